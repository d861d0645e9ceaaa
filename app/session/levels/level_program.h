// The running program that states the levels of one run of a block.

#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "analysis/words/phrase.h"
#include "app/processes/child_process.h"
#include "app/session/levels/external_program.h"
#include "app/session/levels/supplied_steps.h"
#include "app/words/phrase_of_error.h"
#include "protocols/plan/level_tracks.h"

namespace asperity {

/// Speaks the line protocol of docs/formats/external.md with a program: one process for one run of a block.
///
/// Whatever the program does, calls return within the time asked for, and a failure is an exception with a sentence for
/// the experimenter; the object is then to be destroyed, and a new one receives the answers so far as a replayed history.
class LevelProgram final {
 public:
  /// Starts the program. `begin` is the first line that it receives. Errors: PhrasedError.
  LevelProgram(const ExternalProgram& program, const std::string& begin,
               std::filesystem::path log_of_errors);

  /// Asks for a step. Sends the answers that the program has not received yet first. Errors: as `step`.
  void ask(const LevelRequest& request);
  /// Tells an answer before the next request, so that the program has the time between trials.
  void tell(const TrackAnswer& answer);
  /// The step, once the program has stated it; waits at most this long for it.
  ///
  /// Errors: PhrasedError where the program has ended, has not answered in time, or has answered something else.
  std::optional<SuppliedStep> step(double longest_wait_s);
  /// Closes the input of the program, which then has nothing left to do.
  void close() { process_->close_input(); }
  /// Passes bytes while nothing is requested: a program whose standard error is not read is blocked. Nothing that the
  /// program does is an error here.
  void attend(double longest_wait_s);
  /// Errors: PhrasedError where what it wrote to its standard error could not be kept.
  void require_kept_errors() const;
  bool has_ended() const noexcept { return process_->has_ended(); }

 private:
  using Clock = std::chrono::steady_clock;

  SuppliedStep stated(const std::string& line) const;
  void keep_errors();

  std::string name_{};
  std::filesystem::path log_{};
  std::unique_ptr<ChildProcess> process_;
  std::size_t told_ = 0;  ///< answers
  bool has_been_asked_ = false;
  LevelRequest request_{};
  Clock::time_point deadline_{};
  std::size_t logged_ = 0;          ///< bytes
  std::string last_error_line_{};   ///< of its standard error
  std::optional<Phrase> unkept_{};  ///< why its standard error could not be kept
};

}  // namespace asperity
