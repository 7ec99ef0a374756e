// SPDX-License-Identifier: BSD-3-Clause
// A checksum does not prove the origin of a file. Altered bytes with a valid checksum must give a
// usable model or be refused; nothing crashes (the sanitizers watch), and no memory is allocated
// that the bytes do not justify.
#include "clip/testing.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <zlib.h>

#include "capi/handles.hpp"
#include "results/model_file/archive.hpp"
#include "results/model_file/archive_model.hpp"
#include "stltsa.h"

namespace {

using namespace clip_testing;
namespace clip = stltsa::clip;

constexpr std::size_t head = 8 + 4 + 8; // magic, version, size
constexpr int rows = 20;                // few, because every byte of the model is altered

/// Two joints that swing, one of them about a single axis and, because its bone is measured in
/// every frame, up and down.
std::string swinging_bvh(int frames) {
    std::string text = "HIERARCHY\nROOT hip\n{\nOFFSET 0 0 0\n"
                       "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
                       "JOINT knee\n{\nOFFSET 0 -40 0\nCHANNELS 2 Yposition Xrotation\n"
                       "End Site\n{\nOFFSET 0 -40 0\n}\n}\n}\nMOTION\n";
    text += "Frames: " + std::to_string(frames) + "\nFrame Time: 0.05\n";
    for (int i = 0; i < frames; ++i) {
        const double swing = std::sin(0.3 * i);
        text += "0 90 " + std::to_string(0.1 * i) + " 0 " + std::to_string(20 * swing) + " 0 " +
                std::to_string(swing - 40) + " " + std::to_string(30 - 25 * std::cos(0.3 * i)) +
                "\n";
    }
    return text;
}

std::string archived(const stltsa::results::Fitted& model) {
    std::string bytes;
    stltsa::results::archive_model(model, stltsa::results::archive_size(model),
                                   [&](std::string_view piece) { bytes += piece; });
    return bytes;
}

std::string serialized_model() {
    const std::string bvh = swinging_bvh(rows);
    stltsa_clip* clip = nullptr;
    assert_int_equal(
        stltsa_clip_parse(bvh.data(), bvh.size(), STLTSA_FORMAT_BVH, nullptr, nullptr, &clip),
        STLTSA_OK);
    stltsa_options* options = nullptr;
    assert_int_equal(stltsa_options_new(&options), STLTSA_OK);
    stltsa_options_set_int(options, STLTSA_OPT_NEIGHBORS, 8);
    stltsa_model* model = nullptr;
    const stltsa_clip* const clips[] = {clip};
    assert_int_equal(stltsa_fit_clips(clips, 1, options, &model), STLTSA_OK);
    std::string bytes = archived(*model);
    stltsa_model_free(model);
    stltsa_options_free(options);
    stltsa_clip_free(clip);
    return bytes;
}

/// The bytes of a value in a model file.
template <class T>
std::string bytes_of(T value) {
    std::string bytes;
    stltsa::results::ArchiveWriter writer([&](std::string_view piece) { bytes += piece; });
    writer(value);
    writer.finish();
    return bytes;
}

/// Updates size and checksum.
void seal(std::string& bytes) {
    bytes.replace(12, 8, bytes_of(static_cast<std::uint64_t>(bytes.size() - head - 4)));
    const auto sum =
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size() - 4));
    bytes.replace(bytes.size() - 4, 4, bytes_of(static_cast<std::uint32_t>(sum)));
}

/// Calls every function that reads a model; whatever the status, nothing may crash.
void use(const stltsa_model& model) {
    char* json = nullptr;
    if (stltsa_info_json(stltsa_model_info(&model), &json) == STLTSA_OK)
        stltsa_free(json);
    std::int64_t features = 0;
    std::int64_t dimension = 0;
    stltsa_info_int(stltsa_model_info(&model), STLTSA_INFO_FEATURE_COUNT, 0, &features);
    stltsa_info_int(stltsa_model_info(&model), STLTSA_INFO_DIMENSION, 0, &dimension);
    if (features < 1 || features > 1000 || dimension < 1 || dimension > 1000)
        return;
    std::vector<double> frame(static_cast<std::size_t>(features), 0.5);
    std::vector<double> point(static_cast<std::size_t>(dimension), 0.01);
    double distance = 0;
    std::int64_t nearest = 0;
    const stltsa_in frame_in{frame.data(), 1, features, 0, 0, STLTSA_F64, 0};
    const stltsa_out frame_out{frame.data(), 1, features, 0, 0, STLTSA_F64, 0};
    const stltsa_in point_in{point.data(), 1, dimension, 0, 0, STLTSA_F64, 0};
    const stltsa_out point_out{point.data(), 1, dimension, 0, 0, STLTSA_F64, 0};
    const stltsa_out distance_out{&distance, 1, 1, 0, 0, STLTSA_F64, 0};
    const stltsa_out nearest_out{&nearest, 1, 1, 0, 0, STLTSA_I64, 0};
    stltsa_map(&model, &frame_in, nullptr, nullptr, &point_out, &distance_out, &nearest_out);
    stltsa_unmap(&model, &point_in, nullptr, nullptr, &frame_out, &distance_out, &nearest_out);
    stltsa_clip* poses = nullptr;
    stltsa_unmap_clip(&model, &point_in, nullptr, nullptr, &distance_out, &nearest_out, &poses);
    stltsa_clip_free(poses);
}

