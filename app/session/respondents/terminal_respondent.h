// Handles a participant at a terminal: numbered options, typed answers.

#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "app/session/respondents/dialogues/answer_dialogue.h"
#include "app/session/respondents/respondent.h"
#include "app/session/respondents/unechoed_input.h"
#include "app/session/respondents/visit_tally.h"

namespace asperity {

/// Asks on a terminal. While it waits for a line the session keeps ticking.
///
/// It shows prompts, codes and option numbers, never names of textures or models. Pictures, which a
/// terminal cannot show, are placed side by side in one file in the order of the options, written
/// anew for each question, which any viewer can show next to the terminal. They are in colour,
/// unless the protocol shows them in shades of grey.
///
/// From the announcement of a surface until the next question or text is shown, the terminal does
/// not echo typed text, and discards it.
///
/// Errors: RespondentGone when the input ends; errors of reading a picture or writing the sheet.
class TerminalRespondent final : public Respondent {
 public:
  /// `input` is a file descriptor that can be polled (standard input); `input` and `output` outlive
  /// the respondent. Pictures are read from `study` and written to `sheet`, a PNG.
  TerminalRespondent(int input, std::ostream& output, std::filesystem::path study,
                     std::filesystem::path sheet);

  /// Shows all later pictures in shades of grey.
  void show_in_grey() noexcept { in_grey_ = true; }

  void read(const std::string& text, double minimum_s, const Wait& wait) override;
  void announce(const Trial& trial, const PlannedPresentation& surface) override;
  Reply ask(const Trial& trial, std::span<const Question> page, std::span<const ForceFeatures> felt,
            std::optional<double> deadline_s, const Wait& wait) override;
  void tell(const std::string& text, const Wait& wait) override;
  std::optional<Answer> answer(const Question& question, const Wait& wait) override;
  std::string source() const override { return "keyboard"; }
  /// At a terminal there is no experimenter's window: Return states that the fault is corrected.
  void hear_of_fault(const std::string& what) override;
  AfterFault after_fault() override;
  void begin_attempt(int, int) override {
    visits_.clear();
    felt_side_by_side_ = false;
  }
  void visit_was_without_contact(int position) override {
    visits_.take_back(position);
    output_ << "The surface was not touched." << std::endl;
  }
  /// Surfaces side by side are finished as soon as possible: a terminal has no key for it while the hand moves.
  bool wants_next(bool may_go) override { return felt_side_by_side_ && may_go; }

 private:
  using Heard = std::variant<NoAnswer, FeelAgain, std::optional<Answer>>;
  /// Asks one question. `left_s` follows the time that passes in `timed`.
  Heard ask(const Trial& trial, const Question& question, const std::optional<double>& left_s,
            const Wait& timed);
  void put(const Question& question);
  /// Asks for lines until the dialogue is complete. `trial`: null for a question of the session.
  Heard hear(AnswerDialogue& dialogue, const Trial* trial, const std::optional<double>& left_s,
             const Wait& timed);
  /// The position of the surface that the line requests to feel again; nothing for other lines. `said` is true for
  /// every such request; an unknown surface is reported on the terminal.
  std::optional<int> wish_in(const std::string& typed, const Trial& trial, bool& said);

  /// The next line typed; nothing when no time is left. `wait` may count `left_s` down.
  std::optional<std::string> line(const Wait& wait, const std::optional<double>& left_s = {});

  /// A line that has already been typed.
  std::optional<std::string> typed_line();

  /// Writes the sheet with these pictures (paths in the study), from left to right.
  void show(const std::vector<std::string>& pictures);
  void forget_typed();

  int input_ = 0;
  std::ostream& output_;
  std::filesystem::path study_{};
  std::filesystem::path sheet_{};
  bool in_grey_ = false;
  std::string buffer_{};
  std::optional<UnechoedInput> unechoed_{};
  VisitTally visits_{};  ///< of the attempt
  bool felt_side_by_side_ = false;
};

}  // namespace asperity
