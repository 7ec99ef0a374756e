// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/mapped.hpp"
#include "commands/session.hpp"
#include "reports/report.hpp"

namespace tool {
namespace {

/// Warns if the clip's frames are not comparable with the model's.
std::vector<std::string> warnings_of(const stltsa::Model& model, const stltsa::Clip& clip) {
    const stltsa::Info info = model.info();
    const double smoothing = info.real(STLTSA_INFO_SMOOTHING);
    if (!(smoothing > 0 && info.real(STLTSA_INFO_FPS) > 0) || clip.fps() > 0)
        return {};
    return {fmt::format("the clip has no frame rate, so its frames are not smoothed like the "
                        "model's (over {:.3g} s): set --fps",
                        smoothing)};
}

} // namespace

Exit run_map(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Model model = session.open_model(arguments.model);
    const stltsa::Clip& clip = session.open_input();
    const Mapping mapping{arguments, model, model.map(clip, session.options()), clip.fps(),
                          warnings_of(model, clip)};
    if (!arguments.product.empty())
        session.add_table(arguments.product, mapping.rows.values, "y", clip.fps());
    session.finish({[&] { return mapping_json(mapping); },
                    [&] { return mapping_report(mapping, session.title()); }, mapping.warnings});
    return Exit::done;
}

} // namespace tool
