// What somebody has filled in on the page before a session.

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/records/participant_answers.h"
#include "app/session/levels/external_program.h"
#include "app/session/sound/sound.h"

namespace asperity {

/// Pages are made anew with the theme and the language; the new one goes on with this. What the
/// settings remember is not among it.
struct StartDraft {
  struct Person {
    bool is_new = true;
    std::string label{};           ///< empty: as suggested
    ParticipantAnswers answers{};  ///< of somebody new
    std::optional<std::string> group{};  ///< where the experimenter assigns it
  };

  Person person{};
  std::optional<std::int64_t> session{};  ///< that goes on
  int virtual_people = 1;
  bool as_fast_as_possible = true;
  bool has_consented = false;
  std::string consent_seen_by{};
  std::optional<bool> left_hand{};      ///< where somebody has chosen it
  std::optional<ExternalProgram> level_program{};
  std::optional<MaskingNoise> noise{};  ///< where the protocol asks for one
};

}  // namespace asperity
