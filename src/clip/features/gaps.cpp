// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/gaps.hpp"

#include <algorithm>
#include <iterator>

#include "base/checkpoint.hpp"

namespace stltsa::clip {
namespace {

/// The body is there in frames with at least this share of the usual number of groups. With a half,
/// the legs of somebody who comes near a camera would not count before the arms are seen, nor one
/// of two people before the other comes.
constexpr double least_share = 1.0 / 3;

/// The gaps of each group, in order.
using GapLists = std::vector<std::vector<Gap>>;

GapLists find_gaps(const Matrix& rows, int width) {
    GapLists gaps(static_cast<std::size_t>(rows.cols() / width));
    for (std::int64_t i = 0; i < rows.rows(); ++i) {
        checkpoint(2 * rows.cols());
        for (std::size_t g = 0; g < gaps.size(); ++g) {
            const auto group = static_cast<std::int64_t>(g);
            if (!is_missing(rows.row(i) + width * group, width))
                continue;
            if (gaps[g].empty() || gaps[g].back().end < i)
                gaps[g].push_back({{i, i}, group});
            gaps[g].back().end = i + 1;
        }
    }
    return gaps;
}

/// How many of the groups are missing in each frame.
std::vector<std::int64_t>
missing_groups(const GapLists& gaps, const std::vector<std::int64_t>& groups, std::int64_t frames) {
    std::vector<std::int64_t> missing(static_cast<std::size_t>(frames) + 1);
    for (const std::int64_t group : groups)
        for (const Gap& gap : gaps[static_cast<std::size_t>(group)]) {
            ++missing[static_cast<std::size_t>(gap.begin)];
            --missing[static_cast<std::size_t>(gap.end)];
        }
    for (std::size_t i = 1; i < missing.size(); ++i)
        missing[i] += missing[i - 1];
    missing.pop_back();
    return missing;
}

/// How many groups are recorded in a usual frame: half of all values are in frames with as many or
/// more. So frames in which nearly nothing is recorded do not count, however many they are.
std::int64_t usual_number(const std::vector<std::int64_t>& missing, std::int64_t groups) {
    std::vector<std::int64_t> frames_with(static_cast<std::size_t>(groups) + 1);
    std::int64_t values = 0;
    for (const std::int64_t count : missing) {
        ++frames_with[static_cast<std::size_t>(groups - count)];
        values += groups - count;
    }
    std::int64_t number = groups;
    for (std::int64_t above = 0; number > 0; --number) {
        above += number * frames_with[static_cast<std::size_t>(number)];
        if (2 * above >= values)
            break;
    }
    return number;
}

/// Number of frames before each one, and before the end, in which the body is there.
std::vector<std::int64_t> frames_with_body(const GapLists& gaps, std::int64_t frames) {
    std::vector<std::int64_t> all(gaps.size());
    for (std::size_t g = 0; g < all.size(); ++g)
        all[g] = static_cast<std::int64_t>(g);
    const auto groups = std::ssize(gaps);
    const std::vector<std::int64_t> missing = missing_groups(gaps, all, frames);
    const double least =
        least_share * static_cast<double>(std::max<std::int64_t>(1, usual_number(missing, groups)));
    std::vector<std::int64_t> before(static_cast<std::size_t>(frames) + 1);
    for (std::size_t i = 0; i < missing.size(); ++i)
        before[i + 1] = before[i] + (static_cast<double>(groups - missing[i]) >= least ? 1 : 0);
    return before;
}

/// Divides the groups into those that take part and those that are missing in more than half of the
/// frames with the body.
void choose_groups(const GapLists& found, std::int64_t frames, Gaps& gaps) {
    const std::vector<std::int64_t> before = frames_with_body(found, frames);
    for (const std::vector<Gap>& of_group : found) {
        std::int64_t missing = 0;
        for (const Gap& gap : of_group)
            missing += before[static_cast<std::size_t>(gap.end)] -
                       before[static_cast<std::size_t>(gap.begin)];
        const bool is_seen = before.back() > 0 && 2 * missing <= before.back();
        (is_seen ? gaps.seen : gaps.dropped).push_back(&of_group - found.data());
    }
}

/// Runs of frames in which more than half of the groups are missing, longer than `longest`.
std::vector<Frames> find_holes(const GapLists& gaps, const std::vector<std::int64_t>& seen,
                               std::int64_t frames, double longest) {
    const std::vector<std::int64_t> missing = missing_groups(gaps, seen, frames);
    std::vector<Frames> holes;
    for (std::int64_t i = 0; i < frames; ++i) {
        if (2 * missing[static_cast<std::size_t>(i)] <= std::ssize(seen))
            continue;
        if (holes.empty() || holes.back().end < i)
            holes.push_back({i, i});
        holes.back().end = i + 1;
    }
    std::erase_if(holes,
                  [&](const Frames& hole) { return static_cast<double>(hole.count()) <= longest; });
    return holes;
}

/// Drops the groups that are missing in all of the frames.
void drop_unseen(const GapLists& found, std::int64_t frames, Gaps& gaps) {
    const auto is_unseen = [&](std::int64_t g) {
        const std::vector<Gap>& of_group = found[static_cast<std::size_t>(g)];
        return !of_group.empty() && of_group.front().count() == frames;
    };
    std::ranges::copy_if(gaps.seen, std::back_inserter(gaps.dropped), is_unseen);
    std::ranges::sort(gaps.dropped);
    std::erase_if(gaps.seen, is_unseen);
}

/// Sums, over the frames, the mean displacement of the groups that both frames have: the path of
/// the body, whichever of its points are seen. Without the body, it stands.
Matrix path_of(const Matrix& rows, int width, const std::vector<std::int64_t>& seen) {
    Matrix path(rows.rows(), width);
    std::vector<double> moved(static_cast<std::size_t>(width));
    for (std::int64_t i = 1; i < rows.rows(); ++i) {
        checkpoint(2 * rows.cols());
        std::ranges::fill(moved, 0);
        std::int64_t count = 0;
        for (const std::int64_t g : seen) {
            const double *before = rows.row(i - 1) + width * g, *now = rows.row(i) + width * g;
            if (is_missing(before, width) || is_missing(now, width))
                continue;
            ++count;
            for (int c = 0; c < width; ++c)
                moved[static_cast<std::size_t>(c)] += now[c] - before[c];
        }
        const bool is_there =
            static_cast<double>(count) >= least_share * static_cast<double>(seen.size());
        const double share = is_there && count > 0 ? 1 / static_cast<double>(count) : 0;
        for (int c = 0; c < width; ++c)
            path(i, c) = path(i - 1, c) + share * moved[static_cast<std::size_t>(c)];
    }
    return path;
}

/// Fills the rows of the gap between those beside it, of which one may lie beyond its end, relative
/// to the path.
void fill_gap(Matrix& rows, int width, const Gap& gap, const Matrix& path) {
    const std::int64_t from = gap.begin > 0 ? gap.begin - 1 : gap.end;
    const std::int64_t to = gap.end < rows.rows() ? gap.end : from;
    for (std::int64_t i = gap.begin; i < gap.end; ++i) {
        const double share =
            from == to ? 0 : static_cast<double>(i - from) / static_cast<double>(to - from);
        for (std::int64_t c = 0; c < width; ++c) {
            const auto off_path = [&](std::int64_t frame) {
                return rows(frame, width * gap.group + c) - path(frame, c);
            };
            rows(i, width * gap.group + c) =
                path(i, c) + (1 - share) * off_path(from) + share * off_path(to);
        }
    }
}

} // namespace

Frames between_end_holes(const std::vector<Frames>& holes, std::int64_t frames) {
    Frames kept{0, frames};
    if (!holes.empty() && holes.front().begin == 0)
        kept.begin = holes.front().end;
    if (!holes.empty() && holes.back().end == frames)
        kept.end = holes.back().begin;
    return kept;
}

Gaps fill_gaps(Matrix& rows, int width, GapRule rule, double fps) {
    Gaps gaps;
    const double longest = longest_filled_s * (fps > 0 ? fps : usual_rate);
    GapLists found = find_gaps(rows, width);
    choose_groups(found, rows.rows(), gaps);
    gaps.holes = find_holes(found, gaps.seen, rows.rows(), longest);
    gaps.kept = between_end_holes(gaps.holes, rows.rows());
    if (gaps.kept.count() < rows.rows()) {
        rows = copied(rows.view().block(gaps.kept.begin, gaps.kept.count()));
        found = find_gaps(rows, width);
        drop_unseen(found, rows.rows(), gaps);
    }
    for (const std::int64_t g : gaps.dropped)
        for (std::int64_t i = 0; i < rows.rows(); ++i) {
            checkpoint(width);
            std::fill_n(rows.row(i) + width * g, width, 0.0);
        }
    // Columns that are no coordinates have no path in common.
    const bool travels = width > 1 && std::ranges::any_of(gaps.seen, [&](std::int64_t g) {
                             return !found[static_cast<std::size_t>(g)].empty();
                         });
    const Matrix path = travels ? path_of(rows, width, gaps.seen) : Matrix(rows.rows(), width);
    for (const std::int64_t g : gaps.seen) {
        const std::vector<Gap>& of_group = found[static_cast<std::size_t>(g)];
        if (!of_group.empty())
            gaps.filled.push_back(g);
        for (const Gap& gap : of_group) {
            fill_gap(rows, width, gap, path);
            checkpoint(gap.count() * width);
            gaps.frames += gap.count();
            if (rule == GapRule::skip || static_cast<double>(gap.count()) > longest ||
                gap.begin == 0 || gap.end == rows.rows())
                gaps.predicted.push_back(gap);
        }
    }
    return gaps;
}

Matrix with_all_frames(Matrix rows, const Frames& kept, std::int64_t frames) {
    if (rows.rows() == frames)
        return rows;
    Matrix all = Matrix::unset(frames, rows.cols());
    for (std::int64_t i = 0; i < frames; ++i)
        std::copy_n(rows.row(std::clamp(i - kept.begin, std::int64_t{0}, rows.rows() - 1)),
                    rows.cols(), all.row(i));
    return all;
}

} // namespace stltsa::clip
