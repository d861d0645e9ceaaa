// Checks the free space on the disk of a study.

#pragma once

#include "app/tasks/checks/session_check.h"
#include "protocols/design/protocol.h"

namespace asperity {

SessionCheck disk_check(const CheckInputs& inputs, const Protocol& protocol);

/// An upper limit for the recordings of one session, before compression:
///
///   bytes = T·f·(size of a time stamp + columns·size of a float)
///
/// with the duration T of the session and the rate f of the servo loop.
double recording_bytes(const Protocol& protocol);

struct DiskSpace {
  double wanted_bytes = 0.0;  ///< for one session
  double free_bytes = 0.0;
};
/// The result without id and title.
SessionCheck disk_check(const DiskSpace& space);

}  // namespace asperity
