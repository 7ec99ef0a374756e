// SPDX-License-Identifier: BSD-3-Clause
// The same bits with every instruction set and number of threads; the same numbers with other
// kernels of OpenBLAS.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "ltsa/fit.hpp"
#include "ltsa/testing.hpp"

namespace {

using namespace ltsa_testing;
using stltsa::ltsa::Mode;
using stltsa::ltsa::Model;
using stltsa::ltsa::Parameters;

constexpr std::int64_t features = 29;

Matrix motion(std::int64_t frames) {
    Matrix x = cyclic(frames, features);
    add_noise(x, 1e-3, 1); // all cycles differ
    return x;
}

Parameters parameters_of(Mode mode, std::int64_t size) {
    Parameters parameters;
    parameters.mode = mode;
    parameters.neighbors = parameters.window = parameters.exclusion = size;
    parameters.simd = Simd::baseline;
    return parameters;
}

Model fitted(const Matrix& x, const Parameters& parameters) {
    const std::int64_t lengths[] = {x.rows()};
    return fit(x.view(), lengths, parameters);
}

bool same_bits(const double* a, const double* b, std::int64_t count) {
    return std::memcmp(a, b, static_cast<std::size_t>(count) * sizeof(double)) == 0;
}

bool same_bits(const Model& a, const Model& b) {
    bool same = a.components.size() == b.components.size() &&
                same_bits(a.coords.data(), b.coords.data(), a.coords.rows() * a.coords.cols());
    for (std::size_t c = 0; same && c < a.components.size(); ++c)
        same = same_bits(a.components[c].eigenvalues.data(), b.components[c].eigenvalues.data(),
                         static_cast<std::int64_t>(a.components[c].eigenvalues.size())) &&
               same_bits(&a.components[c].error_estimate, &b.components[c].error_estimate, 1);
    return same;
}

/// Whether all fits have the bits of the fit with one thread and the baseline instruction set.
void check_bits(const char* name, const Matrix& x, Parameters parameters,
                const std::vector<int>& thread_counts) {
    const Model expected = fitted(x, parameters);
    for (const Simd simd : instruction_sets())
        for (const int threads : thread_counts) {
            parameters.simd = simd;
            parameters.threads = threads;
            if (!same_bits(fitted(x, parameters), expected))
                FAIL("%s: k = %ld, instruction set %d, %d threads: other bits", name,
                     parameters.neighbors, static_cast<int>(simd), threads);
        }
}

/// More than two blocks of frames, which threads share.
constexpr std::int64_t frames = 1100;

void temporal_fits_have_the_same_bits(void**) {
    for (const std::int64_t size : {12, 50, 140})
        check_bits("temporal", motion(frames), parameters_of(Mode::temporal, size), {1, 2, 4});
    for (const std::int64_t size : {8, 12})
        check_bits("noise", noise(301, features), parameters_of(Mode::temporal, size), {1});
}

/// Long enough to share passes over single numbers per frame; some frames repeat.
void long_fits_have_the_same_bits(void**) {
    Matrix x = cyclic(300000, 3);
    add_noise(x, 1e-3, 1);
    for (const std::int64_t frame : {1000, 1024, 2048, 290000})
        std::copy_n(x.row(frame - 1), x.cols(), x.row(frame));
    check_bits("long", x, parameters_of(Mode::temporal, 6), {1, 2, 4});
}

void spatial_fits_have_the_same_bits(void**) {
    for (const std::int64_t size : {12, 50, 140})
        check_bits("spatial", motion(frames), parameters_of(Mode::spatial, size), {1, 2, 4});
}

void recurrent_fits_have_the_same_bits(void**) {
    for (const std::int64_t size : {12, 50, 140})
        check_bits("recurrent", motion(frames), parameters_of(Mode::recurrent, size), {1, 2, 4});
}

/// Writes the coordinates of a fit to standard output, in a child process.
int print_coords(const char* size) {
    const Model model = fitted(motion(frames), parameters_of(Mode::temporal, std::atoi(size)));
    const auto count = static_cast<std::size_t>(model.coords.rows() * model.coords.cols());
    return std::fwrite(model.coords.data(), sizeof(double), count, stdout) == count ? 0 : 1;
}

/// The same from a process whose OpenBLAS was told, when it was loaded, to use the kernels of
/// another machine.
std::vector<double> coords_with(const char* machine, std::int64_t size) {
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const char* emulator = std::getenv("MESON_EXE_WRAPPER"); // set for the code of another machine
    const std::string command = std::string("OPENBLAS_CORETYPE=") + machine + ' ' +
                                (emulator == nullptr ? "" : emulator) + " '" + self + "' " +
                                std::to_string(size) + " 2>/dev/null";
    std::vector<double> coords(static_cast<std::size_t>(2 * frames));
    FILE* pipe = popen(command.c_str(), "r");
    assert_non_null(pipe);
    const std::size_t count = std::fread(coords.data(), sizeof(double), coords.size(), pipe);
    assert_int_equal(pclose(pipe), 0);
    assert_int_equal(count, coords.size());
    return coords;
}

std::vector<const char*> other_machines() {
#ifdef __aarch64__
    return {"CORTEXA53", "NEOVERSEN1"};
#else
    return {"Nehalem", stltsa::widest_simd() == Simd::avx2 ? "Haswell" : "Nehalem"};
#endif
}

void other_blas_kernels_give_the_same_numbers(void**) {
    for (const std::int64_t size : {12, 50, 140}) {
        const Model expected = fitted(motion(frames), parameters_of(Mode::temporal, size));
        // If OpenBLAS does not know the name, or is not the BLAS, nothing differs.
        for (const char* machine : other_machines()) {
            const std::vector<double> coords = coords_with(machine, size);
            double worst = 0;
            for (std::size_t i = 0; i < coords.size(); ++i)
                worst = std::max(worst, std::abs(coords[i] - expected.coords.data()[i]));
            ASSERT_NEAR(worst, 0, 1e-10);
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc > 1)
        return print_coords(argv[1]);
    const CMUnitTest tests[] = {
        cmocka_unit_test(temporal_fits_have_the_same_bits),
        cmocka_unit_test(long_fits_have_the_same_bits),
        cmocka_unit_test(spatial_fits_have_the_same_bits),
        cmocka_unit_test(recurrent_fits_have_the_same_bits),
        cmocka_unit_test(other_blas_kernels_give_the_same_numbers),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
