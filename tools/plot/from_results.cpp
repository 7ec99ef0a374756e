// SPDX-License-Identifier: BSD-3-Clause
#include "plot/from_results.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "arguments/choices.hpp"
#include "plot/denoise_figure.hpp"
#include "plot/figure.hpp"
#include "plot/seam_figure.hpp"
#include "reports/report.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

/// The body of a clip with a skeleton; `up`: 1, 2, 3 for x, y, z, 0 for unknown.
stltsa::Matrix from_column(const stltsa::Matrix& all, std::int64_t first) {
    stltsa::Matrix rest(all.rows, all.cols - first);
    for (std::int64_t i = 0; i < rest.rows; ++i)
        for (std::int64_t c = 0; c < rest.cols; ++c)
            rest(i, c) = all(i, first + c);
    return rest;
}

/// Without the joints above the body.
std::optional<plot::SideView> bodies_of(const stltsa::Clip& clip, std::int64_t up) {
    if (clip.joint_count() == 0)
        return std::nullopt;
    const std::int64_t root = clip.info().integer(STLTSA_INFO_BODY_ROOT);
    plot::Bodies bodies;
    for (const stltsa::Joint& joint : clip.joints())
        bodies.joints.push_back({joint.name, joint.parent - static_cast<int>(root)});
    bodies.joints.erase(bodies.joints.begin(), bodies.joints.begin() + root);
    bodies.positions = from_column(clip.positions(), 3 * root);
    bodies.rotations = from_column(clip.rotations(), 4 * root);
    bodies.up = up > 0 ? static_cast<int>(up) - 1 : 1;
    return plot::SideView(std::move(bodies));
}

plot::Figure figure_of(const Session& session, const stltsa::Info& info) {
    plot::Figure figure;
    figure.title = session.title();
    figure.frames = session.clip().frames();
    figure.fps = session.clip().fps();
    figure.first = info.integer(STLTSA_INFO_FIRST_FRAME);
    figure.step = info.integer(STLTSA_INFO_FRAME_STEP);
    figure.bodies = bodies_of(session.clip(), info.integer(STLTSA_INFO_UP_AXIS));
    return figure;
}

/// `length`: of so many samples, after a comma; may be empty.
template <class Length>
std::vector<std::string> facts_of(const stltsa::Info& info, const Length& length) {
    std::vector<std::string> facts{"samples: " + samples_text(info),
                                   "features: " + features_text(info)};
    if (info.count(STLTSA_INFO_NEIGHBORS) > 0) {
        const std::int64_t neighbors = info.integer(STLTSA_INFO_NEIGHBORS);
        facts.push_back("neighborhoods: " + counted(neighbors, "sample") + length(neighbors));
    }
    return facts;
}

std::string embedding_text(const stltsa::Info& info) {
    return fmt::format("likeness one period later: {:.2f}; regularity of the curve: {:.2f} "
                       "(1: perfect)",
                       info.real(STLTSA_INFO_LAG_QUALITY), info.real(STLTSA_INFO_CYCLICITY));
}

/// Sets samples to NaN where curve and loop are exactly zero, because nothing was fitted there;
/// removes a loop of which nothing is left.
void leave_out_unfitted(plot::Figure& figure) {
    std::int64_t left = 0;
    for (std::int64_t i = 0; i < figure.loop.rows; ++i) {
        double& curve = figure.curve[static_cast<std::size_t>(i)];
        if (curve == 0 && figure.loop(i, 0) == 0 && figure.loop(i, 1) == 0)
            curve = figure.loop(i, 0) = figure.loop(i, 1) = NAN;
        else
            left += figure.loop(i, 1) == 0 ? 0 : 1;
    }
    if (left == 0)
        figure.loop = {};
}

