// Measured surfaces as files: four formats, the same heights in metres, and a refusal with a place for everything else.

#include "stimuli/measured/measured_surface.h"

#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>

#include "stimuli/measured/surface_decoding.h"
#include "stimuli/pictures/photograph.h"
#include "tests/stimuli/surface_file.h"
#include "tests/support/refusal.h"
#include "tests/support/replaced.h"

namespace asperity::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

using namespace std::string_literals;

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

std::span<const std::byte> bytes_in(const std::string& content) {
  return std::as_bytes(std::span(content));
}

/// 5 by 4 points; no two heights are equal, and one is missing. Multiples of 1 nm.
MeasuredSurface small_surface() {
  MeasuredSurface surface{.rows = 4, .columns = 5, .pitch_x_m = 2e-6, .pitch_y_m = 3e-6};
  for (int i = 0; i < 20; ++i) surface.heights_m.push_back(1e-9 * (137 * i - 1500));
  surface.heights_m[7] = kMissing;
  return surface;
}

MeasuredSurface decoded(const std::string& content, const SurfaceReading& reading = {}) {
  return decode_surface(bytes_in(content), reading, "scan");
}

std::string surface_refusal(const std::string& content, const SurfaceReading& reading = {}) {
  return refusal_of<std::invalid_argument>([&] { decoded(content, reading); });
}

void expect_small_surface(const MeasuredSurface& found, double tolerance_m,
                          double pitch_tolerance_m = 1e-18) {
  const MeasuredSurface expected = small_surface();
  ASSERT_EQ(found.rows, expected.rows);
  ASSERT_EQ(found.columns, expected.columns);
  EXPECT_NEAR(found.pitch_x_m, expected.pitch_x_m, pitch_tolerance_m);
  EXPECT_NEAR(found.pitch_y_m, expected.pitch_y_m, pitch_tolerance_m);
  for (std::size_t i = 0; i < expected.heights_m.size(); ++i) {
    EXPECT_EQ(std::isnan(found.heights_m[i]), i == 7) << i;
    if (i == 7) continue;
    EXPECT_NEAR(found.heights_m[i], expected.heights_m[i], tolerance_m) << i;
  }
}

/// An X3P file with another main.xml.
std::string x3p_with(const std::string& from, const std::string& to) {
  std::map<std::string, std::string> entries = x3p_entries_of(small_surface(), 'D');
  entries["main.xml"] = replaced(entries["main.xml"], from, to);
  return zip_of(entries);
}

TEST(MeasuredSurface, HasTheHeightsOfEveryTypeOfX3p) {
  const StoredLevels levels{.step_m = 1e-9, .offset_m = 2e-7};
  for (const char type : {'I', 'L', 'F', 'D'}) {
    SCOPED_TRACE(type);
    const std::string file = x3p_of(small_surface(), type, levels);
    EXPECT_EQ(surface_format_of(bytes_in(file), "scan"), SurfaceFormat::x3p);
    expect_small_surface(decoded(file), 1e-15);
  }
}

TEST(MeasuredSurface, IsReadFromX3pWithAFolderAByteOrderMarkAndPrefixes) {
  std::map<std::string, std::string> entries{};
  for (auto [path, content] : x3p_entries_of(small_surface(), 'L')) {
    if (path == "main.xml") {
      content = replaced(content, "<Record3>", "<p:Record3>");
      content = "\xEF\xBB\xBF" + replaced(content, "</Record3>", "</p:Record3>");
    }
    entries.emplace("surface/" + path, content);
  }
  expect_small_surface(decoded(zip_of(entries)), 1e-15);
}

TEST(MeasuredSurface, IsReadFromX3pWhoseRootElementHasNoPart) {
  std::map<std::string, std::string> entries = x3p_entries_of(small_surface(), 'L');
  std::string& main = entries.at("main.xml");
  main = replaced(replaced(main, "<p:ISO5436_2 ", "<ISO5436 "), "</p:ISO5436_2>", "</ISO5436>");
  expect_small_surface(decoded(zip_of(entries)), 1e-15);
}

