// Takes force features or true heights as expectations, and lets the observer of the protocol answer.

#include "app/session/respondents/virtual_participant.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/rounded_text.h"
#include "app/session/attempt_measures.h"
#include "app/session/respondents/felt_surface.h"
#include "protocols/design/block_factors.h"

namespace asperity {

namespace {

constexpr double kReading_s = 2.0;
constexpr double kChoosing_s = 0.5;   // which surface to feel next
constexpr double kMostNumbers = 1e6;  // that a question of the questionnaire is answered with

/// A sample of a texture whose heights are known: a plate that has these heights.
struct Sample {
  const ForceModel* model = nullptr;
  RendererInputs inputs{};
};

Sample plate_with(const std::string& height_field, const Protocol& protocol,
                  StimulusBuilder& builder) {
  const ForceModel* model = builder.models().find("height_map");
  if (model == nullptr)
    throw std::logic_error(
        "the force model height_map is missing; register it with the other models");
  Sample sample{.model = model};
  sample.inputs.parameters = complete_values(model->declaration, {});
  sample.inputs.material = protocol.material;
  sample.inputs.patch = protocol.patch;
  const std::optional<double> cutoff_m = protocol.observer.gaussian_wavelength_m;
  sample.inputs.height_field =
      cutoff_m ? builder.height_field_without_long_wavelengths(height_field, *cutoff_m)
               : builder.height_field(height_field).field;
  return sample;
}

Sample bodies_of(StimulusDescription stimulus, StimulusBuilder& builder) {
  stimulus.parameters.clear();
  stimulus.relative_amplitude.reset();
  PreparedStimulus prepared = builder.unmatched(stimulus);
  return {.model = prepared.model, .inputs = std::move(prepared.inputs)};
}

std::set<std::string, std::less<>> body_models_of(const ModelRegistry& models) {
  std::set<std::string, std::less<>> ids{};
  for (const ForceModel& model : models.models()) {
    if (model.declaration.needs_bodies) ids.insert(model.declaration.id);
  }
  return ids;
}

Expectations true_surfaces(const Protocol& protocol, const Exploration& exploration,
                           const std::map<std::string, StimulusDescription, std::less<>>& on_bodies,
                           StimulusBuilder& builder, const Random& random) {
  const HandHabits habits = habits_for(exploration, protocol.patch);
  Expectations expectations{};
  for (const auto& [name, texture] : protocol.textures) {
    const auto stimulus = on_bodies.find(name);
    if (stimulus == on_bodies.end() && !texture.true_height_field) continue;
    const Sample sample = stimulus == on_bodies.end()
                              ? plate_with(*texture.true_height_field, protocol, builder)
                              : bodies_of(stimulus->second, builder);
    expectations[name] = felt_surface(*sample.model, sample.inputs, protocol, habits,
                                      random.split("expectation").split(name));
  }
  return expectations;
}

}  // namespace

ExpectationsByExploration expectations_of(const Protocol& protocol, StimulusBuilder& builder,
                                          const Random& random) {
  Expectations stated{};
  for (const auto& [name, texture] : protocol.textures) {
    if (texture.prior) stated[name] = *texture.prior;
  }
  using Source = ObserverDeclaration::Expectation;
  std::map<std::string, StimulusDescription, std::less<>> on_bodies{};
  if (protocol.observer.expectation == Source::true_surface) {
    on_bodies = stimuli_on_bodies(possible_trials(protocol), body_models_of(builder.models()));
  }
  ExpectationsByExploration expectations{};
  for (const auto& [name, exploration] : protocol.explorations) {
    switch (protocol.observer.expectation) {
      case Source::none:
        break;
      case Source::prior:
        expectations[name] = stated;
        break;
      case Source::true_surface:
        expectations[name] = true_surfaces(protocol, exploration, on_bodies, builder, random);
        break;
    }
  }
  return expectations;
}

VirtualParticipant::VirtualParticipant(const Protocol& protocol,
                                       ExpectationsByExploration expectations,
                                       ParticipantRow person, const Random& random)
    : protocol_(protocol),
      expectations_(std::move(expectations)),
      person_(std::move(person)),
      random_(random),
      attempt_random_(random) {}

void VirtualParticipant::begin_attempt(int trial, int attempt) {
  attempt_random_ = random_.split("attempt")
                        .split(static_cast<std::uint64_t>(trial))
                        .split(static_cast<std::uint64_t>(attempt));
  visits_.clear();
  responses_.clear();
  felt_side_by_side_ = false;
}

void VirtualParticipant::announce(const Trial& trial, const PlannedPresentation& surface) {
  visits_.add(surface.position);
  felt_side_by_side_ = trial.arrangement.surfaces == Arrangement::Surfaces::side_by_side;
}

void VirtualParticipant::read(const std::string&, double minimum_s, const Wait& wait) {
  wait(std::max(minimum_s, kReading_s));
}

void VirtualParticipant::tell(const std::string&, const Wait& wait) { wait(1.0); }

namespace {

/// An answer that is independent of everything else. Virtual participants write no texts.
struct RandomAnswer {
  const Question& question;
  Random draws;

