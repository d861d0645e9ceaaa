// A reason or a remark as a study stores it: codes with arguments, or typed text.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json_fwd.hpp>

namespace asperity {

/// What the program worded is stored by its code, so that it can be shown in every language and reworded later
/// (app/words/coded_phrases.h has the words). `text` is the same in English, for other tools that open the file; the program
/// reads it only where there are no codes.
struct StoredWords {
  std::string text{};
  /// JSON: a string that was typed, an object `{"code", "arguments"}` whose arguments are such items again, or an object
  /// `{"english"}` of what has no code. Empty: the text of an event that is a name or data.
  std::string json{};

  StoredWords() = default;
  /// Typed text. Implicit, so that it can be stored wherever the program's own reasons can.
  StoredWords(std::string typed);  // NOLINT(google-explicit-constructor)
  StoredWords(const char* typed) : StoredWords(std::string(typed)) {}
  StoredWords(std::string english, std::string json_text)
      : text(std::move(english)), json(std::move(json_text)) {}

  bool empty() const noexcept { return text.empty(); }
  /// What `json` holds; the text where it holds no JSON.
  nlohmann::ordered_json item() const;
  bool operator==(const StoredWords&) const = default;
};

inline constexpr std::string_view kCodeKey = "code";
inline constexpr std::string_view kArgumentsKey = "arguments";
inline constexpr std::string_view kEnglishKey = "english";
/// Its arguments one after the other, with semicolons between.
inline constexpr std::string_view kListCode = "list";
/// An attempt that was invalidated so that its trial could be repeated; its argument is the reason.
inline constexpr std::string_view kTrialRepeatedCode = "trial_repeated";

/// Whether it is a code with parts.
bool is_stored_list(const nlohmann::ordered_json& item);

/// Both, one after the other; where there is no first one, the second.
StoredWords joined(const std::optional<StoredWords>& first, const StoredWords& second);
/// Why an attempt is invalid whose trial was repeated for this reason.
StoredWords set_aside_because(const StoredWords& reason);

}  // namespace asperity
