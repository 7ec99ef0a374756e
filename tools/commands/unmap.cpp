// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/mapped.hpp"
#include "commands/session.hpp"
#include "reports/report.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

/// The numbers of a CSV or NPY file.
stltsa::Matrix points_of(const stltsa::Clip& clip) {
    if (!clip.joints().empty())
        throw Failure(Exit::usage,
                      "coordinates come from a CSV or NPY file, not from a clip with a "
                      "skeleton; use stltsa map for clips");
    return clip.features();
}

/// Points per second: from --fps or the file, otherwise the rate of the model's rows.
double rate_of(const stltsa::Clip& points, const stltsa::Model& model) {
    return points.fps() > 0 ? points.fps() : model.info().real(STLTSA_INFO_FPS);
}

/// An NPY file has no rate, and coordinates of another clip may have another one than the model's.
std::vector<std::string> notes_of(const stltsa::Clip& points, double rate) {
    if (points.fps() > 0 || !(rate > 0))
        return {};
    return {
        fmt::format("the coordinates carry no rate, so they are taken as {:.6g} per second, the "
                    "rate of the model's samples: if that is wrong, set --fps, or give a CSV "
                    "file that map wrote, which carries it",
                    rate)};
}

/// Whether the model is of a clip with a skeleton.
bool has_poses(const stltsa::Model& model) {
    const stltsa::Info info = model.info();
    if (info.count(STLTSA_INFO_FORMAT) == 0)
        return false;
    const std::int64_t format = info.integer(STLTSA_INFO_FORMAT);
    return format == STLTSA_FORMAT_BVH || format == STLTSA_FORMAT_AMC ||
           format == STLTSA_FORMAT_SKELETON;
}

bool poses_wanted(const std::string& path, const stltsa::Model& model) {
    if (path == standard_output)
        return has_poses(model);
    return ends_in(path, ".bvh") || ends_in(path, ".amc") || ends_in(path, ".glb");
}

/// Hints that make each point continue from the row of the previous one, and never go back: on both
/// sides of a turning point a single coordinate has the same values.
std::vector<std::int64_t> followed(const Session& session, const stltsa::Model& model,
                                   const stltsa::Matrix& points) {
    const std::int64_t reach = session.options().integer(STLTSA_OPT_HINT_WINDOW);
    const std::int64_t last = model.info().integer(STLTSA_INFO_ROWS) - 1;
    std::vector<std::int64_t> hints;
    std::int64_t hint = -1;
    for (std::int64_t r = 0; r < points.rows; ++r) {
        hints.push_back(hint);
        const stltsa::MatrixView point(points.row(r), points.cols);
        const std::int64_t nearest =
            model.unmap(point, session.options(), std::span(&hint, 1)).nearest[0];
        hint = std::min(nearest + reach, last);
    }
    return hints;
}

} // namespace

Exit run_unmap(const Arguments& arguments) {
    Session session(arguments);
    constexpr std::int64_t step = 2; // rows that one step may deviate, either way
    if (arguments.follow)
        session.set_default(STLTSA_OPT_HINT_WINDOW, step);
    const stltsa::Model model = session.open_model(arguments.model);
    const stltsa::Clip& input = session.open_input();
    const stltsa::Matrix points = points_of(input);
    session.set_fps(input.fps());
    const std::vector<std::int64_t> hints =
        arguments.follow ? followed(session, model, points) : std::vector<std::int64_t>();
    const double rate = rate_of(input, model);
    Mapping mapping{arguments, model, {}, rate, {}, notes_of(input, rate)};
    std::optional<stltsa::Clip> clip;
    if (poses_wanted(arguments.product, model)) {
        stltsa::Poses poses = model.unmap_clip(points, session.options(), hints);
        mapping.rows = {{}, std::move(poses.distance), std::move(poses.nearest)};
        clip = std::move(poses.clip);
        session.add_clip(arguments.product, *clip);
    } else {
        mapping.rows = model.unmap(points, session.options(), hints);
        session.add_table(arguments.product, mapping.rows.values, "feature");
    }
    session.finish({[&] { return mapping_json(mapping); },
                    [&] { return mapping_report(mapping, session.title()); },
                    {},
                    {},
                    mapping.notes});
    return Exit::done;
}

} // namespace tool
