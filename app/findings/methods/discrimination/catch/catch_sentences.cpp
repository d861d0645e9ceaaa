// Sums the table of catch trials by type and participant, and states the range over the participants.

#include "app/findings/methods/discrimination/catch/catch_sentences.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <variant>
#include <vector>

#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/methods/discrimination/thresholds/threshold_columns.h"
#include "app/findings/outcome/display_number.h"
#include "protocols/design/protocol.h"

namespace asperity {

namespace {

/// The responses in catch trials of one type.
struct CaughtResponses {
  double correct = 0.0;
  double all = 0.0;
};

/// By participant, over the blocks.
std::map<std::string, CaughtResponses> caught_responses(const ResultTable& table,
                                                        const std::string& type) {
  std::map<std::string, CaughtResponses> caught{};
  const bool has_types = table.has(kCatchTypeColumn);  // absent where all are easy
  for (const ResultRow& cells : table.rows) {
    const RowReader row(table, cells);
    const std::string own =
        has_types ? row.text(kCatchTypeColumn) : std::string(text_of(CatchType::easy));
    if (own != type) continue;
    CaughtResponses& one = caught[row.text(columns::kParticipant)];
    one.correct += row.number(columns::kCorrectCount).value_or(0.0);
    one.all += row.number(columns::kOf).value_or(0.0);
  }
  return caught;
}

/// " (75 % to 100 % for single participants)"; empty where they have the same percentage.
std::string range_over_participants(const std::map<std::string, CaughtResponses>& caught,
                                    bool of_errors) {
  double least = 1.0;
  double most = 0.0;
  for (const auto& [participant, one] : caught) {
    const double correct = one.correct / std::max(one.all, 1.0);
    least = std::min(least, of_errors ? 1.0 - correct : correct);
    most = std::max(most, of_errors ? 1.0 - correct : correct);
  }
  return least >= most ? std::string()
                       : " (" + display_percent(least) + " to " + display_percent(most) +
                             " for single participants)";
}

std::string catch_sentence_of(CatchType type, const ResultTable& table) {
  const std::map<std::string, CaughtResponses> caught = caught_responses(table, text_of(type));
  CaughtResponses sum{};
  for (const auto& [participant, one] : caught) {
    sum.correct += one.correct;
    sum.all += one.all;
  }
  if (sum.all == 0.0) return {};
  const auto whole = [](double number) { return display_count(static_cast<std::size_t>(number)); };
  if (type == CatchType::easy) {
    const std::string where =
        table.has(kCatchTypeColumn) ? " in easy catch trials" : " in catch trials";
    if (sum.correct == sum.all && sum.all > 1.0) {
      return " All " + whole(sum.all) + " responses" + where + " were correct.";
    }
    return " Of " + whole(sum.all) + (sum.all == 1.0 ? " response" : " responses") + where + ", " +
           whole(sum.correct) + (sum.correct == 1.0 ? " was correct" : " were correct") +
           range_over_participants(caught, false) + '.';
  }
  const std::string trials =
      " In " + whole(sum.all) + (sum.all == 1.0 ? " catch trial " : " catch trials ") +
      (type == CatchType::no_signal ? "without a signal, " : "with an identical pair, ");
  const double others = sum.all - sum.correct;
  if (others == 0.0) return trials + "every response was “cannot tell”.";
  return trials + (others == 1.0 ? "there was " : "there were ") + whole(others) +
         (others == 1.0 ? " response" : " responses") +
         " other than “cannot tell” (a missed deadline would count as one)" +
         range_over_participants(caught, true) + '.';
}

}  // namespace

std::string catch_trials_sentence(const AnalysisOutcome& outcome) {
  std::string text{};
  for (const ResultTable& table : outcome.tables) {
    if (table.name != kCatchTrials) continue;
    for (const CatchType type :
         {CatchType::easy, CatchType::no_signal, CatchType::identical_pair}) {
      text += catch_sentence_of(type, table);
    }
  }
  return text;
}

}  // namespace asperity
