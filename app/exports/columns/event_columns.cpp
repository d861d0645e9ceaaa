// Declares the columns of events.tsv; a public export has only those data that the kind of event permits.

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"
#include "app/records/session_timeline.h"
#include "app/words/coded_phrases.h"
#include "app/words/event_kinds.h"

namespace asperity::export_columns {
namespace {

bool contains(const std::vector<std::string_view>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The members of the event's data that this audience receives; missing if there are none.
Cell published_data(const EventRow& event, ExportAudience audience) {
  const EventKind* const kind = event_kind(event.kind);
  const auto data = nlohmann::ordered_json::parse(event.data_json, nullptr, false);
  if (kind == nullptr || !data.is_object()) return {};
  nlohmann::ordered_json kept = nlohmann::ordered_json::object();
  for (const auto& [name, value] : data.items()) {
    const bool is_dating =
        audience == ExportAudience::relabelled && contains(kind->dating_data, name);
    if (contains(kind->public_data, name) && !is_dating) kept[name] = value;
  }
  return kept.empty() ? Cell{} : Cell{kept.dump()};
}

ExportColumn without_free_text(ExportColumn made,
                               std::function<Cell(const ExportPlace&)> published) {
  made.publication = Publication::without_free_text;
  made.published_cell = std::move(published);
  return made;
}

ExportColumn kind_column() {
  ExportColumn kind = column("kind", "text", "", "kind of the event, described in events.json",
                             [](const ExportPlace& at) { return at.event->row.kind; });
  for (const EventKind& known : event_kinds()) {
    const std::string name(known.name);
    kind.levels.push_back(name);
    kind.level_meanings[name] = {std::string(known.meaning), hed_tags(known)};
  }
  return kind;
}

}  // namespace

Columns event_columns() {
  Columns columns = keys_to(Key::attempt);
  for (ExportColumn& made : columns) {
    if (made.name == "trial" || made.name == "attempt") {
      made.missing = "no attempt was in progress";
    }
  }
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  add(at_least(1, column("event", "integer", "", "number of the event within the session, by time",
                         [](const ExportPlace& at) { return integer(at.event->number); })));
  columns.back().hed = "ID/#";
  add(column("onset_s", "number", "s",
             "time at which the event happened or began, since the session began",
             [](const ExportPlace& at) { return seconds_in_session(at, at.event->row.time_ns); }));
  add(missing("the end of the event was not recorded, for example after a crash",
              at_least(0, column("duration_s", "number", "s",
                                 "time until the event that ended it, or the session's end; 0 for "
                                 "an event without duration",
                                 [](const ExportPlace& at) {
                                   return optional_cell(at.event->duration_s);
                                 }))));
  add(kind_column());
  add(missing(
      "the event has no text, or its text is free text in a public export",
      without_free_text(column("text", "text", "",
                               "text of the event, as stored; its meaning depends on the kind",
                               [](const ExportPlace& at) { return at.event->row.text; }),
                        [](const ExportPlace& at) -> Cell {
                          const EventKind* const kind = event_kind(at.event->row.kind);
                          if (kind == nullptr || !kind->text_is_public) return {};
                          return at.event->row.text;
                        })));
  const auto codes = [](std::string (*of)(const StoredWords&)) {
    return [of](const ExportPlace& at) -> Cell {
      const EventRow& event = at.event->row;
      const EventKind* const kind = event_kind(event.kind);
      if (kind == nullptr || !kind->text_is_words || event.text.empty()) return {};
      return of(event.words());
    };
  };
  add(missing("the event has no text, or its text has no codes",
              without_free_text(
                  column("text_code", "text", "",
                         "the text as codes, separated by semicolons; \"typed\" where it was typed",
                         codes(codes_of)),
                  codes(published_codes_of))));
  add(missing("the event has no data, or none that a public export includes",
              without_free_text(column("data_json", "json", "",
                                       "data of the event; their meaning depends on the kind",
                                       [](const ExportPlace& at) -> Cell {
                                         const std::string& json = at.event->row.data_json;
                                         return json == "null" ? Cell{} : Cell{json};
                                       }),
                                [](const ExportPlace& at) {
                                  return published_data(at.event->row, ExportAudience::published);
                                })));
  columns.back().relabelled_cell = [](const ExportPlace& at) {
    return published_data(at.event->row, ExportAudience::relabelled);
  };
  return columns;
}

}  // namespace asperity::export_columns
