// Averages ratings by participant and group of trials; a paired t test from the family `equivalence`.

#include "app/findings/shared/accompanying_scales.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "app/findings/gathering/answer_columns.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

constexpr const char* kAccompanying = "accompanying";
constexpr const char* kAccompanyingTest = "accompanying_scales";
constexpr QuantityName kMeanOfScale = "mean.score";
constexpr QuantityName kComparedMean = "mean.score.compared";
constexpr const char* kCorrectLevel = "correct";
constexpr const char* kIncorrectLevel = "incorrect";

/// The property of trials by which the rows of a scale are grouped.
const ResultColumn kTrialGroup{.id = "by",
                               .heading = phrase("AnalysisWords", "trials grouped by"),
                               .words = words_of_trial_group};

/// The ratings of a group of trials, summed for each participant.
struct SummedRatings {
  struct Sum {
    double total = 0.0;
    std::size_t n = 0;
    double mean() const { return total / static_cast<double>(n); }
  };
  std::map<std::uint32_t, Sum> of_people{};
  std::size_t responses = 0;

  void add(std::uint32_t person, double score) {
    Sum& sum = of_people[person];
    sum.total += score;
    ++sum.n;
    ++responses;
  }
};

/// By the property of the trials and its level; those of all trials first.
using RatingsByGroup = std::map<std::tuple<int, std::string, std::string>, SummedRatings>;

void add_rating(const GatheredAnswers& gathered, const GatheredAnswer& answer, double score,
                RatingsByGroup& groups) {
  const AccompaniedResponse& to = *answer.accompanied;
  const auto add = [&](int place, const char* by, const std::string& level) {
    groups[{place, by, level}].add(answer.person, score);
  };
  add(0, "all", "");
  if (to.correct) {
    add(1, "correctness", *to.correct ? kCorrectLevel : kIncorrectLevel);
  } else if (to.answer != kNoWord) {
    add(2, "chosen", gathered.word(to.answer));
  }
  const auto surfaces = gathered.surfaces_of(answer);
  if (surfaces.size() == 1) add(3, "presented", gathered.word(surfaces.front().item));
}

/// The means of correct and incorrect responses of the participants who have both.
TidyInput pairs_of_means(const GatheredAnswers& gathered, const SummedRatings& correct,
                         const SummedRatings& incorrect, const std::string& scale) {
  LabelRows people{};
  NumberColumn of_correct{};
  NumberColumn of_incorrect{};
  for (const auto& [person, sum] : correct.of_people) {
    const auto other = incorrect.of_people.find(person);
    if (other == incorrect.of_people.end()) continue;
    people.add(gathered.people[person].label);
    of_correct.push_back(sum.mean());
    of_incorrect.push_back(other->second.mean());
  }
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"subject", std::move(people).take()},
                                                           {"a", std::move(of_correct)},
                                                           {"b", std::move(of_incorrect)}},
                            "the ratings on " + scale);
  // The family reports the interval of two one-sided tests, 1 − 2α.
  input.options.set("alpha", 0.025);
  return input;
}

/// The means of both columns, over the same participants as the difference.
std::vector<Finding> means_of_pairs(const TidyInput& pairs, const FindingKey& key) {
  FindingList list{};
  for (const auto& [column, level] :
       {std::pair{"a", kCorrectLevel}, std::pair{"b", kIncorrectLevel}}) {
    add_mean_of_group(kComparedMean, {key, level}, pairs.table().all_numbers(column),
                      {.of = "mean of the participants with correct and incorrect responses"},
                      list);
  }
  std::vector<Finding> findings = list.take();
  for (Finding& finding : findings) finding.analysis = kAccompanying;
  return findings;
}

/// The findings of the family `equivalence` that belong to a paired t test.
bool is_of_paired_test(const Finding& finding) {
  return is(finding, "diff") || is(finding, "se") || is(finding, "df") || is(finding, "dz") ||
         is(finding, "t") || is(finding, "t.p.two");
}

std::vector<Finding> paired_test(TidyInput input, const FindingKey& key) {
  std::vector<Finding> findings = analysis_of(kAccompanying, "equivalence", std::move(input));
  std::erase_if(findings, [](const Finding& finding) { return !is_of_paired_test(finding); });
  for (Finding& finding : findings) {
    finding.key = key;
    finding.method = "correct − incorrect responses, within participants";
  }
  return findings;
}

}  // namespace

Phrase rating_text(const Finding& mean) {
  constexpr int kDecimals = 2;
  const std::string value = display_signed(*mean.value, kDecimals);
  if (!mean.low || !mean.high) return Phrase(value);
  return phrase("Analysis", "%1 (95 % CI [%2, %3])")
      .with(value, display_signed(*mean.low, kDecimals), display_signed(*mean.high, kDecimals));
}

FindingKey AccompanyingScales::Scale::Group::key(const Scale& scale) const {
  return {scale.key(), by, level};
}

