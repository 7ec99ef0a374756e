// SPDX-License-Identifier: BSD-3-Clause
// The options handle and what the rooms' parameter structs become from it.
#pragma once

#include <map>
#include <string>

#include "base/progress.hpp"
#include "clip/clip.hpp"
#include "clip/features.hpp"
#include "ltsa/parameters.hpp"
#include "motion/decompose.hpp"
#include "stltsa.h"

/// Only what was set; the rest is the table's default.
struct stltsa_options {
    std::map<int32_t, double> numbers;
    std::map<int32_t, std::string> texts;
    stltsa::Progress progress;
};

namespace stltsa::capi {

/// Reads options; a null handle reads defaults.
class OptionsReader {
  public:
    explicit OptionsReader(const stltsa_options* options) : options_(options) {}

    std::int64_t integer(int32_t key) const;
    double real(int32_t key) const;
    const char* text(int32_t key) const;
    Progress progress() const { return options_ == nullptr ? Progress() : options_->progress; }

    clip::ReadOptions read_options() const;
    clip::PrepareOptions prepare_options() const;
    motion::DecomposeOptions decompose_options() const;
    int threads() const;

  private:
    const stltsa_options* options_;
};

} // namespace stltsa::capi
