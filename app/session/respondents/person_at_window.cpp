// Polls a queue of inputs, judges each by the current scene, and publishes the changed scene.

#include "app/session/respondents/person_at_window.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "app/session/respondents/sheets/answer_sheet.h"
#include "app/session/respondents/visit_tally.h"

namespace asperity {

namespace {

using Kind = ParticipantInput::Kind;

constexpr double kLongestPoll_s = 0.01;
constexpr double kShortestPoll_s = 0.001;  // the resolution of a session's clock is no finer
constexpr double kFeedback_s = 1.5;        // long enough to be read
// Longest delay between a key press and its arrival here while a window is busy.
constexpr double kHandedOn_s = 0.05;
// No participant enters more than this between two polls; a key is stuck.
constexpr std::size_t kMostWaiting = 1000;

}  // namespace

/// The state between inputs and answers.
struct PersonAtWindow::Desk {
  Desk(SessionMonitor& monitor_, Sound* sound_) : monitor(monitor_), sound(sound_) {}

  SessionMonitor& monitor;
  Sound* sound = nullptr;

  std::mutex mutex{};
  // under the mutex; all other members belong to the conductor
  std::deque<ParticipantInput> inputs{};

  std::vector<EventRow> events{};
  std::string source = "keyboard";
  std::optional<std::int64_t> answered_ns{};                     ///< the last question of a form
  ParticipantScene::Kind shown = ParticipantScene::Kind::blank;  ///< the current scene
  std::uint64_t cues = 0;     ///< a new scene may begin without the number of the last cue
  std::int64_t shown_ns = 0;  ///< inputs stamped earlier were meant for another scene
  /// Inputs stamped earlier cannot refer to the current state of the scene.
  std::int64_t perceived_ns = 0;
  /// A request to feel again that is stamped earlier was meant to finish.
  std::int64_t unexpected_until_ns = 0;
  std::optional<std::int64_t> deadline_ns{};  ///< inputs stamped later came too late
  std::int64_t private_until_ns = 0;          ///< the end of the last form

  std::vector<std::string> codes{};  ///< of the trial's surfaces, by position
  std::set<int> felt{};              ///< positions, of this attempt
  int now = 0;                       ///< position of the current surface; 0 between surfaces
  int last_felt = 0;
  /// A surface was announced, and the participant has not requested to finish.
  bool ends_without_request = false;
  std::optional<int>
      untouched{};  ///< the surface of a visit without contact, to be reported with the question
  VisitTally visits{};                   ///< of this attempt
  bool is_side_by_side = false;          ///< all surfaces of the trial are felt at once
  std::unique_ptr<AnswerSheet> sheet{};  ///< kept while surfaces are felt again
  std::string sheet_question{};          ///< the first of its page, by name

  std::map<int, std::int64_t> buttons_down{};
  std::map<int, std::int64_t> buttons_let_go{};
  std::atomic<bool> more_to_read{false};

  /// Ensures that a scene of one of `kinds` is shown: the conductor's, which contains what only it
  /// has (progress, workspace), or `plain` where there is none of these kinds yet.
  void face(std::initializer_list<ParticipantScene::Kind> kinds, ParticipantScene plain);
  /// Shows the screen between two surfaces, where cues are shown too. Earlier inputs are refused as
  /// well.
  void see_ground_between();
  /// Does nothing while the conductor shows something else (a pause).
  void change(const std::function<void(ParticipantScene&)>& alter);
  void put(ParticipantInput input);
  /// Marks a change of meaning at `time_ns`: inputs that follow it too closely do not count.
  void change_meaning(std::int64_t time_ns) {
    perceived_ns = time_ns + std::llround(1e9 * kTooSoon_s);
  }
  /// An input as the store has it: what is done in a form is private, and only its answer is stored.
  std::string described(const ParticipantInput& input) const {
    const bool is_private =
        shown == ParticipantScene::Kind::form || input.time_ns < private_until_ns;
    return is_private ? "answer" : description_of(input);
  }
  /// The next input that is meant for the present scene.
  std::optional<ParticipantInput> hear();
  /// Shows a cue in the scene.
  void remind(ParticipantMessage message);
  void refuse(const ParticipantInput& input, ParticipantMessage message);
  /// Refuses an answer before the question is asked: surface `to_feel` has to be felt first.
  void refuse_answer(const ParticipantInput& input, std::optional<int> to_feel);
  void play(Cue cue, int number = 0) const {
    if (sound != nullptr) sound->play(cue, number);
  }
  /// Processes inputs until `heard` is done (true) or the time is over (false). The time is taken
  /// from the session's clock, because every wait takes slightly longer than requested.
  bool listen(const Wait& wait, std::optional<std::int64_t> until_ns,
              const std::function<bool(const ParticipantInput&)>& heard);
  std::int64_t after_shown_ns(double duration_s) const {
    return shown_ns + std::llround(1e9 * duration_s);
  }

