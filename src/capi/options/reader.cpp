// SPDX-License-Identifier: BSD-3-Clause
#include "capi/options/reader.hpp"

#include <algorithm>
#include <cstring>

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/options/table.hpp"

namespace stltsa::capi {
namespace {

[[noreturn]] void refuse_unset(const stltsa_option_info& row) {
    fail(Status::argument, "option {} is not set, so that the library chooses its value", row.name);
}

double number(const stltsa_options* options, const stltsa_option_info& row) {
    if (options != nullptr)
        if (const auto found = options->numbers.find(row.key); found != options->numbers.end())
            return found->second;
    if (row.automatic != 0)
        refuse_unset(row);
    return row.standard;
}

/// The comparison is false for NaN, which is so refused.
void set_number(stltsa_options& options, int32_t key, int32_t type, double value) {
    const auto& row = option_row(key, type);
    if (!(value >= row.minimum && value <= row.maximum))
        fail(Status::argument, "option {} is {}; it must be from {} to {}", row.name, value,
             row.minimum, row.maximum);
    options.numbers[key] = value;
}

constexpr bool same_features(clip::Features features, int value) {
    return static_cast<int>(features) == value;
}
static_assert(same_features(clip::Features::positions, STLTSA_FEATURES_POSITIONS) &&
              same_features(clip::Features::rotations6d, STLTSA_FEATURES_ROTATIONS6D) &&
              same_features(clip::Features::euler, STLTSA_FEATURES_EULER) &&
              same_features(clip::Features::raw, STLTSA_FEATURES_RAW) &&
              same_features(clip::Features::points, STLTSA_FEATURES_POINTS));
constexpr bool same_rule(clip::GapRule rule, int value) {
    return static_cast<int>(rule) == value;
}
static_assert(same_rule(clip::GapRule::fill, STLTSA_GAPS_FILL) &&
              same_rule(clip::GapRule::refuse, STLTSA_GAPS_REFUSE) &&
              same_rule(clip::GapRule::skip, STLTSA_GAPS_SKIP));
constexpr bool same_mode(ltsa::Mode mode, int value) {
    return static_cast<int>(mode) == value;
}
static_assert(same_mode(ltsa::Mode::temporal, STLTSA_MODE_TEMPORAL) &&
              same_mode(ltsa::Mode::spatial, STLTSA_MODE_SPATIAL) &&
              same_mode(ltsa::Mode::recurrent, STLTSA_MODE_RECURRENT));

} // namespace

Call::Asked asked_by(const stltsa_options* options) {
    return options == nullptr ? Call::Asked() : options->progress;
}

bool is_set(const stltsa_options* options, int32_t key) {
    return options != nullptr && (options->numbers.contains(key) || options->texts.contains(key));
}

std::int64_t OptionsReader::integer(int32_t key) const {
    return static_cast<std::int64_t>(number(options_, option_row(key, STLTSA_TYPE_INT)));
}

double OptionsReader::real(int32_t key) const {
    return number(options_, option_row(key, STLTSA_TYPE_REAL));
}

std::optional<double> OptionsReader::real_if_set(int32_t key) const {
    return is_set(options_, key) ? std::optional(real(key)) : std::nullopt;
}

const char* OptionsReader::text(int32_t key) const {
    const auto& row = option_row(key, STLTSA_TYPE_TEXT);
    if (!is_set(options_, key))
        refuse_unset(row);
    return options_->texts.at(key).c_str();
}

int OptionsReader::threads() const {
    return thread_count(integer_if_set(STLTSA_OPT_THREADS));
}

clip::ReadOptions OptionsReader::read_options() const {
    clip::ReadOptions read;
    read.fps = real_if_set(STLTSA_OPT_FPS);
    if (is_set(options_, STLTSA_OPT_SKELETON))
        read.skeleton = text(STLTSA_OPT_SKELETON);
    if (is_set(options_, STLTSA_OPT_SUBJECT))
        read.subject = text(STLTSA_OPT_SUBJECT);
    read.min_confidence = real(STLTSA_OPT_MIN_CONFIDENCE);
    return read;
}

clip::PrepareOptions OptionsReader::prepare_options() const {
    clip::PrepareOptions prepare;
    prepare.features = integer_if_set<clip::Features>(STLTSA_OPT_FEATURES);
    prepare.up = integer_if_set<clip::Axis>(STLTSA_OPT_UP_AXIS);
    prepare.rate = real(STLTSA_OPT_SAMPLE_RATE);
    prepare.smoothing = real(STLTSA_OPT_SMOOTHING);
    prepare.drop_tpose = integer(STLTSA_OPT_KEEP_START) == 0;
    prepare.gaps = static_cast<clip::GapRule>(integer(STLTSA_OPT_GAPS));
    return prepare;
}

std::optional<ltsa::DimensionOptions> OptionsReader::intrinsic_options() const {
    if (integer(STLTSA_OPT_INTRINSIC) == 0)
        return std::nullopt;
    return ltsa::DimensionOptions{real(STLTSA_OPT_EIGENGAP), real(STLTSA_OPT_VARIANCE)};
}

motion::Options OptionsReader::decompose_options() const {
    for (const std::int32_t key :
         {STLTSA_OPT_NEIGHBORS, STLTSA_OPT_WINDOW, STLTSA_OPT_DIMENSION, STLTSA_OPT_MODE})
        if (is_set(options_, key))
            fail(
                Status::argument,
                "option {} belongs to fit: decompose embeds each segment with cycles at 24 samples "
                "a cycle, with parameters of its own",
                option_row(key).name);
    motion::Options options;
    options.segments = integer_if_set(STLTSA_OPT_SEGMENTS);
    const results::PeriodRange range = results::range_of(period_search(), 1, 0); // in seconds
    options.periods = {range.shortest, range.longest};
    return options;
}

results::PeriodSearch OptionsReader::period_search() const {
    return {real_if_set(STLTSA_OPT_PERIOD_MIN), real_if_set(STLTSA_OPT_PERIOD_MAX)};
}

results::FitOptions OptionsReader::fit_options() const {
    results::FitOptions fit;
    fit.neighbors = integer_if_set(STLTSA_OPT_NEIGHBORS);
    fit.window = integer_if_set(STLTSA_OPT_WINDOW);
    fit.exclusion = integer_if_set(STLTSA_OPT_EXCLUSION);
    fit.links = integer(STLTSA_OPT_LINKS);
    fit.dimension = integer_if_set<int>(STLTSA_OPT_DIMENSION);
    fit.mode = static_cast<ltsa::Mode>(integer(STLTSA_OPT_MODE));
    fit.include_self = integer(STLTSA_OPT_INCLUDE_SELF) != 0;
    fit.search = period_search();
    fit.threads = threads();
    return fit;
}

results::MapOptions OptionsReader::map_options(const ltsa::Parameters& fitted) const {
    const results::MapRequest asked = {integer_if_set(STLTSA_OPT_MAP_NEIGHBORS),
                                       integer(STLTSA_OPT_MAP_BLEND),
                                       integer_if_set(STLTSA_OPT_HINT_WINDOW)};
    return {results::choose_map_parameters(asked, fitted), threads()};
}

results::DenoiseOptions OptionsReader::denoise_options() const {
    return {real_if_set(STLTSA_OPT_GAMMA), real_if_set(STLTSA_OPT_KNOT_SPACING),
            integer(STLTSA_OPT_ROBUST) != 0, period_search()};
}

synthesis::Options OptionsReader::synthesis_options() const {
    return {real_if_set(STLTSA_OPT_CROSSFADE), real_if_set(STLTSA_OPT_CUT_RANGE),
            real(STLTSA_OPT_POSTURE_LIMIT),    prepare_options().up,
            integer(STLTSA_OPT_LOOP) != 0,     integer(STLTSA_OPT_IN_PLACE) != 0};
}

} // namespace stltsa::capi

