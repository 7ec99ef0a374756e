// SPDX-License-Identifier: BSD-3-Clause
// What a caller is told of a defect of the library.
#include <stdexcept>
#include <string>

#include "assertions.hpp"
#include "capi/boundary/guard.hpp"

namespace {

using stltsa::capi::guard;

std::string text_of(const std::string& what) {
    assert_int_equal(guard([&] { throw std::logic_error(what); }), STLTSA_E_INTERNAL);
    return stltsa_last_error();
}

void the_text_says_where_to_report(void**) {
    const std::string text = text_of("the impossible");
    assert_true(text.starts_with("the impossible (this is a defect of libstltsa"));
    assert_true(text.find("https://") != text.npos && text.ends_with(")"));
}

void a_long_text_keeps_the_address(void**) {
    const std::string text = text_of(std::string(5000, 'x'));
    assert_true(text.size() < 1024 && text.starts_with("xxx"));
    assert_true(text.find("https://") != text.npos && text.ends_with(")"));
}

void faults_of_the_caller_are_not_reported(void**) {
    assert_int_equal(guard([] { stltsa::fail(stltsa::Status::argument, "k is 0"); }),
                     STLTSA_E_ARGUMENT);
    assert_string_equal(stltsa_last_error(), "k is 0");
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(the_text_says_where_to_report),
        cmocka_unit_test(a_long_text_keeps_the_address),
        cmocka_unit_test(faults_of_the_caller_are_not_reported),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