/// Each cyclic segment has coordinates of its own. Keeps the loop of the segment with the
/// representative cycle or, if there is none, of the longest segment.
void keep_one_loop(plot::Figure& figure) {
    std::vector<stltsa::Segment> cyclic = figure.segments;
    std::erase_if(cyclic, [](const stltsa::Segment& segment) {
        return segment.kind != STLTSA_SEGMENT_CYCLIC;
    });
    if (figure.loop.rows == 0 || cyclic.size() < 2)
        return;
    stltsa::Segment kept = *std::ranges::max_element(
        cyclic, {}, [](const stltsa::Segment& segment) { return segment.end - segment.begin; });
    if (figure.representative >= 0) {
        const auto& cycle = figure.cycles[static_cast<std::size_t>(figure.representative)];
        kept = figure.segments[static_cast<std::size_t>(cycle.segment)];
    }
    for (std::int64_t i = 0; i < figure.loop.rows; ++i)
        if (figure.frame_of(i) < kept.begin || figure.frame_of(i) >= kept.end)
            figure.loop(i, 0) = figure.loop(i, 1) = NAN;
    const std::string place = figure.fps > 0
                                  ? fmt::format("{:.1f} to {:.1f} s", kept.begin_s, kept.end_s)
                                  : fmt::format("frames {} to {}", kept.begin, kept.end);
    figure.loop_note = fmt::format("The loop of {}, {}; every cyclic segment has its own.",
                                   label_text(kept.label), place);
}

bool has_curve(const plot::Figure& figure, const stltsa::Interval& cycle) {
    const std::int64_t middle = ((cycle.begin + cycle.end) / 2 - figure.first) / figure.step;
    return middle >= 0 && middle < std::ssize(figure.curve) &&
           std::isfinite(figure.curve[static_cast<std::size_t>(middle)]);
}

/// The representative cycle, or else the first one that has a curve; -1: none.
std::int64_t enlarged_cycle(const plot::Figure& figure) {
    const auto fits = [&](const stltsa::Interval& cycle) { return has_curve(figure, cycle); };
    if (figure.representative >= 0 &&
        fits(figure.cycles[static_cast<std::size_t>(figure.representative)]))
        return figure.representative;
    const auto found = std::ranges::find_if(figure.cycles, fits);
    return found == figure.cycles.end() ? -1 : found - figure.cycles.begin();
}

/// The curves on 0 to 100 % of the enlarged cycle and of those that follow one another before and
/// after it; between other cycles of its segment there may be another motion.
std::optional<stltsa::Cycles> overlaid_cycles(const plot::Figure& figure) {
    if (figure.enlarged < 0)
        return std::nullopt;
    const auto& cycles = figure.cycles;
    const auto continues = [&](std::size_t i) {
        return cycles[i].segment == cycles[i - 1].segment && cycles[i].begin == cycles[i - 1].end;
    };
    auto first = static_cast<std::size_t>(figure.enlarged), last = first;
    while (first > 0 && continues(first))
        --first;
    while (last + 1 < cycles.size() && continues(last + 1))
        ++last;
    std::vector<double> borders; // in samples
    const auto add = [&](std::int64_t frame) {
        const double sample =
            static_cast<double>(frame - figure.first) / static_cast<double>(figure.step);
        borders.push_back(std::clamp(sample, 0.0, static_cast<double>(figure.curve.size())));
    };
    add(cycles[first].begin);
    for (std::size_t i = first; i <= last; ++i)
        add(cycles[i].end);
    stltsa::Matrix curve(std::ssize(figure.curve), 1);
    curve.values = figure.curve;
    constexpr std::int64_t percent = 101;
    return stltsa::cycles_between(borders, curve, percent);
}

/// Mean and standard deviation, if all cycles are of one motion.
std::string cycle_times_of(const stltsa::Decomposition& result) {
    if (result.summary_count() != 1)
        return "";
    const stltsa::Statistics times =
        result.statistics(STLTSA_PART_CYCLE, result.summary(0).label, -1, STLTSA_QUANTITY_TIME);
    return times.count < 2
               ? ""
               : fmt::format("{:.3f} s, standard deviation {:.3f} s", times.mean, times.sd);
}

/// More would not fit on a page.
constexpr std::size_t most_strips = 6;

