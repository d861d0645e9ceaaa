// Calls the family `group` for each pair of groups in which both have responses.

#include "app/findings/shared/participant_pairs.h"

#include <algorithm>
#include <utility>

#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/shared/group_equivalence.h"

namespace asperity {

namespace {

/// For the family `group`: a row per participant of either level; nothing without participants of both.
std::optional<TidyInput> table_of_pair(const GatheredAnswers& gathered, const ParticipantPair& pair,
                                       std::span<const HitCount> own) {
  PairRows rows(gathered, pair);
  NumberColumn correct{};
  NumberColumn trials{};
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].trials == 0 || !rows.add(i)) continue;
    correct.push_back(static_cast<double>(own[i].hits));
    trials.push_back(static_cast<double>(own[i].trials));
  }
  return std::move(rows).take({{"correct", std::move(correct)}, {"trials", std::move(trials)}});
}

/// "95 % CI [2.10, 2.90]" for an estimate other than a proportion.
Phrase plain_interval(const Finding& finding, int digits) {
  if (finding.low && finding.high) {
    return phrase("Analysis", "95 % CI [%1, %2]")
        .with(display_signed(*finding.low, digits), display_signed(*finding.high, digits));
  }
  return phrase("Analysis", "without a CI");
}

/// The same for a difference, whose p comes from a different method than its interval.
Phrase interval_of_difference(const Finding& finding, int digits) {
  if (finding.low && finding.high) {
    return phrase("Analysis", "Welch 95 % CI [%1, %2]")
        .with(display_signed(*finding.low, digits), display_signed(*finding.high, digits));
  }
  return phrase("Analysis", "without a CI");
}

Phrase method_of_pair(const PairMeans& means, const StudyTest& test) {
  const Phrase own = phrase("Analysis", "Means of the participants' own results.");
  const Phrase intervals =
      means.difference->low
          ? phrase(
                "Analysis",
                "%1 The CIs of the means are t-based, for proportions on the logit scale; that "
                "of the difference is Welch's CI. p is computed by a different method: in "
                "borderline cases p may be below .05 although the CI contains 0, or the reverse.")
                .with(own)
          : own;
  return phrase("Analysis", "%1 %2").with(intervals, method_of_splits(test));
}

Phrase means_text(const ParticipantPair& pair, const PairMeans& means, const Phrase& first,
                  const Phrase& second) {
  switch (means.scale) {
    case PairScale::shares_of_answers:
      return phrase("Analysis", "the mean proportion correct is %1 for %3 and %2 for %4")
          .with(first, second, pair.first_name, pair.second_name);
    case PairScale::shares_of_items:
      return phrase("Analysis",
                    "the mean proportion of correctly matched items is %1 for %3 and %2 for %4")
          .with(first, second, pair.first_name, pair.second_name);
    case PairScale::items:
      return phrase("Analysis",
                    "the mean number of correctly matched items per trial is %1 for %3 and %2 for "
                    "%4")
          .with(first, second, pair.first_name, pair.second_name);
    case PairScale::shares_of_target:
      break;
  }
  return phrase("Analysis", "the mean proportion of choices of %5 is %1 for %3 and %2 for %4")
      .with(first, second, pair.first_name, pair.second_name, means.target);
}

}  // namespace

bool PairRows::add(std::size_t person) {
  const std::string& level = pair_.levels[person];
  if (level.empty()) return false;
  has_[level == pair_.first ? 0 : 1] = true;
  subjects_.add(gathered_.people[person].label);
  levels_.add(level);
  if (!pair_.blocks.empty()) blocks_.add(pair_.blocks[person]);
  return true;
}

std::optional<TidyInput> PairRows::take(std::vector<TidyTable::Column> further) && {
  if (!has_[0] || !has_[1]) return std::nullopt;
  std::vector<TidyTable::Column> columns{{"subject", std::move(subjects_).take()},
                                         {"group", std::move(levels_).take()}};
  if (!pair_.blocks.empty()) columns.push_back({"block", std::move(blocks_).take()});
  for (TidyTable::Column& column : further) columns.push_back(std::move(column));
  TidyInput input{};
  input.tables.emplace_back(std::move(columns), "the participants");
  input.options.set("groups", std::vector<std::string>{pair_.first, pair_.second});
  return input;
}

Phrase method_of_splits(const StudyTest& test) {
  const std::size_t drawn = test.random_permutations.value_or(0);
  const Phrase splits =
      drawn == 0
          ? phrase("Analysis", "The permutation test uses all permutations of the group labels.")
          : phrase("Analysis",
                   "The permutation test uses %1 permutations of the group labels drawn at "
                   "random, because there are too many to enumerate.")
                .with(std::to_string(drawn));
  if (!test.permutes_within_blocks) return splits;
  return phrase("Analysis",
                "%1 Labels are exchanged only within the blocks in which the groups were assigned.")
      .with(splits);
}

ParticipantPair women_and_men(const GatheredAnswers& gathered) {
  ParticipantPair pair{.test = kSexesTest,
                       .analysis = kSexesTest,
                       .equivalence = kSexesEquivalence,
                       .first = "F",
                       .second = "M",
                       .first_name = phrase("Analysis", "women"),
                       .second_name = phrase("Analysis", "men"),
                       .question = phrase("Analysis", "Do women and men differ?"),
                       .equivalence_question = phrase("Analysis", "Are women and men equivalent?")};
  for (const AnsweringPerson& person : gathered.people) {
    const std::string sex = person.sex.value_or("");
    pair.levels.push_back(sex == "F" || sex == "M" ? sex : "");
  }
  return pair;
}

