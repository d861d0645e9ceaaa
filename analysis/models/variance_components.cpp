// Equates mean squares with their expectations, over the participants with a number in every cell.

#include "analysis/models/variance_components.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace asperity {

namespace {

struct CellSum {
  double sum = 0.0;
  double squares = 0.0;  ///< about the mean, once it is known
  double count = 0.0;

  double mean() const { return sum / count; }
};

/// By participant, in the order of the cells: of the participants with a number in every cell.
std::vector<std::vector<CellSum>> complete_cells(std::span<const CellNumber> numbers,
                                                 std::size_t cells) {
  std::map<std::size_t, std::vector<CellSum>> by_participant{};
  for (const CellNumber& number : numbers) {
    std::vector<CellSum>& own = by_participant[number.participant];
    own.resize(cells);
    own[number.cell].sum += number.value;
    ++own[number.cell].count;
  }
  for (const CellNumber& number : numbers) {
    CellSum& cell = by_participant[number.participant][number.cell];
    cell.squares += (number.value - cell.mean()) * (number.value - cell.mean());
  }
  std::vector<std::vector<CellSum>> complete{};
  for (auto& [participant, own] : by_participant) {
    const bool has_all =
        std::all_of(own.begin(), own.end(), [](const CellSum& cell) { return cell.count > 0.0; });
    if (has_all) complete.push_back(std::move(own));
  }
  return complete;
}

double mean_of_cells(const std::vector<CellSum>& own) {
  double sum = 0.0;
  for (const CellSum& cell : own) sum += cell.mean();
  return sum / static_cast<double>(own.size());
}

double root(double variance) { return std::sqrt(std::max(variance, 0.0)); }

}  // namespace

std::optional<VarianceComponents> variance_components(std::span<const CellNumber> numbers) {
  std::size_t cells = 0;
  for (const CellNumber& number : numbers) cells = std::max(cells, number.cell + 1);
  const std::vector<std::vector<CellSum>> all = complete_cells(numbers, cells);
  if (cells < 2 || all.size() < 2) return std::nullopt;
  const auto participants = static_cast<double>(all.size());
  const auto count = static_cast<double>(cells);
  double squares = 0.0;
  double degrees = 0.0;
  double inverse = 0.0;
  double mean = 0.0;
  std::vector<double> means_of_cells(cells, 0.0);
  for (const std::vector<CellSum>& own : all) {
    mean += mean_of_cells(own) / participants;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      squares += own[cell].squares;
      degrees += own[cell].count - 1.0;
      inverse += 1.0 / (own[cell].count * participants * count);
      means_of_cells[cell] += own[cell].mean() / participants;
    }
  }
  if (degrees <= 0.0) return std::nullopt;
  double of_participants = 0.0;
  double of_interaction = 0.0;
  for (const std::vector<CellSum>& own : all) {
    const double own_mean = mean_of_cells(own);
    of_participants += (own_mean - mean) * (own_mean - mean) / (participants - 1.0);
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const double deviation = own[cell].mean() - own_mean - means_of_cells[cell] + mean;
      of_interaction += deviation * deviation / ((participants - 1.0) * (count - 1.0));
    }
  }
  const double within = squares / degrees;
  return VarianceComponents{.participants = all.size(),
                            .mean = mean,
                            .participant_sd = root(of_participants - of_interaction / count),
                            .interaction_sd = root(of_interaction - inverse * within),
                            .within_sd = std::sqrt(within)};
}

}  // namespace asperity
