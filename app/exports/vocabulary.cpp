#include "app/exports/vocabulary.h"

#include <algorithm>
#include <variant>

#include <nlohmann/json.hpp>

namespace asperity {

namespace {

std::string text(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<double> number(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

nlohmann::json member(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_object() ? *found : nlohmann::json::object();
}

std::string place_in(const ProtocolRow& protocol, const std::string& pointer) {
  return "protocol " + protocol.name + " " + protocol.version + ": " + pointer;
}

void learn_questions(const ProtocolRow& protocol, const nlohmann::json& source,
                     StudyVocabulary& vocabulary) {
  const nlohmann::json questions = member(source, "questions");
  for (const auto& [name, declaration] : questions.items()) {
    if (!declaration.is_object()) continue;
    StudyVocabulary::AnswerMeaning meaning{};
    meaning.prompt = text(declaration, "prompt");
    meaning.free_text = text(declaration, "form") == "text";
    meaning.minimum = number(declaration, "minimum");
    meaning.maximum = number(declaration, "maximum");
    meaning.source = place_in(protocol, "/questions/" + name);
    for (const nlohmann::json& option : declaration.value("options", nlohmann::json::array())) {
      if (option.is_string()) meaning.options.push_back(option.get<std::string>());
    }
    vocabulary.questions_of_source[{protocol.source_sha256, name}] = meaning;
    const bool free_text = meaning.free_text;
    const auto [question, is_new] = vocabulary.questions.insert({name, std::move(meaning)});
    question->second.questionnaire = true;  // also where a trial of another protocol asks the same
    if (!is_new && free_text) question->second.free_text = true;
  }
  const nlohmann::json blocks = member(source, "blocks");
  for (const auto& [name, block] : blocks.items()) {
    if (!block.is_object()) continue;
    const nlohmann::json asked = member(block, "question");
    const std::string called = text(asked, "name");
    if (called.empty()) continue;
    StudyVocabulary::AnswerMeaning meaning{};
    meaning.prompt = text(asked, "prompt");
    meaning.free_text = false;
    meaning.questionnaire = false;
    meaning.source = place_in(protocol, "/blocks/" + name + "/question");
    vocabulary.questions.insert({called, std::move(meaning)});
  }
}

void learn_from_protocol(const ProtocolRow& protocol, StudyVocabulary& vocabulary) {
  const nlohmann::json source = nlohmann::json::parse(protocol.source, nullptr, false);
  if (!source.is_object()) return;
  const nlohmann::json factors = member(source, "factors");
  for (const auto& [name, declaration] : factors.items()) {
    const auto factor = vocabulary.factors.find(name);
    if (factor == vocabulary.factors.end() || !declaration.is_object()) continue;
    factor->second.meaning = text(declaration, "meaning");
    factor->second.unit = text(declaration, "unit");
    factor->second.source = place_in(protocol, "/factors/" + name);
  }
  learn_questions(protocol, source, vocabulary);
  if (std::optional<EstimationDeclaration> estimation = declared_estimation(protocol.source)) {
    vocabulary.estimations.insert({protocol.source_sha256, *std::move(estimation)});
  }
}

void learn_factors(const nlohmann::json& factors, StudyVocabulary& vocabulary) {
  for (const auto& [name, level] : factors.items()) {
    StudyVocabulary::FactorMeaning& factor = vocabulary.factors[name];
    if (!level.is_number()) factor.numeric = false;
    std::string word = level.is_string() ? level.get<std::string>() : level.dump();
    if (level.is_number_float()) word = text_of_number(level.get<double>());
    if (std::find(factor.levels.begin(), factor.levels.end(), word) == factor.levels.end()) {
      factor.levels.push_back(std::move(word));
    }
  }
}

void sort_levels(StudyVocabulary::FactorMeaning& factor) {
  std::sort(factor.levels.begin(), factor.levels.end(),
            [&factor](const std::string& a, const std::string& b) {
              if (!factor.numeric) return a < b;
              return number_in(a).value_or(0.0) < number_in(b).value_or(0.0);
            });
}

void learn_declaration(const std::string& model, const Parameter& parameter,
                       StudyVocabulary& vocabulary) {
  const auto found = vocabulary.parameters.find(parameter.name);
  if (found == vocabulary.parameters.end() || !found->second.models.contains(model)) return;
  StudyVocabulary::ParameterMeaning& meaning = found->second;
  meaning.meanings.insert(parameter.meaning);
  if (parameter.kind == ParameterKind::choice) {
    meaning.levels.insert(parameter.choices.begin(), parameter.choices.end());
    return;
  }
  meaning.unit = parameter.unit;
  meaning.minimum = std::min(meaning.minimum.value_or(parameter.minimum), parameter.minimum);
  meaning.maximum = std::max(meaning.maximum.value_or(parameter.maximum), parameter.maximum);
}

}  // namespace

StudyVocabulary vocabulary_of(const Study& study, const ModelRegistry& models) {
  StudyVocabulary vocabulary{};
  const StudyWords words = study.words();
  for (const std::string& factors : words.factors_json) {
    learn_factors(nlohmann::json::parse(factors), vocabulary);
  }
  for (auto& [name, factor] : vocabulary.factors) sort_levels(factor);
  for (const auto& [model, parameters_json] : words.parameters) {
    const nlohmann::json parameters = nlohmann::json::parse(parameters_json);
    for (const auto& [name, value] : parameters.items()) {
      StudyVocabulary::ParameterMeaning& parameter = vocabulary.parameters[name];
      parameter.models.insert(model);
      if (value.is_string()) parameter.levels.insert(value.get<std::string>());
    }
  }
  for (const ForceModel& model : models.models()) {
    for (const Parameter& parameter : model.declaration.parameters) {
      learn_declaration(model.declaration.id, parameter, vocabulary);
    }
  }
  for (const auto& [kind, model] : words.model_limits) vocabulary.limits[kind].insert(model);
  for (const ParticipantRow& participant : study.participants()) {
    const nlohmann::json answers = nlohmann::json::parse(participant.answers_json);
    for (const auto& [name, value] : answers.items()) vocabulary.participant_answers.insert(name);
  }
  for (const ProtocolRow& protocol : study.protocols()) learn_from_protocol(protocol, vocabulary);
  return vocabulary;
}

}  // namespace asperity
