// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <fmt/format.h>

#include "arguments/choices.hpp"
#include "arguments/option_flags.hpp"
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/json.hpp"
#include "reports/report.hpp"
#include "reports/table.hpp"

namespace tool {
namespace {

/// The original coordinates and the result.
struct Cleaning {
    stltsa::Matrix points;
    stltsa::Denoising denoising;
};

Cleaning clean_model(const Session& session, const stltsa::Model& model) {
    return {model.coords(), stltsa::denoise(model, session.options())};
}

/// Takes the file's columns as coordinates.
Cleaning clean_columns(Session& session, const stltsa::Clip& clip) {
    if (!clip.joints().empty())
        throw Failure(Exit::usage,
                      "--coordinates needs a CSV or NPY file; this clip has a skeleton");
    stltsa::Matrix points = clip.features();
    session.set_fps(clip.fps());
    stltsa::Denoising denoising = stltsa::denoise(points, session.options());
    return {std::move(points), std::move(denoising)};
}

/// Refuses options of a fit if nothing is fitted: they would have no effect.
void refuse_fit_options(const Arguments& arguments, const char* what,
                        std::initializer_list<std::int32_t> more = {}) {
    std::vector<std::int32_t> used = {STLTSA_OPT_GAMMA,      STLTSA_OPT_KNOT_SPACING,
                                      STLTSA_OPT_ROBUST,     STLTSA_OPT_PERIOD_MIN,
                                      STLTSA_OPT_PERIOD_MAX, STLTSA_OPT_THREADS};
    used.insert(used.end(), more);
    for (const auto& [key, typed] : arguments.options)
        if (std::ranges::find(used, key) == used.end())
            throw Failure(Exit::usage, fmt::format("{} applies only if a clip is fitted; {}",
                                                   flag_of(key), what));
}

Cleaning clean(Session& session) {
    const Arguments& arguments = session.arguments();
    if (session.input_is_model()) {
        if (arguments.coordinates)
            throw Failure(Exit::usage, "--coordinates needs a CSV or NPY file; this is a "
                                       "model, which has its own coordinates");
        refuse_fit_options(arguments, "this is a model");
        return clean_model(session, session.open_model(arguments.input));
    }
    if (arguments.coordinates)
        refuse_fit_options(arguments, "--coordinates skips the fit", {STLTSA_OPT_FPS});
    const stltsa::Clip& clip = session.open_input();
    if (arguments.coordinates)
        return clean_columns(session, clip);
    return clean_model(session, stltsa::fit(clip, session.options()));
}

/// The file of the coordinates, which the library saw only as a matrix.
Json clip_json(const stltsa::Clip& clip) {
    const stltsa::Info info = clip.info();
    const double duration = clip.fps() > 0 ? static_cast<double>(clip.frames()) / clip.fps() : 0;
    return JsonObject("path", json_or_null(info.text(STLTSA_INFO_PATH)), "format",
                      named(info, STLTSA_INFO_FORMAT), "frames", clip.frames(), "fps",
                      json_or_null(clip.fps()), "duration_s", json_or_null(duration), "features",
                      named(info, STLTSA_INFO_FEATURES), "dropped_start_frames",
                      info.integer(STLTSA_INFO_FIRST_FRAME), "notes", info.texts(STLTSA_INFO_NOTE));
}

std::string denoising_json(const Session& session, const Cleaning& cleaning) {
    const stltsa::Denoising& denoising = cleaning.denoising;
    std::string object = denoising.json();
    if (session.arguments().coordinates) {
        const std::string no_clip = "\"clip\":null";
        object.replace(object.find(no_clip), no_clip.size(),
                       "\"clip\":" + clip_json(session.clip()).text());
    }
    if (!session.arguments().curve)
        return object;
    return with_member(object, "curve",
                       JsonObject("frames", json_frames(denoising.info()), "points",
                                  json_rows(cleaning.points), "fitted",
                                  json_rows(denoising.curve()), "cleaned",
                                  json_rows(denoising.cleaned())));
}

} // namespace

Exit run_denoise(const Arguments& arguments) {
    Session session(arguments);
    const Cleaning cleaning = clean(session);
    const stltsa::Denoising& denoising = cleaning.denoising;
    if (!arguments.product.empty())
        session.add_table(arguments.product, denoising.cleaned());
    if (!arguments.curve_product.empty())
        session.add_table(arguments.curve_product, denoising.curve());
    session.finish({[&] { return denoising_json(session, cleaning); },
                    [&] { return denoising_report(denoising, session.title()); },
                    texts_of(denoising.warnings())});
    return Exit::done;
}

} // namespace tool
