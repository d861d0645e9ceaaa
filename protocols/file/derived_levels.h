// Declares the factors whose levels a block computes.

#pragma once

#include <set>
#include <string>

#include "protocols/design/protocol.h"

namespace asperity {

/// Adds the factors of `derived` with the levels that the rows of the block have, as if the file had declared them.
/// Factors that are in `of_file` remain unchanged, which the check of meaning reports. Adds nothing where the rows cannot
/// be made.
void declare_derived(const Protocol::Block& block, Protocol& protocol,
                     const std::set<std::string>& of_file);

}  // namespace asperity
