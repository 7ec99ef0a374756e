// SPDX-License-Identifier: BSD-3-Clause
// What stands behind the opaque handles of stltsa.h.
#pragma once

#include <string>
#include <vector>

#include "capi/json.hpp"
#include "clip/clip.hpp"
#include "ltsa/dimension.hpp"
#include "ltsa/model.hpp"
#include "motion/decompose.hpp"
#include "stltsa.h"

namespace stltsa::capi {

/// How a result's rows lie in the source, and what its neighbors rest on.
struct Source {
    bool from_clip = false;
    ClipFacts clip;
    SampleFacts samples;
    PeriodFacts period;

    const ClipFacts* clip_or_null() const { return from_clip ? &clip : nullptr; }
};

/// A copy of a text that the caller frees with stltsa_string_free.
char* caller_string(const std::string& text);

} // namespace stltsa::capi

struct stltsa_clip {
    stltsa::clip::Clip clip;
};

struct stltsa_model {
    stltsa::ltsa::Model model;
    stltsa::capi::Source source;
};

struct stltsa_dimension_result {
    stltsa::ltsa::Dimension dimension;
    stltsa::capi::Source source;
};

struct stltsa_decomposition {
    stltsa::motion::Decomposition result;
    stltsa::ltsa::Dimension dimension;
    bool has_dimension = false;
    stltsa::capi::Source source;
    std::vector<stltsa_interval> units;
    std::vector<stltsa_interval> cycles;
};
