// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"
#include "coords_file.hpp"
#include "make_figure.hpp"
#include "report.hpp"
#include "session.hpp"

namespace tool {
namespace {

Grid coordinates(const stltsa_model* model) {
    std::int64_t rows = 0;
    std::int64_t cols = 0;
    check(stltsa_model_get_int(model, STLTSA_MODEL_FRAMES, &rows));
    check(stltsa_model_get_int(model, STLTSA_MODEL_DIMENSION, &cols));
    return grid_of(stltsa_model_coords, model, rows, cols);
}

} // namespace

Exit run_fit(const Arguments& arguments) {
    Session session(arguments);
    const auto model = made_by<Model>([&](stltsa_model** made) {
        return stltsa_fit_clip(session.clip(), session.options(), made);
    });
    const Json object = json_of(stltsa_model_json, model.get());
    if (const std::string& path = arguments.coords; !path.empty()) {
        const Grid coords = coordinates(model.get());
        session.add_file(path, path.ends_with(".npy") ? npy_bytes(coords) : csv_text(coords));
    }
    if (!arguments.plot.empty())
        session.add_file(arguments.plot,
                         fit_figure(session, object, model.get(), coordinates(model.get())));
    session.finish(object, model_report(object, session.title(), session.colors()));
    return object["components"].size() > 1 ? Exit::untrustworthy : Exit::done;
}

} // namespace tool
