// Runs the program as a child process with limits for lines, waits and its log of errors.

#include "app/session/levels/level_program.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <variant>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/overloaded.h"
#include "analysis/words/phrase.h"
#include "app/session/levels/level_messages.h"
#include "app/words/phrase_of_error.h"
#include "app/words/shown_text.h"
#include "results_schema/files/log_file.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

constexpr std::size_t kLongestLine = 64 * 1024;  // a level needs a few dozen bytes
constexpr std::size_t kLongestLog = 1024 * 1024;
constexpr std::size_t kLongestQuote = 80;

/// What the program wrote, short enough for a window and without control characters.
std::string quoted_output(std::string text) {
  const bool is_long = text.size() > kLongestQuote;
  if (is_long) text.resize(kLongestQuote);
  std::replace_if(
      text.begin(), text.end(),
      [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e;
      },
      '?');
  return is_long ? text + "…" : text;
}

[[noreturn]] void fail_with(const Phrase& what) { throw PhrasedError(what); }

Phrase text_of_end(const ChildProcess::Ending& ending) {
  switch (ending.how) {
    case ChildProcess::End::closed:
      break;
    case ChildProcess::End::exited:
      return phrase("ExternalProgram", "it ended with status %1")
          .with(std::to_string(ending.number));
    case ChildProcess::End::signalled:
      return phrase("ExternalProgram", "signal %1 ended it").with(std::to_string(ending.number));
  }
  return phrase("ExternalProgram", "it closed its standard output");
}

}  // namespace

LevelProgram::LevelProgram(const ExternalProgram& program, const std::string& begin,
                           std::filesystem::path log_of_errors)
    : name_(program.name()), log_(std::move(log_of_errors)) {
  try {
    process_ =
        std::make_unique<ChildProcess>(std::filesystem::absolute(program.file), program.arguments);
  } catch (const std::system_error& error) {
    fail_with(
        phrase("ExternalProgram",
               "the external program %1 cannot be started (%2); check that it is executable and, "
               "if it is a script, that its interpreter exists")
            .with(program.file.string(), error.code().message()));
  }
  process_->write(begin);
}

void LevelProgram::ask(const LevelRequest& request) {
  request_ = request;
  attend(0.0);
  require_kept_errors();
  if (!process_->output().empty()) {
    fail_with(
        phrase("ExternalProgram",
               "the external program %1 wrote \"%2\" without being asked; it must write one line "
               "for each \"ask\", and everything else to its standard error")
            .with(name_, quoted_output(process_->output())));
  }
  const TellKind kind = has_been_asked_ ? TellKind::now : TellKind::replayed;
  for (; told_ < request.answers.size(); ++told_) {
    process_->write(tell_line(request.answers[told_], request.settings, kind));
  }
  process_->write(ask_line(request));
  has_been_asked_ = true;
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(request.settings.answer_within_s));
}

void LevelProgram::tell(const TrackAnswer& answer) {
  process_->write(tell_line(answer, request_.settings, TellKind::now));
  ++told_;
  process_->pump(0.0);
}

void LevelProgram::attend(double longest_wait_s) {
  process_->pump(longest_wait_s);
  keep_errors();
}

void LevelProgram::require_kept_errors() const {
  if (unkept_) fail_with(*unkept_);
}

std::optional<SuppliedStep> LevelProgram::step(double longest_wait_s) {
  attend(longest_wait_s);
  require_kept_errors();
  std::string& output = process_->output();
  const std::size_t end = output.find('\n');
  if (end != std::string::npos && end + 1 == output.size()) {
    const std::string line = std::exchange(output, {});
    return stated(line.substr(0, end));
  }
  if (end != std::string::npos) {
    fail_with(
        phrase("ExternalProgram",
               "the external program %1 wrote more than the one line that was asked for: \"%2\"; "
               "it must write one line for each \"ask\", and everything else to its standard error")
            .with(name_, quoted_output(output)));
  }
  if (output.size() > kLongestLine) {
    fail_with(
        phrase("ExternalProgram",
               "the external program %1 wrote %2 bytes without the end of a line, beginning with "
               "\"%3\"; it must write one line for each \"ask\"")
            .with(name_, std::to_string(output.size()), quoted_output(output)));
  }
  if (process_->has_ended()) {
    const Phrase end_of_program = text_of_end(process_->ending());
    if (logged_ == 0) {
      fail_with(phrase("ExternalProgram",
                       "the external program %1 did not state the level: %2, and it wrote nothing "
                       "to its standard error; start it by hand to find the cause")
                    .with(name_, end_of_program));
    }
    const std::string errors =
        last_error_line_.empty() ? std::string() : ", \"" + quoted_output(last_error_line_) + '"';
    fail_with(phrase("ExternalProgram",
                     "the external program %1 did not state the level: %2%3; what it wrote to its "
                     "standard error is in %4")
                  .with(name_, end_of_program, errors, log_.string()));
  }
  if (Clock::now() >= deadline_) {
    fail_with(
        phrase("ExternalProgram",
               "the external program %1 did not answer within %2 s; check that it writes a line "
               "and flushes it after each \"ask\", or raise \"answer_within_s\" in the protocol")
            .with(name_, number_text(request_.settings.answer_within_s)));
  }
  return std::nullopt;
}

SuppliedStep LevelProgram::stated(const std::string& line) const {
  SuppliedStep step{.block_ordinal = request_.block_ordinal, .of = request_.of};
  const std::vector<double>& levels = request_.settings.levels;
  std::visit(
      Overloaded{
          [&](const StatedLevel& reply) {
            const auto level = presented_level(request_.settings, reply.level);
            if (!level) {
              fail_with(
                  phrase("ExternalProgram",
                         "the external program %1 stated the level %2, but the levels of the "
                         "block lie between %3 and %4; correct the program, or extend the levels "
                         "in the protocol")
                      .with(name_, number_text(reply.level), number_text(levels.front()),
                            number_text(levels.back())));
            }
            step.step = NextLevel{*level};
            step.stated = reply.level;
          },
          [&](const StatedEnd&) { step.step = TrackEnd::program; },
          [&](const StatedError& reply) {
            fail_with(phrase("ExternalProgram", "the external program %1 reports a problem: %2")
                          .with(name_, quoted_output(reply.text)));
          },
          [&](const NotUnderstood&) {
            fail_with(
                phrase("ExternalProgram",
                       "the external program %1 answered \"%2\", which is neither a level nor the "
                       "end of the track; it must write {\"level\": NUMBER} or {\"end\": true}")
                    .with(name_, quoted_output(line)));
          }},
      reply_in(line));
  return step;
}

/// The log holds at most 1 MiB of each run of the program.
void LevelProgram::keep_errors() {
  std::string text = process_->take_errors();
  if (text.empty()) return;
  const std::size_t end = text.find_last_not_of("\r\n");
  if (end != std::string::npos) {
    const std::size_t before = text.rfind('\n', end);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    last_error_line_ = text.substr(begin, end + 1 - begin);
  }
  if (logged_ >= kLongestLog) return;
  logged_ += text.size();
  if (logged_ >= kLongestLog) text += "\n(asperity: further output is not kept)\n";
  try {
    append_to_log(log_, shown_in_lines(text));
  } catch (const ResultsError& error) {
    unkept_ = phrase("ExternalProgram",
                     "what the external program %1 writes to its standard error cannot be kept: "
                     "%2; check the permissions and the free space of the study's folder")
                  .with(name_, std::string(error.what()));
  }
}

}  // namespace asperity
