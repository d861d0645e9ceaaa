#include "app/report/text/report_languages.h"

#include <algorithm>

#include "protocols/file/stored_protocol.h"

namespace asperity {

namespace {

bool has_scales_with_words(const Protocol& protocol) {
  const auto has_words = [](const Question& question) {
    const auto* const scale = std::get_if<ScaleForm>(&question.form);
    return scale != nullptr && !scale->labels.empty();
  };
  const auto is_in_block = [&](const auto& named) {
    const auto& questions = named.second.questions;
    return std::any_of(questions.begin(), questions.end(), has_words);
  };
  const auto is_question = [&](const auto& named) { return has_words(named.second); };
  return std::any_of(protocol.blocks.begin(), protocol.blocks.end(), is_in_block) ||
         std::any_of(protocol.questions.begin(), protocol.questions.end(), is_question);
}

}  // namespace

std::string languages_text(const ReportFacts& facts) {
  if (facts.languages.size() < 2) return {};
  std::string text{};
  for (const auto& [language, participants] : facts.languages) {
    text +=
        (text.empty() ? "" : ", ") + std::to_string(participants.size()) + " (" + language + ')';
  }
  text = " Participants by language: " + text + '.';
  if (has_scales_with_words(stored_protocol(facts.protocol.source).protocol)) {
    text +=
        " The scales have labels in words; whether they are equivalent in these languages was not "
        "tested.";
  }
  return text;
}

}  // namespace asperity
