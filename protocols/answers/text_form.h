// A text in the participant's words.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

struct AnsweredItem;
struct Question;

/// The answer is a text.
struct TextForm {
  static constexpr std::string_view kName = "text";
  static constexpr bool kIsSeen = true;  ///< see is_seen
  bool operator==(const TextForm&) const = default;
};

struct WrittenText {
  std::string text{};
};

std::vector<AnsweredItem> items_of(const Question& question, const TextForm&,
                                   const WrittenText& answer);

}  // namespace asperity
