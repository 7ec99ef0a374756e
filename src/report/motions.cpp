// SPDX-License-Identifier: BSD-3-Clause
#include "report/motions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <string>

#include "base/numbers.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/features/column_owners.hpp"
#include "clip/features/points.hpp"
#include "report/packed.hpp"
#include "results/compared.hpp"
#include "results/summary.hpp"

namespace stltsa::report {
namespace {

constexpr std::int64_t samples = 101;      ///< per cycle: one for each percent
constexpr std::int64_t every = 2;          ///< every second sample of single cycles is kept,
constexpr std::int64_t every_time = 10;    ///< and every tenth of their times
constexpr std::int64_t most_columns = 300; ///< in a set of signals: those that move most
constexpr std::int64_t most_cycles = 24, least_cycles = 4; ///< drawn one by one
constexpr std::int64_t most_values = 1'000'000;            ///< in all cycles drawn one by one

/// A signal: a coordinate of a part of the body, an angle, or a column.
struct Column {
    std::int64_t part = -1; ///< index of the part of the body; -1: none
    std::string name;       ///< of the part
    std::string axis;       ///< "x" to "z", "rx" to "rz"; empty: it is the only signal of its part
};

/// Signals of the same kind and unit, a row for each frame.
struct SignalSet {
    const char* name;
    const char* unit; ///< empty: that of the file
    std::vector<Column> columns;
    Matrix rows;
};

std::vector<Column> columns_of(const clip::Clip& clip, clip::Features kind,
                               const std::vector<Part>& parts) {
    std::map<std::string, std::int64_t> index;
    for (std::size_t i = 0; i < parts.size(); ++i)
        index.emplace(parts[i].name, static_cast<std::int64_t>(i));
    const bool points = kind == clip::Features::positions || kind == clip::Features::points;
    std::map<std::string, std::size_t> seen;
    std::vector<Column> columns;
    for (const std::string& owner : clip::column_owners(clip, kind)) {
        const auto found = index.find(owner);
        Column& column = columns.emplace_back();
        column.name = owner;
        column.part = found == index.end() ? -1 : found->second;
        const std::size_t k = seen[owner]++;
        if (points && k < 3)
            column.axis = std::string(1, "xyz"[k]);
        else if (kind == clip::Features::rotations6d)
            column.axis = format_text("{}", k + 1);
        else if (kind == clip::Features::euler && column.part >= 0) {
            std::vector<std::string_view> names;
            for (const clip::Channel channel :
                 clip.skeleton->joints[static_cast<std::size_t>(column.part)].channels)
                if (clip::is_rotation(channel))
                    names.push_back(clip::channel_name(channel));
            column.axis = k < names.size() ? names[k] : "";
        }
    }
    return columns;
}

/// Sets values that are predicted in long gaps, frames without the body, and columns that are left
/// out to NaN, because curves show only recorded values.
void leave_out_gaps(const clip::Clip& clip, std::int64_t width, Matrix& rows) {
    Matrix filled = copied(clip.values.view());
    const clip::Gaps gaps =
        clip::fill_gaps(filled, static_cast<int>(width), clip::GapRule::fill, clip.fps);
    const auto clear = [&](std::int64_t frame, std::int64_t group) {
        std::fill_n(rows.row(frame) + width * group, width, none);
    };
    for (const clip::Gap& gap : gaps.predicted)
        for (std::int64_t frame = gap.begin; frame < gap.end; ++frame)
            clear(gaps.kept.begin + frame, gap.group);
    for (const clip::Frames& hole : gaps.holes)
        for (std::int64_t frame = hole.begin; frame < hole.end; ++frame)
            std::fill_n(rows.row(frame), rows.cols(), none);
    for (const std::int64_t group : gaps.dropped)
        for (std::int64_t frame = 0; frame < rows.rows(); ++frame)
            clear(frame, group);
}

SignalSet signal_set(const clip::Clip& clip, clip::Features kind, const results::Phased& phased,
                     const std::vector<Part>& parts, clip::GapRule gaps) {
    const char* const name = kind == clip::Features::positions || kind == clip::Features::points
                                 ? "position"
                             : kind == clip::Features::euler       ? "angle"
                             : kind == clip::Features::rotations6d ? "rotation"
                                                                   : "value";
    SignalSet set{name, "", columns_of(clip, kind, parts),
                  clip::feature_rows(clip, kind, phased.samples.up, gaps).rows};
    if (!clip.skeleton)
        leave_out_gaps(clip, kind == clip::Features::points ? clip::point_columns(clip) : 1,
                       set.rows);
    if (kind == clip::Features::euler) {
        constexpr double degrees = 180 / std::numbers::pi;
        set.unit = "°";
        for (std::int64_t r = 0; r < set.rows.rows(); ++r)
            for (std::int64_t c = 0; c < set.rows.cols(); ++c)
                set.rows(r, c) *= degrees;
    }
    return set;
}

/// The kinds of signals that are shown: the features that were decomposed and, for a skeleton, the
/// joint angles.
std::vector<SignalSet> signal_sets(const clip::Clip& clip, const results::Phased& phased,
                                   const std::vector<Part>& parts, clip::GapRule gaps) {
    std::vector<SignalSet> sets;
    sets.push_back(signal_set(clip, phased.samples.features, phased, parts, gaps));
    if (clip.skeleton && phased.samples.features != clip::Features::euler) {
        SignalSet angles = signal_set(clip, clip::Features::euler, phased, parts, gaps);
        if (angles.rows.cols() > 0)
            sets.push_back(std::move(angles));
    }
    return sets;
}

/// Indices, in ascending order, of the columns whose mean cycle moves most; of few columns, all.
std::vector<std::int64_t> chosen_columns(const Matrix& mean) {
    std::vector<std::int64_t> order(static_cast<std::size_t>(mean.cols()));
    std::iota(order.begin(), order.end(), 0);
    if (mean.cols() <= most_columns)
        return order;
    std::vector<double> range;
    for (std::int64_t c = 0; c < mean.cols(); ++c) {
        double low = 0, high = 0;
        for (std::int64_t r = 0; r < mean.rows(); ++r) {
            const double moved = std::isfinite(mean(r, c)) ? mean(r, c) - mean(0, c) : 0;
            low = std::min(low, moved);
            high = std::max(high, moved);
        }
        range.push_back(high - low);
    }
    std::ranges::stable_sort(order, [&](std::int64_t a, std::int64_t b) {
        return range[static_cast<std::size_t>(a)] > range[static_cast<std::size_t>(b)];
    });
    order.resize(most_columns);
    std::ranges::sort(order);
    return order;
}

/// Every `step`-th row of some columns.
Matrix taken(const Matrix& from, std::int64_t step, const std::vector<std::int64_t>& columns) {
    Matrix result((from.rows() + step - 1) / step, std::ssize(columns));
    for (std::int64_t r = 0; r < result.rows(); ++r)
        for (std::int64_t c = 0; c < result.cols(); ++c)
            result(r, c) = from(r * step, columns[static_cast<std::size_t>(c)]);
    return result;
}

/// Indices of the cycles that are drawn one by one, evenly spaced.
std::vector<std::int64_t> shown_cycles(std::int64_t count, std::int64_t columns,
                                       std::int64_t motions) {
    const std::int64_t one = std::max<std::int64_t>(1, columns) * (samples / every + 1) * motions;
    const std::int64_t shown =
        std::min(count, std::clamp(most_values / one, least_cycles, most_cycles));
    std::vector<std::int64_t> indices;
    for (std::int64_t i = 0; i < shown; ++i)
        indices.push_back(i * count / shown);
    return indices;
}

Json set_json(const SignalSet& set, const phase::Resampled& cycles,
              const std::vector<std::int64_t>& shown) {
    const std::vector<std::int64_t> columns = chosen_columns(cycles.mean);
    std::vector<Json> list;
    for (const std::int64_t c : columns) {
        const Column& column = set.columns[static_cast<std::size_t>(c)];
        list.push_back(JsonObject("part", column.part, "name", column.name, "axis", column.axis));
    }
    const std::int64_t kept = (samples + every - 1) / every;
    Matrix each(kept * std::ssize(shown), std::ssize(columns));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const Matrix one = taken(cycles.each[static_cast<std::size_t>(shown[i])], every, columns);
        std::copy_n(one.data(), one.rows() * one.cols(),
                    each.row(static_cast<std::int64_t>(i) * kept));
    }
    return JsonObject(
        "name", set.name, "unit", set.unit, "columns", list, "columns_of_all", cycles.mean.cols(),
        "shown", shown, "mean", packed(taken(cycles.mean, 1, columns).view()), "sd",
        packed(taken(cycles.deviation, 1, columns).view()), "each", packed(each.view()));
}

/// For each cycle the frames at 0, 10, ... 100 %, to hundredths of a frame.
Json times_json(const Matrix& rows) {
    std::vector<std::vector<double>> all;
    for (std::int64_t i = 0; i < rows.rows(); ++i) {
        std::vector<double>& frames = all.emplace_back();
        for (std::int64_t s = 0; s < rows.cols(); s += every_time)
            frames.push_back(std::round(100 * rows(i, s)) / 100);
    }
    return all;
}

Json sides_json(const results::Comparison& found) {
    std::vector<Json> pairs;
    std::vector<std::int64_t> columns;
    for (std::size_t c = 0; c < found.columns.axis.size() && pairs.size() < most_columns; ++c) {
        const phase::PartDifference& of = found.differences.columns[c];
        const auto part = static_cast<std::size_t>(found.columns.part[c]);
        pairs.push_back(JsonObject(
            "left", found.columns.names[part], "right", found.columns.other_names[part], "axis",
            found.columns.axis[c], "rms", of.rms, "chance", of.chance, "mean", -of.mean.difference,
            "left_range", of.amplitude.first, "right_range", of.amplitude.second, "shift",
            of.lag.difference, "correlation", of.correlation));
        columns.push_back(static_cast<std::int64_t>(c));
    }
    return JsonObject("reason", "", "pairs", pairs, "left_curves",
                      packed(taken(found.motions[0].mean, 1, columns).view()), "right_curves",
                      packed(taken(found.motions[1].mean, 1, columns).view()));
}

/// Left against right, or the reason why they are not compared.
Json compared_sides(const clip::Clip& clip, const results::Phased& phased, std::int32_t label,
                    const clip::PrepareOptions& prepare) {
    try {
        return sides_json(results::compare_left_right(clip, phased, label, samples, prepare));
    } catch (const Error& error) {
        if (error.status() != Status::argument && error.status() != Status::unsupported &&
            error.status() != Status::too_few_frames)
            throw;
        return JsonObject("reason", error.what(), "pairs", std::vector<Json>());
    }
}

} // namespace

