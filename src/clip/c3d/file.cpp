// SPDX-License-Identifier: BSD-3-Clause
#include "clip/c3d/file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/error.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip::c3d {
namespace {

/// Values of the byte that names the processor.
enum : std::uint8_t { intel = 84, dec = 85, mips = 86 };

/// Bytes of all parameters. The format has room for 255 blocks, which some programs exceed.
constexpr std::size_t most_bytes = std::size_t{1} << 20;

/// F_floating of VAX: it has no infinities and counts the exponent from 129.
double vax_real(std::uint32_t bits) {
    const auto exponent = static_cast<int>(bits >> 23 & 0xff);
    if (exponent == 0)
        return 0;
    const double fraction = std::ldexp(static_cast<double>(bits & 0x7fffff), -23);
    return std::ldexp((bits >> 31) != 0 ? -1 - fraction : 1 + fraction, exponent - 129);
}

/// Where the parameters begin.
std::size_t place_of_parameters(std::string_view bytes) {
    return block * (static_cast<std::uint8_t>(bytes[0]) - std::size_t{1});
}

} // namespace

bool is_c3d(std::string_view bytes) {
    // The second byte is a P, which a text could have; but a header contains zeros.
    if (bytes.size() < block || bytes[1] != 'P' || bytes.substr(0, block).find('\0') == bytes.npos)
        return false;
    const std::size_t place = place_of_parameters(bytes) + 3;
    const auto processor = place < bytes.size() ? static_cast<std::uint8_t>(bytes[place]) : 0;
    return processor >= intel && processor <= mips;
}

File::File(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {
    if (!is_c3d(bytes))
        fail(Status::format,
             "{}: not a C3D file, or only the start of one: its second byte must be 80, and its "
             "parameters must name a processor (84, 85 or 86)",
             name);
    processor_ = static_cast<std::uint8_t>(bytes[place_of_parameters(bytes) + 3]);
    read_parameters(place_of_parameters(bytes) + 4);
}

std::string_view File::text(std::size_t at, std::size_t count) const {
    if (at > bytes_.size() || count > bytes_.size() - at)
        fail(Status::format, "{}: the file was cut off: it ends at byte {}: get the whole file",
             name_, bytes_.size());
    return bytes_.substr(at, count);
}

std::uint16_t File::word(std::size_t at) const {
    const std::string_view two = text(at, 2);
    const auto low = static_cast<std::uint8_t>(two[processor_ == mips ? 1 : 0]);
    const auto high = static_cast<std::uint8_t>(two[processor_ == mips ? 0 : 1]);
    return static_cast<std::uint16_t>(low | high << 8);
}

double File::real(std::size_t at) const {
    // The more significant word comes first, except on Intel.
    const std::uint32_t high = word(processor_ == intel ? at + 2 : at);
    const std::uint32_t bits = high << 16 | word(processor_ == intel ? at : at + 2);
    return processor_ == dec ? vax_real(bits) : static_cast<double>(std::bit_cast<float>(bits));
}

/// Entries follow one another: length of the name (negative: locked), group (negative: this is the
/// group itself), name, distance to the next entry (0: there is none), content.
void File::read_parameters(std::size_t at) {
    std::map<int, std::string> groups;
    std::vector<std::pair<int, std::pair<std::string, Values>>> found;
    for (const std::size_t end = std::min(size(), at + most_bytes); at < end;) {
        const auto length = std::abs(static_cast<std::int8_t>(text(at, 1)[0]));
        const int group = static_cast<std::int8_t>(text(at + 1, 1)[0]);
        if (length == 0 || group == 0)
            break;
        std::string name = to_lower(text(at + 2, static_cast<std::size_t>(length)));
        at += 2 + static_cast<std::size_t>(length);
        const std::size_t step = word(at), next = step == 0 ? end : at + step;
        if (group < 0)
            groups.emplace(-group, std::move(name));
        else
            found.push_back({group, {std::move(name), values_at(at + 2, next)}});
        at = next;
    }
    for (auto& [group, parameter] : found) // which may come before its group
        parameters_.emplace(groups[group] + ':' + parameter.first, std::move(parameter.second));
}

/// Type (-1: text, 1: bytes, 2: words, 4: reals), number of dimensions, dimensions, values. The
/// first dimension of texts is their length.
File::Values File::values_at(std::size_t at, std::size_t end) const {
    const int type = static_cast<std::int8_t>(text(at, 1)[0]);
    const std::string_view dimensions = text(at + 2, static_cast<std::uint8_t>(text(at + 1, 1)[0]));
    const std::size_t begin = at + 2 + dimensions.size();
    auto width = static_cast<std::size_t>(std::abs(type));
    std::size_t count = 1;
    for (std::size_t i = 0; i < dimensions.size() && count <= most_bytes; ++i)
        (type < 0 && i == 0 ? width : count) *= static_cast<std::uint8_t>(dimensions[i]);
    if (begin + width * count > end) // values that overlap could need any memory
        fail(Status::format, "{}: damaged: the parameter at byte {} is longer than its place",
             name_, at);
    Values values;
    for (std::size_t i = 0; width > 0 && i < count; ++i) {
        const std::string_view value = text(begin + i * width, width);
        if (type < 0)
            values.texts.emplace_back(trim(value.substr(0, value.find('\0'))));
        else if (type == 4)
            values.numbers.push_back(real(begin + i * width));
        else // counts, which may need the bit of the sign
            values.numbers.push_back(type == 2 ? word(begin + i * width)
                                               : static_cast<std::uint8_t>(value[0]));
    }
    return values;
}

File::Values File::parameter(const std::string& name) const {
    Values all;
    auto found = parameters_.find(name);
    for (int i = 2; found != parameters_.end(); ++i) {
        const auto& [numbers, texts] = found->second;
        all.numbers.insert(all.numbers.end(), numbers.begin(), numbers.end());
        all.texts.insert(all.texts.end(), texts.begin(), texts.end());
        found = parameters_.find(format_text("{}{}", name, i));
    }
    return all;
}

double File::number(const std::string& name, double otherwise) const {
    const auto found = parameters_.find(name);
    const bool has = found != parameters_.end() && !found->second.numbers.empty();
    return has ? found->second.numbers[0] : otherwise;
}

} // namespace stltsa::clip::c3d
