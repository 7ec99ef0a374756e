// SPDX-License-Identifier: BSD-3-Clause
// The table for spreadsheets: one row for each segment, unit, cycle and repetition.
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "reports/report.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr const char* header =
    "level,kind,label,begin,end,begin_s,end_s,duration_s,likeness,confidence,way,stride,speed,"
    "turn_deg\n";
constexpr stltsa::Travel nowhere = {unknown, unknown, unknown, unknown};

std::string number(double value) {
    return std::isnan(value) ? std::string() : fmt::format("{}", value);
}

template <class Part>
std::string row(std::string_view level, std::string_view kind, const stltsa::Segment& segment,
                const Part& part, double likeness, double confidence,
                const stltsa::Travel& travel = nowhere) {
    const std::string label = segment.label < 0 ? std::string() : label_text(segment.label);
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", level, kind, label,
                       part.begin, part.end, part.begin_s, part.end_s, part.end_s - part.begin_s,
                       number(likeness), number(confidence), number(travel.way),
                       number(travel.stride), number(travel.speed), number(travel.turn));
}

} // namespace

std::string decomposition_csv(const stltsa::Decomposition& result) {
    const std::vector<stltsa::Segment> segments = result.segments();
    const auto segment_of = [&](std::int64_t index) -> const stltsa::Segment& {
        return segments.at(static_cast<std::size_t>(index));
    };
    std::string text = header;
    for (const stltsa::Segment& segment : segments)
        text += row("segment", stltsa::segment_name(segment.kind), segment, segment,
                    segment.likeness, segment.confidence);
    for (const stltsa::Interval& unit : result.units())
        text += row("unit", stltsa::unit_name(unit.kind), segment_of(unit.segment), unit, unknown,
                    unknown);
    const auto append = [&](std::int32_t kind, const char* name) {
        for (std::int64_t i = 0; i < result.part_count(kind); ++i) {
            const stltsa::Part part = result.part(kind, i);
            text += row(name, name, segment_of(part.segment), part, part.likeness, part.confidence,
                        result.travel(kind, i));
        }
    };
    append(STLTSA_PART_CYCLE, "cycle");
    append(STLTSA_PART_REPETITION, "repetition");
    return text;
}

} // namespace tool
