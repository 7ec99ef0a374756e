// SPDX-License-Identifier: BSD-3-Clause
#include "clip/testing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
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

/// frames x points x coordinates, in both orders.
void three_dimensions_are_points(void**) {
    const Clip rows = npy(header(dict("<f8", "False", "(1, 3, 2)")) + numbers("<f8", six));
    check_values(rows, 1, six);
    assert_int_equal(rows.space, 2);
    const Clip columns = npy(header(dict("<f8", "True", "(1, 2, 3)")) + numbers("<f8", six));
    check_values(columns, 1, {1, 3.5, 5, -2, 4, 6});
    assert_int_equal(columns.space, 3);
}

void numbers_at_odd_addresses(void**) {
    const std::string text = header(dict("<f8", "False", "(3, 2)")) + numbers("<f8", six);
    for (std::size_t shift = 0; shift < sizeof(double); ++shift) {
        const std::string shifted = std::string(shift, ' ') + text;
        check_values(npy(std::string_view(shifted).substr(shift)), 3, six);
    }
}

void headers_in_any_notation(void**) {
    const std::string data = numbers("<f8", six);
    for (const char* text :
         {"{\"shape\":(2,3),\"descr\":\"<f8\",\"fortran_order\":False}",
          "{ 'fortran_order' : False , 'shape' : ( 2 , 3 , ) , 'descr' : '<f8' , }\n"})
        check_values(npy(header(text) + data), 2, six);
}

void integers(void**) {
    const std::string shape = "(1, 3)";
    check_values(npy(header(dict("<i2", "False", shape)) + std::string("\x01\0\xfe\xff\0\x01", 6)),
                 1, {1, -2, 256});
    check_values(npy(header(dict(">u2", "False", shape)) + std::string("\0\x01\xff\xfe\x01\0", 6)),
                 1, {1, 65534, 256});
    check_values(npy(header(dict("|i1", "False", shape)) + "\x01\xff\x7f"), 1, {1, -1, 127});
    check_values(npy(header(dict("|u1", "False", shape)) + "\x01\xff\x7f"), 1, {1, 255, 127});
    const std::string eight = std::string("\x05\0\0\0\0\0\0\0", 8);
    check_values(npy(header(dict("<i8", "False", "(1,)")) + eight), 1, {5});
    check_values(npy(header(dict("<i4", "False", "(2,)")) + eight), 2, {5, 0});
}

void refuses(const std::string& bytes, Status status, std::string_view part, int line) {
    check_fails(
        status, part, [&] { npy(bytes); }, __FILE__, line);
}
#define REFUSES(bytes, status, part) refuses(bytes, Status::status, part, __LINE__)

void types_that_are_not_numbers(void**) {
    const std::string data = numbers("<f8", six);
    for (const char* descr : {"<i3", "|O", "<f2", "<c16", "|b1", "<f16", "<U3", "f8", ""})
        REFUSES(header(dict(descr, "False", "(2, 3)")) + data, unsupported,
                "only integers, float32 and float64 are read");
    REFUSES(header("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (6,)}") + data,
            unsupported, "a structured array");
}

