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

std::string number(double value) {
    return std::isnan(value) ? std::string() : fmt::format("{}", value);
}

/// The cells that all rows have.
template <class Row>
std::string cells(std::string_view level, std::string_view kind, const char* letters,
                  const Row& row, double likeness, double confidence) {
    return fmt::format("{},{},{},{},{},{},{},{},{},{}", level, kind, letters, row.begin, row.end,
                       row.begin_s, row.end_s, row.end_s - row.begin_s, number(likeness),
                       number(confidence));
}

std::string part_row(const char* name, const stltsa::Part& part) {
    return fmt::format(
        "{},{},{},{},{}\n", cells(name, name, part.letters, part, part.likeness, part.confidence),
        number(part.path_length), number(part.stride), number(part.speed), number(part.turn_deg));
}

} // namespace

std::string decomposition_csv(const stltsa::Decomposition& result) {
    const std::vector<stltsa::Segment> segments = result.segments();
    std::string text = "level,kind,label,begin,end,begin_s,end_s,duration_s,likeness,confidence,"
                       "path_length,stride,speed,turn_deg\n";
    for (const stltsa::Segment& segment : segments)
        text += cells("segment", stltsa::segment_name(segment.kind), segment.letters, segment,
                      segment.likeness, segment.confidence) +
                ",,,,\n";
    for (const stltsa::Unit& unit : result.units())
        text += cells("unit", stltsa::unit_name(unit.kind),
                      segments.at(static_cast<std::size_t>(unit.segment)).letters, unit, unknown,
                      unknown) +
                ",,,,\n";
    for (const stltsa::Part& cycle : result.cycles())
        text += part_row("cycle", cycle);
    for (const stltsa::Part& repetition : result.repetitions())
        text += part_row("repetition", repetition);
    return text;
}

} // namespace tool
