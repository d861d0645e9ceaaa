// The mean drag that check prints of each stimulus.

#include "app/tasks/warnings/drag_of_stimuli.h"

#include <cmath>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocols/file/library_protocols.h"
#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kStroking =
    R"(, "stroke_length_m": {"target": 0.06}, "speed_m_per_s": {"target": 0.06},
       "normal_force_N": {"target": 1})";

class DragOfStimuli : public ::testing::Test {
 protected:
  DragOfStimuli() { make_small_study(folder_ / "study"); }

  std::vector<StimulusDrag> drags(const std::string& exploration, const std::string& law = "") {
    Protocol protocol = read_small_protocol(models_, small_protocol("", exploration));
    if (!law.empty()) protocol.stimuli.at("rendered").parameters["friction_law"].value = law;
    StimulusBuilder builder(models_, folder_ / "study");
    return drag_of_stimuli({protocol, "p.json"}, builder);
  }

  TemporaryFolder folder_{};
  ModelRegistry models_ = built_in_models();
};

/// Gratings of ±0.1 and ±1 mm on a stiff surface with much friction.
constexpr const char* kStrongGratings = R"({
  "format": "asperity.protocol/1",
  "kind": "selection",
  "design": "improved",
  "name": "gratings",
  "version": "1.0.0",
  "title": "Which one is rougher?",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "realism_standard": "memory",
  "material": {"stiffness_N_per_m": 5000, "friction": 0.8},
  "factors": {"height": {"levels": [0.0001, 0.001]}},
  "stimuli": {
    "grating": {"model": "sinusoid",
                "parameters": {"wavelength_m": 0.004, "amplitude_m": {"factor": "height"}}}
  },
  "explorations": {"stroke": {"minimum_contact_s": 0.3, "maximum_contact_s": 2,
    "stroke_length_m": {"target": 0.04}, "speed_m_per_s": {"target": 0.06},
    "normal_force_N": {"target": 1}}},
  "blocks": {
    "main": {
      "presented": [{"stimulus": "grating", "with": {"height": 0.0001}, "item": "low"},
                    {"stimulus": "grating", "with": {"height": 0.001}, "item": "high"}],
      "question": {"name": "rougher", "prompt": "Which surface felt rougher?"},
      "exploration": "stroke"
    }
  },
  "flow": [{"run": "main"}]
})";

TEST_F(DragOfStimuli, IsThatOfCoulombForBothModelsWithTheDefaultLaw) {
  const std::vector<StimulusDrag> found = drags(kStroking);
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_NE(found[0].stimulus, found[1].stimulus);
  for (const StimulusDrag& drag : found) {
    EXPECT_EQ(drag.exploration, "short");
    EXPECT_NEAR(drag.of_coulomb, 1.0, 0.01) << drag.stimulus;
  }
  EXPECT_NEAR(found[0].of_coulomb, found[1].of_coulomb, 0.003);
}

// 1/√(1 + (10/60)²) of 0.2 · 1 N, at the mean speed of a stroke.
TEST_F(DragOfStimuli, IsThatOfTheLawOfTheStimulus) {
  for (const StimulusDrag& drag : drags(kStroking, "rounded")) {
    EXPECT_NEAR(drag.of_coulomb, 0.98639, 1e-4) << drag.stimulus;
    EXPECT_NEAR(drag.mean_N, 0.2 * drag.of_coulomb, 1e-9) << drag.stimulus;
  }
}

TEST_F(DragOfStimuli, IsNotStatedForAHandThatOnlyPresses) { EXPECT_THAT(drags(""), IsEmpty()); }

// A ridge that is pressed with 6 N turns friction round on more than the 40 mm of the strokes.
TEST_F(DragOfStimuli, IsMeasuredOnStrokesThatAreLongEnough) {
  StimulusBuilder without_files(models_, {});
  const std::vector<StimulusDrag> found =
      drag_of_stimuli({read_small_protocol(models_, kStrongGratings), "p.json"}, without_files);
  ASSERT_THAT(found, SizeIs(2));
  for (const StimulusDrag& drag : found) {
    EXPECT_NEAR(drag.of_coulomb, 1.0, 0.03) << drag.stimulus;
  }
}

