// Numbers the studies of an order, and writes it as the declaration to which tables are compared.

#include "app/power/curve/power_order.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/words/text_parts.h"

namespace asperity {

void require_order(const PowerOrder& order) {
  if (order.effects.empty()) {
    throw std::invalid_argument("there is no effect; state at least one");
  }
  for (const std::string& effect : order.effects) {
    if (std::count(order.effects.begin(), order.effects.end(), effect) > 1) {
      throw std::invalid_argument("the effect " + effect + " occurs twice; state it once");
    }
  }
  if (order.participants.empty() || order.participants.front() < 1) {
    throw std::invalid_argument(
        "the numbers of participants must be at least 1, and at least one "
        "number is required");
  }
  if (std::adjacent_find(order.participants.begin(), order.participants.end(),
                         [](int one, int next) { return one >= next; }) !=
      order.participants.end()) {
    throw std::invalid_argument("the numbers of participants must ascend");
  }
  if (order.runs < 1) {
    throw std::invalid_argument("the number of runs is " + std::to_string(order.runs) +
                                "; it must be at least 1");
  }
}

std::int64_t studies_per_run(const PowerOrder& order) {
  return static_cast<std::int64_t>(order.effects.size() * order.participants.size());
}

StudyPlace place_of(const PowerOrder& order, std::int64_t index) {
  const std::int64_t of_run = studies_per_run(order);
  const auto in_run = static_cast<std::size_t>(index % of_run);
  const std::size_t sizes = order.participants.size();
  return {.run = index / of_run, .effect = in_run / sizes, .size = in_run % sizes};
}

std::string declaration_of(const PowerOrder& order) {
  nlohmann::ordered_json json{{"format", "asperity.power_studies/1"},
                              {"program", order.program},
                              {"protocol_sha256", order.protocol_sha256},
                              {"assumptions_sha256", order.assumptions_sha256},
                              {"effects", order.effects},
                              {"participants", order.participants},
                              {"seed", order.seed}};
  if (order.physics_sha256) json["physics_sha256"] = *order.physics_sha256;
  return json.dump(2) + '\n';
}

std::string differences(const std::string& declaration, const std::string& other) {
  constexpr std::array<std::pair<const char*, const char*>, 8> kNames{
      {{"format", "the format"},
       {"program", "the version of the program"},
       {"protocol_sha256", "the protocol"},
       {"assumptions_sha256", "the assumptions"},
       {"effects", "the effects"},
       {"participants", "the numbers of participants"},
       {"seed", "the seed"},
       {"physics_sha256", "the stimuli or force models of the full physics"}}};
  const auto one = nlohmann::json::parse(declaration);
  const auto two = nlohmann::json::parse(other, nullptr, false);
  if (!two.is_object()) return kNames.front().second;
  std::vector<std::string> different{};
  for (const auto& [key, name] : kNames) {
    if (one.value(key, nlohmann::json{}) != two.value(key, nlohmann::json{}))
      different.emplace_back(name);
  }
  return listed(different);
}

}  // namespace asperity
