// Takes logarithms, and refuses times that are not above 0.

#include "app/findings/tidy/time_column.h"

#include <cmath>
#include <cstddef>

#include "analysis/numbers/number_text.h"

namespace asperity {

std::vector<std::optional<double>> logarithms_of_times(const TidyTable& table) {
  std::vector<std::optional<double>> times = table.numbers("time_s");
  for (std::size_t row = 0; row < times.size(); ++row) {
    if (!times[row]) continue;
    if (*times[row] <= 0.0) {
      table.refuse(row, "time_s",
                   "time_s is " + number_text(*times[row]) +
                       "; a response time must be above 0 s. Correct it, or leave the cell empty "
                       "where there is none");
    }
    times[row] = std::log(*times[row]);
  }
  return times;
}

}  // namespace asperity
