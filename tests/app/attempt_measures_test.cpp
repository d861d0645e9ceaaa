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

TEST(ServoQuality, CountsTheGapsInContact) {
  std::vector<TickRecord> records = ticks("ffffpp");
  for (const std::size_t i : {std::size_t{1}, std::size_t{3}}) {
    records[i].flags |= static_cast<std::uint32_t>(TickFlag::gap_in_contact);
  }
  EXPECT_EQ(servo_quality_of(records, 1000.0, 0).gaps_in_contact, 2);
  EXPECT_EQ(quality_of("fFfF").gaps_in_contact, 0);
}

TEST(ServoQuality, CountsTheHeldReadingsInContactAndInFreeSpace) {
  std::vector<TickRecord> records = ticks("ffff--");
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}, std::size_t{5}}) {
    records[i].flags |= static_cast<std::uint32_t>(TickFlag::reading_held);
  }
  EXPECT_EQ(servo_quality_of(records, 1000.0, 0).held_readings, 3);
  EXPECT_EQ(quality_of("fFpP").held_readings, 0);
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

TEST(Recorder, CountsHowLongASurfaceThatAppearedAroundTheProbeIsSilent) {
  Recorder recorder;
  RecordRing ring(64);
  recorder.begin(nullptr, 1000.0, ring);
  recorder.watch(1);
  const auto silent_s = [&](double penetration_m, double gain) {
    TickRecord record{};
    record.presentation = 1;
    record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
    record.penetration_m = penetration_m;
    record.gain = gain;
    ring.push(record);
    recorder.drain(ring);
    return recorder.live().silent_s;
  };
  for (int tick = 1; tick <= 5; ++tick) EXPECT_NEAR(silent_s(1e-3, 0.0), 1e-3 * tick, 1e-12);
  EXPECT_EQ(silent_s(0.0, 0.0), 0.0);
  EXPECT_EQ(silent_s(1e-3, 0.5), 0.0);
}

/// Two patches of 47 mm in a workspace of 100 mm, whose border fades over 5 mm; between them 6 mm.
std::vector<SurfacePatch> two_patches(bool along_x) {
  std::vector<SurfacePatch> patches(2);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const double place_m = i == 0 ? -0.0265 : 0.0265;
    patches[i].centre_m = along_x ? glm::dvec3(place_m, 0.0, 0.0) : glm::dvec3(0.0, place_m, 0.0);
    patches[i].extent_m = along_x ? glm::dvec2(0.047, 0.1) : glm::dvec2(0.1, 0.047);
  }
  return patches;
}

TEST(HabitsOverPatches, StrokeInTheDirectionOfTheExplorationWithinAPatch) {
  Exploration exploration{};
  exploration.stroke_length_m = {{}, 0.06, {}};
  exploration.maximum_contact_s = 10.0;
  const HandHabits across = habits_over_patches(exploration, {}, two_patches(false), 1);
  EXPECT_EQ(across.direction_rad, 0.0);
  EXPECT_EQ(across.stroke_length_m, 0.06);
  // From the fading border to the blend: y from −45 to −5 mm.
  EXPECT_NEAR(across.centre_m.y, -0.025, 1e-12);
  EXPECT_NEAR(across.further_centres_m[0].y, 0.025, 1e-12);
  EXPECT_EQ(across.further_centres, 1);
  EXPECT_EQ(across.drift_m, 0.004) << "15 mm is left at each end, 20 mm at each side";
  const HandHabits along = habits_over_patches(exploration, {}, two_patches(true), 1);
  EXPECT_NEAR(along.stroke_length_m, 0.04, 1e-12) << "shortened to the patch";
  EXPECT_NEAR(along.drift_m, 0.0, 1e-12);
  EXPECT_NEAR(along.centre_m.x, -0.025, 1e-12);
  exploration.stroke_length_m = {{}, 0.03, {}};
  EXPECT_NEAR(habits_over_patches(exploration, {}, two_patches(true), 1).drift_m, 0.002, 1e-12)
      << "5 mm at each end";
}

TEST(HabitsOverPatches, DivideTheStrokesAmongTheVisits) {
  Exploration exploration{};
  exploration.stroke_length_m = {{}, 0.03, {}};
  exploration.speed_m_per_s = {{}, 0.1, {}};
  exploration.strokes = {{}, 6.0, {}};
  exploration.maximum_contact_s = 10.0;
  EXPECT_EQ(habits_over_patches(exploration, {}, two_patches(true), 1).strokes_at_a_centre, 6);
  EXPECT_EQ(habits_over_patches(exploration, {}, two_patches(true), 2).strokes_at_a_centre, 3);
  exploration.maximum_contact_s = 2.0;  // three visits: 0.67 s of strokes of 0.3 s
  EXPECT_EQ(habits_over_patches(exploration, {}, two_patches(true), 2).strokes_at_a_centre, 2);
}

TEST(HabitsOverPatches, AreThoseOfAHandWhereThereIsNoRoom) {
  std::vector<SurfacePatch> patches = two_patches(true);
  for (SurfacePatch& patch : patches) patch.extent_m.x = 0.004;
  patches[0].centre_m.x = -0.048;
  patches[1].centre_m.x = 0.048;
  const HandHabits habits = habits_over_patches({}, {}, patches, 1);
  EXPECT_GT(habits.stroke_length_m, 0.0);
  EXPECT_NO_THROW(VirtualHand(habits, Random(1)));
}

TEST(ServoQuality, CountsNoneWhereThereIsNoTick) { EXPECT_EQ(quality_of("").missed_in_contact, 0); }

}  // namespace
}  // namespace asperity
