// SPDX-License-Identifier: BSD-3-Clause
#include "capi/info/info.hpp"

#include <algorithm>
#include <cstring>

#include "base/warning.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/boundary/structs.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

namespace {

constexpr bool same(WarningCode code, int value) {
    return static_cast<int>(code) == value;
}
static_assert(same(WarningCode::follows_time, STLTSA_WARNING_FOLLOWS_TIME) &&
              same(WarningCode::rank_deficient, STLTSA_WARNING_RANK_DEFICIENT) &&
              same(WarningCode::small_gap, STLTSA_WARNING_SMALL_GAP) &&
              same(WarningCode::unscaled, STLTSA_WARNING_UNSCALED) &&
              same(WarningCode::inaccurate, STLTSA_WARNING_INACCURATE) &&
              same(WarningCode::disconnected, STLTSA_WARNING_DISCONNECTED) &&
              same(WarningCode::jump, STLTSA_WARNING_JUMP) &&
              same(WarningCode::separate_motion, STLTSA_WARNING_SEPARATE_MOTION) &&
              same(WarningCode::offsets_differ, STLTSA_WARNING_OFFSETS_DIFFER) &&
              same(WarningCode::resampled, STLTSA_WARNING_RESAMPLED) &&
              same(WarningCode::seam_posture, STLTSA_WARNING_SEAM_POSTURE) &&
              same(WarningCode::seam_speed, STLTSA_WARNING_SEAM_SPEED) &&
              same(WarningCode::seam_acceleration, STLTSA_WARNING_SEAM_ACCELERATION) &&
              same(WarningCode::not_blended, STLTSA_WARNING_NOT_BLENDED) &&
              same(WarningCode::no_order, STLTSA_WARNING_NO_ORDER) &&
              same(WarningCode::linear_phase, STLTSA_WARNING_LINEAR_PHASE) &&
              same(WarningCode::several_places, STLTSA_WARNING_SEVERAL_PLACES) &&
              same(WarningCode::not_found, STLTSA_WARNING_NOT_FOUND) &&
              same(WarningCode::few_cycles, STLTSA_WARNING_FEW_CYCLES) &&
              same(WarningCode::not_alike, STLTSA_WARNING_NOT_ALIKE) &&
              same(WarningCode::uncertain_shift, STLTSA_WARNING_UNCERTAIN_SHIFT) &&
              same(WarningCode::sizes_differ, STLTSA_WARNING_SIZES_DIFFER));

const capi::InfoRow* row_of(const capi::InfoTable& table, int32_t key) {
    for (const auto rows : {table.own, table.source, table.fit, table.warnings})
        for (const capi::InfoRow& row : rows)
            if (row.key == key)
                return &row;
    return nullptr;
}

const char* name_of(int32_t key) {
    for (const stltsa_info_key& row : capi::info_keys())
        if (row.key == key)
            return row.name;
    fail(Status::argument, "there is no info key {}; see stltsa_info_describe", key);
}

/// Throws if the handle lacks the key, or if it is of another kind.
template <class IsKind>
const capi::InfoRow& find(const stltsa_info& info, int32_t key, const char* kind, IsKind is_kind) {
    const char* name = name_of(key);
    const capi::InfoRow* row = row_of(*info.table, key);
    if (row == nullptr)
        fail(Status::argument, "there is no {} here", name);
    if (!is_kind(*row))
        fail(Status::argument, "info {} is not {}", name, kind);
    return *row;
}

const capi::InfoRow& array_row(const stltsa_info* info, int32_t key) {
    return find(required(info, "info"), key, "an array",
                [](const capi::InfoRow& row) { return row.write != nullptr; });
}

capi::Fact value(const stltsa_info& info, int32_t key, int64_t index, const char* type) {
    const char* name = name_of(key);
    const capi::InfoRow* row = row_of(*info.table, key);
    const int64_t count = row == nullptr ? 0 : row->count(info);
    if (index < 0 || index >= count)
        fail(Status::argument, "value {} of info {} does not exist: there are {} here", index, name,
             count);
    if (row->value == nullptr)
        fail(Status::argument, "info {} is not {}", name, type);
    return row->value(info, static_cast<std::size_t>(index));
}

template <class T>
stltsa_status get(const stltsa_info* info, int32_t key, int64_t index, T* value,
                  const char* type) noexcept {
    return guard([&] {
        required(value, "value");
        const capi::Fact found = ::value(required(info, "info"), key, index, type);
        if (!std::holds_alternative<T>(found))
            fail(Status::argument, "info {} is not {}", name_of(key), type);
        *value = std::get<T>(found);
    });
}

} // namespace

