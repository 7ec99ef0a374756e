// SPDX-License-Identifier: BSD-3-Clause
// Builds JSON text, and finds parts of it. nlohmann's library is not used because its destructors
// allocate memory, so it ends the process if there is none.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stltsa {

/// One value as text.
class Json {
  public:
    Json(std::nullptr_t) : text_("null") {}
    template <std::same_as<bool> Bool> // no pointer is a truth value
    Json(Bool value) : text_(value ? "true" : "false") {}
    Json(int value) : Json(static_cast<std::int64_t>(value)) {}
    Json(std::int64_t value);
    /// The shortest digits that read back to the same bits; null for NaN and infinities.
    Json(double value);
    /// Bytes that are not UTF-8 are replaced: a path in another encoding must not make a call fail.
    Json(std::string_view text);
    Json(const std::string& text) : Json(std::string_view(text)) {}
    Json(const char* text) : Json(std::string_view(text)) {}
    template <class T>
    Json(const std::vector<T>& values) : text_("[") {
        for (const T& value : values)
            append(Json(value));
        text_ += ']';
    }

    const std::string& text() const { return text_; }

  private:
    void append(const Json& element) {
        if (text_.size() > 1)
            text_ += ',';
        text_ += element.text_;
    }
    friend class JsonObject;
    std::string text_;
};

/// Keys and values in the order in which they were set.
class JsonObject {
  public:
    template <class... Pairs>
    explicit JsonObject(const Pairs&... pairs) {
        set(pairs...);
    }

    void set() {}
    template <class... Rest>
    void set(const char* key, const Json& value, const Rest&... rest) {
        if (!members_.empty())
            members_ += ',';
        members_ += Json(key).text();
        members_ += ':';
        members_ += value.text();
        set(rest...);
    }

    operator Json() const {
        Json whole(nullptr);
        whole.text_ = text();
        return whole;
    }
    std::string text() const { return '{' + members_ + '}'; }

  private:
    std::string members_;
};

/// The elements of an array, or the members of an object, as they are written. Of a text that is
/// no JSON, any parts of it.
std::vector<std::string_view> json_parts(std::string_view text);
/// The value of a member of an object, as it is written; "" if there is none.
std::string_view json_member(std::string_view object, std::string_view name);
/// The text of a string that Json wrote; "" for another value.
std::string json_string(std::string_view value);

} // namespace stltsa
