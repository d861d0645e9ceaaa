// The wavelengths in recorded forces, as properties of the items of an analysis.

#include "app/records/felt_octaves.h"

#include <cmath>
#include <fstream>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/shared/similarity_properties.h"
#include "app/findings/study/analyze_study.h"
#include "tests/app/scripted_session.h"

namespace asperity {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(FeltOctaves, AddThePowersOfTheTwoBandsOfAnOctave) {
  const auto feature = [](double ratio) {
    return std::log(std::sqrt(ratio * ratio + kFeltRatio * kFeltRatio));
  };
  ForceFeatures features{};
  features.spectrum.fill(feature(0.0));
  features.spectrum[2] = feature(0.03);
  features.spectrum[3] = feature(0.04);
  features.size = feature(0.05);
  FeltOctaves felt{};
  add_octaves(features, felt);
  features.spectrum[2] = feature(0.12);
  features.spectrum[3] = feature(0.16);
  add_octaves(features, felt);
  EXPECT_EQ(felt.presentations, 2U);
  EXPECT_NEAR(felt.mean_ratio(1),
              std::sqrt(std::hypot(0.05, kFeltRatio) * std::hypot(0.2, kFeltRatio)), 1e-12);
  EXPECT_NEAR(felt.mean_ratio(0), kFeltRatio, 1e-12) << "nothing above the floor";
}

TEST(FeltOctaves, LeaveOutContactsThatAreTooShort) {
  ForceFeatures features{};
  features.spectrum.fill(std::log(kFeltRatio));
  features.size = std::log(kFeltRatio);
  FeltOctaves felt{};
  add_octaves(features, felt);
  EXPECT_EQ(felt.presentations, 0U);
}

class RecordedGratings : public SessionTest {
 protected:
  void SetUp() override {
    begin(R"({
  "format": "asperity.protocol/1", "kind": "magnitude", "design": "improved", "name": "gratings",
  "version": "1.0.0", "title": "Gratings",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "estimation": {"factor": "wavelength_m", "predictor": "waves_2.5_to_5_mm"},
  "factors": {"wavelength_m": {"levels": [0.001, 0.002, 0.0035]}},
  "stimuli": {"rendered": {"model": "sinusoid",
      "parameters": {"amplitude_m": 5e-5, "wavelength_m": {"factor": "wavelength_m"}}}},
  "explorations": {"long": {"minimum_contact_s": 4, "maximum_contact_s": 8}},
  "blocks": {"main": {"crossed": ["wavelength_m"], "repetitions": 2,
      "presented": [{"stimulus": "rendered"}], "exploration": "long",
      "question": {"name": "size", "prompt": "How strong?"}}},
  "flow": [{"run": "main"}]})");
    person_.at_question = [](int, const Trial&) { return gives(10.0); };
    EXPECT_EQ(run().state, SessionState::completed);
  }
};

TEST_F(RecordedGratings, ShowTheirWavelengthInItsOctave) {
  const GatheredAnswers gathered = gather_answers(*study_, {}, std::stop_token{}).front();
  EXPECT_EQ(gathered.unread_recordings, 0U);
  const auto of = [&gathered](const char* property) {
    return property_of_items(gathered, {"0.001", "0.002", "0.0035"}, property);
  };
  const auto coarse = of("waves_2.5_to_5_mm");
  const auto fine = of("waves_0.625_to_1.25_mm");
  EXPECT_GT(coarse.at("0.0035"), 5.0 * coarse.at("0.001"));
  EXPECT_GT(fine.at("0.001"), 3.0 * fine.at("0.0035"));
}

std::string remarks_on(const Study& study) {
  std::string remarks{};
  const std::vector<AnalysisOutcome> outcomes = analyze_study(study);
  for (const Phrase& remark : outcomes.front().remarks) remarks += remark.english() + '\n';
  return remarks;
}

TEST_F(RecordedGratings, AreStoredForOnlyOneOfTwoParticipants) {
  EXPECT_THAT(remarks_on(*study_), Not(HasSubstr("recordings")));
  start("p2", 8);
  Conductor conductor(*study_, protocol_, *builder_, *rig_, person_, {.record = false});
  EXPECT_EQ(conductor.run(session_).state, SessionState::completed);
  EXPECT_THAT(remarks_on(*study_), AllOf(HasSubstr("these are stored for only 1 of 2 participants"),
                                         HasSubstr("\"--recordings all\"")));
}

TEST_F(RecordedGratings, AreMissedWhereTheirFilesAreDamaged) {
  const AttemptRow damaged = attempts().front();
  std::ofstream(study_->folder() / damaged.recording->path, std::ios::trunc) << "no recording";
  EXPECT_EQ(gather_answers(*study_, {}, std::stop_token{}).front().unread_recordings, 1U);
  EXPECT_THAT(remarks_on(*study_),
              HasSubstr("their forces: 1. \"asperity verify\" names the files"));
}

}  // namespace
}  // namespace asperity
