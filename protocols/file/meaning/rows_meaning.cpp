// Implements the checks of the combinations of a block: excluded ones, derived levels, repetitions, places in the order.

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "protocols/design/arithmetic.h"
#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/trial_order.h"

namespace asperity {

using Block = Protocol::Block;

namespace {

std::string text_of_levels(const FactorLevels& levels) {
  std::string text{};
  for (const auto& [name, level] : levels) {
    text += (text.empty() ? "" : ", ") + name + " " + text_of(level);
  }
  return text;
}

std::string trials_text(std::size_t trials) {
  return std::to_string(trials) + (trials == 1 ? " trial" : " trials");
}

/// Whether every row of the block has a level of the factor that is not computed.
bool is_row_factor(const Block& block, const std::string& factor) {
  return std::find(block.crossed.begin(), block.crossed.end(), factor) != block.crossed.end() ||
         (!block.listed.empty() &&
          std::all_of(block.listed.begin(), block.listed.end(),
                      [&factor](const FactorLevels& row) { return row.contains(factor); })) ||
         (block.vary && !block.procedure && block.vary->factor == factor);
}

/// Reports factors and levels that the rows of the block do not have.
bool check_row_levels(CheckedDocument& checked, const Block& block, const FactorLevels& levels,
                      const std::string& pointer) {
  bool is_valid = true;
  for (const auto& [factor, level] : levels) {
    const std::string at = pointer_to(pointer, factor);
    if (!check_level(checked, factor, level, at)) {
      is_valid = false;
    } else if (!is_row_factor(block, factor)) {
      checked.report_key(at, "the block neither crosses, lists nor varies the factor " +
                                 in_quotes(factor) + "; cross or list it, or remove this key");
      is_valid = false;
    }
  }
  return is_valid;
}

void check_derived(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  const auto& stated = checked.document.root().at("blocks").at(block.name);
  const auto& declared = checked.document.root();
  for (const auto& [name, formula] : block.derived) {
    const std::string at = pointer_to(pointer + "/derived", name);
    if (declared.contains("factors") && declared.at("factors").contains(name)) {
      checked.report_key(
          at, "the factor " + in_quotes(name) +
                  " is declared with levels and cannot be computed; use another name, or "
                  "remove it from factors");
      continue;
    }
    const auto parsed = Arithmetic::parse(formula);
    if (const auto* const problem = std::get_if<ArithmeticProblem>(&parsed)) {
      checked.report(at, "the formula cannot be read: " + problem->text + "; correct it");
      continue;
    }
    bool is_computable = true;
    for (const std::string& used : std::get<Arithmetic>(parsed).names()) {
      if (block.derived.contains(used)) {
        checked.report(at, in_quotes(used) + " is itself computed; write its formula here instead");
        is_computable = false;
      } else if (!checked.protocol.factors.contains(used)) {
        checked.report(at, unknown_name("factor", used, checked.protocol.factors));
        is_computable = false;
      } else if (!is_row_factor(block, used)) {
        checked.report(at, "the block neither crosses, lists nor varies the factor " +
                               in_quotes(used) +
                               "; cross or list it, or use another factor in the formula");
        is_computable = false;
      } else {
        const std::vector<Level>& levels = checked.protocol.factors.at(used).levels;
        const auto is_name = [](const Level& level) {
          return std::holds_alternative<std::string>(level);
        };
        if (std::any_of(levels.begin(), levels.end(), is_name)) {
          checked.report(at,
                         "the levels of the factor " + in_quotes(used) +
                             " are names, and a formula needs numbers; use a factor with numbers");
          is_computable = false;
        }
      }
    }
    if (!is_computable || stated.contains("procedure")) continue;
    for (const BlockRow& row : rows_of(checked.protocol, block)) {
      if (row.factors.contains(name)) continue;
      FactorLevels levels = row.factors;
      std::erase_if(levels, [&](const auto& each) { return block.derived.contains(each.first); });
      checked.report(at, "the formula has no finite value for " + text_of_levels(levels) +
                             "; exclude this combination, or change the formula or a level");
      break;
    }
  }
}

void check_repetitions_of(CheckedDocument& checked, const Block& block,
                          const std::vector<BlockRow>& rows, const std::string& pointer) {
  const std::string place = pointer + "/repetitions_of";
  if (block.repetitions_of.empty()) return;
  if (block.order == Block::Order::shuffle_within_repetition) {
    checked.report(
        pointer + "/order",
        "with unequal repetitions the repetitions do not have the same trials; use \"shuffle\", "
        "or remove repetitions_of");
  }
  std::vector<std::size_t> matches(rows.size());
  for (std::size_t i = 0; i < block.repetitions_of.size(); ++i) {
    const std::string at = pointer_to(place, i);
    const FactorLevels& levels = block.repetitions_of[i].levels;
    if (!check_row_levels(checked, block, levels, at + "/levels")) continue;
    bool has_row = false;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (!has_levels(rows[row].factors, levels)) continue;
      has_row = true;
      if (++matches[row] != 2) continue;
      checked.report(at + "/levels",
                     "the combination " + text_of_levels(rows[row].factors) +
                         " already has repetitions by an earlier entry; make the entries "
                         "exclude each other");
      break;
    }
    if (!has_row) {
      checked.report(at + "/levels",
                     "no combination has " + text_of_levels(levels) + "; remove this entry");
    }
  }
}

void check_places(CheckedDocument& checked, const Block& block, const std::vector<BlockRow>& rows,
                  const std::vector<BlockTrial>& trials, const std::string& pointer) {
  for (const auto& [factor, minimum] : block.minimum_distance) {
    std::map<Level, std::size_t> counts{};
    for (const BlockTrial& trial : trials) ++counts[rows[trial.row].factors.at(factor)];
    for (const auto& [level, count] : counts) {
      const std::size_t needed = (count - 1) * static_cast<std::size_t>(minimum) + 1;
      if (needed <= trials.size()) continue;
      checked.report(pointer_to(pointer + "/minimum_distance", factor),
                     "the level " + in_quotes(text_of(level)) + " has " + trials_text(count) +
                         ", which at a distance of " + std::to_string(minimum) + " need " +
                         std::to_string(needed) + " positions, but the block has " +
                         trials_text(trials.size()) +
                         "; reduce the distance or the repetitions, or add other levels");
      break;
    }
  }
  std::set<int> positions{};
  std::map<std::string, std::size_t> wanted{};
  for (std::size_t i = 0; i < block.fixed_positions.size(); ++i) {
    const auto& [position, levels] = block.fixed_positions[i];
    const std::string at = pointer_to(pointer + "/fixed_positions", i);
    if (static_cast<std::size_t>(position) > trials.size()) {
      checked.report(at + "/position", "the block has " + trials_text(trials.size()) +
                                           "; state a position from 1 to " +
                                           std::to_string(trials.size()));
    } else if (!positions.insert(position).second) {
      checked.report(at + "/position",
                     "the position " + std::to_string(position) +
                         " is already fixed by an earlier entry; remove one of them");
    }
    const auto available = static_cast<std::size_t>(
        std::count_if(trials.begin(), trials.end(), [&, &own = levels](const BlockTrial& trial) {
          return has_levels(rows[trial.row].factors, own);
        }));
    if (++wanted[text_of_levels(levels)] > available) {
      checked.report(at + "/levels",
                     available == 0
                         ? "no trial has " + text_of_levels(levels) + "; correct the levels"
                         : "only " + trials_text(available) + " have " + text_of_levels(levels) +
                               ", and more positions require them; remove entries, or raise "
                               "the repetitions");
    }
  }
}

/// The largest and the smallest part of the pairs: all others have as many trials as one of them, with the same levels of the
/// other factors. The only part, where the block has no parts.
std::vector<std::vector<BlockRow>> extreme_parts(CheckedDocument& checked, const Block& block) {
  std::vector<std::vector<BlockRow>> parts{rows_of_part(checked.protocol, block, 0)};
  if (block.all_pairs && block.all_pairs->parts > 1) {
    parts.push_back(rows_of_part(checked.protocol, block,
                                 static_cast<std::size_t>(block.all_pairs->parts) - 1));
  }
  return parts;
}

void check_balance(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  for (const std::vector<BlockRow>& rows : extreme_parts(checked, block)) {
    const std::size_t trials = trials_of(block, rows).size();
    const std::size_t surfaces = surfaces_in_trial(block);
    if (trials % surfaces == 0) continue;
    checked.report(pointer + "/positions",
                   "balanced positions need a multiple of " + std::to_string(surfaces) +
                       " trials, the number of surfaces, but the block has " +
                       std::to_string(trials) +
                       "; change the number of repetitions or of levels, or remove positions");
    return;
  }
}

void check_possible_order(CheckedDocument& checked, const Block& block,
                          const std::vector<BlockRow>& rows, const std::vector<BlockTrial>& trials,
                          const std::string& pointer) {
  const OrderProblem whole = order_problem(block, rows, trials);
  const bool is_fixed = block.order == Block::Order::fixed;
  const auto can_be_met = [is_fixed](const OrderProblem& problem) {
    if (!is_fixed) return some_order(problem).has_value();
    std::vector<std::size_t> order(problem.trials);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    return meets(problem, order);
  };
  if (can_be_met(whole)) return;
  OrderProblem limits = whole;
  limits.distances.clear();
  limits.places.clear();
  OrderProblem distances = whole;
  distances.limits.clear();
  distances.places.clear();
  const std::string key = !can_be_met(limits)      ? "maximum_in_a_row"
                          : !can_be_met(distances) ? "minimum_distance"
                          : whole.places.empty()   ? "minimum_distance"
                                                   : "fixed_positions";
  const bool is_alone = (whole.limits.empty() ? 0 : 1) + (whole.distances.empty() ? 0 : 1) +
                            (whole.places.empty() ? 0 : 1) ==
                        1;
  const std::string with_others =
      is_alone || key == "maximum_in_a_row" ? "" : " together with the other constraints";
  if (is_fixed) {
    checked.report(pointer + "/" + key, "the fixed order of this block violates " + key +
                                            "; use \"shuffle\" or write the rows in another order");
    return;
  }
  checked.report(pointer + "/" + key,
                 "no order of the block's " + std::to_string(whole.trials) + " trials satisfies " +
                     key + with_others +
                     (key == "maximum_in_a_row" ? "; allow more in a row, or add other levels"
                      : key == "minimum_distance"
                          ? "; reduce the distance, or add other levels"
                          : "; free some of the positions, or relax the other constraints"));
}

void check_constraints(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  if (block.maximum_in_a_row.empty() && block.minimum_distance.empty() &&
      block.fixed_positions.empty()) {
    return;
  }
  for (std::size_t i = 0; i < block.fixed_positions.size(); ++i) {
    if (!check_row_levels(checked, block, block.fixed_positions[i].levels,
                          pointer_to(pointer + "/fixed_positions", i) + "/levels")) {
      return;
    }
  }
  // A repetition of unequal ones is not a group of trials; reported with the order.
  if (!block.repetitions_of.empty() && block.order == Block::Order::shuffle_within_repetition) {
    return;
  }
  const std::size_t before = checked.found().size();
  for (const std::vector<BlockRow>& rows : extreme_parts(checked, block)) {
    const std::vector<BlockTrial> trials = trials_of(block, rows);
    check_places(checked, block, rows, trials, pointer);
    if (checked.found().size() == before)
      check_possible_order(checked, block, rows, trials, pointer);
    if (checked.found().size() > before) return;
  }
}

}  // namespace

