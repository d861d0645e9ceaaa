#include "app/session/respondents/answer_sheet.h"

#include <algorithm>

namespace asperity {

AnswerSheet::AnswerSheet(const Trial& trial)
    : is_assignment_(trial.question.form == TrialQuestion::Form::assignment),
      may_feel_again_(trial.question.allow_revisit),
      options_(trial.question.options.size()),
      given_(is_assignment_ ? trial.presentations.size() : 1) {}

void AnswerSheet::choose(std::size_t option) { assign(option, turn_); }

void AnswerSheet::assign(std::size_t option, std::size_t surface) {
  take_back(option);
  given_.at(surface) = option;
  pointed_.reset();
  turn_ = surface;
  pass_turn();
}

void AnswerSheet::take_back(std::size_t option) {
  for (std::optional<std::size_t>& given : given_) {
    if (given == option) given.reset();
  }
  forget_feeling_again();
}

void AnswerSheet::turn_to(std::size_t surface) {
  turn_ = surface;
  pointed_.reset();
  forget_feeling_again();
}

void AnswerSheet::pass_turn() {
  const std::size_t next = (turn_ + 1) % given_.size();
  for (std::size_t i = 0; i < given_.size(); ++i) {
    const std::size_t surface = (next + i) % given_.size();
    if (!given_[surface]) {
      turn_ = surface;
      return;
    }
  }
  turn_ = next;
}

std::optional<std::size_t> AnswerSheet::point() {
  if (options_ == 0) return {};
  std::optional<std::size_t>& before = is_assignment_ ? pointed_ : given_.front();
  points_at_feeling_again_ = may_feel_again_ && before == options_ - 1;
  if (points_at_feeling_again_) {
    before.reset();
    return {};
  }
  const std::size_t option = before ? (*before + 1) % options_ : 0;
  if (is_assignment_) {
    pointed_ = option;
  } else {
    choose(option);
  }
  return option;
}

bool AnswerSheet::take_pointed() {
  if (!pointed_) return false;
  choose(*pointed_);
  return true;
}

bool AnswerSheet::is_complete() const noexcept { return !free_surface(); }

std::optional<std::size_t> AnswerSheet::free_surface() const noexcept {
  for (std::size_t i = 0; i < given_.size(); ++i) {
    if (!given_[i]) return i;
  }
  return {};
}

std::vector<std::size_t> AnswerSheet::answer() const {
  std::vector<std::size_t> answer{};
  for (const std::optional<std::size_t>& given : given_) answer.push_back(given.value());
  return answer;
}

void AnswerSheet::mark(ParticipantScene& scene) const {
  scene.can_confirm = is_complete() || points_at_feeling_again_;
  if (is_assignment_) scene.assigning = turn_;
  for (std::size_t option = 0; option < scene.choices.size(); ++option) {
    ParticipantScene::Choice& choice = scene.choices[option];
    choice.chosen = is_assignment_ ? pointed_ == option : given_.front() == option;
    choice.assigned_to.clear();
    for (std::size_t surface = 0; is_assignment_ && surface < given_.size(); ++surface) {
      if (given_[surface] == option) choice.assigned_to = scene.surfaces.at(surface).code;
    }
  }
}

}  // namespace asperity
