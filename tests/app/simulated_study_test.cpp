// Studies simulated from response tables: what each participant has alone, and what responses lead to.

#include "app/power/simulated_study.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/power/power_model.h"
#include "tests/protocols/protocol_files.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// The responses with these values; effects that are not stated are null, and their standard deviations 0.1.
std::vector<GatheredAnswers> study_with(const nlohmann::json& file,
                                        const std::map<std::string, double>& stated,
                                        int participants) {
  const Protocol protocol = test::valid(file, test::models_of_library());
  std::vector<Assumption> assumptions = assumptions_of(protocol);
  for (const auto& [name, value] : stated) set_assumption(assumptions, name, value, "the test");
  for (Assumption& assumption : assumptions) {
    if (assumption.value) continue;
    assumption.value = assumption.part == Assumption::Part::effect ? assumption.null_value : 0.1;
    assumption.source = "the test";
  }
  return simulated_study(PowerModel(protocol, assumptions).tables(), participants, Random(1));
}

std::string level_of(const GatheredAnswers& study, const GatheredAnswer& answer,
                     std::string_view factor) {
  return study.word(study.level(answer, factor));
}

TEST(SimulatedStudy, HasAPlanOfItsOwnForEachParticipant) {
  const auto studies = study_with(test::library_file("roughness_of_photographs"), {}, 2);
  std::vector<std::vector<std::string>> textures(2);
  for (const GatheredAnswer& answer : studies.front().answers) {
    textures.at(answer.person).push_back(level_of(studies.front(), answer, "texture"));
  }
  ASSERT_THAT(textures[0], SizeIs(24));
  EXPECT_THAT(textures[1], testing::UnorderedElementsAreArray(textures[0]));
  EXPECT_NE(textures[0], textures[1]);
}

// Without such an effect the power would be that of equal groups.
TEST(SimulatedStudy, IsRefusedWhereTheTablesHaveNoEffectOfTheGroupsThatTheFamilyCompares) {
  nlohmann::json file = test::library_file("roughness_of_photographs");
  file["factors"]["training"] = {{"levels", {"none", "haptic"}}};
  file["groups"] = {{"factor", "training"}};
  file["analysis"]["family"] = {"groups"};
  EXPECT_NO_THROW(study_with(file, {}, 2));
  file["analysis"]["family"] = {"groups", "group_profiles"};
  EXPECT_THAT(refusal_of([&file] { study_with(file, {}, 2); }),
              testing::AllOf(HasSubstr("no effect of the groups for the test \"group_profiles\""),
                             HasSubstr("add --physics")));
}

// Groups in turn, beginning one later in every round of an even number of them.
TEST(SimulatedStudy, AssignsParticipantsInTurn) {
  nlohmann::json file = test::library_file("improved_recognition");
  file["factors"]["training"] = {{"levels", {"none", "haptic"}}};
  file["groups"] = {{"factor", "training"}, {"assigned", "balanced"}};
  EXPECT_EQ(participants_per_round(test::valid(file, test::models_of_library())), 2);
  const auto studies = study_with(file, {}, 4);
  std::vector<std::string> groups{};
  for (const AnsweringPerson& person : studies.front().people) {
    groups.push_back(person.group.value_or("none of them"));
  }
  EXPECT_THAT(groups, ElementsAre("none", "haptic", "haptic", "none"));
}

// Without noise a participant gives a texture the same number in every repetition.
TEST(SimulatedStudy, KeepsTheDifferencesOfAParticipant) {
  const auto studies = study_with(
      test::library_file("roughness_of_photographs"),
      {{"difference_sd", 15.0}, {"level_sd", 5.0}, {"noise_sd", 0.0}, {"lapse", 0.0}}, 3);
  const GatheredAnswers& study = studies.front();
  std::map<std::pair<std::uint32_t, std::string>, std::set<double>> ratings{};
  std::set<double> different{};
  for (const GatheredAnswer& answer : study.answers) {
    const double rating = study.reply_of(answer).number.value();
    ratings[{answer.person, level_of(study, answer, "texture")}].insert(rating);
    different.insert(rating);
  }
  EXPECT_THAT(ratings, SizeIs(12));
  for (const auto& [of, own] : ratings) EXPECT_THAT(own, SizeIs(1)) << of.first << ' ' << of.second;
  EXPECT_GT(different.size(), 6U);
}

/// The amplitude of the comparison in the last step of the first track.
double last_level_m(const GatheredAnswers& study) {
  std::map<int, double> levels{};
  for (const GatheredAnswer& answer : study.answers) {
    if (answer.track == 1) levels[answer.step] = std::stod(level_of(study, answer, "amplitude_m"));
  }
  return levels.rbegin()->second;
}

// From 75 µm the procedure goes down to the lowest level, 51 µm, where responses are correct, and up to 100 µm with guesses.
TEST(SimulatedStudy, PresentsTheLevelsThatItsResponsesLeadTo) {
  const nlohmann::json file = test::library_file("amplitude_jnd");
  const auto correct = study_with(file, {{"threshold", 1e-9}, {"lapse", 0.0}}, 1);
  const auto guessed = study_with(file, {{"threshold", 1.0}, {"lapse", 0.0}}, 1);
  EXPECT_LT(last_level_m(correct.front()), 55e-6);
  EXPECT_GT(last_level_m(guessed.front()), 85e-6);
}

}  // namespace
}  // namespace asperity
