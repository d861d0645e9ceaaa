// Writes one line per stored attempt, "done" if it counts and "stored" otherwise.

#include "app/cli/output/session_output.h"

#include <mutex>
#include <string>

#include "app/cli/output/terminal.h"

namespace asperity {

void say_done(const AttemptDone& done) {
  static std::once_flag is_explained{};
  std::call_once(is_explained, [] {
    say("asperity: each stored attempt is acknowledged by a line: done PARTICIPANT SESSION TRIAL "
        "ATTEMPT, or stored and the outcome if the attempt does not count");
  });
  say((done.counts ? "done " : "stored ") + done.participant + ' ' + std::to_string(done.session) +
      ' ' + std::to_string(done.trial) + ' ' + std::to_string(done.attempt) +
      (done.counts ? std::string() : std::string(" ") + text_of(done.outcome)));
}

}  // namespace asperity