void check_rows(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  check_derived(checked, block, pointer);
  const auto known = [&checked](const std::string& name) {
    return checked.protocol.factors.contains(name);
  };
  if (!std::all_of(block.crossed.begin(), block.crossed.end(), known)) return;
  if (block.all_pairs && !known(block.all_pairs->factor)) return;
  Block all = block;
  all.exclude.clear();
  if (row_count(checked.protocol, all) > kMaximumRows)
    return;  // reported with the number of trials
  const std::vector<BlockRow> rows = rows_of(checked.protocol, all);
  for (std::size_t i = 0; i < block.exclude.size(); ++i) {
    const std::string at = pointer_to(pointer + "/exclude", i);
    if (block.crossed.empty() && !block.vary) {
      checked.report_key(
          pointer + "/exclude",
          "only combinations of crossed or varied levels are excluded; remove the trials "
          "from listed, or cross factors");
      break;
    }
    if (!check_row_levels(checked, block, block.exclude[i], at)) continue;
    if (std::none_of(rows.begin(), rows.end(), [&](const BlockRow& row) {
          return has_levels(row.factors, block.exclude[i]);
        })) {
      checked.report(
          at, "no combination has " + text_of_levels(block.exclude[i]) + "; remove this entry");
    }
  }
  if (!block.exclude.empty() && !rows.empty() && rows_of(checked.protocol, block).empty()) {
    checked.report(pointer + "/exclude", "all combinations are excluded; remove entries");
  }
  check_repetitions_of(checked, block, rows_of(checked.protocol, block), pointer);
}

