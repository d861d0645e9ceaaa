// Implements the search for the loads of a contact.

#include "renderers/elastic/half_space_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asperity {

void HalfSpaceContact::clear() noexcept {
  if (!is_loaded_) return;
  load_m_.fill(0.0);
  displacement_m_.fill(0.0);
  direction_m_.fill(0.0);
  is_loaded_ = false;
}

// Loads proportional to the overlap, scaled to the maximum of w·s − ½s·K·s.
void HalfSpaceContact::start(const CellField& overlap_m) noexcept {
  for (std::size_t i = 0; i < kCells; ++i) load_m_[i] = std::max(0.0, overlap_m[i]);
  displace_.of(load_m_, displacement_m_);
  double work = 0.0;
  double energy = 0.0;
  for (std::size_t i = 0; i < kCells; ++i) {
    work += load_m_[i] * overlap_m[i];
    energy += load_m_[i] * displacement_m_[i];
  }
  const double scale = work / energy;
  for (std::size_t i = 0; i < kCells; ++i) {
    load_m_[i] *= scale;
    displacement_m_[i] *= scale;
  }
  is_loaded_ = true;
}

double HalfSpaceContact::residual_m(const CellField& overlap_m) const noexcept {
  double worst_m = 0.0;
  for (std::size_t i = 0; i < kCells; ++i) {
    const double gap_m = displacement_m_[i] - overlap_m[i];
    worst_m = std::max(worst_m, load_m_[i] > 0.0 ? std::abs(gap_m) : -gap_m);
  }
  return worst_m;
}

bool HalfSpaceContact::step(const CellField& overlap_m, bool continues) noexcept {
  double square_m2 = 0.0;
  for (std::size_t i = 0; i < kCells; ++i) {
    const double gap_m = displacement_m_[i] - overlap_m[i];
    if (load_m_[i] > 0.0) square_m2 += gap_m * gap_m;
  }
  const double share = continues && gap_square_m2_ > 0.0 ? square_m2 / gap_square_m2_ : 0.0;
  gap_square_m2_ = square_m2;
  for (std::size_t i = 0; i < kCells; ++i) {
    const double gap_m = displacement_m_[i] - overlap_m[i];
    direction_m_[i] = load_m_[i] > 0.0 ? gap_m + share * direction_m_[i] : 0.0;
  }
  displace_.of(direction_m_, of_direction_m_);
  double along = 0.0;
  double curvature = 0.0;
  for (std::size_t i = 0; i < kCells; ++i) {
    along += (displacement_m_[i] - overlap_m[i]) * direction_m_[i];
    curvature += of_direction_m_[i] * direction_m_[i];
  }
  // Without a gap in contact there is no direction; new cells are then added as if each were alone.
  constexpr double kOfOneCell = 0.89;  // 1/K of a cell on itself
  const double length = curvature > 0.0 ? along / curvature : kOfOneCell;
  bool has_new = false;
  bool has_lost = false;
  for (std::size_t i = 0; i < kCells; ++i) {
    if (load_m_[i] > 0.0) {
      load_m_[i] -= length * direction_m_[i];
      if (load_m_[i] > 0.0) continue;
      load_m_[i] = 0.0;
      has_lost = true;
    } else if (displacement_m_[i] < overlap_m[i]) {
      load_m_[i] = length * (overlap_m[i] - displacement_m_[i]);
      has_new = true;
    }
  }
  if (has_new || has_lost) {
    displace_.of(load_m_, displacement_m_);
  } else {
    for (std::size_t i = 0; i < kCells; ++i) displacement_m_[i] -= length * of_direction_m_[i];
  }
  return !has_new;
}

double HalfSpaceContact::solve(const CellField& overlap_m, const Effort& effort) noexcept {
  const double deepest_m = *std::max_element(overlap_m.begin(), overlap_m.end());
  if (!(deepest_m > 0.0)) {
    clear();
    return 0.0;
  }
  if (!is_loaded_) start(overlap_m);
  bool continues = false;
  double worst_m = residual_m(overlap_m);
  for (int i = 0; i < effort.most_iterations && worst_m > effort.residual * deepest_m; ++i) {
    continues = step(overlap_m, continues);
    worst_m = residual_m(overlap_m);
  }
  return worst_m / deepest_m;
}

}  // namespace asperity
