// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/progress.hpp"
#include "synthesis/loop.hpp"
#include "synthesis/material.hpp"
#include "synthesis/measures.hpp"
#include "synthesis/seams.hpp"
#include "synthesis/splice.hpp"
#include "synthesis/synthesis.hpp"
#include "synthesis/turning.hpp"

namespace stltsa::synthesis {
namespace {

/// The first clip without its motion.
clip::Clip empty_clip(const clip::Clip& first) {
    clip::Clip made;
    made.format = first.format;
    made.fps = first.fps;
    made.frame_time = first.frame_time;
    made.skeleton = first.skeleton;
    made.channel_names = first.channel_names;
    return made;
}

class Synthesizer {
  public:
    Synthesizer(const Material& material, const Options& options)
        : material_(material), options_(options), runs_(make_runs(material_.parts)),
          cuts_(choose_cuts(material_.tracks, material_.parts, runs_, options)) {
        result_.warnings = material_.warnings;
        result_.up = material_.up;
    }

    Synthesis make(const clip::Clip& first) {
        const std::int64_t frames = place_seams();
        for (const Seam& seam : result_.seams)
            check_posture(seam);
        result_.clip = empty_clip(first);
        result_.clip.values = splice(frames);
        const Track made =
            make_track(material_.body, result_.clip.values, result_.clip.fps, "the new clip");
        if (options_.loop)
            close_loop(made);
        measure_seams(made);
        for (std::size_t i = 0; i < result_.seams.size();)
            i = warn_of(i);
        return std::move(result_);
    }

  private:
    const Track& track(std::size_t run) const { return material_.tracks[runs_[run].track]; }
    std::size_t after(std::size_t run) const { return (run + 1) % runs_.size(); }
    std::size_t before(std::size_t run) const { return (run + runs_.size() - 1) % runs_.size(); }
    /// The frames of a run between the cuts at its ends.
    std::int64_t start(std::size_t run) const {
        if (run == 0 && !options_.loop)
            return runs_[run].begin;
        return cuts_[before(run)].cut.begin;
    }
    std::int64_t stop(std::size_t run) const {
        return run == cuts_.size() ? runs_[run].end : cuts_[run].cut.end;
    }

    /// Returns the frames of the new clip.
    std::int64_t place_seams() {
        std::int64_t frames = stop(0) - start(0);
        for (std::size_t i = 0; i < cuts_.size(); ++i) {
            const Cut& cut = cuts_[i].cut;
            result_.seams.push_back({frames, runs_[i].last_piece, runs_[after(i)].first_piece,
                                     cut.end, cut.begin, cut.crossfade, cuts_[i].posture, 0, 0});
            if (after(i) > 0)
                frames += stop(i + 1) - start(i + 1);
        }
        return frames;
    }

    std::string where(const Seam& seam) const {
        return format_text("the seam at frame {}, from frame {} of {} to frame {} of {}",
                           seam.frame, seam.cut_end, piece_track(seam.piece).name, seam.cut_begin,
                           piece_track(seam.next).name);
    }

    const Part& part(std::int64_t piece) const {
        return material_.parts[static_cast<std::size_t>(piece)];
    }
    const Track& piece_track(std::int64_t piece) const {
        return material_.tracks[part(piece).track];
    }

    void check_posture(const Seam& seam) const {
        if (options_.posture_limit > 0 && seam.posture > options_.posture_limit)
            fail(Status::no_common_posture,
                 "at {}, between pieces[{}] and pieces[{}], the postures differ {:.1f} times as "
                 "much as those of repetitions of one motion, over the limit of {}: choose pieces "
                 "with a common posture, raise option cut_range or posture_limit, or put a piece "
                 "between them",
                 where(seam), seam.piece, seam.next, seam.posture, options_.posture_limit);
    }

    /// Extra turn per frame of a run, in radians, that keeps a straight walk straight for any
    /// number of repetitions.
    double straightening(std::size_t i) const {
        if ((i == 0 && !options_.loop) || i == cuts_.size() ||
            !cut_alike(result_.seams[before(i)], result_.seams[i]))
            return 0;
        return -stray_turn(material_.body, track(i), cuts_[i].cut) /
               static_cast<double>(stop(i) - start(i));
    }

