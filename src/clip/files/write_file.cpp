// SPDX-License-Identifier: BSD-3-Clause
#include "clip/files/write_file.hpp"

#include <new>
#include <system_error>

#include "base/error.hpp"
#include "clip/files/replace_file.hpp"

namespace stltsa::clip {

void write_file(const std::string& path, std::string_view bytes) {
    write_file(path, [bytes](const Sink& sink) { sink(bytes); });
}

void write_file(const std::string& path, const std::function<void(const Sink&)>& content) {
    if (path.empty())
        fail(Status::io, "the path is empty: give the name of a file");
    try {
        if (!regular_or_new(path))
            return write_directly(path, content);
        TemporaryFile file(followed(path));
        file.write(content);
        file.move_to_place();
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::not_enough_memory)
            throw std::bad_alloc();
        fail(Status::io, "{}: cannot write: {}", path, why_not_written(error.code()));
    }
}

} // namespace stltsa::clip
