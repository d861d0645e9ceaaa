// Checks whether the contents of a study are intact and consistent.

#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderers/force/force_model.h"
#include "results_schema/study.h"

namespace asperity {

struct VerifyResult {
  std::vector<std::string> problems{};  ///< a sentence each; empty: no problems
  std::vector<std::string> remarks{};   ///< information for the user: leftovers of a crash
  int recordings_replayed = 0;
  std::vector<std::string> rules{};  ///< what was compared with what, one line per rule applied
};

/// Checks the constraints and other rules of the schema, hashes, that every stored plan is the one
/// that its protocol, seed, row and group give, and that surfaces, answers and the options stored with
/// them agree with the plan. With `replay_too`, the forces of every recorded hand are rendered
/// again: bit for bit equal where the session was run by this build on this kind of machine, within
/// each model's declared tolerance otherwise.
///
/// A plug-in with which attempts were rendered and that is not among `models`, or there with another content, is a problem. Plans
/// with it are checked nevertheless, from the declaration that the session stored.
///
/// A study that is open for reading is checked by as many threads as the machine has, eight at
/// most; with `replay_too` only by the caller's. The results and their order do not depend on the
/// number of threads. `progress` is called by the caller's thread; an exception from it ends the
/// work and is passed on to the caller.
VerifyResult verify_study(Study& study, const ModelRegistry& models, bool replay_too,
                          const std::stop_token& asked_to_stop,
                          const std::function<void(double)>& progress);

}  // namespace asperity
