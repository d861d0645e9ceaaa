// Rankings: each trial ranks some or all of the items that it offers.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/choices/comparison_graph.h"
#include "analysis/choices/plackett_luce.h"
#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/tests/effect_size.h"
#include "app/findings/tidy/scale_findings.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

struct OfferedItem {
  std::size_t row = 0;
  std::size_t item = 0;
  std::optional<double> rank{};
};

struct Rankings {
  std::vector<std::string> items{};
  std::vector<std::string> participants{};
  std::vector<Ranking> rankings{};
  Eigen::MatrixXd ranks{};  ///< trials × items, where every trial ranks all items; empty otherwise
  double confidence = 0.95;
};

Ranking ranking_of(const TidyTable& table, const std::vector<std::string>& items,
                   std::vector<OfferedItem>& offered) {
  Ranking ranking{};
  std::set<std::size_t> seen{};
  std::stable_sort(offered.begin(), offered.end(), [](const OfferedItem& a, const OfferedItem& b) {
    return a.rank && (!b.rank || *a.rank < *b.rank);
  });
  for (std::size_t i = 0; i < offered.size(); ++i) {
    const OfferedItem& one = offered[i];
    if (!seen.insert(one.item).second) {
      table.refuse(
          one.row, "item",
          "the item \"" + items[one.item] + "\" occurs twice in its trial; remove one of the rows");
    }
    if (i > 0 && one.rank && one.rank == offered[i - 1].rank) {
      table.refuse(one.row, "rank",
                   "the rank " + number_text(*one.rank) +
                       " occurs twice in its trial; give each item its own rank, or analyse tied "
                       "items with the family \"rating\"");
    }
    (one.rank ? ranking.ranked : ranking.behind).push_back(one.item);
  }
  return ranking;
}

Rankings rankings_in(const TidyInput& input) {
  const TidyTable& table = input.table();
  Rankings read{.items = input.options.texts("items")};
  if (read.items.size() < 2) {
    throw std::runtime_error("the option \"items\" must name at least two items, not " +
                             std::to_string(read.items.size()) + "; add the others");
  }
  read.confidence = input.options.confidence();
  const LabelColumn participants = table.all_labels("subject");
  const LabelColumn trials = table.all_labels("trial");
  const LabelColumn items = table.labels("item", read.items);
  const std::vector<std::optional<double>> ranks = table.numbers("rank");
  const std::vector<std::uint64_t> times =
      table.has("times") ? table.counts("times") : std::vector<std::uint64_t>(table.rows(), 1);
  read.participants = participants.names;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> place{};
  std::vector<std::pair<std::size_t, std::vector<OfferedItem>>> offers{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (items.codes[row] == LabelColumn::kMissing)
      table.refuse(row, "item", "the item is missing; enter it, or remove the row");
    if (ranks[row] && (*ranks[row] < 1.0 || *ranks[row] != std::round(*ranks[row]))) {
      table.refuse(row, "rank",
                   "rank is " + number_text(*ranks[row]) +
                       "; it must be a whole number of at least 1, or empty for items ranked "
                       "behind all others");
    }
    const std::pair name{participants.codes[row], trials.codes[row]};
    const auto [found, first] = place.emplace(name, offers.size());
    if (first) offers.emplace_back(name.first, std::vector<OfferedItem>{});
    offers[found->second].second.push_back({row, items.codes[row], ranks[row]});
  }
  bool whole = !offers.empty();
  std::size_t trials_in_all = 0;
  for (auto& [participant, offered] : offers) {
    read.rankings.push_back(ranking_of(table, read.items, offered));
    read.rankings.back().participant = participant;
    read.rankings.back().times = times[offered.front().row];
    for (const OfferedItem& one : offered) {
      if (times[one.row] == read.rankings.back().times) continue;
      table.refuse(one.row, "times",
                   "times is " + std::to_string(times[one.row]) + ", but " +
                       std::to_string(read.rankings.back().times) +
                       " in another row of the same trial; enter the same number in all of them");
    }
    trials_in_all += read.rankings.back().times;
    whole = whole && read.rankings.back().ranked.size() == read.items.size();
  }
  if (whole) {
    read.ranks.resize(static_cast<Eigen::Index>(trials_in_all),
                      static_cast<Eigen::Index>(read.items.size()));
    Eigen::Index next = 0;
    for (std::size_t trial = 0; trial < offers.size(); ++trial) {
      const auto rows = static_cast<Eigen::Index>(read.rankings[trial].times);
      for (const OfferedItem& one : offers[trial].second) {
        read.ranks.block(next, static_cast<Eigen::Index>(one.item), rows, 1).setConstant(*one.rank);
      }
      next += rows;
    }
  }
  return read;
}

