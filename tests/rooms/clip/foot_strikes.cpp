// SPDX-License-Identifier: BSD-3-Clause
// Which events of a file are foot strikes, and of which side.
#include "clip/testing.hpp"

#include "clip/foot_strikes.hpp"

namespace {

using namespace clip_testing;
using stltsa::Side;
using namespace stltsa::clip;

struct Case {
    std::string label, context;
    Side side;
};

void check_name(const Event& event, std::size_t strikes) {
    Clip clip;
    clip.events = {event};
    if (foot_strikes(clip).size() != strikes)
        FAIL("context '%s', label '%s'", event.context.c_str(), event.label.c_str());
}

void names_of_foot_strikes(void**) {
    for (const Case& each : std::vector<Case>{
             {"Foot Strike", "Left", Side::left},
             {"FOOT STRIKE", "RIGHT", Side::right},
             {"Foot Strike", "General", Side::neither},
             {"Foot Strike 2", "Right", Side::right},
             {"RHS", "", Side::right},
             {"", "LHS", Side::left},
             {"R FS", "", Side::right},
             {"LFS", "", Side::left},
             {"LIC", "", Side::left},
             {"Right Foot Strike", "", Side::right},
             {"heel_strike_left", "", Side::left},
             {"Right heel contact", "", Side::right},
             {"Initial Contact", "Left", Side::left},
             {"IC", "Right", Side::right},
             {"hs", "", Side::neither},
             {"eRHS", "", Side::right},
             {"", "eLHS", Side::left},
             {"rhs", "", Side::right},
             {"l_ic", "", Side::left},
             {"Touchdown", "Left Foot", Side::left},
             {"RHS", "Left", Side::neither}, // they contradict each other
             {"Left Foot Strike", "Right", Side::neither},
             {"RHS", "Right", Side::right},
         }) {
        check_name({12.5, each.label, each.context}, 1);
        Clip clip;
        clip.events = {{12.5, each.label, each.context}};
        const FootStrike strike = foot_strikes(clip).front();
        assert_true(strike.frame == 12.5);
        if (strike.side != each.side)
            FAIL("the side of '%s' '%s'", each.context.c_str(), each.label.c_str());
    }
}

void names_of_others(void**) {
    for (const Event& each : std::vector<Event>{{1, "Foot Off", "Left"},
                                                {1, "LTO", ""},
                                                {1, "RON", ""},
                                                {1, "Event", "General"},
                                                {1, "", "RTO"},
                                                {1, "", ""},
                                                {1, "Foot Off", "LHS"},
                                                {1, "LHSR", ""},
                                                {1, "eRTO", ""},
                                                {1, "eLEFT", "Left"},
                                                {1, "basic", "Right"}})
        check_name(each, 0);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(names_of_foot_strikes),
        cmocka_unit_test(names_of_others),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
