// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"
#include "report.hpp"
#include "session.hpp"

namespace tool {

Exit run_dimension(const Arguments& arguments) {
    Session session(arguments);
    const Json object =
        parsed_json(stltsa::dimension(session.open_input(), session.options()).json());
    session.finish(object, dimension_report(object, session.title(), session.colors()));
    const bool nothing =
        object["local_pca"]["dimension"].is_null() && object["eigengap"]["dimension"].is_null();
    return nothing ? Exit::untrustworthy : Exit::done;
}

} // namespace tool
