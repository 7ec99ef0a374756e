// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;

namespace {

/// Throws for no marks, and for frames that the clip does not have.
std::vector<double> marks_of(const stltsa_in* marks, const results::Phased& from) {
    const capi::InputFrames input(marks, "marks");
    if (input.view().cols != 1 || input.view().rows < 1)
        fail(Status::shape, "marks is {} x {}; it must have one column and at least one row",
             input.view().rows, input.view().cols);
    std::vector<double> frames;
    for (int64_t i = 0; i < input.view().rows; ++i) {
        const double frame = input.view()(i, 0);
        if (!(frame >= 0 && frame <= static_cast<double>(from.clip.frames - 1)))
            fail(Status::argument, "mark {} is frame {}; the clip has frames 0 to {}", i, frame,
                 from.clip.frames - 1);
        frames.push_back(frame);
    }
    return frames;
}

} // namespace

stltsa_status stltsa_events_find(const stltsa_phase* from, const stltsa_in* marks,
                                 const stltsa_phase* in, const stltsa_options* options,
                                 stltsa_events** events) noexcept {
    return compute(options, [&] {
        required(events, "events") = nullptr;
        const results::Phased& source = required(from, "from");
        const results::Phased& target = in == nullptr ? source : *in->found;
        *events = new stltsa_events(results::find_events(source, marks_of(marks, source), target));
    });
}

void stltsa_events_free(stltsa_events* events) noexcept {
    delete events;
}
