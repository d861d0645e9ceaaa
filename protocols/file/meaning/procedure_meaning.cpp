// Implements the checks of the procedure of a block.

#include <algorithm>
#include <cmath>

#include "analysis/numbers/rounded_text.h"
#include "protocols/file/levels_from_json.h"
#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/plan/level_tracks.h"

namespace asperity {

using Block = Protocol::Block;

namespace {

/// The place of a setting of a procedure in its file.
std::string place_of_setting(const std::string& setting, const nlohmann::json& stated,
                             const std::string& pointer) {
  if (setting == "levels") return pointer + "/vary";
  std::string key = setting;
  std::replace(key.begin(), key.end(), '.', '/');
  if (key.starts_with("steps_") && !stated.contains(key)) key = "steps";
  // The innermost stated part of the setting.
  while (!key.empty() && !stated.contains(nlohmann::json::json_pointer('/' + key))) {
    const std::size_t end = key.rfind('/');
    key = end == std::string::npos ? "" : key.substr(0, end);
  }
  return pointer + "/procedure" + (key.empty() ? "" : '/' + key);
}

/// "100 or more", "-60 or less": the levels that are at least as far from the standard as every level of the block.
Phrase easy_levels(const Dimension& dimension, bool is_performance) {
  const auto or_more = [](double level) {
    return phrase("Protocols", "%1 or more").with(rounded_text(level));
  };
  const auto or_less = [](double level) {
    return phrase("Protocols", "%1 or less").with(rounded_text(level));
  };
  const double standard = *dimension.standard;
  const std::vector<double> values = dimension.values();
  const std::vector<double> levels = dimension.levels();
  const double below = standard - values.front();
  const double above = values.back() - standard;
  if (is_performance) return above > 0.0 ? or_more(levels.back()) : or_less(levels.front());
  const double farthest = std::max(below, above);
  const Phrase upper = or_more(dimension.level_of(standard + farthest));
  if (standard - farthest <= 0.0 && needs_positive_standard(dimension.measure)) return upper;
  return phrase("Protocols", "%1, or %2")
      .with(upper, or_less(dimension.level_of(standard - farthest)));
}

/// Psi and QUEST+ assume a Weibull function of the difference from the standard.
void check_bayesian_procedure(CheckedDocument& checked, const Block& block,
                              const std::string& method, const std::string& pointer) {
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  if (judged != nullptr && judged->judgement() != DiscriminationJudgement::performance) {
    checked.report(pointer + "/procedure/method",
                   phrase("Protocols",
                          "the method %1 estimates a threshold of correct responses, but with the "
                          "judgement %2 no response is correct; use %3: %4, %5 or %6")
                       .with(word_name(method), word_name("comparison"), key_name("judgement"),
                             word_name("performance"), word_name("transformed_up_down"),
                             word_name("constant_stimuli")));
  }
  if (block.vary->measure == LevelMeasure::decibels) {
    checked.report(
        pointer + "/vary/" + std::string(key_of(block.vary->measure)),
        phrase("Protocols",
               "the method %1 needs levels that are proportional to the difference from the "
               "standard; state them as %2 or %3")
            .with(word_name(method), key_name("levels_percent"), key_name("levels_difference")));
  }
}

/// Where a response can be "cannot tell": whether the method has a step for it.
void check_unforced(CheckedDocument& checked, const Block& block, const std::string& method,
                    const std::string& pointer) {
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  if (judged == nullptr || !judged->allow_cannot_tell || block.design()->has_noise()) return;
  const bool is_performance = judged->judgement() == DiscriminationJudgement::performance;
  const Phrase remedy =
      phrase("Protocols", "; use %1, or remove %2 from the question")
          .with(word_name(is_performance ? weighted_up_down().id : constant_stimuli().id),
                key_name("allow_cannot_tell"));
  if (method == transformed_up_down().id) {
    checked.report(
        pointer + "/procedure/method",
        phrase("Protocols",
               "the method %1 counts correct responses in succession, among which the response "
               "\"cannot tell\" cannot be counted%2")
            .with(word_name(method), remedy));
  } else if (method == external().id) {
    checked.report(
        pointer + "/procedure/method",
        phrase("Protocols",
               "a program that states levels receives correct and incorrect responses only%1")
            .with(remedy));
  } else if (method == weighted_up_down().id && !is_performance) {
    const auto index = static_cast<std::size_t>(judged - block.questions.data());
    checked.report(
        place_of_question(block, index) + "/judgement",
        phrase("Protocols",
               "the step after the response \"cannot tell\" is the mean step of a guess, which is "
               "defined where one response is correct; use %1, or the method %2")
            .with(word_name("performance"), word_name(constant_stimuli().id)));
  }
}

/// With two standards no choice is correct: the only correct response is "cannot tell".
void check_pairs_of_standards(CheckedDocument& checked, const Block& block,
                              const std::string& place) {
  const CatchType type = block.procedure->catch_trials->type;
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  const CatchType of_judgement = judged->judgement() == DiscriminationJudgement::performance
                                     ? CatchType::no_signal
                                     : CatchType::identical_pair;
  if (block.design()->surfaces() != 2) {
    checked.report(place + "/type",
                   phrase("Protocols",
                          "catch trials of this type present two standards, and those of %1 three "
                          "surfaces; use %2")
                       .with(block.design()->with_article, word_name("easy")));
    return;
  }
  if (type != of_judgement) {
    checked.report(
        place + "/type",
        (type == CatchType::no_signal
             ? phrase("Protocols",
                      "with the judgement %1 there is no signal to be found; set it to %2")
                   .with(word_name("comparison"), word_name("identical_pair"))
             : phrase("Protocols",
                      "with the judgement %1 the comparison has to be found, and a trial without "
                      "it has no signal; set it to %2")
                   .with(word_name("performance"), word_name("no_signal"))));
    return;
  }
  if (judged->allow_cannot_tell) return;
  checked.report(
      place + "/type",
      phrase("Protocols",
             "of two standards neither is the correct response, so that errors need the response "
             "\"cannot tell\"; add %1: true to the question, or use the type %2")
          .with(key_name("allow_cannot_tell"), word_name("easy")));
}

/// Errors in catch trials are lapses only if their level is easy and the correct response is known.
void check_catch_trials(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  const auto& catch_trials = block.procedure->catch_trials;
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  if (!catch_trials || !block.vary->standard || judged == nullptr) return;
  const std::string place = pointer + "/procedure/catch_trials";
  if (catch_trials->type != CatchType::easy) return check_pairs_of_standards(checked, block, place);
  if (!checked.document.root().contains(nlohmann::json::json_pointer(place + "/level"))) {
    checked.report(
        place,
        phrase("Protocols", "a catch trial of the type %1 has a level; add %2, or state another %3")
            .with(word_name("easy"), key_name("level"), key_name("type")));
    return;
  }
  const double standard = *block.vary->standard;
  const std::vector<double> values = block.vary->values();
  const double level = catch_trials->level;
  const double value = block.vary->value_of(level);
  const double farthest =
      std::max(std::abs(values.front() - standard), std::abs(values.back() - standard));
  const bool is_performance = judged->judgement() == DiscriminationJudgement::performance;
  const bool is_other_side = is_performance && (value > standard) != (values.back() > standard);
  // Values of a level are rounded to 12 digits.
  if (is_other_side || std::abs(value - standard) < farthest * (1.0 - 1e-9)) {
    checked.report(
        place + "/level",
        (is_performance
             ? phrase("Protocols",
                      "a catch trial must be easy: its level must be at least as far from the "
                      "standard as the farthest level of the block, on the same side, but the "
                      "level is %1; use %2")
             : phrase("Protocols",
                      "a catch trial must be easy: its level must be at least as far from the "
                      "standard as the farthest level of the block, but the level is %1; use %2"))
            .with(digits(level), easy_levels(*block.vary, is_performance)));
    return;
  }
  if (is_performance) return;
  const auto index = static_cast<std::size_t>(judged - block.questions.data());
  const std::string at_direction = place_of_question(block, index) + "/asks_for";
  if (checked.document.root().contains(nlohmann::json::json_pointer(at_direction))) return;
  checked.report(
      place,
      phrase("Protocols",
             "with the judgement %1 the correct response in a catch trial is known only if the "
             "question states %2: %3 or %4 of the varied parameter; add it to the question")
          .with(word_name("comparison"), key_name("asks_for"), word_name("more"),
                word_name("less")));
}

/// The settings of every track; those that tracks share are reported once.
void check_track_starts(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  const auto& stated = checked.document.root().at("blocks").at(block.name).at("procedure");
  const std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
  bool is_usable = true;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const bool has_start = stated.contains("tracks") && stated.at("tracks").at(i).contains("start");
    if (!has_start && !stated.contains("start") &&
        (std::holds_alternative<TransformedUpDown>(tracks[i]) ||
         std::holds_alternative<WeightedUpDown>(tracks[i]))) {
      checked.report(pointer + "/procedure",
                     phrase("Protocols",
                            "no start is stated; add %1, the level of the first trial, well above "
                            "the expected threshold")
                         .with(key_name("start")));
      is_usable = false;
      continue;
    }
    for (const ProcedureProblem& problem : problems_of(tracks[i])) {
      is_usable = false;
      const std::string place = problem.setting == "start" && has_start
                                    ? pointer_to(pointer + "/procedure/tracks", i) + "/start"
                                    : place_of_setting(problem.setting, stated, pointer);
      checked.report(place, problem.message);
    }
  }
  if (!is_usable) return;
  const auto known = [&checked](const std::string& name) {
    return checked.protocol.factors.contains(name);
  };
  if (block.all_pairs || !std::all_of(block.crossed.begin(), block.crossed.end(), known)) return;
  if (const auto& catch_trials = block.procedure->catch_trials) {
    Block without = block;
    without.procedure->catch_trials.reset();
    const std::size_t trials = most_trials_of(checked.protocol, without);
    if (static_cast<std::size_t>(catch_trials->every) > trials) {
      checked.report(
          pointer + "/procedure/catch_trials/every",
          (trials < 2
               ? phrase("Protocols",
                        "the tracks of this block have at most %1 trial, so that a session may "
                        "have no catch trial; allow more trials in the tracks")
               : phrase("Protocols",
                        "the tracks of this block have at most %1 trials, so that a session may "
                        "have no catch trial; state that number or less"))
              .with(std::to_string(trials)));
      return;
    }
  }
  if (most_trials_of(checked.protocol, block) > kMaximumTrials) {
    checked.report(
        pointer + "/procedure",
        phrase("Protocols",
               "this block can have %1 trials, more than %2, too many for a participant; reduce "
               "the maximum number of trials of a track, the tracks or the levels of the other "
               "factors")
            .with(std::to_string(most_trials_of(checked.protocol, block)),
                  std::to_string(kMaximumTrials)));
  }
}

}  // namespace

