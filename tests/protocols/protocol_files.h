// Protocol files that tests change, and what the reader reports of them.

#pragma once

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_problems.h"
#include "protocols/file/translation.h"
#include "protocols/plan/course.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "tests/protocols/example.h"
#include "tests/protocols/untranslated.h"
#include "tests/support/replaced.h"

namespace asperity::test {

inline std::string library_text(std::string_view name) {
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name == name) return std::string(each.text);
  }
  throw std::invalid_argument("no such library protocol");
}

/// In another language; the translation is complete.
inline std::string library_text(std::string_view name, std::string_view language) {
  for (const LibraryProtocol& each : library_protocols()) {
    for (const LibraryTranslation& one : each.translations) {
      if (each.name != name || one.language != language) continue;
      const std::string file = std::string(name) + '.' + std::string(language) + ".json";
      TranslatedProtocol made =
          translated(each.text, std::string(name), {one.text, file, std::string(language)});
      append(made.problems, made.warnings);
      for (const Diagnostic& problem : made.problems) ADD_FAILURE() << text_of(problem);
      return made.text;
    }
  }
  throw std::invalid_argument("no such library protocol in this language");
}

inline nlohmann::json library_file(std::string_view name) {
  return nlohmann::json::parse(library_text(name));
}

inline nlohmann::json without_practice(nlohmann::json file) {
  file["blocks"].erase("practice");
  file.erase("resume");
  nlohmann::json& flow = file["flow"];
  flow.erase(std::remove_if(flow.begin(), flow.end(),
                            [](const nlohmann::json& step) {
                              return step.value("run", std::string()) == "practice";
                            }),
             flow.end());
  return file;
}

inline std::vector<ModelDeclaration> models_of_library() {
  return declarations_of(built_in_models());
}

inline ProtocolReading reading_of(const nlohmann::json& file,
                                  const std::vector<ModelDeclaration>& models = example_models()) {
  ProtocolReading reading = read_protocol_with_problems(file.dump(1), "file.json", models);
  for (const Diagnostic& problem : reading.problems) {
    EXPECT_GT(problem.line, problem.pointer.empty() ? 0 : 1) << text_of(problem);
  }
  expect_translatable(reading.problems);
  return reading;
}

/// The protocol of a file that has no problem.
inline Protocol valid(const nlohmann::json& file,
                      const std::vector<ModelDeclaration>& models = example_models()) {
  ProtocolReading reading = reading_of(file, models);
  for (const Diagnostic& problem : reading.problems) ADD_FAILURE() << text_of(problem);
  return reading.protocol.value_or(Protocol{});
}

/// The messages at a JSON pointer, one per line.
inline std::string problems_at(const nlohmann::json& file, const std::string& pointer,
                               const std::vector<ModelDeclaration>& models = example_models()) {
  std::string messages{};
  for (const Diagnostic& problem : reading_of(file, models).problems) {
    if (problem.pointer != pointer) continue;
    messages += (messages.empty() ? "" : "\n") + problem.message.english();
  }
  return messages;
}

/// "POINTER: MESSAGE" of every problem.
inline std::vector<std::string> problems_in(const nlohmann::json& file) {
  std::vector<std::string> problems{};
  for (const Diagnostic& problem : reading_of(file).problems) {
    problems.push_back(problem.pointer + ": " + problem.message.english());
  }
  return problems;
}

/// A planned trial without what is read of it.
inline nlohmann::json without_wording(nlohmann::json trial) {
  static const std::set<std::string> kTexts{"screen", "text", "prompt"};
  if (trial.is_array()) {
    for (nlohmann::json& one : trial) one = without_wording(one);
  }
  if (!trial.is_object()) return trial;
  nlohmann::json kept = nlohmann::json::object();
  for (const auto& [key, value] : trial.items()) {
    if (!kTexts.contains(key)) kept[key] = without_wording(value);
  }
  return kept;
}

inline std::vector<Trial> main_trials(const Protocol& protocol) {
  std::vector<Trial> trials{};
  for (const Trial& trial : example_plan(protocol, {1, 0}).trials) {
    if (trial.phase == Phase::main) trials.push_back(trial);
  }
  return trials;
}

}  // namespace asperity::test
