// Does a study hold what it says?

#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderers/force/force_model.h"
#include "results_schema/study.h"

namespace asperity {

struct VerifyResult {
  std::vector<std::string> problems{};  ///< a sentence each; empty: everything holds
  std::vector<std::string> remarks{};   ///< what a person may want to know: leftovers of a crash
  int recordings_replayed = 0;
  std::vector<std::string> rules{};  ///< how replays were compared, one line per rule applied
};

/// Constraints and what else the schema refuses by, hashes, that every stored plan is the one its protocol,
/// seed and row give, and that surfaces, answers and the options beside them are those of the plan. With
/// `replay_too`, every recorded hand goes through its renderers again: bit for bit where the
/// session was run by this build on this kind of machine, within each model's declared tolerance
/// otherwise.
///
/// A study that is open for reading is looked at by as many threads as the machine has, eight at most;
/// with `replay_too` by the caller's alone. What is found, and in which order, depends on none of them.
/// `progress` is called by the caller's thread; what it throws ends the work and comes out of here.
VerifyResult verify_study(Study& study, const ModelRegistry& models, bool replay_too,
                          const std::stop_token& asked_to_stop,
                          const std::function<void(double)>& progress);

}  // namespace asperity
