// Warnings about virtual observers that cannot judge what a discrimination varies.

#include "app/tasks/warnings/observer_warnings.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/tasks/warnings/stimulus_warnings.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"

namespace asperity {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// The protocol of the library, changed by a merge patch.
Protocol patched(const std::string& name, const char* patch) {
  for (const auto& each : library_protocols()) {
    if (each.name != name) continue;
    auto source = nlohmann::ordered_json::parse(each.text);
    source.merge_patch(nlohmann::ordered_json::parse(patch));
    return read_protocol(source.dump(2), name + ".json", declarations_of(built_in_models()));
  }
  throw std::logic_error("the library has no " + name);
}

std::vector<Diagnostic> warned(const Protocol& protocol) {
  const ModelRegistry models = built_in_models();
  StimulusBuilder without_files(models, {});
  return warnings_about_observer({protocol, "p.json"}, without_files);
}

TEST(ObserverWarnings, AreNoneForTheLibrary) {
  EXPECT_THAT(warned(patched("amplitude_jnd", "{}")), IsEmpty());
  EXPECT_THAT(warned(patched("spacing_jnd", "{}")), IsEmpty());
}

// Without friction, forces along the normal have no lateral part.
TEST(ObserverWarnings, NameAForceThatDoesNotDependOnTheParameter) {
  const std::vector<Diagnostic> found = warned(
      patched("amplitude_jnd",
              R"({"material": {"friction": 0}, "observer": {"magnitude_of": "lateral_force"}})"));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].pointer, "/blocks/comparisons/vary/parameter");
  EXPECT_THAT(found[0].message.english(),
              AllOf(HasSubstr("judges the variation of the lateral force, which does not change "
                              "with \"amplitude_m\": simulated responses are guesses."),
                    HasSubstr("\"magnitude_of\"")));
}

TEST(ObserverWarnings, NameAnEffectInTheOtherDirection) {
  const std::vector<Diagnostic> longer =
      warned(patched("spacing_jnd", R"({"observer": {"effect": null}})"));
  ASSERT_THAT(longer, SizeIs(1));
  EXPECT_THAT(longer[0].message.english(), AllOf(HasSubstr("which decreases by a factor of "),
                                                 HasSubstr("State \"effect\": \"decreases\"")));
  const std::vector<Diagnostic> higher =
      warned(patched("amplitude_jnd", R"({"observer": {"effect": "decreases"}})"));
  ASSERT_THAT(higher, SizeIs(1));
  EXPECT_THAT(higher[0].message.english(), HasSubstr("State \"effect\": \"increases\""));
}

// With forces along the normal of the plane the lateral force stems from friction alone. It is proportional to the normal
// force, so that its variation relative to the mean follows the amplitude; friction of 0.2 leaves a fifth of it.
TEST(ObserverWarnings, NameAnEffectThatIsTooWeakForTheNoiseOfTheObserver) {
  const std::vector<Diagnostic> found =
      warned(patched("amplitude_jnd", R"({"observer": {"feature_noise": 1}})"));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].pointer, "/blocks/comparisons/vary/parameter");
  EXPECT_THAT(
      found[0].message.english(),
      AllOf(HasSubstr("within the levels of \"amplitude_m\": with a \"feature_noise\" of 1 "
                      "and a \"lapse\" of 0.02 it distinguishes no level from the standard in "
                      "more than "),
            HasSubstr("and a threshold requires 79 %")));
}

TEST(ObserverWarnings, AreNoneForAnObserverThatIgnoresTheSurfaces) {
  EXPECT_THAT(warned(patched("spacing_jnd", R"({"observer": {"effect": null, "deaf": true}})")),
              IsEmpty());
}

TEST(StimulusWarnings, DoNotNeedAStudyForStimuliWithoutFiles) {
  const ModelRegistry models = built_in_models();
  StimulusBuilder without_files(models, {});
  const Protocol narrow = patched("spacing_jnd", R"({"surface": {"extent_m": [0.04, 0.1]}})");
  const std::vector<Diagnostic> found = warnings_about_stimuli({narrow, "p.json"}, without_files);
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(found[0].message.english(), HasSubstr("the patches are 17 mm wide"));
  EXPECT_THAT(warnings_about_stimuli({patched("photo_matching", "{}"), "p.json"}, without_files),
              IsEmpty());
}

// A criterion outside of the magnitudes of the surfaces gives the same response to all of them.
TEST(ObserverWarnings, NameACriterionThatSeparatesNoSurfaces) {
  const auto of_criterion = [](const std::string& criterion) {
    const std::string block =
        R"({"design": "yes_no", "positions": null, "until": null, "question": {"options":
           [{"value": "yes", "text": "Yes"}, {"value": "no", "text": "No"}]}})";
    return warned(
        patched("amplitude_same_different",
                (R"({"observer": {"different_above": null, "yes_above": )" + criterion +
                 R"(}, "blocks": {"practice": )" + block + R"(, "comparisons": )" + block + "}}")
                    .c_str()));
  };
  const std::vector<Diagnostic> found = of_criterion("2");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].pointer, "/observer/yes_above");
  EXPECT_THAT(found[0].message.english(),
              AllOf(HasSubstr("judges the variation of the normal force, which is 0."),
                    HasSubstr("nearly all simulated responses are the same")));
  EXPECT_THAT(of_criterion("0.024"), IsEmpty());
}

}  // namespace
}  // namespace asperity
