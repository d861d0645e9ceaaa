// Handles the inputs of a participant at the participant's window.

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/respondents/participant_input.h"
#include "app/session/respondents/respondent.h"
#include "app/session/session_monitor.h"
#include "app/session/sound/sound.h"

namespace asperity {

/// Takes the participant's inputs from any window or device. The conductor shows each scene in the
/// monitor; this class keeps its marks: what is chosen, assigned, refused.
///
/// The rules of answering are implemented here, without any window: digits and letters choose,
/// `next` switches surfaces where that is allowed, `confirm` answers when the answer is complete;
/// an answer before the question is asked (while a surface is felt, while the hand lifts) is
/// refused with a cue; each picture is assigned once, and an assignment may be changed until it is
/// confirmed (AnswerSheet).
///
/// No response is accepted to what cannot have been perceived. An input from before a scene was
/// shown, or less than `kTooSoon_s` after, is stored and has no other effect: a key pressed twice
/// and a button that bounces never answer the scene that the first press brought. Even a response
/// to an expected light with a single key takes 0.21 s on average [Woods 2015]; reading or choosing
/// takes longer. The same applies after a confirmation by device button that changed what the next
/// one would mean. A button that is down again within `kBounce_s` has not been released. An input
/// after the deadline has no effect either, however soon it is read; an input before the deadline
/// counts when it is read up to 0.05 s after it, which allows for a busy window.
///
/// With device buttons alone: button 1 steps through the options, with a tone for each; button 2,
/// or button 1 held for 0.8 s, confirms. In an assignment a confirmation gives the option to the
/// current surface, with the next surface's tone, and a further confirmation confirms the whole
/// assignment; of a multiple choice it chooses the selected option, and a further one confirms the answer. Numbers and texts
/// are not confirmed by button. Where surfaces may be felt again, the step after the last option is that wish: the
/// tone of the surface that would be felt sounds, nothing is chosen, and a confirmation requests
/// it. The effect of every confirmation is thus heard before it, and one button is sufficient.
/// While a surface is felt, button 1 continues to the next; while a text is read, any button turns
/// the page, and continues after the last page.
///
/// Tones that respond to the participant's inputs (option, refused, mask) come from here; those of
/// the trial (surface, question, accepted, …) from the conductor.
///
/// Events: "input" (what, its source, whether it came too late or early to count),
/// "input_released", "refused" (the text of the cue). Inputs of a form are private: they are stored as "answer".
///
/// Threads: `post` and `set_more_to_read` from any thread; everything else from the conductor's.
///
/// [Woods 2015] Woods et al.: Factors influencing the latency of simple reaction time.
class PersonAtWindow final : public Respondent {
 public:
  /// Measured from the time at which the scene was shown to the time stamp of the input.
  static constexpr double kTooSoon_s = 0.2;
  /// The same for a request to feel again on the screen that follows a surface which was removed without a request:
  /// until then its key and its place meant to finish. The screen comes unexpectedly and has to be read, while a finger may be
  /// on its way: a click arrived 0.33 s after such a screen.
  static constexpr double kUnexpected_s = 1.0;
  /// Contacts of a switch bounce for a few milliseconds; a finger cannot press again this soon.
  static constexpr double kBounce_s = 0.02;

  /// `monitor` and `sound` (may be null) must outlive this.
  PersonAtWindow(SessionMonitor& monitor, Sound* sound);
  ~PersonAtWindow() override;

  /// Replaces the sound; it must outlive this object.
  void set_sound(Sound* sound);

  /// From any thread. Inputs are processed in the order of posting; inputs without meaning in the
  /// current scene have no effect.
  void post(ParticipantInput input);
  /// Whether the text has pages after the one that the window shows: a button of the device turns
  /// to the next (ParticipantScene::pages_turned). Keys and mouse turn it in the window.
  void set_more_to_read(bool more);

  void read(const std::string& text, double minimum_s, const Wait& wait) override;
  void announce(const Trial& trial, const PlannedPresentation& surface) override;
  Reply ask(const Trial& trial, std::span<const Question> page, std::span<const ForceFeatures> felt,
            std::optional<double> deadline_s, const Wait& wait) override;
  void tell(const std::string& text, const Wait& wait) override;
  std::optional<Answer> answer(const Question& question, const Wait& wait) override;
  std::optional<std::int64_t> answered_ns() const override;
  std::string source() const override;
  void begin_attempt(int trial, int attempt) override;
  bool wants_next(bool may_go) override;
  void visit_was_without_contact(int position) override;
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
