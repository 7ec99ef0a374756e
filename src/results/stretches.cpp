// SPDX-License-Identifier: BSD-3-Clause
#include "results/stretches.hpp"

#include <algorithm>

#include "base/names.hpp"

namespace stltsa::results {
namespace {

using Kind = clip::Stretch::Kind;

template <class Interval>
clip::Frames frames_of(const Interval& interval) {
    return {interval.begin, interval.end};
}

[[noreturn]] void missing(std::string_view what, std::size_t count, const std::string& reason) {
    fail(Status::no_such_part, "there {} {} {}{}{}", count == 1 ? "is" : "are",
         count == 0 ? "no" : format_text("{}", count), what, reason.empty() ? "" : "; ", reason);
}

/// The one with this number, from 1.
template <class Interval>
clip::Frames numbered(const std::vector<Interval>& list, std::int64_t number, std::string_view what,
                      const std::string& reason) {
    if (number > std::ssize(list))
        missing(what, list.size(), reason);
    return frames_of(list[static_cast<std::size_t>(number - 1)]);
}

const stltsa_unit* longest(const std::vector<stltsa_unit>& units, std::string_view kind) {
    const stltsa_unit* found = nullptr;
    for (const stltsa_unit& unit : units)
        if (name_of(unit_kinds, unit.kind) == kind &&
            (found == nullptr || unit.end - unit.begin > found->end - found->begin))
            found = &unit;
    return found;
}

clip::Frames named(const Decomposed& found, const std::string& name) {
    const std::string& reason = found.reason;
    if (name == "best" || name == "representative")
        return numbered(found.cycles,
                        (name == "best" ? found.best : found.representative) + 1 +
                            (found.cycles.empty() ? 1 : 0),
                        "cycles", reason);
    const stltsa_unit* unit = longest(found.units, name);
    if (unit == nullptr)
        missing(format_text("units of the kind {}", name), 0, reason);
    return frames_of(*unit);
}

} // namespace

std::vector<clip::Frames> find_stretches(const clip::Clip& clip, const clip::Stretch& stretch,
                                         const std::function<Decomposed()>& decomposed) {
    if (stretch.kind == Kind::range)
        return {clip::frames_of(stretch, clip)};
    const Decomposed found = decomposed();
    const std::string& reason = found.reason;
    switch (stretch.kind) {
    case Kind::cycle:
        return {numbered(found.cycles, stretch.number, "cycles", reason)};
    case Kind::segment:
        return {numbered(found.segments, stretch.number, "segments", {})};
    case Kind::repetition:
        return {numbered(found.repetitions, stretch.number, "repetitions", {})};
    case Kind::label:
        break;
    default:
        return {named(found, stretch.name)};
    }
    std::vector<clip::Frames> all;
    for (const stltsa_segment& segment : found.segments)
        if (segment.label == stretch.number)
            all.push_back(frames_of(segment));
    if (all.empty())
        missing("segments of this label", 0, {});
    return all;
}

} // namespace stltsa::results
