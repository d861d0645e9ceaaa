// The detectors of perceived instability for an attempt, computed while the question is answered.

#pragma once

#include <future>
#include <map>
#include <span>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "app/words/phrase.h"
#include "protocols/design/protocol.h"
#include "renderers/offline/perceived_instability.h"
#include "results_schema/rows.h"

namespace asperity {

/// The values as they are stored.
InstabilityRow instability_row(const PerceivedInstability& judged);

/// Judges the surfaces of an attempt (perceived_instability.h) on other threads, each from the time at which the hand has
/// lifted from it. Two bodies cost 45 µs for each tick and replay, 0.1 s for each second of contact: the participant
/// answers meanwhile. The values do not depend on when they are computed.
///
/// Errors: those of the force model, from `take`.
class AttemptInstability final {
 public:
  /// A surface was removed; `records`: all of the attempt up to now. Replaces the values of earlier visits to it.
  void begin(int position, const PreparedStimulus& stimulus, const RendererInputs& inputs,
             std::span<const TickRecord> records, double rate_Hz);
  /// Waits for the values of the surface; nullopt if it was not removed before the attempt was interrupted.
  std::optional<InstabilityRow> take(int position);

 private:
  std::map<int, std::vector<std::future<PerceivedInstability>>> judged_{};  ///< the last one counts
};

/// The surfaces whose vibration exceeds the limit of the protocol, in words; empty without a limit and without such a surface.
Phrase excessive_buzz(const Protocol& protocol, std::span<const PresentationRow> surfaces);

}  // namespace asperity
