// Declares the columns of perceived instability of a surface, missing where none was computed.

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"

namespace asperity::export_columns {
namespace {

constexpr const char* kWhenNotJudged = "the attempt was interrupted, or the computation failed";

template <class Value>
std::function<Cell(const ExportPlace&)> cell_of_instability(
    std::optional<Value> InstabilityRow::*member) {
  return [member](const ExportPlace& at) -> Cell {
    const std::optional<InstabilityRow>& judged = at.presentation->instability;
    return judged ? optional_cell(*judged.*member) : Cell{};
  };
}

}  // namespace

void add_instability(Columns& columns) {
  const auto number = [&columns](const char* name, const char* unit, const char* description,
                                 const std::string& when, auto member) {
    columns.push_back(
        missing(when + "; or " + kWhenNotJudged,
                column(name, "number", unit, description, cell_of_instability(member))));
  };
  const auto positive = [&](const char* name, const char* unit, const char* description,
                            const std::string& when, auto member) {
    number(name, unit, description, when, member);
    columns.back() = at_least(0, columns.back());
  };
  const auto reason = [&columns](const char* name, const char* of, auto member) {
    columns.push_back(
        with_levels(missing(std::string("there is a value; or ") + kWhenNotJudged,
                            column(name, "text", "",
                                   std::string("why there is no ") + of +
                                       ": too_short (contact), no_force (the device has no "
                                       "motors), low_rate (of the servo loop) or no_crests (the "
                                       "model is not a grating)",
                                   cell_of_instability(member))),
                    {"too_short", "no_force", "low_rate", "no_crests"}));
  };
  const std::string no_buzz = "see no_buzz";
  positive("buzz", "1",
           "greatest vibration above 150 Hz in 0.3 s that the force model does not explain, "
           "relative to the texture force, at least to 20 mN (docs/instability.md)",
           no_buzz, &InstabilityRow::buzz);
  positive("buzz_force_N", "N", "the same as an RMS force", no_buzz, &InstabilityRow::buzz_force_N);
  columns.push_back(missing(no_buzz + "; or " + kWhenNotJudged,
                            column("buzz_s", "number", "s",
                                   "middle of the window with this vibration, since the session "
                                   "began",
                                   [](const ExportPlace& at) -> Cell {
                                     const auto& judged = at.presentation->instability;
                                     return judged ? seconds_in_session(at, judged->buzz_ns)
                                                   : Cell{};
                                   })));
  reason("no_buzz", "buzz", &InstabilityRow::no_buzz);
  const std::string no_rest = "see no_aliveness";
  positive("resting_s", "s", "time for which the hand rested on the surface, below 5 mm/s", no_rest,
           &InstabilityRow::resting_s);
  positive("alive_force_N", "N", "RMS of the force on the resting hand in 2 to 20 Hz", no_rest,
           &InstabilityRow::alive_force_N);
  positive("alive_plate_force_N", "N",
           "the same for the surface without its texture under the same motion of the hand",
           no_rest, &InstabilityRow::alive_plate_force_N);
  positive("alive_motion_m", "m", "RMS of the motion of the resting hand in 2 to 20 Hz", no_rest,
           &InstabilityRow::alive_motion_m);
  number("alive_work_J", "J",
         "net work of the texture on the resting hand over closed parts of its path; positive: "
         "energy from the surface",
         no_rest + "; or no part of the path is closed", &InstabilityRow::alive_work_J);
  reason("no_aliveness", "resting time", &InstabilityRow::no_aliveness);
  const std::string no_crest_share = "see no_crest_share";
  number("crest_share", "1",
         "proportion of the contact below 30 mm/s within 15 % of a wavelength of a crest; 0.3 "
         "for an even motion",
         no_crest_share, &InstabilityRow::crest_share);
  columns.back() = fraction(columns.back());
  positive("slow_s", "s", "time of the contact below 30 mm/s", no_crest_share,
           &InstabilityRow::slow_s);
  reason("no_crest_share", "proportion at crests", &InstabilityRow::no_crest_share);
}

}  // namespace asperity::export_columns
