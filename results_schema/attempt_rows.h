// Attempts read with what was decided about them, without what hangs on them. Seen by this folder
// only.

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "results_schema/rows.h"
#include "results_schema/sqlite.h"

namespace asperity {

/// All that can be decided about an attempt.
inline constexpr std::array kVerdicts{Verdict::set_aside, Verdict::flag, Verdict::exclude,
                                      Verdict::include};

/// Attempts in the order of their ids, so that the rows that belong to them are assigned by bisection.
class Attempts {
 public:
  void add(AttemptRow row) { rows_.push_back(std::move(row)); }
  AttemptRow& of(std::int64_t id);
  const std::vector<AttemptRow>& rows() const noexcept { return rows_; }
  /// By trial, attempt.
  std::vector<AttemptRow> in_order() &&;

 private:
  std::vector<AttemptRow> rows_{};
};

/// `which` selects attempts by the one parameter `key`.
Attempts read_bare_attempts(Database& database, const std::string& which, std::int64_t key);

}  // namespace asperity
