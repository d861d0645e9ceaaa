// The analysis of paired comparisons.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "analysis/choices/circular_triads.h"
#include "analysis/numbers/number_text.h"
#include "analysis/tests/pooled_share.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/paired_comparison/paired_comparison_analysis.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/tally.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/shared/choice_tables.h"
#include "app/findings/shared/group_comparisons.h"
#include "app/findings/shared/selection_choices.h"
#include "app/findings/shared/selection_questions.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

constexpr const char* kScores = "scores";
constexpr const char* kScale = "scale";
constexpr const char* kModel = "paired_model";
constexpr const char* kConsistency = "consistency";
/// The quantity of the scale.
constexpr QuantityName kLogWorth = "bt.ability.sumzero.cluster";

/// How often a participant compared two items, and the choices of the first and the second.
struct PairCount {
  std::size_t first = 0;
  std::size_t second = 0;
  std::size_t ties = 0;

  std::size_t all() const { return first + second + ties; }
};

/// Two items by number, the first before the second.
using PairKey = std::pair<std::size_t, std::size_t>;

struct PairedStudy {
  explicit PairedStudy(const Selection& of);

  const Selection& choices;
  std::vector<std::map<PairKey, PairCount>>
      by_person{};                    ///< of the gathered people, in their order
  std::map<PairKey, Tally> shares{};  ///< choices of the first, without ties
  std::map<PairKey, PairCount> counts{};
  /// The comparisons of each participant in rounds: the k-th comparison of every pair with the same levels of the other
  /// factors belongs to round k of these levels.
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::size_t>, std::vector<Comparison>> rounds{};
  std::array<Tally, 2> positions{};
  std::size_t ties = 0;

  std::size_t people_who_compared(const PairKey& pair) const {
    return static_cast<std::size_t>(
        std::count_if(by_person.begin(), by_person.end(),
                      [&pair](const auto& own) { return own.contains(pair); }));
  }
};

PairedStudy::PairedStudy(const Selection& of) : choices(of), by_person(of.gathered.people.size()) {
  std::map<std::tuple<std::uint32_t, std::uint32_t, PairKey>, std::size_t> times{};
  for (const GatheredAnswer& answer : of.gathered.answers) {
    const auto surfaces = of.gathered.surfaces_of(answer);
    if (surfaces.size() != 2) continue;
    const std::size_t one = of.item(surfaces[0]);
    const std::size_t other = of.item(surfaces[1]);
    const std::size_t chosen = of.chosen(answer);
    const PairKey key = std::minmax(one, other);
    const auto count = [&](PairCount& counted) {
      ++(chosen == kNoChoice ? counted.ties : chosen == key.first ? counted.first : counted.second);
    };
    count(by_person[answer.person][key]);
    count(counts[key]);
    if (chosen == kNoChoice) {
      ++ties;
    } else {
      shares[key].count(answer.person, chosen == key.first, 2);
      positions[0].count(answer.person, chosen == one, 2);
      positions[1].count(answer.person, chosen == other, 2);
    }
    const std::size_t round = times[{answer.person, answer.factors, key}]++;
    Comparison comparison{.first = one, .second = other};
    if (chosen != kNoChoice) comparison.winner = chosen;
    rounds[{answer.person, answer.factors, round}].push_back(comparison);
  }
}

const ResultColumn kTies{.id = "ties", .heading = phrase("AnalysisWords", "ties")};
const ResultColumn kStatistic{
    .id = "statistic", .heading = phrase("AnalysisWords", "statistic"), .digits = Digits::of_row};
const ResultColumn kRounds{.id = "rounds", .heading = phrase("AnalysisWords", "rounds")};
const ResultColumn kCircularTriads{.id = "circular_triads",
                                   .heading = phrase("AnalysisWords", "circular triads")};
const ResultColumn kZeta{.id = "zeta", .heading = phrase("AnalysisWords", "ζ")};

