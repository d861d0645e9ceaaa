// What a participant is shown, as a value: the same for the window, its mirror and a terminal.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/words/phrase.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// A sentence of the program's own (not the protocol's), by what it means: tones and windows distinguish
/// them.
struct Saying {
  enum class What {
    nothing,
    feel_surface,      ///< surface `code` can be felt now
    lift,              ///< surface `code` was felt long enough
    put_mask_on,       ///< and confirm
    take_mask_off,     ///< and confirm
    cannot_tell,       ///< as an option
    feel_first,        ///< refused: surface `code` has to be felt before the answer
    feel_longer,       ///< refused: surface `code` is to be felt a little longer
    not_asked_yet,     ///< refused: all was felt, and the question is about to be put
    wait,              ///< refused: not before `number` seconds have gone by
    choose_first,      ///< refused: nothing is chosen yet
    assign_first,      ///< refused: surface `code` has no picture yet
    feel_again,        ///< a confirmation now asks for surface `code` again
    no_going_back,     ///< refused: surfaces cannot be felt again in this trial
    was_right,         ///< feedback
    was_wrong,         ///< feedback; the right answer was `code`, where it is shown
    answer_needed,     ///< refused: this question cannot be left out
    number_needed,     ///< refused: a number, not below `minimum`, not above `maximum`
    option_needed,     ///< refused: one of the options
    estimate_needed,   ///< refused: a number above 0
    estimate_unclear,  ///< refused: `code` can be read with thousands or with decimals
    session_resumes,   ///< it goes on where it was interrupted, once that is confirmed
    check_estimate,    ///< the number `code` is far from an earlier one
  };
  What what = What::nothing;
  std::string code{};
  int number = 0;
  std::optional<double> minimum{};
  std::optional<double> maximum{};
};
/// Empty for nothing.
Phrase phrase_of(const Saying& saying);
/// In English.
std::string text_of(const Saying& saying);

/// The values at the right ends of the bars that show a hand its bands. One scale for all explorations
/// of a protocol: a band that asks for more stands further to the right, and is as wide as it allows.
struct GuideScale {
  double force_N = 0.0;
  double speed_m_per_s = 0.0;
};
/// Of the explorations that participants see guided; a quantity without a band is 0.
GuideScale guide_scale_of(const Protocol& protocol);
/// The same of one band: a quarter more than its maximum, or else 2.5 times its minimum.
double end_of_bar(const Band& band);
/// A participant sees how they meet its bands.
bool is_guided_by_sight(const Exploration& exploration) noexcept;

/// One thing at a time. Nothing in it names a stimulus, a texture or a model.
struct ParticipantScene {
  enum class Kind {
    blank,     ///< a calm ground; with `surfaces` between two of them, where answers are refused
    text,      ///< something to be read; goes on with a confirmation
    feel,      ///< surface `surface` of `surfaces` can be felt now
    question,  ///< the answer to the trial
    feedback,  ///< after an answer; goes by itself
    rest,      ///< a break; goes on with a confirmation, not before `rest_until_ns`
    form,      ///< a question about the person or the session (`question`)
    mask_on,   ///< the eye mask is to be put on and that confirmed
    mask_off,
    paused,  ///< the experimenter made a pause, or something is being seen to
    ended,   ///< thanks
  };
  /// A surface of the trial, by its code "A", "B", …
  struct Surface {
    std::string code{};
    bool felt = false;
    bool now = false;     ///< under the hand
    bool can_go = false;  ///< may be chosen to be felt (again) now
  };
  /// An option of the question.
  struct Choice {
    /// What is pressed for it and stands on it: "1" … for pictures, "A" … for surfaces, "0" for "I
    /// cannot tell".
    std::string key{};
    std::optional<std::string> picture{};  ///< study-relative; a surface or "cannot tell" has none
    std::string text{};         ///< for what is neither picture nor surface ("I cannot tell")
    Saying saying{};            ///< the same, where it is the program's own
    bool chosen = false;        ///< of a choice
    std::string assigned_to{};  ///< of an assignment: the code of the surface that has it; or empty
  };

  Kind kind = Kind::blank;
  /// Of the program's own sentences in it, as `Protocol::language`; the protocol's are as they are.
  std::string language = "en";
  /// When it was shown, on the session's clock: what was pressed before does not answer it. 0 where
  /// this is not known.
  std::int64_t shown_ns = 0;
  std::string text{};  ///< the instruction, prompt or feedback
  std::string
      cue{};  ///< a short refusal or reminder ("Please feel surface C first."); usually empty
  Saying text_saying{};          ///< the meaning of `text`, where it is not the protocol's
  Saying cue_saying{};           ///< the meaning of `cue`
  std::uint64_t cue_number = 0;  ///< counts the cues, so that the same one can be shown again
  int block = 0;                 ///< "block 3 of 6"; 0: no progress is shown
  int blocks = 0;

  std::vector<Surface> surfaces{};
  std::vector<Choice> choices{};
  AnswerForm form{};  ///< of the question: how it is answered
  /// Of an assignment: the surface (index in `surfaces`) that the next picture is given to.
  std::optional<std::size_t> assigning{};
  bool can_confirm = false;                       ///< the answer is complete
  bool can_switch = false;                        ///< surfaces may be felt again before the answer
  std::optional<std::string> standard_picture{};  ///< what realism is measured against

  std::optional<Question> question{};           ///< of a form
  std::optional<std::int64_t> rest_until_ns{};  ///< on the session's clock
  /// While a surface is felt: show the workspace (object, tool, probe) to who is allowed to see it.
  bool show_workspace = false;
  /// While a surface is felt: what is asked of the hand, as the session's layout has it, where the
  /// participant is to see how they meet it.
  std::optional<Exploration> guide{};
  GuideScale guide_scale{};  ///< of that
  /// Counts how often a button of the device asked for the next page of what is read.
  int pages_turned = 0;
  /// A response of the trial is open: keys of any window belong to it.
  bool response_open = false;

  /// A question of this form.
  template <class Form>
  bool is_answered_by() const noexcept {
    return std::holds_alternative<Form>(form);
  }
};

/// The scenes of a session; the conductor shows them to every kind of respondent.
ParticipantScene scene_to_read(const std::string& text);
/// Before the first trial after an interruption, to start from.
ParticipantScene scene_of_resuming();
/// `felt`: positions that were felt in this attempt; `now`: the position under the hand. Pictures
/// stand beside, unless they are to be seen only after feeling. `show_workspace` and `guide` are left
/// to the caller.
ParticipantScene scene_of_surface(const Trial& trial, const std::vector<int>& felt, int now);
/// The same when feeling is over, by the participant's wish or by itself: the hand is to lift.
ParticipantScene scene_of_lifting(const Trial& trial, const std::vector<int>& felt, int now);
/// Nothing is seen until the next surface comes; keys are known, to be refused.
ParticipantScene scene_between_surfaces(const Trial& trial, const std::vector<int>& felt);
ParticipantScene scene_of_question(const Trial& trial, const std::vector<int>& felt);
/// The same once more, of a number that is to be given again, or another one.
ParticipantScene scene_of_doubt(const Trial& trial, const std::vector<int>& felt, double estimate);
ParticipantScene scene_of_form(const Question& question);
ParticipantScene scene_of_mask(bool on);
/// `right_answer`: the labels of the right options where an incorrect response is followed by them; or empty.
ParticipantScene scene_of_feedback(bool was_right, const std::string& right_answer);

}  // namespace asperity
