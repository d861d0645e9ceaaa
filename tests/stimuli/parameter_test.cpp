// Values against their declarations: what is accepted, completed and refused, and in which words.

#include "stimuli/properties/parameter.h"

#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include "stimuli/properties/other_unit.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

const Parameter kSpacing{.name = "spacing_m",
                         .unit = "m",
                         .minimum = 1e-4,
                         .maximum = 0.05,
                         .default_value = 0.002,
                         .meaning = "distance between ridges"};
const Parameter kOrder{.name = "order",
                       .kind = ParameterKind::integer,
                       .unit = "1",
                       .minimum = 1.0,
                       .maximum = 9.0,
                       .default_value = 3.0};
const Parameter kLaw{.name = "law",
                     .kind = ParameterKind::choice,
                     .choices = {"literal", "corrected"},
                     .default_value = std::string("corrected")};

const ModelDeclaration kModel{.id = "ridges", .parameters = {kSpacing, kOrder, kLaw}};

std::string values_refusal(const ParameterValues& given) {
  return refusal_of<std::invalid_argument>([&] { complete_values(kModel, given); });
}

TEST(Parameter, AcceptsBothEndsOfItsRange) {
  EXPECT_FALSE(complaint_about(kSpacing, 1e-4));
  EXPECT_FALSE(complaint_about(kSpacing, 0.05));
}

TEST(Parameter, RefusesANumberOutsideItsRangeWithTheRange) {
  EXPECT_EQ(complaint_about(kSpacing, 0.06),
            "spacing_m is 0.06 m; it must be a number from 1e-04 to 0.05 m.");
  EXPECT_EQ(problem_of_value(kSpacing, 0.06),
            "spacing_m is 0.06 m; it must be a number from 1e-04 to 0.05 m");
  EXPECT_TRUE(complaint_about(kSpacing, 0.9e-4));
}

TEST(Parameter, IsRefusedInTheLanguageOfAWindow) {
  const auto look_up = [](const char* context, const char* words) -> std::string {
    const std::string text = words;
    if (context == nullptr || context == std::string_view(kNumbersOfFile)) {
      return text == "0.06" ? "0,06" : text;
    }
    return text == "%1 is %2; it must be %3%4" ? "%1 = %2: %3%4" : text;
  };
  EXPECT_EQ(complaint_about(kSpacing, 0.06)->translated(look_up),
            "spacing_m = 0,06 m: a number from 1e-04 to 0.05 m.");
}

TEST(Parameter, StatesTheNumberThatAnotherUnitMeans) {
  EXPECT_EQ(complaint_about(kSpacing, 2.3),
            "spacing_m is 2.3 m; it must be a number from 1e-04 to 0.05 m; lengths are in metres: "
            "2.3 mm is 0.0023.");
  EXPECT_EQ(complaint_about(kSpacing, 500.0),
            "spacing_m is 500 m; it must be a number from 1e-04 to 0.05 m; lengths are in metres: "
            "500 µm is 0.0005.");
  EXPECT_EQ(complaint_about(kSpacing, -2.3),
            "spacing_m is -2.3 m; it must be a number from 1e-04 to 0.05 m.");
}

TEST(MeantInOtherUnit, ListsEveryUnitOfALargeNumberAndTheLikeliestOfASmallOne) {
  const auto up_to = [](double most) { return [most](double number) { return number <= most; }; };
  EXPECT_EQ(meant_in_other_unit(500.0, "m", up_to(1.0)),
            "; lengths are in metres: 500 mm is 0.5, and 500 µm is 0.0005");
  EXPECT_EQ(meant_in_other_unit(2.3, "m", up_to(1.0)), "; lengths are in metres: 2.3 mm is 0.0023");
  EXPECT_EQ(meant_in_other_unit(1500.0, "N", up_to(5.0)),
            "; forces are in newtons: 1500 mN is 1.5");
  EXPECT_EQ(meant_in_other_unit(6.0, "N", up_to(5.0)), "");
  EXPECT_EQ(meant_in_other_unit(90.0, "rad", up_to(6.3)), "; angles are in radians: 90° is 1.5708");
  EXPECT_EQ(meant_in_other_unit(1.0, "Hz", [](double number) { return number >= 100.0; }),
            "; frequencies are in hertz: 1 kHz is 1000");
  EXPECT_EQ(meant_in_other_unit(7.0, "1", up_to(1.0)), "");
}

TEST(Parameter, RefusesWhatIsNotANumber) {
  EXPECT_TRUE(complaint_about(kSpacing, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(complaint_about(kSpacing, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(complaint_about(kSpacing, std::string("wide")),
            "spacing_m is \"wide\"; it must be a number from 1e-04 to 0.05 m.");
}

TEST(Parameter, RefusesAFractionWhereAWholeNumberIsDeclared) {
  EXPECT_FALSE(complaint_about(kOrder, 4.0));
  EXPECT_EQ(complaint_about(kOrder, 4.5), "order is 4.5; it must be a whole number from 1 to 9.");
}

TEST(Parameter, RefusesAnUnknownChoiceWithTheChoices) {
  EXPECT_FALSE(complaint_about(kLaw, std::string("literal")));
  EXPECT_EQ(complaint_about(kLaw, std::string("liberal")),
            "law is \"liberal\"; it must be literal or corrected.");
  EXPECT_TRUE(complaint_about(kLaw, 1.0));
}

TEST(CompleteValues, FillsInTheDefaultsAndKeepsWhatIsGiven) {
  const ParameterValues values = complete_values(kModel, {{"spacing_m", 0.003}});
  EXPECT_EQ(values.size(), 3u);
  EXPECT_DOUBLE_EQ(number_of(values, "spacing_m"), 0.003);
  EXPECT_DOUBLE_EQ(number_of(values, "order"), 3.0);
  EXPECT_EQ(choice_of(values, "law"), "corrected");
}

TEST(CompleteValues, NamesTheModelAndTheParameterItRefuses) {
  EXPECT_EQ(values_refusal({{"spacng_m", 0.003}}),
            "ridges has no parameter \"spacng_m\"; use spacing_m, order or law.");
  EXPECT_THAT(values_refusal({{"spacing_m", 1.0}}), HasSubstr("ridges: spacing_m is 1 m"));
}

TEST(CompleteValues, RefusesAValueOfTheWrongKind) {
  EXPECT_THAT(values_refusal({{"law", 2.0}}), HasSubstr("literal or corrected"));
  EXPECT_THAT(values_refusal({{"order", std::string("3")}}), HasSubstr("whole number"));
}

TEST(ParameterValues, SayWhichValueIsMissing) {
  EXPECT_THROW(number_of({}, "spacing_m"), std::invalid_argument);
  EXPECT_THROW(number_of({{"law", std::string("literal")}}, "law"), std::invalid_argument);
  EXPECT_THROW(choice_of({{"order", 1.0}}, "order"), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
