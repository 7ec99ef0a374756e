// SPDX-License-Identifier: BSD-3-Clause
// For any bytes, a reader returns a clip or throws an Error: it throws nothing else, never crashes
// (the sanitizers watch), and allocates no memory that the bytes do not justify.
#include "clip/testing.hpp"

#include <algorithm>

#include "base/utf8.hpp"
#include "clip/acclaim/skeleton_file.hpp"
#include "clip/features/features.hpp"
#include "clip/features/prepare.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;

using Reader = std::function<void(std::string_view)>;

const std::string small_csv = "time,\"left, knee\",hip\n0,1.5,2\n0.01,-2e0,3\n0.02,4,+5.25\n";
const std::string small_npy = [] {
    std::string bytes("\x93NUMPY\x01\x00", 8);
    const std::string dict = "{'descr': '<f8', 'fortran_order': True, 'shape': (2, 2), }\n";
    bytes += {static_cast<char>(dict.size()), '\0'};
    bytes += dict;
    for (int i = 0; i < 4; ++i)
        bytes += std::string("\0\0\0\0\0\0\xF0\x3F", 8);
    return bytes;
}();

void check_clip(const Clip& clip) {
    assert_true(clip.frames() > 0 && clip.values.cols() > 0);
    assert_true(clip.channel_names.empty() ||
                static_cast<std::int64_t>(clip.channel_names.size()) == clip.values.cols());
    assert_true(clip.fps >= 0);
    if (failure_of([&] { prepare(clip, {}); }).status == Status::internal)
        FAIL("a clip that breaks prepare()");
}

Reader reader(Format format) {
    return [format](std::string_view bytes) { check_clip(parse(bytes, format)); };
}

/// Letters of any script, but no control characters (C1 is U+0080 to U+009F) and no broken UTF-8.
bool is_printable(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = stltsa::utf8_length(text, at);
        const auto first = static_cast<unsigned char>(text[at]);
        const bool control = first < 0x20 || first == 0x7F;
        const bool c1 = first == 0xC2 && static_cast<unsigned char>(text[at + 1]) < 0xA0;
        if (length == 0 || control || c1)
            return false;
        at += length;
    }
    return true;
}

/// Reads; an exception must be an Error with a suitable status and a printable text.
void read(const Reader& reader, const std::string& bytes) {
    const Failure failure = failure_of([&] { reader(bytes); });
    if (failure.status == Status::ok)
        return;
    const bool fitting = failure.status == Status::format || failure.status == Status::not_finite ||
                         failure.status == Status::unsupported || failure.status == Status::shape;
    if (!fitting || !is_printable(failure.text) || failure.text.empty() ||
        failure.text.size() > 400)
        FAIL("status %d: %s", static_cast<int>(failure.status), failure.text.c_str());
}

void truncate_everywhere(const Reader& reader, const std::string& bytes) {
    for (std::size_t size = 0; size <= bytes.size(); ++size)
        read(reader, bytes.substr(0, size));
}

void flip_bytes(const Reader& reader, const std::string& bytes) {
    Random random;
    for (int round = 0; round < 4000; ++round) {
        std::string changed = bytes;
        for (std::uint64_t flips = 1 + random.below(4); flips > 0; --flips)
            changed[random.below(bytes.size())] = static_cast<char>(random.below(256));
        read(reader, changed);
    }
}

/// Words that break parsers, in place of every word.
void replace_words(const Reader& reader, const std::string& bytes) {
    const std::string long_word(100000, '7');
    for (const std::string_view word :
         {std::string_view(""), std::string_view("-1"), std::string_view("99999999999999999999"),
          std::string_view("9223372036854775807"), std::string_view("1e308"),
          std::string_view("-1e308"), std::string_view("nan"), std::string_view("{"),
          std::string_view("}"), std::string_view("\""), std::string_view(","),
          std::string_view("0"), std::string_view("1e-320"), std::string_view("\0", 1),
          std::string_view(long_word)})
        for (std::size_t begin = 0; begin < bytes.size();) {
            const std::size_t end = std::min(bytes.find_first_of(" \n,", begin), bytes.size());
            if (end > begin)
                read(reader, bytes.substr(0, begin).append(word).append(bytes, end));
            begin = end + 1;
        }
}

void attack(const Reader& reader, const std::string& bytes) {
    reader(bytes); // the complete bytes are valid
    truncate_everywhere(reader, bytes);
    flip_bytes(reader, bytes);
    replace_words(reader, bytes);
}

void hostile_bvh(void**) {
    attack(reader(Format::bvh), small_bvh);
}
void hostile_csv(void**) {
    attack(reader(Format::csv), small_csv);
}
void hostile_npy(void**) {
    attack(reader(Format::npy), small_npy);
}

void hostile_amc(void**) {
    const TemporaryFolder folder;
    ReadOptions options;
    options.skeleton = folder.write("a.asf", small_asf);
    attack([&](std::string_view bytes) { check_clip(parse(bytes, Format::amc, options)); },
           small_amc);
}

void hostile_asf(void**) {
    attack([](std::string_view bytes) { parse_asf(bytes, "test"); }, small_asf);
}

void hostile_content_of_unknown_kind(void**) {
    for (const std::string& bytes : {small_bvh, small_amc, small_csv, small_npy, small_asf})
        for (std::size_t size = 0; size <= bytes.size(); ++size)
            sniff(std::string_view(bytes).substr(0, size));
}

void deep_and_wide_skeletons(void**) {
    std::string asf = ":root\norder rx\n:bonedata\n";
    std::string links = ":hierarchy\nbegin\nroot b0\n";
    for (int i = 0; i < 2000; ++i) {
        asf += stltsa::format_text("begin\nname b{}\ndirection 0 1 0\nlength 1\nend\n", i);
        if (i > 0)
            links += stltsa::format_text("b{} b{}\n", i - 1, i);
    }
    assert_int_equal(parse_asf(asf + links + "end\n", "test").skeleton.joints.size(), 2002);
    std::string bvh = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n";
    for (int i = 0; i < 4000; ++i)
        bvh += "JOINT b\n{\nOFFSET 0 1 0\n";
    for (int i = 0; i < 4001; ++i)
        bvh += "}\n";
    const Clip clip = parse(bvh + "MOTION\nFrames: 2\nFrame Time: 1\n0\n90\n", Format::bvh);
    ASSERT_NEAR(positions(clip)(1, 3 * 4000 + 2), 4000, 1e-9);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(hostile_bvh),
        cmocka_unit_test(hostile_csv),
        cmocka_unit_test(hostile_npy),
        cmocka_unit_test(hostile_amc),
        cmocka_unit_test(hostile_asf),
        cmocka_unit_test(hostile_content_of_unknown_kind),
        cmocka_unit_test(deep_and_wide_skeletons),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
