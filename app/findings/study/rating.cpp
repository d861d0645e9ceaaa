// The analysis of ratings: each scale on its own; scales that accompany another question apart from the others.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/reading_number.h"
#include "app/findings/study/accompanying_scales.h"
#include "app/findings/study/answer_columns.h"
#include "app/findings/study/estimate_sentences.h"
#include "app/findings/study/kinds/rating_analysis.h"
#include "app/findings/study/study_findings.h"
#include "app/findings/study/test_sentences.h"

namespace asperity {

namespace {

constexpr const char* kRatings = "ratings";
constexpr const char* kScales = "scales";
constexpr const char* kAgreement = "agreement";
constexpr const char* kOrdinal = "ordinal";
constexpr const char* kComponents = "components";
constexpr const char* kLoadings = "loadings";

/// The ratings on one scale: means of each participant for each item.
struct RatedScale {
  std::string name{};
  std::vector<std::string> items{};                                 ///< by name
  std::map<std::pair<std::uint32_t, std::string>, double> means{};  ///< by participant and item
  bool has_points = false;
  struct Response {
    std::uint32_t person = 0;
    std::string item{};
    double score = 0.0;
  };
  std::vector<Response> responses{};  ///< all of them, not averaged
};

/// What is rated in a trial: its surface. Where a scale accompanies several surfaces, all of them, in
/// whatever order they were felt.
std::string rated_item(const GatheredAnswers& gathered, const GatheredAnswer& answer) {
  std::multiset<std::string> names{};
  for (const FeltSurface& surface : gathered.surfaces_of(answer)) {
    names.insert(gathered.word(surface.item));
  }
  std::string item{};
  for (const std::string& name : names) item += (item.empty() ? "" : "+") + name;
  return item;
}

/// Whether the protocol's family names a test of ratings that can only be one of accompanying scales.
bool tests_accompanying_ratings(const GatheredAnswers& gathered) {
  const std::vector<std::string>& family = gathered.declared.family;
  return gathered.only_accompanies &&
         std::any_of(family.begin(), family.end(), [](const std::string& name) {
           return name == "ratings" || name == "rated_pairs" || name == "rating_model";
         });
}

/// A scale that accompanies another question is about the trial, not an attribute of its item.
std::vector<RatedScale> rated_scales(const GatheredAnswers& gathered) {
  const bool takes_all = tests_accompanying_ratings(gathered);
  std::map<std::string, std::vector<RatedScale::Response>> responses{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const std::optional<double>& number = gathered.reply_of(answer).number;
    if (!number || (answer.accompanied && !takes_all)) continue;
    responses[gathered.word(answer.question)].push_back(
        {answer.person, rated_item(gathered, answer), *number});
  }
  std::vector<RatedScale> scales{};
  for (const StoredProtocol::TrialQuestion& question : gathered.questions) {
    const auto found = responses.find(question.name);
    if (found == responses.end()) continue;
    RatedScale& scale = scales.emplace_back();
    scale.name = question.name;
    scale.has_points = question.points.has_value();
    scale.responses = std::move(found->second);
    responses.erase(found);
    struct Sum {
      double total = 0.0;
      std::size_t n = 0;
    };
    std::map<std::pair<std::uint32_t, std::string>, Sum> sums{};
    std::set<std::string> items{};
    for (const RatedScale::Response& response : scale.responses) {
      Sum& sum = sums[{response.person, response.item}];
      sum.total += response.score;
      ++sum.n;
      items.insert(response.item);
    }
    for (const auto& [of, sum] : sums) scale.means[of] = sum.total / static_cast<double>(sum.n);
    scale.items.assign(items.begin(), items.end());
  }
  return scales;
}

/// The table of the families `rating` and `icc`, which call its columns by other names.
TidyInput table_of(const GatheredAnswers& gathered, const RatedScale& scale, const char* rater,
                   const char* rated) {
  ScoreRows scores(gathered);
  for (const auto& [of, mean] : scale.means) scores.add(of.first, of.second, mean);
  return std::move(scores).take(rater, rated, "the ratings on " + scale.name);
}

/// The findings of a family with keys that begin with the name of the scale.
std::vector<Finding> findings_of(const char* analysis, const char* family, const RatedScale& scale,
                                 TidyInput input) {
  std::vector<Finding> findings = analysis_of(analysis, family, std::move(input));
  for (Finding& finding : findings) {
    finding.key = scale.name + (finding.key.empty() ? "" : "|" + finding.key);
  }
  return findings;
}

/// The single responses, for the family `ordinal`.
TidyInput responses_of(const GatheredAnswers& gathered, const RatedScale& scale) {
  ScoreRows scores(gathered);
  for (const RatedScale::Response& response : scale.responses) {
    scores.add(response.person, response.item, response.score);
  }
  TidyInput input = std::move(scores).take("subject", "item", "the responses on " + scale.name);
  input.options.set("items", scale.items);
  return input;
}

void add_odds(const RatedScale& scale, const FoundNumbers& found, Table& table) {
  for (const std::string& item : scale.items) {
    const std::string key = scale.name + '|' + item;
    const Finding* const odds = found.find("logodds", key);
    if (odds == nullptr) continue;
    const auto [low, high] = found.interval("logodds", key);
    table.rows.push_back({scale.name, item, scale.items.front(), cell_of(odds->value), low, high,
                          found.cell("wald.z", key), found.cell("wald.p", key)});
  }
}

/// Means over participants, for the family `components`: the items that were rated on every scale.
TidyInput profiles_of(const std::vector<RatedScale>& scales) {
  LabelRows items{};
  LabelRows names{};
  NumberColumn scores{};
  for (const std::string& item : scales.front().items) {
    const bool is_on_all =
        std::all_of(scales.begin(), scales.end(), [&item](const RatedScale& scale) {
          return std::binary_search(scale.items.begin(), scale.items.end(), item);
        });
    if (!is_on_all) continue;
    for (const RatedScale& scale : scales) {
      double total = 0.0;
      std::size_t n = 0;
      for (const auto& [of, mean] : scale.means) {
        if (of.second != item) continue;
        total += mean;
        ++n;
      }
      items.add(item);
      names.add(scale.name);
      scores.push_back(total / static_cast<double>(n));
    }
  }
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"item", std::move(items).take()},
                                                           {"scale", std::move(names).take()},
                                                           {"score", std::move(scores)}},
                            "the mean ratings");
  return input;
}

