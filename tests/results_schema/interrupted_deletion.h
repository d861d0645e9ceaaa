// A deletion that is interrupted at one place after another, and then repeated.

#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include "tests/results_schema/failing_vfs.h"
#include "tests/results_schema/removal_fault.h"
#include "tests/results_schema/study_of_two.h"

namespace asperity {

/// Whatever interrupts the deletion, and wherever: the command repeated leads to the same end.
class InterruptedDeletion : public StudyOfTwo {
 protected:
  /// Interrupts the `first`-th write, sync or truncation of the database, and every `step`-th after it. Returns how many
  /// deletions were interrupted.
  int interrupt_database(FailingVfs::Fault fault, int first, int step) {
    int interrupted = 0;
    for (int n = first;; n += step) {
      const TemporaryFolder place;
      begin_again(place);
      bool is_interrupted = false;
      if (fault == FailingVfs::Fault::killed) {
        is_interrupted = is_killed([this, n] {
          FailingVfs disk;
          disk.fail_from(n, FailingVfs::Fault::killed);
          delete_unless_refused();
        });
      } else {
        FailingVfs disk;
        disk.fail_from(n, fault);
        delete_unless_refused();
        is_interrupted = disk.has_failed();
        disk.heal();
      }
      expect_the_end_when_repeated();
      if (HasFailure()) {
        ADD_FAILURE() << "interrupted at operation " << n;
        return interrupted;
      }
      if (!is_interrupted) return interrupted;
      ++interrupted;
    }
  }

  /// The same of the removal of each file.
  int interrupt_removal(RemovalFault::Kind kind) {
    for (int n = 1;; ++n) {
      const TemporaryFolder place;
      begin_again(place);
      const auto delete_with_fault = [this, n, kind] {
        const RemovalFault fault("Wanda7", n, kind);
        return delete_unless_refused();
      };
      const bool is_interrupted =
          kind == RemovalFault::Kind::killed ? is_killed(delete_with_fault) : !delete_with_fault();
      expect_the_end_when_repeated();
      if (HasFailure()) {
        ADD_FAILURE() << "interrupted at removal " << n;
        return n - 1;
      }
      if (!is_interrupted) return n - 1;
    }
  }

 private:
  void begin_again(const TemporaryFolder& place) {
    path_ = place / "study";
    std::filesystem::copy(folder_ / "study", path_, std::filesystem::copy_options::recursive);
  }

  /// False: it was refused.
  bool delete_unless_refused() const {
    try {
      open().withdraw("Wanda7", kDeletion);
    } catch (const ResultsError&) {
      return false;
    }
    return true;
  }

  /// Whether a child is killed while it runs `deletion`.
  template <typename Deletion>
  static bool is_killed(const Deletion& deletion) {
    const pid_t child = ::fork();
    if (child == 0) {
      deletion();
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status);
  }
};

}  // namespace asperity
