// Runs the analysis without the excluded and with all participants; the main tables of the latter are renamed.

#include "app/findings/methods/discrimination/catch/catch_exclusions.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/findings/outcome/result_table.h"
#include "app/findings/outcome/study_tests.h"

namespace asperity {

namespace {

Phrase words_of_rule(const CatchExclusion& rule) {
  if (rule.more_errors_than == 1) return phrase("Analysis", "more than 1 error");
  return rule.more_errors_than ? phrase("Analysis", "more than %1 errors")
                                     .with(std::to_string(*rule.more_errors_than))
                               : phrase("Analysis", "errors in more than %1 of the catch trials")
                                     .with(display_percent(rule.error_rate_above.value_or(0.0)));
}

bool is_main_result(const std::string& name) {
  return name == kThresholds || name == kMeanThresholds || name == StudyTests::kTable;
}

const ResultColumn kErrors{.id = "errors", .heading = phrase("AnalysisWords", "errors")};
const ResultColumn kExcluded{.id = "excluded", .heading = phrase("AnalysisWords", "excluded")};

void add_results_of_all(AnalysisOutcome of_all, AnalysisOutcome& outcome) {
  for (ResultTable& table : of_all.tables) {
    if (!is_main_result(table.name)) continue;
    table.name += kWithExcluded;
    table.figures = nullptr;  // they are those of the results without the excluded
    table.title = phrase("Analysis", "%1, with the excluded participants").with(table.title);
    outcome.tables.push_back(std::move(table));
  }
  for (Finding& finding : of_all.findings) {
    if (!is_main_result(finding.analysis)) continue;
    finding.analysis += kWithExcluded;
    outcome.findings.push_back(std::move(finding));
  }
}

void add_exclusions(const CatchExclusion& rule, const std::vector<CatchErrors>& all,
                    AnalysisOutcome& outcome) {
  ResultTable made{kExclusions,
                   phrase("Analysis", "Exclusions by errors in catch trials"),
                   {columns::kParticipant, kErrors, columns::kOf, columns::kShare, kExcluded},
                   phrase("Analysis",
                          "Rule that the protocol declares: participants with %1 are excluded, all "
                          "types of catch trials and all blocks together. Their stored responses "
                          "are unchanged.")
                       .with(words_of_rule(rule))};
  for (const CatchErrors& each : all) {
    made.add({each.participant, count_cell(each.errors), count_cell(each.trials),
              static_cast<double>(each.errors) / static_cast<double>(each.trials),
              std::string(is_excluded(rule, each) ? "yes" : "no")});
  }
  outcome.tables.push_back(std::move(made));
}

}  // namespace

std::vector<CatchErrors> catch_errors(const GatheredAnswers& gathered) {
  std::vector<CatchErrors> all{};
  for (const CatchResponses& each : gathered.catch_responses) {
    auto known = std::find_if(all.begin(), all.end(), [&each](const CatchErrors& of) {
      return of.participant == each.participant;
    });
    if (known == all.end()) known = all.insert(known, {.participant = each.participant});
    known->errors += each.trials - each.correct;
    known->trials += each.trials;
  }
  return all;
}

bool is_excluded(const CatchExclusion& rule, const CatchErrors& errors) {
  const auto count = static_cast<double>(errors.errors);
  if (rule.more_errors_than) return count > static_cast<double>(*rule.more_errors_than);
  return rule.error_rate_above && errors.trials > 0 &&
         count > *rule.error_rate_above * static_cast<double>(errors.trials);
}

GatheredAnswers without_participants(GatheredAnswers gathered,
                                     const std::set<std::string>& participants) {
  std::vector<std::optional<std::uint32_t>> places{};
  std::vector<AnsweringPerson> kept{};
  for (AnsweringPerson& person : gathered.people) {
    if (participants.contains(person.label)) {
      places.emplace_back();
      continue;
    }
    places.emplace_back(static_cast<std::uint32_t>(kept.size()));
    kept.push_back(std::move(person));
  }
  gathered.people = std::move(kept);
  std::erase_if(gathered.answers,
                [&places](const GatheredAnswer& answer) { return !places[answer.person]; });
  for (GatheredAnswer& answer : gathered.answers) answer.person = *places[answer.person];
  std::erase_if(gathered.matches, [&participants](const ParticipantMatch& match) {
    return participants.contains(match.participant);
  });
  return gathered;
}

std::set<std::string> excluded_by_rule(const GatheredAnswers& gathered) {
  std::set<std::string> excluded{};
  const std::optional<CatchExclusion>& rule = gathered.declared.exclude;
  if (!rule) return excluded;
  const std::vector<CatchErrors> all = catch_errors(gathered);
  for (const AnsweringPerson& person : gathered.people) {
    const auto own = std::find_if(all.begin(), all.end(), [&person](const CatchErrors& each) {
      return each.participant == person.label;
    });
    if (own != all.end() && is_excluded(*rule, *own)) excluded.insert(person.label);
  }
  return excluded;
}

GatheredAnswers without_excluded(const GatheredAnswers& gathered) {
  const std::set<std::string> excluded = excluded_by_rule(gathered);
  if (excluded.empty() || excluded.size() == gathered.people.size()) return gathered;
  return without_participants(gathered, excluded);
}

void analyze_with_exclusions(const GatheredAnswers& gathered, AnalysisOutcome& outcome,
                             void (*analyze)(const GatheredAnswers&, AnalysisOutcome&)) {
  const std::optional<CatchExclusion>& rule = gathered.declared.exclude;
  if (!rule) return analyze(gathered, outcome);
  const std::vector<CatchErrors> all = catch_errors(gathered);
  const std::set<std::string> excluded = excluded_by_rule(gathered);
  if (excluded.empty() || excluded.size() == gathered.people.size()) {
    analyze(gathered, outcome);
    if (!excluded.empty()) {
      outcome.remarks.push_back(
          phrase("Analysis",
                 "The declared rule (%1) excludes all participants, so that the results are those "
                 "of the excluded participants.")
              .with(words_of_rule(*rule)));
    }
  } else {
    AnalysisOutcome of_all = outcome;
    analyze(without_participants(gathered, excluded), outcome);
    analyze(gathered, of_all);
    std::string codes{};
    for (const std::string& label : excluded) codes += (codes.empty() ? "" : ", ") + label;
    outcome.remarks.push_back(
        phrase("Analysis",
               "Participants whom the declared rule (%3) excludes: %1 of %2 (%4). Results are "
               "those without these participants; tables with the excluded participants follow. "
               "Tables of response times, learning, exploration and anchors contain all "
               "participants.")
            .with(std::to_string(excluded.size()), std::to_string(gathered.people.size()),
                  words_of_rule(*rule), codes));
    add_results_of_all(std::move(of_all), outcome);
  }
  if (!all.empty()) add_exclusions(*rule, all, outcome);
}

std::set<std::string> excluded_participants(const AnalysisOutcome& outcome) {
  const ResultTable* const made = table_named(outcome, kExclusions);
  const bool has_results_of_all =
      std::any_of(outcome.tables.begin(), outcome.tables.end(),
                  [](const ResultTable& each) { return each.name.ends_with(kWithExcluded); });
  std::set<std::string> excluded{};
  if (made == nullptr || !has_results_of_all) return excluded;
  for (const ResultRow& cells : made->rows) {
    const RowReader row(*made, cells);
    if (row.text(kExcluded) == "yes") excluded.insert(row.text(columns::kParticipant));
  }
  return excluded;
}

std::string exclusions_sentence(const AnalysisOutcome& outcome) {
  const std::size_t excluded = excluded_participants(outcome).size();
  if (excluded == 0) return {};
  const ResultTable* const made = table_named(outcome, kExclusions);
  return " By the rule that the protocol declares for errors in catch trials, " +
         std::to_string(excluded) + " of " + std::to_string(made->rows.size()) +
         (excluded == 1 ? " participants was" : " participants were") +
         " excluded; the results with all participants are reported in separate tables.";
}

}  // namespace asperity
