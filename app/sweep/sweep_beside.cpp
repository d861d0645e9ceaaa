// Reads the level of each quantity in a trial, and states which option matches the conditions.

#include "app/sweep/sweep_beside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "app/study_files/height_field_files.h"
#include "app/words/text_parts.h"
#include "protocols/plan/plan.h"
#include "results_schema/error_text.h"

namespace asperity {

namespace {

// Numbers written twice are equal, but heights are interpolated between the pixels of a file.
constexpr double kSameNumber = 1e-6;
constexpr double kSameHeight = 0.03;
constexpr double kMillimetres_per_m = 1e3;

bool is_alike(double one, double other, double tolerance) {
  return std::abs(one - other) <= tolerance * std::max(std::abs(one), std::abs(other));
}

/// Without the rounding errors of a conversion.
std::string rounded_text(double number) {
  constexpr double kDigits = 1e9;
  return number_text(std::round(number * kDigits) / kDigits);
}

/// In the customary unit.
std::string quantity_text(VariedQuantity quantity, double value) {
  switch (quantity) {
    case VariedQuantity::probe_diameter:
      return rounded_text(kMillimetres_per_m * value) + " mm";
    case VariedQuantity::applied_force:
      return rounded_text(value) + " N";
    case VariedQuantity::exploratory_speed:
      return rounded_text(kMillimetres_per_m * value) + " mm/s";
    case VariedQuantity::turning:
      return rounded_text(value) + " rad";
  }
  return {};
}

std::string quantities_text(VariedQuantity quantity, const std::vector<double>& values) {
  std::vector<std::string> words{};
  for (const double value : values) words.push_back(quantity_text(quantity, value));
  return listed(words);
}

/// In the syntax of the option.
std::string option_values(const std::vector<double>& values) {
  std::string text{};
  for (const double value : values) text += (text.empty() ? "" : ",") + number_text(value);
  return text;
}

constexpr std::array kVariedQuantities{VariedQuantity::probe_diameter,
                                       VariedQuantity::applied_force,
                                       VariedQuantity::exploratory_speed};

const char* words_of(VariedQuantity quantity) {
  switch (quantity) {
    case VariedQuantity::probe_diameter:
      return "the tool";
    case VariedQuantity::applied_force:
      return "the instructed force";
    case VariedQuantity::exploratory_speed:
      return "the instructed speed";
    case VariedQuantity::turning:
      return "the turning of the tool";
  }
  return "";
}

const char* option_of(VariedQuantity quantity) {
  switch (quantity) {
    case VariedQuantity::probe_diameter:
      return "--probe-diameter-m";
    case VariedQuantity::applied_force:
      return "--applied-force-n";
    case VariedQuantity::exploratory_speed:
      return "--exploratory-speed-m-per-s";
    case VariedQuantity::turning:
      return "--turning-rad";
  }
  return "";
}

double fixed_level(const SweepOrder& order, VariedQuantity quantity) {
  switch (quantity) {
    case VariedQuantity::probe_diameter:
      return order.stroke.tip.diameter_m;
    case VariedQuantity::applied_force:
      return order.stroke.force_N;
    case VariedQuantity::exploratory_speed:
      return order.stroke.speed_m_per_s;
    case VariedQuantity::turning:
      return order.stroke.turning ? order.stroke.turning->amplitude_rad : 0.0;
  }
  return 0.0;
}

/// The level of a quantity in a trial: its identity, and its number if it has one. A band without a
/// target has none: participants may keep any value within its bounds.
struct QuantityLevel {
  std::string told_by{};
  std::optional<double> number{};
  std::optional<double> minimum{};
  std::optional<double> maximum{};