TEST(MeasuredSurface, HasTheHeightsOfSurWithBothSizesPlainAndCompressed) {
  const StoredLevels levels{.step_m = 1e-9, .offset_m = 2e-7};
  for (const int bits : {16, 32}) {
    for (const bool is_compressed : {false, true}) {
      SCOPED_TRACE(bits);
      const std::string file = sur_of(small_surface(), bits, is_compressed, levels);
      EXPECT_EQ(surface_format_of(bytes_in(file), "scan"), SurfaceFormat::sur);
      // The header has 32-bit floating-point numbers.
      expect_small_surface(decoded(file), 1e-12, 1e-12);
    }
  }
}

TEST(MeasuredSurface, IsTheFirstChannelOfHeightsOfGwyOrTheOneThatIsAskedFor) {
  const std::string file = gwy_of(small_surface());
  const MeasuredSurface found = decoded(file);
  expect_small_surface(found, 0.0);
  EXPECT_EQ(found.channel, "2 (Height)");
  expect_small_surface(decoded(file, {.channel = 2}), 0.0);
  EXPECT_THAT(surface_refusal(file, {.channel = 0}),
              StartsWith("scan: byte 4: there is no channel 0 with heights in m; the channels are "
                         "0 in deg, 2 in m"));
}

TEST(MeasuredSurface, TakesSizeAndUnitOfATiffFromOutside) {
  MeasuredSurface expected = small_surface();
  const std::string file = float_tiff_of(expected, 1e-6);
  EXPECT_EQ(surface_format_of(bytes_in(file), "scan"), SurfaceFormat::tiff);
  MeasuredSurface found = decoded(file, {.width_m = 1e-5, .height_unit_m = 1e-6});
  EXPECT_NEAR(found.pitch_y_m, 2e-6, 1e-18);  // the same along both axes
  found.pitch_y_m = expected.pitch_y_m;
  expect_small_surface(found, 1e-12);
  EXPECT_THAT(surface_refusal(file), StartsWith("scan: a TIFF states neither the size of the "
                                                "surface nor the unit of its heights; give "
                                                "--width-m and --height-unit-m"));
  EXPECT_THAT(surface_refusal(file, {.width_m = 1e-5, .height_unit_m = 0.0}),
              HasSubstr("--height-unit-m in metres"));
  EXPECT_THAT(surface_refusal(file, {.width_m = -1.0, .height_unit_m = 1e-6}),
              HasSubstr("--width-m in metres"));
}

// GDAL and the programs that use it write the number of a missing point as the text of the entry 42113.
TEST(MeasuredSurface, HasNoPointsWhereATiffHasItsNoDataValue) {
  const SurfaceReading reading{.width_m = 1e-5, .height_unit_m = 1e-6};
  MeasuredSurface stored = small_surface();
  stored.heights_m[1] = -9999e-6;
  EXPECT_FALSE(std::isnan(decoded(float_tiff_of(stored, 1e-6), reading).heights_m[1]));
  const MeasuredSurface found = decoded(float_tiff_of(stored, 1e-6, "-9999.0 "), reading);
  EXPECT_TRUE(std::isnan(found.heights_m[1]));
  EXPECT_NEAR(found.heights_m[0], stored.heights_m[0], 1e-12);
  EXPECT_THAT(surface_refusal(float_tiff_of(stored, 1e-6, "lowest"), reading),
              HasSubstr("\"lowest\" as the value of missing points, which is not a number"));
}

TEST(MeasuredSurface, OfATiffKnowsThatThereAreFurtherPages) {
  const SurfaceReading reading{.width_m = 1e-5, .height_unit_m = 1e-6};
  std::string file = float_tiff_of(small_surface(), 1e-6);
  EXPECT_FALSE(decoded(file, reading).has_further_pages);
  // The directory of ten entries at byte 8 ends with the offset of the next one: here the same again.
  file.replace(8 + 2 + 12 * 10, 4, little_endian(8, 4));
  EXPECT_TRUE(decoded(file, reading).has_further_pages);
}