void sizes_that_do_not_fit(void**) {
    const std::string data = numbers("<f8", six);
    REFUSES(header(dict("<f8", "False", "(3, 3)")) + data, format,
            "3 frames of 3 numbers, but the data end after 2");
    REFUSES(header(dict("<f8", "False", "(2, 2)")) + data, format, "more bytes than");
    REFUSES(header(dict("<f8", "False", "(2, 3)")) + data + "x", format, "more bytes than");
    REFUSES(header(dict("<f8", "False", "()")) + data, shape, "a single number");
    REFUSES(header(dict("<f8", "False", "(3, 2, 1)")) + data, shape,
            "the array has 3 dimensions; expected frames, frames x columns, or frames x points");
    REFUSES(header(dict("<f8", "False", "(1, 4611686018427387904, 3)")) + data, format, "points");
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
    REFUSES("\x93NUMPX\x01", format, "must begin with");
    REFUSES("", format, "must begin with");
    REFUSES("\x93NUMPY\x09", unsupported, "NPY version 9");
    REFUSES("\x93NUMPY", unsupported, "NPY version 0");
    REFUSES(header(dict("<f8", "False", "(2, 3)")).substr(0, 40), format,
            "ends inside the NPY header");
    for (const char* text :
         {"", "{", "{}", "nonsense", "{'descr': '<f8'}",
          "{'descr': '<f8', 'fortran_order': 1, 'shape': (2,)}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2,", "{'descr: '<f8'",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2",
          "{'descr': '<f8', 'fortran_order': False, 'shape': 2}", "{'x': '<f8'}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)} more"})
        REFUSES(header(text) + numbers("<f8", six), format, "not a dict");
}

/// A sine of which 30 rows are left out, or none.
void rows_that_were_lost(void**) {
    for (const int lost : {0, 30}) {
        std::vector<double> values;
        for (int i = 0; i < 200; ++i)
            values.push_back(std::sin(0.1 * (i < 100 ? i : i + lost)));
        const Clip clip = npy(header(dict("<f8", "False", "(200,)")) + numbers("<f8", values));
        assert_int_equal(clip.notes.size(), lost > 0 ? 1 : 0);
        if (lost > 0)
            assert_non_null(std::strstr(clip.notes[0].c_str(), "the numbers jump at frame 100"));
    }
}

/// Frames of a body of 9 points that swing while it walks across the room, without those of
/// [lost, lost + count).
std::vector<double> crossing(int lost, int count) {
    std::vector<double> values;
    for (int i = 0; i < 400; ++i)
        for (int p = 0; p < 9 && !(i >= lost && i < lost + count); ++p) {
            const double t = 0.01 * i, swing = std::sin(6 * t + p);
            values.insert(values.end(), {1.3 * t + 0.1 * p + 0.2 * swing, 0.1 * p, 0.05 * swing});
        }
    return values;
}

Clip points_of(const std::vector<double>& values) {
    const std::string frames = std::to_string(values.size() / 27);
    return npy(header(dict("<f8", "False", "(" + frames + ", 9, 3)")) + numbers("<f8", values));
}

/// However far the body travels, and while points are missing.
void rows_that_were_lost_on_the_way(void**) {
    assert_true(points_of(crossing(150, 0)).notes.empty());
    for (const int lost : {100, 150, 300}) {
        std::vector<double> values = crossing(lost, 12);
        for (std::size_t i = 0; i + 27 < values.size(); i += 54)
            std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(i), 3, 0); // flickers
        const Clip clip = points_of(values);
        assert_int_equal(clip.notes.size(), 1);
        assert_non_null(
            std::strstr(clip.notes[0].c_str(),
                        stltsa::format_text("the numbers jump at frame {}:", lost).c_str()));
        // As the note asks.
        values.insert(values.begin() + 27 * lost, 27 * 12, std::nan(""));
        assert_true(points_of(values).notes.empty());
    }
}

/// Neither a switch nor the last digit of a slow column jumps.
void steps_that_are_usual(void**) {
    std::vector<double> digits, switched;
    for (int i = 0; i < 600; ++i) {
        digits.push_back(std::round(0.05 * i));
        switched.push_back(i / 97 % 2);
    }
    for (const std::vector<double>& values : {digits, switched})
        assert_true(
            npy(header(dict("<f8", "False", "(600,)")) + numbers("<f8", values)).notes.empty());
}

std::size_t missing_in(const Clip& clip) {
    return static_cast<std::size_t>(std::count_if(
        clip.values.data(), clip.values.data() + clip.values.rows() * clip.values.cols(),
        [](double x) { return std::isnan(x); }));
}

