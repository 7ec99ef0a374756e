// SPDX-License-Identifier: BSD-3-Clause
// Tests memory exhaustion at every point: makes each allocation of a complete task fail in turn.
// A call that fails must return STLTSA_E_NO_MEMORY with a text and no handle. Every call must leak
// nothing (the count of live allocations returns to its value) and leave the settings of OpenBLAS
// and OpenMP as they were. A call that succeeds despite a failed allocation, and the task after all
// failures, must give the result of the complete run.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include "allocations.hpp"
#include "calls.hpp"
#include "works.hpp"

namespace {

std::int64_t all_failures = 0;

stltsa_status decompose(const std::string& input) {
    stltsa_options* options = nullptr;
    stltsa_clip* clip = nullptr;
    stltsa_decomposition* units = nullptr;
    char* json = nullptr;
    stltsa_status status = stltsa_options_new(&options);
    if (status == STLTSA_OK)
        status = stltsa_options_set_real(options, STLTSA_OPT_FPS, 30);
    if (status == STLTSA_OK)
        status = stltsa_clip_parse(input.data(), input.size(), STLTSA_FORMAT_CSV, nullptr, options,
                                   &clip);
    if (status == STLTSA_OK)
        status = stltsa_decompose(clip, options, &units);
    else if (clip != nullptr)
        status = 1;
    if (status == STLTSA_OK)
        status = stltsa_info_json(stltsa_decomposition_info(units), &json);
    note(json);
    stltsa_free(json);
    stltsa_decomposition_free(units);
    stltsa_clip_free(clip);
    stltsa_options_free(options);
    return status;
}

/// Writes a clip to files; no other file may remain in their folder.
stltsa_status save(const std::string&) {
    static const std::string bvh =
        "HIERARCHY\nROOT hip\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
        "JOINT a joint of a long name\n{\nOFFSET 0 1 0\nCHANNELS 1 Xrotation\nEnd Site\n{\n"
        "OFFSET 0 1 0\n}\n}\n}\nMOTION\nFrames: 2\nFrame Time: 0.01\n1 2 3 4\n1 2 3 5\n";
    static const std::string folder =
        std::filesystem::temp_directory_path() / ("stltsa-oom-" + std::to_string(::getpid()));
    static const std::string paths[] = {folder + "/a.bvh", folder + "/a.csv", folder + "/a.npy"};
    stltsa_clip* clip = nullptr;
    stltsa_status status =
        stltsa_clip_parse(bvh.data(), bvh.size(), STLTSA_FORMAT_BVH, nullptr, nullptr, &clip);
    ::mkdir(folder.c_str(), 0777);
    for (const std::string& path : paths) {
        if (status == STLTSA_OK)
            status = stltsa_clip_save(clip, path.c_str(), nullptr);
        ::unlink(path.c_str());
    }
    stltsa_clip_free(clip);
    return ::rmdir(folder.c_str()) == 0 ? status : 1;
}

/// A swing with two joints: 40 frames at 30 frames per second.
std::string swinging_bvh() {
    std::string text =
        "HIERARCHY\nROOT hip\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
        "JOINT knee\n{\nOFFSET 0 -1 0\nCHANNELS 1 Xrotation\nEnd Site\n{\nOFFSET 0 -1 0\n}\n}\n}\n"
        "MOTION\nFrames: 40\nFrame Time: 0.0333333\n";
    for (int i = 0; i < 40; ++i)
        for (int c = 0; c < 4; ++c)
            text += std::to_string(20 * std::sin(2 * M_PI * i / 15.0 + c) + 0.1 * i) +
                    (c < 3 ? " " : "\n");
    return text;
}

const stltsa_clip* swinging() {
    static stltsa_clip* clip = [] {
        const std::string bvh = swinging_bvh();
        stltsa_clip* made = nullptr;
        stltsa_clip_parse(bvh.data(), bvh.size(), STLTSA_FORMAT_BVH, nullptr, nullptr, &made);
        return made;
    }();
    return clip;
}

/// Writes a report and a figure of a clip that has already been decomposed.
stltsa_status report(const std::string&) {
    static const stltsa_decomposition* found = [] {
        stltsa_decomposition* made = nullptr;
        stltsa_decompose(swinging(), nullptr, &made);
        return made;
    }();
    static const std::string figure = std::filesystem::temp_directory_path() /
                                      ("stltsa-oom-" + std::to_string(::getpid()) + ".svg");
    stltsa_status status = stltsa_report_save(swinging(), found, nullptr, "stltsa", "/dev/null");
    if (status == STLTSA_OK)
        status = stltsa_report_save(swinging(), found, nullptr, nullptr, figure.c_str());
    ::unlink(figure.c_str());
    return status;
}

stltsa_status note_model(const stltsa_model* model) {
    unsigned char* bytes = nullptr;
    std::size_t size = 0;
    const stltsa_status status = stltsa_model_serialize(model, &bytes, &size);
    note(bytes, status == STLTSA_OK ? size : 0);
    stltsa_free(bytes);
    return status;
}

/// A model that keeps frames and poses.
stltsa_status fit_clip(const std::string&) {
    stltsa_model* model = nullptr;
    stltsa_status status = fitted_clip(swinging(), model);
    if (status == STLTSA_OK)
        status = note_model(model);
    else if (model != nullptr)
        status = 1;
    stltsa_model_free(model);
    return status;
}

/// Maps to the curve and back, to features and to poses.
stltsa_status map(const std::string&) {
    static const stltsa_model* model = [] {
        stltsa_model* made = nullptr;
        fitted_clip(swinging(), made);
        return made;
    }();
    double coords[40][2], frames[3][9], distance[40];
    std::int64_t nearest[40];
    const stltsa_in points = {coords[7], 3, 2, 0, 0, STLTSA_F64, 0};
    const stltsa_out coords_out = {coords, 40, 2, 0, 0, STLTSA_F64, 0};
    const stltsa_out frames_out = {frames, 3, 9, 0, 0, STLTSA_F64, 0};
    const stltsa_out distance_out = {distance, 40, 1, 0, 0, STLTSA_F64, 0};
    const stltsa_out nearest_out = {nearest, 40, 1, 0, 0, STLTSA_I64, 0};
    const stltsa_in hints = {nearest, 3, 1, 0, 0, STLTSA_I64, 0};
    stltsa_clip* poses = nullptr;
    stltsa_status status =
        stltsa_map_clip(model, swinging(), nullptr, &coords_out, &distance_out, &nearest_out);
    coords[7][0] += 0.01; // away from the rows, so that rows are blended
    if (status == STLTSA_OK)
        status = stltsa_unmap(model, &points, nullptr, nullptr, &frames_out, nullptr, nullptr);
    if (status == STLTSA_OK)
        status = stltsa_unmap_clip(model, &points, &hints, nullptr, nullptr, nullptr, &poses);
    if (status == STLTSA_OK) {
        note(coords, sizeof(coords));
        note(frames, sizeof(frames));
    } else if (poses != nullptr) {
        status = 1;
    }
    stltsa_clip_free(poses);
    return status;
}

stltsa_status map_swinging(const stltsa_model* model) {
    double coords[40][2];
    const stltsa_out out = {coords, 40, 2, 0, 0, STLTSA_F64, 0};
    return stltsa_map_clip(model, swinging(), nullptr, &out, nullptr, nullptr);
}

/// Writes a model to memory and to a file and reads both back, with the parts for mapping built at
/// first use; no other file may remain in the folder.
stltsa_status model_file(const std::string&) {
    static const stltsa_model* kept = [] {
        stltsa_model* made = nullptr;
        fitted_clip(swinging(), made);
        return made;
    }();
    static const std::string folder =
        std::filesystem::temp_directory_path() / ("stltsa-oom-model-" + std::to_string(::getpid()));
    static const std::string path = folder + "/model";
    ::mkdir(folder.c_str(), 0777);
    unsigned char* bytes = nullptr;
    std::size_t size = 0;
    stltsa_model* parsed = nullptr;
    stltsa_model* loaded = nullptr;
    stltsa_status status = stltsa_model_serialize(kept, &bytes, &size);
    if (status == STLTSA_OK)
        status = stltsa_model_parse(bytes, size, &parsed);
    else if (bytes != nullptr)
        status = 1;
    if (status == STLTSA_OK)
        status = stltsa_model_save(kept, path.c_str(), nullptr);
    else if (parsed != nullptr)
        status = 1;
    if (status == STLTSA_OK)
        status = stltsa_model_load(path.c_str(), nullptr, &loaded);
    if (status != STLTSA_OK && loaded != nullptr)
        status = 1;
    if (status == STLTSA_OK)
        status = map_swinging(loaded);
    if (status == STLTSA_OK)
        status = map_swinging(parsed);
    note(bytes, status == STLTSA_OK ? size : 0);
    ::unlink(path.c_str());
    stltsa_model_free(loaded);
    stltsa_model_free(parsed);
    stltsa_free(bytes);
    return ::rmdir(folder.c_str()) == 0 ? status : 1;
}

void write_text(const std::filesystem::path& path, const char* text) {
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (file == nullptr || std::fputs(text, file) < 0 || std::fclose(file) != 0)
        std::abort();
}

/// Opens an AMC file whose skeleton lies beside it.
stltsa_status open_amc(const std::string&) {
    static const std::filesystem::path folder = [] {
        std::string made = (std::filesystem::temp_directory_path() / "stltsa-oom-XXXXXX").string();
        if (::mkdtemp(made.data()) == nullptr)
            std::abort();
        write_text(std::filesystem::path(made) / "1.asf",
                   ":root\norder tx rx\naxis xyz\nposition 0 0 0\norientation 0 0 0\n:bonedata\n"
                   "begin\nid 1\nname leg\ndirection 0 1 0\nlength 1\naxis 0 0 0 xyz\ndof rx\n"
                   "end\n:hierarchy\nbegin\nroot leg\nend\n");
        write_text(std::filesystem::path(made) / "1_01.amc",
                   ":DEGREES\n1\nroot 1 2\nleg 3\n2\nroot 1 3\nleg 4\n");
        return std::filesystem::path(made);
    }();
    static const struct Remove {
        ~Remove() {
            std::error_code ignored;
            std::filesystem::remove_all(folder, ignored);
        }
    } at_the_end;
    static const std::string path = folder / "1_01.amc";
    stltsa_clip* clip = nullptr;
    stltsa_status status = stltsa_clip_open(path.c_str(), nullptr, &clip);
    if (status == STLTSA_OK && stltsa_clip_frames(clip) != 2)
        status = 1;
    if (status != STLTSA_OK && clip != nullptr)
        status = 1;
    stltsa_clip_free(clip);
    return status;
}

/// Fits a model to the numbers of a file.
stltsa_status fit_file(const std::string&) {
    static const std::string path =
        (std::filesystem::temp_directory_path() / ("stltsa-oom-" + std::to_string(::getpid())))
            .string() +
        ".npy";
    static const std::string stretch = path + ":2-40";
    stltsa_clip *clip = nullptr, *part = nullptr;
    stltsa_model* model = nullptr;
    stltsa_status status = stltsa_clip_save(swinging(), path.c_str(), nullptr);
    if (status == STLTSA_OK)
        status = stltsa_clip_open(path.c_str(), nullptr, &clip);
    if (status == STLTSA_OK)
        status = stltsa_clip_open_stretch(stretch.c_str(), nullptr, &part);
    else if (clip != nullptr)
        status = 1;
    if (status == STLTSA_OK)
        status = fitted_clip(part, model);
    else if (part != nullptr)
        status = 1;
    if (status == STLTSA_OK)
        status = note_model(model);
    else if (model != nullptr)
        status = 1;
    ::unlink(path.c_str());
    stltsa_model_free(model);
    stltsa_clip_free(part);
    stltsa_clip_free(clip);
    return status;
}

stltsa_status fit_mode(std::int64_t mode) {
    static double frames[200][4];
    for (int i = 0; i < 200; ++i)
        for (int c = 0; c < 4; ++c)
            frames[i][c] = std::sin(0.05 * i * (c + 1)) + 0.01 * i;
    const stltsa_in in = {frames, 200, 4, 0, 0, STLTSA_F64, 0};
    stltsa_options* options = nullptr;
    stltsa_model* model = nullptr;
    stltsa_status status = stltsa_options_new(&options);
    if (status == STLTSA_OK)
        status = stltsa_options_set_int(options, STLTSA_OPT_MODE, mode);
    if (status == STLTSA_OK)
        status = stltsa_options_set_int(options, STLTSA_OPT_THREADS, 2);
    if (status == STLTSA_OK)
        status = stltsa_fit(&in, nullptr, options, &model);
    else if (model != nullptr)
        status = 1;
    if (status == STLTSA_OK)
        status = note_model(model);
    stltsa_model_free(model);
    stltsa_options_free(options);
    return status;
}

stltsa_status fit_temporal(const std::string&) {
    return fit_mode(STLTSA_MODE_TEMPORAL);
}
stltsa_status fit_spatial(const std::string&) {
    return fit_mode(STLTSA_MODE_SPATIAL);
}
stltsa_status fit_recurrent(const std::string&) {
    return fit_mode(STLTSA_MODE_RECURRENT);
}

stltsa_status denoise(const std::string&) {
    static double coords[200][2];
    for (int i = 0; i < 200; ++i)
        for (int c = 0; c < 2; ++c)
            coords[i][c] = std::sin(0.2 * i + c) + 0.1 * std::sin(37.0 * i * i);
    const stltsa_in in = {coords, 200, 2, 0, 0, STLTSA_F64, 0};
    stltsa_options* options = nullptr;
    stltsa_denoising* denoising = nullptr;
    char* json = nullptr;
    stltsa_status status = stltsa_options_new(&options);
    if (status == STLTSA_OK)
        status = stltsa_options_set_real(options, STLTSA_OPT_FPS, 30);
    if (status == STLTSA_OK)
        status = stltsa_denoise(&in, nullptr, options, &denoising);
    if (status == STLTSA_OK)
        status = stltsa_info_json(stltsa_denoising_info(denoising), &json);
    else if (denoising != nullptr)
        status = 1;
    note(json);
    stltsa_free(json);
    stltsa_denoising_free(denoising);
    stltsa_options_free(options);
    return status;
}

/// Makes a loop and reads its description.
stltsa_status synthesize(const std::string&) {
    const stltsa_piece piece = {swinging(), 8, 23, 3, 0};
    stltsa_synthesis* synthesis = nullptr;
    char* json = nullptr;
    stltsa_status status = stltsa_synthesize(&piece, 1, nullptr, &synthesis);
    if (status == STLTSA_OK)
        status = stltsa_info_json(stltsa_synthesis_info(synthesis), &json);
    else if (synthesis != nullptr)
        status = 1;
    note(json);
    stltsa_free(json);
    stltsa_synthesis_free(synthesis);
    return status;
}

/// A setting of a library that this process loaded, and that the test gives an unusual value.
class Setting {
  public:
    Setting(const char* getter, const char* setter, int value)
        : get_(reinterpret_cast<int (*)()>(::dlsym(RTLD_DEFAULT, getter))), value_(value) {
        const auto set = reinterpret_cast<void (*)(int)>(::dlsym(RTLD_DEFAULT, setter));
        if (set != nullptr)
            set(value);
    }
    bool remains() const { return get_ == nullptr || get_() == value_; }

