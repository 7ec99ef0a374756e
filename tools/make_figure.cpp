// SPDX-License-Identifier: BSD-3-Clause
#include "make_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "plot/denoise_figure.hpp"
#include "plot/figure.hpp"
#include "plot/seam_figure.hpp"
#include "report.hpp"
#include "text.hpp"

namespace tool {
namespace {

/// The body, for clips with a skeleton; `up` is "x", "y" or "z".
std::optional<plot::SideView> bodies_of(const stltsa::Clip& clip, const Json& up) {
    if (clip.joint_count() == 0)
        return std::nullopt;
    plot::Bodies bodies;
    for (const stltsa::Joint& joint : clip.joints())
        bodies.joints.push_back({joint.name, joint.parent});
    bodies.positions = clip.positions();
    bodies.rotations = clip.rotations();
    bodies.up = up.is_null() ? 1 : up.get<std::string>()[0] - 'x';
    return plot::SideView(std::move(bodies));
}

/// The file's name, from the JSON: there it is UTF-8, whatever the name's bytes are.
std::string title_of(const Json& clip) {
    if (clip["path"].is_null())
        return "standard input";
    return std::filesystem::path(clip["path"].get<std::string>()).filename().string();
}

plot::Figure figure_of(const Session& session, const Json& object) {
    plot::Figure figure;
    figure.title = title_of(object["clip"]);
    figure.frames = session.clip().frames();
    figure.fps = session.clip().fps();
    figure.first = object["samples"]["first_frame"];
    figure.step = object["samples"]["frame_step"];
    figure.bodies = bodies_of(session.clip(), object["samples"]["up_axis"]);
    return figure;
}

std::vector<std::string> facts_of(const Json& object) {
    return {neighbors_text(object), "samples: " + samples_text(object),
            "features: " + features_text(object)};
}

std::string embedding_text(const Json& object) {
    return fmt::format("period {:.3f} s, lag quality {:.2f}, cyclicity {:.2f}",
                       object["period_s"].get<double>(), object["lag_quality"].get<double>(),
                       object["embedding"]["cyclicity"].get<double>());
}

/// More would be a page too long for the eye.
constexpr std::size_t most_strips = 6;

std::string seam_heading(const Json& seam) {
    return fmt::format("seam at frame {}, {:.3f} s", seam["frame"].dump(),
                       seam["time_s"].get<double>());
}

std::string seam_note(const Json& seam, const std::vector<std::string>& pieces) {
    const auto name = [&](const char* which) {
        return piece_name(pieces[seam[which].get<std::size_t>()]);
    };
    return fmt::format("{} until frame {}, {} from frame {} on; crossfade of {:.3f} s to each "
                       "side; posture {:.2f}, step {:.2f}, acceleration {:.2f}",
                       name("piece"), seam["cut_end"].dump(),
                       seam["piece"] == seam["next"] ? "again" : name("next"),
                       seam["cut_begin"].dump(), seam["crossfade_s"].get<double>(),
                       seam["posture"].get<double>(), seam["step"].get<double>(),
                       seam["acceleration"].get<double>());
}

/// The strip shows a tenth of a second from posture to posture, or more where a crossfade is long.
plot::Strip strip_of(const Json& seam, const std::vector<std::string>& pieces, double fps) {
    plot::Strip strip{seam_heading(seam), seam_note(seam, pieces), seam["frame"], 1,
                      seam["crossfade"]};
    constexpr double apart_s = 0.1;
    constexpr std::int64_t postures_blended = 4; // to each side, at most
    strip.step = std::max<std::int64_t>(
        {1, std::llround(apart_s * fps), strip.crossfade / postures_blended});
    return strip;
}

bool cut_alike(const Json& a, const Json& b) {
    return std::ranges::all_of(std::array{"piece", "next", "cut_end", "cut_begin"},
                               [&](const char* key) { return a[key] == b[key]; });
}

/// The seams that are shown: of those that are cut alike, as a cycle's repetitions are, the first.
std::vector<Json> different_seams(const Json& seams) {
    std::vector<Json> different;
    for (const Json& seam : seams)
        if (std::ranges::none_of(different,
                                 [&](const Json& shown) { return cut_alike(shown, seam); }))
            different.push_back(seam);
    return different;
}

/// All of a clip that has no seam.
plot::Strip whole_strip(std::int64_t frames) {
    const std::int64_t step = std::max<std::int64_t>(1, frames / plot::strip_postures);
    return {"no seam: the pieces follow each other", "", plot::strip_postures / 2 * step, step, -1};
}

} // namespace

std::string decomposition_figure(const Session& session, const Json& object,
                                 const stltsa::Decomposition& decomposition) {
    plot::Figure figure = figure_of(session, object);
    figure.summary = decomposition_summary(object);
    figure.facts = facts_of(object);
    if (!object["period_s"].is_null())
        figure.facts.insert(figure.facts.begin(), embedding_text(object));
    const Json& column = object["embedding"]["coordinate"];
    figure.curve_name = column.is_null() ? "coordinate" : "coordinate " + column.dump();
    figure.curve = decomposition.curve().values;
    figure.loop_names = {"first coordinate of the loop", "second coordinate of the loop"};
    figure.loop = decomposition.loop();
    figure.units = decomposition.units();
    figure.cycles = decomposition.cycles();
    figure.representative = decomposition.integer(STLTSA_DECOMPOSITION_REPRESENTATIVE);
    return plot::figure_svg(figure);
}

std::string fit_figure(const Session& session, const Json& object, const stltsa::Model& model) {
    const stltsa::Matrix coords = model.coords();
    plot::Figure figure = figure_of(session, object);
    figure.summary = fmt::format("curve of {}, mode {}",
                                 counted(static_cast<std::size_t>(coords.cols), "coordinate"),
                                 object["parameters"]["mode"].get<std::string>());
    figure.facts = facts_of(object);
    figure.curve_name = "coordinate 1";
    figure.pieces = model.components();
    for (std::int64_t i = 0; i < coords.rows; ++i)
        figure.curve.push_back(coords(i, 0));
    if (coords.cols >= 2) {
        figure.loop_names = {"coordinate 1", "coordinate 2"};
        figure.loop = stltsa::Matrix(coords.rows, 2);
        for (std::int64_t i = 0; i < coords.rows; ++i)
            for (std::int64_t c = 0; c < 2; ++c)
                figure.loop(i, c) = coords(i, c);
    }
    return plot::figure_svg(figure);
}

std::string denoising_figure(const Json& object, const stltsa::Matrix& points,
                             const stltsa::Denoising& denoising) {
    const Json& clip = object["clip"];
    const Json& samples = object["samples"];
    plot::DenoiseFigure figure;
    figure.title = clip.is_null() ? "coordinates" : title_of(clip);
    figure.summary = denoising_summary(object);
    figure.facts = {"samples: " + samples_text(object), "knots: " + knots_text(object)};
    figure.fps = samples["fps"].is_null() ? 0 : samples["fps"].get<double>();
    figure.first = samples["first_frame"];
    figure.step = samples["frame_step"];
    figure.fps *= static_cast<double>(figure.step);
    figure.lengths = samples["lengths"].get<std::vector<std::int64_t>>();
    figure.before = points;
    figure.after = denoising.cleaned();
    figure.curve = denoising.curve();
    figure.moves = denoising.moves();
    for (const Json& column : object["columns"])
        figure.gammas.push_back(column["gamma"]);
    return plot::denoise_figure_svg(figure);
}

std::string synthesis_figure(const Json& object, const Arguments& arguments,
                             const stltsa::Clip& clip) {
    std::vector<Json> seams = different_seams(object["seams"]);
    const std::size_t left_out = seams.size() - std::min(seams.size(), most_strips);
    seams.resize(seams.size() - left_out);
    plot::SeamFigure figure{
        std::filesystem::path(arguments.product).filename().string(),
        synthesis_summary(object),
        "Shaded: frames that are blended. Seams that are cut alike are shown once.",
        *bodies_of(clip, object["parameters"]["up_axis"]),
        {}};
    if (left_out > 0)
        figure.note += fmt::format(" Not shown: {}.", counted(left_out, "seam"));
    for (const Json& seam : seams)
        figure.strips.push_back(strip_of(seam, arguments.pieces, object["clip"]["fps"]));
    if (seams.empty()) {
        figure.strips.push_back(whole_strip(clip.frames()));
        figure.note.clear();
    }
    return plot::seam_figure_svg(figure);
}

} // namespace tool
