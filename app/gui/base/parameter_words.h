// Declares how windows name declared parameters, their choices and computed surfaces.

#pragma once

#include <string>

#include <QtCore/QString>

#include "stimuli/properties/parameter.h"

namespace asperity {

/// "Noise rate" for noise_rate_Hz. A parameter that only a plug-in has is named by the words of its name.
QString caption_of(const Parameter& parameter);
/// The same of a choice: "Local normal" for local_normal.
QString choice_name(const Parameter& parameter, const std::string& choice);
/// With the word of the file, which the meanings of parameters use, where windows name the choice in another way: "Wörtlich
/// (literal)".
QString choice_with_word(const Parameter& parameter, const std::string& choice);
/// Of a kind of computed surface: "Sinusoid".
QString surface_name(const std::string& kind);

}  // namespace asperity
