// Matching: each trial assigns several felt textures to as many images.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analysis/choices/mallows.h"
#include "analysis/choices/matching_null.h"
#include "analysis/choices/relabelled_matching.h"
#include "analysis/numbers/exact_null.h"
#include "analysis/numbers/proportion.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/tests/effect_size.h"
#include "analysis/tests/t_test.h"
#include "analysis/tests/two_samples.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

struct TidyTrial {
  std::size_t participant = 0;
  std::size_t name = 0;
  std::size_t first_item = 0;
  std::size_t items = 0;
  std::size_t right = 0;
  std::size_t chance = 0;  ///< index in `chances`
  std::size_t times = 1;   ///< how many trials it represents
  bool permutation = false;

  bool whole() const { return permutation && right == items; }
};

struct Matching {
  std::vector<std::string> labels{};  ///< felt items first, then those that were only chosen
  std::vector<std::string> participants{};
  std::vector<std::string> trial_names{};
  std::vector<std::string> groups{};  ///< by participant; empty where there is none
  std::vector<MatchedItem> matched{};
  std::vector<TidyTrial> trials{};
  /// Distributions of one trial's number correct; all different.
  std::vector<IntegerDistribution> chances{};
  std::vector<std::size_t> felt{};  ///< labels that were felt, by name
  std::size_t items = 0;            ///< of the first trial
  bool equal_size = true;
  double confidence = 0.95;

  std::size_t trials_in_all() const {
    std::size_t sum = 0;
    for (const TidyTrial& trial : trials) sum += trial.times;
    return sum;
  }
  MatchingTrial items_of(const TidyTrial& trial) const {
    return std::span(matched).subspan(trial.first_item, trial.items);
  }
};

/// Groups rows into trials, in the order of their first rows.
void read_rows(const TidyTable& table, const LabelColumn& felt, Matching& read) {
  const LabelColumn participants = table.all_labels("subject");
  const LabelColumn trials = table.all_labels("trial");
  const LabelColumn chosen = table.labels("response");
  read.participants = participants.names;
  read.trial_names = trials.names;
  std::vector<std::size_t> label_of(chosen.names.size());
  for (std::size_t i = 0; i < chosen.names.size(); ++i) {
    const auto found = std::find(read.labels.begin(), read.labels.end(), chosen.names[i]);
    label_of[i] = static_cast<std::size_t>(found - read.labels.begin());
    if (found == read.labels.end()) read.labels.push_back(chosen.names[i]);
  }
  std::unordered_map<std::size_t, std::size_t> place{};
  std::vector<std::size_t> trial_of(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t name = participants.codes[row] * trials.names.size() + trials.codes[row];
    const auto [found, first] = place.emplace(name, read.trials.size());
    if (first) {
      read.trials.push_back({.participant = participants.codes[row], .name = trials.codes[row]});
    }
    trial_of[row] = found->second;
    ++read.trials[found->second].items;
  }
  std::size_t next = 0;
  for (TidyTrial& trial : read.trials) {
    trial.first_item = next;
    next += trial.items;
    trial.items = 0;
  }
  const std::vector<std::uint64_t> times =
      table.has("times") ? table.counts("times") : std::vector<std::uint64_t>(table.rows(), 1);
  read.matched.resize(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    TidyTrial& trial = read.trials[trial_of[row]];
    MatchedItem& item = read.matched[trial.first_item + trial.items++];
    item.felt = felt.codes[row];
    if (trial.items > 1 && trial.times != times[row]) {
      table.refuse(row, "times",
                   "times is " + std::to_string(times[row]) + ", but " +
                       std::to_string(trial.times) +
                       " in the rows before it of the same trial; enter the same number in all of "
                       "them");
    }
    trial.times = times[row];
    if (chosen.codes[row] != LabelColumn::kMissing) item.chosen = label_of[chosen.codes[row]];
  }
  read.groups.resize(participants.names.size());
  if (!table.has("group")) return;
  const std::vector<std::string_view> groups = table.texts("group");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::string& group = read.groups[participants.codes[row]];
    if (group.empty()) group = groups[row];
    if (!groups[row].empty() && groups[row] != group) {
      table.refuse(row, "group",
                   participants.names[participants.codes[row]] + " is in the groups \"" + group +
                       "\" and \"" + std::string(groups[row]) +
                       "\"; enter one group for each participant");
    }
  }
}

