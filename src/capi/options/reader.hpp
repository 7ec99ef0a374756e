// SPDX-License-Identifier: BSD-3-Clause
// The options handle, and the parameter structs that the rooms take.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/progress.hpp"
#include "clip/features/prepare.hpp"
#include "motion/recording/recording.hpp"
#include "results/denoised.hpp"
#include "results/parameters.hpp"
#include "results/placed.hpp"
#include "stltsa.h"
#include "synthesis/synthesis.hpp"

/// Holds the options that were set; the others have the defaults of the table.
struct stltsa_options {
    std::map<int32_t, double> numbers;
    std::map<int32_t, std::string> texts;
    stltsa::Call::Asked progress;
};

namespace stltsa::capi {

bool is_set(const stltsa_options* options, int32_t key);

/// Reads options; a null handle gives the defaults.
class OptionsReader {
  public:
    explicit OptionsReader(const stltsa_options* options) : options_(options) {}

    std::int64_t integer(int32_t key) const;
    double real(int32_t key) const;
    const char* text(int32_t key) const;
    // Of options that the library chooses if they are not set: integer() and real() throw then.
    std::optional<double> real_if_set(int32_t key) const;
    template <class T = std::int64_t>
    std::optional<T> integer_if_set(int32_t key) const {
        return is_set(options_, key) ? std::optional(static_cast<T>(integer(key))) : std::nullopt;
    }

    clip::ReadOptions read_options() const;
    clip::PrepareOptions prepare_options() const;
    std::optional<ltsa::DimensionOptions> intrinsic_options() const;
    motion::Options decompose_options() const;
    results::PeriodSearch period_search() const;
    results::FitOptions fit_options() const;
    /// For a model with these parameters.
    results::MapOptions map_options(const ltsa::Parameters& fitted) const;
    results::DenoiseOptions denoise_options() const;
    synthesis::Options synthesis_options() const;
    int threads() const;

  private:
    const stltsa_options* options_;
};

} // namespace stltsa::capi