AccompanyingScales::AccompanyingScales(const GatheredAnswers& gathered) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, RatingsByGroup> ratings{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const std::optional<double>& number = gathered.reply_of(answer).number;
    if (!number || !answer.accompanied) continue;
    add_rating(gathered, answer, *number, ratings[{answer.question, answer.accompanied->question}]);
  }
  for (const auto& [of, groups] : ratings) {
    Scale& scale = scales_.emplace_back(
        Scale{.name = gathered.word(of.first), .question = gathered.word(of.second)});
    FindingList means{};
    for (const auto& [group, ratings_of_group] : groups) {
      scale.groups.push_back({.by = std::get<1>(group),
                              .level = std::get<2>(group),
                              .responses = ratings_of_group.responses});
      std::vector<double> of_people{};
      for (const auto& [person, sum] : ratings_of_group.of_people) of_people.push_back(sum.mean());
      add_mean_of_group(kMeanOfScale, scale.groups.back().key(scale), of_people,
                        {.of = "mean of the participants with such trials"}, means);
    }
    scale.findings = means.take();
    for (Finding& finding : scale.findings) finding.analysis = kAccompanying;
    const auto correct = groups.find({1, "correctness", kCorrectLevel});
    const auto incorrect = groups.find({1, "correctness", kIncorrectLevel});
    if (correct == groups.end() || incorrect == groups.end()) continue;
    TidyInput pairs = pairs_of_means(gathered, correct->second, incorrect->second, scale.name);
    const std::size_t both = pairs.table().rows();
    scale.left_out = groups.begin()->second.of_people.size() - both;
    if (both == 0) continue;
    scale.compared_means = means_of_pairs(pairs, scale.key());
    scale.comparison = paired_test(std::move(pairs), scale.key());
  }
  // In the order of the protocol; the questions of the protocol have each name once.
  const auto place = [&gathered](const Scale& scale) {
    return std::find_if(gathered.questions.begin(), gathered.questions.end(),
                        [&scale](const auto& question) { return question.name == scale.name; });
  };
  std::stable_sort(scales_.begin(), scales_.end(), [&place](const Scale& one, const Scale& other) {
    return place(one) < place(other);
  });
}

bool AccompanyingScales::has(const std::string& scale) const {
  return std::any_of(scales_.begin(), scales_.end(),
                     [&scale](const Scale& one) { return one.name == scale; });
}

std::string AccompanyingScales::groups_text() const {
  std::set<std::string> by{};
  for (const Scale& scale : scales_) {
    for (const Scale::Group& group : scale.groups) by.insert(group.by);
  }
  std::vector<std::string> texts{};
  if (by.contains("correctness")) {
    texts.emplace_back("the trials with correct and over those with incorrect responses");
  }
  if (by.contains("chosen")) texts.emplace_back("the trials in which the same item was chosen");
  if (by.contains("presented")) texts.emplace_back("the trials with the same item");
  if (texts.empty()) texts.emplace_back("all trials");
  std::string text = texts.front();
  for (std::size_t i = 1; i < texts.size(); ++i) text += ", and over " + texts[i];
  return text;
}

void AccompanyingScales::add_tests(StudyTests& tests) const {
  for (const Scale& scale : scales_) {
    const bool has_responses = std::any_of(scale.groups.begin(), scale.groups.end(),
                                           [](const auto& one) { return one.by == "correctness"; });
    if (!has_responses) continue;
    const FoundNumbers found(scale.comparison);
    if (found.find("t.p.two", scale.key()) == nullptr) {
      tests.add_untested(kAccompanyingTest, scale.about(),
                         scale.comparison.empty() ? "not_both_correct_and_incorrect"
                                                  : "no_variance_of_differences");
      continue;
    }
    tests.add(kAccompanyingTest, scale.about(), found, "t.p.two", scale.key());
    if (scale.left_out > 0) {
      tests.leave_out(scale.left_out,
                      phrase("Analysis",
                             "Participants without both correct and incorrect responses are left "
                             "out of the test of the ratings on “%1”")
                          .with(scale.name));
    }
  }
}

