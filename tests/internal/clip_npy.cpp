// SPDX-License-Identifier: BSD-3-Clause
#include "clip_testing.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>

namespace {

using namespace clip_testing;

std::string header(std::string_view dict, int version = 1) {
    std::string bytes = "\x93NUMPY";
    bytes += {static_cast<char>(version), '\0'};
    const std::size_t length = version == 1 ? 2 : 4;
    for (std::size_t i = 0; i < length; ++i)
        bytes += static_cast<char>(dict.size() >> (8 * i) & 0xFF);
    return bytes.append(dict);
}

std::string dict(std::string_view descr, std::string_view order, std::string_view shape) {
    return stltsa::format_text("{{'descr': '{}', 'fortran_order': {}, 'shape': {}, }}          \n",
                               descr, order, shape);
}

template <class Float>
void append(std::string& bytes, double value, bool big) {
    auto raw = std::bit_cast<std::array<char, sizeof(Float)>>(static_cast<Float>(value));
    if (big != (std::endian::native == std::endian::big))
        std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

std::string numbers(std::string_view descr, const std::vector<double>& values) {
    std::string bytes;
    for (const double value : values)
        if (descr[2] == '4')
            append<float>(bytes, value, descr[0] == '>');
        else
            append<double>(bytes, value, descr[0] == '>');
    return bytes;
}

Clip npy(std::string_view bytes) {
    return parse(bytes, Format::npy);
}

void check_values(const Clip& clip, std::int64_t rows, const std::vector<double>& expected) {
    assert_int_equal(clip.frames(), rows);
    assert_int_equal(clip.values.rows() * clip.values.cols(), expected.size());
    assert_true(std::equal(expected.begin(), expected.end(), clip.values.data()));
}

const std::vector<double> six{1, -2, 3.5, 4, 5, 6};

void all_types_orders_and_versions(void**) {
    for (const char* descr : {"<f4", "<f8", ">f4", ">f8"})
        for (const int version : {1, 2, 3}) {
            const std::string data = numbers(descr, six);
            check_values(npy(header(dict(descr, "False", "(2, 3)"), version) + data), 2, six);
            check_values(npy(header(dict(descr, "True", "(3, 2)"), version) + data), 3,
                         {1, 4, -2, 5, 3.5, 6});
        }
}

void keeps_every_bit(void**) {
    const std::vector<double> values{0.1, 1e-310, 1.7976931348623157e308, -0.0};
    check_values(npy(header(dict("<f8", "False", "(2, 2)")) + numbers("<f8", values)), 2, values);
}

void one_dimension_is_one_column(void**) {
    for (const char* order : {"True", "False"})
        check_values(npy(header(dict("<f8", order, "(6,)")) + numbers("<f8", six)), 6, six);
}

/// Of a header that ends on a multiple of 64 bytes, as numpy.save() writes it.
std::string aligned_npy(std::string_view descr, std::string_view order) {
    std::string text = dict(descr, order, "(3, 2)");
    text.resize(128 - 10, ' ');
    return header(text) + numbers(descr, six);
}

Clip owned_npy(const std::shared_ptr<const std::string>& bytes) {
    return stltsa::clip::parse({*bytes, bytes}, Format::npy, "test", {});
}

void numbers_stay_where_they_lie(void**) {
    const std::string own = std::endian::native == std::endian::little ? "<f8" : ">f8";
    const auto bytes = std::make_shared<const std::string>(aligned_npy(own, "False"));
    {
        Clip clip = owned_npy(bytes);
        check_values(clip, 3, six);
        assert_ptr_equal(clip.values.data(), bytes->data() + 128);
        const Clip copy = clip;
        assert_ptr_equal(copy.values.data(), clip.values.data());
        clip.values.edit()(0, 0) = 7; // not in the file
        check_values(copy, 3, six);
    }
    assert_int_equal(bytes.use_count(), 1);
    assert_ptr_not_equal(npy(*bytes).values.data(), bytes->data() + 128); // whose are they?
}

void numbers_that_are_not_ours_are_converted(void**) {
    const std::string own = std::endian::native == std::endian::little ? "<f8" : ">f8";
    const std::string other = own == "<f8" ? ">f8" : "<f8";
    std::string shifted = header(dict(own, "False", "(3, 2)") + " ") + numbers(own, six);
    while ((reinterpret_cast<std::uintptr_t>(shifted.data()) + shifted.size()) % 8 == 0)
        shifted = header(dict(own, "False", "(3, 2)") + "  ") + numbers(own, six);
    for (const std::string& text :
         {aligned_npy("<f4", "False"), aligned_npy(other, "False"), shifted}) {
        const auto bytes = std::make_shared<const std::string>(text);
        check_values(owned_npy(bytes), 3, six);
        const Clip clip = owned_npy(bytes);
        assert_int_equal(bytes.use_count(), 1);
    }
    const auto fortran = std::make_shared<const std::string>(aligned_npy(own, "True"));
    check_values(owned_npy(fortran), 3, {1, 4, -2, 5, 3.5, 6});
}

/// Where the system tells; elsewhere `otherwise`.
bool is_mapped(const std::string& path, bool otherwise) {
    std::ifstream maps("/proc/self/maps");
    if (!maps)
        return otherwise;
    const std::string text{std::istreambuf_iterator<char>(maps), {}};
    return text.find(path) != text.npos;
}

void a_mapped_file(void**) {
    const TemporaryFolder folder;
    const std::string bytes = aligned_npy("<f8", "False");
    const std::string path = folder.write("x.npy", bytes);
    stltsa::clip::ReadOptions options;
    {
        const Clip clip = stltsa::clip::read(path, options);
        assert_false(is_mapped(path, false));
    }
    options.memory_map = true;
    {
        const Clip clip = stltsa::clip::read(path, options);
        assert_true(is_mapped(path, true));
    }
    assert_false(is_mapped(path, false));
    assert_true(stltsa::clip::read(path, options).notes.empty());
    const std::string narrow = folder.write("narrow.npy", aligned_npy("<f4", "False"));
    assert_int_equal(stltsa::clip::read(narrow, options).notes.size(), 1);
    assert_true(stltsa::clip::read(narrow, {}).notes.empty());
    const Clip clip = stltsa::clip::read(path, options);
    assert_true(stltsa::clip::map_file(path, {}).bytes == bytes);
    std::filesystem::remove(path);
    check_values(clip, 3, six); // while the clip has it, it is there
    ASSERT_FAILS(Status::io, "No such file", stltsa::clip::read(path, options));
    ASSERT_FAILS(Status::io, "Is a directory", stltsa::clip::read(folder.path(""), options));
    ASSERT_FAILS(Status::format, "begins with",
                 stltsa::clip::read(folder.write("empty.npy", ""), options));
    assert_int_equal(stltsa::clip::read(folder.write("x.csv", "1,2\n3,4\n"), options).frames(), 2);
}

void headers_however_written(void**) {
    const std::string data = numbers("<f8", six);
    for (const char* text :
         {"{\"shape\":(2,3),\"descr\":\"<f8\",\"fortran_order\":False}",
          "{ 'fortran_order' : False , 'shape' : ( 2 , 3 , ) , 'descr' : '<f8' , }\n"})
        check_values(npy(header(text) + data), 2, six);
}

void refuses(const std::string& bytes, Status status, std::string_view part, int line) {
    check_fails(
        status, part, [&] { npy(bytes); }, __FILE__, line);
}
#define REFUSES(bytes, status, part) refuses(bytes, Status::status, part, __LINE__)

void types_that_are_not_numbers(void**) {
    const std::string data = numbers("<f8", six);
    for (const char* descr : {"<i8", "|O", "<f2", "<c16", "|b1", "<f16", "<U3", "f8", ""})
        REFUSES(header(dict(descr, "False", "(2, 3)")) + data, unsupported,
                "only float32 and float64 are read");
    REFUSES(header("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (6,)}") + data,
            unsupported, "a structured array");
}

void sizes_that_do_not_fit(void**) {
    const std::string data = numbers("<f8", six);
    REFUSES(header(dict("<f8", "False", "(3, 3)")) + data, format,
            "3 frames of 3 numbers, the data end after 2");
    REFUSES(header(dict("<f8", "False", "(2, 2)")) + data, format, "more bytes follow");
    REFUSES(header(dict("<f8", "False", "(2, 3)")) + data + "x", format, "more bytes follow");
    REFUSES(header(dict("<f8", "False", "()")) + data, shape, "a single number");
    REFUSES(header(dict("<f8", "False", "(3, 2, 1)")) + data, shape,
            "an array of 3 dimensions; frames are rows: save array.reshape");
    REFUSES(header(dict("<f8", "False", "(0, 3)")), shape, "the array is empty");
    REFUSES(header(dict("<f8", "False", "(3, 0)")), shape, "the array is empty");
    REFUSES(header(dict("<f8", "False", "(1000000000000, 3)")) + data, format,
            "the data end after");
    REFUSES(header(dict("<f8", "False", "(2, 4611686018427387904)")) + data, format, "end after");
    REFUSES(header(dict("<f8", "False", "(9223372036854775807, 2)")) + data, format, "end after");
    REFUSES(header(dict("<f8", "False", "(99999999999999999999,)")) + data, format, "not a dict");
    REFUSES(header(dict("<f8", "False", "(-2, 3)")) + data, format, "not a dict");
}

void broken_headers(void**) {
    REFUSES("\x93NUMPX\x01", format, "begins with");
    REFUSES("", format, "begins with");
    REFUSES("\x93NUMPY\x09", unsupported, "NPY version 9");
    REFUSES("\x93NUMPY", unsupported, "NPY version 0");
    REFUSES(header(dict("<f8", "False", "(2, 3)")).substr(0, 40), format,
            "ends inside the NPY header");
    for (const char* text :
         {"", "{", "{}", "nonsense", "{'descr': '<f8'}",
          "{'descr': '<f8', 'fortran_order': 1, 'shape': (2,)}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2,", "{'descr: '<f8'",
          "{'descr': '<f8', 'fortran_order': False, 'shape': 2}", "{'x': '<f8'}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)} more"})
        REFUSES(header(text) + numbers("<f8", six), format, "not a dict");
}

void not_finite(void**) {
    std::vector<double> values = six;
    values[4] = std::numeric_limits<double>::quiet_NaN();
    REFUSES(header(dict("<f8", "False", "(2, 3)")) + numbers("<f8", values), not_finite,
            "test: frame 1, column 2 is nan");
    values[4] = std::numeric_limits<double>::infinity();
    REFUSES(header(dict(">f4", "True", "(3, 2)")) + numbers(">f4", values), not_finite,
            "test: frame 1, column 2 is inf");
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(all_types_orders_and_versions),
        cmocka_unit_test(keeps_every_bit),
        cmocka_unit_test(one_dimension_is_one_column),
        cmocka_unit_test(numbers_stay_where_they_lie),
        cmocka_unit_test(numbers_that_are_not_ours_are_converted),
        cmocka_unit_test(a_mapped_file),
        cmocka_unit_test(headers_however_written),
        cmocka_unit_test(types_that_are_not_numbers),
        cmocka_unit_test(sizes_that_do_not_fit),
        cmocka_unit_test(broken_headers),
        cmocka_unit_test(not_finite),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
