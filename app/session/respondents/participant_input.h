// Describes an action of a participant at a window or a device, and what it can mean.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace asperity {

/// One action of the participant, stamped when it happened.
struct ParticipantInput {
  enum class Kind {
    /// Option `number` (its place among the choices, from 1): chosen, or given to the current
    /// surface.
    option,
    /// Option `number` given to surface `surface` (both from 1), by click or drag; surface 0:
    /// withdrawn.
    assign,
    /// Surface `number` (from 1) requested to be felt; in an assignment without feeling again, the
    /// surface that the next option is given to.
    surface,
    next,     ///< ends feeling this surface; on the question: the next surface to feel again
    confirm,  ///< continues, or confirms an answer that is complete
    mark,     ///< `position` on scale `number` (from 1) of the page
    step,     ///< `number` steps to the right on the current scale; below 0 to the left
    select,   ///< the scale `number` places further on the page; below 0 before
    click,    ///< of the mouse, on the blank screen between two surfaces
    text,     ///< the answer to a form, or a number, as text; empty where optional and omitted
    /// A button of the device, `number` from 1, pressed for `held_s`.
    device_button,
    /// The key or button `text`, pressed at `time_ns`, was released `held_s` later: stored, without
    /// effect on the answer.
    released,
  };
  Kind kind = Kind::confirm;
  int number = 0;
  int surface = 0;
  double position = 0.0;  ///< of a mark, from 0 at the left end of the scale to 1 at the right
  std::string text{};
  std::int64_t time_ns = 0;  ///< on the session's clock: when it was pressed, not when it was read
  double held_s = 0.0;
  std::string source = "keyboard";  ///< "keyboard", "mouse", "device_button", "experimenter"
};

/// As it is stored: "option 2 to surface 1". Excludes the text of a response, which may be private.
std::string description_of(const ParticipantInput& input);

/// The index of an item counted from 1; nothing where there is no such item.
std::optional<std::size_t> index_of(int number, std::size_t count);

/// Any button of the device except the first, and the first when it is held for 0.8 s.
bool confirms_by_button(const ParticipantInput& input);
/// The first button of the device, pressed for a shorter time.
bool steps_by_button(const ParticipantInput& input);
/// A confirmation where no answer is expected.
bool continues(const ParticipantInput& input);

}  // namespace asperity
