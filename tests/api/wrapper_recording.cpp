// SPDX-License-Identifier: BSD-3-Clause
// stltsa.hpp: the segments of a recording.
#include <algorithm>

#include <stltsa.hpp>

#include "../rooms/assertions.hpp"

namespace {

std::string walker_path; // set by main()

const stltsa::Clip& walker() {
    static const stltsa::Clip clip = stltsa::Clip::open(walker_path);
    return clip;
}

void a_recording_is_divided_into_segments(void**) {
    const stltsa::Decomposition found = stltsa::decompose(walker());
    const std::vector<stltsa::Segment> segments = found.segments();
    assert_int_equal(segments.size(), found.segment_count());
    assert_int_equal(segments[0].begin, 0);
    assert_int_equal(segments.back().end, walker().frames());
    const auto cyclic = std::ranges::find(segments, STLTSA_SEGMENT_CYCLIC, &stltsa::Segment::kind);
    assert_true(cyclic != segments.end());
    const std::int64_t index = cyclic - segments.begin();
    assert_string_equal(stltsa::segment_name(found.segment(index).kind).c_str(), "cyclic");
    assert_int_equal(cyclic->count, 3);
    assert_string_equal(found.segment_reason(index).c_str(), "");
    assert_true(!found.carriers(index).empty());
    const std::vector<stltsa::Part> cycles = found.parts(STLTSA_PART_CYCLE);
    assert_int_equal(cycles.size(), 3);
    assert_int_equal(found.part_count(STLTSA_PART_STEP), 6);
    assert_int_equal(found.part(STLTSA_PART_STEP, 5).parent, 2);
    assert_int_equal(cycles[1].begin, found.cycle(1).begin);
    assert_int_equal(found.summary_count(), 1);
    assert_int_equal(found.summary(0).count, 3);
    ASSERT_NEAR(found.summaries()[0].mean_s, found.info().real(STLTSA_INFO_PERIOD), 0.1);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2)
        return 2;
    walker_path = argv[1];
    const CMUnitTest tests[] = {
        cmocka_unit_test(a_recording_is_divided_into_segments),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
