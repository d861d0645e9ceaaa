// Declares the rows of the page of the format (docs/formats/protocol.md) that state a table.

#pragma once

#include <string>

#include "protocols/shapes/key.h"

namespace asperity {

/// One row of Markdown per key: "| `rate_Hz` | number ≥ 100, ≤ 10000 | `1000` | Rate of the servo loop. |", each with a
/// line break.
std::string page_rows_of(const KeyTable& table);

}  // namespace asperity
