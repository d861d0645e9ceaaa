// Checks whether the contents of a study are intact and consistent.

#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/plugins/plugin_builds.h"
#include "results_schema/study.h"

namespace asperity {

struct VerifyResult {
  std::vector<std::string> problems{};  ///< a sentence each; empty: no problems
  std::size_t plugin_problems = 0;      ///< of the problems: plug-ins that are missing or differ
  std::vector<std::string> remarks{};   ///< information for the user, such as leftovers of a crash
  int recordings_replayed = 0;
  int attempts_without_recording = 0;  ///< as those of most simulated participants
  std::vector<std::string> rules{};    ///< what was compared with what, one line per rule applied
};

/// Checks the constraints and other rules of the schema, hashes, that every stored plan is the one
/// that its protocol, seed, row and group give, and that surfaces, answers and the options stored with
/// them agree with the plan. With `replay_too`, the forces of every recorded hand are rendered
/// again: bit for bit equal where the session was run by this build on this kind of machine, within
/// each model's declared tolerance otherwise. The stored detectors of perceived instability and numbers of gaps in
/// contact are compared with those of the recording.
///
/// A build of a plug-in with which attempts were rendered and that is not among `builds` is one problem for all of its attempts,
/// which are not replayed. Plans with it are checked nevertheless, from the declaration that the session stored.
///
/// The threads read the study at different moments. Where problems are found and a participant withdrew meanwhile, whose rows
/// or files may have been read by one of them only, everything is checked again.
///
/// A study that is open for reading is checked by as many threads as the machine has, eight at
/// most; with `replay_too` only by the caller's. The results and their order do not depend on the
/// number of threads. `progress` is called by the caller's thread; an exception from it ends the
/// work and is passed on to the caller.
VerifyResult verify_study(Study& study, const ModelBuilds& builds, bool replay_too,
                          const std::stop_token& asked_to_stop,
                          const std::function<void(double)>& progress);

}  // namespace asperity