Phrase AccompanyingScales::answer_text(const Scale& scale, const StudyTests& tests) {
  const FoundNumbers means(scale.findings);
  const auto mean = [&](const char* by, const char* level) {
    return means.find(kMeanOfScale, Scale::Group{.by = by, .level = level}.key(scale));
  };
  const Finding* const correct = mean("correctness", kCorrectLevel);
  const Finding* const incorrect = mean("correctness", kIncorrectLevel);
  if (correct == nullptr || incorrect == nullptr) {
    const Phrase all = phrase("Analysis", "The mean rating is %1 over all trials.")
                           .with(rating_text(*mean("all", "")));
    if (correct == nullptr && incorrect == nullptr) return all;
    return phrase("Analysis", "%1 %2")
        .with(all, correct == nullptr ? phrase("Analysis", "No response was correct.")
                                      : phrase("Analysis", "No response was incorrect."));
  }
  const FoundNumbers of_both(scale.compared_means);
  const auto compared_mean = [&](const char* level, const Finding* own) {
    const Finding* const found = of_both.find(kComparedMean, {scale.key(), level});
    return rating_text(found == nullptr ? *own : *found);
  };
  const Phrase means_text =
      phrase("Analysis", "The mean rating is %1 for correct responses and %2 for incorrect ones.")
          .with(compared_mean(kCorrectLevel, correct), compared_mean(kIncorrectLevel, incorrect));
  const FoundNumbers compared(scale.comparison);
  const Finding* const difference = compared.find("diff", scale.key());
  const StudyTests::Test* const test = tests.find(kAccompanyingTest, scale.about());
  if (difference == nullptr || test == nullptr || !test->p) {
    return phrase("Analysis", "%1 The difference could not be tested.").with(means_text);
  }
  const TestStatements statements = statements_of(
      *test, {.numbers = phrase("Analysis", "mean difference %1, N = %2, paired t test: %3.")
                             .with(rating_text(*difference), display_count(test->n), p_text(*test)),
              .significant = phrase("Analysis", "They differ significantly: %1"),
              .not_significant = phrase("Analysis", "They do not differ significantly: %1"),
              .exploratory = {}});
  return phrase("Analysis", "%1 %2").with(means_text, said_of(*test, statements));
}

void AccompanyingScales::report(const StudyTests& tests, AnalysisOutcome& outcome) const {
  using namespace columns;
  if (empty()) return;
  ResultTable table{
      kAccompanying,
      phrase("Analysis", "Ratings that accompany another question"),
      {kScale, kQuestion, kTrialGroup, kFactorLevel, kPersons, kAnswers, kMean, interval_of(kMean)},
      phrase("Analysis",
             "Means of the participants' mean ratings over such trials, of the participants who "
             "have any, with t-based 95 % CIs; difference: of the participants who have both "
             "correct and incorrect responses.")};
  for (const Scale& scale : scales_) {
    const FoundNumbers found(scale.findings);
    const FoundNumbers compared(scale.comparison);
    const auto add_row = [&](const std::string& by, const std::string& level, ResultCell responses,
                             const FoundNumbers& numbers, QuantityName quantity,
                             const FindingKey& key) {
      const Finding* const mean = numbers.find(quantity, key);
      if (mean == nullptr) return;
      table.add({scale.name, scale.question, by, word_cell(level), count_cell(mean->n),
                 std::move(responses), cell_of(mean->value), numbers.interval(quantity, key)});
    };
    for (std::size_t i = 0; i < scale.groups.size(); ++i) {
      const Scale::Group& group = scale.groups[i];
      add_row(group.by, group.level, count_cell(group.responses), found, kMeanOfScale,
              group.key(scale));
      const bool is_last_of_correctness =
          group.by == "correctness" &&
          (i + 1 == scale.groups.size() || scale.groups[i + 1].by != group.by);
      if (is_last_of_correctness) {
        add_row("difference", "", {}, compared, "diff", scale.key());
      }
    }
    keep_findings(scale.findings, outcome);
    keep_findings(scale.comparison, outcome);
    keep_findings(scale.compared_means, outcome);
    state_means_of(scale, outcome);
    const bool has_comparison = !scale.comparison.empty();
    add_question(
        outcome, ("accompanying_" + scale.name + '_' + scale.question).c_str(),
        has_comparison
            ? phrase("Analysis",
                     "Do the ratings on the scale “%1” differ between correct and incorrect "
                     "responses to the question “%2”?")
                  .with(scale.name, scale.question)
            : phrase("Analysis",
                     "How high are the ratings on the scale “%1”, which accompanies the question "
                     "“%2”?")
                  .with(scale.name, scale.question),
        answer_text(scale, tests),
        phrase("Analysis",
               "Means of the participants' mean ratings, with t-based CIs; a paired t test "
               "compares correct and incorrect responses."),
        kAccompanying,
        has_comparison ? FoundNumbers(scale.comparison).find("diff", scale.key())
                       : FoundNumbers(scale.findings)
                             .find(kMeanOfScale, Scale::Group{.by = "all"}.key(scale)));
  }
  outcome.tables.push_back(std::move(table));
}

void AccompanyingScales::state_means_of(const Scale& scale, AnalysisOutcome& outcome) {
  const FoundNumbers found(scale.compared_means);
  const Finding* const correct = found.find(kComparedMean, {scale.key(), kCorrectLevel});
  const Finding* const incorrect = found.find(kComparedMean, {scale.key(), kIncorrectLevel});
  if (correct == nullptr || incorrect == nullptr) return;
  state_means(outcome, kAccompanyingTest,
              "means: " + rating_text(*correct).english() + " for correct responses and " +
                  rating_text(*incorrect).english() + " for incorrect ones",
              scale.about());
}

}  // namespace asperity