/// Which dimensions the scales share.
void add_components(const std::vector<RatedScale>& scales, AnalysisOutcome& outcome) {
  if (scales.size() < 2) return;
  const std::vector<Finding> findings = analysis_of(kComponents, "components", profiles_of(scales));
  const FoundNumbers found(findings);
  keep_findings(findings, outcome);
  const std::vector<const Finding*> eigenvalues = found.all("eigenvalue");
  if (eigenvalues.empty() || !eigenvalues.front()->value) return;
  NamedTable components{
      kComponents,
      phrase("Analysis", "Principal components of the scales"),
      {{"component", "eigenvalue", "proportion", "limit", "retained"}, {}},
      phrase(
          "Analysis",
          "The components are those of the correlations of the scales over the items' mean "
          "ratings. A component is retained if its eigenvalue and those of all components before "
          "it exceed the limit: the 95th percentile of the eigenvalues of tables of random "
          "numbers of the same size (parallel analysis).")};
  const double retained = found.value("retained").value_or(0.0);
  for (const Finding* const eigenvalue : eigenvalues) {
    const auto number = static_cast<double>(components.table.rows.size() + 1);
    components.table.rows.push_back({eigenvalue->key, cell_of(eigenvalue->value),
                                     found.cell("proportion", eigenvalue->key),
                                     found.cell("parallel.limit", eigenvalue->key),
                                     std::string(number <= retained ? "yes" : "no")});
  }
  NamedTable loadings{kLoadings,
                      phrase("Analysis", "Loadings of the scales and scores of the items"),
                      {{"of", "name", "component", "value"}, {}},
                      phrase("Analysis",
                             "A loading is the correlation of a scale with a component; a score is "
                             "the position of an item on it.")};
  for (const char* const quantity : {"loading", "score"}) {
    for (const Finding* const finding : found.all(quantity)) {
      const std::size_t bar = finding->key.rfind('|');
      loadings.table.rows.push_back({std::string(quantity), finding->key.substr(0, bar),
                                     finding->key.substr(bar + 1), cell_of(finding->value)});
    }
  }
  outcome.tables.push_back(std::move(components));
  outcome.tables.push_back(std::move(loadings));
}

/// The scales as shown to participants.
NamedTable table_of_scales(const GatheredAnswers& gathered, const std::vector<RatedScale>& scales,
                           const AccompanyingScales& accompanying) {
  NamedTable shown{kScales,
                   phrase("Analysis", "The scales"),
                   {{"scale", "minimum", "low_label", "maximum", "high_label", "points"}, {}},
                   phrase("Analysis",
                          "The ends of each scale as numbers and as labelled for participants; a "
                          "scale without points is a continuous line.")};
  // Whole numbers are displayed without decimals.
  const auto whole_cell = [](const std::optional<double>& number) {
    return number && std::floor(*number) == *number
               ? Cell{static_cast<std::int64_t>(std::llround(*number))}
               : cell_of(number);
  };
  const auto label_cell = [](const std::string& label) {
    return label.empty() ? Cell{} : Cell{label};
  };
  for (const StoredProtocol::TrialQuestion& question : gathered.questions) {
    const bool is_rated = std::any_of(scales.begin(), scales.end(), [&question](const auto& scale) {
      return scale.name == question.name;
    });
    if (!is_rated && !accompanying.has(question.name)) continue;
    shown.table.rows.push_back({question.name, whole_cell(question.minimum),
                                label_cell(question.low_label), whole_cell(question.maximum),
                                label_cell(question.high_label), whole_cell(question.points)});
  }
  return shown;
}