/// Most trials have the same design: all permutations of a size.
void find_chances(Matching& read) {
  std::map<std::size_t, std::size_t> of_permutations{};  // by size
  std::map<std::vector<double>, std::size_t> of_probabilities{};
  for (TidyTrial& trial : read.trials) {
    const MatchingTrial items = read.items_of(trial);
    trial.right = fixed_points(items);
    trial.permutation = is_permutation(items);
    if (trial.permutation) {
      const auto known = of_permutations.find(trial.items);
      if (known != of_permutations.end()) {
        trial.chance = known->second;
        continue;
      }
    }
    IntegerDistribution chance = chance_matches(items);
    const auto [found, first] = of_probabilities.emplace(chance.probability, read.chances.size());
    if (first) read.chances.push_back(std::move(chance));
    trial.chance = found->second;
    if (trial.permutation) of_permutations.emplace(trial.items, trial.chance);
  }
}

Matching matching_in(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn felt = table.all_labels("stimulus");
  Matching read{.labels = felt.names};
  read.confidence = input.options.confidence();
  read_rows(table, felt, read);
  std::erase_if(read.trials, [](const TidyTrial& trial) { return trial.times == 0; });
  if (read.trials.empty())
    throw std::runtime_error(table.name() + " has no trial with times above 0; add at least one");
  find_chances(read);
  read.items = read.trials.front().items;
  read.equal_size =
      std::all_of(read.trials.begin(), read.trials.end(),
                  [&read](const TidyTrial& trial) { return trial.items == read.items; });
  for (std::size_t i = 0; i < felt.names.size(); ++i) read.felt.push_back(i);
  std::sort(read.felt.begin(), read.felt.end(),
            [&read](std::size_t a, std::size_t b) { return read.labels[a] < read.labels[b]; });
  return read;
}

/// How often each chance distribution occurs.
using Times = std::vector<std::uint64_t>;

IntegerDistribution chance_of(const Matching& read, const Times& times) {
  IntegerDistribution sum{};
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] > 0) sum = sum_of(sum, repeated_sum(read.chances[i], times[i]));
  }
  return sum;
}

IntegerDistribution chance_of_all(const Matching& read) {
  Times times(read.chances.size());
  for (const TidyTrial& trial : read.trials) times[trial.chance] += trial.times;
  return chance_of(read, times);
}

void add_fixed_points(const Matching& read, FindingList& findings) {
  for (const TidyTrial& trial : read.trials) {
    findings.count("fixed.points",
                   read.participants[trial.participant] + ':' + read.trial_names[trial.name],
                   trial.right, {.n = 1, .method = "correctly matched items"});
  }
}

void add_totals(const Matching& read, FindingList& findings) {
  const std::size_t n = read.trials_in_all();
  const IntegerDistribution chance = chance_of_all(read);
  std::size_t right = 0;
  std::size_t items = 0;
  std::size_t permutations = 0;
  std::size_t largest = 0;
  for (const TidyTrial& trial : read.trials) {
    right += trial.right * trial.times;
    items += trial.items * trial.times;
    largest = std::max(largest, trial.items);
    permutations += trial.permutation ? trial.times : 0;
  }
  const auto number = [&](const char* quantity, double value, const std::string& method) {
    findings.number(quantity, "", value, {.n = n, .method = method});
  };
  const std::string method =
      "correctly matched items of all trials, permutation null distribution of each trial's own "
      "responses";
  const auto total = static_cast<std::int64_t>(right);
  const double sd = std::sqrt(chance.variance());
  number("n.trials", static_cast<double>(n), "");
  number("n.trials.permutation", static_cast<double>(permutations),
         "trials in which every item was assigned once");
  number("total.correct", static_cast<double>(right), "");
  number("total.items", static_cast<double>(items), "");
  number("mean.correct", static_cast<double>(right) / static_cast<double>(n), "per trial");
  number("null.mean", chance.mean(), "of the total, expected under guessing");
  number("null.sd", sd, "of the total, expected under guessing");
  const CountInterval usual = central_interval(chance, read.confidence);
  const std::string holds =
      "limit of the narrowest range of totals with at least the probability conf under guessing";
  number("null.lower", static_cast<double>(usual.low), holds);
  number("null.upper", static_cast<double>(usual.high), holds);
  number("exact.p.greater", chance.upper_tail(total),
         "exact permutation test, one-sided: " + method);
  number("exact.midp.greater", chance.upper_tail(total + 1) + 0.5 * chance.at(total),
         "exact permutation test, mid-p, one-sided: " + method);
  number("exact.p.less", chance.lower_tail(total), "exact permutation test, one-sided: " + method);
  number("z", (static_cast<double>(right) - chance.mean()) / sd, method);
  for (std::size_t k = 0; k <= largest; ++k) {
    std::uint64_t trials = 0;
    for (const TidyTrial& trial : read.trials) trials += trial.right == k ? trial.times : 0;
    findings.count("trials.with.k", std::to_string(k), trials, {.n = n});
  }
  const std::vector<double> one = fixed_point_distribution(read.items);
  for (std::size_t k = 0; k < one.size(); ++k) {
    findings.number("null.pmf", "n=" + std::to_string(read.items) + ";k=" + std::to_string(k),
                    one[k], {.n = n, .method = "probability under guessing, one permutation"});
  }
  number("prop.correct", static_cast<double>(right) / static_cast<double>(items), "of all items");
}

