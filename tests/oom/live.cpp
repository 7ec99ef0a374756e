// SPDX-License-Identifier: BSD-3-Clause
// Tests that streams allocate nothing once they are made, in whatever form frames come.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "allocations.hpp"
#include "stltsa.h"

namespace {

/// A clip that teaches a model, and a stream of the model.
struct Stream {
    stltsa_clip* clip = nullptr;
    stltsa_decomposition* found = nullptr;
    stltsa_phase* phase = nullptr;
    stltsa_model* model = nullptr;
    stltsa_live* live = nullptr;
    stltsa_live_frame frame{};

    explicit Stream(stltsa_clip* of) : clip(of) {
        frame.size = sizeof frame;
        stltsa_decompose(clip, nullptr, &found);
        stltsa_phase_find(found, nullptr, &phase);
        const stltsa_clip* const clips[] = {clip};
        stltsa_fit_clips(clips, 1, nullptr, &model);
        if (stltsa_model_keep_cycle(model, phase, nullptr) == STLTSA_OK)
            stltsa_live_new(model, &live);
    }
    ~Stream() {
        stltsa_live_free(live);
        stltsa_model_free(model);
        stltsa_phase_free(phase);
        stltsa_decomposition_free(found);
        stltsa_clip_free(clip);
    }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
};

/// A stream allocates when it is made, and never again: each push would fail. `push`: of a frame
/// and its time.
template <class Push>
bool allocates_nothing(const char* name, const Stream& stream, const Push& push) {
    stltsa_status status = stream.live == nullptr ? STLTSA_E_INTERNAL : STLTSA_OK;
    until_failure = 0;
    for (int i = 0; i < 500 && status == STLTSA_OK; ++i)
        status = push(i, i / 30.0 + (i > 300 ? 5 : 0));
    const bool untouched = until_failure.exchange(-1) == 0;
    std::printf("live, %s: 500 frames, %s\n", name, untouched ? "no allocation" : "allocations");
    return status == STLTSA_OK && untouched;
}

bool features_allocate_nothing(const std::string& input) {
    stltsa_options* options = nullptr;
    stltsa_clip* clip = nullptr;
    stltsa_options_new(&options);
    stltsa_options_set_real(options, STLTSA_OPT_FPS, 30);
    stltsa_clip_parse(input.data(), input.size(), STLTSA_FORMAT_CSV, nullptr, options, &clip);
    stltsa_options_free(options);
    Stream stream(clip);
    return allocates_nothing("features", stream, [&](int i, double seconds) {
        double row[8];
        const stltsa_in features = {row, 1, 8, 0, 0, STLTSA_F64, 0};
        for (int c = 0; c < 8; ++c)
            row[c] = i % 50 == 7 ? NAN : std::sin(0.21 * i * (1 + c % 2) + c);
        return stltsa_live_push(stream.live, seconds, &features, &stream.frame);
    });
}

/// Five points that swing about an upright line.
void put_points(int i, double* row) {
    for (int p = 0; p < 5; ++p) {
        const double angle = 0.21 * i + p;
        row[3 * p] = p % 2 + 0.3 * std::sin(angle) + 0.01 * i;
        row[3 * p + 1] = p + 0.2 * std::cos(angle);
        row[3 * p + 2] = p % 3 + 0.3 * std::sin(2 * angle);
    }
}

bool points_allocate_nothing() {
    std::vector<double> rows(15 * 400);
    for (int i = 0; i < 400; ++i)
        put_points(i, rows.data() + 15 * i);
    stltsa_points given{};
    given.size = sizeof given;
    given.space = 3;
    given.positions = {rows.data(), 400, 15, 0, 0, STLTSA_F64, 0};
    given.fps = 30;
    stltsa_clip* clip = nullptr;
    stltsa_clip_from_points(&given, nullptr, &clip);
    Stream stream(clip);
    return allocates_nothing("points", stream, [&](int i, double seconds) {
        double row[15], sure[5] = {1, 1, i % 3 == 0 ? 0.0 : 1.0, 1, 1};
        put_points(i, row);
        row[0] = i % 5 == 0 ? NAN : row[0];
        const stltsa_in points = {row, 5, 3, 0, 0, STLTSA_F64, 0};
        const stltsa_in confidence = {sure, 5, 1, 0, 0, STLTSA_F64, 0};
        return stltsa_live_push_points(stream.live, seconds, &points, &confidence, &stream.frame);
    });
}

/// A quaternion about x, then one about z.
void put_pose(int i, double* row) {
    const double a = 0.4 * std::sin(0.21 * i), b = 0.3 * std::sin(0.21 * i + 1);
    const double values[] = {std::cos(a), std::sin(a), 0, 0, std::cos(b), 0,
                             0,           std::sin(b), 1, 0, 0,           0};
    std::copy(std::begin(values), std::end(values), row);
}

bool poses_allocate_nothing() {
    std::vector<double> rows(12 * 400);
    for (int i = 0; i < 400; ++i)
        put_pose(i, rows.data() + 12 * i);
    const stltsa_joint joints[] = {
        {"hip", -1, {0, 0}, nullptr, 0},
        {"knee", 0, {0, -4}, nullptr, 0},
        {"foot", 1, {0, -4, 1}, nullptr, 1},
    };
    const stltsa_in rotations = {rows.data(), 400, 12, 0, 0, STLTSA_F64, 0};
    stltsa_clip* clip = nullptr;
    stltsa_clip_from_skeleton(joints, sizeof *joints, 3, STLTSA_ROTATIONS_QUATERNION, &rotations,
                              nullptr, 30, &clip);
    Stream stream(clip);
    return allocates_nothing("poses", stream,
                             [&](int i, double seconds) {
                                 double row[12];
                                 const double place[3] = {0.1 * i, 0, 0};
                                 put_pose(i, row);
                                 row[5] = i % 50 == 7 ? NAN : row[5];
                                 const stltsa_in pose = {row, 3, 4, 0, 0, STLTSA_F64, 0};
                                 const stltsa_in root = {place, 1, 3, 0, 0, STLTSA_F64, 0};
                                 return stltsa_live_push_pose(stream.live, seconds,
                                                              STLTSA_ROTATIONS_QUATERNION, &pose,
                                                              &root, &stream.frame);
                             }) &&
           allocates_nothing("frames", stream, [&](int i, double seconds) {
               return stltsa_live_push_frame(stream.live, 100 + seconds, stream.clip, i % 400,
                                             &stream.frame);
           });
}

} // namespace

int main() {
    bool good = features_allocate_nothing(cyclic_csv());
    good = points_allocate_nothing() && good;
    good = poses_allocate_nothing() && good;
    return good ? 0 : 1;
}