  bool operator==(const QuantityLevel&) const = default;
};

QuantityLevel band_level(const Band& band) {
  const auto bound = [](const std::optional<double>& one) {
    return one ? number_text(*one) : std::string("-");
  };
  return {bound(band.minimum) + ' ' + bound(band.target) + ' ' + bound(band.maximum), band.target,
          band.minimum, band.maximum};
}

std::optional<double> diameter_of(const BodyDescription& body) {
  if (!body.shape) return {};
  if (const auto* sphere = std::get_if<SphereShape>(&*body.shape)) return sphere->diameter_m;
  if (const auto* cylinder = std::get_if<CylinderShape>(&*body.shape)) return cylinder->diameter_m;
  return {};
}

QuantityLevel quantity_level(const Protocol& protocol, const Trial& trial,
                             VariedQuantity quantity) {
  switch (quantity) {
    case VariedQuantity::probe_diameter: {
      if (trial.presentations.empty()) return {};
      const std::optional<BodyDescription>& tool = trial.presentations.front().stimulus.tool;
      return tool ? QuantityLevel{tool->name, diameter_of(*tool)} : QuantityLevel{};
    }
    case VariedQuantity::applied_force:
      return band_level(exploration_of(protocol, trial).normal_force_N);
    case VariedQuantity::exploratory_speed:
      return band_level(exploration_of(protocol, trial).speed_m_per_s);
    case VariedQuantity::turning:
      return {};  // no protocol instructs it
  }
  return {};
}

/// The levels of a quantity in the main trials of a protocol, by condition.
class QuantityByCondition final {
 public:
  QuantityByCondition(const Protocol& protocol, VariedQuantity quantity) {
    const EstimationDeclaration& estimation = *protocol.estimation;
    for (const Trial& trial : possible_trials(protocol)) {
      if (trial.phase != Phase::main) continue;
      const auto level = trial.factors.find(estimation.condition);
      const std::string condition = level == trial.factors.end() ? "" : text_of(level->second);
      const QuantityLevel here = quantity_level(protocol, trial, quantity);
      std::vector<QuantityLevel>& there = levels_[condition];
      if (std::find(there.begin(), there.end(), here) == there.end()) there.push_back(here);
    }
  }

  /// Whether every condition has a different level.
  bool varies() const {
    std::set<std::string> told{};
    for (const auto& [condition, levels] : levels_) {
      if (levels.size() != 1) return false;
      told.insert(levels.front().told_by);
    }
    return told.size() > 1;
  }

  std::optional<double> number(const std::string& condition) const {
    const auto found = levels_.find(condition);
    if (found == levels_.end() || found->second.size() != 1) return {};
    return found->second.front().number;
  }

  /// A level without a number whose bounds exclude `value`.
  std::optional<QuantityLevel> band_without(double value) const {
    for (const auto& [condition, levels] : levels_) {
      for (const QuantityLevel& level : levels) {
        if (level.number) continue;
        if (level.minimum.value_or(value) > value || level.maximum.value_or(value) < value) {
          return level;
        }
      }
    }
    return {};
  }

  /// All numbers, in ascending order.
  std::vector<double> numbers() const {
    std::set<double> numbers{};
    for (const auto& [condition, levels] : levels_) {
      for (const QuantityLevel& level : levels) {
        if (level.number) numbers.insert(*level.number);
      }
    }
    return {numbers.begin(), numbers.end()};
  }