void add_whole(const Matching& read, FindingList& findings) {
  HitCount whole{};
  for (const TidyTrial& trial : read.trials) {
    whole.trials += trial.permutation ? trial.times : 0;
    whole.hits += trial.whole() ? trial.times : 0;
  }
  Basis basis{.n = whole.trials, .method = "permutation trials with all items correct"};
  if (whole.trials > 0) {
    basis.interval = wilson_interval(whole, read.confidence);
    basis.confidence = read.confidence;
  }
  findings.count("perfect.trials", "", whole.hits, {.n = whole.trials, .method = basis.method});
  if (whole.trials == 0) return;
  const Basis wilson{.n = whole.trials,
                     .method = "permutation trials only; Wilson interval" +
                               simulated_coverage({91, 99}, {60, 96})};
  findings.number("perfect.wilson.lower", "", basis.interval->low, wilson);
  findings.number("perfect.wilson.upper", "", basis.interval->high, wilson);
  std::vector<HitCount> own(read.participants.size());
  for (const TidyTrial& trial : read.trials) {
    own[trial.participant].trials += trial.permutation ? trial.times : 0;
    own[trial.participant].hits += trial.whole() ? trial.times : 0;
  }
  std::erase_if(own, [](const HitCount& one) { return one.trials == 0; });
  add_mean_share("perfect.subj.mean", "", own,
                 "mean of the participants' own proportions of trials with all items correct",
                 {.confidence = read.confidence}, findings);
  if (!read.equal_size) return;
  findings.number(
      "perfect.p.greater", "", binomial_upper_tail(whole, whole_chance(read.items)),
      {.n = whole.trials,
       .method = "exact binomial test, one-sided against 1/" + std::to_string(read.items) + "!"});
  add_cohen_h("perfect.h", "", whole,
              {.chance = whole_chance(read.items), .confidence = read.confidence}, findings);
}

/// A permutation has at least two incorrect items: under Mallows' model with four items their
/// number has up to 2.1 times the variance of that of independent items.
constexpr double kLeastDesignEffect = 2.0;

/// Responses by felt and chosen item, both as labels.
struct ItemCounts {
  std::vector<HitCount> hits{};  ///< by felt label, permutation trials only
  std::vector<std::map<std::size_t, std::uint64_t>> trials_by_size{};  ///< the same trials
  std::vector<std::uint64_t> chosen{};  ///< felt × chosen, all trials

  explicit ItemCounts(const Matching& read)
      : hits(read.labels.size()),
        trials_by_size(read.labels.size()),
        chosen(read.labels.size() * read.labels.size()) {
    for (const TidyTrial& trial : read.trials) {
      for (const MatchedItem& item : read.items_of(trial)) {
        if (item.chosen) chosen[item.felt * read.labels.size() + *item.chosen] += trial.times;
        if (!trial.permutation) continue;
        hits[item.felt].trials += trial.times;
        hits[item.felt].hits += item.chosen == item.felt ? trial.times : 0;
        trials_by_size[item.felt][trial.items] += trial.times;
      }
    }
  }
};

/// Every participant's distributions under one relabelling of the pictures.
std::vector<RelabelledMatching> relabelled_participants(const Matching& read,
                                                        bool permutations_only) {
  std::vector<std::vector<RepeatedTrial>> trials(read.participants.size());
  for (const TidyTrial& trial : read.trials) {
    if (permutations_only && !trial.permutation) continue;
    trials[trial.participant].push_back({.items = read.items_of(trial), .times = trial.times});
  }
  std::vector<RelabelledMatching> participants{};
  for (const std::vector<RepeatedTrial>& own : trials) {
    if (!own.empty()) participants.emplace_back(own);
  }
  return participants;
}

