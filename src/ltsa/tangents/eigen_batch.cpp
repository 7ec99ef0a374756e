// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/tangents/eigen_batch.hpp"

#include "base/random.hpp"

namespace stltsa::ltsa {
EigenBatch::EigenBatch(const Shape& shape, Simd simd)
    : shape_(shape), rows_(rounded_up(shape.size, product_rows)),
      columns_(rounded_up(shape.columns, product_columns)), simd_(simd), lanes_(simd_width(simd)) {
    const auto sized = [this](std::int64_t entries) {
        return AlignedVector<double>(checked_size(entries, lanes_));
    };
    matrix_ = sized(rows_ * rows_);
    block_ = sized(rows_ * columns_);
    product_ = sized(rows_ * columns_);
    small_ = sized(columns_ * (2 * columns_ + 1));
    values_ = sized(shape.count + 1);
    vectors_ = sized(rows_ * shape.count);
    start_.resize(checked_size(rows_, columns_));
    // Columns beyond the order of the matrices stay zero.
    Random random(1);
    for (std::int64_t l = 0; l < std::min(columns_, shape.size); ++l)
        for (std::int64_t a = 0; a < shape.size; ++a)
            start_[static_cast<std::size_t>(l * rows_ + a)] = random.symmetric();
}

BlockIteration EigenBatch::iteration() {
    return {shape_.size,   rows_,          columns_,       shape_.count,
            start_.data(), matrix_.data(), block_.data(),  product_.data(),
            small_.data(), values_.data(), vectors_.data()};
}

} // namespace stltsa::ltsa
