// Implements the check of the positions of two surfaces in a trial.

#include "protocols/kinds/positions.h"

#include "protocols/design/wording.h"

namespace asperity {

void check_positions(const BlockOfKind& checked, ProblemSink& problems) {
  if (checked.block.phase != Phase::main ||
      checked.block.positions != Protocol::Block::Positions::as_listed) {
    return;
  }
  problems.report(
      checked.pointer + "/presented",
      phrase("Protocols",
             "the same surface would always be presented first, so that an order effect could "
             "not be distinguished from a difference; set %1 to %2 or %3")
          .with(key_name("positions"), word_name("balanced"), word_name("shuffle")));
}

}  // namespace asperity