 private:
  std::map<std::string, std::vector<QuantityLevel>> levels_{};
};

/// "0.8 N to 1.2 N", "0.8 N or more", "1.2 N or less".
std::string level_text(VariedQuantity quantity, const QuantityLevel& band) {
  const auto text = [quantity](const std::optional<double>& bound) {
    return bound ? quantity_text(quantity, *bound) : std::string();
  };
  if (!band.maximum) return text(band.minimum) + " or more";
  if (!band.minimum) return text(band.maximum) + " or less";
  return text(band.minimum) + " to " + text(band.maximum);
}

[[noreturn]] void refuse_beside(const Protocol& protocol, const std::string& why) {
  throw std::runtime_error("--beside: the protocol " + protocol.name + ' ' + why);
}

/// The numbers of the conditions, in the order of the protocol; nothing where a condition has none,
/// or two have the same.
std::optional<std::vector<double>> numbers_by_condition(const std::vector<std::string>& conditions,
                                                        const QuantityByCondition& varied) {
  std::vector<double> numbers{};
  for (const std::string& condition : conditions) {
    const std::optional<double> number = varied.number(condition);
    if (!number) return {};
    for (const double other : numbers) {
      if (is_alike(other, *number, kSameNumber)) return {};
    }
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<std::string> conditions_of_levels(const SweepOrder& order, const Protocol& protocol) {
  const std::vector<std::string> conditions = protocol.estimation->conditions.empty()
                                                  ? std::vector<std::string>{""}
                                                  : protocol.estimation->conditions;
  const QuantityByCondition varied(protocol, order.varied);
  if (conditions.size() > 1 && !varied.varies()) {
    std::string instead{};
    for (const VariedQuantity other : kVariedQuantities) {
      const QuantityByCondition by_condition(protocol, other);
      if (!by_condition.varies()) continue;
      const auto numbers = numbers_by_condition(conditions, by_condition);
      instead += (instead.empty() ? "" : " or") + std::string(" --vary ") + text_of(other) +
                 (numbers ? " --values " + option_values(*numbers) : "");
    }
    refuse_beside(protocol,
                  "has the conditions " + listed(conditions) + ", which do not differ in " +
                      words_of(order.varied) + ", the quantity that --vary " +
                      text_of(order.varied) + " varies; " +
                      (instead.empty() ? "a sweep cannot vary the quantity in which they differ: "
                                         "name another protocol, or leave out --beside"
                                       : "use" + instead));
  }
  const auto numbers = numbers_by_condition(conditions, varied);
  const std::string theirs = (conditions.size() == 1 ? std::string("one condition")
                                                     : std::to_string(conditions.size()) +
                                                           " conditions, " + listed(conditions)) +
                             (numbers ? " (" + quantities_text(order.varied, *numbers) + ")" : "");
  if (order.values.size() != conditions.size()) {
    refuse_beside(protocol, "has " + theirs + ", and the sweep has " +
                                std::to_string(order.values.size()) +
                                (order.values.size() == 1 ? " level, " : " levels, ") +
                                quantities_text(order.varied, order.values) +
                                ": give a level for each condition" +
                                (numbers ? ", --values " + option_values(*numbers) : ""));
  }
  if (!numbers) return conditions;
  std::vector<std::string> by_level{};
  for (const double value : order.values) {
    const auto same = std::find_if(numbers->begin(), numbers->end(), [value](double number) {
      return is_alike(number, value, kSameNumber);
    });
    if (same == numbers->end()) {
      refuse_beside(protocol, "has " + theirs + ", and the level of " +
                                  quantity_text(order.varied, value) +
                                  " is not one of them; use --values " + option_values(*numbers) +
                                  " for the levels of the protocol");
    }
    by_level.push_back(conditions[static_cast<std::size_t>(same - numbers->begin())]);
  }
  return by_level;
}

/// From the lowest to the highest point, including points between the samples: the crest of a wave
/// of eight pixels lies between samples, which alone are a twelfth lower.
double relief_height_m(const HeightField& field) {
  const HeightField::Grid& grid = field.grid();
  double lowest_m = field.minimum_m();
  double highest_m = field.maximum_m();
  const double first_x = -0.5 * static_cast<double>(grid.columns - 1);
  const double first_y = -0.5 * static_cast<double>(grid.rows - 1);
  for (const auto& [dx, dy] : {std::pair{0.5, 0.0}, std::pair{0.0, 0.5}, std::pair{0.5, 0.5}}) {
    for (std::size_t row = 0; row < grid.rows; ++row) {
      for (std::size_t column = 0; column < grid.columns; ++column) {
        const double x_m = grid.pitch_m * (first_x + static_cast<double>(column) + dx);
        const double y_m = grid.pitch_m * (first_y + static_cast<double>(row) + dy);
        const double height_m = field.sample(x_m, y_m, Tiling::bounded).height_m;
        lowest_m = std::min(lowest_m, height_m);
        highest_m = std::max(highest_m, height_m);
      }
    }
  }
  return highest_m - lowest_m;
}

std::string height_text(double height_m) {
  return rounded_text(std::round(kMillimetres_per_m * height_m * 1e2) / 1e2) + " mm";
}

void compare_heights(const SweepOrder& order, const Protocol& protocol,
                     const std::filesystem::path& study, std::vector<std::string>& remarks) {
  std::set<std::string> files{};
  for (const auto& [level, spacing_m] : protocol.estimation->spacing_m) {
    const auto texture = protocol.textures.find(level);
    if (texture != protocol.textures.end() && texture->second.height_field) {
      files.insert(*texture->second.height_field);
    }
  }
  // surfaces defined by a formula, whose heights are parameters of a model
  if (files.empty()) return;
  std::optional<double> lowest_m{};
  std::optional<double> highest_m{};
  for (const std::string& file : files) {
    try {
      const double height_m = relief_height_m(*load_height_field(study / file).field);
      lowest_m = std::min(lowest_m.value_or(height_m), height_m);
      highest_m = std::max(highest_m.value_or(height_m), height_m);
    } catch (const std::exception& error) {
      remarks.push_back(
          "the heights of the textures of " + protocol.name +
          " are unknown and were not compared with those of the sweep: " + message_of(error));
      return;
    }
  }
  const double middle_m = std::sqrt(order.spacings_m.front() * order.spacings_m.back());
  const double here_m = relief_height_m(*texture_at_spacing(order.texture, middle_m).field);
  if (is_alike(here_m, *lowest_m, kSameHeight) && is_alike(here_m, *highest_m, kSameHeight)) return;
  const std::string theirs = is_alike(*lowest_m, *highest_m, kSameHeight)
                                 ? height_text(*highest_m)
                                 : height_text(*lowest_m) + " to " + height_text(*highest_m);
  remarks.push_back("the height of the textures from trough to crest is " + height_text(here_m) +
                    " in the sweep and " + theirs + " in " + protocol.name +
                    "; for the same height, change --texture");
}

void compare_spacings(const SweepOrder& order, const Protocol& protocol,
                      std::vector<std::string>& remarks) {
  std::vector<double> theirs_m{};
  for (const auto& [level, spacing_m] : protocol.estimation->spacing_m) {
    theirs_m.push_back(spacing_m);
  }
  if (theirs_m.empty())
    refuse_beside(protocol,
                  "specifies no spacing of its textures; give each texture a \"spacing_m\", or "
                  "leave out --beside");
  const auto [shortest, longest] = std::minmax_element(theirs_m.begin(), theirs_m.end());
  const auto [first, last] = std::minmax_element(order.spacings_m.begin(), order.spacings_m.end());
  const auto range = [](double from_m, double to_m) {
    return rounded_text(kMillimetres_per_m * from_m) + " to " +
           rounded_text(kMillimetres_per_m * to_m) + " mm";
  };
  const bool is_any =
      std::any_of(order.spacings_m.begin(), order.spacings_m.end(), [&](double spacing_m) {
        return spacing_m >= *shortest * (1.0 - kSameNumber) &&
               spacing_m <= *longest * (1.0 + kSameNumber);
      });
  const std::string both = "has spacings of " + range(*shortest, *longest) +
                           ", and the sweep has " + range(*first, *last) + " (--spacings)";
  if (!is_any) refuse_beside(protocol, both + ": they have none in common; change --spacings");
  if (is_alike(*first, *shortest, kSameNumber) && is_alike(*last, *longest, kSameNumber)) return;
  remarks.push_back(protocol.name + ' ' + both +
                    ": the figure shows the common spacings only, but the peak of the parabola is "
                    "computed from all of them; for the same range, change --spacings");
}

void compare_material(const SweepOrder& order, const Protocol& protocol,
                      std::vector<std::string>& remarks) {
  const Material& here = order.stroke.material;
  const Material& there = protocol.material;
  if (!is_alike(here.stiffness_N_per_m, there.stiffness_N_per_m, kSameNumber)) {
    remarks.push_back("the stiffness of the surface is " + number_text(here.stiffness_N_per_m) +
                      " N/m in the sweep and " + number_text(there.stiffness_N_per_m) + " N/m in " +
                      protocol.name + "; for the same stiffness, use --stiffness-n-per-m " +
                      number_text(there.stiffness_N_per_m));
  }
  if (!is_alike(here.friction, there.friction, kSameNumber)) {
    remarks.push_back("the friction coefficient of the surface is " + number_text(here.friction) +
                      " in the sweep and " + number_text(there.friction) + " in " + protocol.name +
                      "; for the same friction, use --friction " + number_text(there.friction));
  }
}

/// Compares the models with which the surfaces of the main trials were rendered.
void compare_models(const SweepOrder& order, const Protocol& protocol,
                    std::vector<std::string>& remarks) {
  if (order.stroke.model == nullptr) return;
  const std::string& here = order.stroke.model->declaration.id;
  std::set<std::string> felt{};
  for (const Trial& trial : possible_trials(protocol)) {
    if (trial.phase != Phase::main) continue;
    for (const PlannedPresentation& planned : trial.presentations) {
      felt.insert(planned.stimulus.model);
    }
  }
  if (felt.empty() || felt == std::set<std::string>{here}) return;
  remarks.push_back("the sweep uses the force model " + here + ", and " + protocol.name + " uses " +
                    listed({felt.begin(), felt.end()}) + "; for the same model, change --model");
}

/// Compares the quantities that neither of the two varies.
void compare_levels(const SweepOrder& order, const Protocol& protocol,
                    std::vector<std::string>& remarks) {
  for (const VariedQuantity quantity : kVariedQuantities) {
    if (quantity == order.varied) continue;
    const bool has_none =
        quantity == VariedQuantity::probe_diameter &&
        (order.stroke.tool || order.stroke.tip.form == TipForm::point ||
         (order.stroke.model != nullptr && !order.stroke.model->declaration.needs_bodies));
    if (has_none) continue;
    const QuantityByCondition by_condition(protocol, quantity);
    const double here = fixed_level(order, quantity);
    const std::string sweep =
        "the sweep has " + quantity_text(quantity, here) + ", and " + protocol.name + ' ';
    const std::string remedy = std::string("; for the same value, change ") + option_of(quantity);
    if (const auto band = by_condition.band_without(here)) {
      remarks.push_back(sweep + "requests " + level_text(quantity, *band) + remedy);
    }
    const std::vector<double> theirs = by_condition.numbers();
    if (theirs.empty() || (theirs.size() == 1 && is_alike(theirs.front(), here, kSameNumber))) {
      continue;
    }
    remarks.push_back(sweep + "has " + quantities_text(quantity, theirs) + remedy);
  }
}

}  // namespace

SweepBeside sweep_beside(const SweepOrder& order, const Protocol& protocol,
                         const std::filesystem::path& study) {
  if (!protocol.estimation || protocol.estimation->spacing.empty()) {
    refuse_beside(protocol,
                  "does not request estimates by spacing; name a protocol with the key "
                  "\"estimation\" and its \"spacing\", or leave out --beside");
  }
  SweepBeside beside{.conditions = conditions_of_levels(order, protocol)};
  compare_models(order, protocol, beside.remarks);
  compare_spacings(order, protocol, beside.remarks);
  compare_heights(order, protocol, study, beside.remarks);
  compare_material(order, protocol, beside.remarks);
  compare_levels(order, protocol, beside.remarks);
  return beside;
}

}  // namespace asperity
