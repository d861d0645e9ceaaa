// Implements the division of a recorded hand into strokes.

#include "app/records/recorded_strokes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "renderers/servo/contact.h"

namespace asperity {
namespace {

constexpr double kStroke_s = 0.25;          // one period of the lowest frequency of a texture, 4 Hz
constexpr double kSlowest_m_per_s = 0.020;  // below it the hand stops or turns
constexpr double kSameDirection = 0.8660254;  // cos 30°

}  // namespace

TextureRecording strokes_of_hand(const RecordedHand& hand) {
  TextureRecording recording{};
  RecordedStroke stroke{};
  glm::dvec2 direction{0.0};
  const TickRecord* previous = nullptr;
  const auto samples = static_cast<std::size_t>(std::lround(kStroke_s * hand.rate_Hz));
  const auto longest_gap_ns = static_cast<std::int64_t>(kUnbroken_ticks * 1e9 / hand.rate_Hz);
  for (const TickRecord& record : hand.records) {
    const glm::dvec2 velocity_m_per_s(record.probe.velocity_m_per_s);
    const double speed_m_per_s = glm::length(velocity_m_per_s);
    const bool is_stroke = record.presentation == hand.presentation && measures_hand(record) &&
                           speed_m_per_s >= kSlowest_m_per_s;
    const bool continues = is_stroke && previous != nullptr &&
                           record.probe.time_ns - previous->probe.time_ns < longest_gap_ns &&
                           glm::dot(velocity_m_per_s, direction) >= kSameDirection * speed_m_per_s;
    if (!continues) stroke = {};
    if (!is_stroke) {
      previous = nullptr;
      continue;
    }
    if (stroke.time_s.empty()) direction = velocity_m_per_s / speed_m_per_s;
    const glm::dvec3& force_N = record.sent.force_N;
    const glm::dvec2 along = velocity_m_per_s / speed_m_per_s;
    stroke.path_m.push_back(stroke.path_m.empty()
                                ? 0.0
                                : stroke.path_m.back() +
                                      glm::length(glm::dvec2(record.probe.position_m) -
                                                  glm::dvec2(previous->probe.position_m)));
    stroke.time_s.push_back(static_cast<double>(record.probe.time_ns) / 1e9);
    stroke.normal_N.push_back(force_N.z);
    stroke.force_N.push_back(hand.component == TextureComponent::normal
                                 ? force_N.z
                                 : -(force_N.x * along.x + force_N.y * along.y));
    previous = &record;
    if (stroke.time_s.size() < samples) continue;
    recording.strokes.push_back(std::move(stroke));
    stroke = {};
  }
  return recording;
}

}  // namespace asperity
