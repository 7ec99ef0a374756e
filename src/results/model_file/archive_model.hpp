// SPDX-License-Identifier: BSD-3-Clause
// Models as bytes: a head with the version and the length, the fields, and a checksum of all.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/sink.hpp"
#include "results/fitted.hpp"

namespace stltsa::results {

/// The size of the archive in bytes.
std::uint64_t archive_size(const Fitted& model);
/// `size`: archive_size(), which takes about as long as this.
void archive_model(const Fitted& model, std::uint64_t size, const Sink& sink);

/// Throws Status::format for bytes that are no model, are cut off, altered or of another version.
Fitted restore_model(std::string_view bytes);

} // namespace stltsa::results
