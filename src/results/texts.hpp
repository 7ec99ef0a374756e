// SPDX-License-Identifier: BSD-3-Clause
// Texts that the rows of a result point to.
#pragma once

#include <deque>
#include <string>
#include <vector>

namespace stltsa::results {

/// Keeps texts where they are, however often it is moved.
class Texts {
  public:
    Texts() = default;
    Texts(Texts&&) = default;
    Texts& operator=(Texts&&) = default;
    Texts(const Texts&) = delete;
    Texts& operator=(const Texts&) = delete;

    const char* keep(std::string text) { return texts_.emplace_back(std::move(text)).c_str(); }

    /// A list that ends with a null pointer.
    const char* const* keep(const std::vector<std::string>& list) {
        std::vector<const char*>& kept = lists_.emplace_back();
        for (const std::string& text : list)
            kept.push_back(keep(text));
        kept.push_back(nullptr);
        return kept.data();
    }

  private:
    std::deque<std::string> texts_;
    std::deque<std::vector<const char*>> lists_;
};

} // namespace stltsa::results
