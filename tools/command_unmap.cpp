// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "commands.hpp"
#include "mapped.hpp"
#include "report.hpp"
#include "session.hpp"
#include "text.hpp"

namespace tool {
namespace {

/// The numbers of a CSV or NPY file.
Grid points_of(const stltsa_clip* clip) {
    if (stltsa_clip_joints(clip) > 0)
        throw Failure(Exit::usage, "coordinates are read from a CSV or NPY file, not from a clip "
                                   "with a skeleton: stltsa map places those on a curve");
    Grid points(stltsa_clip_frames(clip), stltsa_clip_channels(clip));
    const stltsa_out out{points.values.data(), points.rows, points.cols, 0, 0, STLTSA_F64, 0};
    check(stltsa_clip_features(clip, nullptr, &out));
    return points;
}

/// Points a second: as typed, or as the file says, else as the model has rows.
double rate_of(const stltsa_clip* points, const stltsa_model* model) {
    double rate = stltsa_clip_fps(points);
    if (!(rate > 0))
        check(stltsa_model_get_real(model, STLTSA_MODEL_FPS, &rate));
    return rate;
}

stltsa_in rows_of(const Grid& points, std::int64_t first, std::int64_t count) {
    return {points.values.data() + first * points.cols, count, points.cols, 0, 0, STLTSA_F64, 0};
}

bool poses_wanted(const std::string& path) {
    return ends_in(path, ".bvh") || ends_in(path, ".amc");
}

/// Makes frames, or, where `path` is one of a clip with a skeleton, poses.
class Unmapper {
  public:
    Unmapper(const Session& session, const stltsa_model* model, const Grid& points)
        : options_(session.options()), model_(model), points_(points) {}

    /// Hints that let each point go on from the row of the one before, and never back: to both
    /// sides of a turning point of one coordinate things look the same.
    std::vector<std::int64_t> followed(Mapped& mapped) const {
        std::int64_t reach = 0;
        check(stltsa_options_get_int(options_, STLTSA_OPT_HINT_WINDOW, &reach));
        const std::int64_t last = whole_of(model_, STLTSA_MODEL_FRAMES) - 1;
        std::vector<std::int64_t> hints(static_cast<std::size_t>(points_.rows), -1);
        std::vector<double> frame(static_cast<std::size_t>(mapped.values.cols));
        const stltsa_out out{frame.data(), 1, mapped.values.cols, 0, 0, STLTSA_F64, 0};
        std::int64_t nearest = -1;
        for (std::int64_t r = 0; r < points_.rows; ++r) {
            std::int64_t& hint = hints[static_cast<std::size_t>(r)];
            hint = nearest < 0 ? -1 : std::min(nearest + reach, last);
            const stltsa_in point = rows_of(points_, r, 1);
            check(stltsa_unmap(model_, &point, &hint, options_, &out, nullptr, &nearest));
        }
        return hints;
    }

    Clip poses(const std::int64_t* hints, Mapped& mapped) const {
        const stltsa_in in = rows_of(points_, 0, points_.rows);
        const stltsa_out distance = mapped.distance_out();
        return made_by<Clip>([&](stltsa_clip** made) {
            return stltsa_unmap_clip(model_, &in, hints, options_, &distance, mapped.nearest.data(),
                                     made);
        });
    }

    Clip frames(const std::int64_t* hints, Mapped& mapped) const {
        const stltsa_in in = rows_of(points_, 0, points_.rows);
        const stltsa_out values = mapped.values_out();
        const stltsa_out distance = mapped.distance_out();
        check(
            stltsa_unmap(model_, &in, hints, options_, &values, &distance, mapped.nearest.data()));
        return {};
    }

  private:
    const stltsa_options* options_;
    const stltsa_model* model_;
    const Grid& points_;
};

} // namespace

Exit run_unmap(const Arguments& arguments) {
    Session session(arguments);
    constexpr std::int64_t step = 2; // rows to and fro that one step may be off
    if (arguments.follow)
        session.set_default(STLTSA_OPT_HINT_WINDOW, step);
    const Model model = session.open_model(arguments.model);
    const stltsa_clip* input = session.open_input();
    const Grid points = points_of(input);
    session.set_fps(stltsa_clip_fps(input));
    Mapped mapped(points.rows, whole_of(model.get(), STLTSA_MODEL_FEATURES));
    const Unmapper unmapper(session, model.get(), points);
    const std::vector<std::int64_t> hints =
        arguments.follow ? unmapper.followed(mapped) : std::vector<std::int64_t>();
    const std::int64_t* hinted = hints.empty() ? nullptr : hints.data();
    const bool poses = poses_wanted(arguments.product);
    const Clip clip = poses ? unmapper.poses(hinted, mapped) : unmapper.frames(hinted, mapped);
    if (poses)
        session.add_clip(arguments.product, clip.get());
    else
        session.add_table(arguments.product, mapped.values, "feature");
    const double rate = rate_of(input, model.get());
    const Json object = mapping_json("unmap", arguments, model.get(), mapped, rate);
    session.finish(object, mapping_report(object, session.title(), session.colors()));
    return Exit::done;
}

} // namespace tool
