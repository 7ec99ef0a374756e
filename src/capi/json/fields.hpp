// SPDX-License-Identifier: BSD-3-Clause
// Rows as JSON: a list of fields for each, in the order of the keys.
#pragma once

#include <iterator>
#include <string>
#include <vector>

#include "base/json.hpp"

namespace stltsa::capi {

template <class Row>
struct Field {
    const char* name;
    Json (*value)(const Row&);
};

template <class Row, std::size_t Count>
JsonObject row_json(const Field<Row> (&fields)[Count], const Row& row) {
    JsonObject object;
    for (const Field<Row>& field : fields)
        object.set(field.name, field.value(row));
    return object;
}

template <class Rows, class Row, std::size_t Count>
Json rows_json(const Field<Row> (&fields)[Count], const Rows& rows) {
    std::vector<Json> list;
    for (const Row& row : rows)
        list.push_back(row_json(fields, row));
    return list;
}

template <class T>
struct RowOf;
template <class Row, class Value>
struct RowOf<Value Row::*> {
    using type = Row;
};
template <auto member>
using Of = typename RowOf<decltype(member)>::type;

/// The member as it is; null for NaN.
template <auto member>
Json value(const Of<member>& row) {
    return row.*member;
}
/// An index, null for -1; a text, null if it is empty.
template <auto member>
Json known(const Of<member>& row) {
    using Value = std::remove_cvref_t<decltype(row.*member)>;
    if constexpr (std::is_same_v<Value, const char*>)
        return *(row.*member) == '\0' ? Json(nullptr) : Json(row.*member);
    else
        return row.*member < 0 ? Json(nullptr) : Json(row.*member);
}
template <auto member>
Json flag(const Of<member>& row) {
    return row.*member != 0;
}
/// A list that ends with a null pointer.
template <auto member>
Json texts(const Of<member>& row) {
    std::vector<Json> list;
    for (const char* const* text = row.*member; *text != nullptr; ++text)
        list.push_back(*text);
    return list;
}

} // namespace stltsa::capi
