// Shows the quantities of tables with the prefixes of their units.

#pragma once

#include "app/findings/study/analysis_outcome.h"

namespace asperity {

/// For display: quantities with the prefix of their unit, "12.3 µm", and without the columns of units and parameters; a
/// table of another name is unchanged.
Table with_quantities(const NamedTable& table);

}  // namespace asperity