  private:
    int (*get_)();
    int value_;
};

bool settings_remain() {
    static const Setting blas("openblas_get_num_threads", "openblas_set_num_threads", 2);
    static const Setting omp("omp_get_max_active_levels", "omp_set_max_active_levels", 3);
    return blas.remains() && omp.remains();
}

struct Run {
    stltsa_status status;
    std::uint64_t result; ///< see noted
    bool failed;          ///< an allocation failed
    std::int64_t leaked;  ///< number of allocations that were not freed
};

Run run_with_failure(const Work& work, const std::string& input, std::int64_t n) {
    const std::int64_t before = live.load();
    noted = 0;
    until_failure = n;
    const stltsa_status status = work.run(input);
    const bool failed = until_failure.exchange(-1) < 0;
    return {status, noted, failed, live.load() - before};
}

/// Fails every `step`-th allocation until a run succeeds; returns false on any wrong result.
bool survives(const Work& work, const std::string& input, std::int64_t step) {
    // The first run also creates everything that libraries allocate once.
    constexpr std::int64_t never = INT64_MAX;
    const Run complete = run_with_failure(work, input, never);
    if (complete.status != STLTSA_OK) {
        std::printf("%s fails with all memory: %s\n", work.name, stltsa_last_error());
        return false;
    }
    std::int64_t failures = 0, tried = 0;
    for (std::int64_t n = 0;; n += step, ++tried) {
        Run run = run_with_failure(work, input, n);
        if (run.leaked != 0) // what a library allocates once and keeps does not leak again
            run = run_with_failure(work, input, n);
        if (run.leaked != 0) {
            std::printf("%s: failing allocation %lld leaks %lld\n", work.name,
                        static_cast<long long>(n), static_cast<long long>(run.leaked));
            return false;
        }
        if (!settings_remain()) {
            std::printf("%s: failing allocation %lld changes a setting of OpenBLAS or OpenMP\n",
                        work.name, static_cast<long long>(n));
            return false;
        }
        if (run.status == STLTSA_OK && run.result != complete.result) {
            std::printf("%s: failing allocation %lld changes the result\n", work.name,
                        static_cast<long long>(n));
            return false;
        }
        if (!run.failed)
            break; // the task needed at most n allocations
        // If a thread cannot start, the others do its share, and the call succeeds.
        if (run.status != STLTSA_OK && run.status != STLTSA_E_NO_MEMORY) {
            std::printf("%s: failing allocation %lld gives %s (%s)\n", work.name,
                        static_cast<long long>(n), stltsa_status_name(run.status),
                        stltsa_last_error());
            return false;
        }
        failures += run.status == STLTSA_E_NO_MEMORY;
        all_failures += 1;
    }
    const Run again = run_with_failure(work, input, never);
    if (again.status != STLTSA_OK || again.result != complete.result) {
        std::printf("after the failures, %s fails or gives another result: %s\n", work.name,
                    stltsa_last_error());
        return false;
    }
    std::printf("%s: %lld of %lld allocations failed in turn\n", work.name,
                static_cast<long long>(failures), static_cast<long long>(tried * step));
    return !work.allocates || failures > 0;
}

} // namespace

