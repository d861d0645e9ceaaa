// Ratings: each participant scores every item once; only the order of the scores counts.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/tests/effect_size.h"
#include "analysis/tests/friedman.h"
#include "analysis/tests/multiplicity.h"
#include "app/findings/tidy/scale_findings.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

struct Scores {
  Eigen::MatrixXd complete{};  ///< a row per participant who rated every item
  std::size_t incomplete = 0;  ///< participants who did not rate every item
};

Scores scores_of(const TidyTable& table, const std::vector<std::string>& items) {
  const LabelColumn participants = table.all_labels("subject");
  const LabelColumn codes = table.labels("item", items);
  const std::vector<std::optional<double>> scores = table.numbers("score");
  std::vector<std::vector<std::optional<double>>> all(
      participants.names.size(), std::vector<std::optional<double>>(items.size()));
  Scores made{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (codes.codes[row] == LabelColumn::kMissing)
      table.refuse(row, "item", "the item is missing; enter it, or remove the row");
    if (!scores[row]) continue;
    const std::size_t person = participants.codes[row];
    const std::size_t item = codes.codes[row];
    if (all[person][item]) {
      table.refuse(row, "item",
                   participants.names[person] + " has already rated \"" + items[item] +
                       "\"; remove one of the rows: a participant rates an item once");
    }
    all[person][item] = scores[row];
  }
  made.incomplete = std::erase_if(all, [](const std::vector<std::optional<double>>& own) {
    for (const std::optional<double>& score : own) {
      if (!score) return true;
    }
    return false;
  });
  made.complete.resize(static_cast<Eigen::Index>(all.size()),
                       static_cast<Eigen::Index>(items.size()));
  for (Eigen::Index person = 0; person < made.complete.rows(); ++person) {
    for (Eigen::Index item = 0; item < made.complete.cols(); ++item) {
      made.complete(person, item) =
          *all[static_cast<std::size_t>(person)][static_cast<std::size_t>(item)];
    }
  }
  return made;
}

/// Reports the rows that the numbers omit, if any.
void add_left_out(const Scores& scores, FindingList& findings) {
  if (scores.incomplete > 0) {
    findings.count("n.incomplete", "", scores.incomplete,
                   {.n = scores.incomplete,
                    .method = "participants without a rating of every item, who are left out"});
  }
}

void add_pairs(const std::vector<std::string>& items, const Eigen::MatrixXd& scores,
               FindingList& findings) {
  std::vector<FindingKey> pairs{};
  std::vector<double> p{};
  const std::string method = "Wilcoxon signed-rank test, equal ratings dropped";
  for (Eigen::Index a = 0; a < scores.cols(); ++a) {
    for (Eigen::Index b = a + 1; b < scores.cols(); ++b) {
      const FindingKey key{items[static_cast<std::size_t>(a)], items[static_cast<std::size_t>(b)]};
      const Eigen::VectorXd differences = scores.col(a) - scores.col(b);
      const SignedRankTest test = signed_rank_test(
          std::span(differences.data(), static_cast<std::size_t>(differences.size())));
      const Basis basis{.n = test.n, .method = method + ", " + way_of_counting(test.drawn)};
      findings.count("wilcoxon.n", key, test.n, basis);
      findings.number("wilcoxon.Wplus", key, test.positive, basis);
      findings.number("wilcoxon.exact.p.two", key, test.p, basis);
      findings.number(
          "wilcoxon.exact.smallest", key,
          std::min(1.0, std::ldexp(1.0, 1 - static_cast<int>(test.n))),
          {.n = test.n, .method = "smallest attainable p: all differences with the same sign"});
      pairs.push_back(key);
      p.push_back(test.p);
      findings.number(
          "wilcoxon.rankbiserial", key, test.rank_biserial,
          {.n = test.n,
           .method = "rank-biserial correlation",
           .undefined = "no participant rated the two items differently: add participants"});
    }
  }
  const std::vector<double> adjusted = holm_adjusted(p);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    findings.number("wilcoxon.exact.p.holm", pairs[i], adjusted[i],
                    {.n = pairs.size(), .method = method + "; Holm-corrected over the pairs"});
  }
}

}  // namespace

std::vector<Finding> rating_findings(const TidyInput& input) {
  const std::vector<std::string> items = input.options.texts("items");
  const std::string parts = input.options.text_or("parts", "all");
  if (parts != "all" && parts != "items") {
    throw std::runtime_error("the option \"parts\" is \"" + parts +
                             "\"; it must be all or items (without the tests of pairs)");
  }
  if (items.size() < 2) {
    throw std::runtime_error("the option \"items\" must name at least two items, not " +
                             std::to_string(items.size()) + "; add the others");
  }
  const Scores given = scores_of(input.table(), items);
  const Eigen::MatrixXd& scores = given.complete;
  const auto n = static_cast<std::size_t>(scores.rows());
  FindingList findings{};
  findings.count("n.complete", "", n, {.n = n, .method = "participants who rated every item"});
  add_left_out(given, findings);
  const FriedmanTest test = friedman_test(scores);
  add_friedman(
      test,
      {.n = n,
       .none = "no participant rated every item: add the missing ratings, or leave out items",
       .one = "agreement requires at least two participants: add participants",
       .concordance = concordance_interval(scores, input.options.confidence()),
       .confidence = input.options.confidence()},
      findings);
  for (std::size_t i = 0; i < items.size() && n > 0; ++i) {
    const Eigen::VectorXd own = scores.col(static_cast<Eigen::Index>(i));
    add_mean_of_group("mean.score", items[i], std::span(own.data(), n),
                      {.confidence = input.options.confidence(), .of = "mean of the participants"},
                      findings);
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    findings.number("mean.rank", items[i], test.mean_rank[i],
                    {.n = n,
                     .method = "within participants, 1 for the lowest rating",
                     .undefined = "no participant rated every item: add the missing ratings, or "
                                  "leave out items"});
  }
  if (parts == "all") add_pairs(items, scores, findings);
  return findings.take();
}

}  // namespace asperity
