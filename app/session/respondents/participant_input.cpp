// Describes inputs as text for the store, and interprets buttons by their number and duration.

#include "app/session/respondents/participant_input.h"

#include "analysis/numbers/number_text.h"

namespace asperity {

namespace {

using Kind = ParticipantInput::Kind;

constexpr double kHeld_s = 0.8;

}  // namespace

std::string description_of(const ParticipantInput& input) {
  switch (input.kind) {
    case Kind::option:
      return "option " + std::to_string(input.number);
    case Kind::assign:
      return "option " + std::to_string(input.number) + " to surface " +
             std::to_string(input.surface);
    case Kind::surface:
      return "surface " + std::to_string(input.number);
    case Kind::next:
      return "next";
    case Kind::confirm:
      return "confirm";
    case Kind::mark:
      return "mark " + fixed(input.position, 3) + " on scale " + std::to_string(input.number);
    case Kind::step:
      return "step " + std::to_string(input.number);
    case Kind::select:
      return "scale " + std::string(input.number < 0 ? "before" : "after");
    case Kind::click:
      return "click";
    case Kind::text:
      return "text";
    case Kind::device_button:
      return "device button " + std::to_string(input.number);
    case Kind::released:
      return input.text;
  }
  return {};
}

std::optional<std::size_t> index_of(int number, std::size_t count) {
  if (number < 1 || static_cast<std::size_t>(number) > count) return {};
  return static_cast<std::size_t>(number - 1);
}

bool confirms_by_button(const ParticipantInput& input) {
  return input.kind == Kind::device_button && (input.number != 1 || input.held_s >= kHeld_s);
}

bool steps_by_button(const ParticipantInput& input) {
  return input.kind == Kind::device_button && !confirms_by_button(input);
}

bool continues(const ParticipantInput& input) {
  return input.kind == Kind::confirm || input.kind == Kind::device_button;
}

}  // namespace asperity
