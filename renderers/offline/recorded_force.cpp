// Implements the analysis of the force in a recording.

#include "renderers/offline/recorded_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "analysis/signals/compliance.h"
#include "analysis/signals/spectrum.h"
#include "renderers/offline/felt_roughness.h"
#include "renderers/offline/replay.h"
#include "renderers/servo/contact.h"

namespace asperity {
namespace {

// A shorter stretch of contact contains too few periods of the band's lower limit (5 Hz).
constexpr double kShortestStretch_s = 0.25;
// Dropped at a contact's end, where the hand lifts the tool.
constexpr double kLifting_s = 0.1;

/// Pools the accelerations of a held tool over several contacts.
class Shaking final {
 public:
  explicit Shaking(double rate_Hz) : rate_Hz_(rate_Hz) {}

  /// Adds the forces from the first to the last tick of one contact.
  void add_contact(std::span<const glm::dvec3> forces_N) {
    const auto lifting = static_cast<std::size_t>(kLifting_s * rate_Hz_);
    if (forces_N.size() <= lifting) return;
    FeltRoughness felt({.rate_Hz = rate_Hz_,
                        .window_s = static_cast<double>(forces_N.size()) / rate_Hz_,
                        .shortest_s = kShortestStretch_s});
    for (const glm::dvec3& force_N : forces_N.first(forces_N.size() - lifting)) felt.add(force_N);
    const std::optional<double> rms_m_per_s2 = felt.rms_accel_m_per_s2();
    if (!rms_m_per_s2) return;
    sum_m2_per_s4_ += *rms_m_per_s2 * *rms_m_per_s2 * static_cast<double>(felt.judged());
    samples_ += felt.judged();
  }

  std::optional<double> rms_m_per_s2() const {
    if (samples_ == 0) return {};
    return std::sqrt(sum_m2_per_s4_ / static_cast<double>(samples_));
  }

