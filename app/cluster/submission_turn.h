// The right to look at a submission and submit what is missing, which one process has at a time.

#pragma once

#include <chrono>

#include "app/cluster/submission.h"

namespace asperity {

/// Locks the file `lock` in the folder of the submission while it lives: of two processes the second one looks at the queue when
/// it contains what the first one submitted. A process that dies has no lock. On a file system without locks there is none, and two
/// processes at the same time can submit the same shards, which gives the same bytes twice.
///
/// Errors: std::runtime_error naming the file where it cannot be opened, and where another process has it for longer than `patience`.
class SubmissionTurn final {
 public:
  explicit SubmissionTurn(const Submission& submission,
                          std::chrono::milliseconds patience = std::chrono::minutes(1));
  SubmissionTurn(const SubmissionTurn&) = delete;
  SubmissionTurn& operator=(const SubmissionTurn&) = delete;
  ~SubmissionTurn();

 private:
  int descriptor_ = -1;
};

}  // namespace asperity
