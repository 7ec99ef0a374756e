// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "clip/clip.hpp"
#include "clip/csv/table.hpp"

namespace stltsa::clip {

/// Whether so many frames a second are plausible: a range wider than that of motion capture.
bool is_plausible_rate(double rate);

/// The one rule of time of all text formats. Removes the columns of times and of counted frames,
/// which are not channels, and sets fps; clip.fps as given is what the lines before the table say.
/// - The clock is the first column that is named as time, or else has dates. Its unit is that of
///   its name, or follows from its size: seconds, or milli-, micro- or nanoseconds.
/// - "frame", "packet counter" and the like, and a first column without a name, count the rows if
///   they increase by whole numbers; "sub frame" counts within a frame.
/// - Rows that are missing by the clock or the count are NaN; rows at uneven times are resampled,
///   unless option fps is set, which makes the rows even.
/// - If the clock contradicts what is said elsewhere, the clock is used.
/// Notes say which columns are removed, and what was assumed. Fails, at the line, if time goes back
/// or is missing, unless option fps is set. `take_channels`: called when the other columns remain,
/// before their rows are resampled, as a point that is missing in one row has no place halfway to
/// the next.
void extract_time(
    Clip& clip, const TableFacts& facts, const std::string& name, const ReadOptions& options,
    const std::function<void()>& take_channels = [] {});

} // namespace stltsa::clip