std::string seam_heading(const stltsa::Seam& seam, std::int64_t frames, double fps) {
    return fmt::format("{} at frame {}, {:.3f} s",
                       seam.frame == frames ? "wrap, from last frame to first," : "seam",
                       seam.frame, static_cast<double>(seam.frame) / fps);
}

std::string seam_note(const stltsa::Seam& seam, const std::vector<std::string>& pieces,
                      double fps) {
    const auto name = [&](std::int64_t piece) {
        return piece_name(pieces[static_cast<std::size_t>(piece)]);
    };
    return fmt::format(
        "{} cut before frame {}, {} continued at frame {}; {:.3f} s blended on each "
        "side; relative to typical: posture {:.2f}, step {:.2f}, acceleration {:.2f}",
        name(seam.piece), seam.cut_end, seam.piece == seam.next ? "repetition" : name(seam.next),
        seam.cut_begin, static_cast<double>(seam.crossfade) / fps, seam.posture, seam.step,
        seam.acceleration);
}

/// Postures are a tenth of a second apart, or more if the crossfade is long.
plot::Strip strip_of(const stltsa::Seam& seam, const std::vector<std::string>& pieces,
                     const stltsa::Clip& clip) {
    const double fps = clip.fps();
    const std::int64_t frames = clip.frames();
    plot::Strip strip{seam_heading(seam, frames, fps),
                      seam_note(seam, pieces, fps),
                      seam.frame,
                      1,
                      seam.crossfade,
                      seam.frame == frames};
    constexpr double apart_s = 0.1;
    constexpr std::int64_t postures_blended = 4; // to each side, at most
    strip.step = std::max<std::int64_t>(
        {1, std::llround(apart_s * fps), strip.crossfade / postures_blended});
    return strip;
}

bool cut_alike(const stltsa::Seam& a, const stltsa::Seam& b) {
    return a.piece == b.piece && a.next == b.next && a.cut_end == b.cut_end &&
           a.cut_begin == b.cut_begin;
}

/// The seams to show: of identical ones, such as those of a repeated cycle, only the first, and the
/// wrap of a loop.
std::vector<stltsa::Seam> different_seams(const std::vector<stltsa::Seam>& seams,
                                          std::int64_t frames) {
    std::vector<stltsa::Seam> different;
    for (const stltsa::Seam& seam : seams)
        if (seam.frame == frames || std::ranges::none_of(different, [&](const stltsa::Seam& shown) {
                return cut_alike(shown, seam);
            }))
            different.push_back(seam);
    return different;
}

/// The whole of a clip without seams.
plot::Strip whole_strip(std::int64_t frames) {
    const std::int64_t step = std::max<std::int64_t>(1, frames / plot::strip_postures);
    return {"no seam: each piece continues the previous one",
            "",
            plot::strip_postures / 2 * step,
            step,
            -1,
            false};
}

} // namespace

std::string decomposition_figure(const Session& session,
                                 const stltsa::Decomposition& decomposition) {
    const stltsa::Info info = decomposition.info();
    plot::Figure figure = figure_of(session, info);
    figure.summary = decomposition_summary(decomposition);
    figure.facts =
        facts_of(info, [](std::int64_t) { return std::string(", of which a cycle has 24"); });
    if (info.real(STLTSA_INFO_PERIOD) > 0)
        figure.facts.insert(figure.facts.begin(), embedding_text(info));
    figure.curve_name = "motion coordinate";
    figure.curve = decomposition.curve().values;
    const char* what = decomposition.cycle_count() > 0 ? "loop" : "curve";
    figure.loop_names = {fmt::format("first coordinate of the {}", what),
                         fmt::format("second coordinate of the {}", what)};
    figure.loop = decomposition.loop();
    leave_out_unfitted(figure);
    figure.segments = decomposition.segments();
    figure.units = decomposition.units();
    figure.cycles = decomposition.cycles();
    if (figure.cycles.size() > 2) // of fewer, none is typical
        figure.representative = info.integer(STLTSA_INFO_REPRESENTATIVE);
    keep_one_loop(figure);
    figure.postures = info.integers(STLTSA_INFO_POSTURES);
    figure.cycle_times = cycle_times_of(decomposition);
    if (figure.dense()) {
        figure.enlarged = enlarged_cycle(figure);
        figure.overlaid = overlaid_cycles(figure);
        figure.facts.emplace_back("band of the curve: range of each cycle");
    }
    return plot::figure_svg(figure);
}

