// Builds a scene for each state of a trial, and holds the English phrase of every message.

#include "app/session/respondents/participant_scene.h"

#include <algorithm>
#include <cstddef>

#include "analysis/numbers/number_text.h"

namespace asperity {

namespace {

bool contains(const std::vector<int>& positions, int position) {
  return std::find(positions.begin(), positions.end(), position) != positions.end();
}

std::vector<ParticipantScene::Surface> surfaces_of(const Trial& trial,
                                                   const std::vector<int>& felt) {
  std::vector<ParticipantScene::Surface> surfaces{};
  for (const PlannedPresentation& planned : trial.presentations) {
    surfaces.push_back({.code = planned.code, .felt = contains(felt, planned.position)});
  }
  return surfaces;
}

std::vector<ParticipantScene::Choice> choices_of(const Trial& trial, const Question& question) {
  std::vector<ParticipantScene::Choice> choices{};
  for (const Option& option : question.options) {
    ParticipantScene::Choice choice{};
    choice.picture = option.picture;
    const bool is_surface = std::any_of(
        trial.presentations.begin(), trial.presentations.end(),
        [&option](const PlannedPresentation& planned) { return planned.code == option.label; });
    if (option.picture || is_surface) {
      choice.key = option.label;
    } else if (!option.text.empty()) {
      choice.key =
          option.label.empty() ? key_of_option(static_cast<int>(choices.size()) + 1) : option.label;
      choice.text = option.text;
    } else {
      choice.key = "0";
      choice.message.what = ParticipantMessage::What::cannot_tell;
      choice.text = text_of(choice.message);
    }
    choices.push_back(std::move(choice));
  }
  return choices;
}

bool is_answered_by_pictures(const Question& question) {
  return std::any_of(question.options.begin(), question.options.end(),
                     [](const Option& option) { return option.picture.has_value(); });
}

ParticipantScene scene_that_says(ParticipantScene::Kind kind, ParticipantMessage message) {
  ParticipantScene scene{};
  scene.kind = kind;
  scene.text = text_of(message);
  scene.text_message = std::move(message);
  return scene;
}

}  // namespace

std::string key_of_option(int number) {
  constexpr int kDigits = 9;
  if (number <= kDigits) return std::to_string(number);
  return {static_cast<char>('A' + (number - kDigits - 1))};
}

Phrase phrase_of(const ParticipantMessage& message) {
  switch (message.what) {
    case ParticipantMessage::What::nothing:
      return {};
    case ParticipantMessage::What::feel_surface:
      return phrase("ParticipantWords", "Feel surface %1 now.").with(message.code);
    case ParticipantMessage::What::feel_patches:
      return (message.number == 2 ? phrase("ParticipantWords",
                                           "Feel surfaces %1 and %2 now. They lie side by side.")
                                  : phrase("ParticipantWords",
                                           "Feel surfaces %1 to %2 now. They lie side by side."))
          .with(message.code, message.last_code);
    case ParticipantMessage::What::lift_from_patches:
      return phrase("ParticipantWords",
                    "You have finished with these surfaces. Please lift the handle.");
    case ParticipantMessage::What::lift:
      return phrase("ParticipantWords",
                    "You have finished with surface %1. Please lift the handle.")
          .with(message.code);
    case ParticipantMessage::What::put_mask_on:
      return phrase("ParticipantWords", "Please put on the eye mask.");
    case ParticipantMessage::What::take_mask_off:
      return phrase("ParticipantWords", "Please take off the eye mask.");
    case ParticipantMessage::What::cannot_tell:
      return phrase("ParticipantWords", "I cannot tell");
    case ParticipantMessage::What::feel_first:
      return phrase("ParticipantWords", "Please feel surface %1 first.").with(message.code);
    case ParticipantMessage::What::feel_longer:
      return phrase("ParticipantWords", "Please feel surface %1 a little longer.")
          .with(message.code);
    case ParticipantMessage::What::feel_all_longer:
      return phrase("ParticipantWords",
                    "Please feel each of the surfaces again, and a little longer.");
    case ParticipantMessage::What::finish_first:
      return phrase("ParticipantWords", "Please finish with these surfaces first.");
    case ParticipantMessage::What::feel_named:
      return phrase("ParticipantWords", "Confirm to feel surface %1.").with(message.code);
    case ParticipantMessage::What::not_asked_yet:
      return phrase("ParticipantWords", "Please wait for the question.");
    case ParticipantMessage::What::wait:
      if (message.number == 1) return phrase("ParticipantWords", "Please wait 1 more second.");
      return phrase("ParticipantWords", "Please wait %1 more seconds.")
          .with(std::to_string(message.number));
    case ParticipantMessage::What::choose_first:
      return phrase("ParticipantWords", "Please choose first.");
    case ParticipantMessage::What::mark_first:
      return message.number == 1
                 ? phrase("ParticipantWords", "Please mark a point on the scale first.")
                 : phrase("ParticipantWords", "Please mark a point on every scale first.");
    case ParticipantMessage::What::assign_first:
      return phrase("ParticipantWords", "Please assign a picture to surface %1 first.")
          .with(message.code);
    case ParticipantMessage::What::feel_again:
      return phrase("ParticipantWords", "Confirm to feel surface %1 again.").with(message.code);
    case ParticipantMessage::What::no_going_back:
      return phrase("ParticipantWords",
                    "The surfaces cannot be felt again. Please answer without feeling them.");
    case ParticipantMessage::What::not_touched:
      return phrase("ParticipantWords", "Surface %1 was not touched.").with(message.code);
    case ParticipantMessage::What::felt_often_enough:
      return phrase("ParticipantWords",
                    "Surface %1 cannot be felt again. Please continue without it.")
          .with(message.code);
    case ParticipantMessage::What::was_right:
      return phrase("ParticipantWords", "Correct.");
    case ParticipantMessage::What::was_wrong:
      if (message.code.empty()) return phrase("ParticipantWords", "Incorrect.");
      return phrase("ParticipantWords", "Incorrect. The correct response is %1.")
          .with(message.code);
    case ParticipantMessage::What::answer_needed:
      return phrase("ParticipantWords", "Please answer this question.");
    case ParticipantMessage::What::typed_needed:
      return phrase("ParticipantWords", "Please confirm with the keyboard or on the screen.");
    case ParticipantMessage::What::number_needed:
      if (message.minimum && message.maximum) {
        return phrase("ParticipantWords", "Please enter a number from %1 to %2.")
            .with(number_text(*message.minimum), number_text(*message.maximum));
      }
      if (message.minimum) {
        return phrase("ParticipantWords", "Please enter a number of at least %1.")
            .with(number_text(*message.minimum));
      }
      if (message.maximum) {
        return phrase("ParticipantWords", "Please enter a number of at most %1.")
            .with(number_text(*message.maximum));
      }
      return phrase("ParticipantWords", "Please enter a number.");
    case ParticipantMessage::What::option_needed:
      return phrase("ParticipantWords", "Please choose one of the answers.");
    case ParticipantMessage::What::options_needed:
      return phrase("ParticipantWords", "Please choose one or more of the answers.");
    case ParticipantMessage::What::estimate_needed:
      return phrase("ParticipantWords", "Please enter a number above 0, such as 7 or 0.5.");
    case ParticipantMessage::What::line_needed:
      return phrase("ParticipantWords", "Please draw a line first.");
    case ParticipantMessage::What::estimate_unclear:
      return phrase("ParticipantWords",
                    "%1 is ambiguous. Please write thousands without a point or a comma, and "
                    "decimals with one or two decimal places.")
          .with(message.code);
    case ParticipantMessage::What::practice_resumes:
      return phrase("ParticipantWords",
                    "First, please do some practice trials again. They do not count. Confirm when "
                    "you are ready.");
    case ParticipantMessage::What::session_resumes:
      return phrase("ParticipantWords",
                    "The session continues where it was interrupted. Confirm when you are ready.");
    case ParticipantMessage::What::check_estimate:
      return phrase(
                 "ParticipantWords",
                 "Please check the number %1: enter it again, or enter the number that you meant.")
          .with(message.code);
  }
  return {};
}

std::string text_of(const ParticipantMessage& message) { return phrase_of(message).english(); }

ParticipantScene scene_to_read(const std::string& text) {
  ParticipantScene scene{};
  scene.kind = ParticipantScene::Kind::text;
  scene.text = text;
  return scene;
}

ParticipantScene scene_of_refresher() {
  return scene_that_says(ParticipantScene::Kind::text,
                         {.what = ParticipantMessage::What::practice_resumes});
}

ParticipantScene scene_of_resuming() {
  return scene_that_says(ParticipantScene::Kind::text,
                         {.what = ParticipantMessage::What::session_resumes});
}

namespace {

ParticipantScene scene_at_surface(const Trial& trial, const std::vector<int>& felt, int now,
                                  ParticipantMessage message) {
  for (const PlannedPresentation& planned : trial.presentations) {
    if (planned.position == now) message.code = planned.code;
  }
  ParticipantScene scene = scene_that_says(ParticipantScene::Kind::feel, std::move(message));
  scene.surfaces = surfaces_of(trial, felt);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    scene.surfaces[i].now = trial.presentations[i].position == now;
  }
  scene.can_finish = !trial.arrangement.strokes && !trial.arrangement.contact_s;
  scene.standard_picture = trial.standard_picture;
  // The pictures of the first question that has any: there is room for one set of them.
  const auto with_pictures =
      std::find_if(trial.questions.begin(), trial.questions.end(), is_answered_by_pictures);
  if (with_pictures != trial.questions.end() && !trial.pictures_after_feeling) {
    scene.choices = choices_of(trial, *with_pictures);
  }
  return scene;
}

}  // namespace

