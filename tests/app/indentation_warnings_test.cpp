// Warnings about normal forces under which a soft surface is strained too much.

#include "app/tasks/warnings/indentation_warnings.h"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/tasks/warnings/stimulus_warnings.h"
#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

void exchange(std::string& text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
}

/// An elastic half-space and a bed of springs under this force.
std::string soft_surfaces(const std::string& elastic_parameters, const std::string& force_N) {
  std::string text =
      small_protocol("", R"(, "normal_force_N": {"target": )" + force_N + R"(, "maximum": 4})");
  exchange(text, R"("model": {"levels": ["height_map", "stochastic"]}, )", "");
  exchange(text, R"("rendered": {"model": {"factor": "model"}, "texture": "grain"})",
           R"("soft": {"model": "elastic_halfspace", "texture": "grain", "parameters": {)" +
               elastic_parameters + R"(}}, "springs": {"model": "winkler", "texture": "grain"})");
  exchange(text, R"({"stimulus": "rendered", "with": {"model": "height_map"}})",
           R"({"stimulus": "soft"})");
  exchange(text, R"({"stimulus": "rendered", "with": {"model": "stochastic"}})",
           R"({"stimulus": "springs"})");
  return text;
}

class IndentationWarnings : public ::testing::Test {
 protected:
  IndentationWarnings() { make_small_study(folder_ / "study"); }

  std::vector<Diagnostic> warnings(const std::string& elastic_parameters,
                                   const std::string& force_N) {
    StimulusBuilder builder(models_, folder_ / "study");
    return warnings_about_indentation(
        {read_small_protocol(models_, soft_surfaces(elastic_parameters, force_N)), "p.json"},
        builder);
  }

  const TemporaryFolder folder_{};
  const ModelRegistry models_ = built_in_models();
};

// A ball of 3 mm on 100 kPa reaches a/R = 0.3 under 43 mN, on 10 MPa under 4.3 N.
TEST_F(IndentationWarnings, NameAnElasticSurfaceThatIsStrainedTooMuch) {
  const std::vector<Diagnostic> found = warnings("", "1");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].pointer, "/stimuli/soft");
  EXPECT_THAT(found[0].message.english(),
              AllOf(HasSubstr("the stimulus \"soft_grain_elastic_halfspace\""),
                    HasSubstr("in the exploration \"short\": under 1 N the tip "
                              "sinks in by 2.19 mm, 0.85 times"),
                    HasSubstr("raise youngs_modulus_Pa or tip_radius_m")));
  EXPECT_THAT(warnings(R"("youngs_modulus_Pa": 1e7)", "1"), IsEmpty());
  EXPECT_THAT(warnings("", "0.04"), IsEmpty());
}

TEST_F(IndentationWarnings, AreAmongTheWarningsOfACheck) {
  StimulusBuilder builder(models_, folder_ / "study");
  const std::vector<Diagnostic> found = warnings_about_stimuli(
      {read_small_protocol(models_, soft_surfaces("", "1")), "p.json"}, builder);
  EXPECT_THAT(found, testing::Contains(testing::Field(
                         &Diagnostic::message,
                         testing::Property(&Phrase::english, HasSubstr("assumes small strains")))));
}

}  // namespace
}  // namespace asperity
