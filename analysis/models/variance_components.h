// How much repeated numbers of participants vary over participants, over cells within participants, and within cells.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace asperity {

/// A number of a participant in a cell: a rating of an item, the logarithm of an estimate of a stimulus.
struct CellNumber {
  std::size_t participant = 0;
  std::size_t cell = 0;
  double value = 0.0;
};

/// The standard deviations of the model
///
///   y = c_j + P_i + I_ij + E
///
/// with fixed cells j, P of the participants, I of the participants' own deviations in a cell, and E within a cell, by the method of
/// moments: with the means m_ij of r_ij numbers, J cells and h the mean of 1/r_ij,
///
///   σ_E² is the pooled variance within cells,
///   σ_I² = MS_I − h·σ_E²       with the mean square MS_I of m_ij without the means of participants and cells,
///   σ_P² = Var(m_i.) − MS_I/J  with the variance of the means of the participants.
///
/// A variance below 0 is reported as 0: the numbers then show no such variation. Exact in expectation where all r_ij are equal.
struct VarianceComponents {
  std::size_t participants = 0;  ///< with a number in every cell; the others are left out
  double mean = 0.0;             ///< of the means of the cells
  double participant_sd = 0.0;
  double interaction_sd = 0.0;
  double within_sd = 0.0;
};

/// Nothing for fewer than two cells, fewer than two participants with a number in every cell, and no cell of them with two numbers.
/// Cells are numbered from 0.
std::optional<VarianceComponents> variance_components(std::span<const CellNumber> numbers);

}  // namespace asperity
