// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>

#include "commands.hpp"
#include "make_figure.hpp"
#include "option_flags.hpp"
#include "report.hpp"
#include "session.hpp"

namespace tool {
namespace {

/// Coordinates before, the result, and what the library says of it.
struct Cleaning {
    Grid points;
    Denoising denoising;
    Json object;

    Grid grid(stltsa_status (*fill)(const stltsa_denoising*, const stltsa_out*) noexcept) const {
        return grid_of(fill, denoising.get(), points.rows, points.cols);
    }
};

Cleaning clean_model(const Session& session, const stltsa_model* model) {
    Cleaning cleaning{coordinates_of(model),
                      made_by<Denoising>([&](stltsa_denoising** made) {
                          return stltsa_denoise_model(model, session.options(), made);
                      }),
                      {}};
    cleaning.object = json_of(stltsa_denoising_json, cleaning.denoising.get());
    return cleaning;
}

/// The file's columns are coordinates already.
Cleaning clean_columns(Session& session, const stltsa_clip* clip) {
    if (stltsa_clip_joints(clip) > 0)
        throw Failure(Exit::usage, "--coordinates goes with a CSV or NPY file; this is a motion");
    std::int64_t cols = 0;
    check(stltsa_clip_feature_count(clip, nullptr, &cols));
    Cleaning cleaning{Grid(stltsa_clip_frames(clip), cols), nullptr, {}};
    const stltsa_out out = out_of(cleaning.points);
    check(stltsa_clip_features(clip, nullptr, &out));
    session.set_fps(stltsa_clip_fps(clip));
    cleaning.denoising = made_by<Denoising>([&](stltsa_denoising** made) {
        const stltsa_in in{out.data, out.rows, out.cols, 0, 0, STLTSA_F64, 0};
        return stltsa_denoise(&in, nullptr, 1, session.options(), made);
    });
    cleaning.object = json_of(stltsa_denoising_json, cleaning.denoising.get());
    cleaning.object["clip"] = json_of(stltsa_clip_json, clip)["clip"];
    return cleaning;
}

/// Of what is not fitted here, options of a fit would change nothing.
void refuse_fit_options(const Arguments& arguments, const char* what,
                        std::initializer_list<std::int32_t> more = {}) {
    std::vector<std::int32_t> used = {STLTSA_OPT_GAMMA,      STLTSA_OPT_KNOTS,
                                      STLTSA_OPT_ROBUST,     STLTSA_OPT_PERIOD_MIN,
                                      STLTSA_OPT_PERIOD_MAX, STLTSA_OPT_THREADS};
    used.insert(used.end(), more);
    for (const auto& [key, typed] : arguments.options)
        if (std::ranges::find(used, key) == used.end())
            throw Failure(Exit::usage, fmt::format("{} goes with a clip that is to be fitted; {}",
                                                   flag_of(key), what));
}

Cleaning clean(Session& session) {
    const Arguments& arguments = session.arguments();
    if (session.input_is_model()) {
        if (arguments.coordinates)
            throw Failure(Exit::usage, "--coordinates goes with a CSV or NPY file; this is a "
                                       "model, which has its own");
        refuse_fit_options(arguments, "this is a model");
        return clean_model(session, session.open_model(arguments.input).get());
    }
    if (arguments.coordinates)
        refuse_fit_options(arguments, "with --coordinates nothing is", {STLTSA_OPT_FPS});
    const stltsa_clip* clip = session.open_input();
    if (arguments.coordinates)
        return clean_columns(session, clip);
    const auto model = made_by<Model>(
        [&](stltsa_model** made) { return stltsa_fit_clip(clip, session.options(), made); });
    return clean_model(session, model.get());
}

Json rows_of(const Grid& grid) {
    Json rows = Json::array();
    for (std::int64_t r = 0; r < grid.rows; ++r) {
        const double* first = grid.values.data() + r * grid.cols;
        rows.push_back(std::vector<double>(first, first + grid.cols));
    }
    return rows;
}

Json curve_json(const Cleaning& cleaning) {
    const Json& samples = cleaning.object["samples"];
    Json frames = Json::array();
    for (std::int64_t i = 0; i < cleaning.points.rows; ++i)
        frames.push_back(samples["first_frame"].get<std::int64_t>() +
                         i * samples["frame_step"].get<std::int64_t>());
    return {{"frames", frames},
            {"points", rows_of(cleaning.points)},
            {"fitted", rows_of(cleaning.grid(stltsa_denoising_curve))},
            {"cleaned", rows_of(cleaning.grid(stltsa_denoising_cleaned))}};
}

} // namespace

Exit run_denoise(const Arguments& arguments) {
    Session session(arguments);
    Cleaning cleaning = clean(session);
    if (!arguments.product.empty())
        session.add_table(arguments.product, cleaning.grid(stltsa_denoising_cleaned));
    if (!arguments.curve_product.empty())
        session.add_table(arguments.curve_product, cleaning.grid(stltsa_denoising_curve));
    if (!arguments.plot.empty())
        session.add_file(arguments.plot, denoising_figure(cleaning.object, cleaning.points,
                                                          cleaning.denoising.get()));
    if (arguments.curve)
        cleaning.object["curve"] = curve_json(cleaning);
    session.finish(cleaning.object,
                   denoising_report(cleaning.object, session.title(), session.colors()));
    return Exit::done;
}

} // namespace tool
