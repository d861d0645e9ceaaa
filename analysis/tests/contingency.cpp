// Column by column, every way to fill it from what is left of the rows.

#include "analysis/tests/contingency.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "analysis/numbers/matrix_place.h"

namespace asperity {
namespace {

/// P = Π row! · Π column!/(n! · Π cell!).
class AllTables final {
 public:
  explicit AllTables(const CountMatrix& table)
      : columns_(table.cols()), left_(static_cast<std::size_t>(table.rows())) {
    const std::int64_t n = table.sum();
    log_factorial_.resize(static_cast<std::size_t>(n) + 1);
    for (std::size_t i = 1; i < log_factorial_.size(); ++i) {
      log_factorial_[i] = std::lgamma(static_cast<double>(i) + 1.0);
    }
    for (Eigen::Index row = 0; row < table.rows(); ++row) {
      left_[static_cast<std::size_t>(row)] = table.row(row).sum();
      margins_ += of(table.row(row).sum());
      for (Eigen::Index column = 0; column < columns_; ++column) {
        cells_ += of(table(row, column));
      }
    }
    for (Eigen::Index column = 0; column < columns_; ++column) {
      sums_.push_back(table.col(column).sum());
      margins_ += of(table.col(column).sum());
    }
    margins_ -= of(n);
  }

  std::optional<double> tail() {
    fill(0, 0, sums_.empty() ? 0 : sums_.front(), 0.0);
    if (steps_ > kMostSteps) return std::nullopt;
    return std::min(1.0, sum_);
  }

 private:
  static constexpr std::size_t kMostSteps = 20'000'000;

  double of(std::int64_t count) const { return log_factorial_[static_cast<std::size_t>(count)]; }

  void fill(std::size_t column, std::size_t row, std::int64_t missing, double cells) {
    if (++steps_ > kMostSteps) return;
    if (column + 1 >= sums_.size()) {  // the last column takes what is left
      for (const std::int64_t rest : left_) cells += of(rest);
      if (cells >= cells_ - 1e-7) sum_ += std::exp(margins_ - cells);
      return;
    }
    if (row + 1 == left_.size()) {
      if (missing > left_[row]) return;
      left_[row] -= missing;
      fill(column + 1, 0, sums_[column + 1], cells + of(missing));
      left_[row] += missing;
      return;
    }
    for (std::int64_t count = 0; count <= std::min(missing, left_[row]); ++count) {
      left_[row] -= count;
      fill(column, row + 1, missing - count, cells + of(count));
      left_[row] += count;
    }
  }

  Eigen::Index columns_ = 0;
  std::vector<std::int64_t> left_{};  ///< of each row
  std::vector<std::int64_t> sums_{};  ///< of each column
  std::vector<double> log_factorial_{};
  double margins_ = 0.0;
  double cells_ = 0.0;
  double sum_ = 0.0;
  std::size_t steps_ = 0;
};

}  // namespace

std::optional<double> exact_independence_test(const CountMatrix& table) {
  if (table.size() > 0 && table.minCoeff() < 0) {
    throw std::invalid_argument("table: the count in " +
                                place_of_first(table, [](auto value) { return value < 0; }) +
                                " is negative; all counts must be at least 0");
  }
  if (table.size() == 0) return 1.0;
  return AllTables(table).tail();
}

}  // namespace asperity
