// Takes round steps from QCustomPlot on linear axes, and labels multiples of powers of ten on logarithmic ones.

#include "app/figures/axis_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include <qcustomplot.h>

#include "analysis/numbers/number_text.h"

namespace asperity {

namespace {

/// With a minus sign, which is as wide as a digit.
std::string label_of(double value) {
  return value < 0.0 ? "−" + number_text(-value) : number_text(value);
}

std::vector<AxisTick> round_ticks(const FigureAxis& axis, int count) {
  QCPAxisTicker ticker{};
  ticker.setTickCount(count);
  QVector<double> values{};
  ticker.generate({axis.low, axis.high}, QLocale::c(), 'g', 6, values, nullptr, nullptr);
  // The library continues one step beyond both ends, and its sums contain 0.30000000000000004.
  const double room = 1e-9 * (axis.high - axis.low);
  std::vector<AxisTick> ticks{};
  for (const double value : values) {
    if (value < axis.low - room || value > axis.high + room) continue;
    const double round = std::abs(value) < room ? 0.0 : QString::number(value, 'g', 10).toDouble();
    ticks.push_back({.value = round, .label = label_of(round)});
  }
  return ticks;
}

/// At least two: a single number does not show how long a unit is. A round step may be longer than
/// the axis; about six steps always leave two ticks.
std::vector<AxisTick> linear_ticks(const FigureAxis& axis, int labels) {
  constexpr std::size_t kLeast = 2;
  constexpr int kShortSteps = 6;
  std::vector<AxisTick> ticks = round_ticks(axis, labels);
  for (int count = labels + 1; ticks.size() < kLeast && count <= kShortSteps; ++count) {
    ticks = round_ticks(axis, count);
  }
  return ticks;
}

/// The labelled multiples of powers of ten: a longer list where a shorter one gives too few labels.
constexpr std::array<std::initializer_list<int>, 4> kLabelled{
    std::initializer_list<int>{1}, std::initializer_list<int>{1, 3},
    std::initializer_list<int>{1, 2, 5}, std::initializer_list<int>{1, 2, 3, 4, 5, 6, 8}};

std::vector<AxisTick> log_ticks(const FigureAxis& axis, int labels_wished) {
  constexpr std::size_t kEnough = 3;
  std::vector<AxisTick> ticks{};
  for (const std::initializer_list<int>& labelled : kLabelled) {
    ticks.clear();
    std::size_t labels = 0;
    const int last = static_cast<int>(std::floor(std::log10(axis.high)));
    for (int power = static_cast<int>(std::floor(std::log10(axis.low))); power <= last; ++power) {
      for (int digit = 1; digit <= 9; ++digit) {
        // Negative powers of ten are inexact: 2 / 10, not 2 · 0.1.
        const double scale = std::pow(10.0, std::abs(power));
        const double value = power < 0 ? digit / scale : digit * scale;
        if (value < axis.low * (1.0 - 1e-9) || value > axis.high * (1.0 + 1e-9)) continue;
        const bool has_label = std::count(labelled.begin(), labelled.end(), digit) > 0;
        labels += has_label ? 1 : 0;
        ticks.push_back(
            {.value = value, .label = has_label ? Phrase(number_text(value)) : Phrase()});
      }
    }
    if (labels >= kEnough) return ticks;
  }
  // From 1.3 to 1.7 there is no such multiple.
  return linear_ticks(axis, labels_wished);
}

}  // namespace

std::vector<AxisTick> ticks_of(const FigureAxis& axis, int labels) {
  if (!axis.places.empty()) {
    std::vector<AxisTick> ticks{};
    for (const Phrase& place : axis.places) {
      ticks.push_back({.value = static_cast<double>(ticks.size()), .label = place});
    }
    return ticks;
  }
  return axis.scale == AxisScale::log10 ? log_ticks(axis, labels) : linear_ticks(axis, labels);
}

}  // namespace asperity
