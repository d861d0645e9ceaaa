// A participant at a window with a script of what is pressed when, on a clock that only waiting moves.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/session/respondents/person_at_window.h"
#include "tests/support/replies.h"
#include "tests/support/scripted_sound.h"

namespace asperity {

class PersonAtWindowTest : public testing::Test {
 protected:
  using Kind = ParticipantInput::Kind;
  using Options = std::vector<std::size_t>;
  static constexpr double kBegin_s = 100.0;
  PersonAtWindowTest() {
    monitor_.update([this](SessionSnapshot& snapshot) { snapshot.now_ns = now_ns_; });
  }

  static std::int64_t nanoseconds(double time_s) {
    return static_cast<std::int64_t>(std::llround(1e9 * time_s));
  }

  /// A selection of three surfaces, "cannot tell" allowed.
  static Trial selection() {
    Trial trial{};
    trial.ordinal = 1;
    trial.questions.resize(1);
    for (int position = 1; position <= 3; ++position) {
      PlannedPresentation planned{};
      planned.position = position;
      planned.code = std::string(1, static_cast<char>('A' + position - 1));
      trial.presentations.push_back(planned);
      trial.questions.front().options.push_back({"item", planned.code, std::nullopt});
    }
    trial.questions.front().options.push_back({"cannot_tell", "I cannot tell", std::nullopt});
    trial.questions.front().prompt = "Which one?";
    return trial;
  }

  /// Three surfaces to as many pictures; nothing is felt again.
  static Trial matching() {
    Trial trial = selection();
    trial.questions.front().form = AssignmentForm{};
    trial.questions.front().options.clear();
    for (int place = 1; place <= 3; ++place) {
      trial.questions.front().options.push_back(
          {"texture", std::to_string(place), "stimuli/picture.png"});
    }
    trial.arrangement.maximum_visits = 1;
    trial.pictures_after_feeling = true;
    return trial;
  }

  /// `after_s` counts from now.
  void press(double after_s, ParticipantInput input) {
    input.time_ns = now_ns_ + nanoseconds(after_s);
    script_.emplace(input.time_ns, std::move(input));
  }
  void press(double after_s, Kind kind, int number = 0, int surface = 0) {
    press(after_s, {.kind = kind, .number = number, .surface = surface});
  }
  void type(double after_s, const std::string& text) {
    press(after_s, {.kind = Kind::text, .text = text});
  }
  /// A device button, down for `held_s`.
  void hold_button(double after_s, int button, double held_s) {
    buttons_.emplace(now_ns_ + nanoseconds(after_s),
                     ButtonChange{button, true, now_ns_ + nanoseconds(after_s)});
    buttons_.emplace(now_ns_ + nanoseconds(after_s + held_s),
                     ButtonChange{button, false, now_ns_ + nanoseconds(after_s + held_s)});
  }

  void pass(double duration_s) {
    now_ns_ += nanoseconds(duration_s);
    if (now_ns_ > nanoseconds(kBegin_s + 600.0)) throw std::runtime_error("waits for ever");
    monitor_.update([this](SessionSnapshot& snapshot) { snapshot.now_ns = now_ns_; });
    while (!script_.empty() && script_.begin()->first <= now_ns_) {
      person_.post(script_.begin()->second);
      script_.erase(script_.begin());
    }
    while (!buttons_.empty() && buttons_.begin()->first <= now_ns_) {
      person_.button_changed(buttons_.begin()->second);
      buttons_.erase(buttons_.begin());
    }
  }

  /// Presents all surfaces, as a conductor does.
  void feel_all(const Trial& trial) {
    person_.begin_attempt(trial.ordinal, ++attempt_);
    for (const PlannedPresentation& surface : trial.presentations) feel(trial, surface.position);
  }
  void feel(const Trial& trial, int position) {
    monitor_.show(scene_of_surface(trial, {}, position));
    person_.announce(trial, trial.presentations.at(static_cast<std::size_t>(position - 1)));
    pass(1.0);
    monitor_.show({});
  }
  Reply ask(const Trial& trial, std::optional<double> deadline_s = {}) {
    ParticipantScene scene = scene_of_question(trial, trial.questions, {1, 2, 3});
    scene.block = 3;
    scene.blocks = 6;
    monitor_.show(std::move(scene));
    return person_.ask(trial, trial.questions, {}, deadline_s, wait_);
  }
  Reply feel_all_and_ask(const Trial& trial, std::optional<double> deadline_s = {}) {
    feel_all(trial);
    return ask(trial, deadline_s);
  }
  /// What was seen while waiting, at `after_s` from now.
  void look(double after_s, std::function<void(const ParticipantScene&)> see) {
    looks_.emplace(now_ns_ + nanoseconds(after_s), std::move(see));
  }

  std::shared_ptr<const ParticipantScene> scene() const { return monitor_.snapshot().scene; }
  std::vector<EventRow> events(const std::string& kind) {
    for (EventRow& event : person_.take_events()) events_.push_back(std::move(event));
    std::vector<EventRow> found{};
    std::copy_if(events_.begin(), events_.end(), std::back_inserter(found),
                 [&kind](const EventRow& event) { return event.kind == kind; });
    return found;
  }

  std::int64_t now_ns_ = nanoseconds(kBegin_s);
  SessionMonitor monitor_{};
  SoundLog sound_{};
  ScriptedSound loudspeakers_{sound_};
  PersonAtWindow person_{monitor_, &loudspeakers_};
  std::multimap<std::int64_t, ParticipantInput> script_{};
  std::multimap<std::int64_t, ButtonChange> buttons_{};
  std::multimap<std::int64_t, std::function<void(const ParticipantScene&)>> looks_{};
  std::vector<EventRow> events_{};
  int attempt_ = 0;
  Wait wait_ = [this](double duration_s) {
    pass(duration_s);
    while (!looks_.empty() && looks_.begin()->first <= now_ns_) {
      looks_.begin()->second(*scene());
      looks_.erase(looks_.begin());
    }
  };
};

}  // namespace asperity
