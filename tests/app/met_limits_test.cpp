// What a protocol allows at most is allowed: every limit is met exactly, and then exceeded by the least that it can be.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/profiles/device_profile.h"
#include "app/session/attempt_instability.h"
#include "app/session/attempt_measures.h"
#include "app/session/rehearsal/rehearsed_device.h"
#include "app/tasks/checks/device_requirements.h"
#include "app/words/coded_phrases.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/scripted_session.h"

namespace asperity {
namespace {

class MetLimits : public SessionTest {
 protected:
  /// The first attempt of a new session, in which `disturb` is called once while a surface is presented.
  AttemptRow attempt_with(const std::function<void()>& disturb) {
    start("of" + std::to_string(++sessions_), 7);
    rig_->at_pass = [this, &disturb, is_done = false]() mutable {
      if (is_done || rig_->loop().status().presentation == 0) return;
      is_done = true;
      disturb();
    };
    EXPECT_EQ(run().state, SessionState::completed);
    return attempts().front();
  }

  void record_ticks(TickFlag flag, int count) {
    TickRecord record{};
    record.probe.time_ns = rig_->clock().now_ns();
    record.presentation = 1;
    record.penetration_m = 1e-4;
    record.flags =
        static_cast<std::uint32_t>(flag) | static_cast<std::uint32_t>(TickFlag::presenting);
    for (int i = 0; i < count; ++i) rig_->records().push(record);
  }

  /// Fills the ring beyond its end, and empties it again: it was empty before.
  void lose_records(int count) {
    RecordRing& ring = rig_->records();
    const std::uint64_t before = ring.lost();
    while (ring.lost() - before < static_cast<std::uint64_t>(count)) ring.push({});
    for (TickRecord record{}; ring.pop(record);) {
    }
  }

 private:
  int sessions_ = 0;
};

TEST_F(MetLimits, OfTheServoLoopLeaveAnAttemptValid) {
  begin(small_protocol());
  protocol_.maximum_missed_deadlines = 50;
  protocol_.maximum_gaps_in_contact = 40;
  protocol_.maximum_lost_records = 3;
  struct Case {
    const char* code;
    int most;
    std::function<void(int)> disturb;
  };
  const std::vector<Case> cases{
      {"deadlines_missed_in_contact", 50,
       [this](int count) { record_ticks(TickFlag::missed_deadline, count); }},
      {"gaps_in_contact", 40, [this](int count) { record_ticks(TickFlag::gap_in_contact, count); }},
      {"records_lost", 3, [this](int count) { lose_records(count); }}};
  for (const Case& limit : cases) {
    const AttemptRow met = attempt_with([&] { limit.disturb(limit.most); });
    EXPECT_TRUE(met.valid) << met.invalid_reason.value_or("").text;
    const AttemptRow exceeded = attempt_with([&] { limit.disturb(limit.most + 1); });
    ASSERT_FALSE(exceeded.valid) << limit.code;
    EXPECT_EQ(codes_of(exceeded.invalid_reason.value()), limit.code);
    if (limit.code == std::string("records_lost")) {
      EXPECT_EQ(exceeded.invalid_reason->text.find(
                    "4 of " + std::to_string(exceeded.servo->ticks + 4) + " ticks are missing"),
                0U)
          << exceeded.invalid_reason->text;
    }
  }
}

TEST_F(MetLimits, OfVibrationAreNoExcess) {
  Protocol protocol{};
  protocol.instability = InstabilityRule{.buzz_max = 0.25};
  std::vector<PresentationRow> surfaces(1);
  surfaces[0].position = 1;
  surfaces[0].instability = InstabilityRow{.buzz = 0.25};
  EXPECT_TRUE(excessive_buzz(protocol, surfaces).empty());
  surfaces[0].instability->buzz = std::nextafter(0.25, 1.0);
  EXPECT_FALSE(excessive_buzz(protocol, surfaces).empty());
}

TEST_F(MetLimits, OfTheTimeInContactAreKept) {
  std::vector<TickRecord> records(125);  // 0.125 s at 1 kHz
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i].probe.time_ns = 1'000'000 * static_cast<std::int64_t>(i);
    records[i].presentation = 1;
    records[i].flags = static_cast<std::uint32_t>(TickFlag::presenting);
    records[i].penetration_m = 1e-4;
    records[i].gain = 1.0;
    records[i].sent.force_N.z = 1.0;
  }
  const auto passes = [&](double minimum_s, double maximum_s) {
    Exploration asked{};
    asked.minimum_contact_s = minimum_s;
    asked.maximum_contact_s = maximum_s;
    const std::vector<ComplianceRow> rows = compliance_of(records, 1, 1000.0, asked);
    const auto contact = std::find_if(rows.begin(), rows.end(), [](const ComplianceRow& row) {
      return row.quantity == "contact_s";
    });
    return contact != rows.end() && contact->passed.value_or(false);
  };
  EXPECT_TRUE(passes(0.125, 0.125));
  EXPECT_FALSE(passes(0.126, 0.2));
  EXPECT_FALSE(passes(0.1, 0.124));
}

TEST_F(MetLimits, OfADeviceAreNoComplaint) {
  Protocol protocol{};
  protocol.rate_Hz = 1000.0;
  protocol.force_limit_N = 5.0;
  DeviceCapability device{.name = "arm", .peak_force_N = 5.0, .maximum_rate_Hz = 1000.0};
  EXPECT_TRUE(complaints_about_device(protocol, device).empty());
  device.peak_force_N = std::nextafter(5.0, 0.0);
  EXPECT_EQ(complaints_about_device(protocol, device).size(), 1U);
  device.maximum_rate_Hz = std::nextafter(1000.0, 0.0);
  EXPECT_EQ(complaints_about_device(protocol, device).size(), 2U);
}

TEST_F(MetLimits, OfAnItemOfAProfileAreKept) {
  using Bound = DeviceItem::Bound;
  EXPECT_TRUE(keeps(0.5, Bound::at_most, 0.5));
  EXPECT_TRUE(keeps(0.5, Bound::at_least, 0.5));
  EXPECT_FALSE(keeps(std::nextafter(0.5, 1.0), Bound::at_most, 0.5));
  EXPECT_FALSE(keeps(std::nextafter(0.5, 0.0), Bound::at_least, 0.5));
}

TEST_F(MetLimits, OfTheAgeOfAProfileAreKept) {
  Protocol protocol{};
  protocol.profile_maximum_age_days = 30.0;
  DeviceProfile profile{
      .name = "arm", .measured_utc = "2026-01-01T10:00:00.000Z", .rate_Hz = 1000.0};
  std::filesystem::create_directories(folder_ / "profiles");
  write_file(profile_path(folder_.path(), profile), json_text_of(profile), Overwrite::refuse);
  const auto refusal_at = [&](const std::string& now_utc) {
    return profiled_device(protocol, {.which = {.name = "arm"}}, folder_.path(), now_utc)
        .refusal.english();
  };
  EXPECT_EQ(refusal_at("2026-01-31T10:00:00.000Z"), "");
  EXPECT_NE(refusal_at("2026-01-31T10:00:01.000Z").find("protocol allows at most 30"),
            std::string::npos);
}

}  // namespace
}  // namespace asperity
