// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "arguments/option_flags.hpp"
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "exit_status.hpp"
#include "reports/comparison.hpp"
#include "reports/table.hpp"

namespace tool {
namespace {

constexpr std::int64_t samples = 101; // of each cycle

/// The phase of a clip with cycles.
stltsa::Phase phase_of(const Session& session, const std::string& path, const stltsa::Clip& clip) {
    const stltsa::Decomposition found = stltsa::decompose(clip, session.options());
    if (found.cycles().empty())
        throw Failure(Exit::untrustworthy,
                      fmt::format("{}: there are no cycles to compare{}{}", path,
                                  found.reason().empty() ? "" : ": ", found.reason()));
    return stltsa::find_phase(found, session.options());
}

/// The result of a comparison, which clips of other motions or names do not permit.
template <class Compare>
stltsa::Comparison if_comparable(Compare compare) {
    try {
        return compare();
    } catch (const stltsa::Error& error) {
        if (error.status() != STLTSA_E_UNSUPPORTED && error.status() != STLTSA_E_SHAPE)
            throw;
        throw Failure(Exit::untrustworthy, with_flags(error.what()));
    }
}

} // namespace

Exit run_compare(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Clip& clip = session.open_input();
    const stltsa::Phase phase = phase_of(session, arguments.input, clip);
    const std::string other = arguments.pieces.empty() ? "" : arguments.pieces.front();
    const auto compared = [&] {
        if (other.empty())
            return if_comparable(
                [&] { return phase.compare_left_right(clip, -1, session.options()); });
        const stltsa::Clip second = session.open_clip(other);
        const stltsa::Phase of_second = phase_of(session, other, second);
        return if_comparable(
            [&] { return phase.compare(of_second, -1, -1, samples, session.options()); });
    };
    const stltsa::Comparison comparison = compared();
    if (!arguments.report.empty())
        session.add_saved(arguments.report, ".html", [&](const std::string& name) {
            comparison.save_report(name, arguments.line);
        });
    session.finish(
        {[&] { return comparison.json(); },
         [&] { return comparison_report(comparison, session.title(), Session::title_of(other)); },
         texts_of(comparison.warnings()), [&] { return comparison_csv(comparison); }});
    return Exit::done;
}

} // namespace tool
