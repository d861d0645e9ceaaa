// Declares the columns of visits.tsv: times, force and speed of each visit to a surface.

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"

namespace asperity::export_columns {
namespace {

using Place = ExportPlace;

}  // namespace

Columns visit_columns() {
  Columns columns = keys_to(Key::attempt);
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  add(at_least(1, column("position", "integer", "", "place in the order of the trial's surfaces",
                         [](const Place& at) { return integer(at.presentation->position); })));
  add(at_least(1, column("visit", "integer", "", "visit to the surface, in chronological order",
                         [](const Place& at) { return integer(at.visit_number); })));
  const auto time = [&add](const char* name, const char* description,
                           std::int64_t VisitRow::*member) {
    add(column(name, "number", "s", description,
               [member](const Place& at) { return seconds_in_session(at, at.visit->*member); }));
  };
  const auto number = [&add](const char* name, const char* unit, const char* description,
                             double VisitRow::*member) {
    add(at_least(0, column(name, "number", unit, description,
                           [member](const Place& at) { return at.visit->*member; })));
  };
  const auto force = [&add](const char* name, const char* description,
                            std::optional<double> VisitRow::*member) {
    add(missing("the surface was never completely faded in",
                column(name, "number", "N", description,
                       [member](const Place& at) { return optional_cell(at.visit->*member); })));
  };
  time("contact_onset_s", "time of the first tick of contact, since the session began",
       &VisitRow::contact_ns);
  time("offset_s", "time of the last tick of contact, since the session began",
       &VisitRow::offset_ns);
  number("contact_s", "s", "contact time", &VisitRow::contact_s);
  number("path_m", "m", "path along the surface in contact", &VisitRow::path_m);
  force("force_mean_N", "mean normal force", &VisitRow::force_mean_N);
  force("force_sd_N", "standard deviation of the normal force", &VisitRow::force_sd_N);
  number("speed_mean_m_per_s", "m/s", "mean tangential speed in contact",
         &VisitRow::speed_mean_m_per_s);
  number("speed_sd_m_per_s", "m/s", "standard deviation of the tangential speed",
         &VisitRow::speed_sd_m_per_s);
  return columns;
}

}  // namespace asperity::export_columns
