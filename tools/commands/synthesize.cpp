// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/pieces.hpp"
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/report.hpp"
#include "reports/table.hpp"

namespace tool {
namespace {

/// Of a whole clip, --loop takes the cycles that make the longest loop.
bool asks_for_longest_loop(const Arguments& arguments, const std::vector<PieceText>& texts) {
    const auto loop = arguments.options.find(STLTSA_OPT_LOOP);
    return loop != arguments.options.end() && loop->second == "1" && texts.size() == 1 &&
           texts[0].what.empty() && texts[0].repeat == 1;
}

stltsa::Synthesis longest_loop(const stltsa::Clip& clip, const stltsa::Options& options) {
    return stltsa::synthesize_loop(clip, stltsa::decompose(clip, options), options);
}

} // namespace

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
    const stltsa::Synthesis made = asks_for_longest_loop(arguments, texts)
                                       ? longest_loop(finder.clip(texts[0].path), session.options())
                                       : stltsa::synthesize(pieces, session.options());
    session.add_clip(arguments.product, made.clip());
    session.finish({[&] { return made.json(); }, [&] { return synthesis_report(made, names); },
                    texts_of(made.warnings())});
    return Exit::done;
}

} // namespace tool
