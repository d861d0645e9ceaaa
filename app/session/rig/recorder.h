// Collects the tick records of an attempt from the ring and writes them to its recording.

#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <vector>

#include "renderers/servo/record_ring.h"
#include "renderers/servo/tick_record.h"
#include "results_schema/recording.h"

namespace asperity {

class RecordWatch;

/// The state of contact that the conductor polls while a surface is felt.
struct LiveContact {
  /// With the current surface (`is_in_contact`), since it was presented: a sum of periods, which rounding makes
  /// differ from the stored contact time (ticks ÷ rate) by less than a tick.
  double contact_s = 0.0;
  bool touching = false;
  bool presented = false;  ///< the servo has taken the surface
  /// For how long the probe has been in the surface without a force: the surface appeared around it, and it has not left it.
  double silent_s = 0.0;
};

/// Takes the records out of the ring between `begin` and `finish`, and discards them at other
/// times. A watch receives all of them.
///
/// Every record is first converted to the values that its recording will give (`as_recorded`).
///
/// Errors: a recording that cannot be written (a full disk) does not disturb the loop: the attempt
/// continues in memory, and `finish` throws the error of the disk.
///
/// Threads: belongs to the conductor's thread.
class Recorder final {
 public:
  Recorder() = default;
  /// `watch` may be null; otherwise it outlives the recorder.
  explicit Recorder(RecordWatch* watch) : watch_(watch) {}

  /// `writer` may be null: the attempt is then measured without being recorded. Earlier records
  /// that are still in the ring are discarded.
  void begin(std::unique_ptr<RecordingWriter> writer, double rate_Hz, RecordRing& records);
  /// `ahead_ns` is added to the times of the records: the offset of the session's clock from the
  /// servo's.
  void drain(RecordRing& records, std::int64_t ahead_ns = 0);
  /// Restarts the count of contact, for the surface presented next, or for one with this many parts.
  void watch(std::uint64_t presentation, std::size_t parts = 0) noexcept;
  LiveContact live() const noexcept { return live_; }
  bool is_open() const noexcept { return open_; }
  /// The records of the current attempt, as they will be recorded.
  const std::vector<TickRecord>& records() const noexcept { return records_; }

  struct Attempt {
    std::vector<TickRecord> records{};
    std::optional<RecordingRow> recording{};
    std::uint64_t lost_records = 0;
  };
  /// Ends the attempt. Throws the writer's ResultsError, if there was one.
  Attempt finish(const RecordRing& records);
  /// Ends the attempt without keeping it (an unfinished recording stays as `.part`).
  void abandon() noexcept;

 private:
  RecordWatch* watch_ = nullptr;
  std::int64_t ahead_ns_ = 0;  ///< as last reported
  bool open_ = false;
  double rate_Hz_ = 1000.0;
  std::uint64_t lost_before_ = 0;
  bool is_watched(const TickRecord& record) const noexcept {
    return watched_ != 0 && (record.presentation == watched_ ||
                             (record.presentation != 0 && record.presentation <= watched_parts_));
  }

  std::uint64_t watched_ = 0;
  std::size_t watched_parts_ = 0;
  LiveContact live_{};
  std::vector<TickRecord> records_{};
  std::size_t latest_ = 0;  ///< records of the latest attempt; the next one has about as many
  std::unique_ptr<RecordingWriter> writer_{};
  std::exception_ptr write_error_{};
};

}  // namespace asperity
