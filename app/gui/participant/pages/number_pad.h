// The pad on which a number is typed, and what was typed.

#pragma once

#include <optional>

#include <QtCore/QString>

#include "app/gui/participant/pages/participant_item.h"

namespace asperity {

class PageFrame;

/// Whether a number may be below 0.
enum class NumberSign { none, minus };

struct NumberTexts {
  QString range{};      ///< what may be typed; may be empty
  QString unit{};       ///< shown after the number; may be empty
  QString no_number{};  ///< in its place while what was typed is no number
};
/// The question of the scene, what was typed, and the keys that type it.
void lay_out_number(PageFrame& frame, const NumberTexts& texts, NumberSign sign);

std::optional<ParticipantAction> key_of_number(int key, const QString& typed, NumberSign sign);
/// Into what was typed so far: What::write or What::erase.
void write_number(const ParticipantAction& action, NumberSign sign, QString& number);
/// Whatever is typed after it: "1/2", "1.2.3", and more signs than a number has. "1e" is none yet.
bool is_no_number(const QString& typed, NumberSign sign);

}  // namespace asperity
