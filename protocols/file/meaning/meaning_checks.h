// Declares the checks of meaning, functions over a CheckedDocument; each file *_meaning.cpp contains those of one subject.

#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "protocols/design/block_factors.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/problem_sink.h"
#include "protocols/design/protocol.h"
#include "protocols/design/question_place.h"
#include "protocols/design/wording.h"
#include "protocols/file/diagnostic.h"
#include "protocols/file/json_document.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/plan.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

// More trials than a participant can complete; a plan of this size is made without a noticeable delay.
inline constexpr std::size_t kMaximumTrials = 2000;
inline constexpr std::size_t kMaximumSessionTrials = 5000;
inline constexpr std::size_t kMaximumRows = 100'000;

template <class Map>
std::vector<std::string> names_of(const Map& map) {
  std::vector<std::string> names{};
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

/// A protocol whose meaning is checked, and the problems that were found. The protocol was read from the document, and all
/// outlive it.
class CheckedDocument final : public ProblemSink {
 public:
  CheckedDocument(const Protocol& read, const JsonDocument& from,
                  const std::vector<ModelDeclaration>& declared)
      : protocol(read), kinds(kinds_of(read)), document(from) {
    for (const ModelDeclaration& model : declared) models.emplace(model.id, &model);
  }

  using ProblemSink::report;
  using ProblemSink::report_key;
  /// A problem of the value, or of the key, at a pointer; one that was reported there already is not repeated.
  void report(const std::string& pointer, Phrase message) override {
    if (!reported_.emplace(pointer, message.english()).second) return;
    found_.push_back(document.at(pointer, std::move(message)));
  }
  void report_key(const std::string& pointer, Phrase message) override {
    if (!reported_.emplace(pointer, message.english()).second) return;
    found_.push_back(document.at_key(pointer, std::move(message)));
  }
  const std::vector<Diagnostic>& found() const noexcept { return found_; }

  const Protocol& protocol;
  const std::vector<const ExperimentKind*> kinds{};  ///< of the blocks
  const JsonDocument& document;
  std::map<std::string, const ModelDeclaration*, std::less<>> models{};

 private:
  std::vector<Diagnostic> found_{};
  std::set<std::pair<std::string, std::string>> reported_{};
};

/// Of a choice: its options are stated, or can be the surfaces of a trial.
enum class OptionsOfChoice { stated, surfaces };

// The checks, in the source of their subject. Those of a block are given its place, "/blocks/NAME".

// setting_meaning.cpp
void check_head(CheckedDocument& checked);
/// Whether every key applies where it is stated.
void check_applicability(CheckedDocument& checked);
void check_device_limits(CheckedDocument& checked);
void check_instability(CheckedDocument& checked);
void check_textures(CheckedDocument& checked);
/// Why this is not the path of a file in the study, and what to state; nothing where it is.
std::optional<Phrase> complaint_about_path(const std::string& path);
void check_path(CheckedDocument& checked, const std::optional<std::string>& path,
                const std::string& pointer);
void check_factors(CheckedDocument& checked);
void check_explorations(CheckedDocument& checked);

// senses_meaning.cpp
void check_senses(CheckedDocument& checked);

// questionnaire_meaning.cpp
void check_questions(CheckedDocument& checked);
/// Whether the parameters of the forms fit the form, which in a trial need not be stated.
void check_form(CheckedDocument& checked, const Question& question, const std::string& pointer,
                OptionsOfChoice options);
void check_options(CheckedDocument& checked, const Question& question, const std::string& pointer);
void check_conditions(CheckedDocument& checked);
/// Whether the condition at the place states exactly one test.
bool states_one_test(CheckedDocument& checked, const std::string& pointer);
/// Whether an answer to the question can meet the condition at the place.
void check_test(CheckedDocument& checked, const AnswerCondition& condition,
                const Question& question, const std::string& pointer);

/// What an entry of a list can be instead: the names that a map declares, without those in the list.
template <class Map>
std::vector<std::string> names_not_in(const std::vector<std::string>& list, const Map& declared) {
  std::vector<std::string> names = names_of(declared);
  std::erase_if(names, [&list](const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  });
  return names;
}

// stimulus_meaning.cpp
void check_stimulus(CheckedDocument& checked, const StimulusTemplate& stimulus,
                    const std::string& pointer);
/// Checks for values that are valid individually and contradict each other.
void check_together(CheckedDocument& checked, const ModelDeclaration& model,
                    const ParameterValues& given, const std::string& pointer);
/// The texts that a binding can have, each with the location for problems.
std::vector<std::pair<std::string, std::string>> texts_of(CheckedDocument& checked,
                                                          const Binding<std::string>& binding,
                                                          const std::string& pointer);

// body_meaning.cpp
void check_bodies(CheckedDocument& checked);
/// Whether a point model touches a body: a surface without a tool.
bool is_point_on_body(const StimulusTemplate& stimulus);
void check_bodies_of(CheckedDocument& checked, const StimulusTemplate& stimulus,
                     const std::vector<const ModelDeclaration*>& models,
                     const std::string& pointer);
/// Whether every surface that the stimulus can have contains its own relief.
bool brings_its_relief(CheckedDocument& checked, const StimulusTemplate& stimulus,
                       const std::string& pointer);
bool is_on_a_body(CheckedDocument& checked, const StimulusTemplate& stimulus,
                  const std::string& texture, const std::string& pointer);

// groups_meaning.cpp
void check_groups(CheckedDocument& checked);
/// The factors that the trials of a block have: set by the block, by `run`, or by the participant's group.
std::set<std::string> factors_of(const CheckedDocument& checked, const Protocol::Block& block,
                                 const Protocol::Run* run);

// flow_meaning.cpp
void check_flow(CheckedDocument& checked);
void check_size(CheckedDocument& checked);
bool check_level(CheckedDocument& checked, const std::string& factor, const Level& level,
                 const std::string& pointer);

// block_meaning.cpp
void check_block(CheckedDocument& checked, const Protocol::Block& block,
                 const std::string& pointer);
void check_criterion(CheckedDocument& checked, const Protocol::Block& block,
                     const std::string& pointer);

// dimension_meaning.cpp
void check_dimension(CheckedDocument& checked, const Protocol::Block& block,
                     const std::string& pointer);

// roughness_meaning.cpp
void check_relative_amplitude(CheckedDocument& checked, const Protocol::Block& block,
                              const StimulusTemplate& stimulus, const std::string& pointer);
void check_equal_roughness(CheckedDocument& checked, const Protocol::Block& block,
                           const std::string& pointer);
void check_matches(CheckedDocument& checked, const std::vector<Trial>& possible);

// procedure_meaning.cpp
void check_procedure(CheckedDocument& checked, const Protocol::Block& block,
                     const std::string& pointer);

// arrangement_meaning.cpp
void check_arrangement(CheckedDocument& checked, const Protocol::Block& block,
                       const std::string& pointer);

// question_meaning.cpp
void check_question(CheckedDocument& checked, const Protocol::Block& block,
                    const std::string& pointer);
/// Where the options are known: those of all trials of the block.
void check_tests_in_trials(CheckedDocument& checked, const std::vector<Trial>& possible);
void check_scale_form(CheckedDocument& checked, const ScaleForm& scale, const std::string& at);

// rows_meaning.cpp
void check_rows(CheckedDocument& checked, const Protocol::Block& block, const std::string& pointer);
void check_order(CheckedDocument& checked, const Protocol::Block& block,
                 const std::string& pointer);

// texts_meaning.cpp
/// Whether the placeholders of texts have a form, a name, and a value where they are.
void check_texts(CheckedDocument& checked);

// analysis_meaning.cpp
void check_analysis(CheckedDocument& checked);

// trial_meaning.cpp
void check_trials(CheckedDocument& checked);

}  // namespace asperity