void add_pair_tables(const PairedStudy& study, AnalysisOutcome& outcome) {
  const std::vector<std::string>& items = study.choices.items;
  ShareTable pairs{"pairs",
                   phrase("Analysis", "Choices of each item in comparisons with each other item"),
                   phrase("Analysis",
                          "Ties are left out. The chance level is 1/2. p: exact binomial test, "
                          "two-sided, uncorrected, all responses treated as independent."),
                   {columns::kItem, kAgainst},
                   columns::kChosen,
                   "share_of_pair",
                   {}};
  for (const auto& [key, tally] : study.shares) {
    pairs.rows.push_back({{items[key.first], items[key.second]}, tally});
  }
  add_shares(pairs, outcome).figures = figures_of_pairs;
  add_positions_table(study.positions,
                      phrase("Analysis",
                             "The position is the place of a surface in the order of "
                             "presentation. Ties are left out."),
                      outcome);
  if (study.ties == 0) return;
  ResultTable ties{
      "ties", phrase("Analysis", "Ties"), {columns::kItem, kAgainst, columns::kResponses, kTies}};
  for (const auto& [key, count] : study.counts) {
    ties.add(
        {items[key.first], items[key.second], count_cell(count.all()), count_cell(count.ties)});
  }
  outcome.tables.push_back(std::move(ties));
}

/// For the family `rating`: the proportion of a participant's comparisons of an item in which it was chosen, a tie
/// counting half; of participants who compared every pair equally often, so that the items of a participant are
/// exchangeable where none is preferred.
struct PairScores {
  TidyInput input{};
  std::size_t left_out = 0;                                               ///< participants
  std::map<std::pair<std::uint32_t, std::string>, double> proportions{};  ///< by person and item
  std::vector<double> trials{};  ///< of each of the other participants, of every item
};

PairScores pair_scores_of(const PairedStudy& study) {
  const std::vector<std::string>& items = study.choices.items;
  const std::size_t pairs = items.size() * (items.size() - 1) / 2;
  ScoreRows scores(study.choices.gathered);
  PairScores made{};
  for (std::size_t person = 0; person < study.by_person.size(); ++person) {
    const std::map<PairKey, PairCount>& own = study.by_person[person];
    const bool is_balanced =
        own.size() == pairs && std::all_of(own.begin(), own.end(), [&own](const auto& each) {
          return each.second.all() == own.begin()->second.all();
        });
    if (!is_balanced) {
      ++made.left_out;
      continue;
    }
    std::vector<double> won(items.size());
    for (const auto& [key, count] : own) {
      won[key.first] += static_cast<double>(count.first) + 0.5 * static_cast<double>(count.ties);
      won[key.second] += static_cast<double>(count.second) + 0.5 * static_cast<double>(count.ties);
    }
    const auto of_item =
        static_cast<double>(own.begin()->second.all()) * static_cast<double>(items.size() - 1);
    made.trials.push_back(of_item);
    for (std::size_t item = 0; item < items.size(); ++item) {
      scores.add(person, items[item], won[item] / of_item);
      made.proportions[{static_cast<std::uint32_t>(person), items[item]}] = won[item] / of_item;
    }
  }
  made.input = std::move(scores).take("subject", "item", "the proportions of choices");
  made.input.options.set("items", items);
  return made;
}

/// Student's interval of a mean proportion, truncated to 0 and 1; of equal proportions, which have none, that of all mean
/// proportions (EqualShares).
void limit_to_proportions(Finding& mean, std::span<const double> trials) {
  if (!mean.low && mean.value && mean.n > 1) {
    constexpr double kConfidenceOfScores = 0.95;
    const auto interval = equal_shares_interval(
        {.share = *mean.value, .trials = trials, .confidence = kConfidenceOfScores});
    if (!interval) return;
    mean.low = interval->low;
    mean.high = interval->high;
    mean.confidence = kConfidenceOfScores;
    mean.method += "; the participants' proportions are equal: t interval on the logit scale";
  }
  if (!mean.low || !mean.high) return;
  mean.low = std::max(*mean.low, 0.0);
  mean.high = std::min(*mean.high, 1.0);
}