ParticipantScene scene_of_surface(const Trial& trial, const std::vector<int>& felt, int now) {
  return scene_at_surface(trial, felt, now, {.what = ParticipantMessage::What::feel_surface});
}

ParticipantScene scene_of_lifting(const Trial& trial, const std::vector<int>& felt, int now) {
  return scene_at_surface(trial, felt, now, {.what = ParticipantMessage::What::lift});
}

void add_guide(ParticipantScene& scene, const Exploration& exploration, const Protocol& protocol) {
  if (!is_guided_by_sight(exploration)) return;
  scene.guide = exploration;
  scene.guide_scale = guide_scale_of(protocol);
}

ParticipantScene scene_of_patches(const Trial& trial) {
  ParticipantMessage message{.what = ParticipantMessage::What::feel_patches,
                             .code = trial.presentations.front().code,
                             .last_code = trial.presentations.back().code,
                             .number = static_cast<int>(trial.presentations.size())};
  ParticipantScene scene = scene_at_surface(trial, {}, 0, std::move(message));
  for (ParticipantScene::Surface& surface : scene.surfaces) surface.now = true;
  return scene;
}

ParticipantScene scene_of_lifting_from_patches(const Trial& trial) {
  ParticipantScene scene =
      scene_at_surface(trial, {}, 0, {.what = ParticipantMessage::What::lift_from_patches});
  for (ParticipantScene::Surface& surface : scene.surfaces) surface.now = true;
  return scene;
}

