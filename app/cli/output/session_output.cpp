#include "app/cli/output/session_output.h"

#include <string>

#include "app/cli/output/terminal.h"

namespace asperity {

void say_done(const AttemptDone& done) {
  say((done.counts ? "done " : "stored ") + done.participant + ' ' + std::to_string(done.session) +
      ' ' + std::to_string(done.trial) + ' ' + std::to_string(done.attempt) +
      (done.counts ? std::string() : std::string(" ") + text_of(done.outcome)));
}

}  // namespace asperity