TEST(MeasuredSurface, IsRefusedWhereItsFileContradictsItself) {
  EXPECT_THAT(
      surface_refusal(x3p_with("</SizeX>", "</SizeX>\n<SizeX>5</SizeX>")),
      AllOf(StartsWith("scan: main.xml:"), HasSubstr("MatrixDimension has a second SizeX")));
  EXPECT_THAT(surface_refusal(x3p_with("<Record3>", "<Record1><Axes/></Record1><Record3>")),
              HasSubstr("has a second Record1"));
  const std::map<std::string, std::string> entries = x3p_entries_of(small_surface(), 'D');
  // The names of an archive are written once before their content and once in its directory.
  std::map<std::string, std::string> two = entries;
  two["Main.xml"] = entries.at("main.xml");
  const std::string renamed = replaced(zip_of(two), "Main.xml", "main.xml");
  EXPECT_THAT(surface_refusal(replaced(renamed, "Main.xml", "main.xml")),
              HasSubstr("has the entry main.xml twice"));
  std::map<std::string, std::string> folders{};
  for (const auto& [path, content] : entries) {
    folders["a/" + path] = content;
    folders["b/" + path] = content;
  }
  EXPECT_THAT(surface_refusal(zip_of(folders)), HasSubstr("a main.xml in a/ and in b/"));
  const std::string heights =
      gwy_component("/0/data", 'o', gwy_field(small_surface(), small_surface().heights_m, "m"));
  EXPECT_THAT(surface_refusal("GWYP" + gwy_object("GwyContainer", heights + heights)),
              HasSubstr("the component \"/0/data\" occurs twice"));
}

// Decoders turn such a picture, and the texture would be felt across instead of along.
TEST(MeasuredSurface, IsRefusedAsATiffThatIsToBeTurnedOrContradictsItself) {
  const SurfaceReading reading{.width_m = 1e-5, .height_unit_m = 1e-6};
  const auto entry = [](std::uint64_t tag, std::uint64_t value) {
    return little_endian(tag, 2) + little_endian(3, 2) + little_endian(1, 4) +
           little_endian(value, 4);
  };
  const std::string upright = float_tiff_of(small_surface(), 1e-6);
  for (const std::uint64_t orientation : {3U, 6U}) {
    EXPECT_THAT(surface_refusal(replaced(upright, entry(262, 1), entry(274, orientation)), reading),
                HasSubstr("turned or mirrored when it is shown (orientation " +
                          std::to_string(orientation) + ")"));
  }
  EXPECT_THAT(surface_refusal(replaced(upright, entry(262, 1), entry(277, 2)), reading),
              HasSubstr("states the entry 277 of its directory twice"));
}

TEST(MeasuredSurface, OfWholeNumbersWithASignIsRefusedWithWhatToSave) {
  const auto entry = [](std::uint64_t tag, std::uint64_t value) {
    return little_endian(tag, 2) + little_endian(3, 2) + little_endian(1, 4) +
           little_endian(value, 4);
  };
  const std::string file =
      replaced(replaced(float_tiff_of(small_surface(), 1e-6), entry(258, 32), entry(258, 16)),
               entry(339, 3), entry(339, 2));
  EXPECT_FALSE(surface_format_of(bytes_in(file), "scan"));
  EXPECT_EQ(refusal_of<std::invalid_argument>([&] { inspect_picture(bytes_in(file), "scan"); }),
            "scan is a TIFF with 16-bit whole numbers with a sign; save a photograph with whole "
            "numbers of 8 or 16 bits without a sign, and measured heights with 32-bit "
            "floating-point numbers.");
}

TEST(MeasuredSurface, IsRefusedWithoutRelief) {
  EXPECT_THAT(surface_refusal(x3p_with("<Increment>1e-09</Increment>", "<Increment>0</Increment>")),
              HasSubstr("the increment of the heights is 0"));
  MeasuredSurface flat = small_surface();
  for (double& height_m : flat.heights_m) {
    if (!std::isnan(height_m)) height_m = 2e-6;
  }
  EXPECT_THAT(surface_refusal(x3p_of(flat)), HasSubstr("every height is"));
  EXPECT_THAT(surface_refusal(float_tiff_of(flat, 1e-6), {.width_m = 1e-5, .height_unit_m = 1e-6}),
              HasSubstr("there is no relief to feel"));
}