void check_order(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  for (const auto& [key, factors] : {std::pair("maximum_in_a_row", &block.maximum_in_a_row),
                                     std::pair("minimum_distance", &block.minimum_distance)}) {
    for (const auto& [factor, number] : *factors) {
      const std::string at = pointer_to(pointer + "/" + key, factor);
      if (!checked.protocol.factors.contains(factor)) {
        checked.report_key(at, unknown_name("factor", factor, checked.protocol.factors));
        return;
      }
      const bool is_varied = block.vary && block.vary->factor == factor;
      if (!is_varied && !is_row_factor(block, factor)) {
        checked.report_key(at,
                           std::string(key) +
                               " applies only to factors that the block crosses, lists or varies; "
                               "cross or list this one, or remove this key");
        return;
      }
    }
  }
  const auto known = [&checked](const std::string& name) {
    return checked.protocol.factors.contains(name);
  };
  if (!std::all_of(block.crossed.begin(), block.crossed.end(), known)) return;
  if (block.all_pairs && !known(block.all_pairs->factor)) return;
  const std::size_t rows = row_count(checked.protocol, block);
  if (rows == 0)
    return;  // a factor or a dimension without levels, or no combination; reported there
  // A procedure determines the number of trials, also one that was refused.
  const bool has_procedure =
      checked.document.root().at("blocks").at(block.name).contains("procedure");
  const std::size_t trials = trial_count(checked.protocol, block);
  if (block.has_anchor_at(AnchorPlace::middle) && !has_procedure && trials < 2) {
    checked.report(pointer + "/anchor_at",
                   "a block with one trial has no middle; remove \"middle\"");
  }
  if (trials > kMaximumTrials) {
    checked.report(
        pointer,
        "this block has more than " + std::to_string(kMaximumTrials) +
            " trials, too many for a participant; reduce the number of repetitions or of levels");
    return;
  }
  if (block.until && !has_procedure &&
      trials < static_cast<std::size_t>(block.until->maximum_trials)) {
    checked.report(
        pointer + "/until/maximum_trials",
        "up to " + std::to_string(block.until->maximum_trials) +
            " trials may be needed, but the block has " + std::to_string(trials) + "; with " +
            std::to_string(rows) + " per repetition, set repetitions to " +
            std::to_string((static_cast<std::size_t>(block.until->maximum_trials) + rows - 1) /
                           rows));
  }
  if (block.positions == Block::Positions::balanced && !block.until && !has_procedure) {
    check_balance(checked, block, pointer);
  }
  if (!has_procedure) check_constraints(checked, block, pointer);
}

}  // namespace asperity
