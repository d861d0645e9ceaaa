// The levels that a program outside of Asperity chooses.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "protocols/procedures/level_answer.h"

namespace asperity {

struct Procedure;

/// The levels that a laboratory's own program states, one before each trial (docs/formats/external.md).
///
/// The levels are not a function of the responses: a program may draw random numbers or depend on its version. They are
/// therefore stored as the program states them, and a session is resumed and verified with the stored ones. A protocol
/// never names the program.
///
/// `Procedure::rule` gives an example of levels (every level equally often, in random order), for estimates and examples
/// of a session before it begins; no session presents them.
struct External {
  std::vector<double> levels{};      ///< ascending; `levels_of` a grid, or a list
  std::size_t trials = 0;            ///< no track has more; the program may end it before
  std::string settings_json = "{}";  ///< passed on to the program; not interpreted
  double answer_within_s = 30.0;     ///< a program that has not answered by then has failed

  bool operator==(const External&) const = default;
};

/// The level that is presented where the program states this number: the nearest level of the block, the lower of two.
/// Nothing if the number lies outside of their range; rounding errors of a billionth of the range are ignored.
std::optional<double> presented_level(const External& method, double stated);

const Procedure& external();

}  // namespace asperity
