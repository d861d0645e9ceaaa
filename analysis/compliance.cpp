// Bands, turning points and tangential speed.

#include "analysis/compliance.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace asperity {

bool is_inside(const AskedBand& band, double value) noexcept {
  return (!band.minimum || value >= *band.minimum) && (!band.maximum || value <= *band.maximum);
}

std::optional<Compliance> compliance_of(std::span<const double> samples, const AskedBand& band) {
  if ((band.minimum && std::isnan(*band.minimum)) || (band.maximum && std::isnan(*band.maximum)) ||
      (band.minimum && band.maximum && *band.minimum > *band.maximum)) {
    throw std::invalid_argument("band: minimum and maximum must be numbers in this order");
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

std::vector<StrokePassage> strokes_along(std::span<const double> position_m,
                                         double least_length_m) {
  if (!(least_length_m > 0.0)) {
    throw std::invalid_argument("least_length_m must be positive");
  }
  std::vector<StrokePassage> strokes;
  // Until the hand has gone the least length, both extremes may become the first turning point;
  // from then on `lowest` or `highest` is where the stroke under way began, the other its far end.
  enum class Going { undecided, forth, back };
  Going going = Going::undecided;
  std::size_t lowest = 0;
  std::size_t highest = 0;
  const auto add = [&](std::size_t begin, std::size_t end) {
    strokes.push_back({begin, end, position_m[end] - position_m[begin]});
  };
  for (std::size_t i = 0; i < position_m.size(); ++i) {
    const double at_m = position_m[i];
    if (!std::isfinite(at_m)) {
      throw std::invalid_argument("position_m: sample " + std::to_string(i) + " is not finite");
    }
    const bool came_back = position_m[highest] - at_m >= least_length_m;
    const bool came_forth = at_m - position_m[lowest] >= least_length_m;
    if (going == Going::forth && came_back) {
      add(lowest, highest);
      going = Going::back;
      lowest = i;
    } else if (going == Going::back && came_forth) {
      add(highest, lowest);
      going = Going::forth;
      highest = i;
    } else if (going == Going::undecided && came_forth) {
      going = Going::forth;
      highest = i;
    } else if (going == Going::undecided && came_back) {
      going = Going::back;
      lowest = i;
    }
    if (going != Going::back && at_m > position_m[highest]) {
      highest = i;
    }
    if (going != Going::forth && at_m < position_m[lowest]) {
      lowest = i;
    }
  }
  if (going == Going::forth) {
    add(lowest, highest);
  } else if (going == Going::back) {
    add(highest, lowest);
  }
  return strokes;
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
