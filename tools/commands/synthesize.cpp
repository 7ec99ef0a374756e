// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/pieces.hpp"
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "plot/from_results.hpp"
#include "reports/report.hpp"

namespace tool {

Exit run_synthesize(const Arguments& arguments) {
    Session session(arguments);
    PieceFinder finder(session);
    std::vector<PieceText> texts;
    for (const std::string& text : arguments.pieces)
        texts.push_back(parse_piece(text));
    std::vector<stltsa::Piece> pieces;
    for (const PieceText& text : texts)
        pieces.push_back(finder.find(text));
    const stltsa::Synthesis made = stltsa::synthesize(pieces, session.options());
    session.add_clip(arguments.product, made.clip());
    if (!arguments.plot.empty())
        session.add_file(arguments.plot, synthesis_figure(arguments, made));
    session.finish({[&] { return made.json(); },
                    [&] { return synthesis_report(made, arguments.pieces); }, made.warnings()});
    return Exit::done;
}

} // namespace tool
