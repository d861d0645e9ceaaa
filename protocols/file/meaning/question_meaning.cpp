// Implements the checks that the questions of a block can be asked and answered.

#include <algorithm>
#include <cstddef>

#include "protocols/file/meaning/meaning_checks.h"

namespace asperity {

using Block = Protocol::Block;
using TrialQuestionTemplate = Protocol::TrialQuestionTemplate;

namespace {

Phrase needed_question(const ExperimentKind& kind) {
  if (std::holds_alternative<AssignmentForm>(kind.form)) {
    return phrase("Protocols", "one question answered by an assignment");
  }
  if (std::holds_alternative<NumberForm>(kind.form)) {
    return phrase("Protocols", "one question answered by a number");
  }
  if (std::holds_alternative<ScaleForm>(kind.form)) {
    return phrase("Protocols", "one question answered by a scale");
  }
  return phrase("Protocols", "one question answered by a choice");
}

/// Whether there are questions, which can be shown as the block states.
bool check_question_keys(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  if (block.questions.empty()) {
    checked.report(
        pointer,
        phrase("Protocols", "a block needs the key %1, or %2 for several questions in a trial")
            .with(key_name("question"), key_name("questions")));
    return false;
  }
  if (!block.on_one_page) return true;
  for (std::size_t i = 0; i < block.questions.size(); ++i) {
    const auto* const scale = std::get_if<ScaleForm>(&block.questions[i].form);
    if (scale != nullptr && !scale->labels_every_point()) continue;
    checked.report(place_of_question(block, i),
                   phrase("Protocols",
                          "questions on one page must be scales without labels between the ends; "
                          "set %1 to %2")
                       .with(key_name("question_layout"), word_name("one_after_another")));
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
      checked.report(at, unknown_name("texture", name,
                                      names_not_in(question.pictures, checked.protocol.textures)));
    } else if (!texture->second.picture) {
      checked.report(at, phrase("Protocols", "the texture %1 has no %2 to show; give it one")
                             .with(in_quotes(name), key_name("picture")));
    }
    if (std::find(question.pictures.begin(), here, name) != here) {
      checked.report(at, phrase("Protocols", "the picture of %1 is listed twice; list it once")
                             .with(in_quotes(name)));
    }
  }
  if (!question.pictures.empty() && !question.options.empty()) {
    checked.report_key(
        place + "/options",
        phrase("Protocols", "options are either pictures or words; keep one of the two keys"));
  }
  const std::string of_trial = block.has_question_list ? pointer_to("/blocks", block.name) : place;
  if (!question.pictures.empty() && block.pictures_after_feeling &&
      block.arrangement.allows_revisits()) {
    checked.report(
        of_trial + "/pictures_after_feeling",
        phrase("Protocols",
               "a participant who may return to a surface feels it with the pictures in view; set "
               "%1 to false, or in an arrangement a maximum of visits equal to the minimum")
            .with(key_name("allow_revisit")));
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
      checked.report(
          place + "/name",
          phrase("Protocols",
                 "the block %1 has the question %2 answered by %3, and responses to "
                 "both would be exported as one variable; give one of the questions "
                 "another name")
              .with(in_quotes(name), in_quotes(question.name), description_of(earlier.form)));
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
          phrase("Protocols",
                 "the block %1 has the question %2 on another scale, and the responses to both are "
                 "analysed together; give one of the questions another name, or use one scale for "
                 "both")
              .with(in_quotes(name), in_quotes(question.name)));
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
    checked.report(
        at, phrase("Protocols",
                   "this scale can rate the confidence of the response to %1; write this name")
                .with(in_quotes(judged->name)));
    return;
  }
  if (&question < judged) {
    checked.report(place,
                   phrase("Protocols",
                          "the confidence of a response is rated after it; list this question "
                          "after %1")
                       .with(in_quotes(judged->name)));
  }
  if (judged->judgement() != DiscriminationJudgement::performance) {
    checked.report_key(
        at,
        phrase("Protocols",
               "with the judgement %1 no response is correct, so that there is no ROC; remove this "
               "key")
            .with(word_name("comparison")));
  }
  if (judged->allow_cannot_tell) {
    checked.report_key(
        at,
        phrase(
            "Protocols",
            "the lowest category of confidence states already that a participant cannot tell, "
            "and an ROC needs a choice in every trial; remove this key, or %1 of the question %2")
            .with(key_name("allow_cannot_tell"), in_quotes(judged->name)));
  }
  if (block.design()->is_choice_of_three()) {
    checked.report_key(
        at,
        phrase("Protocols",
               "the confidence in the response of %1 gives no ROC, because there are more than two "
               "responses; remove this key, and the scale is reported for correct and incorrect "
               "responses")
            .with(block.design()->with_article));
  }
  if (chooses_levels_from_answers(block)) {
    checked.report_key(
        at, phrase("Protocols",
                   "an ROC needs trials at levels that do not depend on the responses; remove this "
                   "key, or use %1")
                .with(word_name("constant_stimuli")));
  }
  constexpr int kMostCategories = 10;
  const auto* const scale = std::get_if<ScaleForm>(&question.form);
  if (scale == nullptr || scale->points < 2 || scale->points > kMostCategories) {
    checked.report(place,
                   phrase("Protocols",
                          "a rating of confidence needs a %1 with 2 to 10 %2, the categories of "
                          "its ROC; state them")
                       .with(key_name("scale"), key_name("points")));
  }
  const auto is_other = [&question](const TrialQuestionTemplate& other) {
    return &other != &question && other.confidence_of() == question.confidence_of();
  };
  const auto first = std::find_if(block.questions.begin(), block.questions.end(), is_other);
  if (first != block.questions.end() && &*first < &question) {
    checked.report_key(
        at,
        phrase("Protocols", "the question %1 rates the same confidence; remove one of the two keys")
            .with(in_quotes(first->name)));
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
                       asked.confidence_of().empty()
                           ? phrase("Protocols",
                                    "the analysis of a %1 needs the response to this question in "
                                    "every trial; remove this key")
                                 .with(kind.name)
                           : phrase("Protocols",
                                    "an ROC needs the rating of confidence in every trial; remove "
                                    "this key"));
    return;
  }
  if (block.on_one_page || block.shuffles_questions) {
    checked.report_key(
        at, block.on_one_page
                ? phrase("Protocols",
                         "the questions of one page are shown together, so that the answer is not "
                         "known before; remove this key, or set %1 to %2")
                      .with(key_name("question_layout"), word_name("one_after_another"))
                : phrase("Protocols",
                         "the questions are asked in an order that is drawn, so that the answer is "
                         "not known before; remove this key, or set %1 to %2")
                      .with(key_name("question_order"), word_name("fixed")));
    return;
  }
  const auto end = block.questions.begin() + static_cast<std::ptrdiff_t>(question);
  const std::string& needed = asked.condition->question;
  const bool is_earlier = std::any_of(block.questions.begin(), end,
                                      [&](const auto& each) { return each.name == needed; });
  if (is_earlier) return;
  checked.report(at + "/question",
                 phrase("Protocols",
                        "no earlier question of the trial has the name %1; name one that is listed "
                        "before this question")
                     .with(in_quotes(needed)));
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
                     phrase("Protocols",
                            "two questions of a trial have the name %1, under which their "
                            "responses are stored; give each its own name")
                         .with(in_quotes(question.name)));
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
      checked.report(place + (is_line ? "/line" : "/scale"),
                     phrase("Protocols", "a %1 needs %2; remove this key")
                         .with(kind.name, needed_question(kind)));
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
                       phrase("Protocols",
                              "a question that states its form is additional, and a %1 needs %2; "
                              "remove this key from the question that the analysis is about")
                           .with(kind.name, needed_question(kind)));
  } else if (own == 0 || (own > 1 && !kind.asks_several)) {
    checked.report(block.has_question_list ? pointer + "/questions" : pointer + "/question",
                   phrase("Protocols",
                          "a %1 needs %2 in every trial; number given: %3; add or remove questions")
                       .with(kind.name, needed_question(kind), std::to_string(own)));
  }
  if (block.feedback != Block::Feedback::none && kind.correct_of == nullptr) {
    checked.report(pointer + "/feedback",
                   phrase("Protocols",
                          "feedback needs a correct response, and no response of a %1 is correct "
                          "or incorrect; set it to %2")
                       .with(kind.name, word_name("none")));
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
    checked.report(
        at, phrase("Protocols",
                   "the maximum of the scale, %1, must be greater than its minimum, %2; raise %3")
                .with(digits(scale.maximum), digits(scale.minimum), key_name("maximum")));
  }
  const std::size_t labels = scale.labels.size();
  if (labels == 0 || labels == 2 || labels == static_cast<std::size_t>(scale.points)) return;
  checked.report(
      at + "/labels",
      phrase("Protocols",
             "a scale has labels for its two ends or for all of its points; labels "
             "given: %1, points: %2; add or remove labels")
          .with(std::to_string(labels), scale.points == 0 ? phrase("Protocols", "none")
                                                          : Phrase(std::to_string(scale.points))));
}

}  // namespace asperity
