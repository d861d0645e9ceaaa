// Declares the square window of cells in which an elastic contact is computed.

#pragma once

#include <array>
#include <cstddef>

namespace asperity {

/// Cells along one side of the window.
inline constexpr std::size_t kCellsAcross = 32;
inline constexpr std::size_t kCells = kCellsAcross * kCellsAcross;

/// One value per cell, row by row: the cell (column, row) is at row·kCellsAcross + column; x grows with the column, y with
/// the row.
using CellField = std::array<double, kCells>;

/// The position of the centre of a column or a row relative to the centre of the window, in cells.
constexpr double from_centre(std::size_t column) noexcept {
  return static_cast<double>(column) - 0.5 * static_cast<double>(kCellsAcross - 1);
}

/// Whether a cell is one of the outermost: a contact that reaches it continues beyond the window, where nothing is computed.
constexpr bool is_at_border(std::size_t cell) noexcept {
  const std::size_t row = cell / kCellsAcross;
  const std::size_t column = cell % kCellsAcross;
  return row == 0 || column == 0 || row + 1 == kCellsAcross || column + 1 == kCellsAcross;
}

}  // namespace asperity
