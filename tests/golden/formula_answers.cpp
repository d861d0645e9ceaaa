// The formulas of made-up answers, and what they know of a protocol.

#include "tests/golden/formula_answers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <stdexcept>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "protocols/plan/plan.h"

namespace asperity::test {

namespace {

std::size_t option_of(const Question& question, const std::string& value) {
  const auto found = std::find_if(question.options.begin(), question.options.end(),
                                  [&value](const Option& option) { return option.value == value; });
  if (found == question.options.end()) {
    throw std::runtime_error("the question " + question.name + " has no option " + value);
  }
  return static_cast<std::size_t>(found - question.options.begin());
}

}  // namespace

double formula_number(const FormulaPlace& place, std::string_view text) {
  // FNV-1a, and the last steps of SplitMix64, which spread its bits.
  std::uint64_t hash = 0xcbf29ce484222325;
  const std::string all = std::to_string(place.participant) + ' ' + std::to_string(place.session) +
                          ' ' + std::to_string(place.trial) + ' ' + std::string(text);
  for (const char byte : all) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  }
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111eb;
  hash ^= hash >> 31;
  return static_cast<double>(hash >> 11) * 0x1p-53;
}

FormulaAnswers::FormulaAnswers(const Protocol& protocol) : protocol_(protocol) {
  std::set<std::string> items{};
  for (const Trial& trial : possible_trials(protocol)) {
    for (const PlannedPresentation& surface : trial.presentations) {
      items.insert(surface.item);
      for (const auto& [name, number] : numbers_of(surface)) {
        auto& [least, greatest] = ranges_.try_emplace(name, number, number).first->second;
        least = std::min(least, number);
        greatest = std::max(greatest, number);
      }
    }
  }
  items_.assign(items.begin(), items.end());
}

FormulaAnswers::Numbers FormulaAnswers::numbers_of(const PlannedPresentation& surface) const {
  const StimulusDescription& stimulus = surface.stimulus;
  Numbers numbers{{"stiffness", stimulus.material.stiffness_N_per_m}};
  for (const auto& [name, value] : stimulus.parameters) {
    if (const auto* const number = std::get_if<double>(&value)) {
      numbers.emplace(stimulus.model + ' ' + name, *number);
    }
  }
  if (stimulus.relative_amplitude) numbers.emplace("amplitude", *stimulus.relative_amplitude);
  const auto texture = protocol_.textures.find(stimulus.texture);
  if (texture != protocol_.textures.end() && texture->second.spacing_m) {
    numbers.emplace("spacing", *texture->second.spacing_m);
  }
  return numbers;
}

double FormulaAnswers::rank(const std::string& item) const {
  if (items_.size() < 2) return 0.5;
  const auto place = std::lower_bound(items_.begin(), items_.end(), item) - items_.begin();
  return static_cast<double>(place) / static_cast<double>(items_.size() - 1);
}

double FormulaAnswers::intensity(const PlannedPresentation& surface) const {
  double sum = 0.0;
  int count = 0;
  for (const auto& [name, number] : numbers_of(surface)) {
    const auto range = ranges_.find(name);
    if (range == ranges_.end() || range->second.first == range->second.second) continue;
    const auto [least, greatest] = range->second;
    sum += (number - least) / (greatest - least);
    ++count;
  }
  return count == 0 ? rank(surface.item) : sum / count;
}

double FormulaAnswers::difference(const Trial& trial) const {
  double least = 1.0;
  double greatest = 0.0;
  for (const PlannedPresentation& surface : trial.presentations) {
    const double each = intensity(surface);
    least = std::min(least, each);
    greatest = std::max(greatest, each);
  }
  return std::max(0.0, greatest - least);
}

/// About 0 to 1: what numbers, lines and scales follow.
double FormulaAnswers::sensation(const Trial& trial, const Question& question,
                                 const FormulaPlace& place) const {
  double felt = intensity(trial.presentations.front());
  if (trial.presentations.size() > 1) {
    const double apart =
        std::abs(rank(trial.presentations.front().item) - rank(trial.presentations.back().item));
    felt = 0.5 * (difference(trial) + apart);
  }
  const double of_question = formula_number({.participant = 0, .session = 0}, question.name);
  const double noise = formula_number(place, question.name) - 0.5;
  return std::clamp(
      0.2 + 0.5 * felt + 0.1 * of_question + 0.25 * noise + 0.02 * (place.participant - 4), 0.0,
      1.0);
}