void add_scores(const PairedStudy& study, const FoundNumbers& found, AnalysisOutcome& outcome) {
  ResultTable scores{
      kScores,
      phrase("Analysis", "Proportion of the comparisons in which each item was chosen"),
      {columns::kItem, columns::kPersons, columns::kMean, interval_of(columns::kMean),
       columns::kMeanRank},
      phrase("Analysis",
             "Means over the participants who compared every pair equally often, with t-based "
             "95 % CIs, truncated at 0 and 1 (on the logit scale where the proportions of all "
             "participants are equal); a tie counts half. Mean rank: 1 for the item that a "
             "participant chose least often.")};
  for (const std::string& item : study.choices.items) {
    const Finding* const mean = found.find("mean.score", item);
    if (mean == nullptr) continue;
    scores.add({item, count_cell(mean->n), cell_of(mean->value), found.interval("mean.score", item),
                found.cell("mean.rank", item)});
  }
  if (!scores.rows.empty()) outcome.tables.push_back(std::move(scores));
}

void add_pair_scale(const PairedStudy& study, const FoundNumbers& found, AnalysisOutcome& outcome) {
  const std::vector<std::string>& items = study.choices.items;
  if (found.find(kLogWorth, items.front()) == nullptr) {
    outcome.remarks.push_back(phrase(
        "Analysis",
        "The items cannot be placed on a scale by maximum likelihood: some of them were always or "
        "never chosen in the comparisons with the others, or were never compared with them, so "
        "that their distance has no finite estimate. Collect more comparisons of these items."));
    return;
  }
  add_worth_scale(
      {.log_worth = kLogWorth,
       .worth = "bt.worth",
       .no_interval = "bt.cluster.status",
       .title = phrase("Analysis", "The items on one scale"),
       .note = phrase(
           "Analysis",
           "Bradley–Terry model without ties: of two items, i is chosen with probability 1/(1 + "
           "exp(l_j − l_i)). The log-worths l have a mean of 0; the worths sum to 1. %1")},
      items, found, outcome);
}

/// "Bradley–Terry model with an order effect and ties", with the terms that could be estimated.
Phrase model_name(const FoundNumbers& found) {
  const bool has_order = found.find("model.order") != nullptr;
  const bool has_ties = found.find("model.tie") != nullptr;
  if (has_order && has_ties) {
    return phrase("Analysis", "Bradley–Terry model with an order effect and ties");
  }
  if (has_order) return phrase("Analysis", "Bradley–Terry model with an order effect");
  if (has_ties) return phrase("Analysis", "Bradley–Terry model with ties");
  return phrase("Analysis", "Bradley–Terry model");
}

/// The expected counts of the model are too small for the distribution of G² to be known.
bool is_fit_unreliable(const FoundNumbers& found) {
  const Finding* const approximation = found.find("model.fit.is_chi_squared");
  return approximation != nullptr && approximation->word == "FALSE";
}

/// "100 % of the expected counts are below 5, and the smallest is 0.2"
Phrase expected_counts_text(const FoundNumbers& found) {
  const double smallest = found.value("model.fit.smallest_expected").value_or(0.0);
  constexpr double kLeastShown = 0.1;
  return phrase("Analysis", "%1 of the expected counts are below 5, and the smallest is %2")
      .with(percent(found.value("model.fit.below_five").value_or(0.0)),
            smallest < kLeastShown ? "< 0.1" : fixed(smallest, 1));
}

/// Order effect, ties and fit of the scale.
void add_model(const PairedStudy& study, const FoundNumbers& found, AnalysisOutcome& outcome) {
  if (found.find("model.fit.lr") == nullptr) return;
  Phrase note =
      phrase("Analysis",
             "%1, by maximum likelihood (Davidson and Beaver 1977), with Wald 95 % CIs and "
             "likelihood-ratio tests. All responses are treated as independent, although "
             "those of one participant may not be: the p values are approximate.")
          .with(model_name(found));
  const auto add = [&note](const Phrase& sentence) {
    note = phrase("Analysis", "%1 %2").with(note, sentence);
  };
  if (found.find("model.order") != nullptr) {
    add(phrase("Analysis",
               "Order effect: increase in the log odds of being chosen for the item presented "
               "first."));
  }
  if (found.find("model.tie") != nullptr) {
    add(phrase(
        "Analysis",
        "Ties: ln ν, where ν is the odds of a tie between equal items, relative to the choice "
        "of one of them."));
  }
  if (is_fit_unreliable(found) && study.choices.items.size() > 2) {
    add(phrase("Analysis", "Goodness of fit has no p: %1.").with(expected_counts_text(found)));
  }
  ResultTable model{kModel,
                    phrase("Analysis", "Order effect, ties and goodness of fit of the scale"),
                    {columns::kMeasure, columns::kValue, interval_of(columns::kValue), kStatistic,
                     columns::kDf, columns::kP},
                    note};
  struct Row {
    const char* shown;
    QuantityName quantity;
    QuantityName likelihood_ratio;
    QuantityName df;
    QuantityName p;
  };
  for (const Row& row :
       {Row{"order_effect", "model.order", "model.order.lr", "model.order.df", "model.order.p"},
        Row{"log_tie", "model.tie", "", "", ""},
        Row{"equal_items", "", "model.equal.lr", "model.equal.df", "model.equal.p"},
        Row{"goodness_of_fit", "", "model.fit.lr", "model.fit.df", "model.fit.p"}}) {
    if (found.find(row.quantity) == nullptr && found.find(row.likelihood_ratio) == nullptr) {
      continue;
    }
    // Two items always lie on one scale.
    if (row.p == QuantityName("model.fit.p") && study.choices.items.size() < 3) continue;
    model.add({std::string(row.shown), found.cell(row.quantity), found.interval(row.quantity),
               found.cell(row.likelihood_ratio), found.count(row.df), found.cell(row.p)});
  }
  outcome.tables.push_back(std::move(model));
}

