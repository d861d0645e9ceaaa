#include "app/findings/study/task_words.h"

#include <algorithm>
#include <cstddef>

namespace asperity {

std::string quoted(const std::string& text) { return "“" + text + "”"; }

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
