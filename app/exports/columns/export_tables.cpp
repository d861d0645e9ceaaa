// Lists the tables in the order of their keys, and joins trials, attempts and responses to one table.

#include "app/exports/columns/export_tables.h"

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"

namespace asperity {

using namespace export_columns;

std::vector<ExportFile> export_files(const StudyVocabulary& vocabulary) {
  Columns trials = trial_columns(vocabulary);
  trials.push_back(attempts_of_trial_column());
  return {{"participants", participant_columns(vocabulary)},
          {"sessions", session_columns(vocabulary)},
          {"trials", std::move(trials)},
          {"attempts", attempt_columns(vocabulary)},
          {"presentations", presentation_columns(vocabulary)},
          {"visits", visit_columns()},
          {"responses", response_columns(vocabulary)},
          {"servo_quality", servo_columns()},
          {"compliance", compliance_columns()},
          {"events", event_columns()}};
}

std::vector<ExportColumn> answered_trial_columns(const StudyVocabulary& vocabulary) {
  Columns columns = keys_to(Key::attempt);
  const std::size_t keys_of_attempt = columns.size();
  const auto append = [&columns](Columns more, std::size_t from) {
    std::move(more.begin() + static_cast<std::ptrdiff_t>(from), more.end(),
              std::back_inserter(columns));
  };
  append(trial_columns(vocabulary), keys_of_attempt - 1);  // without the key "attempt"
  append(attempt_columns(vocabulary), keys_of_attempt);
  columns.push_back(column("surfaces_json", "json", "",
                           "the surfaces presented, in order: position, role, item, stimulus, "
                           "model and texture of each surface",
                           [](const ExportPlace& at) -> Cell {
                             nlohmann::json surfaces = nlohmann::json::array();
                             for (const PresentationRow& row : at.attempt->presentations) {
                               surfaces.push_back({{"position", row.position},
                                                   {"role", row.role},
                                                   {"item", row.item},
                                                   {"stimulus", row.stimulus},
                                                   {"model", row.model},
                                                   {"texture", row.texture}});
                             }
                             return surfaces.dump();
                           }));
  const auto servo = [&columns](const char* name, const char* description,
                                std::int64_t ServoQualityRow::*member) {
    columns.push_back(missing("no servo quality is stored for the attempt",
                              at_least(0, column(name, "integer", "1", description,
                                                 [member](const ExportPlace& at) -> Cell {
                                                   if (!at.attempt->servo) return {};
                                                   return integer((*at.attempt->servo).*member);
                                                 }))));
  };
  servo("missed_deadlines", "ticks that missed their deadline", &ServoQualityRow::missed_deadlines);
  servo("missed_in_contact", kMissedInContact, &ServoQualityRow::missed_in_contact);
  servo("gaps_in_contact", kGapsInContact, &ServoQualityRow::gaps_in_contact);
  servo("held_readings", kHeldReadings, &ServoQualityRow::held_readings);
  servo("saturated_ticks", "ticks with the force reduced to the limit",
        &ServoQualityRow::saturated_ticks);
  servo("lost_records", "tick records that were lost", &ServoQualityRow::lost_records);
  Columns answers = response_columns(vocabulary);
  for (std::size_t i = keys_of_attempt; i < answers.size(); ++i) {
    ExportColumn& made = answers[i];
    made.missing = made.missing == "never" ? "the attempt has no response"
                                           : "the attempt has no response, or " + made.missing;
    made.cell = [of_answer = std::move(made.cell)](const ExportPlace& at) {
      return at.response == nullptr ? Cell{} : of_answer(at);
    };
    columns.push_back(std::move(made));
  }
  return columns;
}

}  // namespace asperity
