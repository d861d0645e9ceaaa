// The detectors of perceived instability for an attempt, computed while the questions are answered.

#pragma once

#include <cstddef>
#include <future>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "app/words/phrase.h"
#include "protocols/design/protocol.h"
#include "renderers/offline/perceived_instability.h"
#include "results_schema/rows.h"

namespace asperity {

/// The values as they are stored; nullopt where one of them is not finite: the computation failed, for example because the
/// model failed on the path without its vibration.
std::optional<InstabilityRow> instability_row(const PerceivedInstability& judged);

/// A surface of an attempt, as it was rendered.
struct JudgedSurface {
  int position = 0;
  ForceModel model{};
  RendererInputs inputs{};
  TextureForceBand band{};  ///< of the texture force that is stored
};

/// The values of a surface that need replays of its records.
struct ReplayedMeasures {
  std::optional<double>
      texture_force_N{};  ///< recorded_texture_force_rms_N in the band of the surface, if it is finite
  std::optional<InstabilityRow> instability{};
};

/// The texture force alone; nullopt as well where it is not finite. Errors: those of recorded_texture.
std::optional<double> texture_force_N(const JudgedSurface& surface,
                                      std::span<const TickRecord> records, double rate_Hz);

/// Judges the surfaces of an attempt (perceived_instability.h). Two bodies cost 45 µs for each tick and replay, 0.1 s for
/// each second of contact, so that the work begins on another thread at the first question, when no surface is rendered.
/// The values depend only on the records of the whole attempt, not on when they are computed.
class AttemptInstability final {
 public:
  /// Begins with the records up to now. Without a thread everything is computed by `take`.
  void begin(std::vector<JudgedSurface> surfaces, std::span<const TickRecord> records,
             double rate_Hz);
  /// The values of a surface from all records of the attempt; waits for them, or computes them where records of the
  /// surface were added after `begin`. Without values where that failed, for example for lack of memory: responses are
  /// stored without them.
  ReplayedMeasures take(const JudgedSurface& surface, std::span<const TickRecord> records,
                        double rate_Hz);

 private:
  struct Judged {
    std::ptrdiff_t records = 0;  ///< of the surface, from which it was judged
    ReplayedMeasures values{};
  };
  std::future<std::map<int, Judged>> begun_{};
  std::map<int, Judged> judged_{};
};

/// The surfaces whose vibration exceeds the limit of the protocol, in words; empty without a limit and without such a surface.
Phrase excessive_buzz(const Protocol& protocol, std::span<const PresentationRow> surfaces);

}  // namespace asperity
