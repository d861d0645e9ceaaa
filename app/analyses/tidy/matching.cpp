// Each trial assigns several felt textures to as many images.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/exact_null.h"
#include "analysis/mallows.h"
#include "analysis/matching_null.h"
#include "analysis/proportion.h"
#include "analysis/tail_probabilities.h"
#include "analysis/two_samples.h"
#include "app/analyses/tidy/finding_list.h"
#include "app/analyses/tidy/tidy_families.h"

namespace asperity {
namespace {

struct Trial {
  std::string name{};  ///< participant:trial
  std::size_t participant = 0;
  std::vector<MatchedItem> items{};
  std::size_t right = 0;
  bool permutation = false;
  IntegerDistribution chance{};

  bool whole() const { return permutation && right == items.size(); }
};

struct Matching {
  std::vector<std::string> labels{};  ///< felt first, then what was only chosen
  std::vector<std::string> participants{};
  std::vector<std::string> groups{};  ///< by participant; empty where there is none
  std::vector<Trial> trials{};
  std::vector<std::size_t> felt{};  ///< labels that were felt, by name
  std::size_t items = 0;            ///< of the first trial
  bool equal_size = true;
  double confidence = 0.95;
};

Matching matching_in(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const LabelColumn trials = table.all_labels("trial");
  const LabelColumn felt = table.all_labels("stimulus");
  const LabelColumn chosen = table.labels("response");
  const std::vector<std::string_view> groups =
      table.has("group") ? table.texts("group") : std::vector<std::string_view>(table.rows());
  Matching read{.labels = felt.names, .participants = participants.names};
  read.confidence = input.options.confidence();
  read.groups.resize(participants.names.size());
  std::vector<std::size_t> label_of(chosen.names.size());
  for (std::size_t i = 0; i < chosen.names.size(); ++i) {
    const auto found = std::find(read.labels.begin(), read.labels.end(), chosen.names[i]);
    label_of[i] = static_cast<std::size_t>(found - read.labels.begin());
    if (found == read.labels.end()) read.labels.push_back(chosen.names[i]);
  }
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> place{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t participant = participants.codes[row];
    const auto [found, first] =
        place.emplace(std::pair{participant, trials.codes[row]}, read.trials.size());
    if (first) {
      read.trials.push_back(
          {.name = participants.names[participant] + ':' + trials.names[trials.codes[row]],
           .participant = participant});
    }
    MatchedItem item{.felt = felt.codes[row]};
    if (chosen.codes[row] != LabelColumn::kMissing) item.chosen = label_of[chosen.codes[row]];
    read.trials[found->second].items.push_back(item);
    if (read.groups[participant].empty()) read.groups[participant] = groups[row];
  }
  if (read.trials.empty()) throw std::runtime_error(table.name() + " has no row: no trial");
  for (Trial& trial : read.trials) {
    trial.right = fixed_points(trial.items);
    trial.permutation = is_permutation(trial.items);
    trial.chance = chance_matches(trial.items);
  }
  read.items = read.trials.front().items.size();
  read.equal_size =
      std::all_of(read.trials.begin(), read.trials.end(),
                  [&read](const Trial& trial) { return trial.items.size() == read.items; });
  for (std::size_t i = 0; i < felt.names.size(); ++i) read.felt.push_back(i);
  std::sort(read.felt.begin(), read.felt.end(),
            [&read](std::size_t a, std::size_t b) { return read.labels[a] < read.labels[b]; });
  return read;
}

/// Most trials are dealt alike, and equal ones add up by squares.
IntegerDistribution chance_of_all(const std::vector<Trial>& trials) {
  std::map<std::vector<double>, std::uint64_t> alike{};
  for (const Trial& trial : trials) ++alike[trial.chance.probability];
  IntegerDistribution sum{};
  for (const auto& [probability, times] : alike) {
    sum = sum_of(sum, repeated_sum({.lowest = 0, .probability = probability}, times));
  }
  return sum;
}

void add_totals(const Matching& read, FindingList& findings) {
  const std::size_t n = read.trials.size();
  const IntegerDistribution chance = chance_of_all(read.trials);
  std::size_t right = 0;
  std::size_t items = 0;
  std::size_t permutations = 0;
  std::size_t largest = 0;
  for (const Trial& trial : read.trials) {
    findings.count("fixed.points", trial.name, trial.right, {.n = 1, .method = "right items"});
    right += trial.right;
    items += trial.items.size();
    largest = std::max(largest, trial.items.size());
    permutations += trial.permutation ? 1 : 0;
  }
  const auto number = [&](const char* quantity, double value, const std::string& method) {
    findings.number(quantity, "", value, {.n = n, .method = method});
  };
  const std::string method =
      "right items of all trials against random orders of each trial's own answers";
  const auto total = static_cast<std::int64_t>(right);
  const double sd = std::sqrt(chance.variance());
  number("n.trials", static_cast<double>(n), "");
  number("n.trials.permutation", static_cast<double>(permutations),
         "trials in which every item was assigned once");
  number("total.correct", static_cast<double>(right), "");
  number("mean.correct", static_cast<double>(right) / static_cast<double>(n), "per trial");
  number("null.mean", chance.mean(), "of the total, by chance");
  number("null.sd", sd, "of the total, by chance");
  number("exact.p.greater", chance.upper_tail(total), "exact, one-sided: " + method);
  number("exact.midp.greater", chance.upper_tail(total + 1) + 0.5 * chance.at(total),
         "exact mid-p, one-sided: " + method);
  number("exact.p.less", chance.lower_tail(total), "exact, one-sided: " + method);
  number("z", (static_cast<double>(right) - chance.mean()) / sd, method);
  for (std::size_t k = 0; k <= largest; ++k) {
    const auto trials = std::count_if(read.trials.begin(), read.trials.end(),
                                      [k](const Trial& trial) { return trial.right == k; });
    findings.count("trials.with.k", std::to_string(k), static_cast<std::uint64_t>(trials),
                   {.n = n});
  }
  const std::vector<double> one = fixed_point_distribution(read.items);
  for (std::size_t k = 0; k < one.size(); ++k) {
    findings.number("null.pmf", "n=" + std::to_string(read.items) + ";k=" + std::to_string(k),
                    one[k], {.n = n, .method = "chance of one permutation"});
  }
  number("prop.correct", static_cast<double>(right) / static_cast<double>(items), "of all items");
}

void add_whole(const Matching& read, FindingList& findings) {
  HitCount whole{};
  for (const Trial& trial : read.trials) {
    whole.trials += trial.permutation ? 1 : 0;
    whole.hits += trial.whole() ? 1 : 0;
  }
  Basis basis{.n = whole.trials, .method = "permutation trials that are wholly right"};
  if (whole.trials > 0) {
    basis.interval = wilson_interval(whole, read.confidence);
    basis.confidence = read.confidence;
  }
  findings.count("perfect.trials", "", whole.hits, {.n = whole.trials, .method = basis.method});
  if (whole.trials == 0) return;
  const Basis wilson{.n = whole.trials, .method = "interval of Wilson, of permutation trials"};
  findings.number("perfect.wilson.lower", "", basis.interval->low, wilson);
  findings.number("perfect.wilson.upper", "", basis.interval->high, wilson);
  if (!read.equal_size) return;
  findings.number(
      "perfect.p.greater", "", binomial_upper_tail(whole, whole_chance(read.items)),
      {.n = whole.trials,
       .method = "exact binomial, one-sided against 1/" + std::to_string(read.items) + "!"});
}

/// Single textures. In trials of different sizes their chances differ, and the hits of chance are a
/// sum of unequal coins.
void add_textures(const Matching& read, FindingList& findings) {
  for (const std::size_t label : read.felt) {
    HitCount count{};
    IntegerDistribution chance{};
    for (const Trial& trial : read.trials) {
      if (!trial.permutation) continue;
      for (const MatchedItem& item : trial.items) {
        if (item.felt != label) continue;
        ++count.trials;
        count.hits += item.chosen == label ? 1 : 0;
        const double p = item_chance(trial.items.size());
        if (!read.equal_size) chance = sum_of(chance, {.lowest = 0, .probability = {1.0 - p, p}});
      }
    }
    if (count.trials == 0) continue;
    const std::string& name = read.labels[label];
    findings.count("texture.hits", name, count.hits,
                   {.n = count.trials, .method = "permutation trials only"});
    findings.number("texture.prop", name, proportion(count),
                    {.n = count.trials,
                     .method = "permutation trials only; interval of Wilson",
                     .interval = wilson_interval(count, read.confidence),
                     .confidence = read.confidence});
    const double p = read.equal_size ? binomial_upper_tail(count, item_chance(read.items))
                                     : chance.upper_tail(static_cast<std::int64_t>(count.hits));
    findings.number("texture.p.greater", name, p,
                    {.n = count.trials,
                     .method = "exact, one-sided against 1 of the trial's items; the tests of "
                               "different textures depend on each other"});
  }
  for (const std::size_t felt : read.felt) {
    for (const std::size_t chosen : read.felt) {
      std::uint64_t count = 0;
      for (const Trial& trial : read.trials) {
        for (const MatchedItem& item : trial.items) {
          count += item.felt == felt && item.chosen == chosen ? 1U : 0U;
        }
      }
      findings.count("confusion", both(read.labels[felt], read.labels[chosen]), count,
                     {.n = read.trials.size(), .method = "felt | chosen, all trials"});
    }
  }
}

void add_mallows(const Matching& read, FindingList& findings) {
  std::vector<std::size_t> right{};
  for (const Trial& trial : read.trials) {
    if (trial.permutation && trial.items.size() == read.items) right.push_back(trial.right);
  }
  if (right.empty()) return;
  Basis basis{.n = right.size(), .method = "Mallows model with Hamming distance; chance is 0"};
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

void add_groups(const Matching& read, const std::vector<double>& means, FindingList& findings) {
  const std::set<std::string> groups(read.groups.begin(), read.groups.end());
  std::vector<std::string> names(groups.begin(), groups.end());
  std::erase(names, "");
  if (names.size() != 2) return;
  std::vector<double> first{};
  std::vector<double> second{};
  for (std::size_t person = 0; person < means.size(); ++person) {
    if (read.groups[person] == names[0]) first.push_back(means[person]);
    if (read.groups[person] == names[1]) second.push_back(means[person]);
  }
  const std::optional<double> p = permutation_test({.first = first, .second = second});
  if (!p) return;
  const auto mean = [](const std::vector<double>& of) {
    double sum = 0.0;
    for (const double one : of) sum += one;
    return sum / static_cast<double>(of.size());
  };
  const std::string key = names[0] + '-' + names[1];
  findings.number("group.diff", key, mean(first) - mean(second),
                  {.n = means.size(), .method = "difference of the participants' means"});
  findings.number("group.perm.p.two", key, *p,
                  {.n = means.size(), .method = "exact permutation of participants, two-sided"});
}

void add_participants(const Matching& read, FindingList& findings) {
  std::vector<std::size_t> right(read.participants.size());
  std::vector<std::size_t> trials(read.participants.size());
  std::vector<IntegerDistribution> chance(read.participants.size());
  for (const Trial& trial : read.trials) {
    right[trial.participant] += trial.right;
    ++trials[trial.participant];
    chance[trial.participant] = sum_of(chance[trial.participant], trial.chance);
  }
  std::vector<double> means{};
  for (std::size_t person = 0; person < right.size(); ++person) {
    means.push_back(static_cast<double>(right[person]) / static_cast<double>(trials[person]));
    findings.number("subject.mean", read.participants[person], means.back(),
                    {.n = 1, .method = "right items per trial"});
  }
  for (std::size_t person = 0; person < right.size(); ++person) {
    findings.number(
        "subject.p.greater", read.participants[person],
        chance[person].upper_tail(static_cast<std::int64_t>(right[person])),
        {.n = trials[person], .method = "exact, one-sided, against random orders of the answers"});
  }
  add_groups(read, means, findings);
}

}  // namespace

std::vector<Finding> matching_findings(const TidyInput& input) {
  const Matching read = matching_in(input);
  FindingList findings{};
  add_totals(read, findings);
  add_whole(read, findings);
  add_textures(read, findings);
  add_mallows(read, findings);
  add_participants(read, findings);
  return findings.take();
}

}  // namespace asperity
