// Derives the columns from those of attempts and events, renamed where BIDS has names of its own.

#include "app/exports/bids_events.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/export_tables.h"
#include "app/exports/columns/table_columns.h"
#include "app/words/event_kinds.h"
#include "results_schema/stored_json.h"

namespace asperity {

using namespace export_columns;

namespace {

constexpr const char* kAttempt = "attempt";
constexpr const char* kPresentation = "presentation";

/// BIDS has specific names for the first columns of a table of events.
ExportColumn renamed_column(const Columns& columns, const std::string& name, std::string bids_name,
                            std::function<Cell(const ExportPlace&)> otherwise) {
  ExportColumn made = *std::find_if(columns.begin(), columns.end(),
                                    [&](const ExportColumn& each) { return each.name == name; });
  made.name = std::move(bids_name);
  made.cell = [of_event = std::move(made.cell), otherwise = std::move(otherwise)](
                  const ExportPlace& at) { return at.event ? of_event(at) : otherwise(at); };
  for (auto* const cell : {&made.published_cell, &made.relabelled_cell}) {
    if (!*cell) continue;
    *cell = [of_event = std::move(*cell)](const ExportPlace& at) {
      return at.event ? of_event(at) : Cell{};
    };
  }
  return made;
}

Cell nothing(const ExportPlace& /*at*/) { return {}; }

std::int64_t onset_ns(const ExportPlace& at) {
  if (at.event) return at.event->row.time_ns;
  return at.presentation ? *at.presentation->onset_ns : at.attempt->onset_ns;
}

/// From the cue to the response that completed the attempt.
Cell response_time(const ExportPlace& at) {
  if (at.event || at.presentation) return {};
  std::optional<double> last{};
  for (const ResponseRow& response : at.attempt->responses) {
    if (response.from_cue_s) last = std::max(last.value_or(0.0), *response.from_cue_s);
  }
  return optional_cell(last);
}

/// `factors`: the columns that have separate tags, which belong to the attempt.
ExportColumn type_column(const Columns& events, const std::string& factors) {
  ExportColumn type = renamed_column(events, "kind", "trial_type", [](const ExportPlace& at) {
    return at.presentation ? kPresentation : kAttempt;
  });
  type.description =
      "kind of the row: an attempt at a trial, a surface presented in an attempt, or the kind of "
      "the event";
  type.levels.insert(type.levels.begin(), {kAttempt, kPresentation});
  type.level_meanings[kAttempt] = {"an attempt at a trial, from its beginning to its end",
                                   "(Experiment-structure, Label/attempt" + factors + ")"};
  type.level_meanings[kPresentation] = {
      "a surface that could be felt",
      "(Sensory-event, Tactile-presentation, Experimental-stimulus, Experiment-participant, "
      "Label/presentation" +
          factors + ")"};
  return type;
}

Columns factor_columns(const StudyVocabulary& vocabulary) {
  std::vector<ExportFile> files = export_files(vocabulary);
  const auto trials = std::find_if(files.begin(), files.end(),
                                   [](const ExportFile& file) { return file.name == "trials"; });
  Columns factors{};
  for (ExportColumn& factor : trials->columns) {
    if (!factor.name.starts_with("factor_")) continue;
    factor.missing = "the row is an event, or the trial does not have this factor";
    factor.cell = [of_trial = std::move(factor.cell)](const ExportPlace& at) {
      return at.event ? Cell{} : of_trial(at);
    };
    factors.push_back(std::move(factor));
  }
  return factors;
}

}  // namespace

Columns bids_event_columns(const StudyVocabulary& vocabulary, ExportAudience audience,
                           std::vector<std::string>& left_out) {
  const Columns events = event_columns();
  const Columns factors = factor_columns(vocabulary);
  std::string tagged{};
  for (const ExportColumn& factor : factors) {
    if (!factor.level_meanings.empty()) tagged += ", {" + factor.name + "}";
  }
  Columns columns{};
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  add(renamed_column(events, "onset_s", "onset",
                     [](const ExportPlace& at) { return seconds_in_session(at, onset_ns(at)); }));
  add(renamed_column(events, "duration_s", "duration", [](const ExportPlace& at) -> Cell {
    const std::optional<std::int64_t> end =
        at.presentation ? at.presentation->offset_ns : at.attempt->offset_ns;
    if (!end) return {};
    return static_cast<double>(*end - onset_ns(at)) * 1e-9;
  }));
  add(type_column(events, tagged));
  add(missing("the row is not an attempt, or has no response",
              at_least(0, column("response_time", "number", "s",
                                 "time from the cue, when the question was first asked, to the "
                                 "response that completed the attempt",
                                 response_time))));
  const auto key = [&](const char* name, auto number) {
    add(missing("no attempt was in progress",
                at_least(1, column(name, "integer", "",
                                   std::string("number of the ") + name +
                                       (std::string(name) == "trial" ? " within the session"
                                                                     : " at the trial"),
                                   [number](const ExportPlace& at) -> Cell {
                                     return at.attempt ? integer(number(*at.attempt)) : Cell{};
                                   }))));
  };
  key("trial", [](const AttemptRow& attempt) { return attempt.trial; });
  key("attempt", [](const AttemptRow& attempt) { return attempt.attempt; });
  add(missing("the row is not an attempt",
              column("outcome", "text", "", "outcome of the attempt", [](const ExportPlace& at) {
                return at.event || at.presentation ? Cell{} : Cell{text_of(at.attempt->outcome)};
              })));
  const auto of_surface = [&](const char* name, const char* description, auto member) {
    add(missing(std::string("the row is not a presentation, or the presentation has no ") + name,
                column(name, "text", "", description, [member](const ExportPlace& at) -> Cell {
                  return at.presentation ? Cell{at.presentation->*member} : Cell{};
                })));
  };
  of_surface("stimulus", "stimulus of the protocol", &PresentationRow::stimulus);
  of_surface("model", "force model", &PresentationRow::model);
  of_surface("texture", "texture of the protocol", &PresentationRow::texture);
  add(missing("the row is not an event", renamed_column(events, "event", "event", nothing)));
  for (const char* name : {"text", "data_json"}) add(renamed_column(events, name, name, nothing));
  for (const ExportColumn& factor : factors) add(factor);
  return columns_for(audience, std::move(columns), left_out);
}

std::vector<std::vector<Cell>> bids_event_rows(const Columns& columns, ExportAudience audience,
                                               const ExportPlace& session,
                                               const std::vector<PlannedTrialRow>& plan,
                                               const std::vector<AttemptRow>& attempts,
                                               const std::vector<TimedEvent>& timeline) {
  std::map<int, nlohmann::json> factors{};
  for (const PlannedTrialRow& trial : plan) {
    factors[trial.trial] = stored_json(trial.factors_json, "trial.factors_json");
  }
  std::vector<ExportPlace> places{};
  for (const AttemptRow& attempt : attempts) {
    ExportPlace at = session;
    at.attempt = &attempt;
    at.factors = &factors[attempt.trial];
    places.push_back(at);
    for (const PresentationRow& presentation : attempt.presentations) {
      if (!presentation.onset_ns) continue;
      at.presentation = &presentation;
      places.push_back(at);
    }
  }
  for (const TimedEvent& event : timeline) {
    ExportPlace at = session;
    at.attempt = event.attempt;
    at.event = &event;
    places.push_back(at);
  }
  std::stable_sort(places.begin(), places.end(), [](const ExportPlace& a, const ExportPlace& b) {
    return onset_ns(a) < onset_ns(b);
  });
  std::vector<std::vector<Cell>> rows{};
  for (const ExportPlace& at : places) {
    std::vector<Cell>& row = rows.emplace_back();
    for (const ExportColumn& column : columns) row.push_back(cell_for(audience, column, at));
  }
  return rows;
}

}  // namespace asperity
