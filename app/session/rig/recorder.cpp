// Rounds each tick to what a recording stores, passes it to the watch, and keeps it until the attempt ends.

#include "app/session/rig/recorder.h"

#include <utility>

#include "app/session/rig/record_watch.h"
#include "app/session/rig/recording_columns.h"
#include "renderers/servo/contact.h"

namespace asperity {

void Recorder::begin(std::unique_ptr<RecordingWriter> writer, double rate_Hz, RecordRing& records) {
  open_ = false;
  drain(records, ahead_ns_);
  open_ = true;
  rate_Hz_ = rate_Hz;
  lost_before_ = records.lost();
  watched_ = 0;
  watched_parts_ = 0;
  live_ = {};
  records_.clear();
  records_.reserve(latest_);
  writer_ = std::move(writer);
  write_error_ = nullptr;
}

void Recorder::drain(RecordRing& records, std::int64_t ahead_ns) {
  ahead_ns_ = ahead_ns;
  TickRecord raw{};
  while (records.pop(raw)) {
    raw.probe.time_ns += ahead_ns;
    const TickRecord record = as_recorded(raw);
    if (watch_ != nullptr) watch_->take(record);
    if (!open_) continue;
    records_.push_back(record);
    if (is_watched(record)) {
      live_.presented = true;
      live_.touching = is_in_contact(record);
      if (live_.touching) live_.contact_s += 1.0 / rate_Hz_;
      const bool is_silent = live_.touching && record.gain == 0.0;
      live_.silent_s = is_silent ? live_.silent_s + 1.0 / rate_Hz_ : 0.0;
    } else {
      live_.touching = false;
      live_.silent_s = 0.0;
    }
    if (writer_ && !write_error_) {
      try {
        writer_->append(record.probe.time_ns, columns_of(record).data());
      } catch (...) {
        write_error_ = std::current_exception();
      }
    }
  }
}

void Recorder::watch(std::uint64_t presentation, std::size_t parts) noexcept {
  watched_ = presentation;
  watched_parts_ = parts;
  live_ = {};
}

Recorder::Attempt Recorder::finish(const RecordRing& records) {
  open_ = false;
  if (write_error_) std::rethrow_exception(write_error_);
  Attempt attempt{};
  attempt.lost_records = records.lost() - lost_before_;
  if (writer_) attempt.recording = writer_->finish();
  writer_.reset();
  latest_ = records_.size();
  attempt.records = std::move(records_);
  records_ = {};
  return attempt;
}

void Recorder::abandon() noexcept {
  open_ = false;
  writer_.reset();
  records_.clear();
}

}  // namespace asperity
