// Texts of the program, made without Qt, that windows can show in another language.

#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

/// English words with placeholders %1 … %9 for the variable parts.
///
/// The terminal receives `english()`; a window translates the words before the placeholders are
/// filled (app/gui/look/words.h), including those of every argument. The words are in the source
/// once, in `phrase("Context", "Words")`, from which scripts/translations extracts them: both have
/// to be literals there, with nothing after the second. A context can also state what its words are
/// (a key, a number in the unit of a file), which a window then shows in its own way.
class Phrase final {
 public:
  Phrase() = default;
  /// A text that is the same in every language: a label, a number, the message of a library.
  /// Implicit, so that it can be used in place of a phrase.
  Phrase(std::string words) : words_(std::move(words)) {}
  Phrase(const char* words) : words_(words) {}
  /// See `phrase`.
  Phrase(const char* context, const char* words) : context_(context), words_(words) {}

  /// The same with the first argument in place of %1, the second in place of %2, …
  template <std::convertible_to<Phrase>... Arguments>
  Phrase with(const Arguments&... arguments) const {
    return filled({Phrase(arguments)...});
  }
  Phrase filled(std::vector<Phrase> arguments) const;
  /// As a complete sentence: with a full stop if it has none, and with a capital letter, unless it
  /// begins with an argument that is the same in every language: that may be a name, which is
  /// unchanged.
  Phrase as_sentence() const;

  /// The same with the code under which it is stored (app/words/coded_phrases.h), a literal.
  Phrase coded(const char* code) const;
  /// Null where it has none.
  const char* code() const noexcept { return code_; }
  const std::vector<Phrase>& arguments() const noexcept { return arguments_; }
  /// The same in every language: without a translation or arguments.
  bool is_verbatim() const noexcept { return context_ == nullptr && arguments_.empty(); }

  bool empty() const noexcept { return words_.empty(); }
  /// Whether it has words to translate; its arguments may have some too.
  bool can_be_translated() const noexcept { return context_ != nullptr; }
  std::string english() const;
  bool operator==(const Phrase& other) const { return english() == other.english(); }
  /// Returns the translation of `words` of `context`, UTF-8, or `words`. Without a context (null)
  /// it is an argument that is the same in every language, except for the decimal point of a
  /// number.
  using LookUp = std::function<std::string(const char* context, const char* words)>;
  std::string translated(const LookUp& look_up) const;

 private:
  bool begins_with_a_name(const LookUp& look_up) const;

  const char* context_ = nullptr;  // a literal; null: not translated
  const char* code_ = nullptr;     // a literal; null: not stored by a code
  std::string words_{};
  std::vector<Phrase> arguments_{};
  bool is_sentence_ = false;
};

/// Words that are translated. `context` groups them for translators.
inline Phrase phrase(const char* context, const char* words) { return {context, words}; }

}  // namespace asperity