bool is_guided_by_sight(const Exploration& exploration) noexcept {
  return exploration.guidance == Exploration::Guidance::bars ||
         exploration.guidance == Exploration::Guidance::moving_target;
}

double end_of_bar(const Band& band) {
  if (band.maximum) return 1.25 * *band.maximum;
  return 2.5 * band.minimum.value_or(0.0);
}

GuideScale guide_scale_of(const Protocol& protocol) {
  GuideScale scale{};
  for (const auto& [name, exploration] : protocol.explorations) {
    if (!is_guided_by_sight(exploration)) continue;
    scale.force_N = std::max(scale.force_N, end_of_bar(exploration.normal_force_N));
    scale.speed_m_per_s = std::max(scale.speed_m_per_s, end_of_bar(exploration.speed_m_per_s));
  }
  return scale;
}

ParticipantScene scene_between_surfaces(const Trial& trial, const std::vector<int>& felt) {
  ParticipantScene scene = scene_at_surface(trial, felt, 0, {});
  scene.kind = ParticipantScene::Kind::blank;
  return scene;
}

namespace {

/// The questions of a page, without the options.
ParticipantScene scene_that_asks(ParticipantScene::Kind kind, std::span<const Question> page) {
  const Question& question = page.front();
  ParticipantScene scene{};
  scene.kind = kind;
  scene.text = question.prompt;
  scene.question = question.name;
  scene.form = question.form;
  scene.optional = question.optional;
  for (const Question& each : page) {
    const auto* const scale = std::get_if<ScaleForm>(&each.form);
    if (scale == nullptr) continue;
    scene.scales.push_back({.prompt = page.size() == 1 ? "" : each.prompt, .form = *scale});
  }
  return scene;
}

}  // namespace

