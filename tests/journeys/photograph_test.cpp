// asperity texture with a photograph and with the maps of a material scan: methods, recommendation, warnings.

#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A synthetic photograph of a stone of 50 mm, as `asperity synth` writes it.
fs::path photograph_in(const TemporaryFolder& place, const std::string& photograph_case) {
  const fs::path photograph = place / (photograph_case + ".png");
  const Outcome outcome =
      asperity({"synth", "stone", "--width-m", "0.05", "--pixels", "256", "--out",
                place / "truth.png", "--force", "--photo", photograph_case, photograph});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return photograph;
}

TEST(PhotographTexture, IsMadeByTheMethodThatItRecommends) {
  const TemporaryFolder place{};
  const fs::path photograph = photograph_in(place, "lambert");
  std::vector<std::string> arguments{"texture",   photograph, "--out",  place / "made.png",
                                     "--width-m", "0.05",     "--force"};
  const Outcome asked = asperity(arguments);
  ASSERT_EQ(asked.status, 0) << asked.err;
  EXPECT_THAT(asked.out, testing::AllOf(HasSubstr("Did the light come from one lamp at the side?"),
                                        HasSubstr("--method pentland --light-azimuth-deg A")));
  std::istringstream lines(asked.out);
  std::string line{};
  std::getline(lines, line);  // of the file, which has a long path here
  while (std::getline(lines, line))
    EXPECT_LE(line.size(), 104U) << line;  // 100 and signs of several bytes
  // A method that uses the light answers the question.
  arguments.insert(arguments.end(), {"--method", "pentland", "--light-azimuth-deg", "0"});
  const Outcome outcome = asperity(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, Not(HasSubstr("one lamp")));
  const auto parameters = nlohmann::json::parse(text_of((place / "made.png").string() + ".json"))
                              .at("provenance")
                              .at("parameters");
  EXPECT_EQ(parameters.at("method"), "pentland");
  EXPECT_EQ(parameters.at("light_azimuth_deg"), 0.0);
  EXPECT_EQ(parameters.at("light_elevation_deg"), 45.0);
}

TEST(PhotographTexture, OfThePublishedMethodHasTheSidecarOfEarlierVersions) {
  const TemporaryFolder place{};
  const fs::path photograph = photograph_in(place, "bright_height");
  const Outcome outcome =
      asperity({"texture", photograph, "--out", place / "made.png", "--width-m", "0.05"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("--method brightness --spectral-tilt 0.5"));
  const auto parameters = nlohmann::json::parse(text_of((place / "made.png").string() + ".json"))
                              .at("provenance")
                              .at("parameters");
  EXPECT_EQ(parameters.size(), 9U);
  EXPECT_FALSE(parameters.contains("method"));
}

TEST(PhotographTexture, NeedsADirectionOfObliqueLightForShapeFromShading) {
  const TemporaryFolder place{};
  std::vector<std::string> arguments{"texture",   photograph_in(place, "lambert"),
                                     "--out",     place / "made.png",
                                     "--width-m", "0.05",
                                     "--method",  "tsai_shah"};
  const Outcome without = asperity(arguments);
  EXPECT_EQ(without.status, 2);
  EXPECT_THAT(without.err, HasSubstr("--light-azimuth-deg is missing"));
  arguments.insert(arguments.end(), {"--light-azimuth-deg", "0", "--light-elevation-deg", "80"});
  const Outcome vertical = asperity(arguments);
  EXPECT_EQ(vertical.status, 1);
  EXPECT_THAT(vertical.err, HasSubstr("light_elevation_deg is 80"));
  arguments[7] = "wu";
  const Outcome unused = asperity(arguments);
  EXPECT_EQ(unused.status, 2);
  EXPECT_THAT(unused.err, HasSubstr("the method wu does not use the light"));
  EXPECT_FALSE(fs::exists(place / "made.png"));
}

// Cones are narrow bright parts on a dark plane.
TEST(PhotographTexture, WarnsOfASignThatThePictureContradictsAndGoesOn) {
  const TemporaryFolder place{};
  const fs::path photograph = place / "cones.png";
  ASSERT_EQ(asperity({"synth", "cones", "--width-m", "0.05", "--pixels", "256", "--out",
                      place / "truth.png", "--photo", "bright_height", photograph})
                .status,
            0);
  std::vector<std::string> arguments{"texture",   photograph, "--out",  place / "made.png",
                                     "--width-m", "0.05",     "--force"};
  const Outcome warned = asperity(arguments);
  EXPECT_EQ(warned.status, 0);
  EXPECT_THAT(warned.err, testing::AllOf(HasSubstr("warning: "), HasSubstr("cones.png: sign 1"),
                                         HasSubstr("use --sign -1")));
  EXPECT_TRUE(fs::exists(place / "made.png"));
  arguments.insert(arguments.end(), {"--sign", "-1"});
  EXPECT_THAT(asperity(arguments).err, Not(HasSubstr("warning")));
}

// Any two pictures of the same size: maps that do not agree are fused with a warning.
TEST(MaterialScan, IsFusedFromAHeightAndANormalMap) {
  const TemporaryFolder place{};
  const fs::path heights = photograph_in(place, "bright_height");
  const fs::path normals = photograph_in(place, "albedo");
  std::vector<std::string> arguments{"texture",   heights, "--out",     place / "made.png",
                                     "--normals", normals, "--width-m", "0.05"};
  EXPECT_THAT(asperity(arguments).err, HasSubstr("--height-range-m is missing"));
  arguments.insert(arguments.end(), {"--height-range-m", "0.001"});
  EXPECT_THAT(asperity(arguments).err, HasSubstr("--normals-convention is missing"));
  arguments.insert(arguments.end(),
                   {"--normals-convention", "opengl", "--crossover-wavelength-m", "0.004"});
  const Outcome outcome = asperity(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Around the crossover of 4 mm: correlation of the two maps "));
  EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("the maps do not agree"),
                                          HasSubstr("times those of the displacement map")));
  const auto provenance =
      nlohmann::json::parse(text_of((place / "made.png").string() + ".json")).at("provenance");
  EXPECT_EQ(provenance.at("kind"), "material_scan");
  EXPECT_EQ(provenance.at("source_name"), "bright_height.png");
  const auto& parameters = provenance.at("parameters");
  EXPECT_EQ(parameters.at("normals_convention"), "opengl");
  EXPECT_EQ(parameters.at("normals_name"), "albedo.png");
  EXPECT_EQ(parameters.at("normals_sha256").get<std::string>().size(), 64U);
  EXPECT_EQ(parameters.at("crossover_wavelength_m"), 0.004);
}

TEST(MaterialScan, RefusesTheOptionsOfPhotographs) {
  const TemporaryFolder place{};
  const fs::path heights = photograph_in(place, "bright_height");
  const Outcome refused = asperity({"texture", heights, "--out", place / "made.png", "--normals",
                                    heights, "--width-m", "0.05", "--sign", "-1"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--sign: --normals is given"));
  const Outcome alone = asperity({"texture", heights, "--out", place / "made.png", "--width-m",
                                  "0.05", "--height-range-m", "0.001"});
  EXPECT_EQ(alone.status, 2);
  EXPECT_THAT(alone.err, HasSubstr("--height-range-m: --normals is missing"));
}

}  // namespace
}  // namespace asperity::test
