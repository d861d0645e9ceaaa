// Declares what determines the rows of a simulation.

#pragma once

#include <string>

#include "app/tasks/simulation/simulation.h"

namespace asperity {

/// "all", "first", "none"
const char* text_of(Recordings recordings);

/// Everything that determines the rows, except the program: numbers, seed, device, and the content of the protocols, of the files of the
/// study that they name and of plug-ins. JSON. Errors: as `load_protocol` and `hash_files`.
std::string declaration_of(const SimulationInputs& inputs, const ModelRegistry& models);

}  // namespace asperity
