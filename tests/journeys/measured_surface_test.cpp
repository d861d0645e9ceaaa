// asperity texture with a measured surface: from the file of an instrument to the force of a model.

#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

/// A file of tests/stimuli/surfaces.
fs::path measured_file(const std::string& name) {
  return fs::path(ASPERITY_SOURCE_DIR) / "tests/stimuli/surfaces" / name;
}

TEST(MeasuredTexture, StoresTheMissingPointsAndThePlaneWithTheHeights) {
  const TemporaryFolder place{};
  const fs::path made = place / "made.png";
  const Outcome outcome = asperity({"texture", measured_file("by_gwyddion.gwy"), "--out", made});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("12 × 9 samples, pitch 40.0 µm"));
  EXPECT_THAT(outcome.out, HasSubstr("GWY, channel 0 (Topography): 3 of 108 points missing and "
                                     "filled (2.78 %); plane subtracted, slope"));
  const auto sidecar = nlohmann::json::parse(text_of(made.string() + ".json"));
  EXPECT_DOUBLE_EQ(sidecar.at("pitch_m").get<double>(), 40e-6);
  const auto& provenance = sidecar.at("provenance");
  EXPECT_EQ(provenance.at("kind"), "measured_surface");
  EXPECT_EQ(provenance.at("source_name"), "by_gwyddion.gwy");
  const auto& parameters = provenance.at("parameters");
  EXPECT_EQ(parameters.at("file_format"), "GWY");
  EXPECT_EQ(parameters.at("form"), "plane");
  EXPECT_EQ(parameters.at("channel"), "0 (Topography)");
  EXPECT_EQ(parameters.at("points"), 108);
  EXPECT_EQ(parameters.at("missing_points"), 3);
  EXPECT_DOUBLE_EQ(parameters.at("missing_proportion").get<double>(), 3.0 / 108.0);
  // The heights rise by 0.8 µm per column and fall by 0.5 µm per row, apart from the waves.
  EXPECT_NEAR(parameters.at("slope_x").get<double>(), 0.8 / 40, 0.03);
  EXPECT_GT(parameters.at("slope_y").get<double>(), 0.0);
}

TEST(MeasuredTexture, IsRenderedByAForceModel) {
  const TemporaryFolder place{};
  ASSERT_EQ(
      asperity({"texture", measured_file("by_gwyddion.sur"), "--out", place / "made.png"}).status,
      0);
  write_text(place / "path.tsv",
             "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t-0.0005\n0.001\t0.00002\t0\t-0.0005\n");
  const Outcome outcome =
      asperity({"render", "--model", "height_map", "--stimulus", place / "made.png", "--path",
                place / "path.tsv", "--out", place / "forces.tsv"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

struct TiffEntry {
  unsigned tag = 0;
  unsigned value = 0;
  unsigned type = 3;  ///< 2: letters, 3: a whole number
  unsigned count = 1;
};

std::string tiff_of(const std::vector<TiffEntry>& entries, const std::string& data) {
  std::string tiff = std::string("II*\0\x08\0\0\0", 8);
  const auto number = [&tiff](std::size_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) tiff += static_cast<char>(value >> (8 * i) & 0xFFU);
  };
  number(entries.size(), 2);
  for (const TiffEntry& entry : entries) {
    number(entry.tag, 2);
    number(entry.type, 2);
    number(entry.count, 4);
    number(entry.value, 4);
  }
  number(0, 4);
  return tiff + data;
}

// Two by two 16-bit numbers with a sign: no advice about the option of a file that no option makes readable.
TEST(MeasuredTexture, OfATiffThatIsNotReadIsRefusedOnceWithWhatToSave) {
  const TemporaryFolder place{};
  write_text(place / "scan.tif", tiff_of({{256, 2},
                                          {257, 2},
                                          {258, 16},
                                          {259, 1},
                                          {262, 1},
                                          {273, 8 + 2 + 12 * 10 + 4},
                                          {277, 1},
                                          {278, 2},
                                          {279, 8},
                                          {339, 2}},
                                         "abcdefgh"));
  const Outcome outcome = asperity({"texture", place / "scan.tif", "--width-m", "0.001",
                                    "--height-unit-m", "1e-6", "--out", place / "made.png"});
  EXPECT_NE(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("save a photograph with whole numbers of 8 or 16 bits without "
                                     "a sign, and measured heights with 32-bit"));
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("leave out")));
}

// GDAL's entry 42113, "0", in a picture of two by two bytes, which is too small as well.
TEST(MeasuredTexture, OfAPhotographHasNoMissingPointsAndAWarningOfThem) {
  const TemporaryFolder place{};
  write_text(place / "photo.tif", tiff_of({{256, 2},
                                           {257, 2},
                                           {258, 8},
                                           {259, 1},
                                           {262, 1},
                                           {273, 8 + 2 + 12 * 10 + 4},
                                           {277, 1},
                                           {278, 2},
                                           {279, 4},
                                           {42113, '0', 2, 2}},
                                          "abcd"));
  EXPECT_THAT(
      asperity({"texture", place / "photo.tif", "--width-m", "0.001", "--out", place / "made.png"})
          .err,
      HasSubstr("photo.tif: the file states 0 as the value of missing points, and a "
                "photograph has none: they are read as brightness\n"));
}

TEST(MeasuredTexture, OfATiffNeedsItsWidthAndTheUnitOfItsHeights) {
  const TemporaryFolder place{};
  std::vector<std::string> arguments{"texture", measured_file("by_tifffile.tif"), "--out",
                                     place / "made.png"};
  const Outcome refused = asperity(arguments);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("give --width-m and --height-unit-m"));
  arguments.insert(arguments.end(),
                   {"--width-m", "0.00048", "--height-unit-m", "1e-6", "--form", "mean"});
  const Outcome outcome = asperity(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr("3 of 108 points missing and filled (2.78 %); mean subtracted\n"));
}

TEST(MeasuredTexture, RefusesTheOptionsOfPhotographsAndTheOtherWayRound) {
  const TemporaryFolder place{};
  make_small_stimuli(place.path());
  const std::string surface = measured_file("by_gwyddion.sur");
  const std::string photograph = place / "slate_photo.png";
  const std::string made = place / "made.png";
  const Outcome of_surface = asperity({"texture", surface, "--out", made, "--rms-m", "1e-5"});
  EXPECT_EQ(of_surface.status, 2);
  EXPECT_THAT(of_surface.err,
              HasSubstr("--rms-m: " + surface + " is a measured surface; leave out this option"));
  const Outcome of_photograph =
      asperity({"texture", photograph, "--out", made, "--width-m", "0.02", "--form", "mean"});
  EXPECT_EQ(of_photograph.status, 2);
  EXPECT_THAT(of_photograph.err, HasSubstr("--form: " + photograph + " is not a measured surface"));
  const Outcome without_width = asperity({"texture", photograph, "--out", made});
  EXPECT_EQ(without_width.status, 2);
  EXPECT_THAT(without_width.err, HasSubstr("--width-m is missing"));
  EXPECT_FALSE(fs::exists(made));
}

TEST(MeasuredTexture, OfADamagedFileIsRefusedWithItsPlaceAndWithoutAFile) {
  const TemporaryFolder place{};
  write_text(place / "cut.sur", text_of(measured_file("by_gwyddion.sur")).substr(0, 700));
  const Outcome outcome = asperity({"texture", place / "cut.sur", "--out", place / "made.png"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("cut.sur: byte 512: the file ends 700 bytes after"));
  EXPECT_FALSE(fs::exists(place / "made.png"));
}

}  // namespace
}  // namespace asperity::test