 private:
  double rate_Hz_ = 0.0;
  double sum_m2_per_s4_ = 0.0;
  std::size_t samples_ = 0;
};

}  // namespace

std::optional<double> recorded_shaking_m_per_s2(const RecordedSurfaceSpan& surface) {
  Shaking shaking(surface.rate_Hz);
  std::vector<glm::dvec3> forces_N{};
  std::size_t touched = 0;  // number of forces until the last tick of contact
  glm::dvec2 along{1.0, 0.0};
  std::int64_t last_touch_ns = 0;
  constexpr auto kLift_ns = static_cast<std::int64_t>(kLift_s * 1e9);
  const auto end_of_contact = [&] {
    shaking.add_contact(std::span(forces_N).first(touched));
    forces_N.clear();
    touched = 0;
  };
  for (const TickRecord& record : surface.records) {
    const bool touches = is_in_contact(record, surface.presentation);
    if (touched > 0 && (!is_rendered(record, surface.presentation) ||
                        record.probe.time_ns - last_touch_ns > kLift_ns)) {
      end_of_contact();
    }
    if (!touches && touched == 0) continue;
    const glm::dvec2 velocity_m_per_s(record.probe.velocity_m_per_s);
    const double speed_m_per_s = glm::length(velocity_m_per_s);
    if (speed_m_per_s > 0.0) along = velocity_m_per_s / speed_m_per_s;
    const glm::dvec3& force_N = record.sent.force_N;
    forces_N.emplace_back(force_N.x * along.x + force_N.y * along.y,
                          force_N.y * along.x - force_N.x * along.y, force_N.z);
    if (!touches) continue;
    touched = forces_N.size();
    last_touch_ns = record.probe.time_ns;
  }
  end_of_contact();
  return shaking.rms_m_per_s2();
}

ForceFeatures recorded_force_features(const RecordedSurfaceSpan& surface) {
  std::vector<double> time_s{};
  std::vector<double> travel_m{};
  std::vector<double> normal_N{};
  std::vector<double> lateral_N{};
  double travelled_m = 0.0;
  double sum_of_depths_m = 0.0;
  double sum_of_normal_N = 0.0;
  const TickRecord* previous = nullptr;
  for (const TickRecord& record : surface.records) {
    if (!is_in_contact(record, surface.presentation)) {
      previous = nullptr;
      continue;
    }
    const glm::dvec3& velocity = record.probe.velocity_m_per_s;
    const glm::dvec3& force = record.sent.force_N;
    if (previous != nullptr) {
      const glm::dvec3 motion_m = record.probe.position_m - previous->probe.position_m;
      travelled_m += std::hypot(motion_m.x, motion_m.y);
    }
    previous = &record;
    const double speed_m_per_s =
        tangential_speed_m_per_s({velocity.x, velocity.y, velocity.z}, {0.0, 0.0, 1.0});
    const double along_N =
        speed_m_per_s > 0.0 ? -(force.x * velocity.x + force.y * velocity.y) / speed_m_per_s : 0.0;
    time_s.push_back(
        static_cast<double>(record.probe.time_ns - surface.records.front().probe.time_ns) * 1e-9);
    travel_m.push_back(travelled_m);
    normal_N.push_back(force.z);
    lateral_N.push_back(along_N);
    sum_of_depths_m += record.penetration_m;
    sum_of_normal_N += force.z;
  }
  ForceFeatures features = force_features({time_s, travel_m, normal_N, lateral_N});
  features.shaking_m_per_s2 = recorded_shaking_m_per_s2(surface).value_or(0.0);
  if (sum_of_normal_N > 0.0) features.compliance_m_per_N = sum_of_depths_m / sum_of_normal_N;
  return features;
}

std::vector<TickRecord> records_as_felt(const RecordedSurfaceSpan& surface) {
  std::vector<TickRecord> felt{};
  felt.reserve(surface.records.size());
  std::uint64_t rendered = 0;  // the surface of the last tick in which one was rendered
  for (const TickRecord& record : surface.records) {
    if (!record.has(TickFlag::presenting)) continue;
    const bool is_entry = record.presentation != rendered;
    rendered = record.presentation;
    if (rendered != surface.presentation) continue;
    felt.push_back(record);
    if (is_entry) {
      felt.back().flags |= static_cast<std::uint32_t>(TickFlag::first_of_presentation);
    }
  }
  return felt;
}

RecordedTexture recorded_texture(const ForceModel& model, const RendererInputs& inputs,
                                 const RecordedSurfaceSpan& surface) {
  RecordedTexture texture{.felt = records_as_felt(surface), .rate_Hz = surface.rate_Hz};
  if (texture.felt.empty()) return texture;
  RendererInputs plain = without_texture(model.declaration, inputs);
  plain.material.friction = inputs.material.friction;
  texture.plate = replay(*make_renderer(model, plain), texture.felt, surface.rate_Hz);
  return texture;
}

std::optional<double> recorded_texture_force_rms_N(const RecordedTexture& texture,
                                                   const TextureForceBand& band) {
  const std::vector<TickRecord>& felt = texture.felt;
  const double rate_Hz = texture.rate_Hz;
  const auto shortest = static_cast<std::size_t>(kShortestStretch_s * rate_Hz);
  std::array<std::vector<double>, 3> stretch_N{};
  double sum_of_squares_N2 = 0.0;
  std::size_t samples = 0;
  const auto end_of_stretch = [&] {
    const std::size_t length = stretch_N[0].size();
    if (length >= shortest) {
      for (const std::vector<double>& axis_N : stretch_N) {
        const double rms_N =
            band_rms(axis_N, rate_Hz, band.low_Hz, std::min(band.high_Hz, 0.5 * rate_Hz));
        sum_of_squares_N2 += rms_N * rms_N * static_cast<double>(length);
      }
      samples += length;
    }
    for (std::vector<double>& axis_N : stretch_N) axis_N.clear();
  };
  const auto longest_gap_ns = static_cast<std::int64_t>(kUnbroken_ticks * 1e9 / rate_Hz);
  for (std::size_t i = 0; i < felt.size(); ++i) {
    const bool unbroken =
        i == 0 || felt[i].probe.time_ns - felt[i - 1].probe.time_ns < longest_gap_ns;
    if (!unbroken) end_of_stretch();
    if (!measures_hand(felt[i])) {
      end_of_stretch();
      continue;
    }
    const glm::dvec3 texture_N = felt[i].rendered.force_N - texture.plate[i].wrench.force_N;
    stretch_N[0].push_back(texture_N.x);
    stretch_N[1].push_back(texture_N.y);
    stretch_N[2].push_back(texture_N.z);
  }
  end_of_stretch();
  if (samples == 0) return {};
  return std::sqrt(sum_of_squares_N2 / static_cast<double>(samples));
}

}  // namespace asperity
