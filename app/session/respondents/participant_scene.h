// Describes the content of a participant's screen as a value, the same for the window, its mirror
// and a terminal.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/words/phrase_of_error.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// A message of the program (not of the protocol), by its meaning: tones and windows distinguish
/// these.
struct ParticipantMessage {
  enum class What {
    nothing,
    feel_surface,  ///< surface `code` can be felt now
    /// The surfaces from `code` to `last_code`, `number` of them, can be felt now, side by side.
    feel_patches,
    lift,               ///< surface `code` was felt for long enough
    lift_from_patches,  ///< the surfaces were felt for long enough
    put_mask_on,        ///< and to confirm
    take_mask_off,      ///< and to confirm
    cannot_tell,        ///< as an option
    feel_first,         ///< refused: surface `code` has to be felt before the answer
    feel_longer,        ///< refused: surface `code` has to be felt a little longer
    feel_all_longer,  ///< refused: some of the surfaces side by side has to be felt again or longer
    finish_first,     ///< refused: the surfaces side by side are still felt
    feel_named,       ///< a confirmation now requests surface `code` for the first time
    not_asked_yet,    ///< refused: all surfaces were felt, and the question is about to be asked
    wait,             ///< refused: not before `number` seconds have passed
    choose_first,     ///< refused: no option is chosen yet
    mark_first,       ///< refused: a scale of the page has no mark yet; `number` scales in all
    assign_first,     ///< refused: surface `code` has no picture yet
    feel_again,       ///< a confirmation now requests surface `code` again
    no_going_back,    ///< refused: surfaces cannot be felt again in this trial
    not_touched,      ///< surface `code` could be felt again and was not touched
    felt_often_enough,  ///< refused: surface `code` cannot be felt again in this trial
    was_right,          ///< feedback
    was_wrong,          ///< feedback; the correct response was `code`, where it is shown
    answer_needed,      ///< refused: this question must be answered
    typed_needed,       ///< refused: what is typed is not confirmed by a button of the device
    number_needed,      ///< refused: a number, not below `minimum`, not above `maximum`
    option_needed,      ///< refused: one of the options
    options_needed,     ///< refused: one or more of the options
    estimate_needed,    ///< refused: a number above 0
    line_needed,        ///< refused: no line is drawn yet
    estimate_unclear,   ///< refused: `code` can be read with thousands or with decimals
    practice_resumes,   ///< practice trials are made again before the session resumes
    session_resumes,    ///< the session resumes where it was interrupted, after a confirmation
    check_estimate,     ///< the number `code` differs greatly from an earlier one
  };
  What what = What::nothing;
  std::string code{};
  std::string last_code{};
  int number = 0;
  std::optional<double> minimum{};
  std::optional<double> maximum{};
};
/// Empty for no message.
Phrase phrase_of(const ParticipantMessage& message);
/// In English.
std::string text_of(const ParticipantMessage& message);

/// The values at the right ends of the bars that show participants their bands. One scale applies
/// to all explorations of a protocol, so that bands can be compared: a higher band lies further to
/// the right, and a wider one is wider.
struct GuideScale {
  double force_N = 0.0;
  double speed_m_per_s = 0.0;
};
/// The scale of the explorations that are shown to participants; a quantity without a band is 0.
GuideScale guide_scale_of(const Protocol& protocol);
/// The scale of one band: a quarter more than its maximum, or 2.5 times its minimum where it has no
/// maximum.
double end_of_bar(const Band& band);
/// The participant sees how force and speed meet the bands.
bool is_guided_by_sight(const Exploration& exploration) noexcept;

/// The content of a participant's screen at one moment. It names no stimulus, texture or model.
struct ParticipantScene {
  enum class Kind {
    blank,     ///< a blank screen; with `surfaces` between two of them, where answers are refused
    text,      ///< a text to read; continues after a confirmation
    feel,      ///< surface `surface` of `surfaces` can be felt now
    question,  ///< the answer to the trial
    feedback,  ///< after an answer; ends by itself
    rest,      ///< a break; continues after a confirmation, not before `rest_until_ns`
    form,      ///< a question about the participant or the session
    mask_on,   ///< the eye mask is to be put on, and that confirmed
    mask_off,
    paused,  ///< the experimenter paused the session, or a problem is being corrected
    ended,   ///< thanks
  };
  /// A surface of the trial, by its code "A", "B", …
  struct Surface {
    std::string code{};
    bool felt = false;
    bool now = false;     ///< currently felt
    bool can_go = false;  ///< may be chosen to be felt (again) now
  };
  /// An option of the question.
  struct Choice {
    /// The key that chooses it, shown as its label: "1" … for pictures and words (of a form also letters), "A" … for
    /// surfaces, "0" for "I cannot tell".
    std::string key{};
    std::optional<std::string> picture{};  ///< study-relative; a surface or "cannot tell" has none
    /// For an option that is neither a picture nor a surface ("I cannot tell").
    std::string text{};
    ParticipantMessage message{};  ///< its meaning, where it is a text of the program
    bool chosen = false;           ///< of a choice
    /// Of several options: the device's button points at it, and its next confirmation chooses it.
    bool pointed_at = false;
    /// Of an assignment: the code of the surface that the option was given to; or empty.
    std::string assigned_to{};
  };

