// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/eigen_batch.hpp"

namespace stltsa::ltsa {
namespace {

std::int64_t rounded_up(std::int64_t value, std::int64_t step) {
    return (value + step - 1) / step * step;
}

} // namespace

EigenBatch::EigenBatch(const Shape& shape, Simd simd)
    : shape_(shape), rows_(rounded_up(shape.size, product_rows)),
      columns_(rounded_up(shape.columns, product_columns)),
      kept_(shape.keeps_block ? columns_ : shape.count), simd_(simd), lanes_(simd_width(simd)) {
    const auto sized = [this](std::int64_t entries) {
        return AlignedVector<double>(checked_size(entries, lanes_));
    };
    matrix_ = sized(rows_ * rows_);
    block_ = sized(rows_ * columns_);
    product_ = sized(rows_ * columns_);
    small_ = sized(columns_ * (2 * columns_ + 1));
    values_ = sized(shape.count + 1);
    vectors_ = sized(rows_ * kept_);
    start_.resize(checked_size(rows_, columns_));
}

BlockIteration EigenBatch::iteration() {
    return {shape_.size,          rows_,          columns_,       shape_.count,  kept_,
            shape_.ritz_interval, start_.data(),  matrix_.data(), block_.data(), product_.data(),
            small_.data(),        values_.data(), vectors_.data()};
}

void EigenBatch::start_from(std::int64_t lane) {
    for (std::size_t i = 0; i < start_.size(); ++i)
        start_[i] = vectors_[index(static_cast<std::int64_t>(i), lane)];
}

} // namespace stltsa::ltsa
