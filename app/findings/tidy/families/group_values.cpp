// Compares two groups of participants in a number of each participant, or in the profiles of their numbers over items.

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/tests/effect_size.h"
#include "analysis/tests/geometric_mean.h"
#include "analysis/tests/profile_comparison.h"
#include "analysis/tests/t_test.h"
#include "analysis/tests/two_samples.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/repeated_rows.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"
#include "app/findings/tidy/two_groups.h"

namespace asperity {
namespace {

/// Whether the geometric means are compared by their ratio.
bool compares_ratio(const FamilyOptions& options) {
  const std::string scale = options.text_or("scale", "difference");
  if (scale == "ratio") return true;
  if (scale == "difference") return false;
  throw std::runtime_error("the option \"scale\" must be \"difference\" or \"ratio\", not \"" +
                           scale + "\"; enter one of these");
}

/// One of the two groups; `missing`: its participants without a number.
struct GroupOfValues {
  std::string name{};
  std::vector<double> values{};
  std::vector<std::size_t> blocks{};  ///< of each of `values`; empty without blocks
  std::size_t missing = 0;
};

/// A number of each participant. Numbers that are compared as a ratio are positive.
class ValueComparison final {
 public:
  ValueComparison(GroupOfValues first, GroupOfValues second, bool is_ratio, double confidence)
      : groups_{std::move(first), std::move(second)},
        is_ratio_(is_ratio),
        confidence_(confidence) {}

  std::vector<Finding> findings() {
    for (const GroupOfValues& group : groups_) {
      list_.count("values.missing", group.name, group.missing,
                  {.n = group.values.size() + group.missing,
                   .method = "participants without a number, who are left out"});
    }
    for (const GroupOfValues& group : groups_) {
      if (group.values.empty()) {
        list_.word("values.status", group.name, "no_data",
                   "no participant of this group has a number, so that no comparison is possible: "
                   "add participants",
                   {});
        return list_.take();
      }
    }
    for (const GroupOfValues& group : groups_) mean_of(group);
    difference();
    return list_.take();
  }

 private:
  std::size_t n() const { return groups_[0].values.size() + groups_[1].values.size(); }
  bool is_complete() const { return groups_[0].missing + groups_[1].missing == 0; }
  Basis basis(std::string method, std::optional<ConfidenceInterval> interval = {}) const {
    Basis made{.n = n(), .method = std::move(method)};
    with_interval(made, interval, is_complete());
    return made;
  }
  /// Those without a number lie mostly on one side, so that an interval of the others describes the others.
  void with_interval(Basis& basis, const std::optional<ConfidenceInterval>& interval,
                     bool is_of_all) const {
    if (!is_of_all) {
      basis.method += "; without an interval, because participants without a number are left out";
    } else if (interval) {
      basis.interval = interval;
      basis.confidence = confidence_;
    }
  }
  /// On the scale on which groups are compared.
  std::vector<double> scaled(const std::vector<double>& values) const {
    std::vector<double> numbers = values;
    if (is_ratio_) {
      for (double& number : numbers) number = std::log(number);
    }
    return numbers;
  }

  void mean_of(const GroupOfValues& group) {
    const std::size_t size = group.values.size();
    if (is_ratio_) {
      const GeometricMean mean = geometric_mean(group.values, confidence_);
      Basis made{.n = size,
                 .method =
                     "geometric mean of the group's participants; t interval on "
                     "the log scale"};
      with_interval(made, mean.interval, group.missing == 0);
      list_.number("values.mean", group.name, mean.mean, made);
      return;
    }
    const OneSampleT t = one_sample_t(group.values, {.confidence = confidence_});
    Basis made{.n = size, .method = "mean of the group's participants; t interval"};
    with_interval(made, t.test ? std::optional(t.test->interval) : std::nullopt,
                  group.missing == 0);
    list_.number("values.mean", group.name, t.mean, made);
  }

