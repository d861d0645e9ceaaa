// A device that somebody wants to test, as the list of devices knows it.

#pragma once

#include <string>

#include <QtCore/QString>

#include "app/profiles/device_profile.h"

namespace asperity {

struct TestedDevice {
  std::string device{};       ///< as DriverRegistry::open takes it
  std::string handle{};       ///< its model and serial number, for a sentence on what will move
  QString name{};             ///< for a title
  WhichDevice which{};        ///< whose profiles are its own
  std::string remark{};       ///< a sentence of its driver that people should know, or empty
  bool is_simulated = false;  ///< nothing moves, and nobody has to be asked
  bool has_motors = true;     ///< otherwise nothing moves by itself, and there is no force
};

}  // namespace asperity