/// The consistency of the participants, over their complete rounds without ties.
struct ConsistencyOfPeople {
  std::vector<double> zetas{};  ///< the mean of each participant
  double under_guessing = 0.0;  ///< the mean ζ
};

ConsistencyOfPeople add_people_consistency(const PairedStudy& study, AnalysisOutcome& outcome) {
  const std::size_t items = study.choices.items.size();
  if (items < 3) return {};
  struct Rounds {
    std::size_t evaluated = 0;
    std::size_t triads = 0;
    double zetas = 0.0;
  };
  std::map<std::uint32_t, Rounds> of_people{};
  for (const auto& [of, comparisons] : study.rounds) {
    Rounds& rounds = of_people[std::get<0>(of)];
    const WinsOfJudge wins = wins_of_judge(comparisons, items);
    if (wins.problem) continue;
    const Consistency own = consistency(wins.wins);
    ++rounds.evaluated;
    rounds.triads += static_cast<std::size_t>(own.circular_triads);
    rounds.zetas += own.zeta;
  }
  ConsistencyOfPeople found{.under_guessing = mean_zeta_under_guessing(items)};
  const bool is_exact = items <= kMostItemsForExactTriads;
  const IntegerDistribution of_round =
      is_exact ? circular_triad_distribution(items) : IntegerDistribution{};
  ResultTable table{
      kConsistency,
      phrase("Analysis", "Consistency of the participants"),
      {columns::kParticipant, kRounds, kCircularTriads, kZeta, columns::kP},
      phrase("Analysis",
             "A round is one comparison of every pair, with the same levels of all other factors; "
             "rounds with a tie or without one of the pairs are left out. A triad is circular if a "
             "is chosen over b, b over c, and c over "
             "a: number per round. ζ, the coefficient of consistence: 1 without circular triads, 0 "
             "with as many as possible, %1 on average under guessing. p: exact probability of at "
             "most as many circular triads in these rounds under guessing, uncorrected.")
          .with(display_bounded(found.under_guessing))};
  for (const auto& [person, rounds] : of_people) {
    ResultRow row{
        study.choices.gathered.people[person].label, count_cell(rounds.evaluated), {}, {}, {}};
    if (rounds.evaluated > 0) {
      const auto n = static_cast<double>(rounds.evaluated);
      found.zetas.push_back(rounds.zetas / n);
      row[2] = static_cast<double>(rounds.triads) / n;
      row[3] = found.zetas.back();
      if (is_exact) {
        row[4] = repeated_sum(of_round, rounds.evaluated)
                     .lower_tail(static_cast<std::int64_t>(rounds.triads));
      }
    }
    table.add(std::move(row));
  }
  if (!found.zetas.empty()) outcome.tables.push_back(std::move(table));
  return found;
}

