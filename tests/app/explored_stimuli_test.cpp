// The stimuli that are examined before a session.

#include "app/session/explored_stimuli.h"

#include <algorithm>
#include <cmath>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/rehearsal/rehearsal.h"
#include "protocols/plan/plan.h"
#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"

namespace asperity {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

/// Two gratings, which one block presents twice in strokes, and another one also to a hand that presses.
constexpr const char* kTwiceExplored = R"({
  "format": "asperity.protocol/1",
  "kind": "selection",
  "design": "improved",
  "name": "gratings",
  "version": "1.0.0",
  "title": "Which one is rougher?",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "realism_standard": "memory",
  "factors": {"spacing": {"levels": [0.004, 0.002]}},
  "stimuli": {
    "grating": {"model": "sinusoid",
                "parameters": {"wavelength_m": {"factor": "spacing"}}}
  },
  "explorations": {"stroke": {"minimum_contact_s": 0.3, "maximum_contact_s": 2,
                              "stroke_length_m": {"target": 0.04},
                              "speed_m_per_s": {"target": 0.06}},
                   "press": {"minimum_contact_s": 0.3, "maximum_contact_s": 2}},
  "blocks": {
    "strokes": {
      "presented": [{"stimulus": "grating", "with": {"spacing": 0.004}, "item": "coarse"},
                    {"stimulus": "grating", "with": {"spacing": 0.002}, "item": "fine"}],
      "repetitions": 2,
      "question": {"name": "rougher", "prompt": "Which surface felt rougher?"},
      "exploration": "stroke"
    },
    "presses": {
      "presented": [{"stimulus": "grating", "with": {"spacing": 0.004}, "item": "coarse"},
                    {"stimulus": "grating", "with": {"spacing": 0.002}, "item": "fine"}],
      "question": {"name": "rougher", "prompt": "Which surface felt rougher?"},
      "exploration": "press"
    }
  },
  "flow": [{"run": "strokes"}, {"run": "presses"}, {"run": "strokes"}]
})";

class ExploredStimuli : public ::testing::Test {
 protected:
  using Names = std::vector<std::pair<std::string, std::string>>;

  Names examined(const StimuliCourse& course, std::stop_source* stop = nullptr) {
    Names names{};
    for_each_stimulus(protocol_, possible_trials(protocol_), course,
                      [&](const ExploredStimulus& one) {
                        names.emplace_back(one.planned.stimulus.name, one.exploration.name);
                        if (stop != nullptr) stop->request_stop();
                      });
    return names;
  }

  ModelRegistry models_ = built_in_models();
  Protocol protocol_ = read_small_protocol(models_, kTwiceExplored);
};

TEST_F(ExploredStimuli, AreExaminedOnceForEachExploration) {
  EXPECT_THAT(examined({}), ElementsAre(Pair("grating_sinusoid_0.004", "stroke"),
                                        Pair("grating_sinusoid_0.002", "stroke"),
                                        Pair("grating_sinusoid_0.004", "press"),
                                        Pair("grating_sinusoid_0.002", "press")));
}

// Factors and roving choose what a name does not state.
TEST_F(ExploredStimuli, AreDifferentWhereTheirMaterialDiffers) {
  protocol_.blocks.at("presses").exploration = protocol_.blocks.at("strokes").exploration;
  EXPECT_EQ(examined({}).size(), 2U);
  protocol_.blocks.at("presses").rove.stiffness_N_per_m = {400.0, 600.0};
  EXPECT_EQ(examined({}).size(), 4U);
}

TEST_F(ExploredStimuli, ReportTheirProgressAndStopOnRequest) {
  std::vector<double> progress{};
  examined({.progress = [&](double done) { progress.push_back(done); }});
  EXPECT_THAT(progress, ElementsAre(0.0, 0.25, 0.5, 0.75));
  std::stop_source stop{};
  EXPECT_EQ(examined({.stop = stop.get_token()}, &stop).size(), 1U);
}

