// `--param NAME=VALUE…`: declared parameters on the command line.

#pragma once

#include <string>
#include <vector>

#include "stimuli/properties/parameter.h"

namespace asperity {

/// Reads assignments against the parameters that there are.
///
/// Errors: WrongUsage for what is not NAME=VALUE; std::runtime_error for a name that does not exist
/// or a value that is out of range, saying what would be right. `what` names the owner, e.g.
/// "height_map".
ParameterValues parameters_from(const std::vector<std::string>& assignments,
                                const std::vector<Parameter>& declared, const std::string& what);

/// One line per parameter: name, default, unit, range, meaning.
std::string described(const std::vector<Parameter>& parameters);

}  // namespace asperity
