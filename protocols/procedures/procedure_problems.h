// Problems of the settings of a procedure.

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/words/phrase.h"

namespace asperity {

/// One problem: the setting ("stop.trials"), and a sentence with the remedy. Not tied to a file: the reader of a
/// protocol knows the place of a setting in its file.
struct ProcedureProblem {
  std::string setting{};
  Phrase message{};

  bool operator==(const ProcedureProblem&) const = default;
};

/// Collects problems in the order in which checks report them.
class ProcedureProblems final {
 public:
  void report(std::string setting, Phrase message) {
    all_.push_back({.setting = std::move(setting), .message = std::move(message)});
  }
  /// Windows could not translate it.
  void report(std::string setting, const std::string& message) = delete;
  const std::vector<ProcedureProblem>& all() const noexcept { return all_; }
  bool empty() const noexcept { return all_.empty(); }

 private:
  std::vector<ProcedureProblem> all_{};
};

}  // namespace asperity
