// SPDX-License-Identifier: BSD-3-Clause
#include "results/model_file/archive_model.hpp"

#include <algorithm>

#include <zlib.h>

#include "results/model_file/archive.hpp"
#include "results/model_file/fields.hpp"

namespace stltsa::results {
namespace {

/// No text file begins like this, and a transfer that changes line ends or the eighth bit alters
/// it.
constexpr std::string_view magic("\x89STLTSA\n", 8);

/// Increases whenever the fields change.
constexpr std::uint32_t version = 5;

constexpr std::size_t head_size = magic.size() + sizeof version + sizeof(std::uint64_t);
/// Bytes of head and checksum.
constexpr std::size_t wrapping_size = head_size + sizeof(std::uint32_t);

/// CRC-32, which detects every change of up to 32 consecutive bits.
class Checksum {
  public:
    void operator()(std::string_view bytes) {
        constexpr std::size_t most = std::size_t{1} << 30; // zlib counts in unsigned int
        for (std::size_t at = 0; at < bytes.size(); at += most) {
            const std::string_view part = bytes.substr(at, most);
            sum_ = crc32(sum_, reinterpret_cast<const Bytef*>(part.data()),
                         static_cast<uInt>(part.size()));
        }
    }
    std::uint32_t value() const { return static_cast<std::uint32_t>(sum_); }

  private:
    uLong sum_ = crc32(0, nullptr, 0);
};

std::uint32_t checksum(std::string_view bytes) {
    Checksum sum;
    sum(bytes);
    return sum.value();
}

void archive_parts(const Fitted& model, const Sink& sink) {
    ArchiveWriter parts(sink);
    model_fields(parts, model);
    parts.finish();
}

template <class... Values>
void archive_values(const Sink& sink, const Values&... values) {
    ArchiveWriter writer(sink);
    writer(values...);
    writer.finish();
}

/// The parts of a file whose head and checksum are right.
std::string_view checked_parts(std::string_view bytes) {
    if (!bytes.starts_with(magic.substr(0, std::min(magic.size(), bytes.size()))) || bytes.empty())
        fail(Status::format, "this is not a model file: its first bytes are different "
                             "(stltsa_model_save, or stltsa fit -o, writes models)");
    if (bytes.size() < wrapping_size)
        fail(Status::format, "the model is cut off: {} bytes are fewer than its head has",
             bytes.size());
    ArchiveReader head(bytes.substr(magic.size(), head_size - magic.size()));
    std::uint32_t written = 0;
    std::uint64_t size = 0;
    head(written, size);
    if (written != version)
        fail(Status::format, "the model is of version {}, this library reads version {}", written,
             version);
    if (size != bytes.size() - wrapping_size)
        fail(Status::format,
             "the model is cut off or extended: it has {} bytes, "
             "{} were written",
             bytes.size(), size + wrapping_size);
    std::uint32_t sum = 0;
    ArchiveReader(bytes.substr(bytes.size() - sizeof sum))(sum);
    if (sum != checksum(bytes.substr(0, bytes.size() - sizeof sum)))
        fail(Status::format, "the model is damaged: its checksum is wrong; save it again");
    return bytes.substr(head_size, static_cast<std::size_t>(size));
}

} // namespace

std::uint64_t archive_size(const Fitted& model) {
    std::uint64_t size = wrapping_size;
    archive_parts(model, [&size](std::string_view piece) { size += piece.size(); });
    return size;
}

void archive_model(const Fitted& model, std::uint64_t size, const Sink& sink) {
    Checksum sum;
    const Sink summed = [&](std::string_view piece) {
        sum(piece);
        sink(piece);
    };
    summed(magic);
    archive_values(summed, version, size - wrapping_size);
    archive_parts(model, summed);
    archive_values(sink, sum.value());
}

Fitted restore_model(std::string_view bytes) {
    ArchiveReader parts(checked_parts(bytes));
    Fitted model;
    model_fields(parts, model);
    if (parts.bytes_left() > 0)
        fail(Status::format, "the model is damaged: {} bytes follow its last part",
             parts.bytes_left());
    check_model_fields(model);
    return model;
}

} // namespace stltsa::results
