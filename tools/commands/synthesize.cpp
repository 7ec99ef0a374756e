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
    std::vector<std::string> names;
    for (std::size_t i = 0; i < texts.size(); ++i)
        for (const stltsa::Piece& piece : finder.find(texts[i])) {
            pieces.push_back(piece);
            names.push_back(arguments.pieces[i]);
        }
    const stltsa::Synthesis made = stltsa::synthesize(pieces, session.options());
    session.add_clip(arguments.product, made.clip());
    if (!arguments.plot.empty())
        session.add_file(arguments.plot, synthesis_figure(arguments.product, names, made));
    session.finish({[&] { return made.json(); }, [&] { return synthesis_report(made, names); },
                    made.warnings()});
    return Exit::done;
}

} // namespace tool
