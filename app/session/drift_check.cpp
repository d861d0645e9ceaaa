// Fits a line to the readings: its slope is the drift, and its residuals are the noise.

#include "app/session/drift_check.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"

namespace asperity {

namespace {

constexpr double kStepsOfRest = 10.0;

double seconds_of(const TickRecord& record, std::int64_t zero_ns) {
  return static_cast<double>(record.probe.time_ns - zero_ns) * 1e-9;
}

std::string in_mm(double length_m) { return fixed(1e3 * length_m, 3); }

/// `limit_m`: what noise or drift exceeds.
Phrase excess_text(const std::string& part, double limit_m) {
  const Phrase text =
      part == kTipHeld
          ? phrase("DriftCheck",
                   "Noise or drift exceeds the limit of this device, %1 mm: check that the tip is "
                   "held still at its reference, and the device, before you continue.")
          : phrase("DriftCheck",
                   "Noise or drift exceeds the limit of this device, %1 mm: check that nothing "
                   "touches the handle, and the device, before you continue.");
  return text.with(in_mm(limit_m));
}

}  // namespace

RestReading rest_reading(std::span<const TickRecord> records) {
  if (records.empty()) return {};
  const std::int64_t zero_ns = records.front().probe.time_ns;
  const auto n = static_cast<double>(records.size());
  RestReading reading{.ticks = records.size(), .duration_s = seconds_of(records.back(), zero_ns)};
  double mean_s = 0.0;
  for (const TickRecord& record : records) {
    reading.position_m += record.probe.position_m / n;
    mean_s += seconds_of(record, zero_ns) / n;
  }
  glm::dvec3 products{0.0};
  double squares = 0.0;
  for (const TickRecord& record : records) {
    const double from_mean_s = seconds_of(record, zero_ns) - mean_s;
    products += from_mean_s * (record.probe.position_m - reading.position_m);
    squares += from_mean_s * from_mean_s;
  }
  if (records.size() < 3 || squares <= 0.0) return reading;
  const glm::dvec3 drift_m_per_s = products / squares;
  double residuals = 0.0;
  for (const TickRecord& record : records) {
    const glm::dvec3 line_m =
        reading.position_m + drift_m_per_s * (seconds_of(record, zero_ns) - mean_s);
    const glm::dvec3 residual_m = record.probe.position_m - line_m;
    residuals += glm::dot(residual_m, residual_m);
  }
  reading.drift_m = glm::length(drift_m_per_s) * reading.duration_s;
  reading.noise_m = std::sqrt(residuals / (n - 2.0));
  return reading;
}

std::optional<double> rest_limit_m(const DeviceCapability& device) {
  if (device.position_resolution_m <= 0.0) return {};
  return kStepsOfRest * device.position_resolution_m;
}

std::optional<bool> DriftCheck::is_passed() const {
  if (!limit_m) return {};
  return std::max(reading.noise_m, reading.drift_m) <= *limit_m;
}

std::string drift_data_json(const DriftCheck& check) {
  const RestReading& reading = check.reading;
  nlohmann::ordered_json data{
      {"ticks", reading.ticks},
      {"duration_s", reading.duration_s},
      {"position_m", {reading.position_m.x, reading.position_m.y, reading.position_m.z}},
      {"noise_m", reading.noise_m},
      {"drift_m", reading.drift_m}};
  if (check.shift_m) data["shift_m"] = *check.shift_m;
  if (check.limit_m) data["limit_m"] = *check.limit_m;
  if (const auto passed = check.is_passed()) data["passed"] = *passed;
  return data.dump();
}

std::optional<glm::dvec3> first_rest_m(std::span<const EventRow> events, const std::string& part) {
  for (const EventRow& event : events) {
    if (event.kind != kDriftChecked || event.text != part) continue;
    const auto data = nlohmann::json::parse(event.data_json, nullptr, false);
    if (!data.is_object() || !data.contains("position_m")) continue;
    const auto& position = data.at("position_m");
    return glm::dvec3{position.at(0).get<double>(), position.at(1).get<double>(),
                      position.at(2).get<double>()};
  }
  return {};
}

Phrase drift_text(const std::string& part, const DriftCheck& check) {
  const RestReading& reading = check.reading;
  Phrase text = (part == kTipHeld
                     ? phrase("DriftCheck",
                              "Tip at its reference: position (%1, %2, %3) mm, noise %4 mm, drift "
                              "%5 mm in %6 s.")
                     : phrase("DriftCheck",
                              "Handle at rest: position (%1, %2, %3) mm, noise %4 mm, drift %5 mm "
                              "in %6 s."))
                    .with(in_mm(reading.position_m.x), in_mm(reading.position_m.y),
                          in_mm(reading.position_m.z), in_mm(reading.noise_m),
                          in_mm(reading.drift_m), fixed(reading.duration_s, 1));
  const auto add = [&text](const Phrase& sentence) { text = Phrase("%1 %2").with(text, sentence); };
  if (check.shift_m) {
    add(phrase("DriftCheck", "Distance from the first check of the session: %1 mm.")
            .with(in_mm(*check.shift_m)));
  }
  if (check.is_passed() == true) {
    add(phrase("DriftCheck", "Noise and drift are within the limit of this device, %1 mm.")
            .with(in_mm(*check.limit_m)));
  } else if (check.is_passed() == false) {
    add(excess_text(part, *check.limit_m));
  }
  return text;
}

}  // namespace asperity
