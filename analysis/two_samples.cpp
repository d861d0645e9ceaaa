// Permutations one by one, and ranks by convolution.

#include "analysis/two_samples.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace asperity {
namespace {

std::vector<double> pooled(const TwoSamples& samples) {
  if (samples.first.empty() || samples.second.empty()) {
    throw std::invalid_argument("a sample is empty; two samples need a number each");
  }
  std::vector<double> all(samples.first.begin(), samples.first.end());
  all.insert(all.end(), samples.second.begin(), samples.second.end());
  return all;
}

// Twice the midrank of each number, which is whole.
std::vector<std::size_t> twice_midranks(const std::vector<double>& numbers) {
  std::vector<std::size_t> ranks;
  for (const double number : numbers) {
    std::size_t below = 0;
    std::size_t equal = 0;
    for (const double other : numbers) {
      below += other < number ? 1 : 0;
      equal += other == number ? 1 : 0;
    }
    ranks.push_back(2 * below + equal + 1);
  }
  return ranks;
}

}  // namespace

std::optional<double> permutation_test(const TwoSamples& samples) {
  const std::vector<double> all = pooled(samples);
  if (all.size() > kMostPermuted) {
    return std::nullopt;
  }
  const auto n1 = static_cast<double>(samples.first.size());
  const auto n2 = static_cast<double>(samples.second.size());
  const double total = std::accumulate(all.begin(), all.end(), 0.0);
  const auto difference = [&](double sum) { return std::abs(sum / n1 - (total - sum) / n2); };
  constexpr double kRounding = 1e-9;
  const double observed =
      difference(std::accumulate(samples.first.begin(), samples.first.end(), 0.0)) - kRounding;
  std::vector<std::size_t> split(samples.first.size());
  std::iota(split.begin(), split.end(), std::size_t{0});
  double as_far = 0.0;
  double ways = 0.0;
  while (true) {
    double sum = 0.0;
    for (const std::size_t i : split) {
      sum += all[i];
    }
    ways += 1.0;
    as_far += difference(sum) >= observed ? 1.0 : 0.0;
    // The next combination: the last place that can move on does, those behind follow it.
    std::size_t place = split.size();
    while (place > 0 && split[place - 1] == all.size() - split.size() + place - 1) {
      --place;
    }
    if (place == 0) {
      return as_far / ways;
    }
    ++split[place - 1];
    for (std::size_t i = place; i < split.size(); ++i) {
      split[i] = split[i - 1] + 1;
    }
  }
}

MannWhitney mann_whitney(const TwoSamples& samples) {
  const std::vector<std::size_t> ranks = twice_midranks(pooled(samples));
  const std::size_t n1 = samples.first.size();
  const std::size_t total = std::accumulate(ranks.begin(), ranks.end(), std::size_t{0});
  const std::size_t observed = std::accumulate(
      ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(n1), std::size_t{0});
  // ways[k][s]: probability weight of k numbers in the first sample with the rank sum s, as shares
  // of all splits made so far, so that nothing overflows: the (i+1)-th number is in the first
  // sample with the probability (n1 − k)/(N − i).
  std::vector<std::vector<double>> ways(n1 + 1, std::vector<double>(total + 1, 0.0));
  ways[0][0] = 1.0;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    const auto left = static_cast<double>(ranks.size() - i);
    for (std::size_t k = std::min(i + 1, n1) + 1; k-- > 0;) {
      for (std::size_t sum = total + 1; sum-- > 0;) {
        const double stays =
            ways[k][sum] * (1.0 - static_cast<double>(n1 - k) / left);
        const double joins =
            k > 0 && sum >= ranks[i]
                ? ways[k - 1][sum - ranks[i]] * static_cast<double>(n1 - k + 1) / left
                : 0.0;
        ways[k][sum] = stays + joins;
      }
    }
  }
  // |s − mean| with the mean n1·total/N, in whole numbers: |N·s − n1·total|.
  const auto distance = [&](std::size_t sum) {
    const std::size_t a = ranks.size() * sum;
    const std::size_t b = n1 * total;
    return a > b ? a - b : b - a;
  };
  MannWhitney answer;
  answer.U = 0.5 * static_cast<double>(observed) - 0.5 * static_cast<double>(n1 * (n1 + 1));
  answer.p = 0.0;
  for (std::size_t sum = 0; sum <= total; ++sum) {
    answer.p += distance(sum) >= distance(observed) ? ways[n1][sum] : 0.0;
  }
  answer.p = std::min(1.0, answer.p);
  return answer;
}

}  // namespace asperity
