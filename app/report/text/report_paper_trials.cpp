// States practice, feedback, arrangement and order of the trials in the past tense.

#include "app/report/text/report_paper_trials.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/level_words.h"
#include "app/findings/outcome/task_words.h"
#include "app/report/text/report_arrangement.h"
#include "app/report/text/report_order.h"
#include "app/words/text_parts.h"
#include "protocols/design/block_factors.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

/// The main or the other blocks of the flow, each once.
std::vector<const Protocol::Block*> blocks_in_flow(const Protocol& protocol, bool is_main) {
  std::vector<const Protocol::Block*> blocks{};
  for (const Protocol::Step& step : protocol.flow) {
    const auto* const run = std::get_if<Protocol::Run>(&step);
    if (run == nullptr) continue;
    const Protocol::Block* const block = &protocol.blocks.at(run->block);
    if ((block->phase == Phase::main) != is_main) continue;
    if (std::find(blocks.begin(), blocks.end(), block) == blocks.end()) blocks.push_back(block);
  }
  return blocks;
}

/// " In these, the amplitude of the comparison differed from that of the standard by 45 % and 75 %."
std::string practised_levels(const Protocol::Block& block) {
  if (!block.vary || block.vary->levels().empty()) return {};
  return " In these, the " + words_of_parameter(block.vary->parameter) + " of the " +
         block.vary->role + ' ' + in_past(levels_text(block, "that of the standard")) + '.';
}

std::string paper_practice(const ReportFacts& facts) {
  const Protocol& protocol = *facts.file.protocol;
  const std::vector<const Protocol::Block*> blocks = blocks_in_flow(protocol, false);
  std::string text{};
  for (const Protocol::Block* const block : blocks) {
    const auto same_phase = std::count_if(blocks.begin(), blocks.end(), [&](const auto* other) {
      return other->phase == block->phase;
    });
    const std::string order =
        order_of_run(protocol, *block, *runs_of(protocol, *block).front(), Tense::past);
    text += ' ' + capitalised(text_of(block->phase)) + " trials " +
            (same_phase > 1 ? "of the block " + quoted(block->name) + ' ' : std::string()) +
            "were presented" + (order.empty() ? "" : ' ' + order) + feedback_text(*block) + '.' +
            practised_levels(*block) + presented_trials_text(*block, facts) +
            unmet_text(block->name, facts);
  }
  return text;
}

/// Feedback in the main blocks; of its absence where it could be expected.
std::string paper_feedback(const Protocol& protocol) {
  std::set<Protocol::Block::Feedback> given{};
  bool is_judged = false;
  for (const Protocol::Block* const block : blocks_in_flow(protocol, true)) {
    given.insert(block->feedback);
    is_judged = is_judged || judged_question(*block) != nullptr;
  }
  const bool is_practised_with = std::any_of(
      protocol.blocks.begin(), protocol.blocks.end(),
      [](const auto& each) { return each.second.feedback != Protocol::Block::Feedback::none; });
  if (given.size() != 1) return {};
  switch (*given.begin()) {
    case Protocol::Block::Feedback::none:
      return is_judged || is_practised_with ? " No feedback was given in the experimental trials."
                                            : std::string();
    case Protocol::Block::Feedback::correctness:
      return " After each experimental trial, the correctness of the response was shown.";
    case Protocol::Block::Feedback::correct_answer:
      return " After each experimental trial, the correct response was shown.";
  }
  return {};
}

}  // namespace

std::string paper_arrangement(const Protocol& protocol) {
  std::vector<std::pair<std::string, std::vector<std::string>>> arrangements{};  // text → blocks
  const std::vector<const Protocol::Block*> blocks = blocks_in_flow(protocol, true);
  for (const Protocol::Block* const block : blocks) {
    const std::string text = past_arrangement_sentences(*block);
    if (text.empty()) continue;
    auto known = std::find_if(arrangements.begin(), arrangements.end(),
                              [&text](const auto& each) { return each.first == text; });
    if (known == arrangements.end()) known = arrangements.insert(known, {text, {}});
    known->second.push_back(quoted(block->name));
  }
  std::string text{};
  for (const auto& [sentences, names] : arrangements) {
    if (!text.empty()) text += ' ';
    if (names.size() < blocks.size()) {
      text += (names.size() == 1 ? "In the block " : "In the blocks ") + listed(names) + ": ";
    }
    text += sentences;
  }
  return text;
}

std::string paper_order(const ReportFacts& facts, Sources& sources) {
  const Protocol& protocol = *facts.file.protocol;
  std::string text = planned_trials_text(facts);
  // Every order with its blocks, as they are run.
  std::vector<std::pair<std::string, std::vector<std::string>>> orders{};
  std::size_t runs = 0;
  for (const Protocol::Step& step : protocol.flow) {
    const auto* run = std::get_if<Protocol::Run>(&step);
    if (run == nullptr) continue;
    const Protocol::Block& block = protocol.blocks.at(run->block);
    if (block.phase != Phase::main) continue;
    ++runs;
    const std::string order = order_of_run(protocol, block, *run, Tense::past);
    if (order.empty()) continue;
    auto known = std::find_if(orders.begin(), orders.end(),
                              [&order](const auto& each) { return each.first == order; });
    if (known == orders.end()) known = orders.insert(known, {order, {}});
    const std::string name = quoted(run->block);
    if (std::find(known->second.begin(), known->second.end(), name) == known->second.end()) {
      known->second.push_back(name);
    }
  }
  for (const auto& [order, blocks] : orders) {
    text += (text.empty() ? "" : " ") +
            (runs == 1 ? "Trials were"
             : orders.size() == 1
                 ? "In each block, trials were"
                 : std::string(blocks.size() == 1 ? "In the block " : "In the blocks ") +
                       listed(blocks) + ", trials were") +
            " presented " + order + '.';
  }
  switch (protocol.counterbalance) {
    case Protocol::Counterbalance::none:
      break;
    case Protocol::Counterbalance::latin:
      text += " The order of the levels was counterbalanced by a Latin square.";
      break;
    case Protocol::Counterbalance::williams:
      text += " The order of the levels was counterbalanced by a Williams square" +
              cited("Williams 1949", sources) + '.';
      break;
  }
  for (const auto& [name, exploration] : protocol.explorations) {
    text += (protocol.explorations.size() == 1 ? " Each" : " Exploration “" + name + "”: each") +
            std::string(" stimulus was to be explored ") + instructed_exploration(exploration) +
            "; " + after_failure(exploration) + '.';
  }
  text += paper_practice(facts);
  text += paper_feedback(protocol);
  return text;
}

}  // namespace asperity
