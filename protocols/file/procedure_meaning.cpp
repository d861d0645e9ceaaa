// Implements the checks of the procedure of a block.

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/rounded_text.h"
#include "protocols/file/levels_from_json.h"
#include "protocols/file/meaning_checks.h"
#include "protocols/plan/level_tracks.h"

namespace asperity {

using Block = Protocol::Block;

namespace {

/// The keys that only some methods have.
struct MethodKeys {
  std::string_view method{};
  std::vector<std::string_view> keys{};
};

const std::array<MethodKeys, 6>& keys_of_methods() {
  static const std::array<MethodKeys, 6> kKeys{
      MethodKeys{"constant_stimuli", {"repetitions"}},
      MethodKeys{"transformed_up_down",
                 {"down", "up", "start", "steps", "steps_up", "steps_down", "stop", "tracks"}},
      MethodKeys{"weighted_up_down", {"target", "start", "steps", "steps_down", "stop", "tracks"}},
      MethodKeys{"psi", {"target", "prior", "marginalise", "stop", "tracks"}},
      MethodKeys{"quest_plus", {"target", "prior", "stop", "tracks"}},
      MethodKeys{"external", {"stop", "tracks", "settings", "answer_within_s"}}};
  return kKeys;
}

/// Whether a method has a key of "stop" or of one of its "tracks".
bool has_inner_key(std::string_view method, std::string_view key) {
  const bool is_posterior = method == psi().id || method == quest_plus().id;
  if (key == "interval") return is_posterior;
  if (key == "reversals" || key == "clipped_moves" || key == "start") {
    return !is_posterior && method != external().id;
  }
  return true;
}

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

/// "transformed_up_down" or "weighted_up_down": the methods that have a key.
std::string methods_with(std::string_view key) {
  std::vector<std::string> methods{};
  for (const MethodKeys& each : keys_of_methods()) {
    if (std::find(each.keys.begin(), each.keys.end(), key) != each.keys.end()) {
      methods.emplace_back(each.method);
    }
  }
  return one_of(methods);
}

std::string listed_keys(const std::vector<std::string_view>& keys) {
  std::vector<std::string> quoted{};
  for (const std::string_view key : keys) quoted.push_back(in_quotes(key));
  return listed_words(quoted);
}

/// "100 or more", "-60 or less": the levels that are at least as far from the standard as every level of the block.
std::string easy_levels(const Dimension& dimension, bool is_performance) {
  const double standard = *dimension.standard;
  const std::vector<double> values = dimension.values();
  const std::vector<double> levels = dimension.levels();
  const double below = standard - values.front();
  const double above = values.back() - standard;
  const std::string more = rounded_text(levels.back()) + " or more";
  const std::string less = rounded_text(levels.front()) + " or less";
  if (is_performance) return above > 0.0 ? more : less;
  const double farthest = std::max(below, above);
  return rounded_text(dimension.level_of(standard + farthest)) + " or more" +
         (standard - farthest > 0.0 || !needs_positive_standard(dimension.measure)
              ? ", or " + rounded_text(dimension.level_of(standard - farthest)) + " or less"
              : "");
}

}  // namespace

void Meaning::check_procedure(const Block& block, const std::string& pointer) {
  const auto& object = document_.root().at("blocks").at(block.name);
  const auto stated = object.find("procedure");
  if (stated == object.end()) return;
  const std::string place = pointer + "/procedure";
  if (!block.procedure) {
    report(place,
           "a procedure chooses the levels of a parameter; add \"vary\" with the parameter and its "
           "levels");
    return;
  }
  if (!kind_of(block).has_judgement) {
    report_key(place,
               "only a discrimination has a procedure; remove this key, or set \"kind\" to "
               "\"discrimination\"");
    return;
  }
  if (block.design->has_noise())
    return;  // no procedure is permitted, which is reported with the design
  for (const char* const key : {"repetitions", "repetitions_of", "maximum_in_a_row",
                                "minimum_distance", "fixed_positions", "until"}) {
    if (!object.contains(key)) continue;
    report_key(pointer + "/" + key,
               "the procedure of a block determines its trials; remove this key");
  }
  const auto method = stated->at("method").get<std::string>();
  std::vector<std::string_view> own{};
  for (const MethodKeys& each : keys_of_methods()) {
    if (each.method == method) own = each.keys;
  }
  for (const auto& [key, value] : stated->items()) {
    const bool is_of_some = std::any_of(
        keys_of_methods().begin(), keys_of_methods().end(), [&key = key](const auto& each) {
          return std::find(each.keys.begin(), each.keys.end(), key) != each.keys.end();
        });
    if (is_of_some && std::find(own.begin(), own.end(), key) == own.end()) {
      report_key(pointer_to(place, key),
                 "the method " + in_quotes(method) + " has no key " + in_quotes(key) +
                     ", which belongs to " + methods_with(key) +
                     ". Remove it, or use that method; the keys of this one are " +
                     listed_keys(own));
    }
  }
  const auto check_inner_keys = [&](const nlohmann::json& inner, const std::string& at) {
    for (const auto& [key, value] : inner.items()) {
      if (has_inner_key(method, key)) continue;
      report_key(pointer_to(at, key), "the method " + in_quotes(method) + " has no key " +
                                          in_quotes(key) + " here; remove it");
    }
  };
  const bool has_stop = std::find(own.begin(), own.end(), "stop") != own.end();
  if (has_stop && stated->contains("stop")) check_inner_keys(stated->at("stop"), place + "/stop");
  if (has_stop && stated->contains("tracks")) {
    for (std::size_t i = 0; i < stated->at("tracks").size(); ++i) {
      check_inner_keys(stated->at("tracks").at(i), pointer_to(place + "/tracks", i));
    }
  }
  for (const auto& [name, at] : texts_of(block.exploration, pointer + "/exploration")) {
    const auto exploration = protocol_.explorations.find(name);
    if (exploration == protocol_.explorations.end() ||
        exploration->second.on_failure != Exploration::OnFailure::requeue_at_end_of_block) {
      continue;
    }
    report(pointer_to("/explorations", name) + "/on_failure",
           "the block " + in_quotes(block.name) +
               " has a procedure, which needs the response to a trial before the next one; use "
               "\"repeat_now\" or \"flag\"");
  }
  if (!has_levels(*block.vary)) return;  // reported at /vary
  // A staircase and a posterior need levels in equal steps.
  const bool takes_any_levels = method == constant_stimuli().id || method == external().id;
  if (!takes_any_levels && !block.vary->grid) {
    report(pointer + "/vary/" + std::string(key_of(block.vary->measure)),
           "the method " + in_quotes(method) +
               " needs levels in equal steps; state the levels as a grid: {\"lowest\": …, "
               "\"highest\": …, \"step\": …}");
    return;
  }
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  const std::vector<double> values = block.vary->values();
  if (posterior_track_of(block.procedure->tracks.front()) != nullptr) {
    check_bayesian_procedure(block, method, pointer);
  } else if (!takes_any_levels && block.vary->standard && values.back() <= *block.vary->standard &&
             judged != nullptr && judged->judgement == DiscriminationJudgement::performance) {
    report(
        place + "/method",
        "the method " + in_quotes(method) +
            " presents a lower level after correct responses, but below the standard lower levels "
            "are easier; state levels above the standard, or use \"constant_stimuli\"");
    return;
  }
  check_unforced(block, method, pointer);
  check_catch_trials(block, pointer);
  check_track_starts(block, pointer);
}

/// Psi and QUEST+ assume a Weibull function of the difference from the standard.
void Meaning::check_bayesian_procedure(const Block& block, const std::string& method,
                                       const std::string& pointer) {
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  if (judged != nullptr && judged->judgement != DiscriminationJudgement::performance) {
    report(pointer + "/procedure/method",
           "the method " + in_quotes(method) +
               " estimates a threshold of correct responses, but with the judgement "
               "\"comparison\" no response is correct; use \"judgement\": \"performance\", "
               "\"transformed_up_down\" or \"constant_stimuli\"");
  }
  if (block.vary->measure == LevelMeasure::decibels) {
    report(pointer + "/vary/" + std::string(key_of(block.vary->measure)),
           "the method " + in_quotes(method) +
               " needs levels that are proportional to the difference from the standard; state "
               "them as \"levels_percent\" or \"levels_difference\"");
  }
}

/// Where a response can be "cannot tell": whether the method has a step for it.
void Meaning::check_unforced(const Block& block, const std::string& method,
                             const std::string& pointer) {
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  if (judged == nullptr || !judged->allow_cannot_tell || block.design->has_noise()) return;
  const bool is_performance = judged->judgement == DiscriminationJudgement::performance;
  const std::string remedy =
      "; use " + std::string(is_performance ? "\"weighted_up_down\"" : "\"constant_stimuli\"") +
      ", or remove \"allow_cannot_tell\" from the question";
  if (method == transformed_up_down().id) {
    report(pointer + "/procedure/method",
           "the method " + in_quotes(method) +
               " counts correct responses in succession, among which the response \"cannot tell\" "
               "cannot be counted" +
               remedy);
  } else if (method == external().id) {
    report(pointer + "/procedure/method",
           "a program that states levels receives correct and incorrect responses only" + remedy);
  } else if (method == weighted_up_down().id && !is_performance) {
    const auto index = static_cast<std::size_t>(judged - block.questions.data());
    report(place_of_question(block, index) + "/judgement",
           "the step after the response \"cannot tell\" is the mean step of a guess, which is "
           "defined where one response is correct; use \"performance\", or the method "
           "\"constant_stimuli\"");
  }
}

/// With two standards no choice is correct: the only correct response is "cannot tell".
void Meaning::check_pairs_of_standards(const Block& block, const std::string& place) {
  const CatchType type = block.procedure->catch_trials->type;
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  if (document_.root().contains(nlohmann::json::json_pointer(place + "/level"))) {
    report_key(place + "/level", "a catch trial of the type " + in_quotes(text_of(type)) +
                                     " presents the standard twice; remove this key");
  }
  const CatchType of_judgement = judged->judgement == DiscriminationJudgement::performance
                                     ? CatchType::no_signal
                                     : CatchType::identical_pair;
  if (block.design->surfaces() != 2) {
    report(place + "/type", "catch trials of this type present two standards, and those of " +
                                block.design->with_article() + " three surfaces; use \"easy\"");
    return;
  }
  if (type != of_judgement) {
    report(place + "/type",
           type == CatchType::no_signal
               ? "with the judgement \"comparison\" there is no signal to be found; set it to "
                 "\"identical_pair\""
               : "with the judgement \"performance\" the comparison has to be found, and a trial "
                 "without it has no signal; set it to \"no_signal\"");
    return;
  }
  if (judged->allow_cannot_tell) return;
  report(place + "/type",
         "of two standards neither is the correct response, so that errors need the response "
         "\"cannot tell\"; add \"allow_cannot_tell\": true to the question, or use the type "
         "\"easy\"");
}

/// Errors in catch trials are lapses only if their level is easy and the correct response is known.
void Meaning::check_catch_trials(const Block& block, const std::string& pointer) {
  const auto& catch_trials = block.procedure->catch_trials;
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  if (!catch_trials || !block.vary->standard || judged == nullptr) return;
  const std::string place = pointer + "/procedure/catch_trials";
  if (catch_trials->type != CatchType::easy) return check_pairs_of_standards(block, place);
  if (!document_.root().contains(nlohmann::json::json_pointer(place + "/level"))) {
    report(place,
           "a catch trial of the type \"easy\" has a level; add \"level\", or state another "
           "\"type\"");
    return;
  }
  const double standard = *block.vary->standard;
  const std::vector<double> values = block.vary->values();
  const double level = catch_trials->level;
  const double value = block.vary->value_of(level);
  const double farthest =
      std::max(std::abs(values.front() - standard), std::abs(values.back() - standard));
  const bool is_performance = judged->judgement == DiscriminationJudgement::performance;
  const bool is_other_side = is_performance && (value > standard) != (values.back() > standard);
  // Values of a level are rounded to 12 digits.
  if (is_other_side || std::abs(value - standard) < farthest * (1.0 - 1e-9)) {
    report(place + "/level",
           "a catch trial must be easy: its level must be at least as far from the standard as "
           "the farthest level of the block" +
               std::string(is_performance ? ", on the same side" : "") + ", but the level is " +
               digits(level) + "; use " + easy_levels(*block.vary, is_performance));
    return;
  }
  if (is_performance) return;
  const auto index = static_cast<std::size_t>(judged - block.questions.data());
  const std::string at_direction = place_of_question(block, index) + "/asks_for";
  if (document_.root().contains(nlohmann::json::json_pointer(at_direction))) return;
  report(place,
         "with the judgement \"comparison\" the correct response in a catch trial is known only if "
         "the question states \"asks_for\": \"more\" or \"less\" of the varied parameter; add it "
         "to the question");
}

/// The settings of every track; those that tracks share are reported once.
void Meaning::check_track_starts(const Block& block, const std::string& pointer) {
  const auto& stated = document_.root().at("blocks").at(block.name).at("procedure");
  const std::vector<ProcedureSettings>& tracks = block.procedure->tracks;
  bool is_usable = true;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const bool has_start = stated.contains("tracks") && stated.at("tracks").at(i).contains("start");
    if (!has_start && !stated.contains("start") &&
        (std::holds_alternative<TransformedUpDown>(tracks[i]) ||
         std::holds_alternative<WeightedUpDown>(tracks[i]))) {
      report(pointer + "/procedure",
             "no start is stated; add \"start\", the level of the first "
             "trial, well above the expected threshold");
      is_usable = false;
      continue;
    }
    for (const ProcedureProblem& problem : problems_of(tracks[i])) {
      is_usable = false;
      const std::string place = problem.setting == "start" && has_start
                                    ? pointer_to(pointer + "/procedure/tracks", i) + "/start"
                                    : place_of_setting(problem.setting, stated, pointer);
      report(place, problem.message);
    }
  }
  if (!is_usable) return;
  const auto known = [this](const std::string& name) { return protocol_.factors.contains(name); };
  if (block.all_pairs || !std::all_of(block.crossed.begin(), block.crossed.end(), known)) return;
  if (const auto& catch_trials = block.procedure->catch_trials) {
    Block without = block;
    without.procedure->catch_trials.reset();
    const std::size_t trials = most_trials_of(protocol_, without);
    if (static_cast<std::size_t>(catch_trials->every) > trials) {
      report(pointer + "/procedure/catch_trials/every",
             "the tracks of this block have at most " + counted(trials, "trial", "trials") +
                 ", so that a session may have no catch trial; " +
                 (trials < 2 ? "allow more trials in the tracks" : "state that number or less"));
      return;
    }
  }
  if (most_trials_of(protocol_, block) > kMaximumTrials) {
    report(pointer + "/procedure",
           "this block can have " + std::to_string(most_trials_of(protocol_, block)) +
               " trials, more than " + std::to_string(kMaximumTrials) +
               ", too many for a participant; reduce the maximum number of trials of a track, the "
               "tracks or the levels of the other factors");
  }
}

}  // namespace asperity
