// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include "base/side_name.hpp"
#include "capi/boundary/arrays.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/boundary/structs.hpp"
#include "capi/handles.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;
using results::SidePair;

namespace {

const SidePair* pair_at(const stltsa_sides* sides, int64_t index) {
    if (index < 0 || index >= stltsa_sides_count(sides))
        return nullptr;
    return &sides->pairs[static_cast<std::size_t>(index)];
}

std::vector<std::string> names_of(const char* const* names, int64_t columns) {
    required(names, "names");
    std::vector<std::string> texts;
    for (int64_t c = 0; c < columns; ++c) {
        if (names[c] == nullptr)
            fail(Status::argument, "name {} is NULL; use \"\" for a column without a name", c);
        texts.emplace_back(names[c]);
    }
    return texts;
}

template <class Value>
void write_curves(const stltsa_out* out, const char* name, const results::ComparedSides& sides,
                  const Value& value) {
    if (out == nullptr)
        return;
    Matrix curves(sides.samples, static_cast<int64_t>(sides.pairs.size()));
    for (int64_t s = 0; s < curves.rows(); ++s)
        for (int64_t p = 0; p < curves.cols(); ++p)
            curves(s, p) =
                value(sides.pairs[static_cast<std::size_t>(p)], static_cast<std::size_t>(s));
    capi::write_output(out, name, curves.view());
}

void check_curves(const stltsa_out* out, const char* name, const results::ComparedSides& sides) {
    if (out != nullptr)
        capi::check_output(out, name, sides.samples, static_cast<int64_t>(sides.pairs.size()));
}

} // namespace

static_assert(static_cast<int32_t>(Side::left) == STLTSA_SIDE_LEFT &&
              static_cast<int32_t>(Side::right) == STLTSA_SIDE_RIGHT &&
              static_cast<int32_t>(Side::none) == STLTSA_SIDE_NONE);

int32_t stltsa_side_of_name(const char* name) noexcept {
    return name == nullptr ? STLTSA_SIDE_NONE : static_cast<int32_t>(side_of_name(name));
}

stltsa_status stltsa_sides_find(const stltsa_clip* clip, const stltsa_phase* phase, int32_t label,
                                int64_t samples, const stltsa_options* options,
                                stltsa_sides** sides) noexcept {
    return compute([&] {
        required(sides, "sides") = nullptr;
        const clip::Clip& of = required(clip, "clip").clip;
        const results::Phased& by = required(phase, "phase");
        capi::check_samples(samples);
        const capi::OptionsReader reader(options);
        *sides = new stltsa_sides(results::compare_sides(
            of, by, label, samples, reader.prepare_options(), reader.progress()));
    });
}

stltsa_status stltsa_sides_compare(const stltsa_cycles* cycles, const char* const* names,
                                   stltsa_sides** sides) noexcept {
    return compute([&] {
        required(sides, "sides") = nullptr;
        const phase::Resampled& of = required(cycles, "cycles");
        *sides = new stltsa_sides(results::compare_sides(of, names_of(names, of.mean.cols())));
    });
}

void stltsa_sides_free(stltsa_sides* sides) noexcept {
    delete sides;
}

int64_t stltsa_sides_count(const stltsa_sides* sides) noexcept {
    return sides == nullptr ? 0 : static_cast<int64_t>(sides->pairs.size());
}

stltsa_status stltsa_sides_pair(const stltsa_sides* sides, int64_t index,
                                stltsa_side_pair* pair) noexcept {
    return guard([&] {
        required(sides, "sides");
        const SidePair* found = pair_at(sides, index);
        if (found == nullptr)
            fail(Status::argument, "pair {} does not exist: there are {}", index,
                 stltsa_sides_count(sides));
        const phase::CurveDifference& of = found->difference;
        const stltsa_side_pair copy = {sizeof(stltsa_side_pair),
                                       found->left,
                                       found->right,
                                       of.rms,
                                       of.chance,
                                       of.mean,
                                       of.left_range,
                                       of.right_range,
                                       of.shift,
                                       of.correlation};
        capi::give(copy, pair, "pair", "stltsa_side_pair");
    });
}

const char* stltsa_sides_left_name(const stltsa_sides* sides, int64_t index) noexcept {
    const SidePair* pair = pair_at(sides, index);
    return pair == nullptr ? "" : pair->left_name.c_str();
}

const char* stltsa_sides_right_name(const stltsa_sides* sides, int64_t index) noexcept {
    const SidePair* pair = pair_at(sides, index);
    return pair == nullptr ? "" : pair->right_name.c_str();
}

stltsa_status stltsa_sides_curves(const stltsa_sides* sides, const stltsa_out* left,
                                  const stltsa_out* right, const stltsa_out* difference) noexcept {
    return guard([&] {
        const results::ComparedSides& of = required(sides, "sides");
        check_curves(left, "left", of);
        check_curves(right, "right", of);
        check_curves(difference, "difference", of);
        const auto of_left = [](const SidePair& p, std::size_t s) { return p.left_curve[s]; };
        const auto of_right = [](const SidePair& p, std::size_t s) { return p.right_curve[s]; };
        write_curves(left, "left", of, of_left);
        write_curves(right, "right", of, of_right);
        write_curves(difference, "difference", of, [&](const SidePair& p, std::size_t s) {
            return of_left(p, s) - of_right(p, s);
        });
    });
}

const char* stltsa_sides_reason(const stltsa_sides* sides) noexcept {
    return sides == nullptr ? "" : sides->reason.c_str();
}
