// Implements the relaxation of a half-space.

#include "renderers/elastic/relaxing_half_space.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asperity {
namespace {

constexpr double kNoDent_m = 1e-12;

/// A coordinate in the window as a cell and the part of the way to the next one; the border is continued.
struct Between {
  std::size_t cell = 0;
  double part = 0.0;
};

Between between(double at) noexcept {
  constexpr double kLast = static_cast<double>(kCellsAcross - 1);
  const double inside = std::clamp(at, 0.0, kLast);
  const auto cell = std::min(static_cast<std::size_t>(inside), kCellsAcross - 2);
  return {.cell = cell, .part = inside - static_cast<double>(cell)};
}

}  // namespace

void RelaxingHalfSpace::reset() noexcept {
  contact_.clear();
  load_m_.fill(0.0);
  dent_m_.fill(0.0);
  delayed_m_.fill(0.0);
  displaced_m_.fill(0.0);
  is_loaded_ = false;
  has_dent_ = false;
}

void RelaxingHalfSpace::move(CellField& field, const glm::dvec2& moved) noexcept {
  for (std::size_t row = 0; row < kCellsAcross; ++row) {
    const Between y = between(static_cast<double>(row) + moved.y);
    const double* const low = &field[y.cell * kCellsAcross];
    const double* const high = low + kCellsAcross;
    for (std::size_t column = 0; column < kCellsAcross; ++column) {
      const Between x = between(static_cast<double>(column) + moved.x);
      const double below = low[x.cell] + x.part * (low[x.cell + 1] - low[x.cell]);
      const double above = high[x.cell] + x.part * (high[x.cell + 1] - high[x.cell]);
      moved_m_[row * kCellsAcross + column] = below + y.part * (above - below);
    }
  }
  field = moved_m_;
}

CellField RelaxingHalfSpace::displacement_m() const noexcept {
  CellField displacement_m{};
  for (std::size_t i = 0; i < kCells; ++i) {
    displacement_m[i] = displaced_m_[i] / material_.ratio + delayed_m_[i];
  }
  return displacement_m;
}

double RelaxingHalfSpace::advance(const CellField& overlap_m, const glm::dvec2& moved, double dt_s,
                                  const HalfSpaceContact::Effort& effort) noexcept {
  const double delayed_share = 1.0 - 1.0 / material_.ratio;
  const double time_s = material_.ratio * material_.time_s;
  const double kept = std::exp(-dt_s / time_s);
  const double mean = -std::expm1(-dt_s / time_s) * time_s / dt_s;
  const double of_before = delayed_share * (mean - kept);
  const double of_now = delayed_share * (1.0 - mean);
  if (has_dent_) {
    if (moved != glm::dvec2(0.0)) {
      move(delayed_m_, moved);
      move(displaced_m_, moved);
    }
    for (std::size_t i = 0; i < kCells; ++i) {
      dent_m_[i] = kept * delayed_m_[i] + of_before * displaced_m_[i];
    }
    if (*std::max_element(dent_m_.begin(), dent_m_.end()) < kNoDent_m) {
      dent_m_.fill(0.0);
      has_dent_ = false;
    }
  }
  for (std::size_t i = 0; i < kCells; ++i) effective_m_[i] = overlap_m[i] - dent_m_[i];
  const double residual = contact_.solve(effective_m_, effort);
  const bool was_loaded = is_loaded_;
  is_loaded_ = *std::max_element(contact_.load_m().begin(), contact_.load_m().end()) > 0.0;
  if (!is_loaded_ && !was_loaded && !has_dent_) return residual;
  const double compliance = 1.0 / material_.ratio + of_now;
  for (std::size_t i = 0; i < kCells; ++i) {
    load_m_[i] = contact_.load_m()[i] / compliance;
    displaced_m_[i] = contact_.displacement_m()[i] / compliance;
    delayed_m_[i] = dent_m_[i] + of_now * displaced_m_[i];
  }
  has_dent_ = has_dent_ || (is_loaded_ && delayed_share > 0.0);
  return residual;
}

}  // namespace asperity
