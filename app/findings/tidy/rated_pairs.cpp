// Averages judgements of a pair in either order; identical pairs are kept apart.

#include "app/findings/tidy/rated_pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace asperity {
namespace {

using UnorderedPair = std::pair<std::size_t, std::size_t>;

UnorderedPair pair_of(const PairJudgement& judgement) {
  return std::minmax(judgement.first, judgement.second);
}

/// The items in the order in which they first occur, in either column.
std::vector<std::string> items_in(const TidyTable& table) {
  const LabelColumn first = table.all_labels("first");
  const LabelColumn second = table.all_labels("second");
  std::vector<std::string> items = first.names;
  for (const std::string& name : second.names) {
    if (std::find(items.begin(), items.end(), name) == items.end()) items.push_back(name);
  }
  return items;
}

double mean_judgement(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

}  // namespace

std::vector<RatedPairs> JudgedPairs::by_rater() const {
  const auto m = static_cast<Eigen::Index>(items.size());
  std::vector<RatedPairs> made(raters.size(), {.values = Dissimilarities::Zero(m, m),
                                               .weights = Eigen::MatrixXd::Zero(m, m)});
  for (const PairJudgement& judgement : judgements) {
    const auto [a, b] = pair_of(judgement);
    if (a == b) continue;
    const auto i = static_cast<Eigen::Index>(a);
    const auto j = static_cast<Eigen::Index>(b);
    made[judgement.rater].values(i, j) += judgement.dissimilarity;
    made[judgement.rater].weights(i, j) += 1.0;
  }
  for (RatedPairs& one : made) one = means_of_sums(std::move(one));
  return made;
}

JudgedPairs::Repeated JudgedPairs::repeated_by(std::size_t rater) const {
  std::map<UnorderedPair, std::vector<double>> by_pair{};
  for (const PairJudgement& judgement : judgements) {
    if (judgement.rater == rater && judgement.first != judgement.second)
      by_pair[pair_of(judgement)].push_back(judgement.dissimilarity);
  }
  Repeated made{};
  for (const auto& [pair, values] : by_pair) {
    if (values.size() < 2) continue;
    made.first.push_back(values.front());
    made.last.push_back(values.back());
  }
  return made;
}

JudgedPairs::Repeated JudgedPairs::in_both_orders_by(std::size_t rater) const {
  struct Orders {
    std::vector<double> as_listed{};
    std::vector<double> reversed{};
  };
  std::map<UnorderedPair, Orders> by_pair{};
  for (const PairJudgement& judgement : judgements) {
    if (judgement.rater != rater || judgement.first == judgement.second) continue;
    Orders& orders = by_pair[pair_of(judgement)];
    (judgement.first < judgement.second ? orders.as_listed : orders.reversed)
        .push_back(judgement.dissimilarity);
  }
  Repeated made{};
  for (const auto& [pair, orders] : by_pair) {
    if (orders.as_listed.empty() || orders.reversed.empty()) continue;
    made.first.push_back(mean_judgement(orders.as_listed));
    made.last.push_back(mean_judgement(orders.reversed));
  }
  return made;
}

std::optional<double> JudgedPairs::mean_of_identical_by(std::size_t rater) const {
  std::vector<double> values{};
  for (const PairJudgement& judgement : judgements) {
    if (judgement.rater == rater && judgement.first == judgement.second)
      values.push_back(judgement.dissimilarity);
  }
  return values.empty() ? std::nullopt : std::optional(mean_judgement(values));
}

std::optional<double> JudgedPairs::mean_of_different_by(std::size_t rater) const {
  std::vector<double> values{};
  for (const PairJudgement& judgement : judgements) {
    if (judgement.rater == rater && judgement.first != judgement.second)
      values.push_back(judgement.dissimilarity);
  }
  return values.empty() ? std::nullopt : std::optional(mean_judgement(values));
}

JudgedPairs judged_pairs_in(const TidyTable& table, std::vector<std::string> items) {
  JudgedPairs made{.items = items.empty() ? items_in(table) : std::move(items)};
  const LabelColumn raters = table.all_labels("subject");
  const LabelColumn first = table.labels("first", made.items);
  const LabelColumn second = table.labels("second", made.items);
  const std::vector<std::optional<double>> values = table.numbers("dissimilarity");
  made.raters = raters.names;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const auto& [column, labels] :
         {std::pair{"first", &first}, std::pair{"second", &second}}) {
      if (labels->codes[row] == LabelColumn::kMissing)
        table.refuse(row, column, "the item is missing; enter it, or remove the row");
    }
    if (!values[row]) continue;
    if (*values[row] < 0.0)
      table.refuse(row, "dissimilarity", "a dissimilarity is at least 0; correct it");
    made.judgements.push_back({.rater = raters.codes[row],
                               .first = first.codes[row],
                               .second = second.codes[row],
                               .dissimilarity = *values[row]});
  }
  return made;
}

std::optional<double> pearson_correlation(const std::vector<double>& a,
                                          const std::vector<double>& b) {
  constexpr std::size_t kFewest = 3;
  if (a.size() < kFewest || a.size() != b.size()) return std::nullopt;
  const auto n = static_cast<Eigen::Index>(a.size());
  const Eigen::Map<const Eigen::ArrayXd> x(a.data(), n);
  const Eigen::Map<const Eigen::ArrayXd> y(b.data(), n);
  const Eigen::ArrayXd dx = x - x.mean();
  const Eigen::ArrayXd dy = y - y.mean();
  const double size = std::sqrt(dx.square().sum() * dy.square().sum());
  return size > 0.0 ? std::optional((dx * dy).sum() / size) : std::nullopt;
}

}  // namespace asperity
