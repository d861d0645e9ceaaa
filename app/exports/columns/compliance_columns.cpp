// Declares the columns of compliance.tsv: required band, and what was achieved, of each quantity.

#include <optional>
#include <utility>

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"

namespace asperity::export_columns {
namespace {

using Place = ExportPlace;

}  // namespace

Columns compliance_columns() {
  Columns columns = keys_to(Key::attempt);
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  using Row = ComplianceRow;
  add(at_least(0, column("position", "integer", "", "place in the order of the trial's surfaces",
                         [](const Place& at) { return integer(at.compliance->position); })));
  add(with_levels(column("quantity", "text", "", "measured quantity; the name ends with the unit",
                         [](const Place& at) { return at.compliance->quantity; }),
                  {"normal_force_N", "speed_m_per_s", "contact_s", "strokes", "stroke_length_m"}));
  const auto bound = [&add](const char* name, const char* description,
                            std::optional<double> Row::*member) {
    add(missing("the protocol declares no such limit",
                column(name, "number", "as quantity", description, [member](const Place& at) {
                  return optional_cell(at.compliance->*member);
                })));
  };
  const auto value = [&add](const char* name, const char* description, double Row::*member) {
    add(column(name, "number", "as quantity", description,
               [member](const Place& at) { return at.compliance->*member; }));
  };
  bound("minimum", "lower end of the band that the protocol requires", &Row::minimum);
  bound("maximum", "upper end of the band that the protocol requires", &Row::maximum);
  value("mean", "mean achieved", &Row::mean);
  value("sd", "standard deviation", &Row::sd);
  value("p05", "5th percentile", &Row::p05);
  value("p50", "median", &Row::p50);
  value("p95", "95th percentile", &Row::p95);
  add(missing("the protocol declares no band",
              fraction(column("fraction_in_band", "number", "1",
                              "fraction inside the band: of the contact time for the force, of the "
                              "strokes for their speed and length",
                              [](const Place& at) {
                                return optional_cell(at.compliance->fraction_in_band);
                              }))));
  add(missing("the protocol declares no requirement",
              column("passed", "boolean", "", "1: explored as the protocol requires",
                     [](const Place& at) { return optional_boolean(at.compliance->passed); })));
  return columns;
}

}  // namespace asperity::export_columns