  /// A button press that turned a page has no further effect.
  bool turned_page(const ParticipantInput& input);
  void wait_for_confirmation(const Wait& wait);

  void leave_surface();
  std::vector<int> felt_positions() const { return {felt.begin(), felt.end()}; }
  /// The position of a surface other than the current one that has not been felt yet.
  std::optional<int> other_unfelt() const;
  /// The position of the surface that a wish without a name means: where surfaces are felt on request the chosen one, or
  /// one that has not been felt often enough; otherwise the next in turn.
  int wished(const Trial& trial) const;
  void know_codes(const Trial& trial) {
    codes.clear();
    for (const PlannedPresentation& planned : trial.presentations) codes.push_back(planned.code);
  }
  const std::string& code_of(int position) const {
    return codes.at(static_cast<std::size_t>(position - 1));
  }

  /// Applies an input to the answer of the trial; returns a reply once there is one.
  std::optional<Reply> hear_answer(const Trial& trial, const ParticipantInput& input);
  std::optional<Reply> hear_wish(const Trial& trial, const ParticipantInput& input);
  void show_sheet(const Trial& trial);
};

void PersonAtWindow::Desk::face(std::initializer_list<ParticipantScene::Kind> kinds,
                                ParticipantScene plain) {
  SessionSnapshot snapshot = monitor.snapshot();
  if (std::find(kinds.begin(), kinds.end(), snapshot.scene->kind) == kinds.end()) {
    monitor.show(std::move(plain));
    snapshot = monitor.snapshot();
  }
  shown = snapshot.scene->kind;
  shown_ns = snapshot.scene->shown_ns != 0 ? snapshot.scene->shown_ns
                                           : std::max(snapshot.now_ns, snapshot.phase_began_ns);
  change_meaning(shown_ns);
  deadline_ns.reset();
}

void PersonAtWindow::Desk::see_ground_between() {
  const std::shared_ptr<const ParticipantScene> scene = monitor.snapshot().scene;
  if (scene->kind == ParticipantScene::Kind::blank && !scene->surfaces.empty()) shown = scene->kind;
}

void PersonAtWindow::Desk::change(const std::function<void(ParticipantScene&)>& alter) {
  ParticipantScene scene = *monitor.snapshot().scene;  // only this thread shows scenes
  if (scene.kind != shown) return;
  alter(scene);
  monitor.show(std::move(scene));
}

void PersonAtWindow::Desk::put(ParticipantInput input) {
  const std::lock_guard lock(mutex);
  if (inputs.size() < kMostWaiting) inputs.push_back(std::move(input));
}

std::optional<ParticipantInput> PersonAtWindow::Desk::hear() {
  for (;;) {
    ParticipantInput input{};
    {
      const std::lock_guard lock(mutex);
      if (inputs.empty()) return {};
      input = std::move(inputs.front());
      inputs.pop_front();
    }
    const bool is_release = input.kind == Kind::released;
    const bool is_stale = !is_release && input.time_ns < shown_ns;
    const bool is_too_soon = !is_release && !is_stale &&
                             (input.time_ns < perceived_ns ||
                              (input.kind == Kind::next && input.time_ns < unexpected_until_ns));
    nlohmann::ordered_json data{{"source", input.source}};
    if (input.held_s > 0.0) data["held_s"] = input.held_s;
    const bool is_late = !is_release && deadline_ns && input.time_ns > *deadline_ns;
    if (is_stale) data["meant_for_an_earlier_scene"] = true;
    if (is_too_soon) data["too_soon"] = true;
    if (is_late) data["after_the_deadline"] = true;
    const auto held_ns = static_cast<std::int64_t>(std::llround(1e9 * input.held_s));
    events.push_back({is_release ? input.time_ns + held_ns : input.time_ns,
                      is_release ? "input_released" : "input", described(input), data.dump()});
    if (!is_release && !is_stale && !is_too_soon && !is_late) return input;
  }
}

void PersonAtWindow::Desk::remind(ParticipantMessage message) {
  change([&](ParticipantScene& scene) {
    scene.cue = text_of(message);
    scene.cue_message = std::move(message);
    cues = std::max(cues, scene.cue_number) + 1;
    scene.cue_number = cues;
  });
}

void PersonAtWindow::Desk::refuse(const ParticipantInput& input, ParticipantMessage message) {
  events.push_back({input.time_ns, "refused", text_of(message),
                    nlohmann::ordered_json{{"input", described(input)}}.dump()});
  remind(std::move(message));
  play(Cue::refused);
}

void PersonAtWindow::Desk::refuse_answer(const ParticipantInput& input,
                                         std::optional<int> to_feel) {
  if (is_side_by_side && now != 0) {
    refuse(input, {.what = ParticipantMessage::What::finish_first});
  } else if (to_feel) {
    refuse(input, {.what = ParticipantMessage::What::feel_first, .code = code_of(*to_feel)});
  } else {
    refuse(input, {.what = ParticipantMessage::What::not_asked_yet});
  }
}

bool PersonAtWindow::Desk::listen(const Wait& wait, std::optional<std::int64_t> until_ns,
                                  const std::function<bool(const ParticipantInput&)>& heard) {
  for (;;) {
    while (const std::optional<ParticipantInput> input = hear()) {
      if (heard(*input)) return true;
    }
    double slice_s = kLongestPoll_s;
    if (until_ns) {
      const std::int64_t left_ns = *until_ns - monitor.snapshot().now_ns;
      if (left_ns <= 0) return false;
      slice_s = std::clamp(1e-9 * static_cast<double>(left_ns), kShortestPoll_s, kLongestPoll_s);
    }
    wait(slice_s);
  }
}

bool PersonAtWindow::Desk::turned_page(const ParticipantInput& input) {
  if (input.kind != Kind::device_button || !more_to_read) return false;
  change([](ParticipantScene& scene) { ++scene.pages_turned; });
  return true;
}

void PersonAtWindow::Desk::wait_for_confirmation(const Wait& wait) {
  change([](ParticipantScene& scene) { scene.can_confirm = true; });
  listen(wait, {},
         [this](const ParticipantInput& input) { return !turned_page(input) && continues(input); });
}

void PersonAtWindow::Desk::leave_surface() {
  if (now == 0) return;
  felt.insert(now);
  for (int position = 1; is_side_by_side && position <= static_cast<int>(codes.size());
       ++position) {
    felt.insert(position);
  }
  last_felt = now;
  now = 0;
}

int PersonAtWindow::Desk::wished(const Trial& trial) const {
  if (trial.arrangement.surfaces == Arrangement::Surfaces::on_request) {
    const std::optional<int> chosen = sheet->chosen_surface();
    if (chosen && visits.may_visit(trial, *chosen)) return *chosen;
    if (const std::optional<int> owed = visits.owed(trial, last_felt)) return *owed;
  }
  const int in_turn = last_felt % static_cast<int>(trial.presentations.size()) + 1;
  return visits.next(trial, last_felt).value_or(in_turn);
}

std::optional<int> PersonAtWindow::Desk::other_unfelt() const {
  for (int position = 1; position <= static_cast<int>(codes.size()); ++position) {
    if (position != now && !felt.contains(position)) return position;
  }
  return {};
}

// --- a page of questions -------------------------------------------------------------------------

void PersonAtWindow::Desk::show_sheet(const Trial& trial) {
  change([&](ParticipantScene& scene) {
    sheet->mark(scene);
    if (trial.arrangement.surfaces == Arrangement::Surfaces::on_request) {
      scene.wished_surface = wished(trial);
    }
    scene.cue.clear();
    scene.cue_message = {};
  });
}

std::optional<Reply> PersonAtWindow::Desk::hear_answer(const Trial& trial,
                                                       const ParticipantInput& input) {
  const SheetResult result = sheet->take(input);
  if (const auto* const answers = std::get_if<GivenAnswers>(&result)) {
    if (const std::optional<int> owed = visits.owed(trial, last_felt)) {
      refuse_answer(input, owed);
      return {};
    }
    source = input.source;
    return Reply{*answers, input.time_ns};
  }
  if (std::holds_alternative<WishToFeelAgain>(result)) return hear_wish(trial, input);
  if (const auto* const refused = std::get_if<SheetRefused>(&result)) {
    refuse(input, refused->message);
  } else if (const auto* const changed = std::get_if<SheetChanged>(&result)) {
    // A held button takes effect when it is released.
    if (changed->needs_new_reading) {
      change_meaning(input.time_ns + std::llround(1e9 * input.held_s));
    }
    show_sheet(trial);
    if (changed->cue) play(*changed->cue, changed->number);
  } else if (std::holds_alternative<PointedAtFeelingAgain>(result)) {
    show_sheet(trial);
    remind({.what = visits.of(wished(trial)) == 0 ? ParticipantMessage::What::feel_named
                                                  : ParticipantMessage::What::feel_again,
            .code = code_of(wished(trial))});
    play(Cue::surface, wished(trial));
  }
  return {};
}

/// A wish to feel a surface (again): the one that was named, or the one that is meant without a name.
std::optional<Reply> PersonAtWindow::Desk::hear_wish(const Trial& trial,
                                                     const ParticipantInput& input) {
  if (trial.presentations.empty()) return {};
  if (!trial.arrangement.allows_revisits()) {
    refuse(input, {.what = ParticipantMessage::What::no_going_back});
    return {};
  }
  sheet->forget_feeling_again();
  const int position = input.kind == Kind::surface ? input.number : wished(trial);
  if (!visits.may_visit(trial, position)) {
    refuse(input, {.what = ParticipantMessage::What::felt_often_enough, .code = code_of(position)});
    return {};
  }
  return Reply{FeelAgain{position}, input.time_ns};
}

// --- the participant -----------------------------------------------------------------------------

PersonAtWindow::PersonAtWindow(SessionMonitor& monitor, Sound* sound)
    : desk_(std::make_unique<Desk>(monitor, sound)) {}

PersonAtWindow::~PersonAtWindow() = default;

void PersonAtWindow::post(ParticipantInput input) { desk_->put(std::move(input)); }

void PersonAtWindow::set_sound(Sound* sound) { desk_->sound = sound; }

void PersonAtWindow::set_more_to_read(bool more) { desk_->more_to_read = more; }

void PersonAtWindow::read(const std::string& text, double minimum_s, const Wait& wait) {
  desk_->face({ParticipantScene::Kind::text, ParticipantScene::Kind::rest}, scene_to_read(text));
  if (minimum_s > 0.0) {
    // In a scene with a countdown, until the countdown ends.
    const std::int64_t until_ns =
        desk_->monitor.snapshot().scene->rest_until_ns.value_or(desk_->after_shown_ns(minimum_s));
    const bool is_over = desk_->listen(wait, until_ns, [&](const ParticipantInput& input) {
      if (desk_->turned_page(input) || !continues(input)) return false;
      if (input.time_ns >= until_ns) return true;
      const double left_s = 1e-9 * static_cast<double>(until_ns - input.time_ns);
      desk_->refuse(input, {.what = ParticipantMessage::What::wait,
                            .number = static_cast<int>(std::ceil(left_s))});
      return false;
    });
    if (is_over) return;
    // A button that is still held was pressed before the break had reached its minimum.
    desk_->shown_ns = until_ns;
  }
  desk_->wait_for_confirmation(wait);
}

void PersonAtWindow::put_mask(bool on, const Wait& wait) {
  desk_->face({on ? ParticipantScene::Kind::mask_on : ParticipantScene::Kind::mask_off},
              scene_of_mask(on));
  desk_->play(on ? Cue::mask_on : Cue::mask_off);
  desk_->wait_for_confirmation(wait);
}

void PersonAtWindow::begin_attempt(int, int) {
  desk_->felt.clear();
  desk_->visits.clear();
  desk_->codes.clear();
  desk_->is_side_by_side = false;
  desk_->now = 0;
  desk_->last_felt = 0;
  desk_->ends_without_request = false;
  desk_->unexpected_until_ns = 0;
  desk_->untouched.reset();
  desk_->sheet.reset();
}

void PersonAtWindow::announce(const Trial& trial, const PlannedPresentation& surface) {
  desk_->leave_surface();
  desk_->now = surface.position;
  desk_->ends_without_request = true;
  desk_->unexpected_until_ns = 0;
  desk_->visits.add(surface.position);
  desk_->know_codes(trial);
  desk_->is_side_by_side = trial.arrangement.surfaces == Arrangement::Surfaces::side_by_side;
  desk_->face({ParticipantScene::Kind::feel},
              desk_->is_side_by_side
                  ? scene_of_patches(trial)
                  : scene_of_surface(trial, desk_->felt_positions(), surface.position));
}

bool PersonAtWindow::wants_next(bool may_go) {
  const std::optional<int> next = desk_->is_side_by_side ? std::nullopt : desk_->other_unfelt();
  std::optional<int> to_feel = next;
  if (!to_feel && !desk_->is_side_by_side && !desk_->felt.contains(desk_->now)) {
    to_feel = desk_->now;
  }
  while (const std::optional<ParticipantInput> input = desk_->hear()) {
    switch (input->kind) {
      case Kind::next:
        break;
      case Kind::surface:
        if (input->number == next) break;
        // The letter of any other surface is the answer to a choice.
        desk_->refuse_answer(*input, to_feel);
        continue;
      case Kind::device_button:
        if (input->number == 1) break;
        [[fallthrough]];
      case Kind::option:
      case Kind::assign:
      case Kind::mark:
      case Kind::confirm:
        desk_->refuse_answer(*input, to_feel);
        continue;
      case Kind::step:
      case Kind::select:
      case Kind::click:
      case Kind::text:
      case Kind::released:
        continue;
    }
    if (may_go) {
      desk_->ends_without_request = false;
      return true;
    }
    if (desk_->is_side_by_side) {
      desk_->refuse(*input, {.what = ParticipantMessage::What::feel_all_longer});
      continue;
    }
    desk_->refuse(*input, {.what = ParticipantMessage::What::feel_longer,
                           .code = desk_->code_of(desk_->now)});
  }
  return false;
}

void PersonAtWindow::visit_was_without_contact(int position) {
  desk_->visits.take_back(position);
  desk_->untouched = position;
  desk_->now = 0;  // it was not felt
}

void PersonAtWindow::refuse_answers() {
  const std::optional<int> next = desk_->other_unfelt();
  desk_->see_ground_between();
  while (const std::optional<ParticipantInput> input = desk_->hear()) {
    switch (input->kind) {
      case Kind::surface:
        if (input->number == next) continue;  // it comes next
        break;
      case Kind::device_button:
        if (input->number == 1) continue;
        break;
      case Kind::option:
      case Kind::assign:
      case Kind::mark:
      case Kind::confirm:
      case Kind::click:
        break;
      case Kind::step:
      case Kind::select:
      case Kind::next:  // the participant already continues
      case Kind::text:
      case Kind::released:
        continue;
    }
    desk_->refuse_answer(*input, next);
  }
}

Reply PersonAtWindow::ask(const Trial& trial, std::span<const Question> page,
                          std::span<const ForceFeatures>, std::optional<double> deadline_s,
                          const Wait& wait) {
  desk_->leave_surface();
  desk_->know_codes(trial);  // on request the question comes before the first surface
  if (!desk_->sheet || desk_->sheet_question != page.front().name) {
    desk_->sheet = sheet_for(trial, page);
    desk_->sheet_question = page.front().name;
  }
  desk_->face({ParticipantScene::Kind::question},
              scene_of_question(trial, page, desk_->felt_positions()));
  desk_->show_sheet(trial);
  desk_->unexpected_until_ns =
      std::exchange(desk_->ends_without_request, false) ? desk_->after_shown_ns(kUnexpected_s) : 0;
  if (const std::optional<int> untouched = std::exchange(desk_->untouched, {})) {
    desk_->remind(
        {.what = ParticipantMessage::What::not_touched, .code = desk_->code_of(*untouched)});
    desk_->play(Cue::refused);
  }
  std::optional<std::int64_t> until_ns{};
  if (deadline_s) {
    desk_->deadline_ns = desk_->after_shown_ns(*deadline_s);
    until_ns = desk_->after_shown_ns(*deadline_s + kHandedOn_s);
  }
  std::optional<Reply> reply{};
  desk_->listen(wait, until_ns, [&](const ParticipantInput& input) {
    reply = desk_->hear_answer(trial, input);
    return reply.has_value();
  });
  desk_->unexpected_until_ns = 0;
  return reply.value_or(Reply{});
}

void PersonAtWindow::tell(const std::string& text, const Wait& wait) {
  ParticipantScene plain{};
  plain.kind = ParticipantScene::Kind::feedback;
  plain.text = text;
  desk_->face({ParticipantScene::Kind::feedback}, std::move(plain));
  desk_->listen(wait, desk_->after_shown_ns(kFeedback_s), continues);
}

std::optional<Answer> PersonAtWindow::answer(const Question& question, const Wait& wait) {
  static const Trial kWithoutSurfaces{.arrangement = {.maximum_visits = 1}};
  desk_->sheet = sheet_for(kWithoutSurfaces, {&question, 1});
  desk_->face({ParticipantScene::Kind::form}, scene_of_form(question));
  desk_->show_sheet(kWithoutSurfaces);
  std::optional<Reply> reply{};
  desk_->listen(wait, {}, [&](const ParticipantInput& input) {
    reply = desk_->hear_answer(kWithoutSurfaces, input);
    return reply.has_value();
  });
  desk_->sheet.reset();
  desk_->private_until_ns = desk_->monitor.snapshot().now_ns;
  desk_->answered_ns = reply->answered_ns;
  const Answer* const answer = reply->answer();
  return answer == nullptr ? std::nullopt : std::optional(*answer);
}

std::optional<std::int64_t> PersonAtWindow::answered_ns() const { return desk_->answered_ns; }

std::string PersonAtWindow::source() const { return desk_->source; }

void PersonAtWindow::button_changed(const ButtonChange& change) {
  if (change.down) {
    const auto let_go = desk_->buttons_let_go.find(change.button);
    if (let_go != desk_->buttons_let_go.end() &&
        1e-9 * static_cast<double>(change.time_ns - let_go->second) < kBounce_s) {
      return;
    }
    desk_->buttons_down[change.button] = change.time_ns;
    // The first button's effect depends on how long it is held.
    if (change.button == 1) return;
  }
  if (!change.down) desk_->buttons_let_go[change.button] = change.time_ns;
  const auto pressed = desk_->buttons_down.find(change.button);
  if (pressed == desk_->buttons_down.end()) return;  // down since before the session, or bouncing
  ParticipantInput input{};
  input.kind = Kind::device_button;
  input.number = change.button;
  input.time_ns = pressed->second;
  input.source = "device_button";
  if (!change.down) {
    input.held_s = 1e-9 * static_cast<double>(change.time_ns - pressed->second);
    desk_->buttons_down.erase(pressed);
    if (change.button != 1) {
      input.text = description_of(input);
      input.kind = Kind::released;
    }
  }
  desk_->put(std::move(input));
}

std::vector<EventRow> PersonAtWindow::take_events() { return std::exchange(desk_->events, {}); }

}  // namespace asperity
