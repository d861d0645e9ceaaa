// Divides the questions of a trial into pages: all on one, or one on each.

#include "protocols/design/trial.h"

#include <algorithm>
#include <cstddef>

namespace asperity {

std::vector<std::span<const Question>> pages_of(const Trial& trial) {
  const std::span<const Question> all(trial.questions);
  if (trial.on_one_page) return {all};
  std::vector<std::span<const Question>> pages{};
  for (std::size_t i = 0; i < all.size(); ++i) pages.push_back(all.subspan(i, 1));
  return pages;
}

const Question* find_question(const Trial& trial, const std::string& name) noexcept {
  const auto found =
      std::find_if(trial.questions.begin(), trial.questions.end(),
                   [&name](const Question& question) { return question.name == name; });
  return found == trial.questions.end() ? nullptr : &*found;
}

}  // namespace asperity