void ask_items(const PairedStudy& study, const FoundNumbers& found, const StudyTests& tests,
               AnalysisOutcome& outcome) {
  const Phrase question = phrase("Analysis", "Are some items chosen more often than others?");
  const Phrase method =
      phrase("Analysis",
             "Friedman test of each participant's proportion of the comparisons in which an item "
             "was chosen, a tie counting half; CIs of the means are t-based.");
  const Finding* most = nullptr;
  const Finding* least = nullptr;
  for (const std::string& item : study.choices.items) {
    const Finding* const mean = found.find("mean.score", item);
    if (mean == nullptr || !mean->value) continue;
    if (most == nullptr || *mean->value > *most->value) most = mean;
    if (least == nullptr || *mean->value < *least->value) least = mean;
  }
  const StudyTests::Test* const test = tests.find("preference");
  if (most == nullptr || test == nullptr || !test->p) {
    add_question(outcome, "preference", question,
                 study.by_person.size() == 1
                     ? phrase("Analysis", "This cannot be tested with one participant.")
                     : phrase("Analysis",
                              "Not tested: fewer than two participants compared every pair equally "
                              "often."),
                 method, "pairs", nullptr);
    return;
  }
  constexpr double kRounding = 1e-12;  // of means of the same proportions in a different order
  if (*most->value - *least->value < kRounding) {
    add_question(outcome, "preference", question,
                 phrase("Analysis", "No: all items were chosen equally often. Friedman test: %1.")
                     .with(p_text(*test)),
                 method, kScores, most);
    return;
  }
  const TestStatements statements = statements_of(
      *test, {.numbers = phrase("Analysis",
                                "%1 was chosen most often, in %2 of its comparisons (%3), and %4 "
                                "least often, in %5 (%6). Friedman test: %7.")
                             .with(most->key.last(), percent(*most->value), interval_text(*most),
                                   least->key.last(), percent(*least->value), interval_text(*least),
                                   p_text(*test))});
  add_question(outcome, "preference", question, said_of(*test, statements), method, kScores, most);
}

void ask_fit(const PairedStudy& study, const FoundNumbers& found, AnalysisOutcome& outcome) {
  if (study.choices.items.size() < 3) return;
  const Finding* const fit = found.find("model.fit.lr");
  if (fit == nullptr || found.find("model.fit.p") == nullptr) return;
  constexpr double kLevel = 0.05;
  const std::string statistic = statistic_text(
      "G²", std::vector<double>{found.value("model.fit.df").value_or(0.0)}, *fit->value);
  const Phrase question = phrase("Analysis", "Do the items lie on one scale?");
  const Phrase expected = expected_counts_text(found);
  if (is_fit_unreliable(found)) {
    add_question(
        outcome, "fit", question,
        phrase("Analysis",
               "This cannot be tested with so few comparisons: %1, so that the distribution of G² "
               "is unknown. Collect more comparisons of each pair.")
            .with(expected),
        phrase("Analysis",
               "A likelihood-ratio test requires that no expected count is below 1 and that at "
               "most 20 % of them are below 5 (Cochran 1954)."),
        kModel, nullptr);
    return;
  }
  const std::optional<double> p = found.value("model.fit.p");
  if (!p) return;
  add_question(
      outcome, "fit", question,
      (*p < kLevel
           ? phrase("Analysis",
                    "The comparisons differ significantly from the %1: %2, %3. Values on "
                    "one scale do not describe them completely.")
           : phrase("Analysis", "The comparisons do not differ significantly from the %1: %2, %3."))
          .with(model_name(found), statistic, display_p(*p)),
      phrase(
          "Analysis",
          "Likelihood-ratio test against a separate probability of each outcome for every pair, "
          "and for either order where the model has an order effect; all responses are treated as "
          "independent. Exploratory. %1.")
          .with(expected),
      kModel, fit, CountedUnit::answers);
}

