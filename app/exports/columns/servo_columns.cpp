// Declares the columns of servo_quality.tsv: rate, periods, delays and counted ticks of each attempt.

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"

namespace asperity::export_columns {
namespace {

using Place = ExportPlace;

}  // namespace

Columns servo_columns() {
  Columns columns = keys_to(Key::attempt);
  const auto number = [&columns](const char* name, const char* unit, const char* description,
                                 double ServoQualityRow::*member) {
    columns.push_back(at_least(0, column(name, "number", unit, description,
                                         [member](const Place& at) { return at.servo->*member; })));
  };
  const auto count = [&columns](const char* name, const char* description,
                                std::int64_t ServoQualityRow::*member) {
    columns.push_back(
        at_least(0, column(name, "integer", "1", description,
                           [member](const Place& at) { return integer(at.servo->*member); })));
  };
  using Row = ServoQualityRow;
  number("rate_Hz", "Hz", "requested rate", &Row::rate_Hz);
  count("ticks", "ticks of the servo loop", &Row::ticks);
  number("period_mean_s", "s", "mean time between ticks", &Row::period_mean_s);
  number("period_sd_s", "s", "standard deviation of the time between ticks", &Row::period_sd_s);
  number("period_p50_s", "s", "median time between ticks", &Row::period_p50_s);
  number("period_p99_s", "s", "99th percentile of the time between ticks", &Row::period_p99_s);
  number("period_p99_9_s", "s", "99.9th percentile of the time between ticks",
         &Row::period_p99_9_s);
  number("period_maximum_s", "s", "longest time between ticks", &Row::period_maximum_s);
  number("lateness_p50_s", "s", "median delay of the start of a tick after its deadline",
         &Row::lateness_p50_s);
  number("lateness_p99_s", "s", "99th percentile of the delay of the start after the deadline",
         &Row::lateness_p99_s);
  number("lateness_maximum_s", "s", "longest delay of a start after its deadline",
         &Row::lateness_maximum_s);
  number("execution_p99_s", "s", "99th percentile of the duration of a tick; 0 when simulated",
         &Row::execution_p99_s);
  number("execution_maximum_s", "s", "longest duration of a tick; 0 when simulated",
         &Row::execution_maximum_s);
  count("missed_deadlines", "ticks that missed their deadline", &Row::missed_deadlines);
  count("missed_in_contact", kMissedInContact, &Row::missed_in_contact);
  count("gaps_in_contact", kGapsInContact, &Row::gaps_in_contact);
  count("held_readings", kHeldReadings, &Row::held_readings);
  count("saturated_ticks", "ticks with the force reduced to the limit", &Row::saturated_ticks);
  count("slew_limited_ticks", "ticks in which the growth of the force was limited",
        &Row::slew_limited_ticks);
  count("not_finite_ticks", "ticks with a force that was not finite", &Row::not_finite_ticks);
  count("lost_records", "tick records that were lost", &Row::lost_records);
  columns.push_back(column("fault", "text", "", "fault that stopped the forces, or none",
                           [](const Place& at) { return at.servo->fault; }));
  return columns;
}

}  // namespace asperity::export_columns