/// Numbers of nines, far from all others.
void codes_for_missing_values(void**) {
    for (const double code :
         {-9999.0, 999.0, 999.9, 9999999.0, -999000.0, -1e6, -9.223372036854775e18,
          static_cast<double>(std::numeric_limits<float>::max())}) {
        std::vector<double> values = crossing(0, 0);
        std::fill_n(values.begin() + 27 * 50 + 6, 3, code); // once
        const Clip clip = points_of(values);
        const bool is_code = code > -1e18;
        assert_int_equal(missing_in(clip), is_code ? 3 : 0);
        if (is_code)
            assert_non_null(
                std::strstr(clip.notes[0].c_str(), "taken as missing, 3 times in 3 columns"));
    }
    std::vector<double> never = crossing(0, 0);
    for (std::size_t i = 0; i < never.size(); i += 27)
        std::fill_n(never.begin() + static_cast<std::ptrdiff_t>(i), 3, -9999);
    assert_int_equal(missing_in(points_of(never)), 400 * 3);
    // A point that is never there; a code inside the range of one axis.
    std::vector<double> values = crossing(0, 0);
    for (std::size_t i = 0; i < values.size(); i += 27) {
        values[i + 3] += 20000 - 100 * static_cast<double>(i / 27);
        std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(i), 3, -9999);
        if (i / 27 % 4 == 0)
            std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(i + 3), 3, -9999);
    }
    const Clip clip = points_of(values);
    assert_int_equal(missing_in(clip), 400 * 3 + 100 * 2);
    assert_true(stltsa::clip::is_missing(clip.values.row(0) + 3, 3));
    assert_true(!stltsa::clip::is_missing(clip.values.row(1) + 3, 3));
}

/// Twice; not far outside; not of nines; beside equal numbers.
void numbers_that_are_no_codes(void**) {
    const auto column = [](double number, int times, double range) {
        std::vector<double> values;
        for (int i = 0; i < 100; ++i)
            values.push_back(i % 10 == 0 && i < 10 * times ? number
                                                           : std::round(range * std::sin(i)));
        return npy(header(dict("<f8", "False", "(100,)")) + numbers("<f8", values));
    };
    assert_int_equal(missing_in(column(9999, 3, 2000)), 3);
    assert_int_equal(missing_in(column(9999, 2, 2000)), 0);
    assert_int_equal(missing_in(column(9999, 3, 4000)), 0);
    assert_int_equal(missing_in(column(9998, 3, 2000)), 0);
    assert_int_equal(missing_in(column(100000, 3, 2000)), 0);
    assert_int_equal(missing_in(column(9999.9999, 3, 2000)), 0);
    assert_int_equal(missing_in(column(9999, 3, 0)), 0);
    assert_int_equal(missing_in(column(99, 3, 2)), 0);
    const std::vector<double> constant(100, 9999);
    assert_int_equal(
        missing_in(npy(header(dict("<f8", "False", "(100,)")) + numbers("<f8", constant))), 0);
}

void not_finite(void**) {
    std::vector<double> values = six;
    values[4] = std::numeric_limits<double>::quiet_NaN(); // a gap
    assert_true(std::isnan(
        npy(header(dict("<f8", "False", "(2, 3)")) + numbers("<f8", values)).values(1, 1)));
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
        cmocka_unit_test(numbers_at_odd_addresses),
        cmocka_unit_test(headers_in_any_notation),
        cmocka_unit_test(integers),
        cmocka_unit_test(types_that_are_not_numbers),
        cmocka_unit_test(sizes_that_do_not_fit),
        cmocka_unit_test(broken_headers),
        cmocka_unit_test(three_dimensions_are_points),
        cmocka_unit_test(rows_that_were_lost),
        cmocka_unit_test(rows_that_were_lost_on_the_way),
        cmocka_unit_test(steps_that_are_usual),
        cmocka_unit_test(codes_for_missing_values),
        cmocka_unit_test(numbers_that_are_no_codes),
        cmocka_unit_test(not_finite),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
