// The detectors of perceived instability for an attempt, computed while the questions are answered.

#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/session/stimulus_builder.h"
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

/// Judges the surfaces of an attempt (perceived_instability.h). Two bodies cost 45 µs for each tick and replay, 0.1 s for
/// each second of contact, so that the work begins on another thread at the first question, when no surface is rendered.
/// The values depend only on the records of the whole attempt, not on when they are computed.
///
/// A model can fail to return from a tick of a replay as it can from one of the servo loop. The replays therefore have a
/// thread of their own, which is left to itself when no tick has returned for the patience: the attempt is stored without
/// these values.
class AttemptInstability final {
 public:
  /// Which values are computed: the detectors replay twice more.
  enum class Values { all, texture_force_only };

  explicit AttemptInstability(std::chrono::milliseconds patience = std::chrono::seconds(10));
  ~AttemptInstability();
  AttemptInstability(const AttemptInstability&) = delete;
  AttemptInstability& operator=(const AttemptInstability&) = delete;

  /// Begins with the records up to now. Without a thread, `take` returns no values.
  void begin(std::vector<JudgedSurface> surfaces, std::span<const TickRecord> records,
             double rate_Hz, Values wanted = Values::all);
  /// The values of a surface from all records of the attempt; waits for them, or computes them where records of the
  /// surface were added after `begin`. Without values where that failed, for example for lack of memory: responses are
  /// stored without them.
  ReplayedMeasures take(const JudgedSurface& surface, std::span<const TickRecord> records,
                        double rate_Hz, Values wanted = Values::all);
  /// The model whose replay did not return, if one did not. Afterwards nothing is computed.
  const std::optional<std::string>& hanging_model() const noexcept { return hanging_model_; }

 private:
  struct Judged {
    std::ptrdiff_t records = 0;  ///< of the surface, from which it was judged
    ReplayedMeasures values{};
  };
  struct Work;
  /// Waits for the thread while its ticks return, and takes over what it found.
  void finish();

  std::chrono::milliseconds patience_;
  std::shared_ptr<Work> work_{};  ///< while it is under way; the thread has its part in it
  std::map<int, Judged> judged_{};
  std::optional<std::string> hanging_model_{};
};

/// The surfaces whose vibration exceeds the limit of the protocol, in words; empty without a limit and without such a surface.
Phrase excessive_buzz(const Protocol& protocol, std::span<const PresentationRow> surfaces);

}  // namespace asperity
