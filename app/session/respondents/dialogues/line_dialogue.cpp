// Accepts a row of the sign "-", and scales the number of signs to the steps of a drawn line.

#include "app/session/respondents/dialogues/line_dialogue.h"

#include <algorithm>

#include "app/session/respondents/form_answer.h"

namespace asperity {

std::string LineDialogue::introduction() const {
  return "  " + std::string(kColumns, '-') + "  (the longest line)\n";
}

std::variant<NextLine, Answer> LineDialogue::take(const std::string& typed) {
  const std::string line = trimmed(typed);
  const bool is_line = !line.empty() && line.size() <= kColumns &&
                       std::all_of(line.begin(), line.end(), [](char sign) { return sign == '-'; });
  if (!is_line) {
    return NextLine{"Please draw a line of 1 to " + std::to_string(kColumns) + " signs \"-\"."};
  }
  return Answer(DrawnLength{static_cast<int>(line.size() * LineForm::kSteps / kColumns)});
}

}  // namespace asperity
