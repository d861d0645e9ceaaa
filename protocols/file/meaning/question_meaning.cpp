// Implements the checks that the questions of a block can be asked and answered.

#include <algorithm>
#include <cstddef>

#include "protocols/file/meaning/meaning_checks.h"

namespace asperity {

using Block = Protocol::Block;
using TrialQuestionTemplate = Protocol::TrialQuestionTemplate;

namespace {

/// "one question answered by a choice"
std::string needed_question(const ExperimentKind& kind) {
  return "one question answered by " +
         std::string(name_of(kind.form) == "assignment" ? "an " : "a ") +
         std::string(name_of(kind.form));
}

/// Whether there are questions, which can be shown as the block states.
bool check_question_keys(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  if (block.questions.empty()) {
    checked.report(
        pointer,
        "a block needs the key \"question\", or \"questions\" for several questions in a trial");
    return false;
  }
  if (!block.on_one_page) return true;
  for (std::size_t i = 0; i < block.questions.size(); ++i) {
    const auto* const scale = std::get_if<ScaleForm>(&block.questions[i].form);
    if (scale != nullptr && !scale->labels_every_point()) continue;
    checked.report(place_of_question(block, i),
                   "questions on one page must be scales without labels between the ends; set "
                   "question_layout to "
                   "\"one_after_another\"");
  }
  return true;
}

void check_pictures(CheckedDocument& checked, const Block& block,
                    const TrialQuestionTemplate& question, const std::string& place) {
  for (std::size_t i = 0; i < question.pictures.size(); ++i) {
    const std::string& name = question.pictures[i];
    const std::string at = pointer_to(place + "/pictures", i);
    const auto texture = checked.protocol.textures.find(name);
    const auto here = question.pictures.begin() + static_cast<std::ptrdiff_t>(i);
    if (texture == checked.protocol.textures.end()) {
      checked.report(at, unknown_name("texture", name, checked.protocol.textures));
    } else if (!texture->second.picture) {
      checked.report(at,
                     "the texture " + in_quotes(name) + " has no \"picture\" to show; give it one");
    }
    if (std::find(question.pictures.begin(), here, name) != here) {
      checked.report(at, "the picture of " + in_quotes(name) + " is listed twice; list it once");
    }
  }
  if (!question.pictures.empty() && !question.options.empty()) {
    checked.report_key(place + "/options",
                       "options are either pictures or words; keep one of the two keys");
  }
  const std::string of_trial = block.has_question_list ? pointer_to("/blocks", block.name) : place;
  if (!question.pictures.empty() && block.pictures_after_feeling &&
      block.arrangement.allows_revisits()) {
    checked.report(
        of_trial + "/pictures_after_feeling",
        "a participant who may return to a surface feels it with the pictures in view; set "
        "allow_revisit to false, or in an arrangement a maximum of visits equal to the minimum");
  }
}

/// Responses are stored, exported and analysed by the name of their question.
void check_same_form(CheckedDocument& checked, const Block& block,
                     const TrialQuestionTemplate& question, const std::string& place) {
  if (block.phase != Phase::main) return;
  for (const auto& [name, other] : checked.protocol.blocks) {
    if (other.phase != Phase::main || name >= block.name) continue;
    for (const TrialQuestionTemplate& earlier : other.questions) {
      if (earlier.name != question.name || earlier.form.index() == question.form.index()) continue;
      checked.report(place + "/name",
                     "the block " + in_quotes(name) + " has the question " +
                         in_quotes(question.name) + " answered by " +
                         std::string(description_of(earlier.form)) +
                         ", and responses to both would be exported as one variable; give "
                         "one of the questions another name");
    }
  }
}

/// Ratings of several blocks are analysed together where their question has one name.
void check_same_scale(CheckedDocument& checked, const Block& block,
                      const TrialQuestionTemplate& question, const std::string& place) {
  const auto* const scale = std::get_if<ScaleForm>(&question.form);
  if (scale == nullptr || block.phase != Phase::main) return;
  for (const auto& [name, other] : checked.protocol.blocks) {
    if (other.phase != Phase::main || name >= block.name) continue;
    for (const TrialQuestionTemplate& earlier : other.questions) {
      const auto* const its = std::get_if<ScaleForm>(&earlier.form);
      if (earlier.name != question.name || its == nullptr || *its == *scale) continue;
      checked.report(
          place + "/name",
          "the block " + in_quotes(name) + " has the question " + in_quotes(question.name) +
              " on another scale, and the responses to both are analysed together; give one of "
              "the questions another name, or use one scale for both");
    }
  }
}

/// An ROC needs categories of confidence, and a response of which one is correct.
void check_confidence(CheckedDocument& checked, const Block& block,
                      const TrialQuestionTemplate& question, const std::string& place) {
  if (question.confidence_of().empty()) return;
  const std::string at = place + "/confidence_of";
  const TrialQuestionTemplate* const judged = judged_question(block);
  if (judged == nullptr) return;  // only a discrimination has this key
  if (question.confidence_of() != judged->name) {
    checked.report(at, "this scale can rate the confidence of the response to " +
                           in_quotes(judged->name) + "; write this name");
    return;
  }
  if (&question < judged) {
    checked.report(place,
                   "the confidence of a response is rated after it; list this question after " +
                       in_quotes(judged->name));
  }
  if (judged->judgement() != DiscriminationJudgement::performance) {
    checked.report_key(
        at,
        "with the judgement \"comparison\" no response is correct, so that there is no "
        "ROC; remove this key");
  }
  if (judged->allow_cannot_tell) {
    checked.report_key(
        at,
        "the lowest category of confidence states already that a participant cannot tell, "
        "and an ROC needs a choice in every trial; remove this key, or "
        "\"allow_cannot_tell\" of the question " +
            in_quotes(judged->name));
  }
  if (block.design()->is_choice_of_three()) {
    checked.report_key(
        at, "the confidence in the response of " + block.design()->with_article() +
                " gives no ROC, because there are more than two responses; remove this key, "
                "and the scale is reported for correct and incorrect responses");
  }
  if (chooses_levels_from_answers(block)) {
    checked.report_key(
        at,
        "an ROC needs trials at levels that do not depend on the responses; remove this "
        "key, or use \"constant_stimuli\"");
  }
  constexpr int kMostCategories = 10;
  const auto* const scale = std::get_if<ScaleForm>(&question.form);
  if (scale == nullptr || scale->points < 2 || scale->points > kMostCategories) {
    checked.report(place,
                   "a rating of confidence needs a \"scale\" with 2 to 10 \"points\", the "
                   "categories of its ROC; state them");
  }
  const auto is_other = [&question](const TrialQuestionTemplate& other) {
    return &other != &question && other.confidence_of() == question.confidence_of();
  };
  const auto first = std::find_if(block.questions.begin(), block.questions.end(), is_other);
  if (first != block.questions.end() && &*first < &question) {
    checked.report_key(at, "the question " + in_quotes(first->name) +
                               " rates the same confidence; remove one of the two keys");
  }
}

/// A question that another one does not decide is asked in every trial: the analysis of its kind, and a procedure, need its
/// response.
void check_condition_in_trial(CheckedDocument& checked, const Block& block, std::size_t question) {
  const TrialQuestionTemplate& asked = block.questions[question];
  const std::string at = place_of_question(block, question) + "/if";
  if (!states_one_test(checked, at)) return;
  const ExperimentKind& kind = kind_of(block);
  const bool is_rated = std::ranges::any_of(
      block.questions, [&](const auto& each) { return each.confidence_of() == asked.name; });
  if (kind_of_question(kind, asked) == &kind || is_rated || !asked.confidence_of().empty()) {
    checked.report_key(at,
                       std::string(asked.confidence_of().empty()
                                       ? "the analysis of a " + std::string(kind.name) +
                                             " needs the response to this question in every trial"
                                       : "an ROC needs the rating of confidence in every trial") +
                           "; remove this key");
    return;
  }
  if (block.on_one_page || block.shuffles_questions) {
    checked.report_key(
        at, std::string(block.on_one_page ? "the questions of one page are shown together"
                                          : "the questions are asked in an order that is drawn") +
                ", so that the answer is not known before; remove this key, or set " +
                (block.on_one_page ? "question_layout to \"one_after_another\""
                                   : "question_order to \"fixed\""));
    return;
  }
  const auto end = block.questions.begin() + static_cast<std::ptrdiff_t>(question);
  const std::string& needed = asked.condition->question;
  const bool is_earlier = std::any_of(block.questions.begin(), end,
                                      [&](const auto& each) { return each.name == needed; });
  if (is_earlier) return;
  checked.report(at + "/question", "no earlier question of the trial has the name " +
                                       in_quotes(needed) +
                                       "; name one that is listed before this question");
}

}  // namespace

void check_question(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  if (!check_question_keys(checked, block, pointer)) return;
  const ExperimentKind& kind = kind_of(block);
  std::size_t own = 0;
  std::set<std::string> names{};
  for (std::size_t i = 0; i < block.questions.size(); ++i) {
    const TrialQuestionTemplate& question = block.questions[i];
    const std::string place = place_of_question(block, i);
    if (!names.insert(question.name).second) {
      checked.report(place + "/name",
                     "two questions of a trial have the name " + in_quotes(question.name) +
                         ", under which their responses are stored; give each its own name");
    }
    check_pictures(checked, block, question, place);
    check_form(checked, question, place, OptionsOfChoice::surfaces);
    check_same_form(checked, block, question, place);
    check_same_scale(checked, block, question, place);
    check_confidence(checked, block, question, place);
    if (question.condition) check_condition_in_trial(checked, block, i);
    const ExperimentKind* const of_question = kind_of_question(kind, question);
    if (of_question == &kind) ++own;
    if (question.is_additional) {
      check_options(checked, question, place);
    } else if (of_question == nullptr) {
      const bool is_line = std::holds_alternative<LineForm>(question.form);
      checked.report(
          place + (is_line ? "/line" : "/scale"),
          "a " + std::string(kind.name) + " needs " + needed_question(kind) + "; remove this key");
    } else if (of_question == &kind && kind.check_block != nullptr) {
      kind.check_block({checked.protocol, block, question, pointer, place}, checked);
    }
  }
  const auto takes_its_place = [&kind](const TrialQuestionTemplate& question) {
    return question.is_additional && question.form.index() == kind.form.index();
  };
  const auto additional = std::ranges::find_if(block.questions, takes_its_place);
  if (own == 0 && additional != block.questions.end()) {
    const auto index = static_cast<std::size_t>(additional - block.questions.begin());
    checked.report_key(place_of_question(block, index) + "/form",
                       "a question that states its form is additional, and a " +
                           std::string(kind.name) + " needs " + needed_question(kind) +
                           "; remove this key from the question that the analysis is about");
  } else if (own == 0 || (own > 1 && !kind.asks_several)) {
    checked.report(block.has_question_list ? pointer + "/questions" : pointer + "/question",
                   "a " + std::string(kind.name) + " needs " + needed_question(kind) +
                       " in every trial; number given: " + std::to_string(own) +
                       "; add or remove questions");
  }
  if (block.feedback != Block::Feedback::none && kind.correct_of == nullptr) {
    checked.report(pointer + "/feedback",
                   "feedback needs a correct response, and no response of a " +
                       std::string(kind.name) + " is correct or incorrect; set it to \"none\"");
  }
  check_criterion(checked, block, pointer);
}

void check_tests_in_trials(CheckedDocument& checked, const std::vector<Trial>& possible) {
  for (const auto& [name, block] : checked.protocol.blocks) {
    for (std::size_t i = 0; i < block.questions.size(); ++i) {
      const std::optional<AnswerCondition>& condition = block.questions[i].condition;
      if (!condition) continue;
      Question needed = *question_named(block, condition->question);
      needed.options.clear();
      for (const Trial& trial : possible) {
        if (trial.block != name) continue;
        for (const Option& option : find_question(trial, needed.name)->options) {
          if (!needed.option_of(option.value)) needed.options.push_back(option);
        }
      }
      check_test(checked, *condition, needed, place_of_question(block, i) + "/if");
    }
  }
}

void check_scale_form(CheckedDocument& checked, const ScaleForm& scale, const std::string& at) {
  if (scale.minimum >= scale.maximum) {
    checked.report(at, "the maximum of the scale, " + digits(scale.maximum) +
                           ", must be greater than its minimum, " + digits(scale.minimum) +
                           "; raise \"maximum\"");
  }
  const std::size_t labels = scale.labels.size();
  if (labels == 0 || labels == 2 || labels == static_cast<std::size_t>(scale.points)) return;
  checked.report(at + "/labels",
                 "a scale has labels for its two ends or for all of its points; labels given: " +
                     std::to_string(labels) + ", points: " +
                     (scale.points == 0 ? std::string("none") : std::to_string(scale.points)) +
                     "; add or remove labels");
}

}  // namespace asperity