/// A one-sided test of a count, with the participant as the unit. `quantity` ends in ".p.greater";
/// the smallest attainable p is added with the suffix ".smallest".
void add_relabelling_test(const std::string& quantity, const FindingKey& key, std::uint64_t count,
                          std::span<const IntegerDistribution> participants, const std::string& of,
                          FindingList& findings) {
  const IntegerDistribution chance = sum_of_all(participants);
  const std::string method = of +
                             ": permutation test, exact and one-sided, one relabelling of the "
                             "pictures per participant, common to the trials";
  findings.number(quantity + ".p.greater", key, chance.upper_tail(static_cast<std::int64_t>(count)),
                  {.n = participants.size(), .method = method});
  findings.number(quantity + ".smallest", key, chance.smallest_upper_tail(),
                  {.n = participants.size(), .method = "smallest attainable p; " + method});
}

/// The number of correct items of all participants.
void add_relabelled_items(const Matching& read, FindingList& findings) {
  std::uint64_t right = 0;
  for (const TidyTrial& trial : read.trials) right += trial.right * trial.times;
  std::vector<IntegerDistribution> own{};
  for (const RelabelledMatching& one : relabelled_participants(read, false)) {
    own.push_back(one.right());
  }
  add_relabelling_test("relabel", "", right, own, "correctly matched items", findings);
  const IntegerDistribution chance = sum_of_all(own);
  const CountInterval usual = central_interval(chance, read.confidence);
  const Basis basis{
      .n = own.size(),
      .method =
          "limit of the narrowest range of totals with at least the probability conf in the "
          "permutation distribution, one relabelling per participant"};
  findings.count("relabel.null.lower", "", usual.low, basis);
  findings.count("relabel.null.upper", "", usual.high, basis);
  findings.number(
      "relabel.z", "", (static_cast<double>(right) - chance.mean()) / std::sqrt(chance.variance()),
      {.n = own.size(),
       .method = "correctly matched items, standardised by the permutation distribution "
                 "with one relabelling per participant"});
}

/// Trials with all items correct, and the responses to each felt item.
void add_relabelled_permutations(const Matching& read, FindingList& findings) {
  const std::vector<RelabelledMatching> participants = relabelled_participants(read, true);
  if (participants.empty()) return;
  std::uint64_t whole = 0;
  std::map<std::size_t, std::uint64_t> hits{};
  for (const TidyTrial& trial : read.trials) {
    if (!trial.permutation) continue;
    whole += trial.whole() ? trial.times : 0;
    for (const MatchedItem& item : read.items_of(trial)) {
      hits[item.felt] += item.chosen == item.felt ? trial.times : 0;
    }
  }
  std::vector<IntegerDistribution> own{};
  for (const RelabelledMatching& one : participants) {
    if (one.whole()) own.push_back(*one.whole());
  }
  if (own.size() == participants.size()) {
    add_relabelling_test("perfect.relabel", "", whole, own, "trials with all items correct",
                         findings);
  } else {
    findings.word("perfect.relabel.p.greater", "", "not_testable",
                  "trials of a participant share some but not all items, so that no relabelling of "
                  "the pictures exchanges all items of a trial: use the results of single items "
                  "(texture.relabel)",
                  {.n = participants.size()});
  }
  for (const std::size_t label : read.felt) {
    own.clear();
    for (const RelabelledMatching& one : participants) {
      if (one.presents(label)) own.push_back(one.right_of(label));
    }
    if (own.empty()) continue;
    add_relabelling_test("texture.relabel", read.labels[label], hits[label], own,
                         "correct responses to this item", findings);
  }
}

