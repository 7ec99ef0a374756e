// SPDX-License-Identifier: BSD-3-Clause
// Values to bytes and back: little-endian, with fixed widths, in the order in which they are named,
// so that one function serves reading and writing.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/sink.hpp"
#include "linalg/matrix.hpp"

namespace stltsa::results {

/// Values of fixed width: numbers, truth values and enumerations.
template <class T>
concept Scalar = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Unsigned bits that hold a scalar in the file: enumerations by their type, truth values as 0
/// or 1.
template <Scalar T>
using BitsOf = std::conditional_t<sizeof(T) == 1, std::uint8_t,
                                  std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>;

/// Passes its bytes to the sink in pieces; finish() passes the last.
class ArchiveWriter {
  public:
    explicit ArchiveWriter(Sink sink) : sink_(std::move(sink)) {}

    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }
    /// For elements that are not scalars; `each(archive, element)` names their parts.
    template <class T, class Each>
    void list(const std::vector<T>& values, const Each& each) {
        put_size(values.size());
        for (const T& value : values)
            each(*this, value);
    }

    void finish() {
        sink_(piece_);
        piece_.clear();
    }

  private:
    template <Scalar T>
    void put(T value) {
        const auto bits = std::bit_cast<BitsOf<T>>(value);
        char bytes[sizeof bits];
        for (std::size_t byte = 0; byte < sizeof bits; ++byte)
            bytes[byte] = static_cast<char>((bits >> (8 * byte)) & 0xff);
        append({bytes, sizeof bytes});
    }
    void put_size(std::size_t size) { put(static_cast<std::uint64_t>(size)); }
    void put(const std::string& text) {
        put_size(text.size());
        append(text);
    }
    template <class T, class Allocator>
    void put(const std::vector<T, Allocator>& values) {
        put_size(values.size());
        for (const auto& value : values)
            put(value);
    }
    template <class T, std::size_t count>
    void put(const std::array<T, count>& values) {
        for (const T& value : values)
            put(value);
    }
    void put(ConstMatrixView packed) {
        put(packed.rows);
        put(packed.cols);
        for (std::int64_t i = 0; i < packed.rows * packed.cols; ++i)
            put(packed.data[i]);
    }
    void put(const Matrix& matrix) { put(matrix.view()); }

    void append(std::string_view bytes) {
        constexpr std::size_t enough = 1 << 16;
        piece_ += bytes;
        if (piece_.size() >= enough)
            finish();
    }

    Sink sink_;
    std::string piece_;
};

/// Throws Status::format if the bytes end too early or are not valid for the value. Never allocates
/// more than the remaining bytes could fill.
class ArchiveReader {
  public:
    explicit ArchiveReader(std::string_view bytes) : rest_(bytes) {}

    template <class... Values>
    void operator()(Values&... values) {
        (get(values), ...);
    }
    template <class T, class Each>
    void list(std::vector<T>& values, const Each& each) {
        values.clear();
        for (std::size_t count = get_count(); count > 0; --count) {
            T value;
            each(*this, value);
            values.push_back(std::move(value));
        }
    }

    std::size_t bytes_left() const { return rest_.size(); }

  private:
    [[noreturn]] static void damaged() {
        fail(Status::format, "the model is damaged: its parts do not fit each other");
    }
    std::string_view take(std::size_t count) {
        if (count > rest_.size())
            damaged();
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    template <Scalar T>
    void get(T& value) {
        BitsOf<T> bits = 0;
        const std::string_view taken = take(sizeof bits);
        for (std::size_t byte = 0; byte < sizeof bits; ++byte)
            bits = static_cast<BitsOf<T>>(
                bits | (BitsOf<T>{static_cast<unsigned char>(taken[byte])} << (8 * byte)));
        if constexpr (std::same_as<T, bool>) {
            if (bits > 1)
                damaged();
            value = bits == 1;
        } else {
            value = std::bit_cast<T>(bits);
        }
    }
    /// A number of elements, each of at least one byte.
    std::size_t get_count() {
        std::uint64_t count = 0;
        get(count);
        if (count > rest_.size())
            damaged();
        return static_cast<std::size_t>(count);
    }
    void get(std::string& text) { text = take(get_count()); }
    template <class T, class Allocator>
    void get(std::vector<T, Allocator>& values) {
        values.clear();
        for (std::size_t count = get_count(); count > 0; --count)
            get(values.emplace_back());
    }
    template <class T, std::size_t count>
    void get(std::array<T, count>& values) {
        for (T& value : values)
            get(value);
    }
    void get(Matrix& matrix) {
        std::int64_t rows = 0;
        std::int64_t cols = 0;
        get(rows);
        get(cols);
        const auto most = static_cast<std::int64_t>(rest_.size() / sizeof(double));
        if (rows < 0 || cols < 0 || (cols > 0 && rows > most / cols))
            damaged();
        matrix = Matrix::unset(rows, cols);
        for (std::int64_t i = 0; i < rows * cols; ++i)
            get(matrix.data()[i]);
    }

    std::string_view rest_;
};

} // namespace stltsa::results
