// Compares the parameters of all presented surfaces: shared ones once, others by surface.

#include "app/report/text/report_parameters.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

using RenderedValues = std::map<std::string, std::set<ParameterValue>>;

/// "50 µm", "50 µm and 100 µm", "50 µm to 100 µm" of more than three.
std::string values_text(const std::string& parameter, const std::set<ParameterValue>& values) {
  constexpr std::size_t kMostListed = 3;
  std::set<double> numbers{};
  std::vector<std::string> words{};
  for (const ParameterValue& value : values) {
    if (const auto* const number = std::get_if<double>(&value)) {
      numbers.insert(*number);
    } else if (const auto* const choice = std::get_if<std::string>(&value)) {
      std::string word = *choice;
      std::replace(word.begin(), word.end(), '_', ' ');
      words.push_back(std::move(word));
    }
  }
  const auto shown = [unit = unit_of_parameter(parameter)](double number) {
    return display_quantity(number, unit);
  };
  if (numbers.size() > kMostListed) {
    return shown(*numbers.begin()) + " to " + shown(*numbers.rbegin());
  }
  for (const double number : numbers) words.push_back(shown(number));
  return listed(words);
}

/// The parameters of a model that the stimuli of the protocol state, as values or by factors, or that its blocks vary.
std::set<std::string> stated_parameters(const ReportFacts& facts, const std::string& model) {
  std::set<std::string> stated{};
  if (!facts.file.protocol) return stated;
  const Protocol& protocol = *facts.file.protocol;
  for (const auto& [name, stimulus] : protocol.stimuli) {
    if (stimulus.model.value && *stimulus.model.value != model) continue;
    for (const auto& [parameter, value] : stimulus.parameters) stated.insert(parameter);
  }
  for (const auto& [name, block] : protocol.blocks) {
    if (block.vary) stated.insert(block.vary->parameter);
  }
  return stated;
}

/// Whether any of the values is not the declared default; true where no such parameter is declared.
bool differs_from_default(const ModelRegistry& models, const std::string& model,
                          const std::string& parameter, const std::set<ParameterValue>& values) {
  const ForceModel* const known = models.find(model);
  if (known == nullptr) return true;
  const std::vector<Parameter>& declared = known->declaration.parameters;
  const auto found =
      std::find_if(declared.begin(), declared.end(),
                   [&parameter](const Parameter& each) { return each.name == parameter; });
  return found == declared.end() || values != std::set<ParameterValue>{found->default_value};
}

constexpr const char* kFrictionLaw = "friction_law";

/// The law, where all models had the same one. Models share it, and readers compare it: it is stated whether or not it is
/// the default.
std::string common_friction(const ReportFacts& facts) {
  std::set<ParameterValue> laws{};
  for (const auto& [model, parameters] : facts.parameters) {
    const auto own = parameters.find(kFrictionLaw);
    if (own != parameters.end()) laws.insert(own->second.begin(), own->second.end());
  }
  if (laws.size() != 1) return {};
  return " The friction law was " + values_text(kFrictionLaw, laws) + '.';
}

/// "amplitude 50 µm, wavelength 2.5 mm"
std::string stated_values(const ReportFacts& facts, const std::string& model,
                          const RenderedValues& parameters) {
  const std::set<std::string> stated = stated_parameters(facts, model);
  const bool has_common_friction = !common_friction(facts).empty();
  std::vector<std::string> parts{};
  for (const auto& [name, values] : parameters) {
    const bool is_shown =
        name == kFrictionLaw ? !has_common_friction
                             : stated.contains(name) ||
                                   differs_from_default(facts.declared_models, model, name, values);
    if (!is_shown) continue;
    const std::string shown = values_text(name, values);
    if (!shown.empty()) parts.push_back(words_of_parameter(name) + ' ' + shown);
  }
  return comma_separated(parts);
}

}  // namespace

std::string paper_parameters(const ReportFacts& facts) {
  std::size_t with_parameters = 0;
  std::vector<std::pair<std::string, std::string>> of_models{};
  for (const auto& [model, parameters] : facts.parameters) {
    if (parameters.empty()) continue;
    ++with_parameters;
    std::string text = stated_values(facts, model, parameters);
    if (!text.empty()) of_models.emplace_back(model, std::move(text));
  }
  if (with_parameters == 0) return {};
  const std::string force_models = with_parameters == 1 ? "the force model" : "the force models";
  if (of_models.empty()) {
    return "All parameters of " + force_models +
           " had their default values, which the report of the study lists." +
           common_friction(facts);
  }
  std::string text = "The parameters of " + force_models + " were: ";
  for (const auto& [model, parameters] : of_models) {
    text += model == of_models.front().first ? "" : "; ";
    text += with_parameters == 1 ? parameters : model + " (" + parameters + ')';
  }
  return text +
         ". All others had their default values; the report of the study lists all parameters." +
         common_friction(facts);
}

ReportSection parameters_section(const ReportFacts& facts) {
  ReportSection section{"Force models", {}};
  ReportTable table{};
  table.is_reference = true;
  table.title = "Parameters of the force models, as rendered";
  table.columns = {{"force model", false}, {"parameter", false}, {"value", false}};
  for (const auto& [model, parameters] : facts.parameters) {
    for (const auto& [name, values] : parameters) {
      const std::string shown = values_text(name, values);
      if (!shown.empty()) table.rows.push_back({model, words_of_parameter(name), shown});
    }
  }
  table.note =
      "Of the surfaces in counted attempts. Parameters of laws that were not used are left "
      "out.";
  if (!table.rows.empty()) section.parts.emplace_back(std::move(table));
  return section;
}

}  // namespace asperity
