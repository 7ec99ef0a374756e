// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>

#include "base/progress.hpp"
#include "capi/boundary/guard.hpp"
#include "capi/handles.hpp"
#include "capi/options/reader.hpp"
#include "clip/files/read_file.hpp"
#include "clip/files/write_file.hpp"
#include "results/model_file/archive_model.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

stltsa_status stltsa_model_serialize(const stltsa_model* model, unsigned char** bytes,
                                     size_t* size) noexcept {
    return guard([&] {
        required(bytes, "bytes") = nullptr;
        required(size, "size") = 0;
        const std::uint64_t needed = results::archive_size(required(model, "model"));
        std::unique_ptr<char[]> made(new char[needed]);
        char* end = made.get();
        results::archive_model(*model, needed, [&end](std::string_view piece) {
            end = std::copy(piece.begin(), piece.end(), end);
        });
        *bytes = reinterpret_cast<unsigned char*>(made.release());
        *size = needed;
    });
}

stltsa_status stltsa_model_parse(const void* bytes, size_t size, stltsa_model** model) noexcept {
    return guard([&] {
        required(model, "model") = nullptr;
        const char* text = static_cast<const char*>(bytes);
        if (size > 0)
            required(text, "bytes");
        *model = new stltsa_model(results::restore_model({text, size}));
    });
}

stltsa_status stltsa_model_save(const stltsa_model* model, const char* path,
                                const stltsa_options* options) noexcept {
    return guard(options, [&] {
        const std::uint64_t needed = results::archive_size(required(model, "model"));
        report_progress(Stage::write, 0);
        clip::write_file(&required(path, "path"),
                         [&](const Sink& sink) { results::archive_model(*model, needed, sink); });
    });
}

stltsa_status stltsa_model_load(const char* path, const stltsa_options* options,
                                stltsa_model** model) noexcept {
    return guard(options, [&] {
        required(model, "model") = nullptr;
        const std::string name = &required(path, "path");
        const std::string bytes = clip::read_file(name);
        try {
            *model = new stltsa_model(results::restore_model(bytes));
        } catch (const Error& error) {
            fail(error.status(), "{}: {}", name, error.what());
        }
    });
}
