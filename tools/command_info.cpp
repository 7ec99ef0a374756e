// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"
#include "report.hpp"
#include "session.hpp"

namespace tool {

Exit run_info(const Arguments& arguments) {
    Session session(arguments);
    session.open_input();
    const Json clip = parsed_json(session.clip().json());
    session.finish(clip, info_report(clip, session.title(), session.colors()));
    return Exit::done;
}

} // namespace tool