/// Whether the bytes were accepted as a model.
bool read(const std::string& bytes) {
    std::unique_ptr<stltsa_model> model;
    const Failure failure = failure_of(
        [&] { model = std::make_unique<stltsa_model>(stltsa::results::restore_model(bytes)); });
    if (failure.status != Status::ok && failure.status != Status::format)
        FAIL("status %d: %s", static_cast<int>(failure.status), failure.text.c_str());
    if (model)
        use(*model);
    return model != nullptr;
}

void unaltered_bytes_are_a_model(void**) {
    std::string bytes = serialized_model();
    seal(bytes);
    assert_true(read(bytes));
}

void altered_bytes(void**) {
    const std::string bytes = serialized_model();
    int refused = 0;
    for (std::size_t at = head; at < bytes.size() - 4; ++at)
        for (const int change : {0x01, 0x80, 0xff}) {
            std::string changed = bytes;
            changed[at] = static_cast<char>(changed[at] ^ change);
            seal(changed);
            refused += read(changed) ? 0 : 1;
        }
    assert_true(refused > 100); // counts, enumerations, parents
}

void cut_bytes(void**) {
    const std::string bytes = serialized_model();
    for (std::size_t size = head; size < bytes.size() - 4; ++size) {
        std::string cut = bytes.substr(0, size) + "0000";
        seal(cut);
        assert_false(read(cut));
    }
}

/// Huge counts, infinities and the like in place of every eight bytes.
void extreme_words(void**) {
    const std::string bytes = serialized_model();
    for (const std::uint64_t word :
         {~std::uint64_t{0}, std::uint64_t{1} << 63, std::uint64_t{1} << 62,
          std::uint64_t{0x7ff0000000000000}, std::uint64_t{0x7fefffffffffffff}, std::uint64_t{0}})
        for (std::size_t at = head; at + 8 <= bytes.size() - 4; at += 4) {
            std::string changed = bytes;
            changed.replace(at, 8, bytes_of(word));
            seal(changed);
            read(changed);
        }
}

