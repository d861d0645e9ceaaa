// Bands, turning points and tangential speed.

#include "analysis/signals/compliance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/numbers/number_text.h"

namespace asperity {

bool is_inside(const AskedBand& band, double value) noexcept {
  return (!band.minimum || value >= *band.minimum) && (!band.maximum || value <= *band.maximum);
}

std::optional<Compliance> compliance_of(std::span<const double> samples, const AskedBand& band) {
  if ((band.minimum && std::isnan(*band.minimum)) || (band.maximum && std::isnan(*band.maximum)) ||
      (band.minimum && band.maximum && *band.minimum > *band.maximum)) {
    throw std::invalid_argument(
        "band: minimum is " + (band.minimum ? number_text(*band.minimum) : "absent") +
        " and maximum is " + (band.maximum ? number_text(*band.maximum) : "absent") +
        "; both must be numbers or absent, and minimum must not exceed maximum");
  }
  const std::optional<Summary> summary = summary_of(samples);
  if (!summary) {
    return std::nullopt;
  }
  Compliance compliance{.summary = *summary, .fraction_inside = {}};
  if (band.minimum || band.maximum) {
    std::size_t inside = 0;
    for (const double sample : samples) {
      if (is_inside(band, sample)) ++inside;
    }
    compliance.fraction_inside = static_cast<double>(inside) / static_cast<double>(samples.size());
  }
  return compliance;
}

double PressingForce::take(double force_N, double duration_s) noexcept {
  const double kept = kMemory_s / (kMemory_s + duration_s);
  weighted_N_s_ = kept * weighted_N_s_ + duration_s * force_N;
  weight_s_ = kept * weight_s_ + duration_s;
  return weighted_N_s_ / weight_s_;
}

double StrokePassage::speed_m_per_s() const noexcept {
  return duration_s > 0.0 ? std::abs(length_m) / duration_s : 0.0;
}

StrokePassage StrokeCutter::between(const Extreme& begin, const Extreme& end) noexcept {
  return {begin.sample, end.sample, end.at_m - begin.at_m,
          static_cast<double>(end.time_ns - begin.time_ns) * 1e-9,
          static_cast<double>(begin.left_ns - begin.time_ns) * 1e-9};
}

std::optional<StrokePassage> StrokeCutter::take(double position_m, std::int64_t time_ns) noexcept {
  const Extreme here{samples_, position_m, time_ns, time_ns};
  if (samples_++ == 0) {
    lowest_ = highest_ = here;
    began_ns_ = time_ns;
  }
  std::optional<StrokePassage> ended{};
  const bool came_back = highest_.at_m - position_m >= least_length_m_;
  const bool came_forth = position_m - lowest_.at_m >= least_length_m_;
  if (going_ != Going::back && came_back) {
    if (going_ == Going::forth) ended = between(lowest_, highest_);
    going_ = Going::back;
    lowest_ = here;
  } else if (going_ != Going::forth && came_forth) {
    if (going_ == Going::back) ended = between(highest_, lowest_);
    going_ = Going::forth;
    highest_ = here;
  }
  if (going_ != Going::back && position_m > highest_.at_m) highest_ = here;
  if (going_ != Going::forth && position_m < lowest_.at_m) lowest_ = here;
  if (highest_.at_m - position_m <= kTurn_m) highest_.left_ns = time_ns;
  if (position_m - lowest_.at_m <= kTurn_m) lowest_.left_ns = time_ns;
  return ended;
}

std::optional<StrokePassage> StrokeCutter::under_way() const noexcept {
  if (going_ == Going::forth) return between(lowest_, highest_);
  if (going_ == Going::back) return between(highest_, lowest_);
  return std::nullopt;
}

std::int64_t StrokeCutter::reached_ns() const noexcept {
  if (going_ == Going::forth) return highest_.time_ns;
  if (going_ == Going::back) return lowest_.time_ns;
  return began_ns_;
}

std::vector<StrokePassage> strokes_along(std::span<const double> position_m,
                                         double least_length_m) {
  if (!(least_length_m > 0.0)) {
    throw std::invalid_argument("least_length_m is " + number_text(least_length_m) +
                                "; it must be above 0");
  }
  std::vector<StrokePassage> strokes;
  StrokeCutter cutter(least_length_m);
  for (std::size_t i = 0; i < position_m.size(); ++i) {
    if (!std::isfinite(position_m[i])) {
      throw std::invalid_argument("position_m: sample " + std::to_string(i) +
                                  " is not finite; all samples must be finite");
    }
    if (const auto ended = cutter.take(position_m[i], 0)) strokes.push_back(*ended);
  }
  if (const auto last = cutter.under_way()) strokes.push_back(*last);
  return strokes;
}

void HandStrokes::take(double along_m, std::int64_t time_ns) {
  now_ns_ = time_ns;
  if (const auto ended = cutter_.take(along_m, time_ns)) {
    lengths_m_.push_back(std::abs(ended->length_m));
    speeds_m_per_s_.push_back(ended->speed_m_per_s());
    last_ = ended;
    last_progress_ = std::exchange(progress_, {});
  }
  const auto stroke = cutter_.under_way();
  if (!stroke) return;
  const double length_m = std::abs(stroke->length_m);
  if (progress_.empty() || length_m > progress_.back().length_m) {
    progress_.push_back({length_m, stroke->duration_s});
  }
}

void HandStrokes::lift() {
  lengths_m_ = lengths_m();
  speeds_m_per_s_ = speeds_m_per_s();
  cutter_ = StrokeCutter();
  last_.reset();
  last_progress_.clear();
  progress_.clear();
}

std::vector<double> HandStrokes::lengths_m() const {
  std::vector<double> lengths = lengths_m_;
  if (const auto cut_off = cutter_.under_way()) lengths.push_back(std::abs(cut_off->length_m));
  return lengths;
}

std::vector<double> HandStrokes::speeds_m_per_s() const {
  std::vector<double> speeds = speeds_m_per_s_;
  const auto cut_off = cutter_.under_way();
  if (cut_off && !last_) speeds.push_back(cut_off->speed_m_per_s());
  return speeds;
}

std::optional<double> HandStrokes::speed_to_tell_m_per_s() const noexcept {
  if (static_cast<double>(now_ns_ - cutter_.reached_ns()) * 1e-9 > kTurn_s) return 0.0;
  const double half_m = 0.5 * (last_ ? std::abs(last_->length_m) : usual_length_m_);
  const auto stroke = cutter_.under_way();
  const double length_m = stroke ? std::abs(stroke->length_m) : 0.0;
  if (!stroke || length_m < half_m) {
    return last_ ? std::optional(last_->speed_m_per_s()) : std::nullopt;
  }
  const auto then = std::lower_bound(
      last_progress_.begin(), last_progress_.end(), length_m,
      [](const Progress& one, double so_far_m) { return one.length_m < so_far_m; });
  if (then == last_progress_.end()) return stroke->speed_m_per_s();
  const double moved_s = stroke->duration_s - stroke->rest_s;
  const double last_moved_s = then->duration_s - last_->rest_s;
  // A hand that went back to its turn after it had left it has no time course to go by.
  if (moved_s <= 0.0 || last_moved_s <= 0.0) return stroke->speed_m_per_s();
  return std::abs(last_->length_m) /
         (stroke->rest_s + moved_s * (last_->duration_s - last_->rest_s) / last_moved_s);
}

double tangential_speed_m_per_s(const std::array<double, 3>& velocity_m_per_s,
                                const std::array<double, 3>& normal) noexcept {
  double along_normal = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    along_normal += velocity_m_per_s[i] * normal[i];
  }
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double tangential = velocity_m_per_s[i] - along_normal * normal[i];
    square += tangential * tangential;
  }
  return std::sqrt(square);
}

}  // namespace asperity
