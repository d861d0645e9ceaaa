// Warnings about models whose tick takes longer than a period of the servo loop.

#include "app/tasks/warnings/rate_warnings.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/tasks/protocol_files.h"
#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"

namespace asperity {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

/// The small protocol with this model in place of one of its two, at this rate.
std::string protocol_of_model(std::string_view model, const std::string& rate_Hz) {
  std::string text = small_protocol();
  constexpr std::string_view kReplaced = "stochastic";
  for (auto at = text.find(kReplaced); at != std::string::npos;
       at = text.find(kReplaced, at + model.size())) {
    text.replace(at, kReplaced.size(), model);
  }
  return text.replace(text.find("\"textures\""), 0, R"("device": {"rate_Hz": )" + rate_Hz + "}, ");
}

std::vector<Diagnostic> warnings(std::string_view model, const std::string& rate_Hz) {
  const ModelRegistry models = built_in_models();
  return warnings_about_rate(
      {read_small_protocol(models, protocol_of_model(model, rate_Hz)), "p.json"}, models);
}

// The page of the model: 1 kHz, on a plane and on a body.
TEST(RateWarnings, NameAnElasticHalfspaceAboveOneKilohertz) {
  const std::vector<Diagnostic> found = warnings("elastic_halfspace", "1001");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].pointer, "/device/rate_Hz");
  EXPECT_THAT(found[0].message,
              AllOf(HasSubstr("a tick of the force model elastic_halfspace of the stimulus "
                              "\"rendered\" can take longer than a period of the servo loop at "
                              "1001 Hz"),
                    HasSubstr("set rate_Hz to at most 1000")));
}

TEST(RateWarnings, AreNoneAtOneKilohertzAndForOtherModels) {
  EXPECT_THAT(warnings("elastic_halfspace", "1000"), IsEmpty());
  EXPECT_THAT(warnings("winkler", "4000"), IsEmpty());
  EXPECT_THAT(warnings("stochastic", "4000"), IsEmpty());
}

// These are also the warnings of the checklist before a session (protocol_warnings_check).
TEST(RateWarnings, AreAmongThoseOfACheck) {
  const auto warnings_at = [](const std::string& rate_Hz) {
    return check_protocol_text(protocol_of_model("elastic_halfspace", rate_Hz), "p.json",
                               built_in_models(), std::nullopt, std::nullopt)
        .warnings;
  };
  const auto about_rate =
      Contains(Field(&Diagnostic::message, HasSubstr("set rate_Hz to at most")));
  EXPECT_THAT(warnings_at("2000"), about_rate);
  EXPECT_THAT(warnings_at("1000"), Not(about_rate));
}

}  // namespace
}  // namespace asperity