/// Fields that are valid alone but not together: each must be refused before it leads out of an
/// array, a number's range or a loop.
void contradictions(void**) {
    const std::string bytes = serialized_model();
    constexpr auto huge = std::numeric_limits<std::int64_t>::max();
    const std::pair<const char*, std::function<void(stltsa::results::Fitted&)>> changes[] = {
        {"dimension", [](auto& m) { ++m.model.parameters.dimension; }},
        {"neighbors", [](auto& m) { m.model.parameters.neighbors = 0; }},
        {"features", [](auto& m) { ++m.model.features; }},
        {"lengths",
         [](auto& m) {
             m.model.lengths = {rows - 1, 2};
         }},
        {"negative length",
         [](auto& m) {
             m.model.lengths = {-1, rows + 1};
         }},
        {"too few rows", [](auto& m) { m.model.lengths = {rows - 1}; }},
        {"component", [](auto& m) { m.model.component_of[7] = 1; }},
        {"negative component", [](auto& m) { m.model.component_of[7] = -1; }},
        {"component of each row", [](auto& m) { m.model.component_of.pop_back(); }},
        {"eigenvalues", [](auto& m) { m.model.components[0].eigenvalues.resize(3); }},
        {"coordinates", [](auto& m) { m.model.coords(3, 1) = NAN; }},
        {"rows of the clip", [](auto& m) { m.source.samples.count = rows - 1; }},
        {"columns", [](auto& m) { m.source.samples.feature_count = -huge; }},
        {"first frame", [](auto& m) { m.source.samples.first = 1; }},
        {"far first frame", [](auto& m) { m.source.samples.first = huge; }},
        {"step", [](auto& m) { m.source.samples.step = 2; }},
        {"no step", [](auto& m) { m.source.samples.step = 0; }},
        {"long step", [](auto& m) { m.source.samples.step = huge; }},
        {"clips", [](auto& m) { m.source.clips.push_back(m.source.clips.front()); }},
        {"far place of the clip",
         [](auto& m) { m.source.clips[0].first = m.source.samples.first = huge; }},
        {"long step of the clip",
         [](auto& m) { m.source.clips[0].step = m.source.samples.step = huge; }},
        {"no step of the clip",
         [](auto& m) { m.source.clips[0].step = m.source.samples.step = 0; }},
        {"warning",
         [](auto& m) {
             m.model.warnings.push_back({static_cast<stltsa::WarningCode>(99), ""});
         }},
        {"frames of the clip", [](auto& m) { m.source.clips.front().frames = rows - 1; }},
        {"period", [](auto& m) { m.source.period.period = 1e300; }},
        {"negative period", [](auto& m) { m.source.period.period = -1; }},
        {"smoothing", [](auto& m) { m.source.samples.smoothing = INFINITY; }},
        {"kind of features",
         [](auto& m) { m.source.samples.features = clip::Features::rotations6d; }},
        {"frames", [](auto& m) { m.kept.frames = stltsa::Matrix(rows - 1, 9); }},
        {"columns of the frames", [](auto& m) { m.kept.frames = stltsa::Matrix(rows, 8); }},
        {"frame", [](auto& m) { m.kept.frames(rows - 1, 8) = INFINITY; }},
        {"no number", [](auto& m) { m.kept.frames(0, 0) = NAN; }},
        {"poses without frames", [](auto& m) { m.kept.frames = {}; }},
        {"poses of a matrix", [](auto& m) { m.source.clips.clear(); }},
        {"poses", [](auto& m) { m.kept.poses = stltsa::Matrix(rows - 1, m.kept.poses.cols()); }},
        {"columns of the poses", [](auto& m) { m.kept.poses = stltsa::Matrix(rows, 1); }},
        {"pose", [](auto& m) { m.kept.poses(0, 0) = NAN; }},
        {"moving column", [](auto& m) { m.kept.code.moves.at(0) = 8; }},
        {"far moving column", [](auto& m) { m.kept.code.moves.at(0) = ~std::size_t{0}; }},
        {"moving columns", [](auto& m) { m.kept.code.moves.push_back(0); }},
        {"root", [](auto& m) { m.kept.code.root = 3; }},
        {"mean rotations", [](auto& m) { m.kept.code.means.pop_back(); }},
        {"mean rotation", [](auto& m) { m.kept.code.means[0].w = 2; }},
        {"rest", [](auto& m) { m.kept.code.rest.pop_back(); }},
        {"names", [](auto& m) { m.kept.code.channel_names.pop_back(); }},
        {"up axis", [](auto& m) { m.kept.code.up = clip::Axis::none; }},
        {"no joints", [](auto& m) { m.kept.code.skeleton.joints.clear(); }},
        {"parent", [](auto& m) { m.kept.code.skeleton.joints[1].parent = 1; }},
        {"second root", [](auto& m) { m.kept.code.skeleton.joints[1].parent = -1; }},
        {"axis", [](auto& m) { m.kept.code.skeleton.joints[1].axis.x = 1; }},
        {"offset", [](auto& m) { m.kept.code.skeleton.joints[1].offset[1] = NAN; }},
        {"channel", [](auto& m) { m.kept.code.skeleton.joints[1].channels[0] = clip::Channel{6}; }},
    };
    for (const auto& [what, change] : changes) {
        auto model = stltsa::results::restore_model(bytes);
        change(model);
        if (read(archived(model)))
            FAIL("taken for a model: %s", what);
    }
}

/// A valid model with a mean cycle of zeros.
stltsa::results::Fitted with_cycle() {
    auto model = stltsa::results::restore_model(serialized_model());
    const std::int64_t n = model.model.features;
    auto& live = model.live;
    live.has_cycle = true;
    live.body.kind = clip::Features::raw;
    live.body.skeleton = {};
    live.body.shape.rule = {1, false, false, clip::Axis::none};
    live.body.shape.used.assign(static_cast<std::size_t>(n), 1);
    live.body.shape.mean.assign(static_cast<std::size_t>(n), 0);
    live.body.shape.directions = stltsa::Matrix(0, n);
    auto& cycle = live.cycle;
    cycle.rate = 30;
    cycle.period = cycle.turns_per_second = cycle.variance = cycle.typical = 1;
    cycle.weights.assign(static_cast<std::size_t>(n), 1);
    cycle.mean.assign(static_cast<std::size_t>(2 * n), 0);
    cycle.directions = stltsa::Matrix(1, 2 * n);
    cycle.places = cycle.rests = stltsa::Matrix(stltsa::phase::place_count, 1);
    cycle.whitening = stltsa::Matrix(1, 1);
    return model;
}

/// They moved phases by infinitely many cycles, and the result was used as an index.
void impossible_rates_of_the_cycle(void**) {
    assert_true(read(archived(with_cycle())));
    const std::pair<double, double> rates[] = {{1e300, 1}, {1e-300, 1e-301}, {30, 1e300}, {30, 31}};
    for (const auto& [rate, turns] : rates) {
        auto model = with_cycle();
        model.live.cycle.rate = rate;
        model.live.cycle.turns_per_second = turns;
        assert_false(read(archived(model)));
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(unaltered_bytes_are_a_model),
        cmocka_unit_test(altered_bytes),
        cmocka_unit_test(cut_bytes),
        cmocka_unit_test(extreme_words),
        cmocka_unit_test(contradictions),
        cmocka_unit_test(impossible_rates_of_the_cycle),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