/// Nine levels of a wavelength, from 1.1 to 1.9 mm; the standard has 1 mm.
constexpr const char* kNineLevels = R"({
  "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "levels",
  "version": "1.0.0", "title": "Levels", "consent": {"version": "1.0", "statement": "I take part."},
  "stimuli": {"grating": {"model": "sinusoid", "parameters": {"wavelength_m": 0.001}}},
  "explorations": {"stroke": {"minimum_contact_s": 1, "maximum_contact_s": 6}},
  "blocks": {"pairs": {
    "vary": {"parameter": "wavelength_m", "of": "comparison", "relative_to": "standard",
             "levels_percent": [10, 20, 30, 40, 50, 60, 70, 80, 90]},
    "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
    "repetitions": 2, "positions": "balanced", "exploration": "stroke",
    "question": {"name": "coarser", "prompt": "Which is coarser?", "judgement": "performance"}}},
  "flow": [{"run": "pairs"}]
})";

class LevelsNearALimit : public ::testing::Test {
 protected:
  /// The levels that are examined, in tenths of a millimetre, if those from `first_near` on are near the limit.
  std::vector<int> examined(int first_near, const StimuliCourse& course = {}) {
    std::vector<int> levels{};
    for_each_stimulus_near_limit(
        protocol_, possible_trials(protocol_), course, [&](const ExploredStimulus& one) {
          const double level_m =
              std::get<double>(one.planned.stimulus.parameters.at("wavelength_m"));
          const int level = static_cast<int>(std::lround(1e4 * level_m));
          if (level == 10) return Nearness::far;  // the standard
          levels.push_back(level);
          return level >= first_near ? Nearness::near : Nearness::far;
        });
    return levels;
  }

  ModelRegistry models_ = built_in_models();
  Protocol protocol_ = read_small_protocol(models_, kNineLevels);
};

TEST_F(LevelsNearALimit, AreTheEndsAndTheMiddleWhereTheseAreFar) {
  EXPECT_THAT(examined(20), ElementsAre(11, 19, 15));
}

TEST_F(LevelsNearALimit, AreAllThatCanBeBeyondIt) {
  EXPECT_THAT(examined(17), ElementsAre(11, 19, 15, 17, 16, 18));
  EXPECT_EQ(examined(11).size(), 9U);
}

TEST_F(LevelsNearALimit, ReportTheProgressThroughAllAndStopOnRequest) {
  std::vector<double> progress{};
  examined(20, {.progress = [&](double done) { progress.push_back(done); }});
  ASSERT_EQ(progress.size(), 4U);
  EXPECT_EQ(progress.front(), 0.0);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_LT(progress.back(), 1.0);
  std::stop_source stop{};
  stop.request_stop();
  EXPECT_TRUE(examined(11, {.stop = stop.get_token()}).empty());
}

// At 100 mm/s the levels have 52.6 to 90.9 Hz and the standard has 100 Hz.
TEST_F(LevelsNearALimit, AreComparedWithADevice) {
  protocol_.explorations.at("stroke").speed_m_per_s.maximum = 0.1;
  std::size_t compared = 0;
  const auto bandwidth_warnings = [&](double resonance_Hz) {
    const DeviceProfile device{
        .rate_Hz = 1000.0,
        .workspace_minimum_m = glm::dvec3(-1.0),
        .workspace_maximum_m = glm::dvec3(1.0),
        .items = {
            {.name = "resonance_Hz", .status = DeviceItem::Status::pass, .value = resonance_Hz}}};
    StimulusBuilder builder(models_, {});
    compared = 0;
    std::vector<std::string> texts{};
    for (const RehearsalWarning& warning : rehearse_on_device(
             protocol_, device, builder, {.progress = [&](double) { ++compared; }})) {
      if (warning.id == "bandwidth") texts.push_back(warning.text.english());
    }
    return texts;
  };
  EXPECT_TRUE(bandwidth_warnings(200.0).empty());
  EXPECT_EQ(compared, 4U) << "all are below 100 Hz";
  EXPECT_THAT(bandwidth_warnings(70.0), Contains(HasSubstr("4 levels of wavelength_m (0.0011, ")));
  EXPECT_EQ(compared, 10U);
}

}  // namespace
}  // namespace asperity
