// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string_view>

#include "base/progress.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/flags.hpp"
#include "capi/options/reader.hpp"
#include "clip/files/write_file.hpp"
#include "clip/text/text_cursor.hpp"
#include "report/comparison_page.hpp"
#include "report/figure/figure.hpp"
#include "report/page.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;

namespace {

/// How commands name the clip: as its reader did; empty: unknown.
std::string name_of(const stltsa_clip& clip) {
    const std::string& path = clip.clip.path;
    if (path.empty() || clip.pieces.empty())
        return path;
    return clip.stretch.empty() ? "" : path + ':' + clip.stretch;
}

/// Of a figure: the name without folders.
std::string title_of(const stltsa_clip& clip) {
    const std::string& path = clip.clip.path;
    if (path.empty())
        return "motion";
    return path.substr(path.find_last_of('/') + 1) +
           (clip.stretch.empty() ? "" : ':' + clip.stretch);
}

/// For the commands on the page.
std::vector<std::pair<const char*, std::string>> flags_by_command(const stltsa_options* options) {
    constexpr int32_t open = STLTSA_CALL_OPEN;
    return {{"decompose", capi::flags_of(options, open | STLTSA_CALL_DECOMPOSE)},
            {"events", capi::flags_of(options, open | STLTSA_CALL_DECOMPOSE)},
            {"synthesize", capi::flags_of(options, open | STLTSA_CALL_SYNTHESIZE)}};
}

} // namespace

stltsa_status stltsa_report_save(const stltsa_clip* clip, const stltsa_decomposition* decomposition,
                                 const stltsa_options* options, const char* command,
                                 const char* path) noexcept {
    return compute(options, [&] {
        const std::string place = &required(path, "path");
        const stltsa_clip& of = required(clip, "clip");
        const results::Decomposed& decomposed = required(decomposition, "decomposition");
        const capi::OptionsReader reader(options);
        const bool drawn = clip::equals_ignoring_case(
            std::string_view(place).substr(std::min(place.find_last_of('.'), place.size())),
            ".svg");
        const std::string page = drawn
                                     ? report::figure(of.clip, decomposed, title_of(of))
                                     : report::page({of.clip, decomposed, reader.prepare_options(),
                                                     capi::decomposition_json(decomposed),
                                                     command == nullptr ? "" : command, name_of(of),
                                                     of.pieces, flags_by_command(options)});
        report_progress(Stage::write, 1);
        clip::write_file(place, page);
    });
}

stltsa_status stltsa_comparison_report_save(const stltsa_comparison* comparison,
                                            const stltsa_options* options, const char* command,
                                            const char* path) noexcept {
    return guard(options, [&] {
        const std::string place = &required(path, "path");
        const stltsa_comparison& of = required(comparison, "comparison");
        report_progress(Stage::write, 0);
        const std::string page = report::comparison_page(of, capi::comparison_json(of),
                                                         command == nullptr ? "" : command);
        report_progress(Stage::write, 1);
        clip::write_file(place, page);
    });
}