std::string rating_shown(double mean) {
  constexpr int kDecimals = 2;
  return reading_signed(mean, kDecimals);
}

/// "4.25 (95 % CI [3.90, 4.60])"
Phrase mean_text(const Finding& mean) {
  constexpr int kDecimals = 2;
  const std::string value = reading_signed(*mean.value, kDecimals);
  if (!mean.low || !mean.high) return Phrase(value);
  return phrase("Analysis", "%1 (95 % CI [%2, %3])")
      .with(value, reading_signed(*mean.low, kDecimals), reading_signed(*mean.high, kDecimals));
}

void add_means(const RatedScale& scale, const FoundNumbers& found, Table& table) {
  for (const std::string& item : scale.items) {
    const std::string key = scale.name + '|' + item;
    const Finding* const mean = found.find("mean.score", key);
    if (mean == nullptr) continue;
    const auto [low, high] = found.interval("mean.score", key);
    table.rows.push_back({scale.name, item, static_cast<std::int64_t>(mean->n),
                          cell_of(mean->value), low, high, found.cell("mean.rank", key)});
  }
}

void add_agreement(const RatedScale& scale, const FoundNumbers& found, Table& table) {
  for (const char* const form : {"ICC2", "ICC3", "ICC2k", "ICC3k"}) {
    const std::string key = scale.name + '|' + form;
    const Finding* const icc = found.find("icc", key);
    if (icc == nullptr) continue;
    const auto [low, high] = found.interval("icc", key);
    table.rows.push_back({scale.name, std::string(form), cell_of(icc->value), low, high,
                          static_cast<std::int64_t>(icc->n)});
  }
  if (const Finding* const alpha = found.find("cronbach.alpha", scale.name)) {
    table.rows.push_back({scale.name, std::string("cronbach_alpha"), cell_of(alpha->value), Cell{},
                          Cell{}, static_cast<std::int64_t>(alpha->n)});
  }
}

void add_tests(const RatedScale& scale, bool is_only_scale, const FoundNumbers& found,
               StudyTests& tests) {
  tests.add("ratings", scale.name, found, "friedman.p", scale.name);
  for (std::size_t a = 0; a < scale.items.size(); ++a) {
    for (std::size_t b = a + 1; b < scale.items.size(); ++b) {
      const std::string pair = scale.items[a] + '|' + scale.items[b];
      const std::string key = scale.name + '|' + pair;
      tests.add("rated_pairs", (is_only_scale ? "" : scale.name + ": ") + pair, found,
                "wilcoxon.exact.p.two", key);
      const double tested = found.value("wilcoxon.n", key).value_or(0.0);
      const double complete = found.value("n.complete", scale.name).value_or(tested);
      tests.drop_ties(static_cast<std::size_t>(complete - tested));
    }
  }
}

void ask_about(const RatedScale& scale, const FoundNumbers& found, const StudyTests& tests,
               AnalysisOutcome& outcome) {
  std::vector<std::pair<const Finding*, std::string>> means{};
  for (const std::string& item : scale.items) {
    const Finding* const mean = found.find("mean.score", scale.name + '|' + item);
    if (mean != nullptr && mean->value) means.emplace_back(mean, item);
  }
  const StudyTests::Test* const test = tests.find("ratings", scale.name);
  const std::string name = "ratings_" + scale.name;
  const Phrase question =
      phrase("Analysis", "Do the ratings on the scale “%1” differ between the items?")
          .with(scale.name);
  const Phrase method = phrase("Analysis",
                               "Friedman test of the participants' mean ratings of the items; CIs "
                               "of the means are t-based.");
  if (means.empty() || test == nullptr || !test->p) {
    add_question(outcome, name.c_str(), question,
                 phrase("Analysis", "Not tested: too few participants rated every item."), method,
                 kRatings, nullptr);
    return;
  }
  const auto by_value = [](const auto& one, const auto& other) {
    return *one.first->value < *other.first->value;
  };
  const auto [low, high] = std::minmax_element(means.begin(), means.end(), by_value);
  const auto with_numbers = [&](const Phrase& words) {
    return words.with(high->second, mean_text(*high->first), low->second, mean_text(*low->first),
                      p_text(*test));
  };
  const Sayings sayings{
      with_numbers(phrase("Analysis",
                          "Yes: the mean rating is highest for %1, %2, and lowest for %3, %4. "
                          "Friedman test: %5.")),
      with_numbers(
          phrase("Analysis",
                 "Not significantly: the mean rating is highest for %1, %2, and lowest for "
                 "%3, %4. Friedman test: %5. This does not show that they are equal.")),
      with_numbers(phrase("Analysis",
                          "For these participants, the mean rating is highest for %1, %2, and "
                          "lowest for %3, %4. Friedman test: %5."))};
  add_question(outcome, name.c_str(), question, said_of(*test, sayings), method, kRatings,
               high->first);
}

}  // namespace

