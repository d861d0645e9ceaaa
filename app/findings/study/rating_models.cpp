#include "app/findings/study/rating_models.h"

#include <string>
#include <utility>
#include <vector>

#include "app/findings/found_numbers.h"
#include "app/findings/study/answer_columns.h"
#include "app/findings/study/study_findings.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

constexpr const char* kOrdinal = "ordinal";
constexpr const char* kMixedModel = "mixed_model";
constexpr const char* kModelTest = "rating_model";
/// The factor of the linear mixed model, and the column of the items.
constexpr const char* kRatedItem = "item";

/// The single responses; `score` is renamed where a family gives its measurements another name.
TidyInput responses_of(const GatheredAnswers& gathered, const RatedScale& scale,
                       const char* score = "score") {
  ScoreRows scores(gathered);
  for (const RatedScale::Response& response : scale.responses) {
    scores.add(response.person, response.item, response.score);
  }
  return std::move(scores).take("subject", kRatedItem, "the responses on " + scale.name, score);
}

void add_odds(const RatedScale& scale, const FoundNumbers& found, Table& table) {
  for (const std::string& item : scale.items) {
    const std::string key = both(scale.name, item);
    const Finding* const odds = found.find("logodds", key);
    if (odds == nullptr) continue;
    const auto [low, high] = found.interval("logodds", key);
    table.rows.push_back({scale.name, item, scale.items.front(), cell_of(odds->value), low, high,
                          found.cell("wald.z", key), found.cell("wald.p", key)});
  }
}

void add_differences(const RatedScale& scale, const FoundNumbers& found, Table& table) {
  for (const std::string& item : scale.items) {
    const std::string key = both(scale.name, both(kRatedItem, item));
    const Finding* const difference = found.find("lmm.beta", key);
    if (difference == nullptr || !difference->value) continue;
    const auto [low, high] = found.interval("lmm.beta", key);
    table.rows.push_back({scale.name, item, scale.items.front(), cell_of(difference->value), low,
                          high, found.cell("lmm.t", key), found.cell("lmm.df", key),
                          found.cell("lmm.p", key)});
  }
}

}  // namespace

RatingModels::RatingModels()
    : ordinal_{kOrdinal,
               phrase("Analysis", "Cumulative link mixed model of the ratings on each scale"),
               {{"scale", "item", "reference", "log_odds", "log_odds_low", "log_odds_high", "z",
                 "p"},
                {}},
               phrase(
                   "Analysis",
                   "Log odds ratio of a higher rating, relative to the reference, with Wald "
                   "95 % CIs: proportional odds, items as fixed effects, participants as random "
                   "intercepts. Every response counts. The p values are uncorrected and slightly "
                   "too small: in simulations without differences the Type I error rate at α = .05 "
                   "was up to 7 %.")},
      linear_{kMixedModel,
              phrase("Analysis", "Linear mixed model of the ratings on each scale"),
              {{"scale", "item", "reference", "difference", "difference_low", "difference_high",
                "t", "df", "p"},
               {}},
              phrase("Analysis",
                     "Difference of the ratings, relative to the reference, with 95 % CIs: items "
                     "as fixed effects, participants as random intercepts, REML, Satterthwaite’s "
                     "degrees of freedom. Every response counts. The p values are uncorrected and "
                     "slightly too small: in simulations in which neither items nor participants "
                     "differed the Type I error rate at α = .05 was up to 7 %.")} {}

void RatingModels::add(const GatheredAnswers& gathered, const RatedScale& scale, StudyTests& tests,
                       AnalysisOutcome& outcome) {
  if (scale.has_categories()) {
    TidyInput input = responses_of(gathered, scale);
    input.options.set("items", scale.items);
    const std::vector<Finding> model = findings_of(kOrdinal, "ordinal", scale, std::move(input));
    const FoundNumbers found(model);
    add_odds(scale, found, ordinal_.table);
    tests.add(kModelTest, scale.name, found, "lr.p", scale.name);
    keep_findings(model, outcome);
    return;
  }
  TidyInput input = responses_of(gathered, scale, "y");
  input.options.set("fixed", std::vector<std::pair<std::string, std::vector<std::string>>>{
                                 {kRatedItem, scale.items}});
  const std::vector<Finding> model = findings_of(kMixedModel, "lmm", scale, std::move(input));
  const FoundNumbers found(model);
  add_differences(scale, found, linear_.table);
  const std::string effect = both(scale.name, kRatedItem);
  if (found.find("lmm.F.p", effect) != nullptr) {
    tests.add(kModelTest, scale.name, found, "lmm.F.p", effect);
  } else {
    tests.add(kModelTest, scale.name, found, "lmm.status", scale.name);
  }
  keep_findings(model, outcome);
}

void RatingModels::report(AnalysisOutcome& outcome) && {
  for (NamedTable* const table : {&ordinal_, &linear_}) {
    if (!table->table.rows.empty()) outcome.tables.push_back(std::move(*table));
  }
}

}  // namespace asperity