bool FormulaAnswers::is_correct(const Trial& trial, const Question& question,
                                const FormulaPlace& place) const {
  const double felt =
      trial.presentations.size() > 1 ? difference(trial) : intensity(trial.presentations.front());
  const double half_way = 0.08 + 0.012 * place.participant;
  const double ratio = felt / half_way * (felt / half_way);
  const double proportion = felt == 0.0 ? 0.75 : 0.5 + 0.48 * ratio / (1.0 + ratio);
  return formula_number(place, question.name) < proportion;
}

std::size_t FormulaAnswers::chosen_option(const Trial& trial, const Question& question,
                                          const FormulaPlace& place) const {
  const bool is_right = !question.correct.empty() && is_correct(trial, question, place);
  if (is_right) return option_of(question, question.correct.front());
  std::optional<std::size_t> best{};
  double most = 0.0;
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    const std::string& value = question.options[i].value;
    if (!question.correct.empty() && value == question.correct.front()) continue;
    const bool is_item = std::binary_search(items_.begin(), items_.end(), value);
    const double liking =
        (is_item ? 0.5 * rank(value) : 0.2) + formula_number(place, question.name + ' ' + value);
    if (best && liking <= most) continue;
    best = i;
    most = liking;
  }
  return best.value_or(0);
}

/// The correct assignment, or two surfaces exchanged.
std::vector<std::size_t> FormulaAnswers::assigned_options(const Trial& trial,
                                                          const Question& question,
                                                          const FormulaPlace& place) const {
  std::vector<std::size_t> options{};
  for (std::size_t i = 0; i < trial.presentations.size(); ++i) {
    options.push_back(question.correct.empty() ? i : option_of(question, question.correct.at(i)));
  }
  const double chance = formula_number(place, question.name);
  if (options.size() > 1 && chance < 0.6) {
    const auto first = static_cast<std::size_t>(chance / 0.6 * static_cast<double>(options.size()));
    std::swap(options[first], options[(first + 1) % options.size()]);
  }
  return options;
}

Answer FormulaAnswers::answer(const Trial& trial, const Question& question,
                              const FormulaPlace& place) const {
  const auto step_up_to = [&](int steps) {
    return static_cast<int>(std::lround(sensation(trial, question, place) * steps));
  };
  if (std::holds_alternative<ChoiceForm>(question.form)) {
    return ChosenOption{chosen_option(trial, question, place)};
  }
  if (std::holds_alternative<AssignmentForm>(question.form)) {
    return AssignedOptions{assigned_options(trial, question, place)};
  }
  if (const auto* const scale = std::get_if<ScaleForm>(&question.form)) {
    return ScalePoint{step_up_to(scale->steps())};
  }
  if (std::holds_alternative<LineForm>(question.form)) {
    return DrawnLength{std::max(1, step_up_to(LineForm::kSteps))};
  }
  // Every participant has a unit of their own.
  const int unit = place.participant % 3 + 1;
  return GivenNumber{std::max(1, step_up_to(60 * unit)) * 0.5};
}

std::optional<Answer> FormulaAnswers::answer(const Question& question,
                                             const FormulaPlace& place) const {
  const double chance = formula_number(place, question.name);
  const auto option =
      static_cast<std::size_t>(chance * static_cast<double>(question.options.size()));
  if (question.is_answered_by<ChoiceForm>()) return ChosenOption{option};
  if (question.is_answered_by<MultipleChoiceForm>()) return ChosenOptions{{option}};
  if (const auto* const scale = std::get_if<ScaleForm>(&question.form)) {
    return ScalePoint{static_cast<int>(chance * (scale->steps() + 1))};
  }
  if (const auto* const number = std::get_if<NumberForm>(&question.form)) {
    const double least = std::ceil(number->minimum.value_or(0.0));
    return GivenNumber{
        std::min(number->maximum.value_or(least + 20.0), least + std::floor(20.0 * chance))};
  }
  if (question.optional) return std::nullopt;
  return WrittenText{"Answer of participant " + std::to_string(place.participant)};
}

}  // namespace asperity::test