/// Single textures. In trials of different sizes the chance levels differ, and the number of hits
/// expected by chance is a sum of unequal Bernoulli variables.
void add_textures(const Matching& read, FindingList& findings) {
  const ItemCounts counts(read);
  for (const std::size_t label : read.felt) {
    const HitCount& count = counts.hits[label];
    if (count.trials == 0) continue;
    const std::string& name = read.labels[label];
    findings.count("texture.hits", name, count.hits,
                   {.n = count.trials, .method = "permutation trials only"});
    findings.number("texture.prop", name, proportion(count),
                    {.n = count.trials,
                     .method = "permutation trials only; Wilson interval",
                     .interval = wilson_interval(count, read.confidence),
                     .confidence = read.confidence});
    IntegerDistribution chance{};
    for (const auto& [size, trials] : counts.trials_by_size[label]) {
      if (read.equal_size) break;
      const double p = item_chance(size);
      chance = sum_of(chance, repeated_sum({.lowest = 0, .probability = {1.0 - p, p}}, trials));
    }
    const double p = read.equal_size ? binomial_upper_tail(count, item_chance(read.items))
                                     : chance.upper_tail(static_cast<std::int64_t>(count.hits));
    findings.number("texture.p.greater", name, p,
                    {.n = count.trials,
                     .method = "exact test of the correct matches, one-sided against 1 divided by "
                               "the number of items in the trial; the tests of "
                               "different textures are not independent"});
    if (!read.equal_size) continue;
    add_cohen_h("texture.h", name, count,
                {.chance = item_chance(read.items), .confidence = read.confidence}, findings);
  }
  for (const std::size_t felt : read.felt) {
    for (const std::size_t chosen : read.felt) {
      findings.count("confusion", {read.labels[felt], read.labels[chosen]},
                     counts.chosen[felt * read.labels.size() + chosen],
                     {.n = read.trials_in_all(), .method = "stimulus | response, all trials"});
    }
  }
}

void add_mallows(const Matching& read, FindingList& findings) {
  std::vector<std::size_t> right{};
  for (const TidyTrial& trial : read.trials) {
    if (trial.permutation && trial.items == read.items) {
      right.insert(right.end(), trial.times, trial.right);
    }
  }
  if (right.empty()) return;
  Basis basis{.n = right.size(),
              .method = "Mallows' model with Hamming distance; 0 under guessing"};
  findings.count("mallows.n", "", right.size(), basis);
  const MallowsFit fit = mallows_fit(right, read.items, read.confidence);
  Basis with_interval = basis;
  if (fit.finite) {
    with_interval.interval = fit.finite->interval;
    with_interval.confidence = read.confidence;
  }
  findings.number("mallows.theta", "", fit.theta, with_interval);
  if (!fit.finite) return;
  findings.number("mallows.se", "", fit.finite->standard_error, basis);
  findings.number("mallows.lr", "", fit.finite->likelihood_ratio, basis);
  findings.number("mallows.ci.lower", "", fit.finite->interval.low, basis);
  findings.number("mallows.ci.upper", "", fit.finite->interval.high, basis);
}

/// The mean of one group: correctly matched items per trial.
void add_group_mean(const Matching& read, const std::string& group, std::span<const double> means,
                    std::span<const HitCount> own, const GroupScale& scale, FindingList& findings) {
  if (!read.equal_size) {
    add_mean_of_group("group.mean", group, means, scale, findings);
    return;
  }
  Basis basis{.n = means.size(),
              .method = scale.of + "; t interval on the logit scale of the proportions",
              .interval = mean_share_interval(own, {.confidence = scale.confidence,
                                                    .least_design_effect = kLeastDesignEffect})};
  if (basis.interval) {
    basis.interval->low *= static_cast<double>(read.items);
    basis.interval->high *= static_cast<double>(read.items);
    basis.confidence = scale.confidence;
  }
  findings.number("group.mean", group, one_sample_t(means).mean, basis);
}

/// `means`: correct items per trial, by participant; `own` over all items.
void add_groups(const Matching& read, const std::vector<double>& means,
                std::span<const HitCount> own, FindingList& findings) {
  const std::set<std::string> groups(read.groups.begin(), read.groups.end());
  std::vector<std::string> names(groups.begin(), groups.end());
  std::erase(names, "");
  if (names.size() != 2) return;
  std::vector<double> first{};
  std::vector<double> second{};
  std::array<std::vector<HitCount>, 2> own_of{};
  for (std::size_t person = 0; person < means.size(); ++person) {
    if (read.groups[person] == names[0]) first.push_back(means[person]);
    if (read.groups[person] == names[1]) second.push_back(means[person]);
    for (std::size_t group = 0; group < 2; ++group) {
      if (read.groups[person] == names[group]) own_of[group].push_back(own[person]);
    }
  }
  const TwoSamples samples{.first = first, .second = second};
  const FindingKey key = names[0] + '-' + names[1];
  std::size_t most = 0;  // items of a trial, the maximum of a participant's mean
  for (const TidyTrial& trial : read.trials) most = std::max(most, trial.items);
  const GroupScale scale{
      .confidence = read.confidence,
      .possible = ConfidenceInterval{.low = 0.0, .high = static_cast<double>(most)}};
  add_group_mean(read, names[0], first, own_of[0], scale, findings);
  add_group_mean(read, names[1], second, own_of[1], scale, findings);
  add_difference_of_means("group.diff", key, samples, scale, findings);
  const SplitTest test = permutation_test(samples);
  findings.number("group.perm.p.two", key, test.p,
                  {.n = first.size() + second.size(),
                   .method = "permutation test of the group labels, two-sided, " +
                             way_of_counting(test.exact ? 0 : kRandomSplits)});
  add_splits("group.perm", key, test, first.size() + second.size(), findings);
  if (const std::optional<WelchT> welch = welch_t(samples, read.confidence)) {
    Basis effect{
        .n = first.size() + second.size(),
        .method =
            "Hedges' g of the participants' means; interval from the noncentral t distribution",
        .interval = bias_corrected(
            *welch, standardised_difference_interval(*welch, samples, read.confidence))};
    if (effect.interval) effect.confidence = read.confidence;
    findings.number("group.hedges.g", key, welch->g, effect);
  }
}