  void difference() {
    const std::vector<double> first = scaled(groups_[0].values);
    const std::vector<double> second = scaled(groups_[1].values);
    const TwoSamples samples{.first = first, .second = second};
    const std::optional<WelchT> welch = welch_t(samples, confidence_);
    const double shift = one_sample_t(first).mean - one_sample_t(second).mean;
    const auto interval = welch ? std::optional(welch->interval) : std::nullopt;
    const std::string coverage =
        welch && is_complete() ? simulated_coverage({95, 98}) : std::string();
    if (is_ratio_) {
      list_.number("values.shift", "", shift,
                   basis("difference of the mean natural logarithms, first − second"));
      list_.number(
          "values.ratio", "", std::exp(shift),
          basis("ratio of the geometric means, first / second; Welch's interval of the "
                "difference of the logarithms" +
                    coverage,
                interval ? std::optional(ConfidenceInterval{.low = std::exp(interval->low),
                                                            .high = std::exp(interval->high)})
                         : std::nullopt));
    } else {
      list_.number(
          "values.shift", "", shift,
          basis("difference of the means, first − second; Welch's interval" + coverage, interval));
    }
    if (welch) {
      list_.number("values.welch.t", "", welch->t, basis("Welch's t over participants"));
      list_.number("values.welch.df", "", welch->df, basis("Welch's degrees of freedom"));
      list_.number("values.welch.p.two", "", welch->p, basis("Welch's t test, two-sided"));
      const auto limits = standardised_difference_interval(*welch, samples, confidence_);
      list_.number("values.hedges.g", "", welch->g,
                   basis(std::string("Hedges' g") + (is_ratio_ ? " of the logarithms" : "") +
                             "; interval from the noncentral t distribution",
                         bias_corrected(*welch, limits)));
    } else {
      list_.word(
          "values.welch.t", "", "undefined_zero_variance",
          "a group has a single participant, or all participants of each group have the same "
          "number, so that t is undefined: add participants",
          basis("Welch's t over participants"));
    }
    const std::vector<std::size_t> blocks = joined(groups_[0].blocks, groups_[1].blocks);
    const SplitTest splits = permutation_test(samples, blocks);
    list_.number(is_ratio_ ? "values.log.perm.p.two" : "values.perm.p.two", "", splits.p,
                 basis(std::string("permutation test of the group labels, difference of the mean") +
                       (is_ratio_ ? " logarithms, " : "s, ") + way_of_splits(splits, blocks)));
    add_splits("values.perm", "", splits, n(), list_);
    list_.number(
        "values.perm.smallest", "",
        smallest_p_of_groups({.first = first.size(), .second = second.size(), .blocks = blocks}),
        basis("smallest p of groups of these sizes"));
  }

  std::array<GroupOfValues, 2> groups_{};
  bool is_ratio_ = false;
  double confidence_ = 0.95;
  FindingList list_{};
};

std::vector<Finding> values_compared(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn groups = two_groups(input);
  refuse_repeated(table, "subject", "one row per participant, with one group");
  const bool is_ratio = compares_ratio(input.options);
  const std::vector<std::size_t> blocks = blocks_in(table);
  const std::vector<std::optional<double>> values = table.numbers("value");
  std::array<GroupOfValues, 2> read{GroupOfValues{.name = groups.names[0]},
                                    GroupOfValues{.name = groups.names[1]}};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    GroupOfValues& group = read[groups.codes[row] == 0 ? 0 : 1];
    if (!values[row]) {
      ++group.missing;
      continue;
    }
    if (is_ratio && *values[row] <= 0.0) {
      table.refuse(row, "value",
                   "a number that is compared as a ratio must be above 0: correct it, leave the "
                   "cell empty, or set the option \"scale\" to \"difference\"");
    }
    group.values.push_back(*values[row]);
    if (!blocks.empty()) group.blocks.push_back(blocks[row]);
  }
  return ValueComparison(std::move(read[0]), std::move(read[1]), is_ratio,
                         input.options.confidence())
      .findings();
}

// --- profiles --------------------------------------------------------------------------------------

struct GroupOfProfiles {
  std::string name{};
  std::vector<std::vector<double>> profiles{};  ///< centred
  std::vector<std::size_t> blocks{};            ///< of each of `profiles`; empty without blocks