Json motions_json(const clip::Clip& clip, const results::Decomposed& decomposed,
                  const results::Phased& phased, const std::vector<Part>& parts,
                  const clip::PrepareOptions& prepare) {
    const auto count = std::ssize(decomposed.summaries);
    const std::vector<SignalSet> sets =
        count == 0 ? std::vector<SignalSet>() : signal_sets(clip, phased, parts, prepare.gaps);
    std::vector<Json> motions;
    for (const stltsa_summary& summary : decomposed.summaries) {
        const auto label = static_cast<std::int32_t>(summary.label);
        const bool cyclic = std::ranges::any_of(
            decomposed.cycles, [&](const stltsa_part& cycle) { return cycle.label == label; });
        JsonObject motion(
            "label", label, "cyclic", cyclic, "trend_margin",
            results::trend_margin(cyclic ? decomposed.cycles : decomposed.repetitions, label));
        std::vector<Json> shown_sets;
        std::string reason;
        try {
            for (const SignalSet& set : sets) {
                const phase::Resampled cycles =
                    results::resample(phased, label, set.rows.view(), samples);
                const auto shown = shown_cycles(std::ssize(cycles.each),
                                                set.rows.cols() * std::ssize(sets), count);
                if (shown_sets.empty())
                    motion.set("times", times_json(cycles.rows));
                shown_sets.push_back(set_json(set, cycles, shown));
            }
        } catch (const Error& error) { // cycles too short for a phase
            if (error.status() != Status::argument)
                throw;
            reason = error.what();
        }
        motion.set("reason", reason, "sets", shown_sets);
        if (cyclic)
            motion.set("sides", compared_sides(clip, phased, label, prepare));
        motions.push_back(motion);
    }
    return motions;
}

} // namespace stltsa::report
