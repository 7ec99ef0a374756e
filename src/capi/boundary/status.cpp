// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "base/progress.hpp"
#include "capi/boundary/guard.hpp"
#include "linalg/blas_threads.hpp"

namespace stltsa::capi {
namespace {

constexpr bool same(Status status, int value) {
    return static_cast<int>(status) == value;
}
static_assert(same(Status::argument, STLTSA_E_ARGUMENT) && same(Status::shape, STLTSA_E_SHAPE) &&
              same(Status::not_finite, STLTSA_E_NOT_FINITE) &&
              same(Status::too_few_frames, STLTSA_E_TOO_FEW_FRAMES) &&
              same(Status::no_memory, STLTSA_E_NO_MEMORY) && same(Status::io, STLTSA_E_IO) &&
              same(Status::format, STLTSA_E_FORMAT) &&
              same(Status::disconnected, STLTSA_E_DISCONNECTED) &&
              same(Status::degenerate, STLTSA_E_DEGENERATE) &&
              same(Status::not_converged, STLTSA_E_NOT_CONVERGED) &&
              same(Status::cancelled, STLTSA_E_CANCELLED) &&
              same(Status::unsupported, STLTSA_E_UNSUPPORTED) &&
              same(Status::internal, STLTSA_E_INTERNAL) &&
              same(Status::no_common_posture, STLTSA_E_NO_COMMON_POSTURE) &&
              same(Status::no_such_part, STLTSA_E_NO_SUCH_PART));

constexpr bool same(Stage stage, int value) {
    return static_cast<int>(stage) == value;
}
static_assert(same(Stage::read, STLTSA_STAGE_READ) &&
              same(Stage::features, STLTSA_STAGE_FEATURES) &&
              same(Stage::neighbors, STLTSA_STAGE_NEIGHBORS) &&
              same(Stage::tangents, STLTSA_STAGE_TANGENTS) &&
              same(Stage::alignment, STLTSA_STAGE_ALIGNMENT) &&
              same(Stage::spectrum, STLTSA_STAGE_SPECTRUM) &&
              same(Stage::units, STLTSA_STAGE_UNITS) && same(Stage::map, STLTSA_STAGE_MAP) &&
              same(Stage::denoise, STLTSA_STAGE_DENOISE) &&
              same(Stage::synthesis, STLTSA_STAGE_SYNTHESIS) &&
              same(Stage::write, STLTSA_STAGE_WRITE));

constexpr std::array<const char*, 16> status_names = {"STLTSA_OK",
                                                      "STLTSA_E_ARGUMENT",
                                                      "STLTSA_E_SHAPE",
                                                      "STLTSA_E_NOT_FINITE",
                                                      "STLTSA_E_TOO_FEW_FRAMES",
                                                      "STLTSA_E_NO_MEMORY",
                                                      "STLTSA_E_IO",
                                                      "STLTSA_E_FORMAT",
                                                      "STLTSA_E_DISCONNECTED",
                                                      "STLTSA_E_DEGENERATE",
                                                      "STLTSA_E_NOT_CONVERGED",
                                                      "STLTSA_E_CANCELLED",
                                                      "STLTSA_E_UNSUPPORTED",
                                                      "STLTSA_E_INTERNAL",
                                                      "STLTSA_E_NO_COMMON_POSTURE",
                                                      "STLTSA_E_NO_SUCH_PART"};

constexpr std::string_view report =
    " (this is a defect of libstltsa: please report it, with the data if you may, at " STLTSA_BUGS
    ")";

// Fixed storage, because the error may be that memory ran out. A trivial type, so that threads may
// end in any order.
thread_local std::array<char, 1024> last_error_text{};

} // namespace

stltsa_status remember(Status status, const char* text) noexcept {
    // What is no fault of the caller ends with where to report it.
    const std::string_view end = status == Status::internal ? report : "";
    auto& to = last_error_text;
    std::size_t size = std::min(std::strlen(text), to.size() - 1 - end.size());
    // A text that is too long is cut between two UTF-8 characters.
    if (text[size] != '\0')
        while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80)
            --size;
    std::memcpy(to.data(), text, size);
    std::ranges::copy(end, to.begin() + static_cast<std::ptrdiff_t>(size));
    to[size + end.size()] = '\0';
    return static_cast<stltsa_status>(status);
}

} // namespace stltsa::capi

const char* stltsa_status_name(stltsa_status status) noexcept {
    const auto& names = stltsa::capi::status_names;
    const auto index = -static_cast<std::int64_t>(status);
    if (index < 0 || index >= static_cast<std::int64_t>(names.size()))
        return "STLTSA_E_UNKNOWN";
    return names[static_cast<std::size_t>(index)];
}

const char* stltsa_last_error(void) noexcept {
    return stltsa::capi::last_error_text.data();
}

#define STLTSA_TEXT_OF(x) #x
#define STLTSA_TEXT(x) STLTSA_TEXT_OF(x)
const char* stltsa_version(void) noexcept {
    return STLTSA_TEXT(STLTSA_VERSION_MAJOR) "." STLTSA_TEXT(STLTSA_VERSION_MINOR) "." STLTSA_TEXT(
        STLTSA_VERSION_PATCH);
}

int32_t stltsa_has(int32_t part) noexcept {
#ifdef STLTSA_CHOLMOD
    if (part == STLTSA_HAS_CHOLMOD)
        return 1;
#endif
    return part == STLTSA_HAS_OPENBLAS && stltsa::blas_is_openblas();
}

void stltsa_free(void* memory) noexcept {
    delete[] static_cast<char*>(memory); // all of it is made by new char[]
}