    Matrix splice(std::int64_t frames) {
        Splicer splicer(material_.body, frames);
        std::int64_t crossed = 0; ///< frames of a run already covered by the previous crossfade
        if (options_.loop) {
            const std::size_t last = before(0);
            splicer.enter_loop(track(last), track(0), cuts_[last].cut, straightening(last));
            crossed = cuts_[last].cut.crossfade;
        }
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            report_progress(Stage::synthesis,
                            static_cast<double>(i) / static_cast<double>(runs_.size()));
            const bool last = i == cuts_.size();
            const std::int64_t covered = last ? 0 : cuts_[i].cut.crossfade;
            const double turn = straightening(i);
            splicer.play(track(i), start(i) + crossed, stop(i) - covered, turn);
            if (!last && after(i) == 0)
                travel_ = splicer.close_loop(track(i), track(0), cuts_[i].cut, turn);
            else if (!last)
                splicer.cross(track(i), track(i + 1), cuts_[i].cut, turn);
            crossed = covered;
        }
        return splicer.take();
    }

    Roughness usual(std::int64_t piece) const {
        return usual_roughness(piece_track(piece), part(piece).begin, part(piece).end);
    }

    /// Share of the requested frames that are between the cuts.
    double coverage() const {
        std::int64_t used = 0;
        std::int64_t requested = 0;
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            used += std::max<std::int64_t>(0, std::min(stop(i), runs_[i].end) -
                                                  std::max(start(i), runs_[i].begin));
            requested += runs_[i].end - runs_[i].begin;
        }
        return static_cast<double>(used) / static_cast<double>(requested);
    }

    void close_loop(const Track& made) {
        result_.loop = travel_of(material_.body, made, travel_);
        result_.loop->coverage = coverage();
        if (options_.in_place)
            put_in_place(material_.body, made, travel_, result_.clip.values);
    }

    void measure_seams(const Track& made) {
        std::vector<Roughness> pieces;
        for (std::size_t p = 0; p < material_.parts.size(); ++p)
            pieces.push_back(usual(static_cast<std::int64_t>(p)));
        for (Seam& seam : result_.seams) {
            const Roughness& a = pieces[static_cast<std::size_t>(seam.piece)];
            const Roughness& b = pieces[static_cast<std::size_t>(seam.next)];
            const Roughness found = roughness_near(made, seam.frame, options_.loop);
            seam.step = ratio(found.step, std::max(a.step, b.step));
            seam.acceleration = ratio(found.acceleration, std::max(a.acceleration, b.acceleration));
        }
    }

    static bool cut_alike(const Seam& a, const Seam& b) {
        return a.piece == b.piece && a.next == b.next && a.cut_end == b.cut_end &&
               a.cut_begin == b.cut_begin;
    }

    static double ratio(double found, double usual) { return found > 0 ? found / usual : 0; }

    /// Warns once for seam i and the following seams with the same cut; returns the next seam.
    std::size_t warn_of(std::size_t i) {
        Seam seam = result_.seams[i];
        std::size_t next = i + 1;
        for (; next < result_.seams.size() && cut_alike(seam, result_.seams[next]); ++next) {
            seam.step = std::max(seam.step, result_.seams[next].step);
            seam.acceleration = std::max(seam.acceleration, result_.seams[next].acceleration);
        }
        const std::string also =
            next - i > 1 ? format_text(" (and {} more like it)", next - i - 1) : "";
        const auto warn = [&](WarningCode code, const std::string& text) {
            const double time = static_cast<double>(seam.frame) / piece_track(seam.piece).fps;
            result_.warnings.push_back(
                {code, format_text("{}{}: {}", where(seam), also, text), time, time});
        };
        if (seam.posture > visible_posture(options_))
            warn(WarningCode::seam_posture,
                 format_text("the postures differ {:.1f} times as much as those of repetitions",
                             seam.posture));
        if (seam.step > visible_step)
            warn(WarningCode::seam_speed,
                 format_text("the body moves {:.1f} times as fast as its normal maximum (95th "
                             "percentile)",
                             seam.step));
        if (seam.acceleration > visible_acceleration)
            warn(WarningCode::seam_acceleration,
                 format_text("the body accelerates {:.1f} times as much as its normal maximum "
                             "(95th percentile)",
                             seam.acceleration));
        if (seam.crossfade == 0 && cuts_[i].wanted_crossfade > 0)
            warn(WarningCode::not_blended,
                 "no frames are blended, because the clips end at the cuts");
        return next;
    }

    const Material& material_;
    const Options& options_;
    std::vector<Run> runs_;
    std::vector<ChosenCut> cuts_; ///< of a loop, the wrap's is the last
    Step travel_;                 ///< of a loop
    Synthesis result_;
};

} // namespace

Synthesis synthesize(const Material& material, const clip::Clip& first, const Options& options) {
    return Synthesizer(material, options).make(first);
}

Synthesis synthesize(std::span<const Piece> pieces, const Options& options) {
    if (options.in_place && !options.loop)
        fail(Status::argument, "option in_place needs option loop");
    return synthesize(prepare_material(pieces, options.up), *pieces[0].clip, options);
}

} // namespace stltsa::synthesis
