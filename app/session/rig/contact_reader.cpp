// Computes force and speed of a tick, accumulates them while in contact, and derives the guide tone.

#include "app/session/rig/contact_reader.h"

#include <cmath>
#include <vector>

#include "renderers/force/adjacent_patches.h"
#include "renderers/servo/contact.h"

namespace asperity {

namespace {

constexpr double kUsualStep_s = 1e-3;

QuantitySoFar quantity_of(const std::vector<double>& samples, const AskedBand& band) {
  QuantitySoFar quantity{};
  if (const auto met = compliance_of(samples, band)) {
    quantity = {.samples = static_cast<std::int64_t>(samples.size()),
                .mean = met->summary.mean,
                .sd = met->summary.sd,
                .fraction_in_band = met->fraction_inside};
  }
  return quantity;
}

}  // namespace

JudgedForce judged_force_of(const DeviceCapability& device) noexcept {
  return device.actuated_degrees_of_freedom > 0 ? JudgedForce::sent : JudgedForce::rendered;
}

const char* text_of(JudgedForce force) noexcept {
  return force == JudgedForce::sent ? "sent" : "rendered";
}

ContactReader::ContactReader(double direction_rad, JudgedForce force) noexcept
    : along_x_(std::cos(direction_rad)), along_y_(std::sin(direction_rad)), force_(force) {}

std::optional<HandSample> ContactReader::take(const TickRecord& record) noexcept {
  const std::int64_t time_ns = record.probe.time_ns;
  const double step_s = static_cast<double>(time_ns - last_ns_) * 1e-9;
  const double untouched_s = static_cast<double>(time_ns - touched_ns_) * 1e-9;
  last_ns_ = time_ns;
  const bool touches = measures_hand(record);
  const bool goes_on = in_contact_ && untouched_s > 0.0 && untouched_s <= kSkip_s &&
                       (!touches || record.presentation == presentation_);
  if (!touches) {
    in_contact_ = goes_on;
    return std::nullopt;
  }
  HandSample sample{};
  sample.presentation = record.presentation;
  sample.begins_contact = !goes_on;
  if (goes_on) {
    if (untouched_s > step_s) pressing_.take(0.0, untouched_s - step_s);
  } else {
    pressing_.lift();
  }
  const Wrench& judged = force_ == JudgedForce::sent ? record.sent : record.rendered;
  sample.pressing_N = pressing_.take(judged.force_N.z, goes_on ? step_s : kUsualStep_s);
  sample.along_m = along_x_ * record.probe.position_m.x + along_y_ * record.probe.position_m.y;
  presentation_ = record.presentation;
  touched_ns_ = time_ns;
  in_contact_ = true;
  return sample;
}

HandWatch::HandWatch(const HandBands& bands)
    : bands_(bands), reader_(bands.direction_rad, bands.force) {}

void HandWatch::Tally::add(double sample, const AskedBand& band) noexcept {
  ++samples;
  if (is_inside(band, sample)) ++inside;
  const double from_mean = sample - mean;
  mean += from_mean / static_cast<double>(samples);
  squares += from_mean * (sample - mean);
}

QuantitySoFar HandWatch::Tally::so_far(const AskedBand& band) const {
  QuantitySoFar quantity{.samples = samples, .mean = mean};
  if (samples > 1) quantity.sd = std::sqrt(squares / static_cast<double>(samples - 1));
  if (samples > 0 && (band.minimum || band.maximum)) {
    quantity.fraction_in_band = static_cast<double>(inside) / static_cast<double>(samples);
  }
  return quantity;
}

HandWatch::Side HandWatch::side_of(const AskedBand& band, double value, Side before) noexcept {
  double back_inside = 0.0;
  if (band.minimum && band.maximum) {
    back_inside = kBackInside * (*band.maximum - *band.minimum);
  } else if (band.minimum || band.maximum) {
    back_inside = kBackInside * std::abs(band.minimum ? *band.minimum : *band.maximum);
  }
  const double above_minimum = before == Side::below ? back_inside : 0.0;
  const double below_maximum = before == Side::above ? back_inside : 0.0;
  if (band.minimum && value < *band.minimum + above_minimum) return Side::below;
  if (band.maximum && value > *band.maximum - below_maximum) return Side::above;
  return Side::inside;
}

void HandWatch::take(const TickRecord& record) {
  const std::optional<HandSample> sample = reader_.take(record);
  if (record.has(TickFlag::presenting) && record.presentation != kSideBySide) {
    presented_ = record.presentation;
  }
  if (sample) {
    Surface& surface =
        surfaces_.try_emplace(sample->presentation, Surface{{}, HandStrokes(bands_.usual_stroke_m)})
            .first->second;
    surface.force_N.add(sample->pressing_N, bands_.normal_force_N);
    if (sample->begins_contact) surface.strokes.lift();
    surface.strokes.take(sample->along_m, record.probe.time_ns);
    now_ = Now{sample->pressing_N, surface.strokes.speed_to_tell_m_per_s()};
    force_ = side_of(bands_.normal_force_N, now_->pressing_N, force_);
    speed_ = now_->stroking_m_per_s ? side_of(bands_.speed_m_per_s, *now_->stroking_m_per_s, speed_)
                                    : Side::inside;
  } else if (!reader_.is_in_contact()) {
    now_.reset();
    force_ = speed_ = Side::inside;
  }
}

HandSoFar HandWatch::so_far() const {
  HandSoFar hand{.surface = static_cast<int>(presented_)};
  if (const auto found = surfaces_.find(presented_); found != surfaces_.end()) {
    hand.force_N = found->second.force_N.so_far(bands_.normal_force_N);
    hand.speed_m_per_s = quantity_of(found->second.strokes.speeds_m_per_s(), bands_.speed_m_per_s);
  }
  return hand;
}

GuideTone HandWatch::tone() const noexcept {
  if (force_ == Side::below) return GuideTone::press_more;
  if (force_ == Side::above) return GuideTone::press_less;
  if (speed_ == Side::below) return GuideTone::faster;
  if (speed_ == Side::above) return GuideTone::slower;
  return GuideTone::none;
}

}  // namespace asperity
