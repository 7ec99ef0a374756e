// SPDX-License-Identifier: BSD-3-Clause
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/report.hpp"

namespace tool {

Exit run_dimension(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Dimension found =
        stltsa::estimate_dimension(session.open_input(), session.options());
    session.finish({[&] { return found.json(); },
                    [&] { return dimension_report(found, session.title()); },
                    {}});
    const bool nothing = found.local_pca().dimension == 0 && found.eigengap().dimension == 0;
    return nothing ? Exit::untrustworthy : Exit::done;
}

} // namespace tool
