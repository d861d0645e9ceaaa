// Writes the numbers of warnings.

#include "app/session/rehearsal/rehearsal_warning.h"

#include <algorithm>
#include <cmath>

#include "analysis/number_text.h"

namespace asperity {

std::string in_three_digits(double value) {
  const double size = std::abs(value);
  if (size >= 100.0 || size == 0.0) return fixed(value, 0);
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(size)));
  return fixed(value, std::clamp(decimals, 0, 12));
}

}  // namespace asperity
