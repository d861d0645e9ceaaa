// Tries the customary units of each quantity, and takes one in which the number is within the limits.

#include "stimuli/properties/other_unit.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "analysis/numbers/number_text.h"

namespace asperity {

namespace {

/// One of it is 10^`power` of the unit of the file; a degree, which has no such power, is converted by itself.
struct OtherUnit {
  std::string_view name{};
  int power = 0;
  double usual_from = 0.0;  ///< smaller numbers are not written in this unit
};

struct Quantity {
  std::string_view unit{};
  Phrase convention{};
  std::span<const OtherUnit> others{};  ///< the greatest first
};

constexpr std::string_view kDegree = "°";
constexpr std::array<OtherUnit, 2> kLengths{{{" mm", -3}, {" µm", -6}}};
constexpr std::array<OtherUnit, 2> kTimes{{{" ms", -3}, {" µs", -6}}};
constexpr std::array<OtherUnit, 1> kSpeeds{{{" mm/s", -3}}};
constexpr std::array<OtherUnit, 1> kForces{{{" mN", -3, 100.0}}};
constexpr std::array<OtherUnit, 1> kMasses{{{" g", -3}}};
constexpr std::array<OtherUnit, 1> kFrequencies{{{" kHz", 3}}};
constexpr std::array<OtherUnit, 1> kStiffnesses{{{" N/mm", 3}}};
constexpr std::array<OtherUnit, 1> kAngles{{{kDegree, 0}}};

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> kAll{
      {"m", phrase("UnitsOfFile", "; lengths are in metres: %1"), kLengths},
      {"s", phrase("UnitsOfFile", "; times are in seconds: %1"), kTimes},
      {"m/s", phrase("UnitsOfFile", "; speeds are in metres per second: %1"), kSpeeds},
      {"N", phrase("UnitsOfFile", "; forces are in newtons: %1"), kForces},
      {"kg", phrase("UnitsOfFile", "; masses are in kilograms: %1"), kMasses},
      {"Hz", phrase("UnitsOfFile", "; frequencies are in hertz: %1"), kFrequencies},
      {"N/m", phrase("UnitsOfFile", "; stiffnesses are in newtons per metre: %1"), kStiffnesses},
      {"rad", phrase("UnitsOfFile", "; angles are in radians: %1"), kAngles}};
  return kAll;
}

std::string converted(double number, const OtherUnit& unit) {
  if (unit.name == kDegree) {
    constexpr double kDigits = 1e4;
    return number_text(std::round(kDigits * number * std::numbers::pi / 180.0) / kDigits);
  }
  return shifted_decimal(number_text(number), unit.power).value_or("");
}

double value_of(double number, const OtherUnit& unit) {
  return unit.name == kDegree ? number * std::numbers::pi / 180.0
                              : number * std::pow(10.0, unit.power);
}

}  // namespace

Phrase number_of_file(std::string_view number) {
  return {kNumbersOfFile, std::string(number).c_str()};
}

Phrase meant_in_other_unit(double number, std::string_view unit,
                           const std::function<bool(double)>& is_permitted) {
  constexpr double kManyOfThem = 100.0;  // from which on a smaller unit is as likely: 500 µm
  for (const Quantity& quantity : quantities()) {
    if (quantity.unit != unit) continue;
    Phrase meant{};
    for (const OtherUnit& other : quantity.others) {
      if (number < other.usual_from || !is_permitted(value_of(number, other))) continue;
      if (!meant.empty() && std::abs(number) < kManyOfThem) break;
      const Phrase one =
          phrase("Protocols", "%1 is %2")
              .with(number_text(number) + std::string(other.name), converted(number, other));
      meant = meant.empty() ? one : phrase("Protocols", "%1, and %2").with(meant, one);
    }
    return meant.empty() ? Phrase() : quantity.convention.with(meant);
  }
  return {};
}

}  // namespace asperity
