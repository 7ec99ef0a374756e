// SPDX-License-Identifier: BSD-3-Clause
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/report.hpp"

namespace tool {

Exit run_dimension(const Arguments& arguments) {
    Session session(arguments);
    session.set_default(STLTSA_OPT_INTRINSIC, 1);
    const stltsa::Model found = stltsa::fit(session.open_input(), session.options());
    session.finish({[&] { return found.json(); },
                    [&] { return dimension_report(found, session.title()); },
                    {}});
    const stltsa::Info info = found.info();
    const bool nothing =
        info.integer(STLTSA_INFO_LOCAL_PCA) == 0 && info.integer(STLTSA_INFO_EIGENGAP) == 0;
    return nothing ? Exit::untrustworthy : Exit::done;
}

} // namespace tool