ParticipantScene scene_of_question(const Trial& trial, std::span<const Question> page,
                                   const std::vector<int>& felt) {
  ParticipantScene scene = scene_that_asks(ParticipantScene::Kind::question, page);
  scene.surfaces = surfaces_of(trial, felt);
  scene.can_switch = trial.arrangement.allows_revisits();
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const auto visits = std::count(felt.begin(), felt.end(), trial.presentations[i].position);
    scene.surfaces[i].can_go =
        scene.can_switch && trial.arrangement.may_visit(static_cast<int>(visits));
  }
  scene.can_switch = std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                                 [](const auto& surface) { return surface.can_go; });
  const bool all_felt =
      std::all_of(scene.surfaces.begin(), scene.surfaces.end(),
                  [](const ParticipantScene::Surface& surface) { return surface.felt; });
  if (all_felt || !trial.pictures_after_feeling) scene.choices = choices_of(trial, page.front());
  if (scene.is_answered_by<AssignmentForm>()) scene.assigning = 0;
  if (page.size() > 1) scene.text = trial.page_prompt;
  scene.standard_picture = trial.standard_picture;
  scene.response_open = true;
  return scene;
}

ParticipantScene scene_of_doubt(const Trial& trial, std::span<const Question> page,
                                const std::vector<int>& felt, double estimate) {
  ParticipantScene scene = scene_of_question(trial, page, felt);
  scene.text_message = {.what = ParticipantMessage::What::check_estimate,
                        .code = number_text(estimate)};
  scene.text = text_of(scene.text_message);
  return scene;
}

ParticipantScene scene_of_form(const Question& question) {
  ParticipantScene scene = scene_that_asks(ParticipantScene::Kind::form, {&question, 1});
  scene.choices = choices_of({}, question);
  return scene;
}

ParticipantScene scene_of_feedback(bool was_right, const std::string& right_answer) {
  ParticipantMessage message{.what = was_right ? ParticipantMessage::What::was_right
                                               : ParticipantMessage::What::was_wrong};
  if (!was_right) message.code = right_answer;
  return scene_that_says(ParticipantScene::Kind::feedback, std::move(message));
}

ParticipantScene scene_of_mask(bool on) {
  return on ? scene_that_says(ParticipantScene::Kind::mask_on,
                              {.what = ParticipantMessage::What::put_mask_on})
            : scene_that_says(ParticipantScene::Kind::mask_off,
                              {.what = ParticipantMessage::What::take_mask_off});
}

}  // namespace asperity
