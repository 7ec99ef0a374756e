// SPDX-License-Identifier: BSD-3-Clause
#include "clip/testing.hpp"

#include <clocale>
#include <cmath>

#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace {

using namespace stltsa::clip;

void reads_common_notations(void**) {
    const struct {
        const char* text;
        double value;
    } cases[] = {{".0083333", .0083333}, {"-3.22404e-015", -3.22404e-15},
                 {"+1.5", 1.5},          {"7.62852E-016", 7.62852e-16},
                 {"-0.0", -0.0},         {"5.", 5},
                 {"1e-400", 0},          {"0.1", 0.1}};
    for (const auto& c : cases) {
        const auto value = parse_number(c.text);
        assert_true(value.has_value());
        assert_true(*value == c.value);
    }
}

void refuses_text_that_is_not_a_number(void**) {
    for (const char* text :
         {"", "+", "-", "+-1", "++1", "1,5", "1.2.3", "0x10", "1e", "abc", "1 2", "1.#QNAN", "--1"})
        if (parse_number(text))
            FAIL("'%s' was read as a number", text);
}

void numbers_may_be_infinite_or_tiny(void**) {
    assert_true(std::isnan(*parse_number("nan")));
    assert_true(*parse_number("1e999") > 1e308);
    assert_true(*parse_number("-1e999") < -1e308);
    // Many digits before the point are huge, many zeros after it are tiny.
    assert_true(std::isinf(*parse_number(std::string(400, '9') + ".5")));
    assert_true(*parse_number("0." + std::string(400, '0') + "1") == 0);
}

void ignores_the_locale(void**) {
    // If none of these locales is installed, this proves nothing.
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"})
        if (std::setlocale(LC_ALL, name) != nullptr)
            break;
    assert_true(*parse_number("1.5") == 1.5);
    std::setlocale(LC_ALL, "C");
}

void rounds_rates_to_nearby_integers(void**) {
    assert_true(rate_of(.0083333) == 120);
    assert_true(rate_of(.008333) == 120);
    assert_true(rate_of(.033333) == 30);
    assert_true(rate_of(.0333667) == 1 / .0333667); // 29.97
    assert_true(rate_of(4) == 0.25);
    assert_true(rate_of(1e5) == 1 / 1e5);
    assert_true(rate_of(0) == 0 && rate_of(1e-310) == 0);
}

void counts_lines_of_every_kind(void**) {
    TextCursor in("\xEF\xBB\xBFone\ntwo\r\nthree\rfour\n\n\r\n six{", "name");
    for (const auto& [word, line] : {std::pair{"one", 1},
                                     {"two", 2},
                                     {"three", 3},
                                     {"four", 4},
                                     {"six", 7},
                                     {"{", 7},
                                     {"", 7}}) {
        assert_true(in.word() == word);
        assert_int_equal(in.line_number(), line);
    }
    TextCursor lines("\n a b \r\n\r\nc\r\rd", "name");
    for (const auto& [text, line] : {std::pair{" a b ", 2}, {"c", 4}, {"d", 6}}) {
        assert_true(lines.line() == text);
        assert_int_equal(lines.line_number(), line);
    }
    assert_true(lines.line().empty());
}

void quotes_only_printable_characters(void**) {
    assert_string_equal(stltsa::clip::in_quotes("a\x01\xFFz").c_str(), "'a??z'");
    assert_true(stltsa::clip::in_quotes(std::string(1000, 'x')).size() < 60);
    assert_string_equal(stltsa::clip::in_quotes("\xC3\xA9-\xC2\x9B\xC3").c_str(), "'\xC3\xA9-?"
                                                                                  "?'");
    std::string letters; // cut between characters, not within one
    for (int i = 0; i < 50; ++i)
        letters += "\xC3\xA9";
    assert_string_equal(stltsa::clip::in_quotes(letters).c_str(),
                        ("'" + letters.substr(0, 80) + "...'").c_str());
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(reads_common_notations),
        cmocka_unit_test(refuses_text_that_is_not_a_number),
        cmocka_unit_test(numbers_may_be_infinite_or_tiny),
        cmocka_unit_test(ignores_the_locale),
        cmocka_unit_test(rounds_rates_to_nearby_integers),
        cmocka_unit_test(counts_lines_of_every_kind),
        cmocka_unit_test(quotes_only_printable_characters),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