void ask_consistency(const ConsistencyOfPeople& people, AnalysisOutcome& outcome) {
  if (people.zetas.empty()) return;
  FindingList findings{};
  add_mean_of_group("mean.zeta", "", people.zetas,
                    {.possible = ConfidenceInterval{0.0, 1.0},
                     .of = "mean of the participants' coefficients of consistence"},
                    findings);
  std::vector<Finding> made = findings.take();
  for (Finding& finding : made) finding.analysis = kConsistency;
  const FoundNumbers found(made);
  const Finding* const mean = found.find("mean.zeta");
  if (mean == nullptr || !mean->value) return;
  Phrase zeta = phrase("Analysis", "ζ = %1").with(display_bounded(*mean->value));
  if (mean->low && mean->high) {
    zeta = phrase("Analysis", "%1, 95 % CI [%2, %3]")
               .with(zeta, display_bounded(*mean->low), display_bounded(*mean->high));
  }
  add_question(outcome, kConsistency,
               phrase("Analysis", "Are the participants' choices consistent?"),
               phrase("Analysis",
                      "Mean coefficient of consistence: %1. It is 1 without circular triads, and "
                      "%2 on average under guessing.")
                   .with(zeta, display_bounded(people.under_guessing)),
               phrase("Analysis",
                      "Kendall’s ζ of each complete round without ties, averaged over the rounds "
                      "of a participant; the CI of the mean is t-based."),
               kConsistency, mean);
  keep_findings(made, outcome);
}

/// `found`: of `pair_findings`.
void add_tests_of_pairs(const PairedStudy& study, const FoundNumbers& found, StudyTests& tests) {
  const Selection& choices = study.choices;
  for (const ItemPair& pair : pairs_offered(choices)) {
    const std::string& first = choices.items[pair.first];
    const std::string& second = choices.items[pair.second];
    const FindingKey key{first, second};
    if (!study.shares.contains({pair.first, pair.second})) {
      tests.add_untested("pairs", {first, second}, "only_ties");
      continue;
    }
    tests.add("pairs", {first, second}, found, "signflip.p.two", key);
    state_share_of_pair(found, key, tests);
    const std::size_t compared = study.people_who_compared({pair.first, pair.second});
    tests.leave_out(
        compared - std::min(compared, tests.tests().back().n),
        phrase("Analysis",
               "Participants who tied %1 and %2 in every comparison are left out of the "
               "test of this pair")
            .with(first, second));
  }
}

/// `found`: of the family `rating` on `scores`. Returns whether there is a test.
bool add_preference_test(const PairedStudy& study, const PairScores& scores,
                         const FoundNumbers& found, StudyTests& tests) {
  const bool is_testable = study.by_person.size() >= scores.left_out + 2;
  if (is_testable) {
    tests.add("preference", "", found, "friedman.p");
  } else {
    tests.add_untested(
        "preference", "",
        study.by_person.size() == 1 ? StudyTests::kOneParticipantAlone : "pairs_incomplete");
  }
  tests.leave_out(
      scores.left_out,
      phrase("Analysis",
             "Participants who did not compare every pair equally often are left out of "
             "the test of the choices of the items"));
  return is_testable;
}

/// Which items are chosen: the mean proportion of a participant is the same for all, and no difference between groups.
GroupComparisons groups_compared(const PairedStudy& study, const PairScores& scores) {
  GroupComparisons groups(study.choices.gathered);
  if (study.choices.items.size() > 1) {
    groups.add(GroupProfile{.words = phrase("Analysis", "which items are chosen"),
                            .items = study.choices.items,
                            .values = scores.proportions});
  }
  return groups;
}

std::vector<Finding> findings_of_positions(const Selection& choices) {
  return analysis_of(
      "position", "selection",
      choices_table(
          choices, numbers_up_to(2),
          [&choices](const GatheredAnswer& answer) { return choices.position(answer); }, "1"));
}

}  // namespace

std::vector<StudyTest> test_paired_comparison(const GatheredAnswers& gathered) {
  StudyTests tests(gathered);
  const Selection choices(gathered);
  if (choices.items.size() < 2) return std::move(tests).take_family();
  const PairedStudy study(choices);
  if (tests.is_in_family("pairs")) {
    const std::vector<Finding> findings = pair_findings("choice", choices, "pairs");
    add_tests_of_pairs(study, FoundNumbers(findings), tests);
  }
  if (tests.is_in_family("preference")) {
    PairScores scores = pair_scores_of(study);
    const std::vector<Finding> findings = analysis_of(kScores, "rating", std::move(scores.input));
    add_preference_test(study, scores, FoundNumbers(findings), tests);
  }
  if (tests.is_in_family("position")) {
    const std::vector<Finding> findings = findings_of_positions(choices);
    const FoundNumbers found(findings);
    tests.add("position", "", found, "relabel.exact.p");
    state_share_of_pair(found, "1", tests);
  }
  if (tests.is_in_family(kGroupProfilesTest)) {
    AnalysisOutcome unused{};
    groups_compared(study, pair_scores_of(study)).add_tests(tests, unused);
  }
  return std::move(tests).take_family();
}

