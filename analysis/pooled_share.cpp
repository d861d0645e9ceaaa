#include "analysis/pooled_share.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace asperity {

PooledShare pooled_share(std::span<const HitCount> participants) {
  if (participants.empty()) {
    throw std::invalid_argument("participants is empty; a share needs at least one");
  }
  HitCount all{};
  for (const HitCount& own : participants) {
    static_cast<void>(proportion(own));  // refuses what is impossible
    all.hits += own.hits;
    all.trials += own.trials;
  }
  PooledShare pooled{.share = proportion(all)};
  const auto trials = static_cast<double>(all.trials);
  const auto n = static_cast<double>(participants.size());
  double squares = 0.0;
  for (const HitCount& own : participants) {
    const double from =
        static_cast<double>(own.hits) - pooled.share * static_cast<double>(own.trials);
    squares += from * from;
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const double binomial = pooled.share * (1.0 - pooled.share) / trials;
  const double clustered = n > 1.0 ? n / (n - 1.0) * squares / (trials * trials) : kNone;
  pooled.clustered_standard_error = std::sqrt(clustered);
  pooled.binomial_standard_error = std::sqrt(binomial);
  pooled.design_effect = binomial > 0.0 ? clustered / binomial : kNone;
  return pooled;
}

}  // namespace asperity
