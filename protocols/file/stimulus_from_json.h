// Declares the conversion of textures, bodies and stimuli of a document that follows the schema.

#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/protocol.h"

namespace asperity {

Texture texture_of(const std::string& name, const nlohmann::json& object);
/// Without a shape if one of its sizes is missing, which the check of meaning reports.
BodyDescription body_of(const std::string& name, const nlohmann::json& object);
StimulusTemplate stimulus_of(const std::string& name, const nlohmann::json& object);

}  // namespace asperity
