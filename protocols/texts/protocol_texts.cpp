// Finds the texts of a protocol by the shapes of their keys, and replaces their placeholders.

#include "protocols/texts/protocol_texts.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "protocols/design/json_pointer.h"
#include "protocols/texts/translatable_texts.h"

namespace asperity {

namespace {

/// The block in whose object the pointer is.
const Protocol::Block* block_of(const std::string& pointer, const Protocol& protocol) {
  constexpr std::string_view kBlocks = "/blocks/";
  if (!pointer.starts_with(kBlocks)) return nullptr;
  const std::size_t end = pointer.find('/', kBlocks.size());
  const auto found = protocol.blocks.find(pointer.substr(kBlocks.size(), end - kBlocks.size()));
  return found == protocol.blocks.end() ? nullptr : &found->second;
}

std::vector<std::string> groups_of_screen(const std::string& pointer, const Protocol& protocol) {
  for (std::size_t i = 0; i < protocol.flow.size(); ++i) {
    const auto* const screen = std::get_if<Protocol::Screen>(&protocol.flow[i]);
    if (screen != nullptr && pointer == pointer_to("/flow", i) + "/screen") return screen->groups;
  }
  return {};
}

constexpr std::string_view kConsent = "/consent/";

bool has_brace(const TextPlace& place) { return place.text.find('{') != std::string::npos; }

}  // namespace

std::vector<TextPlace> participant_texts(const nlohmann::json& root, const Protocol& protocol) {
  std::vector<TextPlace> places{};
  for (TranslatableText& each : translatable_texts(root)) {
    if (each.shape.translated != Translated::always || each.shape.is_value) continue;
    const bool is_of_session = each.pointer.starts_with("/flow/") ||
                               each.pointer.starts_with("/resume/") ||
                               each.pointer.starts_with(kConsent);
    const Protocol::Block* const block = block_of(each.pointer, protocol);
    std::vector<std::string> groups = groups_of_screen(each.pointer, protocol);
    places.push_back(
        {std::move(each.pointer), std::move(each.text), is_of_session, block, std::move(groups)});
  }
  return places;
}

DesignValues values_of_design(const Protocol& protocol, const TextPlace& place) {
  return place.block == nullptr ? values_of_all_blocks(protocol)
                                : values_of_block(protocol, *place.block);
}

std::optional<nlohmann::json> with_design_values(const nlohmann::json& root,
                                                 const Protocol& protocol) {
  std::optional<nlohmann::json> changed{};
  for (const TextPlace& place : participant_texts(root, protocol)) {
    if (place.is_of_session || !has_brace(place)) continue;
    if (!changed) changed = root;
    changed->at(nlohmann::json::json_pointer(place.pointer)) =
        with_values(place.text, values_of_design(protocol, place), protocol.language);
  }
  return changed;
}

PlanStep as_read(PlanStep step, const DesignValues& of_session, std::string_view language) {
  const auto read = [&](std::string& text) { text = with_values(text, of_session, language); };
  if (auto* const screen = std::get_if<Protocol::Screen>(&step)) read(screen->text);
  if (auto* const pause = std::get_if<Protocol::Break>(&step)) {
    read(pause->text);
    if (pause->drift_check) {
      read(pause->drift_check->text);
      read(pause->drift_check->tip_text);
    }
  }
  return step;
}

Plan as_read(const Protocol& protocol, Plan plan) {
  const DesignValues values = values_of_session(protocol, plan);
  for (PlanStep& step : plan.steps) step = as_read(std::move(step), values, protocol.language);
  return plan;
}

std::string consent_as_read(const Protocol& protocol) {
  const std::string& text = protocol.consent_statement;
  return with_values(text,
                     states_session({{.text = text}}) ? values_of_every_session(protocol)
                                                      : values_of_all_blocks(protocol),
                     protocol.language);
}

std::vector<TextPlace> texts_with_placeholders(const Protocol& protocol) {
  if (protocol.source.empty()) return {};
  std::vector<TextPlace> places =
      participant_texts(nlohmann::json::parse(protocol.source), protocol);
  std::erase_if(places, [](const TextPlace& each) {
    return placeholders_in(each.text).empty() || each.pointer.starts_with(kConsent);
  });
  return places;
}

bool states_session(const std::vector<TextPlace>& places) {
  return std::any_of(places.begin(), places.end(), [](const TextPlace& place) {
    const std::vector<Placeholder> found = placeholders_in(place.text);
    return std::any_of(found.begin(), found.end(), [](const Placeholder& each) {
      const DesignNumber* const number = find_design_number(each.name);
      return number != nullptr && number->scope == NumberScope::session;
    });
  });
}

std::vector<TextAsRead> texts_as_read(const Protocol& protocol,
                                      const std::vector<TextPlace>& places,
                                      const DesignValues& of_session) {
  std::vector<TextAsRead> texts{};
  for (const TextPlace& place : places) {
    const DesignValues values =
        place.is_of_session ? of_session : values_of_design(protocol, place);
    texts.push_back({place.pointer, with_values(place.text, values, protocol.language)});
  }
  return texts;
}

}  // namespace asperity
