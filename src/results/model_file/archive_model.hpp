// SPDX-License-Identifier: BSD-3-Clause
// Models as bytes: a head that says what and how long, the parts, and a checksum of all of it.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/sink.hpp"
#include "results/fitted.hpp"

namespace stltsa::results {

/// Bytes that the archive has.
std::uint64_t archive_size(const Fitted& model);
/// `size`: archive_size(), which goes through all of the model as well.
void archive_model(const Fitted& model, std::uint64_t size, const Sink& sink);

/// Throws Status::format for bytes that are no model, are cut off, altered or of another version.
Fitted restore_model(std::string_view bytes);

} // namespace stltsa::results
