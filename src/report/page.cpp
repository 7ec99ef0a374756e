// SPDX-License-Identifier: BSD-3-Clause
#include "report/page.hpp"

#include <algorithm>

#include "base/numbers.hpp"
#include "base/progress.hpp"
#include "report/body.hpp"
#include "report/curve_rows.hpp"
#include "report/motions.hpp"
#include "report/packed.hpp"
#include "report/template.hpp"
#include "results/mirror_image.hpp"
#include "results/phased.hpp"

namespace stltsa::report {
namespace {

/// Of a series with more rows than this, only every second, third, ... is kept.
constexpr std::int64_t most_rows = 200'000;

std::int64_t step_of(std::int64_t rows) {
    return std::max<std::int64_t>(1, (rows + most_rows - 1) / most_rows);
}

Json curve_json(const results::Decomposed& decomposed) {
    const std::int64_t step = step_of(std::ssize(decomposed.curve.curve));
    const results::SampleFacts& samples = decomposed.source.samples;
    return JsonObject("first", samples.first, "step", step * samples.step, "values",
                      packed(curve_rows(decomposed, step).view()));
}

/// Phase and distance from the mean cycle.
std::vector<std::string> texts_of(const Warnings& warnings) {
    std::vector<std::string> texts;
    for (const Warning& warning : warnings)
        texts.push_back(warning.text);
    return texts;
}

Json phase_json(const results::Phased& phased) {
    const auto count = static_cast<std::int64_t>(phased.phase.size());
    const std::int64_t step = step_of(count);
    Matrix rows((count + step - 1) / step, 2);
    for (std::int64_t r = 0; r < rows.rows(); ++r) {
        rows(r, 0) = phased.phase[static_cast<std::size_t>(r * step)];
        rows(r, 1) = phased.residual[static_cast<std::size_t>(r * step)];
    }
    return JsonObject("step", step, "values", packed(rows.view()), "warnings",
                      texts_of(phased.warnings));
}

Json accuracy_json(const motion::Curve& found) {
    return JsonObject("residual", found.residual, "error_estimate", found.error_estimate);
}

Json source_json(const Reported& reported) {
    JsonObject flags;
    for (const auto& [command, text] : reported.flags)
        flags.set(command, text);
    std::vector<Json> pieces;
    for (const clip::Frames& piece : reported.pieces)
        pieces.push_back(std::vector<Json>{piece.begin, piece.end});
    return JsonObject("name", reported.name, "pieces", pieces, "flags", flags);
}

/// The limit of a page is 2 MB (1 MB is 10^6 bytes) for up to 5000 frames of 31 joints, and grows
/// in proportion up to 10 MB. Postures get the remaining bytes, but at least 0.5 MB, even if the
/// page then exceeds its limit.
std::int64_t room_for_body(std::int64_t values, std::size_t used) {
    constexpr std::int64_t short_page = 1'980'000, longest_page = 9'900'000;
    constexpr std::int64_t least = 500'000, usual_values = std::int64_t{5000} * 31 * 3;
    const std::int64_t page =
        std::clamp(short_page * values / usual_values, short_page, longest_page);
    return std::max(least, page - static_cast<std::int64_t>(used));
}

std::string_view bytes_of(const Matrix& matrix) {
    return {reinterpret_cast<const char*>(matrix.data()),
            sizeof(double) * static_cast<std::size_t>(matrix.rows() * matrix.cols())};
}

} // namespace

std::string page(const Reported& reported) {
    const clip::Clip& clip = reported.clip;
    const auto found = results::phase_of(reported.decomposed);
    const results::Phased& phased = *found;
    results::check_same_clip(clip, *phased.of);
    report_progress(Stage::write, 0);
    const std::vector<Part> parts = parts_of(clip);
    JsonObject data("format", "stltsa-report/1", "command", reported.command, "checksum",
                    checksum(bytes_of(clip.values)), "source", source_json(reported));
    data.set("accuracy", accuracy_json(reported.decomposed.curve), "curve",
             curve_json(reported.decomposed), "phase", phase_json(phased), "motions",
             motions_json(clip, reported.decomposed, phased, parts, reported.prepare));
    const Template around = report_template();
    data.set("body",
             body_json(clip, parts, phased.samples.up,
                       room_for_body(clip.frames() * places_width(clip),
                                     around.size() + data.text().size() + reported.json.size())));
    checkpoint();
    std::string json = data.text();
    json.insert(1, "\"decomposition\":" + reported.json + ',');
    return filled(around, json);
}

} // namespace stltsa::report
