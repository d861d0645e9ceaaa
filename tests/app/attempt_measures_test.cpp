// What the records of an attempt tell of the servo loop.

#include "app/session/attempt_measures.h"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/records/recording_curves.h"
#include "app/session/rig/record_watch.h"
#include "app/session/rig/recorder.h"

namespace asperity {
namespace {

/// Ticks at 1 kHz: 'f' feels a surface, 'p' is presented one and feels nothing, '-' neither; 'F', 'P' and '_' came late.
std::vector<TickRecord> ticks(const std::string& what) {
  std::vector<TickRecord> records{};
  for (const char each : what) {
    TickRecord record{};
    record.probe.time_ns = 1'000'000 * static_cast<std::int64_t>(records.size());
    const auto set = [&record](TickFlag flag) { record.flags |= static_cast<std::uint32_t>(flag); };
    if (each == 'f' || each == 'F' || each == 'p' || each == 'P') set(TickFlag::presenting);
    if (each == 'f' || each == 'F') record.penetration_m = 1e-4;
    if (each == 'F' || each == 'P' || each == '_') set(TickFlag::missed_deadline);
    records.push_back(record);
  }
  return records;
}

ServoQualityRow quality_of(const std::string& what) {
  return servo_quality_of(ticks(what), 1000.0, 0);
}

TEST(ServoQuality, CountsDeadlinesMissedInContactApartFromAllOthers) {
  const ServoQualityRow slow_answer = quality_of("pffffp-________-");
  EXPECT_EQ(slow_answer.missed_deadlines, 8);
  EXPECT_EQ(slow_answer.missed_in_contact, 0);
  const ServoQualityRow felt = quality_of("_PpfFFfp--");
  EXPECT_EQ(felt.missed_deadlines, 4);
  EXPECT_EQ(felt.missed_in_contact, 2);
}

// The force of the tick before is held until the late one.
TEST(ServoQuality, CountsALateTickBehindTheLastOfAContact) {
  EXPECT_EQ(quality_of("ffPp").missed_in_contact, 1);
  EXPECT_EQ(quality_of("ff_-").missed_in_contact, 1);
  EXPECT_EQ(quality_of("Fff").missed_in_contact, 1);
}

/// The ticks as the first surface of an attempt, completely faded in.
std::vector<TickRecord> ticks_of_surface(const std::string& what) {
  std::vector<TickRecord> records = ticks(what);
  for (TickRecord& record : records) {
    if (!record.has(TickFlag::presenting)) continue;
    record.presentation = 1;
    record.gain = 1.0;
    record.sent.force_N.z = 1.0;
  }
  return records;
}

// What is stored, what decides when a surface is removed, what judges the hand, and what windows and plots show.
TEST(Contact, IsTheSameForEveryNumberAndDisplay) {
  const std::vector<TickRecord> records = ticks_of_surface("--ppffffpffpp--");
  PresentationRow row{};
  fill_times(records, 1, 1000.0, row);
  EXPECT_EQ(row.contact_s, 0.006);
  EXPECT_EQ(row.contact_ns, 4'000'000);

  SessionMonitor monitor;
  RecordWatch watch(&monitor);
  Recorder recorder(&watch);
  RecordRing ring(64);
  recorder.begin(nullptr, 1000.0, ring);
  recorder.watch(1);
  ContactReader reader{};
  int judged = 0;
  for (const TickRecord& record : records) {
    ring.push(record);
    recorder.drain(ring);
    EXPECT_EQ(recorder.live().touching, record.penetration_m > 0.0);
    if (reader.take(record)) ++judged;
  }
  EXPECT_NEAR(recorder.live().contact_s, 0.006, 1e-12);
  EXPECT_EQ(judged, 6);

  const RecordingCurves curves = curves_of(records, 1000.0, 0);
  ASSERT_EQ(curves.contacts.size(), 1U);  // a tick without contact is a crest
  EXPECT_NEAR(curves.contacts.front().begin_s, 0.004, 1e-12);
  EXPECT_NEAR(curves.contacts.front().end_s, 0.010, 1e-12);
}

TEST(ServoQuality, CountsNoneWhereThereIsNoTick) { EXPECT_EQ(quality_of("").missed_in_contact, 0); }

}  // namespace
}  // namespace asperity
