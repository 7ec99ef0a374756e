// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"
#include "report.hpp"
#include "session.hpp"

namespace tool {

Exit run_dimension(const Arguments& arguments) {
    Session session(arguments);
    session.open_input();
    const auto result = made_by<Dimension>([&](stltsa_dimension_result** made) {
        return stltsa_dimension_clip(session.clip(), session.options(), made);
    });
    const Json object = json_of(stltsa_dimension_json, result.get());
    session.finish(object, dimension_report(object, session.title(), session.colors()));
    const bool nothing =
        object["local_pca"]["dimension"].is_null() && object["eigengap"]["dimension"].is_null();
    return nothing ? Exit::untrustworthy : Exit::done;
}

} // namespace tool
