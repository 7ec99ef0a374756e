// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"
#include "make_figure.hpp"
#include "pieces.hpp"
#include "report.hpp"
#include "session.hpp"

namespace tool {

Exit run_synthesize(const Arguments& arguments) {
    Session session(arguments);
    PieceFinder finder(session);
    std::vector<PieceText> texts;
    for (const std::string& text : arguments.pieces)
        texts.push_back(parse_piece(text));
    std::vector<stltsa_piece> pieces;
    for (const PieceText& text : texts)
        pieces.push_back(finder.find(text));
    const auto made = made_by<Synthesis>([&](stltsa_synthesis** synthesis) {
        return stltsa_synthesize(pieces.data(), static_cast<std::int64_t>(pieces.size()),
                                 session.options(), synthesis);
    });
    session.add_clip(arguments.product, stltsa_synthesis_clip(made.get()));
    const Json object = json_of(stltsa_synthesis_json, made.get());
    if (!arguments.plot.empty())
        session.add_file(arguments.plot,
                         synthesis_figure(object, arguments, stltsa_synthesis_clip(made.get())));
    session.finish(object, synthesis_report(object, arguments.pieces, session.colors()));
    return Exit::done;
}

} // namespace tool
