// Compares the stored detectors of perceived instability with those of the recorded hand.

#pragma once

#include <optional>
#include <string>

#include "app/records/recorded_attempt.h"

namespace asperity {

/// How closely recomputed values have to agree.
enum class Agreement {
  exact,  ///< the program and the system are those of the session
  close,  ///< within 1 %: forces agree within the tolerance of each model only
};

/// The first value of a surface that the recording does not give again: a clause with both numbers. nullopt if all
/// agree, and where none are stored. Times are not compared.
///
/// Errors: those of the force model.
std::optional<std::string> differing_instability(const RecordedAttempt& attempt,
                                                 const RecordedSurface& surface,
                                                 Agreement agreement);

}  // namespace asperity
