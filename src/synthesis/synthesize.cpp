// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "synthesis/material.hpp"
#include "synthesis/measures.hpp"
#include "synthesis/seams.hpp"
#include "synthesis/splice.hpp"
#include "synthesis/synthesis.hpp"
#include "synthesis/turning.hpp"

namespace stltsa::synthesis {
namespace {

/// Above this a seam may be visible.
constexpr double visible_step = 1.4;
constexpr double visible_acceleration = 3;

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
    Synthesizer(Material material, const Options& options, const Progress& progress)
        : material_(std::move(material)), options_(options), progress_(progress),
          runs_(make_runs(material_.parts)),
          cuts_(choose_cuts(material_.tracks, material_.parts, runs_, options, progress)) {
        result_.warnings = material_.warnings;
        result_.up = material_.up;
    }

    Synthesis make(const clip::Clip& first) {
        const std::int64_t frames = place_seams();
        for (const Seam& seam : result_.seams)
            check_posture(seam);
        result_.clip = empty_clip(first);
        result_.clip.values = splice(frames);
        measure_seams();
        for (std::size_t i = 0; i < result_.seams.size();)
            i = warn_of(i);
        return std::move(result_);
    }

  private:
    const Track& track(std::size_t run) const { return material_.tracks[runs_[run].track]; }
    /// The frames of a run between the cuts at its ends.
    std::int64_t start(std::size_t run) const {
        return run == 0 ? runs_[run].begin : cuts_[run - 1].cut.begin;
    }
    std::int64_t stop(std::size_t run) const {
        return run == cuts_.size() ? runs_[run].end : cuts_[run].cut.end;
    }

    /// Returns the frames of the new clip.
    std::int64_t place_seams() {
        std::int64_t frames = stop(0) - start(0);
        for (std::size_t i = 0; i < cuts_.size(); ++i) {
            const Cut& cut = cuts_[i].cut;
            result_.seams.push_back({frames, runs_[i].last_piece, runs_[i + 1].first_piece, cut.end,
                                     cut.begin, cut.crossfade, cuts_[i].posture, 0, 0});
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
        if (i == 0 || i == cuts_.size() || !cut_alike(result_.seams[i - 1], result_.seams[i]))
            return 0;
        return -stray_turn(material_.body, track(i), cuts_[i].cut) /
               static_cast<double>(stop(i) - start(i));
    }

    Matrix splice(std::int64_t frames) const {
        Splicer splicer(material_.body, frames);
        std::int64_t crossed = 0; ///< frames of a run already covered by the previous crossfade
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            progress_.report(Stage::synthesis,
                             static_cast<double>(i) / static_cast<double>(runs_.size()));
            const bool last = i == cuts_.size();
            const std::int64_t covered = last ? 0 : cuts_[i].cut.crossfade;
            const double turn = straightening(i);
            splicer.play(track(i), start(i) + crossed, stop(i) - covered, turn);
            if (!last)
                splicer.cross(track(i), track(i + 1), cuts_[i].cut, turn);
            crossed = covered;
        }
        return splicer.take();
    }

    Roughness usual(std::int64_t piece) const {
        return usual_roughness(piece_track(piece), part(piece).begin, part(piece).end);
    }

    void measure_seams() {
        const Track made =
            make_track(material_.body, result_.clip.values, result_.clip.fps, "the new clip");
        std::vector<Roughness> pieces;
        for (std::size_t p = 0; p < material_.parts.size(); ++p)
            pieces.push_back(usual(static_cast<std::int64_t>(p)));
        for (Seam& seam : result_.seams) {
            const Roughness& a = pieces[static_cast<std::size_t>(seam.piece)];
            const Roughness& b = pieces[static_cast<std::size_t>(seam.next)];
            const Roughness found = roughness_near(made, seam.frame);
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
        const double limit =
            options_.posture_limit > 0 ? options_.posture_limit : Options{}.posture_limit;
        if (seam.posture > limit / 2)
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

    Material material_;
    const Options& options_;
    const Progress& progress_;
    std::vector<Run> runs_;
    std::vector<ChosenCut> cuts_;
    Synthesis result_;
};

} // namespace

Synthesis synthesize(std::span<const Piece> pieces, const Options& options,
                     const Progress& progress) {
    Synthesizer synthesizer(prepare_material(pieces, options.up, progress), options, progress);
    return synthesizer.make(*pieces[0].clip);
}

} // namespace stltsa::synthesis
