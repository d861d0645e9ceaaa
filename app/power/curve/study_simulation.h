// Simulates studies on several threads, and passes them on in their order.

#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "app/power/curve/power_order.h"
#include "app/power/simulated_run.h"
#include "app/shards/shard.h"

namespace asperity {

/// One study of an effect (its place in PowerOrder::effects): a function of its arguments, called from several threads. It returns at
/// least one outcome, or none where it was not completed because of the stop request.
using SimulateStudy = std::function<std::vector<SimulatedOutcome>(
    std::size_t effect, int participants, std::uint64_t seed, std::int64_t run)>;

/// Consecutive studies of the runs of a shard: run n of shard k of N, from 0, is run n·N + k − 1 of the order. By default all runs.
struct StudyRange {
  std::int64_t first = 0;
  std::int64_t last = 0;  ///< after the last one
  Shard shard{};
};

/// Takes the simulated studies, one call at a time, from any thread.
struct StudyReceiver {
  std::function<void(const StudyPlace& place, std::span<const SimulatedOutcome> outcomes)>
      add{};                      ///< by ascending place, without a gap
  std::function<void()> write{};  ///< about once a second, and at the end; may be empty
};

/// Returns where the studies that were passed on end: range.last, or less after a stop request, when the studies that are being simulated
/// are completed. `progress` receives fractions, from any thread, and may be empty.
///
/// Memory does not depend on the number of studies: a thread waits where its study is far ahead of the last one that was passed on.
///
/// Errors: those of the receiver; std::runtime_error for a study without outcomes, and for the error of a study, naming the study. Those
/// that were passed on before are written.
std::int64_t simulate_studies(const PowerOrder& order, const SimulateStudy& simulate,
                              const StudyRange& range, int jobs, const StudyReceiver& receiver,
                              const std::stop_token& stop,
                              const std::function<void(double)>& progress);

}  // namespace asperity
