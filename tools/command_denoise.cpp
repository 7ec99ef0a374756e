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
    stltsa::Matrix points;
    stltsa::Denoising denoising;
    Json object;

    Cleaning(stltsa::Matrix before, stltsa::Denoising after)
        : points(std::move(before)), denoising(std::move(after)),
          object(parsed_json(denoising.json())) {}
};

Cleaning clean_model(const Session& session, const stltsa::Model& model) {
    return {model.coords(), stltsa::denoise(model, session.options())};
}

/// The file's columns are coordinates already.
Cleaning clean_columns(Session& session, const stltsa::Clip& clip) {
    if (clip.joint_count() > 0)
        throw Failure(Exit::usage, "--coordinates goes with a CSV or NPY file; this is a motion");
    const stltsa::Matrix points = clip.features();
    session.set_fps(clip.fps());
    Cleaning cleaning(points, stltsa::denoise(points, session.options()));
    cleaning.object["clip"] = parsed_json(clip.json())["clip"];
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
        return clean_model(session, session.open_model(arguments.input));
    }
    if (arguments.coordinates)
        refuse_fit_options(arguments, "with --coordinates nothing is", {STLTSA_OPT_FPS});
    const stltsa::Clip& clip = session.open_input();
    if (arguments.coordinates)
        return clean_columns(session, clip);
    return clean_model(session, stltsa::fit(clip, session.options()));
}

Json rows_of(const stltsa::Matrix& table) {
    Json rows = Json::array();
    for (std::int64_t r = 0; r < table.rows; ++r)
        rows.push_back(table.row(r));
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
            {"fitted", rows_of(cleaning.denoising.curve())},
            {"cleaned", rows_of(cleaning.denoising.cleaned())}};
}

} // namespace

Exit run_denoise(const Arguments& arguments) {
    Session session(arguments);
    Cleaning cleaning = clean(session);
    if (!arguments.product.empty())
        session.add_table(arguments.product, cleaning.denoising.cleaned());
    if (!arguments.curve_product.empty())
        session.add_table(arguments.curve_product, cleaning.denoising.curve());
    if (!arguments.plot.empty())
        session.add_file(arguments.plot,
                         denoising_figure(cleaning.object, cleaning.points, cleaning.denoising));
    if (arguments.curve)
        cleaning.object["curve"] = curve_json(cleaning);
    session.finish(cleaning.object,
                   denoising_report(cleaning.object, session.title(), session.colors()));
    return Exit::done;
}

} // namespace tool
