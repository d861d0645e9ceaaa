// Declares the phrase of an error.

#pragma once

#include <exception>

#include "analysis/words/phrased_error.h"

namespace asperity {

/// The phrase of a PhrasedError or a PhrasedRefusal; the message of any other error.
Phrase phrase_of(const std::exception& error);

}  // namespace asperity
