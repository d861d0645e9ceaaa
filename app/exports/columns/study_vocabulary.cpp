// Reads the protocols of all sessions and the declarations of force models, and merges their names.

#include "app/exports/columns/study_vocabulary.h"

#include <algorithm>
#include <tuple>
#include <variant>

#include <nlohmann/json.hpp>

#include "app/plugins/stored_plugins.h"
#include "protocols/file/stored_protocol.h"
#include "renderers/force/force_model.h"
#include "results_schema/stored_json.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

std::string place_in(const ProtocolRow& protocol, const std::string& pointer) {
  return "protocol " + protocol.name + " " + protocol.version + ": " + pointer;
}

void add_scale(const ScaleForm& scale, StudyVocabulary::AnswerMeaning& meaning) {
  meaning.minimum = scale.minimum;
  meaning.maximum = scale.maximum;
  if (const auto& labels = scale.labels; !labels.empty()) {
    meaning.prompt += " [" + labels.front() + " … " + labels.back() + "]";
  }
}

StudyVocabulary::AnswerMeaning meaning_of_question(const Question& asked) {
  StudyVocabulary::AnswerMeaning meaning{};
  meaning.prompt = asked.prompt;
  meaning.free_text = asked.is_answered_by<TextForm>();
  meaning.has_several = asked.is_answered_by<MultipleChoiceForm>();
  if (asked.condition) {
    meaning.condition = clause_of(*asked.condition);
    meaning.asked_after = asked.condition->question;
  }
  if (const auto* const number = std::get_if<NumberForm>(&asked.form)) {
    meaning.unit = number->unit;
    meaning.minimum = number->minimum;
    meaning.maximum = number->maximum;
  }
  if (const auto* const scale = std::get_if<ScaleForm>(&asked.form)) add_scale(*scale, meaning);
  for (const Option& option : asked.options) {
    meaning.options.push_back(option.value);
    if (option.text != option.value) {
      meaning.option_meanings[option.value].description = option.text;
    }
  }
  return meaning;
}

/// Questions of several protocols, blocks and the questionnaire can have the same name.
void learn_question(const std::string& name, StudyVocabulary::AnswerMeaning meaning,
                    StudyVocabulary& vocabulary) {
  const auto [known, is_new] = vocabulary.questions.insert({name, meaning});
  if (is_new) return;
  StudyVocabulary::AnswerMeaning& all = known->second;
  all.questionnaire = all.questionnaire || meaning.questionnaire;
  all.free_text = all.free_text || meaning.free_text;
  all.has_several = all.has_several || meaning.has_several;
  all.has_no_own_scale = all.has_no_own_scale && meaning.has_no_own_scale;
}

void learn_questions(const ProtocolRow& protocol, const Protocol& specified,
                     StudyVocabulary& vocabulary) {
  for (const auto& [name, asked] : specified.questions) {
    StudyVocabulary::AnswerMeaning meaning = meaning_of_question(asked);
    meaning.source = place_in(protocol, "/questions/" + name);
    vocabulary.questions_of_source[{protocol.source_sha256, name}] = meaning;
    learn_question(name, std::move(meaning), vocabulary);
  }
  for (const auto& [name, block] : specified.blocks) {
    vocabulary.kinds_of_blocks[{protocol.source_sha256, name}] =
        block.kind.empty() ? protocol.kind : block.kind;
    if (block.procedure && block.procedure->catch_trials) {
      vocabulary.catch_types[{protocol.source_sha256, name}] =
          text_of(block.procedure->catch_trials->type);
    }
    if (const auto task = discrimination_task(name, block)) {
      vocabulary.discriminations[{protocol.source_sha256, name}] = {
          .task = *task,
          .drawn = block.drawn,
          .tracks = block.procedure ? block.procedure->tracks : std::vector<ProcedureSettings>{},
          .levels = *block.vary};
    }
    for (const Protocol::TrialQuestionTemplate& asked : block.questions) {
      if (asked.name.empty()) continue;
      StudyVocabulary::AnswerMeaning meaning = meaning_of_question(asked);
      meaning.questionnaire = false;
      meaning.has_no_own_scale = asked.is_additional || asked.is_answered_by<ScaleForm>();
      meaning.source = place_in(protocol, "/blocks/" + name);
      if (block.questions.size() == 1) meaning.source += "/question";
      learn_question(asked.name, std::move(meaning), vocabulary);
    }
  }
}

// The HED tags of a level. The protocol may spell a number with other digits than the table.
std::string tags_of(const std::string& level, const std::map<std::string, std::string>& hed) {
  for (const auto& [declared, tags] : hed) {
    const std::optional<double> number = number_in(declared);
    if (declared == level || (number && number == number_in(level))) return tags;
  }
  return {};
}

/// With those of which a block states or computes the levels.
std::map<std::string, Factor, std::less<>> all_factors(const Protocol& protocol) {
  auto factors = protocol.factors;
  for (const auto& [block_name, block] : protocol.blocks) {
    if (block.vary) {
      factors[block.vary->factor].meaning =
          "Value of the parameter " + block.vary->parameter + " of the " + block.vary->role;
    }
    for (const auto& [name, formula] : block.derived) {
      factors[name].meaning = "Computed as " + formula;
    }
  }
  return factors;
}

