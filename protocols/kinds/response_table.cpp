// Collects the parameters of a table in a list, and draws a participant's own values by name.

#include "protocols/kinds/response_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "protocols/answers/scale_form.h"
#include "protocols/answers/stored_number.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

constexpr double kLeastUniform = 0x1p-54;  // a uniform number may be 0

/// Numbers ascending and before other names.
bool is_named_before(const std::string& one, const std::string& other) {
  const std::optional<double> first = stored_number(one);
  const std::optional<double> second = stored_number(other);
  if (first && second && *first != *second) return *first < *second;
  if (first.has_value() != second.has_value()) return first.has_value();
  return one < other;
}

/// The order of the levels in the protocol; levels that it does not list, by name.
std::vector<std::string> ordered_levels(const Protocol& protocol, const std::string& factor,
                                        const std::set<std::string>& levels) {
  std::vector<std::string> ordered(levels.begin(), levels.end());
  std::sort(ordered.begin(), ordered.end(), is_named_before);
  const auto declared = protocol.factors.find(factor);
  if (declared == protocol.factors.end()) return ordered;
  const auto place = [&declared](const std::string& level) {
    const auto& all = declared->second.levels;
    return std::find_if(all.begin(), all.end(),
                        [&level](const Level& each) { return text_of(each) == level; }) -
           all.begin();
  };
  std::stable_sort(ordered.begin(), ordered.end(),
                   [&place](const auto& a, const auto& b) { return place(a) < place(b); });
  return ordered;
}

}  // namespace

bool is_in_range(ParameterRange range, double value) noexcept {
  if (!std::isfinite(value)) return false;
  switch (range) {
    case ParameterRange::any:
      return true;
    case ParameterRange::not_negative:
      return value >= 0.0;
    case ParameterRange::positive:
      return value > 0.0;
    case ParameterRange::proportion:
      return value >= 0.0 && value <= 1.0;
  }
  return false;
}

std::string text_of(ParameterRange range) {
  switch (range) {
    case ParameterRange::any:
      return "a finite number";
    case ParameterRange::not_negative:
      return "0 or a number above 0";
    case ParameterRange::positive:
      return "above 0";
    case ParameterRange::proportion:
      return "from 0 to 1";
  }
  return "a number";
}

const std::pair<std::string, std::vector<std::string>>* groups_in(
    const TabulatedQuestion& asked) noexcept {
  if (!asked.protocol.groups) return nullptr;
  const auto found = std::find_if(
      asked.factors.begin(), asked.factors.end(),
      [&asked](const auto& each) { return each.first == asked.protocol.groups->factor; });
  return found == asked.factors.end() ? nullptr : &*found;
}

TabulatedQuestion tabulated_question(const Protocol& protocol, const Protocol::Block& block,
                                     const Protocol::TrialQuestionTemplate& question,
                                     const std::vector<Trial>& possible) {
  TabulatedQuestion asked{.protocol = protocol, .block = block, .question = question};
  const ExperimentKind& of_block = kind_of(block);
  const ExperimentKind& kind = *kind_of_question(of_block, question);
  asked.family =
      family_of(kind, protocol.analysis, protocol.estimation.value_or(EstimationDeclaration{}),
                &kind != &of_block);
  std::set<std::string> items{};
  std::map<std::string, std::set<std::string>> levels{};
  for (const Trial& trial : possible) {
    if (trial.block != block.name) continue;
    for (const PlannedPresentation& surface : trial.presentations) items.insert(surface.item);
    for (const auto& [factor, level] : trial.factors) levels[factor].insert(text_of(level));
  }
  asked.items.assign(items.begin(), items.end());
  std::sort(asked.items.begin(), asked.items.end(), is_named_before);
  for (const auto& [factor, all] : levels) {
    const bool is_drawn =
        std::find(block.drawn.begin(), block.drawn.end(), factor) != block.drawn.end();
    const bool is_varied = block.vary && block.vary->factor == factor;
    if (all.size() < 2 || is_drawn || is_varied) continue;
    asked.factors.emplace_back(factor, ordered_levels(protocol, factor, all));
  }
  if (block.vary) asked.values = block.vary->values();
  return asked;
}

double ResponseValues::at(std::string_view name) const {
  for (const auto& [known, value] : values_) {
    if (known == name) return value;
  }
  throw std::logic_error("the response table has no parameter \"" + std::string(name) +
                         "\"; add it to the parameters of its kind");
}

double TabulatedTrial::own(std::string_view name) const {
  const double sd = values.at(std::string(name) + "_sd");
  return values.at(name) + sd * of_participant.split(name).normal();
}

double TabulatedTrial::own_of(std::string_view name, std::string_view level, double sd) const {
  return sd * of_participant.split(name).split(level).normal();
}

bool TabulatedTrial::lapses() const {
  return of_response.split("lapse").uniform() < values.at("lapse");
}

