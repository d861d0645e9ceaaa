// Collects the parameters of all response tables as assumptions, and requires a value for each.

#include "app/power/power_model.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "app/power/power_tables.h"
#include "protocols/design/wording.h"
#include "protocols/plan/groups.h"
#include "protocols/plan/plan.h"

namespace asperity {

namespace {

const Assumption* find_assumption(const std::vector<Assumption>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&name](const auto& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::string problem_with(const Assumption& needed, const Assumption* stated) {
  if (stated == nullptr) return needed.name + " is missing";
  if (!stated->value) {
    return needed.name + " has no value (" + needed.meaning.english() + ", in the unit \"" +
           needed.unit + "\")";
  }
  if (!is_in_range(needed.range, *stated->value)) {
    return needed.name + " is " + digits(*stated->value) + ", and must be " + text_of(needed.range);
  }
  if (stated->source.empty()) return needed.name + " has no source";
  return {};
}

/// Throws where the assumptions are not exactly those of the protocol, with values.
void check_assumptions(const std::vector<Assumption>& needed,
                       const std::vector<Assumption>& stated) {
  std::string problems{};
  const auto add = [&problems](const std::string& problem) {
    if (!problem.empty()) problems += (problems.empty() ? "" : "; ") + problem;
  };
  for (const Assumption& each : needed) {
    add(problem_with(each, find_assumption(stated, each.name)));
  }
  for (const Assumption& each : stated) {
    if (find_assumption(needed, each.name) != nullptr) continue;
    add("the protocol has no assumption " + each.name);
  }
  if (problems.empty()) return;
  throw std::runtime_error(
      "the studies cannot be simulated with these assumptions: " + problems +
      ". State each of them with its source: effects with --effect, everything with --assumptions");
}

}  // namespace

std::vector<Assumption> assumptions_of(const Protocol& protocol) {
  std::vector<Assumption> all{};
  for (const auto& [name, block] : tabulated_blocks(protocol)) {
    for (const TabulatedBlock::OfQuestion& question : block.questions) {
      for (ResponseParameter& parameter : question.table->parameters(question.asked)) {
        all.push_back({.name = assumption_name(question.asked, parameter.name),
                       .part = parameter.part,
                       .value = parameter.value,
                       .unit = std::move(parameter.unit),
                       .source = parameter.value ? kAssumed : "",
                       .meaning = std::move(parameter.meaning),
                       .null_value = parameter.null_value,
                       .tests = std::move(parameter.tests),
                       .range = parameter.range});
      }
    }
  }
  return all;
}

int participants_per_round(const Protocol& protocol) {
  const auto groups = static_cast<int>(groups_of(protocol).size());
  return counterbalance_rows(protocol) * std::max(groups, 1);
}

PowerModel::PowerModel(const Protocol& protocol, std::vector<Assumption> assumptions)
    : assumptions_(std::move(assumptions)) {
  check_assumptions(assumptions_of(protocol), assumptions_);
  tables_ = std::make_shared<const PowerTables>(protocol, assumptions_);
}

const Protocol& PowerModel::protocol() const noexcept { return tables_->protocol; }

PowerModel PowerModel::at_null() const {
  std::vector<Assumption> without_effects = assumptions_;
  for (Assumption& assumption : without_effects) {
    if (assumption.part != Assumption::Part::effect) continue;
    assumption.value = assumption.null_value;
    assumption.source = kNoEffect;
  }
  return {protocol(), std::move(without_effects)};
}

}  // namespace asperity
