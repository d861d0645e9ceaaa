// Declares errors that windows can show in another language.

#pragma once

#include <stdexcept>

#include "analysis/words/phrase.h"

namespace asperity {

/// What the errors with a phrase have in common, whatever their type; see phrase_of.
class SaidInPhrase {
 public:
  const Phrase& said() const noexcept { return said_; }

 protected:
  explicit SaidInPhrase(const Phrase& said) : said_(said) {}
  ~SaidInPhrase() = default;

 private:
  Phrase said_;
};

/// An error that can be shown in another language; `what()` is the English.
template <class Error>
class Phrased : public Error, public SaidInPhrase {
 public:
  explicit Phrased(const Phrase& said) : Error(said.english()), SaidInPhrase(said) {}
};
using PhrasedError = Phrased<std::runtime_error>;
/// Of an argument, a value or a file that cannot be used.
using PhrasedRefusal = Phrased<std::invalid_argument>;

}  // namespace asperity