TEST(MeasuredSurface, RefusesWhatItsFormatStatesItself) {
  EXPECT_THAT(surface_refusal(sur_of(small_surface()), {.width_m = 1.0}),
              HasSubstr("states its width; leave out --width-m"));
  EXPECT_THAT(surface_refusal(x3p_of(small_surface()), {.height_unit_m = 1.0}),
              HasSubstr("leave out --height-unit-m"));
  EXPECT_THAT(surface_refusal(x3p_of(small_surface()), {.channel = 1}),
              HasSubstr("leave out --channel"));
}

TEST(MeasuredSurface, IsNotEveryFile) {
  for (const std::string& other :
       {std::string(), std::string("PNG"), std::string("II"), std::string("a text")}) {
    EXPECT_EQ(surface_format_of(bytes_in(other), "scan"), std::nullopt);
    EXPECT_THAT(surface_refusal(other), StartsWith("scan is not a measured surface"));
  }
}

/// The content of a file in tests/stimuli/surfaces.
std::string stored_file(const std::string& name) {
  std::ifstream file(std::string(ASPERITY_SOURCE_DIR) + "/tests/stimuli/surfaces/" + name,
                     std::ios::binary);
  std::ostringstream content{};
  content << file.rdbuf();
  return content.str();
}

/// The heights of tests/stimuli/surfaces/README.md.
void expect_the_stored_surface(const MeasuredSurface& found, bool has_missing, double tolerance_m) {
  ASSERT_EQ(found.columns, 12U);
  ASSERT_EQ(found.rows, 9U);
  EXPECT_NEAR(found.pitch_x_m, 40e-6, 1e-12);
  EXPECT_NEAR(found.pitch_y_m, 40e-6, 1e-12);
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 12; ++j) {
      const double height_m = found.heights_m[static_cast<std::size_t>(12 * i + j)];
      const bool is_missing = has_missing && ((i == 0 && j == 0) || (i == 3 && (j == 4 || j == 5)));
      EXPECT_EQ(std::isnan(height_m), is_missing) << i << ' ' << j;
      if (is_missing) continue;
      EXPECT_NEAR(height_m,
                  1e-6 * (10 * std::sin(0.7 * j) + 7 * std::cos(0.9 * i) + 0.8 * j - 0.5 * i),
                  tolerance_m)
          << i << ' ' << j;
    }
  }
}

TEST(MeasuredSurface, OfGwyddionHasTheHeightsThatItWrote) {
  expect_the_stored_surface(decoded(stored_file("by_gwyddion.gwy")), true, 0.0);
  // Gwyddion rounds down to 2^-30 of the range, and stores the step and the offset as 32-bit numbers.
  expect_the_stored_surface(decoded(stored_file("by_gwyddion.sur")), false, 5e-12);
}

TEST(MeasuredSurface, OfTifffileHasTheHeightsThatItWrote) {
  expect_the_stored_surface(
      decoded(stored_file("by_tifffile.tif"), {.width_m = 480e-6, .height_unit_m = 1e-6}), true,
      2e-12);
}

