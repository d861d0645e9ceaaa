// Implements the completion of the key "estimation".

#include "protocols/file/declared_estimation.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"

namespace asperity {

namespace {

/// "5e-05" for "0.00005" and "5.0e-5"; other texts are unchanged.
std::string with_usual_digits(const std::string& text) {
  const auto number = nlohmann::json::parse(text, nullptr, false);
  return number.is_number() ? number_text(number.get<double>()) : text;
}

/// A factor without levels if there is none with this name.
const Factor& factor_named(const Protocol& protocol, const std::string& name) {
  static const Factor kNone{};
  const auto found = protocol.factors.find(name);
  return found == protocol.factors.end() ? kNone : found->second;
}

std::optional<double> spacing_of(const Protocol& protocol, const Level& level) {
  if (const auto* const number = std::get_if<double>(&level)) return *number;
  const auto texture = protocol.textures.find(std::get<std::string>(level));
  return texture == protocol.textures.end() ? std::nullopt : texture->second.spacing_m;
}

void complete_predictor(const Factor& items, EstimationDeclaration& estimation) {
  estimation.item_levels = level_texts(items);
  const std::vector<std::string>& levels = estimation.item_levels;
  const auto stated = std::exchange(estimation.predictor_values, {});
  if (estimation.predictor == kLevelPredictor) {
    if (estimation.predictor_unit.empty()) estimation.predictor_unit = items.unit;
    for (const Level& level : items.levels) {
      const auto* const number = std::get_if<double>(&level);
      if (number != nullptr) estimation.predictor_values.emplace(text_of(level), *number);
    }
  } else if (estimation.predictor == kValuePredictor) {
    for (const auto& [key, value] : stated) {
      const bool is_level = std::find(levels.begin(), levels.end(), key) != levels.end();
      estimation.predictor_values.emplace(is_level ? key : with_usual_digits(key), value);
    }
  }
}

}  // namespace

std::vector<std::string> level_texts(const Factor& factor) {
  std::vector<std::string> texts{};
  for (const Level& level : factor.levels) texts.push_back(text_of(level));
  return texts;
}

void complete_estimation(Protocol& protocol) {
  if (!protocol.estimation) return;
  EstimationDeclaration& estimation = *protocol.estimation;
  estimation.conditions = level_texts(factor_named(protocol, estimation.condition));
  for (const Level& level : factor_named(protocol, estimation.spacing).levels) {
    const std::optional<double> spacing_m = spacing_of(protocol, level);
    if (spacing_m) estimation.spacing_m.emplace(text_of(level), *spacing_m);
  }
  complete_predictor(factor_named(protocol, estimation.items), estimation);
}

}  // namespace asperity
