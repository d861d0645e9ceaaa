// Lists the labelled points, and accepts a number that is a point of the scale.

#include "app/session/respondents/dialogues/scale_dialogue.h"

#include <cstddef>
#include <optional>

#include "analysis/numbers/number_text.h"
#include "app/session/respondents/form_answer.h"
#include "results_schema/tables/table.h"

namespace asperity {

std::string ScaleDialogue::introduction() const {
  std::string lines{};
  const auto add = [&lines, this](int step, const std::string& label) {
    lines += "  " + number_text(form_.value_at(step)) + (label.empty() ? "" : "  " + label) + '\n';
  };
  if (form_.labels_every_point()) {
    for (int step = 0; step <= form_.steps(); ++step) {
      add(step, form_.labels[static_cast<std::size_t>(step)]);
    }
    return lines;
  }
  add(0, form_.labels.empty() ? std::string() : form_.labels.front());
  lines += "  …\n";
  add(form_.steps(), form_.labels.empty() ? std::string() : form_.labels.back());
  return lines;
}

std::variant<NextLine, Answer> ScaleDialogue::take(const std::string& typed) {
  const std::optional<double> number = number_in(with_decimal_point(trimmed(typed)));
  const std::optional<int> step = number ? form_.step_of(*number) : std::nullopt;
  if (step) return Answer(ScalePoint{*step});
  std::string complaint = "Please enter a number from " + number_text(form_.minimum) + " to " +
                          number_text(form_.maximum);
  if (form_.points > 0) {
    complaint += ", in steps of " + number_text(form_.value_at(1) - form_.value_at(0));
  }
  return NextLine{complaint + '.'};
}

}  // namespace asperity
