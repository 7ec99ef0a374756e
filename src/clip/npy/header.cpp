// SPDX-License-Identifier: BSD-3-Clause
#include "clip/npy/header.hpp"

#include <algorithm>
#include <bit>
#include <iterator>

#include "base/error.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

constexpr std::size_t most_dimensions = 32; // NumPy's own limit

/// The Python dict of the header, a literal such as
/// {'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }
class DictReader {
  public:
    DictReader(std::string_view text, const std::string& name) : remaining_(text), name_(name) {}

    NpyHeader read() {
        expect('{');
        while (!take('}')) {
            entry();
            if (!take(',')) {
                expect('}');
                break;
            }
        }
        if (!trim(remaining_).empty() || seen_ != 7)
            malformed();
        return header_;
    }

  private:
    [[noreturn]] void malformed() const {
        fail(Status::format, "{}: the NPY header is not a dict of descr, fortran_order and shape",
             name_);
    }

    bool take(char c) {
        remaining_ = trim(remaining_);
        if (!remaining_.starts_with(c))
            return false;
        remaining_.remove_prefix(1);
        return true;
    }

    void expect(char c) {
        if (!take(c))
            malformed();
    }

    std::string_view string() {
        remaining_ = trim(remaining_);
        const char quote = remaining_.empty() ? '\0' : remaining_[0];
        if (quote != '\'' && quote != '"')
            malformed();
        const std::size_t end = remaining_.find(quote, 1);
        if (end == remaining_.npos)
            malformed();
        const std::string_view text = remaining_.substr(1, end - 1);
        remaining_.remove_prefix(end + 1);
        return text;
    }

    void entry() {
        const std::string_view key = string();
        expect(':');
        if (key == "descr")
            dtype();
        else if (key == "fortran_order")
            order();
        else if (key == "shape")
            shape();
        else
            malformed();
    }

    void dtype() {
        seen_ |= 1;
        if (take('['))
            unsupported("a structured array");
        const std::string_view descr = string();
        constexpr std::string_view types[] = {"f4", "f8", "i1", "i2", "i4",
                                              "i8", "u1", "u2", "u4", "u8"};
        const bool known =
            descr.size() == 3 && std::string_view("<>=|").find(descr[0]) != descr.npos;
        if (!known || std::ranges::find(types, descr.substr(1)) == std::end(types))
            unsupported(format_text("an array of dtype {}", in_quotes(descr)));
        header_.big_endian =
            descr[0] == '>' || (descr[0] == '=' && std::endian::native == std::endian::big);
        header_.kind = descr[1];
        header_.item_size = static_cast<std::size_t>(descr[2] - '0');
    }

    [[noreturn]] void unsupported(const std::string& what) const {
        fail(Status::unsupported,
             "{}: {}; only integers, float32 and float64 are read: save array.astype('float64')",
             name_, what);
    }

    void order() {
        seen_ |= 2;
        remaining_ = trim(remaining_);
        header_.fortran_order = remaining_.starts_with("True");
        if (!header_.fortran_order && !remaining_.starts_with("False"))
            malformed();
        remaining_.remove_prefix(header_.fortran_order ? 4 : 5);
    }

    void shape() {
        seen_ |= 4;
        header_.shape.clear();
        expect('(');
        while (!take(')')) {
            const std::size_t end = remaining_.find_first_of(",)");
            if (end == remaining_.npos)
                malformed();
            const auto size = parse_integer(trim(remaining_.substr(0, end)));
            if (!size || *size < 0 || header_.shape.size() == most_dimensions)
                malformed();
            header_.shape.push_back(*size);
            remaining_.remove_prefix(end);
            take(',');
        }
    }

    std::string_view remaining_;
    const std::string& name_;
    NpyHeader header_;
    int seen_ = 0;
};

std::size_t little_endian(std::string_view bytes) {
    std::size_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

} // namespace

NpyHeader read_npy_header(std::string_view bytes, const std::string& name) {
    constexpr std::string_view magic = "\x93NUMPY";
    if (!bytes.starts_with(magic))
        fail(Status::format, "{}: an NPY file must begin with \\x93NUMPY", name);
    const int version =
        bytes.size() > magic.size() ? static_cast<unsigned char>(bytes[magic.size()]) : 0;
    if (version < 1 || version > 3)
        fail(Status::unsupported, "{}: unknown NPY version {}; versions 1 to 3 are supported", name,
             version);
    const std::size_t size_begin = magic.size() + 2;
    const std::size_t size_bytes = version == 1 ? 2 : 4;
    const std::size_t begin = size_begin + size_bytes;
    const std::size_t size =
        bytes.size() < begin ? 0 : little_endian(bytes.substr(size_begin, size_bytes));
    if (bytes.size() < begin || size > bytes.size() - begin)
        fail(Status::format, "{}: the file ends inside the NPY header", name);
    NpyHeader header = DictReader(bytes.substr(begin, size), name).read();
    header.data_begin = begin + size;
    return header;
}

} // namespace stltsa::clip