int64_t stltsa_info_count(const stltsa_info* info, int32_t key) noexcept {
    const capi::InfoRow* row = info == nullptr ? nullptr : row_of(*info->table, key);
    return row == nullptr ? 0 : row->count(*info);
}

stltsa_status stltsa_info_int(const stltsa_info* info, int32_t key, int64_t index,
                              int64_t* value) noexcept {
    return get(info, key, index, value, "an integer");
}

stltsa_status stltsa_info_real(const stltsa_info* info, int32_t key, int64_t index,
                               double* value) noexcept {
    return get(info, key, index, value, "a real number");
}

stltsa_status stltsa_info_text(const stltsa_info* info, int32_t key, int64_t index,
                               const char** value) noexcept {
    return get(info, key, index, value, "a text");
}

stltsa_status stltsa_info_rows(const stltsa_info* info, int32_t key, int64_t begin, int64_t count,
                               void* rows, size_t row_size) noexcept {
    return guard([&] {
        const capi::InfoRow& list =
            find(required(info, "info"), key, "a list of rows",
                 [](const capi::InfoRow& row) { return row.row != nullptr; });
        const int64_t all = list.count(*info);
        if (begin < 0 || count < 0 || begin > all || count > all - begin)
            fail(Status::argument, "{} rows of {} from {} on do not exist: there are {} here",
                 count, name_of(key), begin, all);
        if (row_size == 0)
            fail(Status::argument, "row_size is 0; it must be the size of the struct");
        if (count > 0)
            required(static_cast<char*>(rows), "rows");
        for (int64_t i = 0; i < count; ++i)
            list.row(*info, static_cast<std::size_t>(begin + i),
                     static_cast<char*>(rows) + static_cast<std::size_t>(i) * row_size, row_size);
    });
}

stltsa_status stltsa_info_array(const stltsa_info* info, int32_t key, int64_t index,
                                const stltsa_out* array) noexcept {
    return capi::compute([&] {
        const capi::InfoRow& found = array_row(info, key);
        if (index < 0 || index >= found.count(*info))
            fail(Status::argument, "array {} of {} does not exist: there are {} here", index,
                 name_of(key), found.count(*info));
        found.write(*info, static_cast<std::size_t>(index), array);
    });
}

stltsa_status stltsa_info_shape(const stltsa_info* info, int32_t key, int64_t* rows,
                                int64_t* cols) noexcept {
    return guard([&] {
        const capi::InfoRow& found = array_row(info, key);
        if (found.count(*info) == 0)
            fail(Status::argument, "there is no {} here", name_of(key));
        required(rows, "rows");
        required(cols, "cols");
        const capi::Shape shape = found.shape(*info);
        *rows = shape.rows;
        *cols = shape.cols;
    });
}

stltsa_status stltsa_info_json(const stltsa_info* info, char** json) noexcept {
    return guard([&] {
        required(json, "json") = nullptr;
        const std::string text = required(info, "info").table->json(*info);
        *json = capi::caller_string(text);
    });
}

stltsa_status stltsa_info_describe(int64_t index, stltsa_info_key* key) noexcept {
    return guard([&] {
        const std::size_t size = required(key, "key").size;
        const auto keys = capi::info_keys();
        if (index < 0 || index >= static_cast<int64_t>(keys.size()))
            fail(Status::argument, "info index {} is not in 0 .. {}", index, keys.size() - 1);
        // A caller built against a shorter struct gets the fields it knows.
        if (size < sizeof(size_t) + 2 * sizeof(int32_t))
            fail(Status::argument, "key->size is {}; set it to sizeof(stltsa_info_key)", size);
        stltsa_info_key row = keys[static_cast<std::size_t>(index)];
        for (const capi::InfoTable* table : capi::info_tables())
            if (const capi::InfoRow* found = row_of(*table, row.key)) {
                row.handles |= table->handle;
                row.is_list = found->is_list ? 1 : 0;
            }
        row.size = size;
        std::memcpy(key, &row, std::min(size, sizeof row));
    });
}
