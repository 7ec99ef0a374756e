// SPDX-License-Identifier: BSD-3-Clause
#include "calls.hpp"
#include "works.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace {

/// A folder with a clip, whose result later runs keep.
class Folder {
  public:
    explicit Folder(const std::string& clip) {
        if (::mkdtemp(path_.data()) == nullptr)
            std::abort();
        std::ofstream(path_ + "/clip.csv") << clip;
        out_ = path_ + "/out";
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    const char* path() const { return path_.c_str(); }
    const char* out() const { return out_.c_str(); }

  private:
    std::string path_ = (std::filesystem::temp_directory_path() / "stltsa-oom-XXXXXX").string();
    std::string out_;
};

} // namespace

stltsa_status batches(const std::string& input) {
    static const Folder folder(input);
    const char* paths[] = {folder.path()};
    Calls calls;
    stltsa_options* options = nullptr;
    stltsa_batch* batch = nullptr;
    char* row = nullptr;
    calls.make([&] { return stltsa_options_new(&options); }, options);
    calls.make([&] { return stltsa_options_set_real(options, STLTSA_OPT_FPS, 30); });
    calls.make([&] { return stltsa_batch_new(paths, 1, folder.out(), "1/1", options, &batch); },
               batch);
    calls.make([&] { return stltsa_batch_run(batch, 0, nullptr, nullptr, nullptr, &row); });
    calls.make([&] {
        return stltsa_batch_finish(batch, const_cast<const char* const*>(&row), 1, nullptr);
    });
    if (calls.good() && stltsa_batch_path(batch, 0) != nullptr)
        note(row);
    stltsa_free(row);
    stltsa_batch_free(batch);
    stltsa_options_free(options);
    return calls.status();
}
