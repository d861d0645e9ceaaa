// Compares the place where a protocol has contacts evaluated with the devices of this computer.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// Warnings for a protocol that computes on a GPU, if this computer has no OpenCL device or the first one is a processor. Not
/// errors: the session may run on another computer. Opens the OpenCL drivers, which can take seconds.
std::vector<Diagnostic> warnings_about_compute(const Protocol& protocol,
                                               const std::string& file_name);

}  // namespace asperity