  std::optional<Answer> operator()(const ChoiceForm&) {
    if (question.options.empty()) return std::nullopt;
    return ChosenOption{static_cast<std::size_t>(draws.below(question.options.size()))};
  }
  std::optional<Answer> operator()(const MultipleChoiceForm&) {
    ChosenOptions chosen{};
    for (std::size_t i = 0; i < question.options.size(); ++i) {
      if (draws.below(2) == 0) chosen.options.push_back(i);
    }
    if (chosen.options.empty() && !question.options.empty()) {
      chosen.options.push_back(question.options.size() - 1);
    }
    return chosen;
  }
  std::optional<Answer> operator()(const NumberForm& form) {
    const double usual = form.is_estimate ? 1.0 : 0.0;
    const double low =
        form.minimum.value_or(form.maximum ? std::min(usual, *form.maximum - 10.0) : usual);
    const double high = form.maximum.value_or(low + 10.0);
    const double first = std::ceil(low);
    const double last = std::floor(high);
    if (first > last) return GivenNumber{std::stod(rounded_text(0.5 * (low + high)))};
    const auto count = static_cast<std::uint64_t>(std::min(last - first, kMostNumbers)) + 1;
    return GivenNumber{first + static_cast<double>(draws.below(count))};
  }
  std::optional<Answer> operator()(const ScaleForm& form) {
    return ScalePoint{static_cast<int>(draws.below(static_cast<std::uint64_t>(form.steps()) + 1))};
  }
  std::optional<Answer> operator()(const LineForm&) {
    return DrawnLength{static_cast<int>(draws.below(LineForm::kSteps)) + 1};
  }
  std::optional<Answer> operator()(const TextForm&) { return std::nullopt; }
  std::optional<Answer> operator()(const AssignmentForm&) {
    throw std::logic_error("an assignment is answered by its kind of experiment; add its `judge`");
  }
};

/// To an additional question of a trial.
Answer additional_answer(const Question& question, const Random& random) {
  const std::optional<Answer> given = std::visit(RandomAnswer{question, random}, question.form);
  return given.value_or(WrittenText{"virtual"});
}

}  // namespace

Reply VirtualParticipant::ask(const Trial& trial, std::span<const Question> page,
                              std::span<const ForceFeatures> felt, std::optional<double> deadline_s,
                              const Wait& wait) {
  if (const std::optional<int> owed = visits_.owed(trial)) {
    wait(kChoosing_s);
    return {FeelAgain{*owed}};
  }
  static const Expectations kNone{};
  const auto expected = expectations_.find(exploration_of(protocol_, trial).name);
  std::optional<double> left_s = deadline_s;
  bool is_guess = false;
  GivenAnswers given{};
  for (const Question& question : page) {
    // The first question of a trial has the stream of the attempt, every other its own.
    const Random random = question.name == trial.questions.front().name
                              ? attempt_random_
                              : attempt_random_.split(question.name);
    VirtualObserver observer(protocol_.observer, random);
    const double thinking_s = observer.response_time_s();
    if (left_s && thinking_s > *left_s) {
      wait(*left_s);
      return {};
    }
    wait(thinking_s);
    if (left_s) left_s = *left_s - thinking_s;
    const ExperimentKind* const kind = kind_of_question(kind_named(trial.kind), question);
    if (kind == nullptr) {
      given.push_back({additional_answer(question, random), {}});
      continue;
    }
    const VirtualResponse judged =
        kind->judge({.protocol = protocol_,
                     .trial = trial,
                     .question = question,
                     .felt = felt,
                     .expectations = expected == expectations_.end() ? kNone : expected->second,
                     .observer = observer,
                     .of_attempt = random,
                     .of_participant = random_,
                     .rated = response_rated_by(trial, question)});
    is_guess = is_guess || judged.is_guess;
    given.push_back({judged.answer, {}});
    responses_[question.name] = judged;
  }
  source_ = is_guess || protocol_.observer.deaf ? "virtual_guess" : "virtual";
  return {std::move(given)};
}

const VirtualResponse* VirtualParticipant::response_rated_by(const Trial& trial,
                                                             const Question& question) const {
  const auto* const asked = question_named(protocol_.blocks.at(trial.block), question.name);
  if (asked == nullptr) return nullptr;
  const auto rated = responses_.find(asked->confidence_of());
  return rated == responses_.end() ? nullptr : &rated->second;
}

std::optional<Answer> VirtualParticipant::answer(const Question& question, const Wait& wait) {
  wait(kReading_s);
  source_ = "virtual";
  // A resumed session gives the same answers.
  return std::visit(RandomAnswer{question, random_.split("questionnaire").split(question.name)},
                    question.form);
}

ParticipantRow virtual_person(int number, const Random& random, const std::string& created_utc) {
  Random draws = random.split("person").split(static_cast<std::uint64_t>(number));
  ParticipantRow person{};
  std::string digits = std::to_string(number);
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  person.label = "virtual" + digits;
  person.is_virtual = true;
  person.sex = number % 2 == 1 ? "F" : "M";
  person.age_years = 20.0 + static_cast<double>(draws.below(9));  // mean 24, as in the chapter
  person.handedness = draws.below(10) == 0 ? "left" : "right";
  person.answers_json = R"({"hand_used":")" + *person.handedness + R"("})";
  person.created_utc = created_utc;
  return person;
}

}  // namespace asperity
