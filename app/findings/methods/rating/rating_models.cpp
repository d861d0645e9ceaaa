// Calls the families `ordinal`, of which only log odds are kept, and `rmanova`, whose F test is the test of the model.

#include "app/findings/methods/rating/rating_models.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/findings/gathering/answer_columns.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/shared/magnitude_effects.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

constexpr const char* kOrdinal = "ordinal";
constexpr const char* kDifferences = "rated_differences";
constexpr const char* kModelTest = "rating_model";
/// The factor of the analysis of variance, and the column of the items.
constexpr const char* kRatedItem = "item";

const ResultColumn kLogOdds{.id = "log_odds", .heading = phrase("AnalysisWords", "log odds ratio")};

/// The single responses.
TidyInput responses_of(const GatheredAnswers& gathered, const RatedScale& scale) {
  ScoreRows scores(gathered);
  for (const RatedScale::Response& response : scale.responses) {
    scores.add(response.person, response.item, response.score);
  }
  return std::move(scores).take("subject", kRatedItem, "the responses on " + scale.name);
}

/// The participants' means.
TidyInput means_of(const GatheredAnswers& gathered, const RatedScale& scale) {
  ScoreRows scores(gathered);
  for (const auto& [of, mean] : scale.means) scores.add(of.first, of.second, mean);
  TidyInput input =
      std::move(scores).take("subject", kRatedItem, "the mean ratings on " + scale.name, "y");
  input.options.set("within", std::vector<std::pair<std::string, std::vector<std::string>>>{
                                  {kRatedItem, scale.items}});
  return input;
}

void add_odds(const RatedScale& scale, const FoundNumbers& found, ResultTable& table) {
  for (const std::string& item : scale.items) {
    const FindingKey key{scale.name, item};
    const Finding* const odds = found.find("logodds", key);
    if (odds == nullptr) continue;
    table.add({scale.name, item, scale.items.front(), cell_of(odds->value)});
  }
}

/// The family has the differences first − second; the table has those to the first item.
void add_differences(const RatedScale& scale, const FoundNumbers& found, ResultTable& table) {
  const std::string& reference = scale.items.front();
  for (const std::string& item : scale.items) {
    const Finding* const pair = found.find("pair.diff", {scale.name, kRatedItem, reference, item});
    if (pair == nullptr || !pair->value) continue;
    const auto negated = [](const std::optional<double>& number) {
      return number ? std::optional(0.0 - *number) : std::nullopt;
    };
    table.add({scale.name, item, reference, count_cell(pair->n), cell_of(negated(pair->value)),
               interval_cell(negated(pair->high), negated(pair->low))});
  }
}

bool is_of_differences(const Finding& finding) {
  constexpr std::array<QuantityName, 10> kKept{"F",      "df1", "df2",       "p",      "p.GG",
                                               "eps.GG", "ges", "pair.diff", "status", "pes"};
  return std::find(kKept.begin(), kKept.end(), finding.quantity) != kKept.end();
}

/// Without the tests of the model, which assume the same effects of the items for all participants; with the reason why there
/// is no fit.
bool is_of_odds(const Finding& finding) {
  if (is(finding, "lr.chisq")) return !finding.value;
  return !finding.quantity.starts_with("lr.") && !finding.quantity.starts_with("wald.");
}

}  // namespace

RatingModels::RatingModels()
    : ordinal_{kOrdinal,
               phrase("Analysis", "Cumulative link mixed model of the ratings on each scale"),
               {columns::kScale, columns::kItem, columns::kReference, kLogOdds},
               phrase("Analysis",
                      "Log odds ratio of a higher rating, relative to the reference: proportional "
                      "odds, items as fixed effects, participants as random intercepts. Every "
                      "response "
                      "counts. There are no CIs and no p values: the model assumes the same "
                      "effects of "
                      "the items for all participants, and in simulations in which these varied "
                      "with an "
                      "SD of 0.5 its likelihood-ratio test had a Type I error rate of 21 % at α = "
                      ".05.")},
      differences_{
          kDifferences,
          phrase("Analysis", "Differences of the mean ratings on each scale"),
          {columns::kScale, columns::kItem, columns::kReference, columns::kPersons,
           columns::kDifference, interval_of(columns::kDifference)},
          phrase("Analysis",
                 "Differences of the participants’ mean ratings to the reference, over the "
                 "participants who rated every item, with t-based 95 % CIs of the paired "
                 "differences, uncorrected.")} {}

void RatingModels::add(const GatheredAnswers& gathered, const RatedScale& scale, StudyTests& tests,
                       AnalysisOutcome& outcome) {
  if (scale.has_categories()) {
    TidyInput input = responses_of(gathered, scale);
    input.options.set("items", scale.items);
    std::vector<Finding> model = findings_of(kOrdinal, "ordinal", scale, std::move(input));
    drop_intervals(model, [](const Finding& finding) -> std::optional<std::string> {
      if (!finding.low) return std::nullopt;
      return "without an interval, which would assume the same effects for all participants";
    });
    add_odds(scale, FoundNumbers(model), ordinal_);
    keep_findings(model, outcome, is_of_odds);
  }
  const std::vector<Finding> anova = add_rating_model_test(gathered, scale, tests);
  add_differences(scale, FoundNumbers(anova), differences_);
  keep_findings(anova, outcome, is_of_differences);
}

std::vector<Finding> add_rating_model_test(const GatheredAnswers& gathered, const RatedScale& scale,
                                           StudyTests& tests) {
  std::vector<Finding> anova =
      findings_of(kDifferences, "rmanova", scale, means_of(gathered, scale));
  const FoundNumbers found(anova);
  const FindingKey effect{scale.name, kRatedItem};
  if (found.find("F", effect) != nullptr) {
    tests.add(kModelTest, scale.name, found, p_of(found, effect.text()), effect);
  } else {
    tests.add(kModelTest, scale.name, found, "status", scale.name);
  }
  return anova;
}

void RatingModels::report(AnalysisOutcome& outcome) && {
  for (ResultTable* const table : {&differences_, &ordinal_}) {
    if (!table->rows.empty()) outcome.tables.push_back(std::move(*table));
  }
}

}  // namespace asperity
