// SPDX-License-Identifier: BSD-3-Clause
// What the name of a column says about time.
#pragma once

#include <optional>
#include <string_view>

namespace stltsa::clip {

/// A column that is named as time.
struct TimeName {
    double unit = 0;     ///< seconds; 0: the name does not say
    bool letter = false; ///< named t only, which may be a torque, too
};

/// Only whole names count, with a unit or without: "time", "Time (ms)", "timestamp_us", "t[s]"; not
/// "T10" or "t_2", which are markers.
std::optional<TimeName> time_name(std::string_view column);

/// The unit of time at the end of another name, in seconds: 1e-3 of "elapsed_ms" and "Zeit (ms)", 1
/// of "Zeit". None if the name says that it is not time: "Zeit (%)", "angle (deg)".
std::optional<double> unit_after(std::string_view column);

/// Whether a word is a unit of time, such as "ms".
bool is_time_unit(std::string_view word);

/// "frame", "Frame#", "packet counter", "sample_index" and the like.
bool is_counter_name(std::string_view column);

/// Those of them that count frames.
bool is_frame_name(std::string_view column);

/// The number of a row within its frame: "Sub Frame".
bool is_subframe_name(std::string_view column);

} // namespace stltsa::clip
