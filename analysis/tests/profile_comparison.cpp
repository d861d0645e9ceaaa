// R² of a division from the sums of the first group, from which those of the second follow.

#include "analysis/tests/profile_comparison.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "analysis/tests/label_permutations.h"

namespace asperity {
namespace {

double sum_of(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

void add_to(std::vector<double>& sums, const std::vector<double>& profile) {
  for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += profile[j];
}

/// The profiles of all participants around their mean, so that the sums of the two groups are the negative of each other: with
/// the sums sⱼ of the first group, m₁ⱼ − m₂ⱼ = sⱼ/n₁ + sⱼ/n₂, and the sum of squares between the groups is
/// n₁n₂/(n₁ + n₂)·Σⱼ(sⱼ·(n₁ + n₂)/(n₁n₂))² = (n₁ + n₂)/(n₁n₂)·Σⱼsⱼ². For given sizes, divisions are ordered by Σⱼsⱼ².
class Divisions final {
 public:
  Divisions(Profiles first, Profiles second) : size_(first.size()) {
    double raw = 0.0;
    for (const Profiles group : {first, second}) {
      for (const std::vector<double>& profile : group) {
        raw += squares(profile);
        all_.push_back(centred(profile));
      }
    }
    std::vector<double> mean(all_.front().size(), 0.0);
    for (const auto& profile : all_) add_to(mean, profile);
    for (auto& profile : all_) {
      for (std::size_t j = 0; j < profile.size(); ++j) {
        profile[j] -= mean[j] / static_cast<double>(all_.size());
        total_ += profile[j] * profile[j];
      }
    }
    observed_ = squares_of_first();
    // Two divisions are equal if they would be without rounding. A sum s of N deviations of numbers x is off by at most δ ≤ N·ε·Σ|x|,
    // so that Σs² is off by 2·Σ|s|δ, and by the inequality of Cauchy and Schwarz by no more than 2·N²·ε·√(total·Σx²).
    const auto participants = static_cast<double>(all_.size());
    const double relative = 2.0 * participants * std::numeric_limits<double>::epsilon();
    rounding_ = 2.0 * participants * relative * (total_ + std::sqrt(total_ * raw));
    // Equal profiles differ from their mean by such a part of their numbers.
    are_equal_ = total_ <= relative * relative * raw;
  }

  double r2() const {
    const auto n1 = static_cast<double>(size_);
    const auto n2 = static_cast<double>(all_.size() - size_);
    return are_equal_ ? std::numeric_limits<double>::quiet_NaN()
                      : (n1 + n2) / (n1 * n2) * observed_ / total_;
  }
  SplitTest p(std::span<const std::size_t> blocks, const Random& random) const {
    return permute_labels(
        {.first = size_, .second = all_.size() - size_, .blocks = {blocks.begin(), blocks.end()}},
        all_,
        [this](std::span<const double> sums) { return squares(sums) >= observed_ - rounding_; },
        random);
  }

 private:
  static double squares(std::span<const double> sums) {
    return std::inner_product(sums.begin(), sums.end(), sums.begin(), 0.0);
  }
  double squares_of_first() const {
    std::vector<double> sums(all_.front().size(), 0.0);
    for (std::size_t i = 0; i < size_; ++i) add_to(sums, all_[i]);
    return squares(sums);
  }
  std::size_t size_ = 0;  ///< of the first group
  std::vector<std::vector<double>> all_{};
  double total_ = 0.0;
  bool are_equal_ = false;
  double observed_ = 0.0;
  double rounding_ = 0.0;
};

}  // namespace

std::vector<double> centred(std::vector<double> profile) {
  const double mean = sum_of(profile) / static_cast<double>(profile.size());
  for (double& number : profile) number -= mean;
  return profile;
}

ProfileComparison compare_profiles(Profiles first, Profiles second,
                                   std::span<const std::size_t> blocks, Random random) {
  if (first.empty() || second.empty()) {
    throw std::invalid_argument("a group is empty; each group needs at least one participant");
  }
  const std::size_t numbers = first.front().size();
  for (const Profiles group : {first, second}) {
    for (const std::vector<double>& profile : group) {
      if (profile.size() != numbers || numbers < 2) {
        throw std::invalid_argument(
            "profiles must have the same length, which is at least two numbers");
      }
    }
  }
  const Divisions divisions(first, second);
  const double r2 = divisions.r2();
  if (std::isnan(r2)) return {.r2 = r2};
  const SplitTest test = divisions.p(blocks, random);
  return {.r2 = r2, .p = test.p, .exact = test.exact};
}

}  // namespace asperity
