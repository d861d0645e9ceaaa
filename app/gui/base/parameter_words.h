// Declares how windows name declared parameters, their choices and computed surfaces.

#pragma once

#include <string>

#include <QtCore/QString>

#include "stimuli/properties/parameter.h"

namespace asperity {

/// "Noise rate" for noise_rate_Hz; of a plug-in's parameter the words of its name.
QString caption_of(const Parameter& parameter);
/// The same of a choice: "Local normal" for local_normal.
QString choice_name(const Parameter& parameter, const std::string& choice);
/// With the word in files, which meanings of parameters use, where it has another name: "Wörtlich (literal)".
QString choice_with_word(const Parameter& parameter, const std::string& choice);
/// Of a kind of computed surface: "Sinusoid".
QString surface_name(const std::string& kind);

}  // namespace asperity