std::vector<ParticipantPair> pairs_of_groups(const GatheredAnswers& gathered) {
  std::vector<ParticipantPair> pairs{};
  const std::vector<std::string>& groups = gathered.groups;
  const bool has_blocks =
      std::any_of(gathered.people.begin(), gathered.people.end(),
                  [](const AnsweringPerson& person) { return person.block.has_value(); });
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      ParticipantPair pair{
          .test = kGroupsTest,
          .analysis = kGroupsTest,
          .equivalence = kGroupsEquivalence,
          .first = groups[i],
          .second = groups[j],
          .first_name = groups[i],
          .second_name = groups[j],
          .question =
              phrase("Analysis", "Do the groups %1 and %2 differ?").with(groups[i], groups[j]),
          .equivalence_question = phrase("Analysis", "Are the groups %1 and %2 equivalent?")
                                      .with(groups[i], groups[j])};
      if (groups.size() > 2) {  // every pair has findings of the same names
        for (std::string* name : {&pair.analysis, &pair.equivalence})
          *name += ':' + pair.about().text();
      }
      for (const AnsweringPerson& person : gathered.people) {
        const std::string group = person.group.value_or("");
        pair.levels.push_back(group == pair.first || group == pair.second ? group : "");
        if (has_blocks) pair.blocks.push_back(person.block.value_or(""));
      }
      pairs.push_back(std::move(pair));
    }
  }
  return pairs;
}

void ask_pair(const ParticipantPair& pair, const PairMeans& means, const StudyTests& tests,
              AnalysisOutcome& outcome) {
  const StudyTests::Test* test = tests.find(pair.test, pair.about());
  const auto has_value = [](const std::optional<Finding>& one) { return one && one->value; };
  if (!has_value(means.first) || !has_value(means.second) || !has_value(means.difference) ||
      test == nullptr) {
    return;
  }
  const bool are_shares = means.scale != PairScale::items;
  const auto mean = [are_shares](const Finding& of) {
    return phrase("Analysis", "%1 (%2, n = %3)")
        .with(are_shares ? percent(*of.value) : Phrase(display_signed(*of.value, 2)),
              are_shares ? interval_text(of) : plain_interval(of, 2), std::to_string(of.n));
  };
  const Phrase of_both = means_text(pair, means, mean(*means.first), mean(*means.second));
  Finding shown = *means.difference;
  for (std::optional<double>* number : {&shown.value, &shown.low, &shown.high}) {
    if (*number && are_shares) **number *= 100.0;
  }
  const int digits = are_shares ? 1 : 2;
  const Phrase difference =
      (are_shares ? phrase("Analysis", "%1 percentage points (%2)")
                  : phrase("Analysis", "%1 items (%2)"))
          .with(display_signed(*shown.value, digits), interval_of_difference(shown, digits));
  state_means(outcome, test->name, of_both.english() + "; difference " + difference.english(),
              test->about);
  const TestStatements statements = statements_of(
      *test,
      {.numbers =
           phrase("Analysis", "%1; difference (%4 − %5) %2. Permutation test of group labels: %3.")
               .with(of_both, difference, p_text(*test), pair.first_name, pair.second_name),
       .compares = true});
  add_question(outcome, pair.analysis.c_str(), pair.question, said_of(*test, statements),
               method_of_pair(means, *test), "tests", &*means.difference);
}

PairComparisons::PairComparisons(const GatheredAnswers& gathered,
                                 const std::vector<ParticipantPair>& pairs,
                                 std::span<const HitCount> own)
    : gathered_(gathered) {
  for (const HitCount& count : own) {
    proportions_.push_back(count.trials > 0 ? std::optional(proportion(count)) : std::nullopt);
  }
  for (const ParticipantPair& pair : pairs) {
    std::optional<TidyInput> table = table_of_pair(gathered, pair, own);
    if (!table) continue;
    compared_.push_back({pair, analysis_of(pair.analysis.c_str(), "group", std::move(*table))});
  }
}

void PairComparisons::add_tests(StudyTests& tests, AnalysisOutcome& outcome) const {
  for (const Compared& one : compared_) {
    keep_findings(one.findings, outcome);
    const FoundNumbers found(one.findings);
    tests.add(one.pair.test, one.pair.about(), found, "perm.p.two");
    tests.state_difference(found.find("subj.diff"));
    if (!one.pair.blocks.empty()) tests.permute_within_blocks();
  }
}

void PairComparisons::ask(PairScale scale, const std::string& target, const StudyTests& tests,
                          AnalysisOutcome& outcome) const {
  for (const Compared& one : compared_) {
    const FoundNumbers found(one.findings);
    const auto of = [&found](QuantityName quantity, const FindingKey& key) {
      const Finding* finding = found.find(quantity, key);
      return finding == nullptr ? std::nullopt : std::optional(*finding);
    };
    ask_pair(one.pair,
             {.first = of("subj.mean", one.pair.first),
              .second = of("subj.mean", one.pair.second),
              .difference = of("subj.diff", ""),
              .scale = scale,
              .target = target},
             tests, outcome);
    if (scale != PairScale::shares_of_target) {
      ask_equivalence(one.pair, gathered_, proportions_, outcome);
    }
  }
}

}  // namespace asperity