TEST_F(DragOfStimuli, IsNotMeasuredAfterAStop) {
  StimulusBuilder without_files(models_, {});
  const Protocol protocol = read_small_protocol(models_, kStrongGratings);
  std::stop_source stop{};
  const StimuliCourse course{.stop = stop.get_token(),
                             .progress = [&](double) { stop.request_stop(); }};
  EXPECT_THAT(drag_of_stimuli({protocol, "p.json"}, without_files, course), SizeIs(1));
  EXPECT_THAT(drag_of_stimuli({protocol, "p.json"}, without_files, course), IsEmpty());
}

TEST_F(DragOfStimuli, LeavesOutWhatCannotBeRendered) {
  StimulusBuilder without_the_texture(models_, folder_ / "elsewhere");
  const Protocol protocol = read_small_protocol(models_, small_protocol("", kStroking));
  EXPECT_THAT(drag_of_stimuli({protocol, "p.json"}, without_the_texture), IsEmpty());
}

// 1/√(1 + (v₀/v)²) with v₀ = 10 mm/s: the friction of pd_gradient depends on the speed.
TEST_F(DragOfStimuli, StatesWhatTheFrictionOfTwoBodiesLosesAtASpeed) {
  StimulusBuilder without_files(models_, {});
  std::map<std::string, double> of_coulomb{};
  for (const LibraryProtocol& library : library_protocols()) {
    if (library.name != "roughness_speed") continue;
    const Protocol protocol = read_small_protocol(models_, std::string(library.text));
    for (const StimulusDrag& drag : drag_of_stimuli({protocol, "p.json"}, without_files)) {
      of_coulomb[drag.exploration] = drag.of_coulomb;
      EXPECT_NEAR(drag.mean_N, 0.2 * 0.8 * drag.of_coulomb, 1e-9) << drag.stimulus;
    }
  }
  ASSERT_THAT(of_coulomb, SizeIs(2));
  EXPECT_NEAR(of_coulomb.at("slow"), 1.0 / std::hypot(1.0, 10.0 / 50.0), 1e-6);
  EXPECT_NEAR(of_coulomb.at("fast"), 1.0 / std::hypot(1.0, 10.0 / 100.0), 1e-6);
}

TEST(DragLines, NameTheStimuliWithTheSameNumbersOnce) {
  std::vector<StimulusDrag> drags{{"fine", "slow", 0.1984, 0.992},
                                  {"coarse", "slow", 0.1650, 0.825},
                                  {"even", "slow", 0.1984, 0.992},
                                  {"fine", "fast", 0.1984, 0.992}};
  EXPECT_THAT(
      drag_lines(drags),
      ElementsAre(
          HasSubstr("should have the same mean drag, because participants can otherwise"),
          "mean drag 0.198 N, 99.2 % of friction × normal force: fine, even (exploration slow)",
          "mean drag 0.165 N, 82.5 % of friction × normal force: coarse (exploration slow)",
          "mean drag 0.198 N, 99.2 % of friction × normal force: fine (exploration fast)"));
  drags.clear();
  for (int level = 1; level <= 60; ++level) {
    drags.push_back({"l" + std::to_string(level), "slow", 0.1984, 0.992});
  }
  EXPECT_THAT(drag_lines(drags),
              ElementsAre(HasSubstr("the mean drag is the mean force of friction"),
                          "mean drag 0.198 N, 99.2 % of friction × normal force: l1, l2, l3, l4, "
                          "l5, l6, l7, l8 and 52 more (exploration slow)"));
  EXPECT_THAT(drag_lines({}), IsEmpty());
}

}  // namespace
}  // namespace asperity
