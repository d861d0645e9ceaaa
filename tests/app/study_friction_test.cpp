// Which friction a study has where its protocols state none.

#include "app/session/study_friction.h"

#include <filesystem>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "app/session/stimulus_builder.h"
#include "renderers/built_in_models.h"
#include "tests/app/scripted_session.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

std::string law_in(StimulusBuilder& builder, const std::string& model,
                   const ParameterValues& parameters = {}) {
  const ParameterValues complete =
      builder.unmatched({.name = "one", .model = model, .parameters = parameters})
          .inputs.parameters;
  return complete.contains("friction_law") ? choice_of(complete, "friction_law") : "";
}

TEST(StudyFriction, IsThatOfNewStudiesWhereThereAreNoSessions) {
  const TemporaryFolder folder;
  const ModelRegistry models = built_in_models();
  make_small_study(folder.path() / "study");
  EXPECT_FALSE(session_with_earlier_friction(folder.path() / "study", models));
  EXPECT_EQ(unstated_friction_of({}, models), UnstatedFriction::of_new_studies);
  StimulusBuilder builder(models, folder.path() / "study");
  EXPECT_EQ(law_in(builder, "sinusoid"), "dahl");
  EXPECT_EQ(law_in(builder, "sinusoid", {{"friction_law", std::string("proxy")}}), "proxy");
  EXPECT_EQ(choice_of(builder.default_parameters(*models.find("stochastic")), "friction_law"),
            "dahl");
}

using FrictionOfSessions = SessionTest;

TEST_F(FrictionOfSessions, StaysInAStudyThatBeganWithTheLaws) {
  begin(small_protocol());
  run();
  const std::vector<AttemptRow> made = attempts();
  ASSERT_FALSE(made.empty());
  for (const PresentationRow& presentation : made.front().presentations) {
    EXPECT_NE(presentation.parameters_json.find(R"("friction_law":"dahl")"), std::string::npos)
        << presentation.parameters_json;
  }
  EXPECT_FALSE(session_with_earlier_friction(folder_.path() / "study", models_));
}

}  // namespace
}  // namespace asperity
