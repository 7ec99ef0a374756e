// SPDX-License-Identifier: BSD-3-Clause
#include "results/comparison_warnings.hpp"

#include "base/numbers.hpp"

namespace stltsa::results {
namespace {

/// Mean cycles less alike than this are of different motions, as for events.
constexpr double least_likeness = 0.6;
/// If the next best alignment is this near, it may be the right one.
constexpr double doubtful = 0.1;
/// Bodies differ less than this in size; units differ by a factor of 2.54 or more.
constexpr double most_size_ratio = 2;
} // namespace

void warn_of_few(const std::string& name, std::int64_t cycles, Comparison& result) {
    if (cycles < 3)
        result.warnings.push_back(
            {WarningCode::few_cycles,
             format_text("{}: only {}", name,
                         cycles == 1 ? "one cycle is complete, so spread and intervals are unknown"
                                     : "two cycles are complete, so intervals are wide")});
}

void warn_of_likeness(Comparison& result) {
    if (!(result.likeness >= least_likeness))
        result.warnings.push_back(
            {WarningCode::not_alike,
             format_text("these seem to be different motions: their mean cycles have a correlation "
                         "of at most {:.2f}, below {}, so 0 % may not be the same moment in both",
                         result.likeness, least_likeness)});
    else if (result.runner_up > result.likeness - doubtful)
        result.warnings.push_back(
            {WarningCode::uncertain_shift,
             format_text("it is not certain that 0 % is the same moment in both: at another shift "
                         "the correlation of the mean cycles is {:.2f}, nearly the {:.2f} at this "
                         "one",
                         result.runner_up, result.likeness)});
    if (result.size_ratio > most_size_ratio || result.size_ratio < 1 / most_size_ratio)
        result.warnings.push_back(
            {WarningCode::sizes_differ,
             format_text("the second body is {:.3g} times as large as the first: if the units of "
                         "the clips differ, amplitudes and distances cannot be compared",
                         result.size_ratio)});
}

} // namespace stltsa::results
