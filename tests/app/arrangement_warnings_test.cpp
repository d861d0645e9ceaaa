// Warnings about designs that are valid and may not be felt as intended: patches, steps of levels, and the report of them.

#include "app/tasks/warnings/arrangement_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/report/text/report_arrangement.h"
#include "app/session/rehearsal/level_rehearsal.h"
#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Two gratings of this period [m] and amplitude [m]; the block has this arrangement.
Protocol two_gratings_of(const std::string& period, const std::string& amplitude,
                         const std::string& arrangement, const std::string& exploration = "") {
  return read_small_protocol(built_in_models(), R"({
    "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "two",
    "version": "1.0.0", "title": "Two", "consent": {"version": "1.0", "statement": "I take part."},
    "surface": {"centre_m": [0, 0, 0], "extent_m": [0.1, 0.1], "tiling": "repeat", "edge": "fade",
                "edge_width_m": 0.005, "motion_scale": 1},
    "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": )" +
                                                    amplitude + R"(, "wavelength_m": )" + period +
                                                    R"(}}},
    "explorations": {"stroking": {"minimum_contact_s": 1, "maximum_contact_s": 6)" +
                                                    exploration + R"(}},
    "blocks": {"pairs": {
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard", "levels_ratio": [1.1]},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "repetitions": 2, "positions": "balanced", "exploration": "stroking", "arrangement": )" +
                                                    arrangement + R"(,
      "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
    "flow": [{"run": "pairs"}]})");
}

class ArrangementWarnings : public testing::Test {
 protected:
  std::vector<Diagnostic> warnings_of(const Protocol& protocol) {
    if (!builder_) {
      make_small_study(folder_ / "study");
      builder_.emplace(models_, folder_ / "study");
    }
    return warnings_about_arrangements({protocol, "p.json"}, *builder_);
  }
  const TemporaryFolder folder_{};
  ModelRegistry models_ = built_in_models();
  std::optional<StimulusBuilder> builder_{};
};

constexpr const char* kPatches = R"({"surfaces": "side_by_side"})";

TEST_F(ArrangementWarnings, AreNoneForPatchesOfManyFinePeriods) {
  EXPECT_THAT(warnings_of(two_gratings_of("0.0025", "5e-5", kPatches)), IsEmpty());
}

TEST_F(ArrangementWarnings, NamePatchesWithFewPeriods) {
  const std::vector<Diagnostic> found = warnings_of(two_gratings_of("0.008", "5e-5", kPatches));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].pointer, "/blocks/pairs/arrangement/surfaces");
  EXPECT_THAT(found[0].message.english(), HasSubstr("47 mm wide and contain 5.9 periods"));
}

TEST_F(ArrangementWarnings, NameStrokesLongerThanAPatch) {
  const std::vector<Diagnostic> found = warnings_of(two_gratings_of(
      "0.0025", "5e-5", kPatches, R"(, "direction_rad": 0, "stroke_length_m": {"target": 0.06})"));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].message.english(), HasSubstr("requests strokes of 60 mm"));
  EXPECT_THAT(
      warnings_of(two_gratings_of("0.0025", "5e-5", R"({"surfaces": "side_by_side", "axis": "y"})",
                                  R"(, "direction_rad": 0, "stroke_length_m": {"target": 0.06})")),
      IsEmpty())
      << "across the strokes";
}

// 1.5 · 500 N/m · 0.5 mm · 0.2 m/s · 1 ms / 2 mm
TEST_F(ArrangementWarnings, NameSidesThatAreFeltAsEdges) {
  const std::vector<Diagnostic> found = warnings_of(two_gratings_of("0.0025", "5e-4", kPatches));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].message.english(), HasSubstr("can change by 38 mN from tick to tick"));
}

TEST_F(ArrangementWarnings, NameStrokesThatDoNotFitIntoAVisit) {
  const std::vector<Diagnostic> found = warnings_of(two_gratings_of(
      "0.0025", "5e-5", R"({"exposure": {"strokes": 20}})",
      R"(, "stroke_length_m": {"target": 0.04}, "speed_m_per_s": {"target": 0.08})"));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].message.english(),
              HasSubstr("20 strokes of the exploration \"stroking\" take 10.0 s"));
}

/// A step of 5 µm at 500 N/m is 2.5 mN; the noise of a resolution of 38 µm is 19 mN.
TEST(LevelSteps, AreComparedWithTheNoiseOfTheForce) {
  const Protocol protocol = two_gratings_of("0.0025", "5e-5", "{}");
  DeviceProfile profile{.name = "falcon"};
  EXPECT_THAT(level_warnings(protocol, profile, built_in_models()), IsEmpty()) << "not measured";
  profile.items = {{.name = "position_resolution_m", .value = 1e-6}};
  EXPECT_THAT(level_warnings(protocol, profile, built_in_models()), IsEmpty());
  profile.items = {{.name = "position_resolution_m", .value = 3.8e-5}};
  const std::vector<RehearsalWarning> found = level_warnings(protocol, profile, built_in_models());
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].id, "level_step");
  EXPECT_EQ(found[0].pointer, "/blocks/pairs/vary");
  EXPECT_NEAR(found[0].asked, 0.0025, 1e-9);
  EXPECT_NEAR(found[0].device, 0.019, 1e-9);
  EXPECT_THAT(found[0].text.english(), HasSubstr("steps of at least 114 µm"));
}

TEST(ReportedArrangement, StatesWhatTheTrialWas) {
  const auto sentences = [](const std::string& arrangement) {
    return arrangement_sentences(two_gratings_of("0.0025", "5e-5", arrangement).blocks.at("pairs"));
  };
  EXPECT_EQ(
      sentences(R"({"visits": {"minimum": 2, "maximum": 2}, "interval_s": 0.8})"),
      " Task: Two-interval forced choice, one surface after the other, each presented 2 times. "
      "The surfaces are presented in the same order twice in each trial. The interval from "
      "the last contact with a surface to the permission to touch the next one is 0.8 s. "
      "Participants cannot return to a surface within a trial.");
  EXPECT_THAT(sentences(kPatches), HasSubstr("Two-alternative forced choice, side by side."));
  EXPECT_THAT(sentences(kPatches), HasSubstr("separated by a flat gap of 6 mm"));
  EXPECT_THAT(sentences(R"({"surfaces": "on_request", "visits": {"maximum": 3}})"),
              HasSubstr("A surface can be felt at most 3 times."));
}

}  // namespace
}  // namespace asperity
