// SPDX-License-Identifier: BSD-3-Clause
// Moments with names: "131=strike", "2.5s=strike".
#pragma once

#include <map>
#include <string>
#include <vector>

#include <stltsa.hpp>

namespace tool {

/// Frames by name.
using Marks = std::map<std::string, std::vector<double>>;

/// Throws Failure with Exit::usage for a wrong one. `fps` 0: unknown.
Marks parse_marks(const std::vector<std::string>& given, double fps);

/// Whether a mark is the name of a file with labels, without "=": .c3d, .csv or .tsv.
bool is_label_file(const std::string& mark);

/// Labels of a table with a header row, in seconds, as `stltsa events`, BIDS and BORIS write it. If
/// the table has several clips, only labels of `clip`; for states, only their beginnings. Throws
/// Failure with Exit::unreadable if it is not such a table. `path`: for messages.
Marks labels_in(const std::string& table, const std::string& path, const std::string& clip,
                double fps);

/// Context and label, as in "Left Foot Strike".
std::string name_of(const stltsa::FileEvent& event);

/// The same of the events of a C3D file.
Marks labels_in(const std::vector<stltsa::FileEvent>& events, const std::string& path,
                const std::string& clip, double fps);

} // namespace tool
