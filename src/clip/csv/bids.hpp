// SPDX-License-Identifier: BSD-3-Clause
// Motion-BIDS: *_motion.tsv has numbers only; *_channels.tsv beside it describes its columns, and
// *_motion.json the recording. https://bids-specification.readthedocs.io, Motion.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stltsa::clip {

bool is_bids_motion(const std::string& path);

/// The one motion file of a folder: of a dataset, a subject, a session, or motion. Any other path
/// is returned unchanged. Throws Status::argument if a folder holds several, and lists them.
std::string motion_file(const std::string& path);

/// The file with this ending that applies to a motion file: in its folder, or in one above in the
/// dataset, with no entities (sub-01, task-walk, ...) but its own. Empty: there is none.
std::string find_beside(const std::string& motion_path, std::string_view ending);

/// The names of the columns, from a table of channels: those of positions are coordinates of the
/// tracked points, others have their type and unit.
std::vector<std::string> channel_names(const std::string& path);

/// Frames a second, from the JSON file; 0: unknown.
double sampling_frequency(const std::string& path);

} // namespace stltsa::clip