TEST(MeasuredSurface, OfX3ptoolsHasTheHeightsThatItWrote) {
  // Its distances of 1 m are refused, so that the decoder is called.
  const std::string file = stored_file("by_x3ptools.x3p");
  const MeasuredSurface found = decode_x3p(bytes_in(file), "scan");
  EXPECT_EQ(found.heights_m, (std::vector<double>{2, 2, 2, 2, 2, 2, 6, 6, 6, 2, 2, 6, 10,
                                                  6, 2, 2, 6, 6, 6, 2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(found.pitch_x_m, 1.0);
  EXPECT_THAT(surface_refusal(file),
              StartsWith("scan: the distance between points along x is 1 m; from 1e-09 to 0.001"));
}

TEST(MeasuredSurface, WithTooManyPointsIsRefusedBeforeMemoryIsAllocated) {
  const std::string problem =
      "the surface has 1000000000 by 1000000000 points; from 2 to 16384 per side and at most "
      "67108864 in total are possible";
  const std::string many = little_endian(1000000000, 4);
  EXPECT_THAT(
      surface_refusal(zip_of(
          {{"main.xml", replaced(replaced(x3p_entries_of(small_surface(), 'D').at("main.xml"),
                                          "<SizeX>5", "<SizeX>1000000000"),
                                 "<SizeY>4", "<SizeY>1000000000")}})),
      AllOf(StartsWith("scan: main.xml:8: "), HasSubstr(problem)));
  for (const bool is_compressed : {false, true}) {
    std::string sur = sur_of(small_surface(), 16, is_compressed);
    sur.replace(108, 8, many + many);
    EXPECT_THAT(surface_refusal(sur), StartsWith("scan: byte 108: " + problem));
  }
  std::string gwy = gwy_of(small_surface());
  const std::size_t heights = gwy.find("/2/data\0o"s);
  const std::size_t columns = gwy.find("xres"s + '\0' + 'i', heights) + 6;
  gwy.replace(columns, 4, many);
  gwy.replace(gwy.find("yres"s + '\0' + 'i', heights) + 6, 4, many);
  EXPECT_THAT(surface_refusal(gwy),
              StartsWith("scan: byte " + std::to_string(columns) + ": " + problem));
  std::string tiff = float_tiff_of(small_surface(), 1e-6);
  tiff.replace(18, 4, many);
  EXPECT_THAT(surface_refusal(tiff, {.width_m = 1e-5, .height_unit_m = 1e-6}),
              StartsWith("scan is 1000000000 by 4 pixels"));
  // Within the bounds, but more than the file can contain.
  const std::string side = little_endian(8192, 4);
  std::string sur = sur_of(small_surface(), 16, true);
  sur.replace(108, 8, side + side);
  EXPECT_THAT(surface_refusal(sur), HasSubstr("too short for its number of points"));
}

TEST(MeasuredSurface, ThatIsTruncatedIsRefusedAtEveryLength) {
  const SurfaceReading tiff_reading{.width_m = 1e-5, .height_unit_m = 1e-6};
  const std::vector<std::pair<std::string, SurfaceReading>> files{
      {x3p_of(small_surface(), 'L'), {}},
      {sur_of(small_surface(), 16), {}},
      {sur_of(small_surface(), 32, true), {}},
      {gwy_of(small_surface()), {}},
      {float_tiff_of(small_surface(), 1e-6), tiff_reading}};
  for (const auto& [file, reading] : files) {
    for (std::size_t length = 0; length < file.size(); ++length) {
      EXPECT_THAT(surface_refusal(file.substr(0, length), reading), StartsWith("scan")) << length;
    }
  }
}

TEST(MeasuredSurface, OfADamagedX3pIsRefusedWithItsPlace) {
  EXPECT_THAT(
      surface_refusal(x3p_with("SUR", "PCL")),
      StartsWith("scan: main.xml:3: the element FeatureType has \"PCL\", and only \"SUR\""));
  EXPECT_THAT(surface_refusal(x3p_with("<SizeZ>1", "<SizeZ>2")), HasSubstr("several layers"));
  EXPECT_THAT(surface_refusal(x3p_with("<SizeX>5", "<SizeX>5.5")),
              AllOf(StartsWith("scan: main.xml:8: "), HasSubstr("not a number of points")));
  EXPECT_THAT(surface_refusal(x3p_with("<SizeX>5", "<SizeX>6")),
              HasSubstr("bindata/data.bin has 160 bytes, and the points of the surface take 192"));
  EXPECT_THAT(surface_refusal(x3p_with("data.bin", "gone.bin")),
              AllOf(StartsWith("scan: main.xml:9: "), HasSubstr("no entry \"bindata/gone.bin\"")));
  EXPECT_THAT(surface_refusal(x3p_with("<Increment>2", "<Increment>two")),
              AllOf(StartsWith("scan: main.xml:4: "), HasSubstr("not a finite number")));
  EXPECT_THAT(surface_refusal(x3p_with("<Axes>", "<Axis>")), HasSubstr("closed as Axes"));
  EXPECT_THAT(surface_refusal(x3p_with("DataLink>", "DataList>")), HasSubstr("closed as DataLink"));
  EXPECT_THAT(surface_refusal(zip_of({{"other.xml", "<a/>"}})),
              StartsWith("scan is a zip archive without main.xml"));
  EXPECT_THAT(surface_refusal(zip_of({{"main.xml", "<svg/>"}})),
              StartsWith("scan: main.xml:1: the root element is svg"));
  EXPECT_THAT(surface_refusal("PK\x03\x04 and no more"),
              testing::StrEq("scan: the directory of the zip archive cannot be read: the file is "
                             "incomplete or damaged; copy or export it again"));
  std::map<std::string, std::string> list = x3p_entries_of(small_surface(), 'D');
  list["main.xml"] = replaced(list["main.xml"], "<DataLink>", "<DataList/><DataLink>");
  EXPECT_THAT(surface_refusal(zip_of(list)), HasSubstr("export them as a binary matrix"));
}

TEST(MeasuredSurface, OfADamagedSurIsRefusedWithItsPlace) {
  const auto refusal_with = [](std::size_t at, const std::string& bytes,
                               bool is_compressed = false) {
    std::string file = sur_of(small_surface(), 16, is_compressed);
    file.replace(at, bytes.size(), bytes);
    return surface_refusal(file);
  };
  EXPECT_THAT(refusal_with(12, "\1"), StartsWith("scan: byte 12: the byte order"));
  EXPECT_THAT(refusal_with(18, "\12"), StartsWith("scan: byte 18: the object has the type 10"));
  EXPECT_THAT(refusal_with(98, "\10"), StartsWith("scan: byte 98: the points have 8 bits"));
  EXPECT_THAT(refusal_with(180, "kg"), StartsWith("scan: byte 180: the unit is \"kg\""));
  EXPECT_THAT(refusal_with(290, "\1"), StartsWith("scan: byte 290: the heights are marked"));
  EXPECT_THAT(refusal_with(128, little_endian(0, 4)), StartsWith("scan: byte 128: "));
  EXPECT_THAT(refusal_with(112, "\x50"), StartsWith("scan: byte 524: the file ends"));
  EXPECT_THAT(refusal_with(524, little_endian(4000000000, 4), true),
              StartsWith("scan: byte 524: the table of compressed parts has 4000000000 rows"));
  EXPECT_THAT(refusal_with(528, little_endian(41, 4), true),
              StartsWith("scan: byte 528: the compressed parts contain more"));
  EXPECT_THAT(refusal_with(544, "\0\0"s, true), HasSubstr("points are damaged"));
}

TEST(MeasuredSurface, OfADamagedGwyIsRefusedWithItsPlace) {
  const std::string good = gwy_of(small_surface());
  EXPECT_THAT(surface_refusal(replaced(good, "GwyContainer", "GwyBrick0123")),
              StartsWith("scan: byte 4: the file has a GwyBrick0123"));
  EXPECT_THAT(surface_refusal(replaced(good, "visible\0b"s, "visible\0x"s)),
              HasSubstr("the component \"/2/data/visible\" has an unknown type"));
  // The heights are the last field of the file.
  std::string without_size = good;
  without_size.replace(good.rfind("xres"), 4, "rows");
  EXPECT_THAT(surface_refusal(without_size), HasSubstr("the GwyDataField has no component xres"));
  std::string fewer = good;
  fewer[good.rfind("yres") + 6] = 3;
  EXPECT_THAT(surface_refusal(fewer), HasSubstr("there are 20 heights for 5 by 3 points"));
  std::string masked_otherwise = good;
  masked_otherwise[good.find("xres", good.find("/2/mask")) + 6] = 10;
  masked_otherwise[good.find("yres", good.find("/2/mask")) + 6] = 2;
  EXPECT_THAT(surface_refusal(masked_otherwise), HasSubstr("the mask and its channel differ"));
}

TEST(MeasuredSurface, WithImpossibleHeightsOrDistancesIsRefused) {
  MeasuredSurface surface = small_surface();
  surface.heights_m[8] = 2.5;
  EXPECT_THAT(surface_refusal(x3p_of(surface)),
              StartsWith("scan: the height of the point 4 of the row 2 is 2.5 m; from -1 to 1 m"));
  surface.heights_m[8] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(decoded(x3p_of(surface)).heights_m[8]));
  surface.pitch_y_m = 0.0;
  EXPECT_THAT(surface_refusal(x3p_of(surface)), HasSubstr("along y is 0 m"));
}

}  // namespace
}  // namespace asperity::test
