// SPDX-License-Identifier: BSD-3-Clause
#include "json.hpp"

namespace tool {

Json parsed_json(const std::string& text) {
    return Json::parse(text);
}

} // namespace tool
