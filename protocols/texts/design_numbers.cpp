// Counts what a trial and a session of a protocol contain.

#include "protocols/texts/design_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <variant>

#include "protocols/design/block_factors.h"
#include "protocols/plan/course.h"
#include "protocols/plan/groups.h"
#include "protocols/plan/plan_parts.h"

namespace asperity {

namespace {

using Block = Protocol::Block;
using QuestionTemplate = Protocol::TrialQuestionTemplate;

constexpr double kMinute_s = 60.0;
constexpr int kRoundedFrom_min = 15;
constexpr int kRoundedTo_min = 5;

/// The one number that all questions with such a number have.
template <class Count>
std::optional<int> agreed(const Block& block, const Count& count) {
  std::optional<int> number{};
  for (const QuestionTemplate& question : block.questions) {
    if (question.is_additional) continue;  // the numbers are those of the block's own question
    const int here = count(question);
    if (here == 0) continue;
    if (number && *number != here) return {};
    number = here;
  }
  return number;
}

int options_of(const Block& block, const QuestionTemplate& question) {
  if (!has_options(question.form)) return 0;
  if (!question.options.empty()) return static_cast<int>(question.options.size());
  if (!question.pictures.empty()) return static_cast<int>(question.pictures.size());
  return static_cast<int>(surfaces_in_trial(block)) +
         (question.own_as<PairQuestion>() == nullptr ? 0 : 1);
}

int rounded_minutes(double total_s) {
  const int minutes = std::max(1, static_cast<int>(std::ceil(total_s / kMinute_s)));
  if (minutes < kRoundedFrom_min) return minutes;
  return (minutes + kRoundedTo_min - 1) / kRoundedTo_min * kRoundedTo_min;
}

}  // namespace

const DesignNumber* find_design_number(std::string_view name) noexcept {
  const auto* const found =
      std::find_if(kDesignNumbers.begin(), kDesignNumbers.end(),
                   [name](const DesignNumber& each) { return each.name == name; });
  return found == kDesignNumbers.end() ? nullptr : &*found;
}

Phrase noun_of(const DesignNumber& number) {
  // For the nominative and the genitive of other languages, without an article.
  static const std::map<std::string_view, Phrase> kNouns{
      {"surfaces", phrase("Protocols", "surfaces")},
      {"surface_names", phrase("Protocols", "surface_names")},
      {"questions", phrase("Protocols", "questions")},
      {"scales", phrase("Protocols", "scales")},
      {"options", phrase("Protocols", "options")},
      {"pictures", phrase("Protocols", "pictures")},
      {"trials", phrase("Protocols", "trials")},
      {"practice_trials", phrase("Protocols", "trials of practice")},
      {"blocks", phrase("Protocols", "blocks")},
      {"breaks", phrase("Protocols", "breaks")},
      {"minutes", phrase("Protocols", "minutes")}};
  return kNouns.at(number.name);
}

DesignValues values_of_block(const Protocol& protocol, const Block& block) {
  if (block.design() == nullptr) return {};  // of a stored protocol: that of another version
  DesignValues values{};
  const auto set = [&values](const char* name, std::optional<int> number) {
    if (number && *number > 0) values[name].number = *number;
  };
  const auto surfaces = static_cast<int>(surfaces_in_trial(block));
  set("surfaces", surfaces);
  for (char name = 'A'; name < 'A' + surfaces; ++name) {
    values["surface_names"].names.emplace_back(1, name);
  }
  set("questions", static_cast<int>(block.questions.size()));
  set("scales", static_cast<int>(std::count_if(
                    block.questions.begin(), block.questions.end(), [](const auto& question) {
                      return std::holds_alternative<ScaleForm>(question.form);
                    })));
  set("options", agreed(block, [&](const auto& each) { return options_of(block, each); }));
  const bool has_pictures = std::any_of(block.questions.begin(), block.questions.end(),
                                        [](const auto& each) { return !each.pictures.empty(); });
  if (has_pictures) {
    set("pictures",
        agreed(block, [](const auto& each) { return static_cast<int>(each.pictures.size()); }));
  } else if (protocol.realism_standard == RealismStandard::photograph) {
    set("pictures", 1);
  }
  return values;
}

DesignValues values_of_all_blocks(const Protocol& protocol) {
  const bool has_main =
      std::any_of(protocol.blocks.begin(), protocol.blocks.end(),
                  [](const auto& named) { return named.second.phase == Phase::main; });
  DesignValues common{};
  std::set<std::string> different{};
  for (const auto& [block_name, block] : protocol.blocks) {
    if (has_main && block.phase != Phase::main) continue;
    if (block.design() == nullptr) return {};
    for (const auto& [name, value] : values_of_block(protocol, block)) {
      const auto [known, is_new] = common.emplace(name, value);
      if (is_new) continue;
      if (known->second.number != value.number || known->second.names != value.names) {
        different.insert(name);
      }
    }
  }
  std::erase_if(common, [&different](const auto& each) { return different.contains(each.first); });
  return common;
}

bool has_known_breaks(const Protocol& protocol) {
  bool has_breaks = false;
  for (const Protocol::Step& step : protocol.flow) {
    if (std::holds_alternative<Protocol::Break>(step)) has_breaks = true;
    const auto* const run = std::get_if<Protocol::Run>(&step);
    if (run == nullptr || !run->pause) continue;
    has_breaks = true;
    if (run->break_every_contact_s > 0.0) return false;
    const auto block = protocol.blocks.find(run->block);
    if (block == protocol.blocks.end()) continue;
    if (run->break_every_trials > 0 && has_variable_length(block->second)) return false;
  }
  return has_breaks;
}

DesignValues values_of_session(const Protocol& protocol, const Plan& example) {
  DesignValues values = values_of_all_blocks(protocol);
  double total_s = cost_of(protocol, example).total_s;
  bool can_be_shorter = false;
  DesignValue blocks{};
  DesignValue trials{};
  DesignValue practised{};
  for (const PlannedRun& run : runs_in(protocol, parts_of(protocol, example))) {
    const std::optional<int> most = run.most_trials;
    const bool is_main = run.block->phase == Phase::main;
    DesignValue& sum = is_main ? trials : practised;
    sum.number += most.value_or(run.trials);
    sum.is_largest = sum.is_largest || most.has_value();
    if (is_main) ++blocks.number;
    if (!most) continue;
    can_be_shorter = true;
    total_s += (*most - run.trials) * run.duration_s / run.trials;
  }
  if (blocks.number > 0) values["blocks"] = blocks;
  if (trials.number > 0) values["trials"] = trials;
  if (practised.number > 0) values["practice_trials"] = practised;
  values["minutes"] = {.number = rounded_minutes(total_s), .is_largest = can_be_shorter};
  if (has_known_breaks(protocol)) {
    values["breaks"].number = static_cast<int>(std::count_if(
        example.steps.begin(), example.steps.end(),
        [](const PlanStep& step) { return std::holds_alternative<Protocol::Break>(step); }));
  }
  return values;
}

DesignValues values_of_every_session(const Protocol& protocol) {
  std::vector<std::string> groups = groups_of(protocol);
  if (groups.empty()) groups.emplace_back();
  std::optional<DesignValues> common{};
  for (const std::string& group : groups) {
    for (int row = 0; row < counterbalance_rows(protocol); ++row) {
      const DesignValues values = values_of_session(
          protocol, example_plan(protocol, {.seed = 1, .counterbalance_row = row, .group = group}));
      if (!common) common = values;
      std::erase_if(*common, [&](const auto& each) { return !values.contains(each.first); });
      for (auto& [name, value] : *common) {
        const DesignValue& other = values.at(name);
        value.is_largest = value.is_largest || other.is_largest || other.number != value.number;
        value.number = std::max(value.number, other.number);
      }
    }
  }
  return common.value_or(DesignValues{});
}

}  // namespace asperity
