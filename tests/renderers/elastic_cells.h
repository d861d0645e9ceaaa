// Fields over the cells of an elastic contact, for its tests. Lengths are in cells and pressures in E*, so that a load is a
// pressure and the sum of the loads is the force.

#pragma once

#include <cstddef>

#include "renderers/elastic/half_space_contact.h"

namespace asperity {

inline constexpr HalfSpaceContact::Effort kConverged{.most_iterations = 400, .residual = 1e-8};

/// A field from a function of the distances to the centre of the window.
template <typename Height>
CellField field_of(const Height& height) {
  CellField field{};
  for (std::size_t row = 0; row < kCellsAcross; ++row) {
    for (std::size_t column = 0; column < kCellsAcross; ++column) {
      field[row * kCellsAcross + column] = height(from_centre(column), from_centre(row));
    }
  }
  return field;
}

inline CellField paraboloid(double radius, double depth) {
  return field_of([=](double x, double y) { return depth - 0.5 * (x * x + y * y) / radius; });
}

template <typename Weight>
double sum_of(const CellField& load, const Weight& weight) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kCells; ++i) {
    sum += load[i] * weight(from_centre(i % kCellsAcross), from_centre(i / kCellsAcross));
  }
  return sum;
}

inline double force_of(const CellField& load) {
  return sum_of(load, [](double, double) { return 1.0; });
}

}  // namespace asperity
