// Enumerates the divisions recursively with the sums of the first group, from which those of the second follow.

#include "analysis/tests/profile_comparison.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "analysis/tests/two_samples.h"

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
    sums_.assign(size_ + 1, std::vector<double>(mean.size(), 0.0));
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
  bool is_exact() const { return all_.size() <= kMostPermuted; }

  double exact_p() {
    choose(0, 0);
    return as_far_ / ways_;
  }
  double random_p(Random& random) {
    std::size_t as_far = 1;
    for (std::size_t i = 0; i < kRandomSplits; ++i) {
      // The first places of a shuffle, which is all that a division needs.
      for (std::size_t place = 0; place < size_; ++place) {
        std::swap(all_[place], all_[place + random.below(all_.size() - place)]);
      }
      as_far += is_as_far(squares_of_first()) ? 1 : 0;
    }
    return static_cast<double>(as_far) / static_cast<double>(kRandomSplits + 1);
  }

 private:
  static double squares(const std::vector<double>& sums) {
    return std::inner_product(sums.begin(), sums.end(), sums.begin(), 0.0);
  }
  double squares_of_first() const {
    std::vector<double> sums(all_.front().size(), 0.0);
    for (std::size_t i = 0; i < size_; ++i) add_to(sums, all_[i]);
    return squares(sums);
  }
  bool is_as_far(double of_division) const { return of_division >= observed_ - rounding_; }

  /// Every first group that contains `chosen` of the participants before `next`, whose sums are sums_[chosen].
  void choose(std::size_t next, std::size_t chosen) {
    if (chosen == size_) {
      ways_ += 1.0;
      as_far_ += is_as_far(squares(sums_[chosen])) ? 1.0 : 0.0;
      return;
    }
    for (std::size_t i = next; i + (size_ - chosen) <= all_.size(); ++i) {
      sums_[chosen + 1] = sums_[chosen];
      add_to(sums_[chosen + 1], all_[i]);
      choose(i + 1, chosen + 1);
    }
  }

  std::size_t size_ = 0;  ///< of the first group
  std::vector<std::vector<double>> all_{};
  std::vector<std::vector<double>> sums_{};  ///< by the number of participants chosen
  double total_ = 0.0;
  bool are_equal_ = false;
  double observed_ = 0.0;
  double rounding_ = 0.0;
  double as_far_ = 0.0;
  double ways_ = 0.0;
};

}  // namespace

std::vector<double> centred(std::vector<double> profile) {
  const double mean = sum_of(profile) / static_cast<double>(profile.size());
  for (double& number : profile) number -= mean;
  return profile;
}

ProfileComparison compare_profiles(Profiles first, Profiles second, Random random) {
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
  Divisions divisions(first, second);
  ProfileComparison compared{.r2 = divisions.r2(), .exact = divisions.is_exact()};
  if (std::isnan(compared.r2)) return compared;
  compared.p = compared.exact ? divisions.exact_p() : divisions.random_p(random);
  return compared;
}

double smallest_p_of_groups(std::size_t first, std::size_t second) noexcept {
  if (first == 0 || second == 0) return 1.0;
  if (first + second > kMostPermuted) return 1.0 / static_cast<double>(kRandomSplits + 1);
  double ways = 1.0;  // binomial coefficient, exact for up to kMostPermuted
  for (std::size_t i = 1; i <= first; ++i) {
    ways = ways * static_cast<double>(second + i) / static_cast<double>(i);
  }
  return (first == second ? 2.0 : 1.0) / ways;
}

}  // namespace asperity
