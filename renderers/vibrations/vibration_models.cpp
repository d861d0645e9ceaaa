// Implements vibration models and their table.

#include "renderers/vibrations/vibration_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/line_spectrum.h"
#include "renderers/recordings/number_table.h"

namespace asperity {
namespace {

constexpr double kClosestPlaces = 1e-4;
constexpr const char* kSpeedColumn = "speed_m_per_s";
constexpr const char* kForceColumn = "normal_force_N";
constexpr const char* kVarianceColumn = "variance_m2_per_s4";
constexpr std::size_t kColumnsBeforeLines = 3;

std::string line_column(std::size_t i) { return "line_" + std::to_string(i + 1) + "_rad"; }

/// What is wrong with one model, as the rest of a sentence about it.
std::optional<std::string> complaint_about_model(const VibrationModel& model) {
  const auto negative = [](const char* column, double value) {
    return "has the " + std::string(column) + ' ' + number_text(value) +
           "; it must not be negative. Write the file again with asperity fit-model";
  };
  if (!(model.speed_m_per_s >= 0.0)) return negative(kSpeedColumn, model.speed_m_per_s);
  if (!(model.normal_N >= 0.0)) return negative(kForceColumn, model.normal_N);
  if (!(model.variance_m2_per_s4 >= 0.0)) {
    return negative(kVarianceColumn, model.variance_m2_per_s4);
  }
  if (!std::isfinite(model.speed_m_per_s + model.normal_N + model.variance_m2_per_s4)) {
    return "has a number that is too large; record or import smaller forces";
  }
  double before = 0.0;
  for (std::size_t i = 0; i < model.lines_rad.size(); ++i) {
    const double line = model.lines_rad[i];
    if (!(line > before) || !(line < std::numbers::pi)) {
      return "has the " + line_column(i) + ' ' + number_text(line) +
             "; line spectral frequencies increase from above 0 to below pi. Write the file again "
             "with asperity fit-model";
    }
    before = line;
  }
  return {};
}

/// The places of the columns in the order of the format.
std::vector<std::size_t> places_of_models(const std::vector<std::string>& columns,
                                          const std::string& name) {
  std::vector<std::string> wanted{kSpeedColumn, kForceColumn, kVarianceColumn};
  const std::size_t order =
      columns.size() > kColumnsBeforeLines ? columns.size() - kColumnsBeforeLines : 1;
  for (std::size_t i = 0; i < order; ++i) wanted.push_back(line_column(i));
  std::vector<std::size_t> places{};
  for (const std::string& column : wanted) {
    const auto found = std::find(columns.begin(), columns.end(), column);
    if (found == columns.end()) {
      refuse_table_line(
          name, 1,
          "the column " + column +
              " is missing; add it. Vibration models have the tab-separated columns " +
              kSpeedColumn + ' ' + kForceColumn + ' ' + kVarianceColumn +
              " line_1_rad line_2_rad and so on, and no others");
    }
    places.push_back(static_cast<std::size_t>(found - columns.begin()));
  }
  if (order > kMostSpectralLines) {
    refuse_table_line(name, 1,
                      "the models have the order " + std::to_string(order) + "; the greatest is " +
                          std::to_string(kMostSpectralLines) + ". Fit a lower order");
  }
  return places;
}

}  // namespace

double acceleration_density(const VibrationModel& model, double frequency_Hz) {
  std::vector<double> coefficients(model.lines_rad.size());
  coefficients_of_lines(model.lines_rad, coefficients);
  const double angle_rad = 2.0 * std::numbers::pi * frequency_Hz / kVibrationRate_Hz;
  std::complex<double> inverse = 1.0;
  for (std::size_t j = 0; j < coefficients.size(); ++j) {
    inverse -= coefficients[j] * std::polar(1.0, -angle_rad * static_cast<double>(j + 1));
  }
  return 2.0 * model.variance_m2_per_s4 / (kVibrationRate_Hz * std::norm(inverse));
}

PlaceScale place_scale(const VibrationModels& set) {
  constexpr std::array kConstantBelow{1.1, 1.25};  // times the least speed, the least normal force
  std::array<std::vector<double>, 2> values{};
  for (const VibrationModel& model : set.models) {
    values[0].push_back(model.speed_m_per_s);
    values[1].push_back(model.normal_N);
  }
  PlaceScale scale{};
  std::array<bool, 2> is_told_apart{};  // no two models have the same value
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::sort(values[axis].begin(), values[axis].end());
    const std::vector<double>& sorted = values[axis];
    is_told_apart[axis] = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    const double range = sorted.back() - sorted.front();
    scale.from[static_cast<Eigen::Index>(axis)] = sorted.front();
    scale.per_range[static_cast<Eigen::Index>(axis)] = range > 0.0 ? 1.0 / range : 0.0;
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::vector<double>& sorted = values[axis];
    const std::size_t other = 1 - axis;
    const bool other_varies =
        values[other].back() >= kConstantBelow[other] * values[other].front() &&
        values[other].back() > values[other].front();
    if (is_told_apart[other] && other_varies &&
        sorted.back() < kConstantBelow[axis] * sorted.front()) {
      scale.per_range[static_cast<Eigen::Index>(axis)] = 0.0;
    }
  }
  return scale;
}

