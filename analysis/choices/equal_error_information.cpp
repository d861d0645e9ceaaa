// Computes log2 of the number of labels minus the entropy of a response whose errors are equally frequent.

#include "analysis/choices/equal_error_information.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/numbers/number_text.h"

namespace asperity {

double equal_error_bits(double share, std::size_t labels) {
  if (labels < 2) {
    throw std::invalid_argument("labels is " + std::to_string(labels) + "; it must be at least 2");
  }
  if (!(share >= 0.0 && share <= 1.0)) {
    throw std::invalid_argument("the proportion correct is " + number_text(share) +
                                "; it must lie between 0 and 1");
  }
  const double wrong = 1.0 - share;
  const auto others = static_cast<double>(labels - 1);
  double bits = std::log2(static_cast<double>(labels));
  if (share > 0.0) bits += share * std::log2(share);
  if (wrong > 0.0) bits += wrong * std::log2(wrong / others);
  return bits;
}

}  // namespace asperity