  /// A scale of the page.
  struct Scale {
    std::string prompt{};  ///< empty where it is the only one: the prompt is `text`
    ScaleForm form{};
    std::optional<int> step{};  ///< where its mark is, as ScalePoint::step; nothing: no mark yet
    /// The mark is an answer: it was put there, and is not only where a key began.
    bool counts = false;
    bool current = false;  ///< keys and buttons move its mark
    bool operator==(const Scale&) const = default;
  };

  Kind kind = Kind::blank;
  /// The language of the program's own texts, as `Protocol::language`; the texts of a protocol are
  /// shown unchanged.
  std::string language = "en";
  /// When it was shown, on the session's clock: an earlier input does not answer it. 0 where this
  /// is unknown.
  std::int64_t shown_ns = 0;
  std::string text{};  ///< the instruction, prompt or feedback
  std::string
      cue{};  ///< a short refusal or reminder ("Please feel surface C first."); usually empty
  ParticipantMessage text_message{};  ///< the meaning of `text`, where it is not the protocol's
  ParticipantMessage cue_message{};   ///< the meaning of `cue`
  std::uint64_t cue_number = 0;       ///< counts the cues, so that the same one can be shown again
  int block = 0;                      ///< "block 3 of 6"; 0: no progress is shown
  int blocks = 0;

  std::vector<Surface> surfaces{};
  std::vector<Choice> choices{};
  std::vector<Scale> scales{};
  std::string question{};          ///< the name of the first question of the page
  AnswerForm form{};               ///< of that question
  bool optional = false;           ///< the question may be left empty
  std::optional<int> line_step{};  ///< of a line: as DrawnLength::step; nothing: no line yet
  /// Of an assignment: the surface (index in `surfaces`) that receives the next picture.
  std::optional<std::size_t> assigning{};
  bool can_confirm = false;  ///< the answer is complete
  bool can_switch = false;   ///< surfaces may be felt again before the answer
  /// Where surfaces are felt on request: the position of the one that the request to feel means.
  std::optional<int> wished_surface{};
  /// The picture of the standard, for judgements of realism.
  std::optional<std::string> standard_picture{};

  std::optional<std::int64_t> rest_until_ns{};  ///< on the session's clock
  /// While a surface is felt: the participant ends it; otherwise a number of strokes or a contact time does.
  bool can_finish = true;
  /// While a surface is felt: show the workspace (object, tool, probe) to users who are allowed to
  /// see it.
  bool show_workspace = false;
  /// While a surface is felt: the instructed exploration, in the session's layout, where the
  /// participant is shown how force and speed meet it.
  std::optional<Exploration> guide{};
  GuideScale guide_scale{};  ///< of that
  /// Counts the device-button presses that requested the next page of a text.
  int pages_turned = 0;
  /// A response of the trial is open: keys pressed in any window count for it.
  bool response_open = false;

  /// A question of this form.
  template <class Form>
  bool is_answered_by() const noexcept {
    return std::holds_alternative<Form>(form);
  }
};

/// The key that chooses an option in words, by its place in the list from 1: "1" … "9", then "A" ….
std::string key_of_option(int number);

/// The scenes of a session; the conductor shows them to every kind of respondent.
ParticipantScene scene_to_read(const std::string& text);
/// Shown before practice trials that are made again after an interruption.
ParticipantScene scene_of_refresher();
/// Shown before the first trial after an interruption.
ParticipantScene scene_of_resuming();
/// `felt`: positions that were felt in this attempt; `now`: the position of the current surface.
/// Pictures are shown next to it, unless the protocol shows them only after feeling. The caller
/// sets `show_workspace` and `guide`.
ParticipantScene scene_of_surface(const Trial& trial, const std::vector<int>& felt, int now);
/// Adds how force and speed meet the bands of the exploration, where participants are shown it.
void add_guide(ParticipantScene& scene, const Exploration& exploration, const Protocol& protocol);
/// All surfaces of the trial can be felt, side by side.
ParticipantScene scene_of_patches(const Trial& trial);
/// The same when feeling has ended, at the participant's request or after the specified time: the
/// hand is to lift.
ParticipantScene scene_of_lifting(const Trial& trial, const std::vector<int>& felt, int now);
ParticipantScene scene_of_lifting_from_patches(const Trial& trial);
/// Shows nothing until the next surface is presented; keys are accepted only to be refused.
ParticipantScene scene_between_surfaces(const Trial& trial, const std::vector<int>& felt);
/// `page`: one of pages_of(trial).
ParticipantScene scene_of_question(const Trial& trial, std::span<const Question> page,
                                   const std::vector<int>& felt);
/// The question again, for a number that is to be confirmed or replaced.
ParticipantScene scene_of_doubt(const Trial& trial, std::span<const Question> page,
                                const std::vector<int>& felt, double estimate);
ParticipantScene scene_of_form(const Question& question);
ParticipantScene scene_of_mask(bool on);
/// `right_answer`: the labels of the correct options where the protocol shows them after an
/// incorrect response; or empty.
ParticipantScene scene_of_feedback(bool was_right, const std::string& right_answer);

}  // namespace asperity
