// Builds columns from a name, a type and a function, and adds levels, limits or publication to them.

#include "app/exports/columns/column_making.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace asperity::export_columns {

Cell boolean(bool value) { return std::int64_t{value ? 1 : 0}; }

Cell optional_boolean(const std::optional<bool>& value) { return value ? boolean(*value) : Cell{}; }

Cell integer(std::int64_t value) { return value; }

Cell seconds_in_session(const ExportPlace& at, std::int64_t time_ns) {
  return static_cast<double>(time_ns - at.session->clock_zero_ns) / 1e9;
}

Cell seconds_in_session(const ExportPlace& at, const std::optional<std::int64_t>& time_ns) {
  return time_ns ? seconds_in_session(at, *time_ns) : Cell{};
}

namespace {

Cell json_cell(const nlohmann::json& value) {
  if (value.is_null()) return {};
  if (value.is_boolean()) return boolean(value.get<bool>());
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  return value.dump();
}

}  // namespace

Cell member_of(const nlohmann::json* object, const std::string& name) {
  const auto found = object->find(name);
  return found == object->end() ? Cell{} : json_cell(*found);
}

ExportColumn column(std::string name, std::string type, std::string unit, std::string description,
                    std::function<Cell(const ExportPlace&)> cell) {
  ExportColumn made{};
  made.name = std::move(name);
  made.type = std::move(type);
  made.unit = std::move(unit);
  made.description = std::move(description);
  made.cell = std::move(cell);
  if (made.type == "boolean") made.levels = {"0", "1"};
  return made;
}

ExportColumn with_levels(ExportColumn made, std::vector<std::string> levels) {
  made.levels = std::move(levels);
  return made;
}

ExportColumn at_least(double minimum, ExportColumn made) {
  made.minimum = minimum;
  return made;
}

ExportColumn fraction(ExportColumn made) {
  made.minimum = 0.0;
  made.maximum = 1.0;
  return made;
}

ExportColumn missing(std::string when, ExportColumn made) {
  made.missing = std::move(when);
  return made;
}

ExportColumn dropped(ExportColumn made) {
  made.publication = Publication::dropped;
  return made;
}

ExportColumn dropped_with_new_labels(ExportColumn made) {
  made.publication = Publication::dropped_with_new_labels;
  return made;
}

Columns keys_to(Key last) {
  Columns columns{};
  columns.push_back(column("participant", "text", "", "label of the participant",
                           [](const ExportPlace& at) { return at.participant->label; }));
  if (last >= Key::session) {
    columns.push_back(
        at_least(1, column("session", "integer", "", "number of the participant's session",
                           [](const ExportPlace& at) { return integer(at.session->session); })));
  }
  if (last >= Key::trial) {
    columns.push_back(at_least(
        1, column("trial", "integer", "", "number of the trial within the plan of the session",
                  [](const ExportPlace& at) {
                    return at.trial ? integer(at.trial->trial) : Cell{};
                  })));
  }
  if (last >= Key::attempt) {
    columns.push_back(
        at_least(1, column("attempt", "integer", "", "number of the attempt at the trial",
                           [](const ExportPlace& at) {
                             return at.attempt ? integer(at.attempt->attempt) : Cell{};
                           })));
  }
  columns.push_back(
      column("virtual", "boolean", "",
             "1: a virtual participant, whose rows are not data of human participants",
             [](const ExportPlace& at) { return boolean(at.participant->is_virtual); }));
  columns.push_back(with_levels(column("mode", "text", "", "mode of the session",
                                       [](const ExportPlace& at) -> Cell {
                                         if (at.session) return text_of(at.session->mode);
                                         return at.participant_mode->empty()
                                                    ? Cell{}
                                                    : Cell{*at.participant_mode};
                                       }),
                                {"run", "pilot", "simulate"}));
  return columns;
}

}  // namespace asperity::export_columns
