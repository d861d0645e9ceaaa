// Converts the parameters of a stimulus to JSON text, and back.

#pragma once

#include <string>

#include "stimuli/properties/parameter.h"

namespace asperity {

std::string json_text_of(const ParameterValue& value);
/// One object, names in order; the same values give the same text.
std::string json_text_of(const ParameterValues& values);

/// Reads what `json_text_of` writes.
ParameterValues parameter_values_in(const std::string& json);

}  // namespace asperity
