// Implements the phrase of an error.

#include "app/words/phrase_of_error.h"

#include "results_schema/error_text.h"

namespace asperity {

Phrase phrase_of(const std::exception& error) {
  if (const auto* phrased = dynamic_cast<const SaidInPhrase*>(&error)) return phrased->said();
  return message_of(error);
}

}  // namespace asperity
