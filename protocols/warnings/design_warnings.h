// Declares warnings about valid designs whose trials cannot show what they seem to.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// A warning for every
/// - crossed factor with several levels that nothing else in the protocol names, so that its levels repeat the same trials
///   (except `column`, which numbers repetitions);
/// - procedure of which the prior of the threshold and the differences of the levels have no value in common;
/// - block in which a participant is given one of so many parts of the pairs that these need not connect all levels;
/// - main block of a choice between surfaces with constant stimuli whose positions need not be balanced within each level
///   (balances_every_row);
/// - group of equal listed trials of a block in random order, unless the block states its number of repetitions;
/// - scale with another question, other labels or other points than the scale of the same name in another block, whose
///   responses are stored under the same name.
///
/// `file_name` is the file in the diagnostics.
std::vector<Diagnostic> warnings_about_design(const Protocol& protocol,
                                              const std::string& file_name);

}  // namespace asperity
