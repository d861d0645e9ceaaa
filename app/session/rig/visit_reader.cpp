// Starts a visit when another surface is touched, and updates its mean and deviation with every record.

#include "app/session/rig/visit_reader.h"

#include <cmath>

#include "renderers/servo/contact.h"

namespace asperity {

VisitReader::VisitReader(std::size_t surfaces, double rate_Hz, JudgedForce force)
    : rate_Hz_(rate_Hz), reader_(0.0, force), visits_(surfaces) {}

void VisitReader::Spread::add(double sample) noexcept {
  ++samples;
  const double from_mean = sample - mean;
  mean += from_mean / static_cast<double>(samples);
  squares += from_mean * (sample - mean);
}

double VisitReader::Spread::sd() const noexcept {
  return samples > 1 ? std::sqrt(squares / static_cast<double>(samples - 1)) : 0.0;
}

void VisitReader::take(const TickRecord& record) {
  const std::optional<HandSample> hand = reader_.take(record);
  if (record.has(TickFlag::first_of_presentation)) current_ = 0;
  const std::uint64_t surface = record.presentation;
  if (!is_in_contact(record) || surface < 1 || surface > visits_.size()) {
    touches_ = false;
    return;
  }
  std::vector<VisitRow>& visits = visits_[surface - 1];
  if (surface != current_) {
    current_ = surface;
    touches_ = false;
    contact_ticks_ = 0;
    force_N_ = {};
    speed_m_per_s_ = {};
    visits.push_back({.contact_ns = record.probe.time_ns});
  }
  VisitRow& visit = visits.back();
  const glm::dvec3& position_m = record.probe.position_m;
  if (touches_) visit.path_m += std::hypot(position_m.x - last_m_.x, position_m.y - last_m_.y);
  last_m_ = position_m;
  touches_ = true;
  visit.offset_ns = record.probe.time_ns;
  visit.contact_s = static_cast<double>(++contact_ticks_) / rate_Hz_;
  speed_m_per_s_.add(std::hypot(record.probe.velocity_m_per_s.x, record.probe.velocity_m_per_s.y));
  visit.speed_mean_m_per_s = speed_m_per_s_.mean;
  visit.speed_sd_m_per_s = speed_m_per_s_.sd();
  if (!hand) return;
  force_N_.add(hand->pressing_N);
  visit.force_mean_N = force_N_.mean;
  visit.force_sd_N = force_N_.sd();
}

double VisitReader::contact_s(int position) const {
  double sum_s = 0.0;
  for (const VisitRow& visit : visits(position)) sum_s += visit.contact_s;
  return sum_s;
}

}  // namespace asperity