/// The proportion of correct items with the participant as the unit.
void add_shares_of_participants(std::span<const HitCount> own, double confidence,
                                FindingList& findings) {
  std::vector<double> shares{};
  for (const HitCount& count : own) shares.push_back(proportion(count));
  const OneSampleT t = one_sample_t(shares, {.confidence = confidence});
  add_mean_share("subj.mean", "", own,
                 "mean of the participants' own proportions of correctly matched items",
                 {.confidence = confidence, .least_design_effect = kLeastDesignEffect}, findings);
  findings.number("subj.sd", "", t.sd.value_or(std::numeric_limits<double>::quiet_NaN()),
                  {.n = t.n,
                   .method = "of the participants' proportions",
                   .undefined = "differences between participants cannot be estimated from one "
                                "participant: add participants"});
  add_spread("", shares, findings);
}

void add_participants(const Matching& read, FindingList& findings) {
  std::vector<HitCount> own(read.participants.size());
  std::vector<std::size_t> trials(read.participants.size());
  std::vector<Times> times(read.participants.size(), Times(read.chances.size()));
  for (const TidyTrial& trial : read.trials) {
    own[trial.participant].hits += trial.right * trial.times;
    own[trial.participant].trials += trial.items * trial.times;
    trials[trial.participant] += trial.times;
    times[trial.participant][trial.chance] += trial.times;
  }
  std::vector<double> means{};
  for (std::size_t person = 0; person < own.size(); ++person) {
    means.push_back(static_cast<double>(own[person].hits) / static_cast<double>(trials[person]));
    findings.number("subject.mean", read.participants[person], means.back(),
                    {.n = 1, .method = "correctly matched items per trial"});
    findings.number("subject.share", read.participants[person], proportion(own[person]),
                    {.n = 1, .method = "proportion of a participant's correctly matched items"});
  }
  std::map<Times, IntegerDistribution> chances{};  // most participants have the same trials
  for (std::size_t person = 0; person < own.size(); ++person) {
    const auto [chance, is_new] = chances.try_emplace(times[person]);
    if (is_new) chance->second = chance_of(read, times[person]);
    findings.number(
        "subject.p.greater", read.participants[person],
        chance->second.upper_tail(static_cast<std::int64_t>(own[person].hits)),
        {.n = trials[person], .method = "exact permutation test of the responses, one-sided"});
  }
  add_shares_of_participants(own, read.confidence, findings);
  add_groups(read, means, own, findings);
}

}  // namespace

std::vector<Finding> matching_findings(const TidyInput& input) {
  const Matching read = matching_in(input);
  const std::string parts = input.options.text_or("parts", "all");
  if (parts != "all" && parts != "summary" && parts != "totals") {
    throw std::runtime_error(
        "the option \"parts\" is \"" + parts +
        "\"; it must be all, summary (without numbers of single trials) or totals");
  }
  FindingList findings{};
  if (parts == "all") add_fixed_points(read, findings);
  add_totals(read, findings);
  add_relabelled_items(read, findings);
  if (parts == "totals") return findings.take();
  add_whole(read, findings);
  add_textures(read, findings);
  add_relabelled_permutations(read, findings);
  add_mallows(read, findings);
  add_participants(read, findings);
  return findings.take();
}

}  // namespace asperity
