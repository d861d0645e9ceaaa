// What a participant does at a window or a device, and what it can mean.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace asperity {

/// One action of the participant, stamped when it happened.
struct ParticipantInput {
  enum class Kind {
    option,  ///< option `number` (its place among the choices, from 1): chosen, or given to the present surface
    /// Option `number` given to surface `surface` (both from 1), by click or drag; surface 0: taken
    /// back.
    assign,
    /// Surface `number` (from 1) requested under the hand; in an assignment without feeling again, the
    /// surface that the next option is given to.
    surface,
    next,     ///< "enough of this surface"; on the question: the next surface to feel again
    confirm,  ///< continues; confirms an answer that is complete
    click,    ///< of the mouse, on the empty ground between two surfaces
    text,     ///< the answer to a form, or a number, as text; empty where optional and left out
    /// A button of the device, `number` from 1, pressed for `held_s`.
    device_button,
    /// The key or button `text`, pressed at `time_ns`, was released `held_s` later: stored, answers
    /// nothing.
    released,
  };
  Kind kind = Kind::confirm;
  int number = 0;
  int surface = 0;
  std::string text{};
  std::int64_t time_ns = 0;  ///< on the session's clock: when it was pressed, not when it was read
  double held_s = 0.0;
  std::string source = "keyboard";  ///< "keyboard", "mouse", "device_button", "experimenter"
};

/// As it is stored: "option 2 to surface 1". The text of a response is not in it, because it may be private.
std::string description_of(const ParticipantInput& input);

/// The index of something that is counted from 1; nothing where there is no such thing.
std::optional<std::size_t> index_of(int number, std::size_t count);

/// Any button of the device but the first, and the first when it is held for 0.8 s.
bool confirms_by_button(const ParticipantInput& input);
/// The first button of the device, pressed for a shorter time.
bool steps_by_button(const ParticipantInput& input);
/// A confirmation where nothing is to be answered.
bool continues(const ParticipantInput& input);

}  // namespace asperity
