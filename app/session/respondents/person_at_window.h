// The person at the participant's window, as the conductor meets them.

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/respondents/participant_input.h"
#include "app/session/respondents/respondent.h"
#include "app/session/session_monitor.h"
#include "app/session/sound/sound.h"

namespace asperity {

/// Takes what the participant does from whichever window or device it comes. The conductor shows
/// each scene in the monitor; this class keeps its marks: what is chosen, assigned, refused.
///
/// The rules of answering live here, without any window: digits and letters choose, `next` switches
/// surfaces where that is allowed, `confirm` answers when the answer is complete; an answer before
/// the question is there (while a surface is felt, while the hand lifts) is refused with a cue; each
/// picture is given once, and an assignment may be changed until it is confirmed (AnswerSheet).
///
/// No response is accepted to what cannot have been perceived. What was pressed before a scene was shown, or less
/// than `kTooSoon_s` after, is stored and does nothing else: a key pressed twice and a button that
/// bounces never answer the scene that the first press brought. Even an expected light that calls
/// for one key takes 0.21 s on average [Woods 2015]; what has to be read or chosen takes longer. The
/// same holds after a confirmation by device button that changed what the next one would mean. A
/// button down again within `kBounce_s` has not been released. What was pressed after the deadline
/// does nothing either, however soon it is heard; what was pressed before it counts when it is heard
/// up to 0.05 s after it, by which time a busy window has handed it on.
///
/// With device buttons alone: button 1 steps through the options, a tone for each; button 2, or
/// button 1 held for 0.8 s, confirms. In an assignment that gives the option to the surface whose
/// turn it is, with the next surface's tone, and once more confirms the whole. Where surfaces may be
/// felt again, the step after the last option is that wish: the tone of the surface that would be
/// felt sounds, nothing is chosen, and the same confirmation asks for it. So whatever a confirmation
/// does was heard before it, and needs one button only. While a surface is felt button 1 goes on to
/// the next; where something is read any button turns the page, and goes on from the last one.
///
/// Tones that answer what a person did (option, refused, mask) come from here; those of the trial
/// (surface, question, accepted, …) from the conductor.
///
/// Events: "input" (what, its source, whether it came too late or early to count), "input_released",
/// "refused" (the cue's words). What is typed into a form is its answer and no event.
///
/// Threads: `post` and `set_more_to_read` from any thread; everything else from the conductor's.
///
/// [Woods 2015] Woods et al.: Factors influencing the latency of simple reaction time.
class PersonAtWindow final : public Respondent {
 public:
  /// By the time stamp of what was pressed, from when the scene was shown.
  static constexpr double kTooSoon_s = 0.2;
  /// Contacts of a switch bounce for a few milliseconds; no finger is back so soon.
  static constexpr double kBounce_s = 0.02;

  /// `monitor` and `sound` (may be null) must outlive this.
  PersonAtWindow(SessionMonitor& monitor, Sound* sound);
  ~PersonAtWindow() override;

  /// The sound that is played from now on; must outlive this.
  void set_sound(Sound* sound);

  /// From any thread. Inputs are heard in the order of posting; what the present scene has no use
  /// for does nothing.
  void post(ParticipantInput input);
  /// What is read has pages after the one that the window shows: a button of the device turns to the
  /// next (ParticipantScene::pages_turned). Keys and mouse turn it in the window.
  void set_more_to_read(bool more);

  void read(const std::string& text, double minimum_s, const Wait& wait) override;
  void announce(const Trial& trial, const PlannedPresentation& surface) override;
  Reply ask(const Trial& trial, std::span<const ForceFeatures> felt,
            std::optional<double> deadline_s, const Wait& wait) override;
  void tell(const std::string& text, const Wait& wait) override;
  std::string answer(const Question& question, const Wait& wait) override;
  std::optional<std::int64_t> answered_ns() const override;
  std::string source() const override;
  void begin_attempt(int trial, int attempt) override;
  bool wants_next(bool may_go) override;
  void refuse_answers() override;
  bool wears_mask() const override { return true; }
  bool leaves_prompts_to_experimenter() const override { return true; }
  void put_mask(bool on, const Wait& wait) override;
  void button_changed(const ButtonChange& change) override;
  std::vector<EventRow> take_events() override;

 private:
  struct Desk;
  std::unique_ptr<Desk> desk_;
};

}  // namespace asperity
