// Variance components of the responses to one question, in cells that the caller defines.

#include "app/findings/outcome/shown_parameters.h"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace asperity {

namespace {

/// The responses to the question as numbers, in cells.
std::vector<CellNumber> cell_numbers(
    const GatheredAnswers& gathered, const TabulatedQuestion& asked,
    const std::function<FindingKey(const GatheredAnswer&)>& cell_of,
    const std::function<std::optional<double>(double)>& value_of) {
  std::map<FindingKey, std::size_t> cells{};
  std::vector<CellNumber> numbers{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const bool is_asked = gathered.word(answer.block) == asked.block.name &&
                          gathered.word(answer.question) == asked.question.name;
    const std::optional<double> number = gathered.reply_of(answer).number;
    if (!is_asked || !number || answer.surface_count == 0) continue;
    const std::optional<double> value = value_of(*number);
    if (!value) continue;
    const std::size_t cell = cells.try_emplace(cell_of(answer), cells.size()).first->second;
    numbers.push_back({.participant = answer.person, .cell = cell, .value = *value});
  }
  return numbers;
}

}  // namespace

std::optional<VarianceComponents> add_shown_components(
    const GatheredAnswers& gathered, const TabulatedQuestion& asked,
    const std::function<FindingKey(const GatheredAnswer&)>& cell_of,
    const std::function<std::optional<double>(double)>& value_of, ShownParameters& shown) {
  const auto components = variance_components(cell_numbers(gathered, asked, cell_of, value_of));
  if (!components) return std::nullopt;
  shown["level"] = components->mean;
  shown["level_sd"] = components->participant_sd;
  shown["noise_sd"] = components->within_sd;
  return *components;
}

}  // namespace asperity
