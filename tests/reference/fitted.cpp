// SPDX-License-Identifier: BSD-3-Clause
#include "fitted.hpp"

#include <cstdint>
#include <memory>
#include <stdexcept>

#include "stltsa.h"

namespace reference {
namespace {

void must(stltsa_status status) {
    if (status != STLTSA_OK)
        throw std::runtime_error(std::string(stltsa_status_name(status)) + ": " +
                                 stltsa_last_error());
}

template <class Handle, void (*Free)(Handle*) noexcept>
struct Deleter {
    void operator()(Handle* handle) const { Free(handle); }
};
using Options = std::unique_ptr<stltsa_options, Deleter<stltsa_options, stltsa_options_free>>;
using Model = std::unique_ptr<stltsa_model, Deleter<stltsa_model, stltsa_model_free>>;
using Clip = std::unique_ptr<stltsa_clip, Deleter<stltsa_clip, stltsa_clip_free>>;

Options new_options() {
    stltsa_options* options = nullptr;
    must(stltsa_options_new(&options));
    return Options(options);
}

void set(const Options& options, std::int32_t key, std::size_t value) {
    must(stltsa_options_set_int(options.get(), key, static_cast<std::int64_t>(value)));
}

stltsa_out packed(Table<double>& table) {
    return {table.values.data(),
            static_cast<std::int64_t>(table.rows),
            static_cast<std::int64_t>(table.cols),
            0,
            0,
            STLTSA_F64,
            0};
}

/// The transpose of a table, in the same memory.
stltsa_out transposed(Table<double>& table) {
    return {table.values.data(),
            static_cast<std::int64_t>(table.cols),
            static_cast<std::int64_t>(table.rows),
            sizeof(double),
            static_cast<std::int64_t>(table.cols * sizeof(double)),
            STLTSA_F64,
            0};
}

} // namespace

Fitted fit(const Frames& frames, std::int32_t mode, std::size_t k, std::size_t w, std::size_t d) {
    const Options options = new_options();
    set(options, STLTSA_OPT_NEIGHBORS, k);
    set(options, STLTSA_OPT_WINDOW, w);
    set(options, STLTSA_OPT_DIMENSION, d);
    set(options, STLTSA_OPT_MODE, static_cast<std::size_t>(mode));
    const stltsa_in in{frames.values.data(),
                       static_cast<std::int64_t>(frames.rows),
                       static_cast<std::int64_t>(frames.cols),
                       0,
                       0,
                       STLTSA_F64,
                       0};
    stltsa_model* raw = nullptr;
    must(stltsa_fit(&in, nullptr, options.get(), &raw));
    const Model model(raw);

    const stltsa_info* info = stltsa_model_info(raw);
    const std::int64_t components = stltsa_info_count(info, STLTSA_INFO_COMPONENT);
    if (components != 1)
        throw std::runtime_error("the library sees " + std::to_string(components) +
                                 " components where the reference sees one");
    stltsa_component component{};
    must(stltsa_info_rows(info, STLTSA_INFO_COMPONENT, 0, 1, &component, sizeof component));
    Fitted result;
    result.error_estimate = component.error_estimate_rad;
    result.coords = Table<double>(d, frames.rows);
    const stltsa_out coords = transposed(result.coords);
    must(stltsa_info_array(info, STLTSA_INFO_COORDS, 0, &coords));
    Table<double> values(1, d + 2);
    const stltsa_out eigenvalues = packed(values);
    must(stltsa_info_array(info, STLTSA_INFO_EIGENVALUES, 0, &eigenvalues));
    result.eigenvalues = values.values;
    return result;
}

Frames euler_features(const std::string& path, const std::string& skeleton) {
    const Options options = new_options();
    if (!skeleton.empty())
        must(stltsa_options_set_text(options.get(), STLTSA_OPT_SKELETON, skeleton.c_str()));
    set(options, STLTSA_OPT_FEATURES, STLTSA_FEATURES_EULER);
    stltsa_clip* raw = nullptr;
    must(stltsa_clip_open(path.c_str(), options.get(), &raw));
    const Clip clip(raw);
    std::int64_t count = 0;
    must(stltsa_clip_feature_count(raw, options.get(), &count));
    Frames frames(static_cast<std::size_t>(stltsa_clip_frames(raw)),
                  static_cast<std::size_t>(count));
    const stltsa_out features = packed(frames);
    must(stltsa_clip_features(raw, options.get(), &features));
    return frames;
}

} // namespace reference
