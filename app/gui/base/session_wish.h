// What a page asks for when somebody wants a session to be run.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <QtCore/QMetaType>

#include "app/tasks/simulation/simulation.h"

namespace asperity {

struct SessionWish {
  std::filesystem::path protocol{};          ///< file
  std::optional<std::string> participant{};  ///< label; otherwise asked for
  /// The participant's unfinished session that goes on, by its id in the store.
  std::optional<std::int64_t> session{};
  bool simulate = false;  ///< by virtual participants
  bool by_mouse = false;  ///< two trials with the mouse, of which nothing is stored
  std::string group{};  ///< of the participant of these trials; empty: the first, if there are any
  /// Several of them, at once and in the background; the rest is not used then.
  std::optional<SimulationInputs> simulation{};
};

}  // namespace asperity

Q_DECLARE_METATYPE(asperity::SessionWish)
