// What a virtual participant expects of textures, as far as it is known.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// The expectations of those of the textures that have one, in order.
std::vector<ForceFeatures> expected_of(const Expectations& expectations,
                                       const std::vector<std::string>& textures);

/// The options that stand for textures of the protocol, by index: all but "cannot tell".
std::vector<std::size_t> options_with_textures(const Protocol& protocol, const Question& question);

/// The textures of these options.
std::vector<std::string> textures_of(const Question& question,
                                     const std::vector<std::size_t>& options);

}  // namespace asperity
