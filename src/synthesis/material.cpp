// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/material.hpp"

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"
#include "synthesis/hierarchy.hpp"
#include "synthesis/resample.hpp"

namespace stltsa::synthesis {
namespace {

/// Longer clips are assumed to be mistakes.
constexpr double longest_clip = 2147483647;

std::string name_of(std::span<const Piece> pieces, std::size_t p) {
    const std::string& path = pieces[p].clip->path;
    return path.empty() ? format_text("the clip of pieces[{}]", p) : path;
}

void check_piece(std::span<const Piece> pieces, std::size_t p) {
    const Piece& piece = pieces[p];
    if (!piece.clip->skeleton)
        fail(Status::unsupported,
             "{} is a bare matrix, which cannot be joined: use clips that have a skeleton",
             name_of(pieces, p));
    if (!(piece.clip->fps > 0))
        fail(Status::unsupported, "the frame rate of {} is unknown: open it with option fps",
             name_of(pieces, p));
    if (piece.begin < 0 || piece.begin >= piece.end || piece.end > piece.clip->frames())
        fail(Status::argument,
             "pieces[{}] is frames [{}, {}); it must have at least one frame, all within the {} "
             "frames of {}",
             p, piece.begin, piece.end, piece.clip->frames(), name_of(pieces, p));
    if (piece.repeat < 1)
        fail(Status::argument, "pieces[{}] has repeat {}; it must be at least 1", p, piece.repeat);
}

void check_pieces(std::span<const Piece> pieces) {
    double total = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        check_piece(pieces, p);
        total += static_cast<double>(pieces[p].end - pieces[p].begin) *
                 static_cast<double>(pieces[p].repeat) *
                 (pieces[0].clip->fps / pieces[p].clip->fps);
    }
    if (total > longest_clip)
        fail(Status::argument,
             "the new clip would have {} frames, more than {}: use fewer repetitions", total,
             longest_clip);
}

/// The joint that turns the body in any of the clips: in a clip of standing, no joint does.
std::size_t common_root(std::span<const Piece> pieces) {
    std::size_t root = 0;
    for (const Piece& piece : pieces)
        root = std::max(root, clip::body_root(*piece.clip));
    return root;
}

class Preparation {
  public:
    Preparation(std::span<const Piece> pieces, Material& material)
        : pieces_(pieces), first_(*pieces[0].clip), material_(material) {}

    void add_piece(std::size_t p) {
        const Piece& piece = pieces_[p];
        const auto known = std::find(clips_.begin(), clips_.end(), piece.clip);
        const auto track = static_cast<std::size_t>(known - clips_.begin());
        if (known == clips_.end()) {
            clips_.push_back(piece.clip);
            add_track(*piece.clip, name_of(pieces_, p));
        }
        Part part{track, piece.begin, piece.end, piece.repeat, piece.cycles};
        if (!same_rate(piece.clip->fps, first_.fps))
            rescale(part, first_.fps / piece.clip->fps);
        material_.parts.push_back(part);
    }

  private:
    void rescale(Part& part, double ratio) const {
        const std::int64_t frames = material_.tracks[part.track].frames();
        const auto moved = [ratio](std::int64_t frame) {
            return std::llround(static_cast<double>(frame) * ratio);
        };
        part.begin = std::min<std::int64_t>(moved(part.begin), frames - 1);
        part.end = std::clamp<std::int64_t>(moved(part.end), part.begin + 1, frames);
    }

    void add_track(const clip::Clip& clip, const std::string& name) {
        const Body& body = material_.body;
        const std::string differs = check_same_body(first_, clip, name);
        if (body.turns_above_root(clip.values))
            fail(Status::unsupported,
                 "{} rotates a joint above \"{}\", the joint that rotates the body in another clip",
                 name, body.skeleton().joints[body.root()].name);
        if (!differs.empty())
            material_.warnings.push_back(
                {WarningCode::offsets_differ,
                 format_text(
                     "the offsets of {} differ from the first clip's by less than 1 %, most "
                     "at \"{}\": the first clip's offsets are used",
                     name, differs)});
        const bool same = same_rate(clip.fps, first_.fps);
        if (!same)
            material_.warnings.push_back(
                {WarningCode::resampled,
                 format_text("{} was resampled from {} to {} frames a second", name, clip.fps,
                             first_.fps)});
        material_.tracks.push_back(
            make_track(body, same ? clip.values : resampled(clip, first_.fps), first_.fps, name));
    }

    std::span<const Piece> pieces_;
    const clip::Clip& first_;
    Material& material_;
    std::vector<const clip::Clip*> clips_; ///< one per track
};

} // namespace

Material prepare_material(std::span<const Piece> pieces, std::optional<clip::Axis> up) {
    check_pieces(pieces);
    const clip::Clip& first = *pieces[0].clip;
    const clip::Axis used = clip::up_axis(first, up);
    for (std::size_t p = 1; p < pieces.size(); ++p)
        check_same_body(first, *pieces[p].clip, name_of(pieces, p));
    Material material{Body(first, common_root(pieces), used), used, {}, {}, {}};
    Preparation preparation(pieces, material);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        report_progress(Stage::features,
                        static_cast<double>(p) / static_cast<double>(pieces.size()));
        preparation.add_piece(p);
    }
    report_progress(Stage::features, 1);
    return material;
}

} // namespace stltsa::synthesis
