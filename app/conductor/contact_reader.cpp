#include "app/conductor/contact_reader.h"

namespace asperity {

namespace {

// Records farther apart than this are not one movement.
constexpr double kLongestStep_s = 0.1;
constexpr double kUsualStep_s = 1e-3;

}  // namespace

std::optional<HandSample> ContactReader::take(const TickRecord& record) noexcept {
  double step_s = static_cast<double>(record.probe.time_ns - last_ns_) * 1e-9;
  last_ns_ = record.probe.time_ns;
  const bool follows = step_s > 0.0 && step_s < kLongestStep_s;
  if (!follows) step_s = kUsualStep_s;
  const bool touches = record.has(TickFlag::presenting) && record.penetration_m > 0.0;
  if (!touches || !follows || record.presentation != presentation_) pressing_.lift();
  presentation_ = record.presentation;
  if (!touches) return std::nullopt;
  const auto& velocity = record.probe.velocity_m_per_s;
  HandSample sample{};
  sample.presentation = record.presentation;
  sample.pressing_N = pressing_.take(record.sent.force_N.z, step_s);
  sample.speed_m_per_s =
      tangential_speed_m_per_s({velocity.x, velocity.y, velocity.z}, {0.0, 0.0, 1.0});
  sample.is_stroking = sample.speed_m_per_s >= kStroking_m_per_s;
  return sample;
}

}  // namespace asperity