  std::vector<double> of_item(std::size_t item) const {
    std::vector<double> numbers{};
    for (const auto& profile : profiles) numbers.push_back(profile[item]);
    return numbers;
  }
};

std::vector<Finding> profiles_of(const std::array<GroupOfProfiles, 2>& groups,
                                 const std::vector<std::string>& items, std::size_t incomplete,
                                 double confidence) {
  FindingList list{};
  const std::size_t n = groups[0].profiles.size() + groups[1].profiles.size();
  list.count("profile.incomplete", "", incomplete,
             {.n = n + incomplete,
              .method = "participants without a number for every item, who are left out"});
  for (const GroupOfProfiles& group : groups) {
    if (!group.profiles.empty() && items.size() > 1) continue;
    list.word("profile.status", group.name, items.size() > 1 ? "no_data" : "one_item",
              items.size() > 1
                  ? "no participant of this group has a number for every item, so that no "
                    "comparison is possible: add participants"
                  : "a profile needs at least two items: add items",
              {});
    return list.take();
  }
  const GroupScale scale{.confidence = confidence,
                         .of = "mean of the group's participants, without each one's own mean",
                         .coverage_of_difference = simulated_coverage({94, 98})};
  for (std::size_t item = 0; item < items.size(); ++item) {
    const std::vector<double> first = groups[0].of_item(item);
    const std::vector<double> second = groups[1].of_item(item);
    add_mean_of_group("profile.mean", {groups[0].name, items[item]}, first, scale, list);
    add_mean_of_group("profile.mean", {groups[1].name, items[item]}, second, scale, list);
    add_difference_of_means("profile.diff", items[item], {.first = first, .second = second}, scale,
                            list);
  }
  const std::vector<std::size_t> blocks = joined(groups[0].blocks, groups[1].blocks);
  const ProfileComparison compared =
      compare_profiles(groups[0].profiles, groups[1].profiles, blocks);
  Basis basis{.n = n,
              .method =
                  "proportion of the sum of squares of the profiles, without each "
                  "participant's own mean, that is between the groups",
              .undefined = "all participants have the same profile: add participants"};
  list.number("profile.r2", "", compared.r2, basis);
  const SplitTest splits{.p = compared.p, .exact = compared.exact};
  basis.method =
      "permutation test of the group labels of whole profiles, " + way_of_splits(splits, blocks);
  list.number("profile.perm.p", "", std::isnan(compared.r2) ? kUndefined : compared.p, basis);
  add_splits("profile.perm", "", splits, n, list);
  list.number("profile.perm.smallest", "",
              smallest_p_of_groups({.first = groups[0].profiles.size(),
                                    .second = groups[1].profiles.size(),
                                    .blocks = blocks}),
              {.n = n, .method = "smallest p of groups of these sizes"});
  std::vector<Finding> findings = list.take();
  // As with single numbers: the others are not all.
  if (incomplete > 0) {
    drop_intervals(findings, [](const Finding&) {
      return std::optional<std::string>(
          "without an interval, because participants without a number for every item are left out");
    });
  }
  return findings;
}

std::vector<Finding> profiles_compared(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn groups = two_groups(input);
  const LabelColumn subjects = table.all_labels("subject");
  const LabelColumn items = table.all_labels("item");
  const std::vector<std::optional<double>> values = table.numbers("value");
  const std::vector<std::size_t> blocks = blocks_in(table);
  struct Participant {
    bool is_second = false;
    std::vector<std::optional<double>> numbers{};
    std::size_t block = 0;
  };
  std::map<std::size_t, Participant> participants{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool is_second = groups.codes[row] == 1;
    const auto [place, is_new] = participants.try_emplace(
        subjects.codes[row],
        Participant{is_second, std::vector<std::optional<double>>(items.names.size())});
    Participant& own = place->second;
    if (own.is_second != is_second) {
      table.refuse(row, "group", "the participant is in two groups; enter the same in every row");
    }
    if (own.numbers[items.codes[row]]) {
      table.refuse(row, "item", "the participant has two rows of this item; enter their mean");
    }
    own.numbers[items.codes[row]] = values[row];
    if (!blocks.empty()) own.block = blocks[row];
  }
  std::array<GroupOfProfiles, 2> read{GroupOfProfiles{.name = groups.names[0]},
                                      GroupOfProfiles{.name = groups.names[1]}};
  std::size_t incomplete = 0;
  for (const auto& [code, own] : participants) {
    std::vector<double> profile{};
    for (const std::optional<double>& number : own.numbers) {
      if (number) profile.push_back(*number);
    }
    if (profile.size() < own.numbers.size()) {
      ++incomplete;
    } else {
      GroupOfProfiles& group = read[own.is_second ? 1 : 0];
      group.profiles.push_back(centred(std::move(profile)));
      if (!blocks.empty()) group.blocks.push_back(own.block);
    }
  }
  return profiles_of(read, items.names, incomplete, input.options.confidence());
}

}  // namespace

std::vector<Finding> group_values_findings(const TidyInput& input) {
  return input.table().has("item") ? profiles_compared(input) : values_compared(input);
}

}  // namespace asperity
