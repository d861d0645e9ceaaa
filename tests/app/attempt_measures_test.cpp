// What the records of an attempt tell of the servo loop.

#include "app/session/attempt_measures.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

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

TEST(ServoQuality, CountsNoneWhereThereIsNoTick) { EXPECT_EQ(quality_of("").missed_in_contact, 0); }

}  // namespace
}  // namespace asperity
