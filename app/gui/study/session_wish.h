// What a page asks for when somebody wants a session to be run.

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <QtCore/QMetaType>

namespace asperity {

struct SessionWish {
  std::filesystem::path protocol{};          ///< file
  std::optional<std::string> participant{};  ///< label; otherwise asked for
  bool resume = false;                       ///< the participant's unfinished session goes on
  bool simulate = false;                     ///< by virtual participants
};

}  // namespace asperity

Q_DECLARE_METATYPE(asperity::SessionWish)
