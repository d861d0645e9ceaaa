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

Phrase trials_text(std::size_t trials) {
  return (trials == 1 ? phrase("Protocols", "%1 trial") : phrase("Protocols", "%1 trials"))
      .with(std::to_string(trials));
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
      checked.report_key(at, phrase("Protocols",
                                    "the block neither crosses, lists nor varies the factor %1; "
                                    "cross or list it, or remove this key")
                                 .with(in_quotes(factor)));
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
          at, phrase("Protocols",
                     "the factor %1 is declared with levels and cannot be computed; use another "
                     "name, or remove it from %2")
                  .with(in_quotes(name), key_name("factors")));
      continue;
    }
    const auto parsed = Arithmetic::parse(formula);
    if (const auto* const problem = std::get_if<ArithmeticProblem>(&parsed)) {
      checked.report(
          at,
          phrase("Protocols", "the formula cannot be read: %1; correct it").with(problem->text));
      continue;
    }
    bool is_computable = true;
    for (const std::string& used : std::get<Arithmetic>(parsed).names()) {
      if (block.derived.contains(used)) {
        checked.report(at,
                       phrase("Protocols", "%1 is itself computed; write its formula here instead")
                           .with(in_quotes(used)));
        is_computable = false;
      } else if (!checked.protocol.factors.contains(used)) {
        checked.report(at, unknown_name("factor", used, checked.protocol.factors));
        is_computable = false;
      } else if (!is_row_factor(block, used)) {
        checked.report(at, phrase("Protocols",
                                  "the block neither crosses, lists nor varies the factor %1; "
                                  "cross or list it, or use another factor in the formula")
                               .with(in_quotes(used)));
        is_computable = false;
      } else {
        const std::vector<Level>& levels = checked.protocol.factors.at(used).levels;
        const auto is_name = [](const Level& level) {
          return std::holds_alternative<std::string>(level);
        };
        if (std::any_of(levels.begin(), levels.end(), is_name)) {
          checked.report(at, phrase("Protocols",
                                    "the levels of the factor %1 are names, and a formula needs "
                                    "numbers; use a factor with numbers")
                                 .with(in_quotes(used)));
          is_computable = false;
        }
      }
    }
    if (!is_computable || stated.contains("procedure")) continue;
    for (const BlockRow& row : rows_of(checked.protocol, block)) {
      if (row.factors.contains(name)) continue;
      FactorLevels levels = row.factors;
      std::erase_if(levels, [&](const auto& each) { return block.derived.contains(each.first); });
      checked.report(at, phrase("Protocols",
                                "the formula has no finite value for %1; exclude this combination, "
                                "or change the formula or a level")
                             .with(text_of_levels(levels)));
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
        phrase("Protocols",
               "with unequal repetitions the repetitions do not have the same trials; use %1, or "
               "remove %2")
            .with(word_name("shuffle"), key_name("repetitions_of")));
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
                     phrase("Protocols",
                            "the combination %1 already has repetitions by an earlier entry; make "
                            "the entries exclude each other")
                         .with(text_of_levels(rows[row].factors)));
      break;
    }
    if (!has_row) {
      checked.report(at + "/levels", phrase("Protocols", "no combination has %1; remove this entry")
                                         .with(text_of_levels(levels)));
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
      checked.report(
          pointer_to(pointer + "/minimum_distance", factor),
          phrase("Protocols",
                 "the level %1 has %2, which at a distance of %3 need %4 positions, but "
                 "the block has %5; reduce the distance or the repetitions, or add "
                 "other levels")
              .with(in_quotes(text_of(level)), trials_text(count), std::to_string(minimum),
                    std::to_string(needed), trials_text(trials.size())));
      break;
    }
  }
  std::set<int> positions{};
  std::map<std::string, std::size_t> wanted{};
  for (std::size_t i = 0; i < block.fixed_positions.size(); ++i) {
    const auto& [position, levels] = block.fixed_positions[i];
    const std::string at = pointer_to(pointer + "/fixed_positions", i);
    if (static_cast<std::size_t>(position) > trials.size()) {
      checked.report(at + "/position",
                     phrase("Protocols", "the block has %1; state a position from 1 to %2")
                         .with(trials_text(trials.size()), std::to_string(trials.size())));
    } else if (!positions.insert(position).second) {
      checked.report(at + "/position",
                     phrase("Protocols",
                            "the position %1 is already fixed by an earlier entry; remove one of "
                            "them")
                         .with(std::to_string(position)));
    }
    const auto available = static_cast<std::size_t>(
        std::count_if(trials.begin(), trials.end(), [&, &own = levels](const BlockTrial& trial) {
          return has_levels(rows[trial.row].factors, own);
        }));
    if (++wanted[text_of_levels(levels)] > available) {
      checked.report(at + "/levels",
                     available == 0
                         ? phrase("Protocols", "no trial has %1; correct the levels")
                               .with(text_of_levels(levels))
                         : phrase("Protocols",
                                  "only %1 have %2, and more positions require them; remove "
                                  "entries, or raise the repetitions")
                               .with(trials_text(available), text_of_levels(levels)));
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
    checked.report(
        pointer + "/positions",
        phrase("Protocols",
               "balanced positions need a multiple of %1 trials, the number of "
               "surfaces, but the block has %2; change the number of repetitions or of "
               "levels, or remove %3")
            .with(std::to_string(surfaces), std::to_string(trials), key_name("positions")));
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
  if (is_fixed) {
    checked.report(pointer + "/" + key,
                   phrase("Protocols",
                          "the fixed order of this block violates %1; use %2 or write the rows in "
                          "another order")
                       .with(key_name(key), word_name("shuffle")));
    return;
  }
  const Phrase problem =
      (is_alone || key == "maximum_in_a_row"
           ? phrase("Protocols", "no order of the block's %1 trials satisfies %2")
           : phrase("Protocols",
                    "no order of the block's %1 trials satisfies %2 together with the other "
                    "constraints"))
          .with(std::to_string(whole.trials), key_name(key));
  checked.report(
      pointer + "/" + key,
      (key == "maximum_in_a_row"
           ? phrase("Protocols", "%1; allow more in a row, or add other levels")
       : key == "minimum_distance"
           ? phrase("Protocols", "%1; reduce the distance, or add other levels")
           : phrase("Protocols", "%1; free some of the positions, or relax the other constraints"))
          .with(problem));
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
          phrase("Protocols",
                 "only combinations of crossed or varied levels are excluded; remove the trials "
                 "from %1, or cross factors")
              .with(key_name("listed")));
      break;
    }
    if (!check_row_levels(checked, block, block.exclude[i], at)) continue;
    if (std::none_of(rows.begin(), rows.end(), [&](const BlockRow& row) {
          return has_levels(row.factors, block.exclude[i]);
        })) {
      checked.report(at, phrase("Protocols", "no combination has %1; remove this entry")
                             .with(text_of_levels(block.exclude[i])));
    }
  }
  if (!block.exclude.empty() && !rows.empty() && rows_of(checked.protocol, block).empty()) {
    checked.report(pointer + "/exclude",
                   phrase("Protocols", "all combinations are excluded; remove entries"));
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
        checked.report_key(at, phrase("Protocols",
                                      "%1 applies only to factors that the block crosses, lists or "
                                      "varies; cross or list this one, or remove this key")
                                   .with(key_name(key)));
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
                   phrase("Protocols", "a block with one trial has no middle; remove %1")
                       .with(word_name("middle")));
  }
  if (trials > kMaximumTrials) {
    checked.report(
        pointer,
        phrase("Protocols",
               "this block has more than %1 trials, too many for a participant; reduce the number "
               "of repetitions or of levels")
            .with(std::to_string(kMaximumTrials)));
    return;
  }
  if (block.until && !has_procedure &&
      trials < static_cast<std::size_t>(block.until->maximum_trials)) {
    checked.report(
        pointer + "/until/maximum_trials",
        phrase("Protocols",
               "up to %1 trials may be needed, but the block has %2; with %3 per repetition, set "
               "%4 to %5")
            .with(std::to_string(block.until->maximum_trials), std::to_string(trials),
                  std::to_string(rows), key_name("repetitions"),
                  std::to_string(
                      (static_cast<std::size_t>(block.until->maximum_trials) + rows - 1) / rows)));
  }
  if (block.positions == Block::Positions::balanced && !block.until && !has_procedure) {
    check_balance(checked, block, pointer);
  }
  if (!has_procedure) check_constraints(checked, block, pointer);
}

}  // namespace asperity
