// A person at a terminal: numbered options, typed answers.

#pragma once

#include <ostream>
#include <string>

#include "app/conductor/respondent.h"

namespace asperity {

/// Asks on a terminal. While it waits for a line the session goes on ticking.
///
/// What it shows are prompts, codes and option numbers, never names of textures or models.
///
/// Errors: RespondentGone when the input ends.
class TerminalRespondent final : public Respondent {
 public:
  /// `input` is a file descriptor that can be polled (standard input); both outlive the respondent.
  TerminalRespondent(int input, std::ostream& output);

  void read(const std::string& text, double minimum_s, const Wait& wait) override;
  void announce(const Trial& trial, const PlannedPresentation& surface) override;
  Reply ask(const Trial& trial, std::span<const ForceFeatures> felt,
            std::optional<double> deadline_s, const Wait& wait) override;
  void tell(const std::string& text, const Wait& wait) override;
  std::string answer(const Question& question, const Wait& wait) override;
  std::string source() const override { return "keyboard"; }
  void begin_attempt(int, int) override {}

 private:
  /// The next line typed; nothing when no time is left. `wait` may count `left_s` down.
  std::optional<std::string> line(const Wait& wait, const std::optional<double>& left_s = {});

  int input_ = 0;
  std::ostream& output_;
  std::string buffer_{};
};

/// Why an answer to a question is not acceptable; nothing when it is. `answer` may be the number of
/// an option; it is then replaced by the option.
std::optional<std::string> complaint_about_answer(const Question& question, std::string& answer);

}  // namespace asperity