double TabulatedTrial::place_of(std::string_view factor) const {
  const auto level = trial.factors.find(factor);
  const auto known = std::find_if(asked.factors.begin(), asked.factors.end(),
                                  [factor](const auto& each) { return each.first == factor; });
  if (level == trial.factors.end() || known == asked.factors.end()) return 0.0;
  return place_among(known->second, text_of(level->second));
}

double place_among(const std::vector<std::string>& names, std::string_view name) noexcept {
  const auto found = std::find(names.begin(), names.end(), name);
  if (names.size() < 2 || found == names.end()) return 0.0;
  return static_cast<double>(found - names.begin()) / static_cast<double>(names.size() - 1) - 0.5;
}

std::string quoted_name(const std::string& name) { return '"' + name + '"'; }

Phrase scale_text(const ScaleForm& form) {
  if (form.labels.empty()) {
    return phrase("Responses", "on the scale from %1 to %2")
        .with(number_text(form.minimum), number_text(form.maximum));
  }
  return phrase("Responses", "on the scale from %1 (%2) to %3 (%4)")
      .with(number_text(form.minimum), quoted_name(form.labels.front()), number_text(form.maximum),
            quoted_name(form.labels.back()));
}

Phrase text_of(const EndComparison& comparison, const std::vector<std::string>& names) {
  const Phrase first =
      names.empty() ? phrase("Responses", "the first") : Phrase(quoted_name(names.front()));
  const Phrase last =
      names.empty() ? phrase("Responses", "the last") : Phrase(quoted_name(names.back()));
  const Phrase of_ends = comparison.of_ends.with(last, first, comparison.details);
  if (names.size() < 3) return of_ends;
  std::string order{};
  for (const std::string& name : names) order += (order.empty() ? "" : ", ") + quoted_name(name);
  return comparison.in_order.with(of_ends, order);
}

std::string ParameterList::in_family(const std::vector<std::string>& tests) const {
  std::string names{};
  for (const std::string& test : tests) {
    if (std::find(asked_.family.begin(), asked_.family.end(), test) == asked_.family.end())
      continue;
    names += (names.empty() ? "" : ", ") + test;
  }
  return names;
}

void ParameterList::effect_of_groups(ResponseParameter effect) {
  effect.tests = in_family({kGroupsTest});
  if (effect.tests.empty()) {
    effect.value = effect.null_value;
  } else {
    effect.part = ResponseParameter::Part::effect;
  }
  parameters_.push_back(std::move(effect));
}

void ParameterList::varies_within_groups(const std::string& sd) {
  if (in_family({kGroupsTest}).empty()) return;
  const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                  [&sd](const ResponseParameter& one) { return one.name == sd; });
  found->value.reset();
  found->part = ResponseParameter::Part::effect_sd;
}

void ParameterList::effect(Effect effect) {
  ResponseParameter& mean = effect.effect;
  mean.tests = in_family(effect.tests);
  ResponseParameter sd{.name = mean.name + "_sd",
                       .range = ParameterRange::not_negative,
                       .unit = effect.sd_unit,
                       .meaning = effect.sd_meaning};
  const bool is_compared = !in_family(effect.compared_in).empty();
  if (!mean.tests.empty()) {
    mean.part = ResponseParameter::Part::effect;
  } else if (!is_compared) {
    mean.value = mean.null_value;
  }
  if (!mean.tests.empty() || is_compared) {
    sd.part = ResponseParameter::Part::effect_sd;
  } else {
    sd.value = effect.usual_sd;
  }
  parameters_.push_back(std::move(mean));
  parameters_.push_back(std::move(sd));
}

void ParameterList::scale(double range, ResponseParameter level, Phrase level_sd, Phrase noise_sd) {
  const auto deviation = [](const char* name, Phrase meaning, double usual) {
    return ResponseParameter{.name = name,
                             .range = ParameterRange::not_negative,
                             .unit = kScaleUnits,
                             .meaning = std::move(meaning),
                             .value = usual};
  };
  level.name = "level";
  level.unit = kScaleUnits;
  assumed(std::move(level));
  assumed(deviation("level_sd", std::move(level_sd), 0.1 * range));
  assumed(deviation("noise_sd", std::move(noise_sd), 0.15 * range));
  lapse();
}

void ParameterList::lapse() {
  assumed({.name = "lapse",
           .range = ParameterRange::proportion,
           .meaning = phrase("Responses",
                             "probability of a response that does not depend on the surfaces"),
           .value = 0.02});
}

double logistic(Random& random) {
  const double u = std::max(random.uniform(), kLeastUniform);
  return std::log(u) - std::log1p(-u);
}

double gumbel(Random& random) {
  return -std::log(-std::log(std::max(random.uniform(), kLeastUniform)));
}

}  // namespace asperity