void analyze_rating(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<RatedScale> scales = rated_scales(gathered);
  const AccompanyingScales accompanying(gathered);
  NamedTable ratings{
      kRatings,
      phrase("Analysis", "Mean ratings of the items on each scale"),
      {{"scale", "item", "persons", "mean", "mean_low", "mean_high", "mean_rank"}, {}},
      phrase("Analysis",
             "Means of the participants' mean ratings, over the participants who rated every item, "
             "with t-based 95 % CIs; mean rank: 1 for a participant's lowest rating.")};
  NamedTable agreement{
      kAgreement,
      phrase("Analysis", "Agreement of the participants on each scale"),
      {{"scale", "measure", "value", "value_low", "value_high", "items"}, {}},
      phrase("Analysis",
             "Intraclass correlations with the items as targets and the participants as raters: "
             "ICC2 measures agreement, ICC3 consistency; k: of the mean of all participants. "
             "Cronbach's α with the participants as test items.")};
  NamedTable odds{
      kOrdinal,
      phrase("Analysis", "Cumulative link mixed model of the ratings on each scale"),
      {{"scale", "item", "reference", "log_odds", "log_odds_low", "log_odds_high", "z", "p"}, {}},
      phrase("Analysis",
             "Log odds ratio of a higher rating, relative to the reference, with Wald 95 % CIs: "
             "proportional odds, items as fixed effects, participants as random intercepts. "
             "Every response counts. The p values are uncorrected.")};
  StudyTests tests(gathered);
  std::vector<std::pair<const RatedScale*, std::vector<Finding>>> all{};
  for (const RatedScale& scale : scales) {
    if (scale.items.size() < 2) {
      tests.add_untested("ratings", scale.name, "only one item was rated on this scale");
      continue;
    }
    TidyInput input = table_of(gathered, scale, "subject", "item");
    input.options.set("items", scale.items);
    std::vector<Finding> findings = findings_of(kRatings, "rating", scale, std::move(input));
    const FoundNumbers found(findings);
    add_means(scale, found, ratings.table);
    add_tests(scale, scales.size() == 1, found, tests);
    keep_findings(findings, outcome);
    if (scale.has_points) {
      const std::vector<Finding> model =
          findings_of(kOrdinal, "ordinal", scale, responses_of(gathered, scale));
      const FoundNumbers found_model(model);
      add_odds(scale, found_model, odds.table);
      tests.add("rating_model", scale.name, found_model, "lr.p", scale.name);
      keep_findings(model, outcome);
    }
    const std::vector<Finding> correlations =
        findings_of(kAgreement, "icc", scale, table_of(gathered, scale, "rater", "target"));
    add_agreement(scale, FoundNumbers(correlations), agreement.table);
    keep_findings(correlations, outcome);
    all.emplace_back(&scale, std::move(findings));
  }
  const bool has_ratings = !ratings.table.rows.empty();
  if (has_ratings) outcome.tables.push_back(std::move(ratings));
  if (has_ratings || !accompanying.empty()) {
    outcome.tables.push_back(table_of_scales(gathered, scales, accompanying));
  }
  if (!agreement.table.rows.empty()) outcome.tables.push_back(std::move(agreement));
  if (!odds.table.rows.empty()) outcome.tables.push_back(std::move(odds));
  add_components(scales, outcome);
  accompanying.add_tests(tests);
  tests.finish(outcome);
  for (const auto& [scale, findings] : all) {
    state_means_of_items(outcome, {.analysis = kRatings,
                                   .quantity = "mean.score",
                                   .scale = scale->name,
                                   .items = scale->items,
                                   .tests = {"ratings", "rating_model"},
                                   .tests_of_pairs = {"rated_pairs"},
                                   .shown = rating_shown});
    ask_about(*scale, FoundNumbers(findings), tests, outcome);
  }
  accompanying.report(tests, outcome);
}

}  // namespace asperity
