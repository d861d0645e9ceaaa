// Compares the rate of the servo loop with the rates at which the force models of a protocol keep their periods.

#pragma once

#include <string>
#include <vector>

#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/file/diagnostic.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// A warning for every force model whose tick can take longer than a period at the protocol's rate
/// (ModelDeclaration::maximum_rate_Hz): late ticks are missed deadlines and can invalidate attempts. At `device.rate_Hz`, where it
/// has to be corrected. No file is needed.
std::vector<Diagnostic> warnings_about_rate(const CheckedProtocol& checked,
                                            const ModelRegistry& models);

}  // namespace asperity
