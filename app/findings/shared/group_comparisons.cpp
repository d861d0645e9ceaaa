// Calls the family `group_values` for each pair of groups and each measure or profile.

#include "app/findings/shared/group_comparisons.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/test_sentences.h"

namespace asperity {

namespace {

constexpr const char* kFamily = "group_values";

const ResultColumn kGroup{.id = "group", .heading = phrase("AnalysisWords", "group")};
/// "haptic − visual", as their difference.
const ResultColumn kGroups{.id = "groups", .heading = phrase("AnalysisWords", "groups")};
const ResultColumn kOfWhat{.id = "of", .heading = phrase("AnalysisWords", "measure")};
const ResultColumn kMeanOfUnit{
    .id = "mean", .heading = phrase("AnalysisWords", "mean"), .digits = Digits::of_row};

/// "12.3 µm (95 % CI [10 µm, 14.6 µm])", "0.52 (95 % CI [0.41, 0.63])"
Phrase with_interval(const Finding& number, bool is_ratio) {
  if (number.unit != "1" || is_ratio) return quantity_with_interval(number);
  constexpr int kDecimals = 2;
  const std::string value = display_signed(*number.value, kDecimals);
  if (!number.low || !number.high) return Phrase(value);
  return phrase("Analysis", "%1 (95 % CI [%2, %3])")
      .with(value, display_signed(*number.low, kDecimals), display_signed(*number.high, kDecimals));
}

/// The mean of a group, and how many participants it is of.
Phrase mean_of(const FoundNumbers& found, const std::string& group, bool is_ratio) {
  const Finding& mean = *found.find("values.mean", group);
  return phrase("Analysis", "%1 in the group %2 (n = %3)")
      .with(with_interval(mean, is_ratio), group, std::to_string(mean.n));
}

std::size_t missing_in(const FoundNumbers& found, const ParticipantPair& pair) {
  double missing = 0.0;
  for (const std::string& group : {pair.first, pair.second}) {
    missing += found.value("values.missing", group).value_or(0.0);
  }
  return static_cast<std::size_t>(missing);
}

/// The items for which both groups have a number: the factor of the groups can determine what is felt.
std::vector<std::string> items_of_pair(const GroupProfile& profile, const ParticipantPair& pair) {
  std::set<std::pair<std::string, std::string>> of_group{};
  for (const auto& [of, value] : profile.values)
    of_group.insert({pair.levels[of.first], of.second});
  std::vector<std::string> items{};
  std::copy_if(
      profile.items.begin(), profile.items.end(), std::back_inserter(items),
      [&](const std::string& item) {
        return of_group.contains({pair.first, item}) && of_group.contains({pair.second, item});
      });
  return items;
}

Phrase question_about(const ParticipantPair& pair, const Phrase& words) {
  return phrase("Analysis", "Do the groups %1 and %2 differ in %3?")
      .with(pair.first, pair.second, words);
}

}  // namespace

std::string GroupComparisons::Compared::analysis() const {
  std::string text = pair.analysis;
  if (is_profile) text.replace(0, std::string_view(kGroupsTest).size(), kGroupProfilesTest);
  return name.empty() ? text : text + ':' + name;
}

GroupComparisons::GroupComparisons(const GatheredAnswers& gathered)
    : gathered_(gathered), pairs_(pairs_of_groups(gathered)) {}

void GroupComparisons::add(const GroupMeasure& measure) {
  std::map<std::uint32_t, std::optional<double>> values = measure.values;
  // Of the only measure everyone who responded is a participant, also without the responses that it takes.
  if (measure.name.empty()) {
    for (std::uint32_t person = 0; person < gathered_.people.size(); ++person) {
      values.try_emplace(person, std::nullopt);
    }
  }
  if (!pairs_.empty()) missing_.emplace(kGroupsTest, "groups_share_no_condition");
  for (const ParticipantPair& pair : pairs_) {
    PairRows rows(gathered_, pair);
    NumberColumn numbers{};
    for (const auto& [person, value] : values) {
      if (rows.add(person)) numbers.push_back(value);
    }
    std::optional<TidyInput> input = std::move(rows).take({{"value", std::move(numbers)}});
    if (!input) continue;
    input->options.set("scale", std::string(measure.is_ratio ? "ratio" : "difference"));
    Compared& one = compared_.emplace_back(
        Compared{.pair = pair, .name = measure.name, .words = measure.words, .unit = measure.unit});
    one.findings = analysis_of(one.analysis().c_str(), kFamily, std::move(*input));
    for (Finding& finding : one.findings) {
      const bool has_unit =
          is(finding, "values.mean") || (!measure.is_ratio && is(finding, "values.shift"));
      if (has_unit) finding.unit = measure.unit;
    }
  }
}

void GroupComparisons::add(const GroupProfile& profile) {
  std::set<std::uint32_t> people{};
  for (const auto& [of, value] : profile.values) people.insert(of.first);
  if (profile.name.empty()) {
    for (std::uint32_t person = 0; person < gathered_.people.size(); ++person) {
      people.insert(person);
    }
  }
  if (!pairs_.empty()) missing_.emplace(kGroupProfilesTest, "fewer_than_two_shared_items");
  for (const ParticipantPair& pair : pairs_) {
    const std::vector<std::string> items_of_both = items_of_pair(profile, pair);
    if (items_of_both.size() < 2) continue;
    PairRows rows(gathered_, pair);
    NumberColumn numbers{};
    LabelRows items{};
    for (const std::uint32_t person : people) {
      for (const std::string& item : items_of_both) {
        if (!rows.add(person)) continue;
        const auto value = profile.values.find({person, item});
        numbers.push_back(value == profile.values.end() ? std::nullopt
                                                        : std::optional(value->second));
        items.add(item);
      }
    }
    std::optional<TidyInput> input =
        std::move(rows).take({{"value", std::move(numbers)}, {"item", std::move(items).take()}});
    if (!input) continue;
    Compared& one = compared_.emplace_back(Compared{.pair = pair,
                                                    .name = profile.name,
                                                    .words = profile.words,
                                                    .is_profile = true,
                                                    .items = items_of_both});
    one.findings = analysis_of(one.analysis().c_str(), kFamily, std::move(*input));
  }
}

void GroupComparisons::add_tests(StudyTests& tests, AnalysisOutcome& outcome) const {
  for (const char* const test : {kGroupsTest, kGroupProfilesTest}) {
    const bool is_compared =
        std::any_of(compared_.begin(), compared_.end(),
                    [test](const Compared& one) { return one.test() == std::string_view(test); });
    if (!is_compared && tests.is_in_family(test) && missing_.contains(test)) {
      tests.add_untested(test, "", missing_.at(test));
    }
  }
  for (const Compared& one : compared_) {
    keep_findings(one.findings, outcome);
    const FoundNumbers found(one.findings);
    const QuantityName p = one.is_profile ? QuantityName("profile.perm.p")
                           : found.find("values.log.perm.p.two") != nullptr
                               ? QuantityName("values.log.perm.p.two")
                               : "values.perm.p.two";
    if (found.find(p) == nullptr) {
      tests.add_untested(one.test(), one.about(), "no_numbers_of_group");
      continue;
    }
    tests.add(one.test(), one.about(), found, p);
    if (!one.pair.blocks.empty()) tests.permute_within_blocks();
    if (one.is_profile) {
      tests.leave_out(static_cast<std::size_t>(found.value("profile.incomplete").value_or(0.0)),
                      phrase("Analysis",
                             "Participants without a number for every item are left out of the "
                             "test of the %1")
                          .with(words_of_test(one.test(), one.about())));
      continue;
    }
    const Finding* const ratio = found.find("values.ratio");
    const Finding* const effect = ratio != nullptr ? ratio : found.find("values.shift");
    tests.state_effect(effect, ratio != nullptr ? "ratio" : "difference");
    ratio != nullptr ? tests.state_ratio(ratio) : tests.state_difference(effect);
    tests.leave_out(missing_in(found, one.pair),
                    phrase("Analysis",
                           "Participants for whom this number is missing are left out of the test "
                           "of the %1")
                        .with(words_of_test(one.test(), one.about())));
  }
}

void GroupComparisons::ask_measure(const Compared& one, const StudyTests& tests,
                                   AnalysisOutcome& outcome) const {
  const FoundNumbers found(one.findings);
  const StudyTest* const test = tests.find(one.test(), one.about());
  if (test == nullptr || !test->p) return;
  const Finding* const ratio = found.find("values.ratio");
  const Finding& effect = ratio != nullptr ? *ratio : *found.find("values.shift");
  const Phrase means = phrase("Analysis", "%1: %2, %3")
                           .with(one.words, mean_of(found, one.pair.first, ratio != nullptr),
                                 mean_of(found, one.pair.second, ratio != nullptr));
  const Phrase difference =
      (ratio != nullptr ? phrase("Analysis", "ratio %1 / %2: %3")
                        : phrase("Analysis", "difference (%1 − %2): %3"))
          .with(one.pair.first, one.pair.second, with_interval(effect, ratio != nullptr));
  state_means(outcome, test->name, means.english() + "; " + difference.english(), test->about);
  const Phrase kind_of_effect =
      ratio != nullptr ? phrase("Analysis", "ratio") : phrase("Analysis", "difference");
  const std::size_t missing = missing_in(found, one.pair);
  const auto with_left_out = [&](const Phrase& answer) {
    if (missing == 0) return answer;
    return phrase("Analysis",
                  "%1 Left out: %2 of %3 participants, for whom this number is missing; the "
                  "comparison does not describe them and therefore has no CI.")
        .with(answer, std::to_string(missing), std::to_string(missing + test->n));
  };
  const TestStatements statements =
      statements_of(*test,
                    {.numbers = phrase("Analysis", "%1; %2. Permutation test of group labels: %3.")
                                    .with(means, difference, p_text(*test)),
                     .compares = true})
          .with(with_left_out);
  const Phrase splits = method_of_splits(*test);
  const Phrase method = effect.low
                            ? phrase("Analysis",
                                     "%1 The CIs of the means are t-based; that of the %2 is "
                                     "Welch's CI.")
                                  .with(splits, kind_of_effect)
                            : splits;
  add_question(outcome, one.analysis().c_str(), question_about(one.pair, one.words),
               said_of(*test, statements), method, kGroupMeans, &effect);
}

void GroupComparisons::ask_profile(const Compared& one, const StudyTests& tests,
                                   AnalysisOutcome& outcome) const {
  const FoundNumbers found(one.findings);
  const StudyTest* const test = tests.find(one.test(), one.about());
  if (test == nullptr || !test->p) return;
  const Finding& r2 = *found.find("profile.r2");
  const std::vector<const Finding*> differences = found.all("profile.diff");
  const Finding& greatest = **std::max_element(
      differences.begin(), differences.end(),
      [](const Finding* a, const Finding* b) { return std::abs(*a->value) < std::abs(*b->value); });
  const Phrase largest =
      phrase("Analysis",
             "the largest difference (%1 − %2), each participant's mean removed, is "
             "that of %3, %4")
          .with(one.pair.first, one.pair.second, words_of_item(greatest.key.text()),
                display_signed(*greatest.value, 2));
  const auto with_left_out = [&](const Phrase& answer) {
    const auto missing = static_cast<std::size_t>(found.value("profile.incomplete").value_or(0.0));
    if (missing == 0) return answer;
    return phrase("Analysis",
                  "%1 Left out: %2 of %3 participants, who do not have a number for every item; "
                  "the comparison does not describe them and therefore has no CI.")
        .with(answer, std::to_string(missing), std::to_string(missing + test->n));
  };
  const TestStatements statements =
      statements_of(*test,
                    {.numbers = phrase("Analysis",
                                       "a proportion R² = %1 of the variation of the profiles is "
                                       "between the groups; %2. Permutation test of group "
                                       "labels: %3.")
                                    .with(display_bounded(*r2.value), largest, p_text(*test)),
                     .compares = true})
          .with(with_left_out);
  add_question(
      outcome, one.analysis().c_str(), question_about(one.pair, one.words),
      said_of(*test, statements),
      phrase("Analysis",
             "From each participant's numbers the participant's mean is subtracted, so that what "
             "is compared is how they differ between items. Whole participants are permuted. %1 "
             "Where the groups are equal, R² is %2 on average.")
          .with(method_of_splits(*test),
                display_bounded(1.0 / static_cast<double>(std::max<std::size_t>(r2.n, 2) - 1))),
      kGroupProfiles, &r2);
}

void GroupComparisons::add_table_of_means(AnalysisOutcome& outcome) const {
  using namespace columns;
  ResultTable table{kGroupMeans,
                    phrase("Analysis", "Means of the groups"),
                    {kOfWhat, kGroup, kPersons, kLeftOut, kMeanOfUnit, interval_of(kMeanOfUnit)},
                    phrase("Analysis",
                           "Means of the participants of each group, geometric where a ratio is "
                           "compared, with t-based 95 % CIs. left out: participants for whom "
                           "the number is missing; where there are any, there is no CI.")};
  std::set<std::pair<std::string, std::string>> listed{};  // a group is in several pairs
  for (const Compared& one : compared_) {
    if (one.is_profile) continue;
    const FoundNumbers found(one.findings);
    for (const std::string& group : {one.pair.first, one.pair.second}) {
      const Finding* const mean = found.find("values.mean", group);
      if (mean == nullptr || !listed.insert({one.name, group}).second) continue;
      const auto missing =
          static_cast<std::size_t>(found.value("values.missing", group).value_or(0.0));
      table.add({word_cell(one.name), group, count_cell(mean->n),
                 missing == 0 ? ResultCell{} : count_cell(missing),
                 quantity_cell(mean->value, one.unit == "1" ? "" : one.unit),
                 interval_cell(mean->low, mean->high, one.unit == "1" ? "" : one.unit)});
    }
  }
  if (!table.rows.empty()) outcome.tables.push_back(std::move(table));
}

void GroupComparisons::add_table_of_profiles(AnalysisOutcome& outcome) const {
  using namespace columns;
  ResultTable table{
      kGroupProfiles,
      phrase("Analysis", "Profiles of the groups"),
      {kOfWhat, kGroups, kItem, kFirst, kSecond, kDifference, interval_of(kDifference)},
      phrase("Analysis",
             "Means of the participants' numbers, without each participant's own mean, in the "
             "first and second of the groups; their difference with Welch's 95 % CI, without "
             "correction for the number of items.")};
  for (const Compared& one : compared_) {
    if (!one.is_profile) continue;
    const FoundNumbers found(one.findings);
    for (const std::string& item : one.items) {
      if (found.find("profile.diff", item) == nullptr) continue;
      table.add({word_cell(one.name), one.pair.first + " − " + one.pair.second, item,
                 found.cell("profile.mean", {one.pair.first, item}),
                 found.cell("profile.mean", {one.pair.second, item}),
                 found.cell("profile.diff", item), found.interval("profile.diff", item)});
    }
  }
  if (!table.rows.empty()) outcome.tables.push_back(std::move(table));
}

void GroupComparisons::report(const StudyTests& tests, AnalysisOutcome& outcome) const {
  for (const Compared& one : compared_) {
    if (one.is_profile) {
      ask_profile(one, tests, outcome);
    } else {
      ask_measure(one, tests, outcome);
    }
  }
  add_table_of_means(outcome);
  add_table_of_profiles(outcome);
}

}  // namespace asperity
