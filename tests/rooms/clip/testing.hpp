// SPDX-License-Identifier: BSD-3-Clause
// Shared by the tests of src/clip.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "assertions.hpp"
#include "clip/clip.hpp"

namespace clip_testing {

using stltsa::Status;
using stltsa::clip::Clip;
using stltsa::clip::Format;

struct Failure {
    Status status = Status::ok;
    std::string text;
};

inline Failure failure_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const stltsa::Error& error) {
        return {error.status(), error.what()};
    }
    return {};
}

/// The action must fail with this status and a message that contains `part`.
inline void check_fails(Status status, std::string_view part, const std::function<void()>& action,
                        const char* file, int line) {
    const Failure failure = failure_of(action);
    if (failure.status == status && failure.text.find(part) != failure.text.npos)
        return;
    print_error("expected status %d with \"%.*s\", got status %d with \"%s\"\n",
                static_cast<int>(status), static_cast<int>(part.size()), part.data(),
                static_cast<int>(failure.status), failure.text.c_str());
    _fail(file, line);
}
#define ASSERT_FAILS(status, part, action)                                                         \
    clip_testing::check_fails(                                                                     \
        status, part, [&] { action; }, __FILE__, __LINE__)

/// Names of columns of points in space: m0_x, m0_y, m0_z, m1_x, ...
inline std::vector<std::string> columns_of_points(std::int64_t points) {
    std::vector<std::string> result;
    for (std::int64_t p = 0; p < points; ++p)
        for (const char* axis : {"_x", "_y", "_z"})
            result.push_back("m" + std::to_string(p) + axis);
    return result;
}

inline Clip parse(std::string_view text, Format format,
                  const stltsa::clip::ReadOptions& options = {}) {
    return stltsa::clip::parse(text, format, "test", options);
}

/// `text` with the first `from` replaced; `text` must contain it.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    if (at == text.npos) {
        print_error("\"%.*s\" is not in the text to change\n", static_cast<int>(from.size()),
                    from.data());
        _fail(__FILE__, __LINE__);
    }
    return text.replace(at, from.size(), to);
}

/// An empty folder, removed with the object.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "stltsa-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            FAIL("no temporary folder");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string path(std::string_view name) const { return (path_ / name).string(); }

    std::string write(std::string_view name, std::string_view bytes) const {
        std::FILE* file = std::fopen(path(name).c_str(), "wb");
        if (file == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() ||
            std::fclose(file) != 0)
            FAIL("cannot write a temporary file");
        return path(name);
    }

  private:
    std::filesystem::path path_;
};

/// Uniform in [-1, 1), the same on every machine (std::uniform_real_distribution is not).
class Random {
  public:
    double next() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
    }
    std::uint64_t below(std::uint64_t bound) {
        return static_cast<std::uint64_t>((next() + 1) / 2 * static_cast<double>(bound));
    }

  private:
    std::uint64_t state_ = 0x9E3779B97F4A7C15;
};

inline void check_same(const stltsa::Matrix& a, const stltsa::Matrix& b, double tolerance) {
    assert_int_equal(a.rows(), b.rows());
    assert_int_equal(a.cols(), b.cols());
    for (std::int64_t i = 0; i < a.rows(); ++i)
        for (std::int64_t c = 0; c < a.cols(); ++c)
            ASSERT_NEAR(a(i, c), b(i, c), tolerance);
}

/// A figure with a root, one leg and one arm.
inline const std::string small_bvh = R"(HIERARCHY
ROOT Hips
{
  OFFSET 0.0 0.0 0.0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Leg
  {
    OFFSET 1.0 -2.0 0.5
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0.0 -4.0 0.0
    }
  }
  JOINT Arm
  {
    OFFSET 3.0 5.0 0.0
    CHANNELS 1 Xrotation
    End Site
    {
      OFFSET 6.0 0.0 0.0
    }
  }
}
MOTION
Frames: 3
Frame Time: 0.0083333
1 2 3 0 0 0 0 0 0 0
2 3 4 10 20 30 40 50 60 70
3 4 5 11 21 31 41 51 61 71
)";

inline const std::string small_asf = R"(# a comment
:version 1.10
:name small
:units
  mass 1.0
  length 0.45
  angle deg
:documentation
  begin of a text with keywords: end
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name thigh
    direction 0.6 -0.8 0
    length 10
    axis 0 0 20 XYZ
    dof rx ry rz
    limits (-160.0 20.0)
           (-70.0 70.0)
           (-60.0 70.0)
  end
  begin
    id 2
    name shank
    direction 0 -1 0
    length 5
    axis 0 90 0 XYZ
    dof rx
    limits (-10.0 170.0)
  end
  begin
    id 3
    name spine
    direction 0 1 0
    length 7
    axis 0 0 0 XYZ
  end
:hierarchy
  begin
    root thigh spine
    thigh shank
  end
)";

inline const std::string small_amc = R"(#!OML:ASF small.ASF
:FULLY-SPECIFIED
:DEGREES
1
root 1 2 3 10 20 30
thigh 5 6 7
shank 90
2
root 2 3 4 11 21 31
thigh 6 7 8
shank 91
)";

} // namespace clip_testing
