// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstring>

#include "capi/boundary/guard.hpp"
#include "capi/boundary/structs.hpp"
#include "capi/handles.hpp"
#include "capi/json/results.hpp"
#include "capi/options/reader.hpp"

using namespace stltsa;
using capi::compute;
using capi::guard;
using capi::required;

namespace {

synthesis::Piece piece_of(const stltsa_piece& piece, int64_t index) {
    if (piece.clip == nullptr)
        fail(Status::argument, "pieces[{}].clip is NULL", index);
    if (piece.reserved != 0)
        fail(Status::argument, "pieces[{}].reserved is {}; set it to 0", index, piece.reserved);
    return {&piece.clip->clip, piece.begin, piece.end, piece.repeat};
}

std::vector<synthesis::Piece> pieces_of(const stltsa_piece* pieces, int64_t count) {
    if (count < 1)
        fail(Status::argument, "count is {}: at least one piece is needed", count);
    const stltsa_piece* first = &required(pieces, "pieces");
    std::vector<synthesis::Piece> result;
    for (int64_t i = 0; i < count; ++i)
        result.push_back(piece_of(first[i], i));
    return result;
}

} // namespace

stltsa_status stltsa_synthesize(const stltsa_piece* pieces, int64_t count,
                                const stltsa_options* options,
                                stltsa_synthesis** synthesis) noexcept {
    return compute(options, [&] {
        required(synthesis, "synthesis") = nullptr;
        const capi::OptionsReader reader(options);
        *synthesis = new stltsa_synthesis(
            results::synthesize(pieces_of(pieces, count), reader.synthesis_options()));
    });
}

stltsa_status stltsa_synthesize_loop(const stltsa_clip* clip,
                                     const stltsa_decomposition* decomposition,
                                     const stltsa_options* options,
                                     stltsa_synthesis** synthesis) noexcept {
    return compute(options, [&] {
        required(synthesis, "synthesis") = nullptr;
        const capi::OptionsReader reader(options);
        *synthesis = new stltsa_synthesis(results::synthesize_loop(
            required(clip, "clip").clip, required(decomposition, "decomposition"),
            reader.synthesis_options()));
    });
}

void stltsa_synthesis_free(stltsa_synthesis* synthesis) noexcept {
    delete synthesis;
}

const stltsa_clip* stltsa_synthesis_clip(const stltsa_synthesis* synthesis) noexcept {
    return synthesis == nullptr ? nullptr : &synthesis->clip;
}
