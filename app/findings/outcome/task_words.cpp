// Counts the scales of each form, and lists the questions of the main blocks, each once.

#include "app/findings/outcome/task_words.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <variant>

#include "app/findings/outcome/display_number.h"
#include "app/words/text_parts.h"

namespace asperity {

std::string quoted(const std::string& text) { return "“" + text + "”"; }

namespace {

/// "with 7 points from −3 to 3"; of a scale without points "from 0 to 100".
std::string form_text(const ScaleForm& form) {
  const auto end = [](double value) {
    constexpr int kDecimals = 2;
    const bool is_whole = value == std::round(value);
    return display_signed(value, is_whole ? 0 : kDecimals);
  };
  return (form.points > 0 ? "with " + std::to_string(form.points) + " points from " : "from ") +
         end(form.minimum) + " to " + end(form.maximum);
}

std::string counted_scales(std::size_t count, const std::string& adjective) {
  return count_in_words(count) + ' ' + adjective + (count == 1 ? "scale" : "scales");
}

}  // namespace

std::string scales_of_blocks(const Protocol& protocol, std::string_view kind) {
  struct OfForm {
    const ScaleForm* form = nullptr;
    std::size_t count = 0;
  };
  std::vector<OfForm> forms{};
  std::set<std::string> names{};
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main || block.kind != kind) continue;
    for (const Protocol::TrialQuestionTemplate& asked : block.questions) {
      const auto* const form = std::get_if<ScaleForm>(&asked.form);
      if (form == nullptr || !names.insert(asked.name).second) continue;
      const auto same = std::find_if(forms.begin(), forms.end(), [form](const OfForm& one) {
        return one.form->points == form->points && one.form->minimum == form->minimum &&
               one.form->maximum == form->maximum;
      });
      ++(same == forms.end() ? *forms.insert(same, {.form = form}) : *same).count;
    }
  }
  std::vector<std::string> parts{};
  for (const OfForm& one : forms) {
    parts.push_back(counted_scales(one.count, one.form->points > 0 ? "" : "continuous ") + ' ' +
                    form_text(*one.form));
  }
  return listed(parts);
}

std::vector<std::string> main_questions(const Protocol& protocol) {
  std::vector<std::string> questions{};
  for (const auto& [name, block] : protocol.blocks) {
    if (block.phase != Phase::main) continue;
    for (const Protocol::TrialQuestionTemplate& asked : block.questions) {
      const std::string question = quoted(asked.prompt);
      if (std::find(questions.begin(), questions.end(), question) == questions.end()) {
        questions.push_back(question);
      }
    }
  }
  return questions;
}

}  // namespace asperity