/// Usage: test_oom [STEP]: only every STEP-th allocation fails, for a quick run.
int main(int count, char** arguments) {
    const std::int64_t step = count > 1 ? std::atoll(arguments[1]) : 1;
    std::vector<Work> works = {{"decompose", decompose},
                               {"save", save},
                               {"fit clip", fit_clip},
                               {"map", map},
                               {"model file", model_file},
                               {"fit file", fit_file},
                               {"open amc", open_amc},
                               {"denoise", denoise},
                               {"synthesize", synthesize},
                               {"fit temporal", fit_temporal},
                               {"fit spatial", fit_spatial},
                               {"fit recurrent", fit_recurrent},
                               {"report", report}};
    for (const Work& work : other_works())
        works.push_back(work);
    const std::string input = cyclic_csv();
    bool good = settings_remain(); // the first call sets them
    ::dl_iterate_phdr(find_spared, nullptr);
    for (const Work& work : works)
        good = survives(work, input, step) && good;
    for (const Spared& s : spared)
        std::printf("%s: %lld of its own allocations spared\n", s.name,
                    static_cast<long long>(s.times.load()));
    std::printf("allocations failed: %lld, of %zu tasks\n", static_cast<long long>(all_failures),
                works.size());
    return good ? 0 : 1;
}