void add_plackett_luce(const Rankings& read, const PlackettLuce& fit, FindingList& findings) {
  const std::size_t n = read.participants.size();
  const auto named = [&](const char* value, const char* error, const std::string& method) {
    return ScaleNames{
        .value = value, .error = error, .method = method, .n = n, .confidence = read.confidence};
  };
  const std::string from_first = "Plackett–Luce, relative to " + read.items.front();
  const std::string centred = "Plackett–Luce, mean 0";
  add_clustered_scale(read.items,
                      {.centred = fit.log_worths.about_mean(), .errors = fit.centred_errors},
                      {.prefix = "pl",
                       .value = "pl.logworth.sumzero.cluster",
                       .method = "Plackett–Luce",
                       .n = n,
                       .confidence = read.confidence},
                      findings);
  const Eigen::VectorXd worth = fit.log_worths.worth();
  for (std::size_t i = 0; i < read.items.size(); ++i) {
    findings.number("pl.worth", read.items[i], worth(static_cast<Eigen::Index>(i)),
                    {.n = n, .method = "Plackett–Luce, sum 1"});
  }
  add_cluster_errors(read.items, fit.clustered.about_mean(),
                     named("", "pl.se.sumzero.cluster", centred), findings);
  add_cluster_errors(read.items, fit.clustered, named("", "pl.se.cluster", from_first), findings);
  ScaleNames about_mean = named("pl.logworth.sumzero", "pl.se.sumzero", centred);
  about_mean.coverage = simulated_coverage({94, 98}, {65, 94});
  add_scale(read.items, fit.log_worths.about_mean(), about_mean, findings);
  add_scale(read.items, fit.log_worths, named("pl.logworth", "pl.se", from_first), findings);
  const double lr = 2.0 * (fit.log_likelihood - fit.equal_log_likelihood);
  const double df = static_cast<double>(read.items.size()) - 1.0;
  const Basis likelihood{.n = n, .method = "log likelihood"};
  const Basis equal{.n = n, .method = "likelihood-ratio test against equal worths"};
  findings.number("pl.loglik", "", fit.log_likelihood, likelihood);
  findings.number("pl.loglik.equal", "", fit.equal_log_likelihood, likelihood);
  findings.number("pl.lr", "", lr, equal);
  findings.number("pl.lr.p", "", *upper_tail(ChiSquaredStatistic{.value = lr, .df = df}), equal);
}

}  // namespace

std::vector<Finding> ranking_findings(const TidyInput& input) {
  const Rankings read = rankings_in(input);
  const std::size_t n = read.participants.size();
  FindingList findings{};
  const RankingCounts counts = count_stages(read.rankings, read.items.size());
  findings.count("n.stages", "", counts.stages,
                 {.n = n, .method = "choices among the remaining items"});
  findings.truth("strongly.connected", "", strongly_connected(counts.wins),
                 {.n = n, .method = "whether chains of wins connect all items in both directions"});
  if (const auto fit = plackett_luce(read.rankings, read.items.size())) {
    add_plackett_luce(read, *fit, findings);
  } else {
    findings.word("pl.status", "", "not_estimable",
                  "some items were never ranked behind the others, or never ranked with them, so "
                  "that the scale has no finite estimate: collect more rankings, or leave these "
                  "items out",
                  {.n = n, .method = "Plackett–Luce"});
  }
  if (read.ranks.rows() > 0) {
    const auto rows = static_cast<std::size_t>(read.ranks.rows());
    add_friedman(friedman_test(read.ranks),
                 {.n = rows,
                  .none = {},
                  .one = "agreement requires at least two rankings: collect more",
                  // Rankings of one participant are not independent.
                  .concordance =
                      rows == n ? concordance_interval(read.ranks, read.confidence) : std::nullopt,
                  .confidence = read.confidence},
                 findings);
    for (std::size_t i = 0; i < read.items.size(); ++i) {
      findings.number("mean.rank", read.items[i],
                      read.ranks.col(static_cast<Eigen::Index>(i)).mean(), {.n = rows});
    }
  }
  return findings.take();
}

}  // namespace asperity
