// What a protocol states for a selection, or for a paired comparison of realism.

#pragma once

namespace asperity {

/// The reference for "realistic" in a selection.
enum class RealismStandard {
  photograph,       ///< the texture's picture is shown
  physical_sample,  ///< the experimenter places the coded sample that the prompt names
  memory,           ///< the participant's own idea of the material
};

}  // namespace asperity
