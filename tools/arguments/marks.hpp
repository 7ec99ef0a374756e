// SPDX-License-Identifier: BSD-3-Clause
// Moments with names: "131=strike", "2.5s=strike".
#pragma once

#include <map>
#include <string>
#include <vector>

namespace tool {

/// Frames by name.
using Marks = std::map<std::string, std::vector<double>>;

/// Throws Failure with Exit::usage for a wrong one. `fps` 0: unknown.
Marks parse_marks(const std::vector<std::string>& given, double fps);

/// Whether a mark is the name of a file with labels, without "=": .c3d, .csv or .tsv.
bool is_label_file(const std::string& mark);

/// Labels of a table with a row of names: the tables that `stltsa events`, BIDS and BORIS write, in
/// seconds. Of several clips only those of `clip`; of states their beginnings. Throws Failure with
/// Exit::unreadable for another table. `path`: for messages.
Marks labels_in(const std::string& table, const std::string& path, const std::string& clip,
                double fps);

} // namespace tool