std::string fit_figure(const Session& session, const stltsa::Model& model) {
    const stltsa::Info info = model.info();
    const stltsa::Matrix coords = model.coords();
    plot::Figure figure = figure_of(session, info);
    figure.summary = fmt::format("curve of {}, {} neighborhoods",
                                 counted(coords.cols, "coordinate"), named(info, STLTSA_INFO_MODE));
    const double fps = info.real(STLTSA_INFO_FPS);
    figure.facts = facts_of(info, [fps](std::int64_t samples) {
        return fps > 0 ? fmt::format(", {:.2f} s", static_cast<double>(samples) / fps) : "";
    });
    figure.curve_name = "first coordinate";
    constexpr std::int64_t postures = 11; // evenly spaced: a model keeps no poses to choose from
    for (std::int64_t i = 0; i < std::min(postures, figure.frames); ++i)
        figure.postures.push_back((2 * i + 1) * figure.frames / (2 * postures));
    figure.pieces = model.components();
    for (std::int64_t i = 0; i < coords.rows; ++i)
        figure.curve.push_back(coords(i, 0));
    if (coords.cols >= 2) {
        figure.loop_names = {"first coordinate", "second coordinate"};
        figure.loop = stltsa::Matrix(coords.rows, 2);
        for (std::int64_t i = 0; i < coords.rows; ++i)
            for (std::int64_t c = 0; c < 2; ++c)
                figure.loop(i, c) = coords(i, c);
    }
    return plot::figure_svg(figure);
}

std::string denoising_figure(const Session& session, const stltsa::Matrix& points,
                             const stltsa::Denoising& denoising) {
    const stltsa::Info info = denoising.info();
    plot::DenoiseFigure figure;
    figure.title = session.title();
    figure.summary = denoising_summary(denoising);
    figure.facts = {"samples: " + samples_text(info), "knots: " + knots_text(info)};
    figure.first = info.integer(STLTSA_INFO_FIRST_FRAME);
    figure.step = info.integer(STLTSA_INFO_FRAME_STEP);
    figure.fps = info.real(STLTSA_INFO_FPS) * static_cast<double>(figure.step);
    figure.lengths = info.integers(STLTSA_INFO_LENGTH);
    figure.before = points;
    figure.after = denoising.cleaned();
    figure.curve = denoising.curve();
    figure.moves = denoising.moves();
    figure.gammas = info.reals(STLTSA_INFO_GAMMA);
    return plot::denoise_figure_svg(figure);
}

std::string synthesis_figure(const std::string& title, const std::vector<std::string>& pieces,
                             const stltsa::Synthesis& synthesis) {
    const stltsa::Clip& clip = synthesis.clip();
    std::vector<stltsa::Seam> seams = different_seams(synthesis.seams(), clip.frames());
    const std::size_t left_out = seams.size() - std::min(seams.size(), most_strips);
    seams.resize(seams.size() - left_out);
    plot::SeamFigure figure{std::filesystem::path(title).filename().string(),
                            synthesis_summary(synthesis),
                            "Shaded: blended frames. Identical seams are shown once.",
                            *bodies_of(clip, synthesis.info().integer(STLTSA_INFO_UP_AXIS)),
                            {}};
    if (left_out > 0)
        figure.note +=
            fmt::format(" Not shown: {}.", counted(static_cast<std::int64_t>(left_out), "seam"));
    for (const stltsa::Seam& seam : seams)
        figure.strips.push_back(strip_of(seam, pieces, clip));
    if (seams.empty()) {
        figure.strips.push_back(whole_strip(clip.frames()));
        figure.note.clear();
    }
    return plot::seam_figure_svg(figure);
}

} // namespace tool
