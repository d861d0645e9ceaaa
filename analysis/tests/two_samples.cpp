// The statistic of the permutations, and ranks by convolution.

#include "analysis/tests/two_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace asperity {
namespace {

std::vector<double> pooled(const TwoSamples& samples) {
  if (samples.first.empty() || samples.second.empty()) {
    throw std::invalid_argument("a sample is empty; each sample needs at least one value");
  }
  std::vector<double> all(samples.first.begin(), samples.first.end());
  all.insert(all.end(), samples.second.begin(), samples.second.end());
  return all;
}

// Twice the midrank of each number, which is whole.
std::vector<std::size_t> twice_midranks(const std::vector<double>& numbers) {
  std::vector<double> sorted = numbers;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> ranks;
  for (const double number : numbers) {
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), number);
    ranks.push_back(
        static_cast<std::size_t>((first - sorted.begin()) + (last - sorted.begin()) + 1));
  }
  return ranks;
}

// Twice the rank sum of n1 of these ranks that is no nearer to its mean than the observed one.
double exact_p(const std::vector<std::size_t>& ranks, std::size_t n1, std::size_t observed) {
  const std::size_t total = std::accumulate(ranks.begin(), ranks.end(), std::size_t{0});
  // ways[k][s]: the probability that k of the ranks so far are in the first sample and add up to s.
  // The (i+1)-th is in it with probability (n1 − k)/(N − i).
  std::vector<std::vector<double>> ways(n1 + 1, std::vector<double>(total + 1, 0.0));
  ways[0][0] = 1.0;
  std::size_t reached = 0;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    reached += ranks[i];
    const auto left = static_cast<double>(ranks.size() - i);
    for (std::size_t k = std::min(i + 1, n1) + 1; k-- > 0;) {
      const double stays = 1.0 - static_cast<double>(n1 - k) / left;
      const double joins = static_cast<double>(n1 - k + 1) / left;
      for (std::size_t sum = reached + 1; sum-- > 0;) {
        ways[k][sum] *= stays;
        if (k > 0 && sum >= ranks[i]) {
          ways[k][sum] += ways[k - 1][sum - ranks[i]] * joins;
        }
      }
    }
  }
  // |s − mean| with the mean n1·total/N, in whole numbers: |N·s − n1·total|.
  const auto distance = [&](std::size_t sum) {
    const std::size_t a = ranks.size() * sum;
    const std::size_t b = n1 * total;
    return a > b ? a - b : b - a;
  };
  double p = 0.0;
  for (std::size_t sum = 0; sum <= total; ++sum) {
    p += distance(sum) >= distance(observed) ? ways[n1][sum] : 0.0;
  }
  return std::min(1.0, p);
}

std::optional<double> normal_p(const std::vector<std::size_t>& ranks, std::size_t n1,
                               std::size_t observed) {
  const auto n = static_cast<double>(ranks.size());
  const auto first = static_cast<double>(n1);
  const double mean =
      static_cast<double>(std::accumulate(ranks.begin(), ranks.end(), std::size_t{0})) / n;
  double squares = 0.0;
  for (const std::size_t rank : ranks) {
    squares += (static_cast<double>(rank) - mean) * (static_cast<double>(rank) - mean);
  }
  if (squares == 0.0) {
    return std::nullopt;
  }
  const double variance = first * (n - first) / (n * (n - 1.0)) * squares;
  const double z = std::abs(static_cast<double>(observed) - first * mean) / std::sqrt(variance);
  return std::erfc(z / std::numbers::sqrt2);
}

}  // namespace

SplitTest permutation_test(const TwoSamples& samples, std::span<const std::size_t> blocks,
                           Random random) {
  std::vector<double> all = pooled(samples);
  const auto n1 = static_cast<double>(samples.first.size());
  const auto n2 = static_cast<double>(samples.second.size());
  // Less one of them, which changes no difference: what they have in common is not rounded again.
  double greatest = 0.0;
  double widest = 0.0;
  const double origin = all.front();
  std::vector<std::vector<double>> numbers;
  for (double& number : all) {
    greatest = std::max(greatest, std::abs(number));
    number -= origin;
    widest = std::max(widest, std::abs(number));
    numbers.push_back({number});
  }
  const double total = std::accumulate(all.begin(), all.end(), 0.0);
  const auto difference = [&](double sum) { return std::abs(sum / n1 - (total - sum) / n2); };
  // Two differences are equal if they would be without rounding: each number may be half a unit off
  // and each of two means of two splits so much more for every addition.
  const double rounding = std::numeric_limits<double>::epsilon() *
                          (2.0 * greatest + 4.0 * static_cast<double>(all.size()) * widest);
  const auto end_of_first = all.begin() + static_cast<std::ptrdiff_t>(samples.first.size());
  const double observed = difference(std::accumulate(all.begin(), end_of_first, 0.0)) - rounding;
  return permute_labels(
      {.first = samples.first.size(),
       .second = samples.second.size(),
       .blocks = {blocks.begin(), blocks.end()}},
      numbers, [&](std::span<const double> sums) { return difference(sums.front()) >= observed; },
      random);
}

MannWhitney mann_whitney(const TwoSamples& samples) {
  const std::vector<double> numbers = pooled(samples);
  const std::vector<std::size_t> ranks = twice_midranks(numbers);
  const std::size_t n1 = samples.first.size();
  const std::size_t observed = std::accumulate(
      ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(n1), std::size_t{0});
  MannWhitney answer;
  answer.U = 0.5 * static_cast<double>(observed) - 0.5 * static_cast<double>(n1 * (n1 + 1));
  answer.p_normal = normal_p(ranks, n1, observed);
  if (ranks.size() <= kMostRanked) {
    answer.p_exact = exact_p(ranks, n1, observed);
  }
  return answer;
}

}  // namespace asperity