void learn_from_protocol(const ProtocolRow& protocol, StudyVocabulary& vocabulary) {
  const StoredProtocol stored = stored_protocol(protocol.source);
  const Protocol& specified = stored.protocol;
  for (const auto& [name, declared] : all_factors(specified)) {
    const auto factor = vocabulary.factors.find(name);
    if (factor == vocabulary.factors.end()) continue;
    factor->second.meaning = declared.meaning;
    factor->second.unit = declared.unit;
    factor->second.source = place_in(protocol, "/factors/" + name);
    for (const std::string& level : factor->second.levels) {
      const std::string tags = tags_of(level, declared.hed);
      if (!tags.empty()) factor->second.level_meanings[level].hed = tags;
    }
  }
  learn_questions(protocol, specified, vocabulary);
  vocabulary.titles[protocol.source_sha256] = specified.title;
  vocabulary.senses[protocol.source_sha256] = stored.senses();
  if (specified.groups) {
    vocabulary.group_factors[protocol.source_sha256] = specified.groups->factor;
  }
  if (specified.estimation) {
    vocabulary.estimations.insert({protocol.source_sha256, *specified.estimation});
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
  meaning.meanings.insert(parameter.meaning.english());
  if (parameter.kind == ParameterKind::choice) {
    meaning.levels.insert(parameter.choices.begin(), parameter.choices.end());
    return;
  }
  meaning.unit = parameter.unit;
  meaning.minimum = std::min(meaning.minimum.value_or(parameter.minimum), parameter.minimum);
  meaning.maximum = std::max(meaning.maximum.value_or(parameter.maximum), parameter.maximum);
}

void learn_from_protocols(const Study& study, StudyVocabulary& vocabulary) {
  // Translations of one protocol. Two files in the same language may ask different questions.
  struct Wordings {
    std::string first_sha256{};
    std::set<std::string> languages{};
  };
  std::map<std::tuple<std::string, std::string, std::string>, Wordings> translations{};
  std::set<std::string> known_languages{};
  for (const ProtocolRow& protocol : study.protocols()) {
    learn_from_protocol(protocol, vocabulary);
    Wordings& wordings =
        translations[{protocol.name, protocol.version, without_texts(protocol.source)}];
    if (wordings.languages.empty()) wordings.first_sha256 = protocol.source_sha256;
    const std::string language = language_of(protocol.source);
    const bool is_new = wordings.languages.insert(language).second;
    vocabulary.languages[protocol.source_sha256] = language;
    known_languages.insert(language);
    vocabulary.first_wording[protocol.source_sha256] =
        is_new ? wordings.first_sha256 : protocol.source_sha256;
  }
  vocabulary.known_languages = {known_languages.begin(), known_languages.end()};
}

bool holds(const StudyVocabulary& vocabulary, const std::string& question,
           bool StudyVocabulary::AnswerMeaning::*what) {
  const auto known = vocabulary.questions.find(question);
  return known != vocabulary.questions.end() && known->second.*what;
}

}  // namespace

bool StudyVocabulary::is_free_text(const std::string& question) const {
  return holds(*this, question, &AnswerMeaning::free_text);
}

bool StudyVocabulary::has_several_answers(const std::string& question) const {
  return holds(*this, question, &AnswerMeaning::has_several);
}

bool StudyVocabulary::has_no_own_scale(const std::string& question) const {
  return holds(*this, question, &AnswerMeaning::has_no_own_scale);
}

bool StudyVocabulary::is_published(const std::string& question) const {
  const auto known = questions.find(question);
  return known != questions.end() && !known->second.free_text && for_public.contains(question);
}

const StudyVocabulary::AnswerMeaning* StudyVocabulary::meaning_of(
    const std::string& source_sha256, const std::string& question) const {
  const auto found = questions_of_source.find({source_sha256, question});
  return found == questions_of_source.end() ? nullptr : &found->second;
}

StudyVocabulary vocabulary_of(const Study& study, const ModelRegistry& loaded) {
  const ModelRegistry models = with_stored_plugins(loaded, study);
  StudyVocabulary vocabulary{};
  const StudyWords words = study.words();
  for (const std::string& factors : words.factors_json) {
    learn_factors(stored_json(factors, "trial.factors_json"), vocabulary);
  }
  for (auto& [name, factor] : vocabulary.factors) sort_levels(factor);
  for (const auto& [model, parameters_json] : words.parameters) {
    const nlohmann::json parameters = stored_json(parameters_json, "presentation.parameters_json");
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
  for (const auto& [role, model] : words.assets) {
    const bool has_own_column = role == "height_field" || role == "surface" || role == "tool";
    if (!has_own_column) vocabulary.assets[role].insert(model);
  }
  for (const ParticipantRow& participant : study.participants()) {
    const nlohmann::json answers =
        stored_json(participant.answers_json, "participant.answers_json");
    for (const auto& [name, value] : answers.items()) vocabulary.participant_answers.insert(name);
  }
  for (const SessionRow& session : study.sessions()) {
    if (session.group_level) vocabulary.groups.insert(*session.group_level);
  }
  learn_from_protocols(study, vocabulary);
  return vocabulary;
}

StudyVocabulary vocabulary_of_protocols(const Study& study) {
  StudyVocabulary vocabulary{};
  learn_from_protocols(study, vocabulary);
  return vocabulary;
}

}  // namespace asperity
