// Writes the messages as one line of JSON each, and validates every member of a reply.

#include "app/session/levels/level_messages.h"

#include <cmath>
#include <optional>
#include <variant>

#include <nlohmann/json.hpp>

#include "analysis/numbers/repeated_key.h"
#include "protocols/design/block_factors.h"

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) {
  // Typed text of a protocol is UTF-8; a faulty byte must not end the session.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

Json json_of_factors(const FactorLevels& factors) {
  Json json = Json::object();
  for (const auto& [name, level] : factors) {
    std::visit([&json, &name = name](const auto& value) { json[name] = value; }, level);
  }
  return json;
}

/// Without a judged question there are no correct responses, and no program is asked.
bool has_correct_responses(const Protocol::Block& block) {
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  return judged != nullptr && judged->judgement() == DiscriminationJudgement::performance;
}

/// A delivered level is computed from the value of the parameter, and differs from the level that was presented in the
/// last digits.
double without_rounding(const External& settings, double delivered) {
  constexpr double kRelative = 1e-9;
  const double range = settings.levels.back() - settings.levels.front();
  const std::optional<double> level = presented_level(settings, delivered);
  const bool is_level = level && std::abs(*level - delivered) <= kRelative * range;
  return is_level ? *level : delivered;
}

}  // namespace

std::string begin_line(const Protocol& protocol, const SessionRow& session,
                       const LevelRequest& request) {
  const Protocol::Block& block = protocol.blocks.at(request.block);
  const Dimension& dimension = *block.vary;
  Json begin{{"participant", session.participant},
             {"session", session.session},
             {"seed", session.seed},
             {"protocol", protocol.name},
             {"block", request.block},
             {"block_ordinal", request.block_ordinal},
             {"tracks", request.tracks},
             {"most_trials", request.settings.trials},
             {"parameter", dimension.parameter},
             {"levels_are", std::string(key_of(dimension.measure))},
             {"standard_level", dimension.level_of_standard()},
             {"levels", request.settings.levels},
             {"judgement", has_correct_responses(block) ? "performance" : "comparison"}};
  if (!dimension.unit.empty()) begin["unit"] = dimension.unit;
  begin["settings"] = Json::parse(request.settings.settings_json);
  return line_of({{"asperity", kLevelProtocol}, {"begin", std::move(begin)}});
}

std::string tell_line(const TrackAnswer& answer, const External& settings, TellKind kind) {
  Json tell{{"track", answer.of.track},
            {"step", answer.of.step},
            {"level", without_rounding(settings, answer.answer.level)},
            {"correct", answer.answer.outcome == LevelOutcome::correct}};
  if (kind == TellKind::replayed) tell["replayed"] = true;
  return line_of({{"tell", std::move(tell)}});
}

std::string ask_line(const LevelRequest& request) {
  Json ask{{"track", request.of.track}, {"step", request.of.step}};
  if (!request.factors.empty()) ask["factors"] = json_of_factors(request.factors);
  return line_of({{"ask", std::move(ask)}});
}

LevelReply reply_in(std::string_view line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object() || json.size() != 1) return NotUnderstood{};
  if (repeated_key<Json>(line)) return NotUnderstood{};
  const std::string key = json.begin().key();
  const Json& value = json.begin().value();
  if (key == "level" && value.is_number()) return StatedLevel{value.get<double>()};
  if (key == "end" && value == true) return StatedEnd{};
  if (key == "error" && value.is_string()) return StatedError{value.get<std::string>()};
  return NotUnderstood{};
}

}  // namespace asperity