using namespace stltsa;
using capi::guard;
using capi::required;

stltsa_status stltsa_option_describe(int64_t index, stltsa_option_info* info) noexcept {
    return guard([&] {
        const std::size_t size = required(info, "info").size;
        const auto table = capi::options_table();
        if (index < 0 || index >= static_cast<int64_t>(table.size()))
            fail(Status::argument, "option index {} is not in 0 .. {}", index, table.size() - 1);
        // A caller built against a shorter struct gets the fields it knows.
        if (size < sizeof(size_t) + 2 * sizeof(int32_t))
            fail(Status::argument, "info->size is {}; set it to sizeof(stltsa_option_info)", size);
        stltsa_option_info row = table[static_cast<std::size_t>(index)];
        row.size = size;
        std::memcpy(info, &row, std::min(size, sizeof row));
    });
}

stltsa_status stltsa_options_new(stltsa_options** options) noexcept {
    return guard([&] { required(options, "options") = nullptr, *options = new stltsa_options; });
}

void stltsa_options_free(stltsa_options* options) noexcept {
    delete options;
}

stltsa_status stltsa_options_set_int(stltsa_options* options, int32_t key, int64_t value) noexcept {
    return guard([&] {
        capi::set_number(required(options, "options"), key, STLTSA_TYPE_INT,
                         static_cast<double>(value));
    });
}

stltsa_status stltsa_options_set_real(stltsa_options* options, int32_t key, double value) noexcept {
    return guard(
        [&] { capi::set_number(required(options, "options"), key, STLTSA_TYPE_REAL, value); });
}

stltsa_status stltsa_options_set_text(stltsa_options* options, int32_t key,
                                      const char* value) noexcept {
    return guard([&] {
        const auto& row = capi::option_row(key, STLTSA_TYPE_TEXT);
        if (required(value, "value") == '\0')
            fail(Status::argument, "option {} is empty; leave it unset instead", row.name);
        required(options, "options").texts[key] = value;
    });
}

stltsa_status stltsa_options_unset(stltsa_options* options, int32_t key) noexcept {
    return guard([&] {
        const auto& row = capi::option_row(key);
        required(options, "options").numbers.erase(row.key);
        options->texts.erase(row.key);
    });
}

int32_t stltsa_options_is_set(const stltsa_options* options, int32_t key) noexcept {
    return capi::is_set(options, key) ? 1 : 0;
}

stltsa_status stltsa_options_get_int(const stltsa_options* options, int32_t key,
                                     int64_t* value) noexcept {
    return guard([&] { required(value, "value") = capi::OptionsReader(options).integer(key); });
}

stltsa_status stltsa_options_get_real(const stltsa_options* options, int32_t key,
                                      double* value) noexcept {
    return guard([&] { required(value, "value") = capi::OptionsReader(options).real(key); });
}

stltsa_status stltsa_options_get_text(const stltsa_options* options, int32_t key,
                                      const char** value) noexcept {
    return guard([&] { required(value, "value") = capi::OptionsReader(options).text(key); });
}

stltsa_status stltsa_options_set_progress(stltsa_options* options, stltsa_progress_fn progress,
                                          void* user) noexcept {
    return guard([&] { required(options, "options").progress = {progress, user}; });
}
