// SPDX-License-Identifier: BSD-3-Clause
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/report.hpp"

namespace tool {

Exit run_info(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Clip& clip = session.open_input();
    session.finish(
        {[&] { return clip.json(); }, [&] { return info_report(clip, session.title()); }, {}});
    return Exit::done;
}

} // namespace tool
