// SPDX-License-Identifier: BSD-3-Clause
// A motion clip: a skeleton with a pose per frame, or a bare matrix of channels per frame.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa::clip {

using Vec3 = std::array<double, 3>;

/// Unit quaternion w + xi + yj + zk; rotates vectors of the child frame into the parent frame.
struct Quaternion {
    double w = 1, x = 0, y = 0, z = 0;
};

enum class Format : std::int32_t {
    bvh = 1,
    amc = 2,
    csv = 3,
    npy = 4,
    matrix = 5,
    points = 6,
    skeleton = 7,
    glb = 8,
    c3d = 9,
    trc = 10,
    mot = 11
};

/// none: of bare numbers, which have no direction.
enum class Axis : std::int32_t { none = 0, x = 1, y = 2, z = 3 };

/// Meaning of one value of a joint.
enum class Channel : std::int8_t { tx, ty, tz, rx, ry, rz };

struct Joint {
    std::string name;
    int parent = -1; ///< index of a previous joint, -1 for the root
    Vec3 offset{};   ///< from the parent joint, in the parent joint's axes, file units
    std::vector<Channel> channels; ///< in file order; empty for end sites and rigid joints
    Quaternion axis;               ///< ASF bone axis C: local rotation = C M C^-1; identity for BVH
    bool end_site = false;
    /// Position channels add to the offset (ASF, few BVH); else they replace it.
    bool adds = false;
};

struct Skeleton {
    std::vector<Joint> joints; ///< parents before children
    /// Rotations are about fixed axes, and the first listed is applied first (ASF); else about
    /// moving axes, so that the matrix of the first listed is leftmost (BVH).
    bool fixed_axes = false;
    std::string asf; ///< text of the ASF file from which it was read; empty if from elsewhere
};

/// Something that the file says happens, such as a foot strike.
struct Event {
    double frame = 0; ///< of the clip, not rounded; may lie outside it
    std::string label;
    std::string context; ///< what it happens to, such as Left; may be empty
};

/// Rates that a clip may have, in frames a second. With lower ones, times overflow.
constexpr double lowest_fps = 1e-9, highest_fps = 1e6;

struct Clip {
    std::string path; ///< as given, empty for memory
    Format format = Format::matrix;
    double fps = 0;        ///< 0: unknown
    double frame_time = 0; ///< seconds as written in the file (.0083333 for 120); 0: 1 / fps
    std::optional<Skeleton> skeleton;
    /// frames x channels as in the file (degrees for rotations); the matrix itself for CSV and NPY.
    /// Without a skeleton, NaN is a missing value.
    Matrix values;
    int space = 0; ///< without a skeleton: coordinates of each point, 2 or 3; 0: no points
    std::vector<std::string> channel_names; ///< one per column of values; may be empty for matrices
    std::string subject;                    ///< whose points these are, if the file says so
    Axis up = Axis::none;                   ///< as the file states it; none: it does not
    std::string unit;                 ///< of lengths, as the file states it; empty: it does not
    std::vector<Event> events;        ///< in order of time
    std::vector<std::string> notes;   ///< what the reader assumed
    std::vector<std::int64_t> breaks; ///< frames that do not continue the one before

    std::int64_t frames() const { return values.rows(); }
};

struct ReadOptions {
    std::optional<double> fps; ///< overrides the file's rate
    double min_confidence = 0; ///< points that are seen with less are missing
    std::string skeleton;      ///< ASF path for AMC; empty: searched for in the file's folder
    std::string subject;       ///< whose points to take; empty: the only one's
    std::string channels;      ///< BIDS: path of the table of the columns; set by read()
    std::string sidecar;       ///< BIDS: path of the JSON file with the rate; set by read()
};

/// Reads a file; its suffix determines the format, or its content if the suffix is unknown. Throws
/// Error (io, format, ...) with path, line number and what to do.
Clip read(const std::string& path, const ReadOptions& options);

/// Parses a file's bytes. For AMC options.skeleton must name the ASF file.
Clip parse(std::string_view bytes, Format format, const std::string& name,
           const ReadOptions& options);

/// The same; options.fps is used only if the file cannot be read without it, or has no rate.
Clip read_at_own_rate(const std::string& path, const ReadOptions& options);

/// The suffixes that read() knows, for messages.
std::string suffixes_read();
/// Whether a file in a folder is a clip by its suffix, perhaps one that only the Python package
/// reads.
bool is_clip_name(const std::string& path);

/// The format of the bytes (NPY magic, HIERARCHY, AMC keywords, else CSV).
Format sniff(std::string_view bytes);

/// Whether a point of two or three columns is missing in a frame: all are exactly 0, as in C3D
/// files, or one is NaN. A group of one column is missing if it is NaN.
inline bool is_missing(const double* group, int width) {
    const bool zero =
        width > 1 && std::all_of(group, group + width, [](double x) { return x == 0; });
    return zero || std::any_of(group, group + width, [](double x) { return std::isnan(x); });
}

} // namespace stltsa::clip
