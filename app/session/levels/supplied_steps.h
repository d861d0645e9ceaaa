// The steps of tracks as a program stated them, and as they are stored with a session.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "protocols/plan/course.h"
#include "results_schema/rows.h"

namespace asperity {

/// A step that a program has stated.
struct SuppliedStep {
  int block_ordinal = 0;
  TrackStep of{};
  NextStep step{};
  double stated = 0.0;  ///< as the program stated it; the level of `step` is the nearest one
};

/// The data of `kExternalLevel`.
std::string json_of(const SuppliedStep& step);

/// The stored steps of a session, in the order in which they were stated.
class SuppliedSteps final {
 public:
  SuppliedSteps() = default;
  /// From the events of a session. Errors: std::runtime_error for data that are not those of a step.
  explicit SuppliedSteps(const std::vector<EventRow>& events);

  /// Supplies the requested step from the next stored one. False where no stored step is left.
  ///
  /// Errors: std::runtime_error where the stored step belongs to another track, or its level is not one of the block.
  bool supply(Course& course);
  /// Steps that have not been supplied.
  std::size_t left() const noexcept { return steps_.size() - next_; }

 private:
  std::vector<SuppliedStep> steps_{};
  std::size_t next_ = 0;
};

}  // namespace asperity