std::vector<Eigen::Vector2d> scaled_places(const VibrationModels& set) {
  const PlaceScale scale = place_scale(set);
  std::vector<Eigen::Vector2d> places{};
  for (const VibrationModel& model : set.models) {
    const Eigen::Vector2d place(model.speed_m_per_s, model.normal_N);
    places.emplace_back((place - scale.from).cwiseProduct(scale.per_range));
  }
  return places;
}

void require_models(const VibrationModels& set, const std::string& name) {
  const auto complain = [&name](const std::string& problem) {
    throw std::invalid_argument(name + ": " + problem);
  };
  if (set.models.empty())
    complain(
        "there is no model; fit models to recorded strokes with asperity fit-model, or import a "
        "texture that has models");
  if (set.models.size() > kMostVibrationModels) {
    complain("there are " + std::to_string(set.models.size()) + " models; at most " +
             std::to_string(kMostVibrationModels) + " are possible" +
             ". Fit fewer speeds and normal forces at a time");
  }
  bool sounds = false;
  for (std::size_t i = 0; i < set.models.size(); ++i) {
    const VibrationModel& model = set.models[i];
    if (model.lines_rad.empty() || model.lines_rad.size() > kMostSpectralLines ||
        model.lines_rad.size() != set.models.front().lines_rad.size()) {
      complain("model " + std::to_string(i + 1) + " has the order " +
               std::to_string(model.lines_rad.size()) +
               "; all models need the same order, from 1 to " + std::to_string(kMostSpectralLines));
    }
    if (const auto problem = complaint_about_model(model)) {
      complain("model " + std::to_string(i + 1) + ' ' + *problem);
    }
    sounds = sounds || model.variance_m2_per_s4 > 0.0;
  }
  if (!sounds)
    complain(
        "the variance of every model is 0, so that the texture is silent; record strokes with "
        "vibration");
  const std::vector<Eigen::Vector2d> places = scaled_places(set);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((places[i] - places[j]).norm() > kClosestPlaces) continue;
      complain("the models " + std::to_string(j + 1) + " and " + std::to_string(i + 1) +
               " have the same speed and normal force, " +
               number_text(set.models[i].speed_m_per_s) + " m/s and " +
               number_text(set.models[i].normal_N) + " N; remove one of them");
    }
  }
}

VibrationModels vibration_models_in(std::string_view tsv, const std::string& name) {
  VibrationModels set{};
  std::vector<std::size_t> places{};
  const NumberTable table = number_table_in(
      tsv, name,
      [&](const std::vector<std::string>& columns) { places = places_of_models(columns, name); });
  for (const NumberTable::Row& row : table.rows) {
    VibrationModel model{.speed_m_per_s = row.cells[places[0]],
                         .normal_N = row.cells[places[1]],
                         .variance_m2_per_s4 = row.cells[places[2]]};
    for (std::size_t i = kColumnsBeforeLines; i < places.size(); ++i) {
      model.lines_rad.push_back(row.cells[places[i]]);
    }
    if (const auto problem = complaint_about_model(model)) {
      refuse_table_line(name, row.line, "the model " + *problem);
    }
    set.models.push_back(std::move(model));
  }
  require_models(set, name);
  return set;
}

std::string tsv_of(const VibrationModels& set) {
  std::string text = std::string(kSpeedColumn) + '\t' + kForceColumn + '\t' + kVarianceColumn;
  const std::size_t order = set.models.empty() ? 0 : set.models.front().lines_rad.size();
  for (std::size_t i = 0; i < order; ++i) text += '\t' + line_column(i);
  text += '\n';
  for (const VibrationModel& model : set.models) {
    text += number_text(model.speed_m_per_s) + '\t' + number_text(model.normal_N) + '\t' +
            number_text(model.variance_m2_per_s4);
    for (const double line : model.lines_rad) text += '\t' + number_text(line);
    text += '\n';
  }
  return text;
}

}  // namespace asperity
