// SPDX-License-Identifier: BSD-3-Clause
// Cycles of motions that were made up: exact counts, and what must not change them.
#include "recordings.hpp"

#include <functional>
#include <numeric>

namespace {

using namespace motion_testing;

constexpr double rate = 50;
constexpr double stands = 1.5; ///< seconds before and after

double minimum_jerk(double share) {
    const double x = std::clamp(share, 0.0, 1.0);
    return x * x * x * (10 - 15 * x + 6 * x * x);
}

/// A motion that begins and ends in the posture of standing, in meters: how far each column goes,
/// and to which side it swings on the way; the last ones, arms, are ahead of the others.
struct Action {
    double seconds;
    std::vector<std::pair<double, double>> columns;
};
const Action squat{2,
                   {{0.25, 0.02},
                    {-0.08, 0.02},
                    {-0.2, -0.03},
                    {-0.42, 0},
                    {0.05, 0.03},
                    {-0.45, 0},
                    {0.55, 0.1},
                    {0.05, -0.15}}};
const Action jack{1.1,
                  {{0.25, 0},
                   {0, 0.06},
                   {0.14, 0},
                   {-0.02, 0.06},
                   {-0.04, 0.07},
                   {0.02, 0.6},
                   {1.1, 0.07},
                   {0.6, 0.07}}};
const Action bow{2.4,
                 {{-0.02, 0},
                  {-0.1, 0},
                  {0.35, 0.03},
                  {-0.25, 0.08},
                  {0.55, 0.05},
                  {-0.4, 0.12},
                  {0.25, -0.04},
                  {-0.25, 0.05}}};

struct Repeated {
    Matrix samples;
    std::vector<double> begins; ///< samples
};

/// Lengths and sizes vary by 4 %; a millimeter of noise.
Repeated repeated(const Action& action, int count, double pause) {
    Random random(static_cast<std::uint64_t>(count));
    std::vector<double> lengths, begins, sizes;
    double at = stands;
    for (int i = 0; i < count; ++i) {
        begins.push_back(at * rate);
        lengths.push_back(action.seconds * (1 + 0.04 * random.symmetric()));
        sizes.push_back(1 + 0.04 * random.symmetric());
        at += lengths.back() + pause;
    }
    Repeated made{Matrix(static_cast<std::int64_t>((at + stands) * rate),
                         static_cast<std::int64_t>(action.columns.size())),
                  begins};
    for (std::int64_t i = 0; i < made.samples.rows(); ++i) {
        double legs = 0, arms = 0;
        for (std::size_t k = 0; k < begins.size(); ++k) {
            const double share = (static_cast<double>(i) - begins[k]) / (lengths[k] * rate);
            legs += sizes[k] * minimum_jerk(share / 0.45) * minimum_jerk((1 - share) / 0.47);
            arms += sizes[k] * minimum_jerk(share / 0.4) * minimum_jerk((1 - share) / 0.53);
        }
        for (std::size_t c = 0; c < action.columns.size(); ++c) {
            const double way = c + 2 < action.columns.size() ? legs : arms;
            const auto [far, arc] = action.columns[c];
            made.samples(i, static_cast<std::int64_t>(c)) =
                way * far + 4 * way * (1 - way) * arc + 0.001 * random.symmetric();
        }
    }
    return made;
}

Recording of_body(stltsa::ConstMatrixView samples, std::vector<double> side = {}) {
    Options options;
    options.size = 2;
    for (const double weight : side) {
        options.one_side.push_back(std::max(0.0, weight));
        options.other_side.push_back(std::max(0.0, -weight));
    }
    options.forward = true;
    options.side = std::move(side);
    return analyze(samples, rate, options);
}

/// Cycles and repetitions of all segments.
std::int64_t counted(const Recording& found) {
    return std::accumulate(found.segments.begin(), found.segments.end(), std::int64_t{0},
                           [](std::int64_t sum, const Segment& each) { return sum + each.count; });
}

void back_to_back_from_standing_to_standing(void**) {
    for (const Action* action : {&squat, &jack, &bow})
        for (const int count : {2, 3, 5, 8, 13, 20}) {
            const Repeated made = repeated(*action, count, 0);
            const Recording found = of_body(made.samples.view());
            check_cover(found, made.samples);
            assert_int_equal(found.cycles.size(), count);
            assert_int_equal(moving_kinds(found).size(), 1);
            for (std::size_t i = 0; i < found.cycles.size(); ++i)
                ASSERT_NEAR((found.cycles[i].begin - made.begins[i]) / rate, 0,
                            0.25 * action->seconds);
        }
}

void with_pauses_between(void**) {
    for (const Action* action : {&squat, &jack, &bow})
        for (const int count : {2, 3, 5, 8, 13, 20}) {
            const Repeated made = repeated(*action, count, 0.7);
            assert_int_equal(counted(of_body(made.samples.view())), count);
        }
}

/// Two millimeters of chest, as by breathing, and noise.
void breathing_is_rest(void**) {
    Random random(5);
    Matrix samples(static_cast<std::int64_t>(12 * rate), columns);
    for (std::int64_t i = 0; i < samples.rows(); ++i)
        for (std::int64_t c = 0; c < columns; ++c)
            samples(i, c) = (c < 4 ? 0.002 : 0.001) *
                                std::sin(2 * std::numbers::pi * static_cast<double>(i) / rate / 3) +
                            0.0005 * random.symmetric();
    const Recording found = of_body(samples.view());
    assert_true(moving_kinds(found).empty());
    assert_true(found.cycles.empty());
    assert_string_equal(found.reason.c_str(), "no period: nothing moves");
}

/// Columns of the left side, and then the same of the right side, half a cycle later.
Matrix walk(double seconds, double period, double noise = 0.001) {
    Random random(2);
    Matrix samples(static_cast<std::int64_t>(seconds * rate), 8);
    for (std::int64_t i = 0; i < samples.rows(); ++i)
        for (std::int64_t c = 0; c < 8; ++c) {
            const double turn =
                2 * std::numbers::pi * (static_cast<double>(i) / rate / period + (c < 4 ? 0 : 0.5));
            const double wave = c % 4 == 0   ? 0.4 * std::sin(turn) + 0.05 * std::sin(2 * turn)
                                : c % 4 == 1 ? 0.1 * std::cos(turn) + 0.05 * std::cos(2 * turn)
                                : c % 4 == 2 ? 0.2 * std::sin(turn + 0.5)
                                             : 0.03 * std::sin(2 * turn + 1);
            samples(i, c) = wave + noise * random.symmetric();
        }
    return samples;
}
const std::vector<double> left_against_right{1, 0, 0, 0, -1, 0, 0, 0};

void symmetric_walks_have_equal_steps(void**) {
    for (const double period : {0.9, 1.1, 1.4}) {
        const Recording found = of_body(walk(10, period).view(), left_against_right);
        assert_true(found.cycles.size() >= static_cast<std::size_t>(10 / period) - 1);
        assert_int_equal(found.steps.size(), 2 * found.cycles.size());
        double lengths[2] = {0, 0};
        for (std::size_t i = 0; i < found.steps.size(); ++i) {
            const Step& step = found.steps[i];
            if (i > 0)
                assert_int_equal(step.side, 1 - found.steps[i - 1].side);
            lengths[step.side] +=
                (step.end - step.begin) / rate / static_cast<double>(found.cycles.size());
        }
        ASSERT_NEAR(lengths[0], lengths[1], 0.002);
        ASSERT_NEAR(lengths[0], period / 2, 0.002);
    }
}

void check_same_cycles(const Recording& a, const Recording& b, double accuracy) {
    assert_true(a.cycles.size() > 2);
    assert_int_equal(a.cycles.size(), b.cycles.size());
    for (std::size_t i = 0; i < a.cycles.size(); ++i) {
        ASSERT_NEAR(a.cycles[i].begin, b.cycles[i].begin, accuracy);
        ASSERT_NEAR(a.cycles[i].end, b.cycles[i].end, accuracy);
    }
}

Matrix changed(const Matrix& samples,
               const std::function<double(std::int64_t row, std::int64_t column)>& value) {
    Matrix result(samples.rows(), samples.cols());
    for (std::int64_t i = 0; i < samples.rows(); ++i)
        for (std::int64_t c = 0; c < samples.cols(); ++c)
            result(i, c) = value(i, c);
    return result;
}

/// Of motions whose rest is known, and of those that are cut at margins.
void units_of_length_change_nothing(void**) {
    for (const Matrix& samples : {repeated(squat, 5, 0).samples, walk(8, 1.1)}) {
        Options meters, millimeters;
        meters.size = 2;
        millimeters.size = 2000;
        const Matrix scaled =
            changed(samples, [&](auto i, auto c) { return 1000 * samples(i, c) + 50; });
        check_same_cycles(analyze(samples.view(), rate, meters),
                          analyze(scaled.view(), rate, millimeters), 1e-3);
    }
}

/// The mirror image does the same at the same times, with the other side. The 7.9 turns leave room
/// for seven cycles from either side's margin, after 0.2 and 0.7 of a cycle.
void the_mirror_image_has_the_same_steps(void**) {
    const Matrix samples = walk(10, 1.1);
    const Matrix mirrored =
        changed(samples, [&](auto i, auto c) { return samples(i, (c + 4) % 8); });
    const Recording a = of_body(samples.view().block(14, 434), left_against_right),
                    b = of_body(mirrored.view().block(14, 434), left_against_right);
    assert_true(std::abs(std::ssize(a.cycles) - std::ssize(b.cycles)) <= 1);
    for (const Step& step : a.steps) {
        const auto same = std::ranges::min_element(
            b.steps, {}, [&](const Step& other) { return std::abs(other.begin - step.begin); });
        if (std::abs(same->begin - step.begin) < 0.25 * rate) // the ends may differ
            assert_true(std::abs(same->begin - step.begin) < 0.03 * rate &&
                        same->side == 1 - step.side);
    }
}

/// Backwards there are as many, from rest to rest or not.
void backwards_there_are_as_many(void**) {
    for (const Matrix& samples :
         {repeated(squat, 5, 0).samples, repeated(jack, 8, 0).samples, walk(8, 1.1)}) {
        const Matrix backwards =
            changed(samples, [&](auto i, auto c) { return samples(samples.rows() - 1 - i, c); });
        const Recording a = of_body(samples.view()), b = of_body(backwards.view());
        assert_true(!a.cycles.empty());
        assert_int_equal(a.cycles.size(), b.cycles.size());
    }
}

/// Less of the standing before: the same cycles.
void a_crop_of_the_rest_moves_no_border(void**) {
    const Matrix samples = repeated(squat, 5, 0).samples;
    const Recording whole = of_body(samples.view());
    assert_int_equal(whole.cycles.size(), 5);
    for (const std::int64_t cut : {10, 25, 45}) {
        Recording part = of_body(samples.view().block(cut, samples.rows() - cut));
        for (Cycle& cycle : part.cycles) {
            cycle.begin += static_cast<double>(cut);
            cycle.end += static_cast<double>(cut);
        }
        check_same_cycles(whole, part, 0.1 * rate);
    }
}

/// The walk, whose cycles may begin at places `first` seconds and so many periods after the start,
/// except those of turn `without`.
Recording with_strikes(double first, double period, int without) {
    Options options;
    options.size = 2;
    options.strikes = [=](const Recording& found) {
        Strikes strikes{found.segments.front().label, 1, {}, {}};
        for (int turn = 0; turn < 9; ++turn)
            if (turn != without)
                strikes.begins.push_back((first + turn * period) * rate);
        return std::vector<Strikes>{strikes};
    };
    return analyze(walk(10, 1.1).view(), rate, options);
}

void cycles_begin_at_strikes(void**) {
    const Recording plain = of_body(walk(10, 1.1).view());
    const Recording found = with_strikes(0.3, 1.1, -1);
    check_cover(found, walk(10, 1.1));
    assert_int_equal(found.cycles.size(), 8);
    for (std::size_t i = 0; i < found.cycles.size(); ++i) {
        assert_true(found.cycles[i].at_strikes);
        ASSERT_NEAR(found.cycles[i].begin, (0.3 + static_cast<double>(i) * 1.1) * rate, 1e-6);
    }
    // A stumble without a strike makes no cycle of two turns; strikes twice a turn, none of a half.
    for (const Recording& same : {with_strikes(0.3, 1.1, 4), with_strikes(0.3, 0.55, -1)}) {
        assert_false(same.cycles.front().at_strikes);
        check_same_cycles(plain, same, 1e-9);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(back_to_back_from_standing_to_standing),
        cmocka_unit_test(with_pauses_between),
        cmocka_unit_test(breathing_is_rest),
        cmocka_unit_test(symmetric_walks_have_equal_steps),
        cmocka_unit_test(units_of_length_change_nothing),
        cmocka_unit_test(the_mirror_image_has_the_same_steps),
        cmocka_unit_test(backwards_there_are_as_many),
        cmocka_unit_test(a_crop_of_the_rest_moves_no_border),
        cmocka_unit_test(cycles_begin_at_strikes),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
