// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "arguments/pieces.hpp"
#include "reports/report.hpp"
#include "reports/table.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

/// A piece as typed, without the folder of its clip.
std::string piece_name(const std::string& piece) {
    return piece.substr(piece.find_last_of('/') + 1);
}

/// Names may be long: they are listed once, and the table has their numbers.
class PieceNumbers {
  public:
    /// `pieces`: as typed; a label gives several pieces.
    explicit PieceNumbers(const std::vector<std::string>& pieces) {
        std::string before;
        for (const std::string& piece : pieces) {
            auto found = std::ranges::find(typed_, piece);
            if (found == typed_.end()) {
                list_ += fmt::format("  {}  {}\n", typed_.size() + 1, after(piece, before));
                found = typed_.insert(found, piece);
            }
            numbers_.push_back(std::to_string(found - typed_.begin() + 1));
        }
    }

    const std::string& operator[](std::int64_t piece) const {
        return numbers_[static_cast<std::size_t>(piece)];
    }
    std::string list() const { return "\n  piece\n" + list_; }

  private:
    /// ":best*8" if the piece before it in the list is of the same clip.
    static std::string after(const std::string& piece, std::string& before) {
        const std::string path = parse_piece(piece).path;
        const bool same = path == std::exchange(before, path);
        return same ? piece.substr(path.size()) : piece_name(piece);
    }

    std::vector<std::string> typed_, numbers_;
    std::string list_;
};

std::string seams_table(const std::vector<stltsa::Seam>& seams,
                        const std::vector<std::string>& pieces) {
    using enum Align;
    if (seams.empty())
        return "";
    const PieceNumbers numbers(pieces);
    Table table({right, right, right, right, right, right, right, right, right, right}, 2);
    table.add({"seam", "", "from", "to", "cut", "goes on", "blend", "", "", ""});
    table.add(
        {"frame", "seconds", "piece", "piece", "before", "at", "(s)", "posture", "step", "accel."});
    const auto seconds = [](double value) { return fmt::format("{:.3f}", value); };
    const auto ratio = [](double value) { return fmt::format("{:.2f}", value); };
    for (const stltsa::Seam& seam : seams)
        table.add({seam.wrap != 0 ? "wrap" : std::to_string(seam.frame), seconds(seam.time_s),
                   numbers[seam.piece], numbers[seam.next], std::to_string(seam.cut_end),
                   std::to_string(seam.cut_begin), seconds(seam.crossfade_s), ratio(seam.posture),
                   ratio(seam.step), ratio(seam.acceleration)});
    constexpr std::size_t place = 2; // cells that say where the seam is
    table.fold(place);
    return numbers.list() + '\n' + table.text() +
           "  posture, step, acceleration: 1 is typical of the pieces\n";
}

/// What share of the source a loop is, and how far it goes.
std::string loop_text(const stltsa::Info& info) {
    if (info.integer(STLTSA_INFO_LOOP) == 0)
        return "";
    const auto travel = info.reals(STLTSA_INFO_TRAVEL);
    const double share = 100 * info.real(STLTSA_INFO_COVERAGE);
    const std::string source =
        info.count(STLTSA_INFO_LOOP_CYCLES) > 0
            ? fmt::format("{} of {} ({:.0f} %)", info.integer(STLTSA_INFO_LOOP_CYCLES),
                          counted(info.integer(STLTSA_INFO_SOURCE_CYCLES), "cycle"), share)
            : fmt::format("{:.0f} % of the pieces' frames", share);
    return fmt::format("\nloop: {}; travel {:.2f} ({:.2f} {:.2f} {:.2f}), turn {:.1f} degrees{}\n",
                       source, std::hypot(travel[0], travel[1], travel[2]), travel[0], travel[1],
                       travel[2],
                       std::round(10 * info.real(STLTSA_INFO_TURN)) / 10 + 0.0, // no -0
                       info.integer(STLTSA_INFO_IN_PLACE) != 0 ? ", both removed" : "");
}

/// "528 frames, 4.40 s, from 1 piece with 3 seams"
std::string synthesis_summary(const stltsa::Synthesis& synthesis) {
    const stltsa::Clip& clip = synthesis.clip();
    return fmt::format("{}, {:.2f} s, from {} with {}", counted(clip.frames(), "frame"),
                       static_cast<double>(clip.frames()) / clip.fps(),
                       counted(synthesis.info().count(STLTSA_INFO_PIECE), "piece"),
                       counted(synthesis.info().count(STLTSA_INFO_SEAM), "seam"));
}

} // namespace

std::string synthesis_report(const stltsa::Synthesis& synthesis,
                             const std::vector<std::string>& pieces) {
    return bold(synthesis_summary(synthesis)) + '\n' + seams_table(synthesis.seams(), pieces) +
           loop_text(synthesis.info()) + listed("note:", synthesis.info().texts(STLTSA_INFO_NOTE)) +
           listed("warning:", texts_of(synthesis.warnings()));
}

} // namespace tool
