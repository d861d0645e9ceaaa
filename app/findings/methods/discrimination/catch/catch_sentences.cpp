// Sums the table of catch trials by type and participant, and states the range over the participants.

#include "app/findings/methods/discrimination/catch/catch_sentences.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <variant>
#include <vector>

#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/outcome/reading_number.h"
#include "app/findings/outcome/reading_table.h"
#include "protocols/design/protocol.h"

namespace asperity {

namespace {

/// The responses in catch trials of one type.
struct CaughtResponses {
  double correct = 0.0;
  double all = 0.0;
};

std::string text_or_empty(const Cell& cell) {
  const auto* const text = std::get_if<std::string>(&cell);
  return text == nullptr ? std::string() : *text;
}

/// By participant, over the blocks.
std::map<std::string, CaughtResponses> caught_responses(const Table& table,
                                                        const std::string& type) {
  std::map<std::string, CaughtResponses> caught{};
  const auto participant = column_of(table, "participant");
  const auto type_of = column_of(table, "type");  // absent where all are easy
  const auto right = column_of(table, "right");
  const auto of = column_of(table, "of");
  if (!participant || !right || !of) return caught;
  for (const std::vector<Cell>& row : table.rows) {
    const std::string own =
        type_of ? text_or_empty(row[*type_of]) : std::string(text_of(CatchType::easy));
    if (own != type) continue;
    CaughtResponses& one = caught[text_or_empty(row[*participant])];
    one.correct += number_of(row[*right]).value_or(0.0);
    one.all += number_of(row[*of]).value_or(0.0);
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
                       : " (" + reading_percent(least) + " to " + reading_percent(most) +
                             " for single participants)";
}

std::string catch_sentence_of(CatchType type, const Table& table) {
  const std::map<std::string, CaughtResponses> caught = caught_responses(table, text_of(type));
  CaughtResponses sum{};
  for (const auto& [participant, one] : caught) {
    sum.correct += one.correct;
    sum.all += one.all;
  }
  if (sum.all == 0.0) return {};
  const auto whole = [](double number) { return reading_count(static_cast<std::size_t>(number)); };
  if (type == CatchType::easy) {
    const std::string where =
        column_of(table, "type") ? " in easy catch trials" : " in catch trials";
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
  for (const NamedTable& table : outcome.tables) {
    if (table.name != kCatchTrials) continue;
    for (const CatchType type :
         {CatchType::easy, CatchType::no_signal, CatchType::identical_pair}) {
      text += catch_sentence_of(type, table.table);
    }
  }
  return text;
}

}  // namespace asperity
