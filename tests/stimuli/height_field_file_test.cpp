// Two files there and back, and what is said about two that do not fit.

#include "stimuli/heights/height_field_file.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>

#include "stimuli/pictures/grey_image.h"
#include "stimuli/pictures/photograph.h"
#include "tests/support/refusal.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

HeightField relief() {
  std::vector<float> heights_m;
  for (int k = 0; k < 20 * 30; ++k) {
    heights_m.push_back(static_cast<float>(1e-4 * std::sin(0.7 * k * k) - 2.3e-5));
  }
  return {{.rows = 20, .columns = 30, .pitch_m = 0.1 / 3.0}, heights_m};
}

const HeightFieldProvenance kProvenance{.kind = "photograph",
                                        .parameters = {{"rms_m", 1e-4}, {"histogram", "none"}},
                                        .seed = {},
                                        .source_name = "wall.jpg",
                                        .source_sha256 = "ab12",
                                        .program_version = "0.2.0"};

std::string field_refusal(std::span<const std::byte> png, const std::string& sidecar) {
  return refusal_of<std::invalid_argument>([&] { decode_height_field(png, sidecar, "wall.png"); });
}

TEST(HeightFieldFile, MovesNoHeightByMoreThanHalfALevel) {
  const HeightField field = relief();
  const StoredHeightField back =
      decode_height_field(encode_height_field_png(field),
                          encode_height_field_sidecar(field, kProvenance, "cd34"), "wall.png");
  const double half_level_m = (field.maximum_m() - field.minimum_m()) / 131070.0;
  ASSERT_EQ(back.field.heights_m().size(), field.heights_m().size());
  for (std::size_t k = 0; k < field.heights_m().size(); ++k) {
    EXPECT_NEAR(back.field.heights_m()[k], field.heights_m()[k], 1.001 * half_level_m);
  }
  EXPECT_EQ(back.field.minimum_m(), field.minimum_m());
  EXPECT_EQ(back.field.maximum_m(), field.maximum_m());
  EXPECT_EQ(back.field.grid().pitch_m, field.grid().pitch_m);
  EXPECT_EQ(back.field.grid().columns, 30u);
}

TEST(HeightFieldFile, IsWrittenTheSameOnceItHasBeenRead) {
  const HeightField field = relief();
  const auto png = encode_height_field_png(field);
  const std::string sidecar = encode_height_field_sidecar(field, kProvenance, "cd34");
  const StoredHeightField back = decode_height_field(png, sidecar, "wall.png");
  EXPECT_EQ(encode_height_field_png(back.field), png);
  EXPECT_EQ(encode_height_field_sidecar(back.field, back.provenance, back.sha256), sidecar);
}

TEST(HeightFieldFile, KeepsWhereItCameFrom) {
  HeightFieldProvenance synthetic{
      .kind = "wood", .parameters = {{"spacing_m", 0.0025}}, .seed = 18446744073709551615U};
  const HeightField field = relief();
  const StoredHeightField back =
      decode_height_field(encode_height_field_png(field),
                          encode_height_field_sidecar(field, synthetic, "cd34"), "wood.png");
  EXPECT_EQ(back.provenance.kind, "wood");
  EXPECT_EQ(back.provenance.seed, 18446744073709551615U);
  EXPECT_EQ(back.provenance.parameters, synthetic.parameters);
  EXPECT_EQ(back.provenance.source_name, "");
  EXPECT_EQ(back.sha256, "cd34");
}

TEST(HeightFieldFile, IsASixteenBitGreyPngWithThePictureTheRightWayUp) {
  const HeightField field({.rows = 2, .columns = 2, .pitch_m = 1.0}, {1.0F, 0.5F, 0.25F, 0.0F});
  const Photograph picture = decode_photograph(encode_height_field_png(field), "four");
  EXPECT_EQ(picture.facts.bits_per_channel, 16);
  EXPECT_EQ(picture.facts.channels, 1);
  EXPECT_THAT(picture.grey.values,
              ::testing::ElementsAre(1.0F, 32768.0F / 65535.0F, 16384.0F / 65535.0F, 0.0F));
}

TEST(HeightFieldFile, KeepsAFieldOfOneHeight) {
  const HeightField flat({.rows = 3, .columns = 3, .pitch_m = 1e-3}, std::vector<float>(9, 2e-4F));
  const StoredHeightField back = decode_height_field(
      encode_height_field_png(flat), encode_height_field_sidecar(flat, kProvenance, ""), "flat");
  EXPECT_EQ(back.field.heights_m(), flat.heights_m());
}

TEST(HeightFieldFile, NamesTheSidecarAndWhatItLacks) {
  const HeightField field = relief();
  const auto png = encode_height_field_png(field);
  const std::string sidecar = encode_height_field_sidecar(field, kProvenance, "cd34");
  EXPECT_EQ(field_refusal(png, sidecar), "");
  EXPECT_EQ(field_refusal(png, "{"),
            "wall.png.json is not a JSON object in the format \"asperity.height_field/1\". Make "
            "the height field again.");
  EXPECT_THAT(field_refusal(png, replaced(sidecar, "height_field/1", "height_field/2")),
              HasSubstr("has the format \"asperity.height_field/2\""));
  for (const std::string key : {"pitch_m", "height_min_m", "height_max_m"}) {
    EXPECT_THAT(field_refusal(png, replaced(sidecar, "\"" + key + "\"", "\"other\"")),
                StartsWith("wall.png.json needs a number " + key));
  }
  EXPECT_THAT(field_refusal(png, replaced(sidecar, "\"format\"", "\"pitch_m\": 0.1, \"format\"")),
              HasSubstr("has the key \"pitch_m\" twice"));
  EXPECT_THAT(field_refusal(png, replaced(sidecar, "\"sha256\"", "\"md5\"")), HasSubstr("sha256"));
  EXPECT_THAT(field_refusal(png, replaced(sidecar, "0.03333", "-0.03333")),
              HasSubstr("not positive"));
  EXPECT_THAT(field_refusal(png, replaced(sidecar, "0.03333", "1e9993333")), HasSubstr("JSON"));
  EXPECT_THAT(
      field_refusal(png, replaced(sidecar, "height_min_m\": ", "height_min_m\": 0.5, \"x\": ")),
      HasSubstr("height_max_m below its height_min_m"));
  EXPECT_THAT(field_refusal(png, replaced(sidecar, "\"none\"", "[1]")), HasSubstr("histogram"));
}

TEST(HeightFieldFile, RefusesAPictureThatIsNotSixteenBitGrey) {
  const std::string sidecar = encode_height_field_sidecar(relief(), kProvenance, "");
  EXPECT_EQ(field_refusal(encode_png({2, 2, {0.0F, 0.1F, 0.2F, 0.3F}}), sidecar),
            "wall.png is not a 16-bit greyscale PNG, as a height field must be. Make the height "
            "field again.");
  std::vector<std::byte> png = encode_height_field_png(relief());
  png.resize(png.size() / 2);
  EXPECT_THAT(field_refusal(png, sidecar), StartsWith("wall.png is truncated"));
}

}  // namespace
}  // namespace asperity