void check_procedure(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  // The key may not apply; with noise no procedure is permitted, which is reported with the design.
  if (!block.procedure || block.kind != discrimination_kind().id) return;
  if (block.design()->has_noise()) return;
  const std::string place = pointer + "/procedure";
  const auto& object = checked.document.root().at("blocks").at(block.name);
  for (const char* const key : {"repetitions", "repetitions_of", "maximum_in_a_row",
                                "minimum_distance", "fixed_positions", "until"}) {
    if (!object.contains(key)) continue;
    checked.report_key(
        pointer + "/" + key,
        phrase("Protocols", "the procedure of a block determines its trials; remove this key"));
  }
  const auto method = object.at("procedure").at("method").get<std::string>();
  for (const auto& [name, at] : texts_of(checked, block.exploration, pointer + "/exploration")) {
    const auto exploration = checked.protocol.explorations.find(name);
    if (exploration == checked.protocol.explorations.end() ||
        exploration->second.on_failure != Exploration::OnFailure::requeue_at_end_of_block) {
      continue;
    }
    checked.report(
        pointer_to("/explorations", name) + "/on_failure",
        phrase("Protocols",
               "the block %1 has a procedure, which needs the response to a trial before the next "
               "one; use %2 or %3")
            .with(in_quotes(block.name), word_name("repeat_now"), word_name("flag")));
  }
  if (!has_levels(*block.vary)) return;  // reported at /vary
  // A staircase and a posterior need levels in equal steps.
  const bool takes_any_levels = method == constant_stimuli().id || method == external().id;
  if (!takes_any_levels && !block.vary->grid) {
    checked.report(
        pointer + "/vary/" + std::string(key_of(block.vary->measure)),
        phrase("Protocols",
               "the method %1 needs levels in equal steps; state the lowest level, the "
               "highest and the step%2")
            .with(word_name(method), with_json("{\"lowest\": …, \"highest\": …, \"step\": …}")));
    return;
  }
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  const std::vector<double> values = block.vary->values();
  if (posterior_track_of(block.procedure->tracks.front()) != nullptr) {
    check_bayesian_procedure(checked, block, method, pointer);
  } else if (!takes_any_levels && block.vary->standard && values.back() <= *block.vary->standard &&
             judged != nullptr && judged->judgement() == DiscriminationJudgement::performance) {
    checked.report(
        place + "/method",
        phrase("Protocols",
               "the method %1 presents a lower level after correct responses, but below the "
               "standard lower levels are easier; state levels above the standard, or use %2")
            .with(word_name(method), word_name(constant_stimuli().id)));
    return;
  }
  check_unforced(checked, block, method, pointer);
  check_catch_trials(checked, block, pointer);
  check_track_starts(checked, block, pointer);
}

}  // namespace asperity