void analyze_paired_comparison(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const Selection choices(gathered);
  if (choices.items.size() < 2) {
    outcome.remarks.push_back(phrase("Analysis",
                                     "Fewer than two items were presented, so that no comparison "
                                     "is possible; present at least two items."));
    return;
  }
  const PairedStudy study(choices);
  StudyTests tests(gathered);

  const std::vector<Finding> of_pairs = pair_findings("choice", choices);
  const FoundNumbers found_pairs(of_pairs);
  keep_findings(of_pairs, outcome);
  add_tests_of_pairs(study, found_pairs, tests);

  PairScores scores = pair_scores_of(study);
  std::vector<Finding> of_scores = analysis_of(kScores, "rating", std::move(scores.input));
  for (Finding& finding : of_scores) {
    if (is(finding, "mean.score")) limit_to_proportions(finding, scores.trials);
  }
  const FoundNumbers found_scores(of_scores);
  if (add_preference_test(study, scores, found_scores, tests)) {
    // The pairs are tested by their own comparisons.
    keep_findings(of_scores, outcome, [](const Finding& finding) {
      return !finding.quantity.starts_with("wilcoxon.");
    });
  }

  const std::vector<Finding> of_positions = findings_of_positions(choices);
  const FoundNumbers found_positions(of_positions);
  // Those of single textures concern the item that was presented first.
  keep_findings(of_positions, outcome, [](const Finding& finding) {
    return finding.key.empty() || finding.quantity.starts_with("subj.");
  });
  tests.add("position", "", found_positions, "relabel.exact.p");
  state_share_of_pair(found_positions, "1", tests);

  std::vector<Finding> of_scale = analysis_of(kScale, "paired", comparisons_of(choices));
  const bool has_scale = FoundNumbers(of_scale).find(kLogWorth, choices.items.front()) != nullptr;
  // Ties can make the model finite where the scale, which leaves them out, is not.
  if (!has_scale) {
    std::erase_if(of_scale,
                  [](const Finding& finding) { return finding.quantity.starts_with("model."); });
  }
  const FoundNumbers found_scale(of_scale);
  keep_findings(of_scale, outcome);

  add_pair_tables(study, outcome);
  add_scores(study, found_scores, outcome);
  add_pair_scale(study, found_scale, outcome);
  add_model(study, found_scale, outcome);
  const ConsistencyOfPeople people = add_people_consistency(study, outcome);
  const GroupComparisons groups = groups_compared(study, scores);
  groups.add_tests(tests, outcome);
  tests.finish(outcome);
  state_means_of_items(outcome, {.analysis = kScores,
                                 .quantity = "mean.score",
                                 .items = study.choices.items,
                                 .tests = {"preference"},
                                 .shown = display_percent});
  // A pair is tested by its own comparisons, not by those with other items.
  state_means_of_items(outcome, {.analysis = "choice",
                                 .quantity = "subj.mean",
                                 .items = study.choices.items,
                                 .tests_of_pairs = {"pairs"},
                                 .within_pairs = true,
                                 .shown = display_percent});

  ask_items(study, found_scores, tests, outcome);
  ask_pairs({.question = phrase("Analysis", "Which item of a pair is chosen more often?"),
             .method = phrase("Analysis",
                              "For each pair, exact sign-flip (randomisation) test of each "
                              "participant's difference between the two counts (both labels "
                              "exchanged within a participant); ties are left out."),
             .nothing_chosen = phrase(
                 "Analysis", "No choice was made between two items; collect responses first."),
             .test = "pairs"},
            tests, found_pairs, outcome);
  ask_position(2,
               phrase("Analysis",
                      "Permutation test of the numbers of choices of the two positions, which are "
                      "exchanged within each participant; ties are left out."),
               found_positions, tests, outcome);
  ask_fit(study, found_scale, outcome);
  ask_consistency(people, outcome);
  groups.report(tests, outcome);
  remark_on_pooling(gathered.answers.size(), gathered.people.size(), outcome);
}

}  // namespace asperity
