// SPDX-License-Identifier: BSD-3-Clause
// The numbers and parameters of a C3D file, in the forms of the processor that wrote it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace stltsa::clip::c3d {

constexpr std::size_t block = 512; ///< bytes in which places are counted

/// Whether the bytes begin like a C3D file.
bool is_c3d(std::string_view bytes);

class File {
  public:
    /// Throws Status::format if the bytes are no C3D file, or if its parameters are damaged.
    File(std::string_view bytes, const std::string& name);

    /// Throw Status::format beyond the end of the file.
    std::string_view text(std::size_t at, std::size_t count) const;
    std::uint16_t word(std::size_t at) const;
    double real(std::size_t at) const;
    std::size_t size() const { return bytes_.size(); }
    const std::string& name() const { return name_; }

    struct Values {
        std::vector<double> numbers;
        std::vector<std::string> texts; ///< without blanks at their ends
    };
    /// The values of a parameter, such as "point:labels", with those of labels2, labels3, ...: each
    /// has at most 255. None if the file lacks it.
    Values parameter(const std::string& name) const;
    /// Its first number.
    double number(const std::string& name, double otherwise = 0) const;

  private:
    void read_parameters(std::size_t at);
    Values values_at(std::size_t at, std::size_t end) const;

    std::string_view bytes_;
    const std::string& name_;
    std::uint8_t processor_ = 0;
    std::map<std::string, Values> parameters_; ///< by "group:name" in lower case
};

} // namespace stltsa::clip::c3d
