// Describes runs, breaks, criteria and feedback in the order of the flow.

#include "app/report/text/report_order.h"

#include <algorithm>
#include <set>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/report/text/report_sections.h"
#include "app/words/text_parts.h"
#include "protocols/design/block_factors.h"

namespace asperity {

namespace {

/// "in random order"; empty where a procedure chooses the level of every trial from the responses.
std::string order_of_levels(const Protocol::Block& block) {
  if (chooses_levels_from_answers(block)) return {};
  switch (block.order) {
    case Protocol::Block::Order::fixed:
      return "in fixed order";
    case Protocol::Block::Order::shuffle:
      return "in random order";
    case Protocol::Block::Order::shuffle_within_repetition:
      return "in random order within each repetition";
  }
  return {};
}

/// "the positions of the surfaces balanced over the trials"
std::string positions_text(const Protocol::Block& block) {
  switch (block.positions) {
    case Protocol::Block::Positions::as_listed:
      return "the surfaces of a trial always in the same positions";
    case Protocol::Block::Positions::shuffle:
      return "the surfaces of a trial in random positions";
    case Protocol::Block::Positions::balanced:
      return "the positions of the surfaces balanced over the trials";
  }
  return {};
}

/// Its own, or that of a parameter whose value it supplies; empty without either.
std::string unit_of_factor(const Protocol& protocol, const std::string& name) {
  const auto factor = protocol.factors.find(name);
  if (factor != protocol.factors.end() && !factor->second.unit.empty()) return factor->second.unit;
  for (const auto& [stimulus_name, stimulus] : protocol.stimuli) {
    for (const auto& [parameter, binding] : stimulus.parameters) {
      if (!binding.value && binding.factor == name) return unit_of_parameter(parameter);
    }
  }
  return {};
}

/// "amplitude 50 µm and texture stone"
std::string text_of_row(const Protocol& protocol,
                        const std::map<std::string, Level, std::less<>>& levels) {
  std::vector<std::string> parts{};
  for (const auto& [factor, level] : levels) {
    const auto* const number = std::get_if<double>(&level);
    const std::string unit = unit_of_factor(protocol, factor);
    parts.push_back(number != nullptr && !unit.empty()
                        ? words_of_parameter(factor) + ' ' + display_quantity(*number, unit)
                        : factor + ' ' + text_of(level));
  }
  return listed(parts);
}

/// "(without the combination of force 2 and texture stone; equal levels of texture at least 3 trials apart; texture stone in
/// trial 1)"
std::string constraints_text(const Protocol& protocol, const Protocol::Block& block) {
  std::vector<std::string> parts{};
  for (const auto& row : block.exclude) {
    parts.push_back("without the combination of " + text_of_row(protocol, row));
  }
  for (const auto& [factor, formula] : block.derived) parts.push_back(factor + " = " + formula);
  for (const auto& each : block.repetitions_of) {
    parts.push_back("trials with " + text_of_row(protocol, each.levels) + " presented " +
                    (each.repetitions == 1 ? "once" : std::to_string(each.repetitions) + " times"));
  }
  for (const auto& [factor, distance] : block.minimum_distance) {
    parts.push_back("equal levels of " + factor + " at least " + std::to_string(distance) +
                    " trials apart");
  }
  for (const auto& fixed : block.fixed_positions) {
    parts.push_back(text_of_row(protocol, fixed.levels) + " in trial " +
                    std::to_string(fixed.position));
  }
  if (parts.empty()) return {};
  std::string text{};
  for (const std::string& part : parts) text += (text.empty() ? "(" : "; ") + part;
  return text + ')';
}

std::string order_text(const Protocol& protocol, const Protocol::Block& block) {
  std::vector<std::string> parts{order_of_levels(block)};
  if (!block.drawn.empty()) parts.push_back(listed(block.drawn) + " drawn at random in each trial");
  if (block.all_pairs) {
    parts.push_back("all pairs of the levels of " + block.all_pairs->factor +
                    (block.all_pairs->in_both_orders ? " in both orders" : "") +
                    (block.all_pairs->with_identical ? " and identical pairs" : "") +
                    (block.all_pairs->parts > 1
                         ? ", of which each participant is given one of " +
                               std::to_string(block.all_pairs->parts) + " parts"
                         : ""));
  }
  const bool has_both_orders = block.all_pairs && block.all_pairs->in_both_orders;
  if (surfaces_in_trial(block) >= 2 && !has_both_orders) parts.push_back(positions_text(block));
  std::erase(parts, std::string());
  if (order_of_levels(block).empty() && !parts.empty()) parts.front().insert(0, "with ");
  const std::string text = comma_separated(parts);
  const std::string constraints = constraints_text(protocol, block);
  return text + (text.empty() || constraints.empty() ? "" : " ") + constraints;
}

/// ", until 2 of the last 3 trials are correct, at most 6 trials"
std::string until_text(const Protocol::Criterion& until, Tense tense) {
  const bool is_past = tense == Tense::past;
  const std::string number = std::to_string(until.correct);
  const std::string are = is_past ? "were" : "are";
  return ", until " +
         (until.correct == until.of_last
              ? (until.correct == 1 ? "a trial " + std::string(is_past ? "was" : "is")
                                    : "the last " + number + " trials " + are)
              : number + " of the last " + std::to_string(until.of_last) + " trials " + are) +
         " correct, at most " + std::to_string(until.maximum_trials) +
         (until.maximum_trials == 1 ? " trial" : " trials");
}

/// ", with a break of at least 120 s after every 5 min of contact"
std::string breaks_text(const Protocol::Run& run) {
  std::vector<std::string> after{};
  if (run.break_every_trials > 0) {
    after.push_back(run.break_every_trials == 1
                        ? "after every trial"
                        : "after every " + std::to_string(run.break_every_trials) + " trials");
  }
  if (run.break_every_contact_s > 0.0) {
    after.push_back("after every " + number_text(run.break_every_contact_s / 60.0) +
                    " min of contact");
  }
  if (after.empty()) return {};
  return ", with a break of at least " + display_quantity(run.pause->minimum_s, "s") + ' ' +
         listed(after);
}

/// Whether the rules of the protocol alone determined the number of its trials.
bool is_completed_and_included(const ReportedSession& session) {
  return session.row.state == SessionState::completed && !session.row.excluded;
}

/// "66", "66 to 87"
std::string range_of(const std::set<int>& counts) {
  return *counts.begin() == *counts.rbegin()
             ? std::to_string(*counts.begin())
             : std::to_string(*counts.begin()) + " to " + std::to_string(*counts.rbegin());
}

/// "The number of trials depended on the responses: a completed session had 66 to 87 experimental trials, and 70 to 93 in
/// total including practice." Tracks of a fixed length give all sessions one number.
std::string trials_by_responses_text(const ReportFacts& facts) {
  std::set<int> main_trials{};
  std::set<int> all{};
  for (const ReportedSession& session : facts.sessions) {
    if (!is_completed_and_included(session)) continue;
    main_trials.insert(session.presented_main_trials);
    all.insert(session.presented_trials);
  }
  if (all.empty()) return "No session was completed and included.";
  std::string text =
      std::string(main_trials.size() > 1
                      ? "The number of trials depended on the responses: a completed session had "
                      : "A completed session had ") +
      range_of(main_trials) + " experimental " +
      (main_trials == std::set<int>{1} ? "trial" : "trials");
  if (all != main_trials) {
    text += ", and " + range_of(all) + " in total including " +
            listed({facts.other_planned.begin(), facts.other_planned.end()});
  }
  return text + '.';
}

}  // namespace

std::string planned_trials_text(const ReportFacts& facts) {
  // The plan of such a session grows with the responses: what it contains was presented, not planned.
  const bool depends_on_responses =
      std::any_of(facts.sessions.begin(), facts.sessions.end(),
                  [](const auto& session) { return session.row.expected_trials.has_value(); });
  if (depends_on_responses) return trials_by_responses_text(facts);
  std::set<int> main_trials{};
  std::set<int> planned{};
  for (const ReportedSession& session : facts.sessions) {
    main_trials.insert(session.main_trials);
    planned.insert(session.planned_trials);
  }
  if (planned.empty()) return {};
  std::string text = "A session was planned with " + range_of(main_trials) + " experimental " +
                     (main_trials == std::set<int>{1} ? "trial" : "trials");
  if (planned != main_trials) {
    text += ", and with " + range_of(planned) + " in total including " +
            listed({facts.other_planned.begin(), facts.other_planned.end()});
  }
  return text + '.';
}

std::string done_trials_text(const ReportedSession& session) {
  return std::to_string(session.done_trials) +
         (session.planned_is_estimated ? " of about " : " of ") +
         std::to_string(session.planned_trials);
}

std::string presented_trials_text(const Protocol::Block& block, const ReportFacts& facts) {
  if (!block.until) return {};
  std::set<int> presented{};
  for (const ReportedSession& session : facts.sessions) {
    if (!is_completed_and_included(session)) continue;
    for (const auto& [run, trials] : session.presented_in_run) {
      if (run.first == block.name) presented.insert(trials);
    }
  }
  if (presented.empty()) return {};
  return " In completed sessions, the block had " + range_of(presented) +
         (presented == std::set<int>{1} ? " trial." : " trials.");
}

std::string order_of_run(const Protocol& protocol, const Protocol::Block& block,
                         const Protocol::Run& run, Tense tense) {
  std::string text = order_text(protocol, block);
  if (block.until) {
    text += until_text(*block.until, tense);
  } else if (block.repetitions > 1) {
    text += ", " + std::to_string(block.repetitions) + " repetitions";
  }
  if (!run.for_each.empty()) text += ", once for each level of " + run.for_each;
  text += breaks_text(run);
  return text.starts_with(", ") ? text.substr(2) : text;
}

/// " The criterion was not met in either session."; empty where it was met in all.
std::string unmet_text(const std::string& block, const ReportFacts& facts) {
  const auto unmet = static_cast<std::size_t>(std::count_if(
      facts.sessions.begin(), facts.sessions.end(),
      [&](const ReportedSession& one) { return one.unmet_criteria.contains(block); }));
  if (unmet == 0) return {};
  return " The criterion was not met " +
         SessionShare{.whole = unmet, .all = facts.sessions.size()}.text_after_not() + '.';
}

std::string feedback_text(const Protocol::Block& block) {
  switch (block.feedback) {
    case Protocol::Block::Feedback::none:
      return {};
    case Protocol::Block::Feedback::correctness:
      return ", with feedback on whether each response was correct";
    case Protocol::Block::Feedback::correct_answer:
      return ", with the correct response shown after each response";
  }
  return {};
}

}  // namespace asperity
