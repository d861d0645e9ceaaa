// Counts the strokes of a visit while it lasts.

#pragma once

#include <cstddef>
#include <span>

#include "analysis/signals/compliance.h"
#include "app/session/rig/contact_reader.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

/// Counts completed strokes: those that have turned round, and those that ended with a lift (HandStrokes).
class StrokeCount final {
 public:
  /// `from`: the first record of the visit.
  StrokeCount(double direction_rad, JudgedForce force, std::size_t from)
      : reader_(direction_rad, force), read_(from) {}

  /// `records`: all of the attempt up to now.
  int completed(std::span<const TickRecord> records) {
    for (; read_ < records.size(); ++read_) {
      const std::optional<HandSample> hand = reader_.take(records[read_]);
      if (!hand) continue;
      if (hand->begins_contact) strokes_.lift();
      strokes_.take(hand->along_m, records[read_].probe.time_ns);
    }
    const std::size_t begun = strokes_.lengths_m().size();
    return static_cast<int>(reader_.is_in_contact() && begun > 0 ? begun - 1 : begun);
  }

 private:
  ContactReader reader_;
  HandStrokes strokes_{};
  std::size_t read_ = 0;
};

}  // namespace asperity
