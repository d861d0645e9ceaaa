// Bad input: a sentence that names the file, the place and what would be right; exit 1; nothing
// written.

#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "renderers/compute/compute_device.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using OrderedJson = nlohmann::ordered_json;
using testing::HasSubstr;

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    EXPECT_NE(text.find(word), std::string::npos) << "without \"" << word << "\":\n" << text;
  }
}

/// Refused, with these words, and the folder is as it was.
void expect_refused(const fs::path& folder, const std::vector<std::string>& arguments,
                    const std::vector<std::string>& words) {
  const auto before = contents_of(folder);
  const Outcome outcome = asperity(arguments);
  EXPECT_EQ(outcome.status, 1) << arguments.front();
  EXPECT_EQ(outcome.out, "");
  expect_words(outcome.err, words);
  for (const auto& [name, content] : contents_of(folder)) {
    const auto was = before.find(name);
    if (was == before.end()) {
      ADD_FAILURE() << arguments.front() << " wrote " << name;
    } else {
      EXPECT_TRUE(content == was->second) << arguments.front() << " changed " << name;
    }
  }
}

/// The protocol is refused by everything that reads one.
void expect_protocol_refused(const SmallStudy& small, const fs::path& protocol,
                             const std::vector<std::string>& words) {
  std::vector<std::string> with_file = words;
  with_file.push_back(protocol.filename());
  expect_refused(small.place(), {"check", protocol, "--study", small.study()}, with_file);
  expect_refused(
      small.place(),
      {"simulate", protocol, "--study", small.study(), "--participants", "1", "--seed", "1"},
      words);
  expect_refused(small.place(),
                 {"run", protocol, "--study", small.study(), "--participant", "p1", "--virtual"},
                 words);
}

TEST(BadProtocol, IsNotThere) {
  const SmallStudy small(1);
  const std::string nowhere = small.place() / "nowhere.json";
  expect_protocol_refused(small, nowhere, {"nowhere.json"});
  const Outcome outcome = asperity({"check", nowhere, "--json"});
  EXPECT_THAT(outcome.err, testing::StartsWith(nowhere + ": error: the file "));
  const OrderedJson problem =
      OrderedJson::parse(outcome.out).at("protocols").at(0).at("diagnostics").at(0);
  EXPECT_TRUE(problem.at("line").is_null() && problem.at("column").is_null()) << problem;
}

TEST(BadProtocol, IsNotJson) {
  const SmallStudy small(1);
  const fs::path file = small.place() / "torn.json";
  write_text(file, "{\n  \"format\": \"asperity.protocol/1\",\n  \"kind\": selection\n}\n");
  expect_protocol_refused(small, file, {"torn.json:3:11: error: "});
  write_text(file, "");
  expect_protocol_refused(small, file, {"torn.json:1:1: error: "});
}

TEST(BadProtocol, HasSeveralFaultsAllSaidAtOnce) {
  const SmallStudy small(1);
  OrderedJson protocol = small_selection(1);
  protocol["kind"] = "selecting";
  protocol["device"]["rate_Hz"] = "fast";
  protocol["blocks"]["main"]["repetitions"] = 0;
  const fs::path file = small.place() / "several.json";
  write_text(file, protocol.dump(2));
  expect_protocol_refused(
      small, file, {"(/kind)", "(/device/rate_Hz)", "(/blocks/main/repetitions)", "selection"});
}

/// The small selection with another file of a texture.
fs::path with_height_field(const SmallStudy& small, const std::string& path) {
  OrderedJson protocol = small_selection(1);
  protocol["textures"]["walnut"]["height_field"] = path;
  const fs::path file = small.place() / "changed.json";
  write_text(file, protocol.dump(2));
  return file;
}

TEST(BadProtocol, ReachesAStimulusOutsideTheStudyThroughALink) {
  const SmallStudy small(1);
  fs::copy_file(small.study() / "stimuli/walnut.png", small.place() / "walnut.png");
  fs::copy_file(small.study() / "stimuli/walnut.png.json", small.place() / "walnut.png.json");
  fs::create_symlink(small.place() / "walnut.png", small.study() / "stimuli/link.png");
  fs::create_symlink(small.place() / "walnut.png.json", small.study() / "stimuli/link.png.json");
  expect_protocol_refused(small, with_height_field(small, "stimuli/link.png"),
                          {"stimuli/link.png", "outside"});
  fs::create_directory_symlink(small.place(), small.study() / "stimuli/elsewhere");
  expect_protocol_refused(small, with_height_field(small, "stimuli/elsewhere/walnut.png"),
                          {"stimuli/elsewhere/walnut.png", "outside"});
}

TEST(BadProtocol, NamesAStimulusThatIsMissingOrBroken) {
  const SmallStudy small(1);
  expect_protocol_refused(small, with_height_field(small, "stimuli/oak.png"), {"stimuli/oak.png"});
  const std::string whole = text_of(small.study() / "stimuli/walnut.png");
  fs::copy_file(small.study() / "stimuli/walnut.png.json", small.study() / "stimuli/half.png.json");
  write_text(small.study() / "stimuli/half.png", whole.substr(0, whole.size() / 2));
  expect_protocol_refused(small, with_height_field(small, "stimuli/half.png"), {"half.png"});
  write_text(small.study() / "stimuli/alone.png", whole);
  expect_protocol_refused(small, with_height_field(small, "stimuli/alone.png"), {"alone.png.json"});
}

TEST(BadPicture, IsRefusedByTextureWithoutAFile) {
  const SmallStudy small(1);
  const auto refuse = [&small](const std::string& name, const std::vector<std::string>& words) {
    std::vector<std::string> with_file = words;
    with_file.push_back(name);
    expect_refused(
        small.place(),
        {"texture", small.place() / name, "--out", small.place() / "made.png", "--width-m", "0.1"},
        with_file);
  };
  const std::string whole = text_of(small.study() / "stimuli/walnut_photo.png");
  refuse("nowhere.png", {});
  write_text(small.place() / "empty.png", "");
  refuse("empty.png", {"empty"});
  write_text(small.place() / "truncated.png", whole.substr(0, whole.size() / 2));
  refuse("truncated.png", {});
  write_text(small.place() / "head.png", whole.substr(0, 20));
  refuse("head.png", {});
  write_text(small.place() / "text.png", "this is no picture");
  refuse("text.png", {"PNG", "JPEG"});
  // A PNG's width and height stand behind its signature, and the length and name of its first
  // chunk.
  std::string gigantic = whole;
  gigantic.replace(16, 8, std::string("\0\1\0\0\0\0\x10\0", 8));  // 65536 × 4096
  write_text(small.place() / "gigantic.png", gigantic);
  refuse("gigantic.png", {"65536", "16"});
}

TEST(BadPicture, LeavesNothingHalfWritten) {
  const SmallStudy small(1);
  const fs::path photograph = small.study() / "stimuli/walnut_photo.png";
  write_text(small.place() / "taken.png", "mine");
  // The preview is in the way, so the height field is not made either.
  expect_refused(small.place(),
                 {"texture", photograph, "--out", small.place() / "made.png", "--width-m", "0.02",
                  "--preview", small.place() / "taken.png"},
                 {"taken.png", "--force"});
  expect_refused(small.place(),
                 {"synth", "sinusoid", "--out", small.place() / "made.png", "--photo",
                  "bright_height", small.place() / "taken.png"},
                 {"taken.png", "--force"});
  const auto before = contents_of(small.place());
  EXPECT_EQ(asperity({"synth", "sinusoid", "--out", small.place() / "made.png", "--photo", "dark",
                      small.place() / "photo.png"})
                .status,
            2);
  EXPECT_TRUE(contents_of(small.place()) == before);
}

TEST(BadPicture, OrSettingIsRefusedWithItsRange) {
  const SmallStudy small(1);
  const fs::path photograph = small.study() / "stimuli/walnut_photo.png";
  const fs::path made = small.place() / "made.png";
  expect_refused(small.place(), {"texture", photograph, "--out", made, "--width-m", "-1"},
                 {"width_m"});
  expect_refused(small.place(), {"texture", photograph, "--out", made, "--width-m", "4"},
                 {"width_m is 4 m", "from 0.001 to 1 m", "4 cm are 0.04 m"});
  expect_refused(small.place(),
                 {"texture", photograph, "--out", made, "--width-m", "0.02", "--rms-m", "nan"},
                 {"rms_m"});
  expect_refused(small.place(), {"synth", "velvet", "--out", made},
                 {"velvet", "sinusoid", "brick"});
  expect_refused(small.place(), {"synth", "sinusoid", "--out", made, "--param", "height=1"},
                 {"height", "amplitude_m"});
  expect_refused(small.place(), {"synth", "sinusoid", "--out", made, "--pixels", "0"}, {"pixels"});
}

struct UnreadableNumber {
  std::vector<std::string> arguments;
  std::string sentence;
};

class NumberOfAnOption : public testing::TestWithParam<UnreadableNumber> {};

TEST_P(NumberOfAnOption, IsRefusedWithOptionTextAndWhatIsExpected) {
  const Outcome refused = asperity(GetParam().arguments);
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.err, "asperity: " + GetParam().sentence + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    Units, NumberOfAnOption,
    testing::Values(
        UnreadableNumber{{"texture", "a.png", "--out", "b.png", "--width-m", "10cm"},
                         "--width-m: \"10cm\" is not a number; write one in metres, such as 0.1"},
        UnreadableNumber{{"texture", "a.png", "--out", "b.png", "--width-m", "0,1"},
                         "--width-m: \"0,1\" is not a number; write one in metres, such as 0.1"},
        UnreadableNumber{
            {"texture", "a.png", "--out", "b.png", "--width-m", "0.1", "--gamma-low", "x"},
            "--gamma-low: \"x\" is not a number; write one, such as 0.5"},
        UnreadableNumber{{"render", "--model", "plane", "--path", "a", "--out", "b",
                          "--stiffness-n-per-m", "1kN/m"},
                         "--stiffness-n-per-m: \"1kN/m\" is not a number; write one in newtons per "
                         "metre, such as 1000"},
        UnreadableNumber{{"sweep", "--model", "plane", "--vary", "probe_diameter", "--out", "b",
                          "--exploratory-speed-m-per-s", "fast"},
                         "--exploratory-speed-m-per-s: \"fast\" is not a number; write one in "
                         "metres per second, such as 0.1"},
        UnreadableNumber{
            {"sweep", "--model", "sinusoid", "--vary", "probe_diameter", "--out", "b", "--values",
             "0.001,2mm"},
            "--values 0.001,2mm: \"2mm\" is not a number; a probe diameter is given in m: "
            "write 2 mm as 0.002"},
        UnreadableNumber{{"device-test", "simulated", "--rate-hz", "1kHz"},
                         "--rate-hz: \"1kHz\" is not a number; write one in hertz, such as 1000"},
        UnreadableNumber{
            {"simulate", "a.json", "--study", "s", "--seed", "1", "--participants", "ten"},
            "--participants: \"ten\" is not a whole number; write one, such as 10"}));

/// The lines of FILE:LINE:COLUMN in what was said, in order.
std::vector<int> lines_said(const std::string& said, const fs::path& file) {
  std::vector<int> lines{};
  const std::string start = file.string() + ':';
  for (std::size_t at = said.find(start); at != std::string::npos; at = said.find(start, at + 1)) {
    lines.push_back(std::stoi(said.substr(at + start.size())));
  }
  return lines;
}

/// A protocol whose contacts are evaluated on a GPU.
fs::path protocol_on_gpu(const TemporaryFolder& place) {
  std::string text = text_of(SmallStudy(1).selection());
  const std::string rate = R"("rate_Hz": 1000)";
  text.replace(text.find(rate), rate.size(), rate + R"(, "compute": "gpu")");
  write_text(place / "on_gpu.json", text);
  return place / "on_gpu.json";
}

TEST(BadProtocol, WarnsThatThisComputerHasNoGpuForAProtocolThatAsksForOne) {
  const TemporaryFolder place{};
  fs::create_directories(place / "no-drivers");
  const Outcome without = run({.arguments = {"check", protocol_on_gpu(place)},
                               .environment = {{"OCL_ICD_VENDORS", place / "no-drivers"}}});
  EXPECT_EQ(without.status, 0) << without.err;
  EXPECT_THAT(without.err, HasSubstr("warning: on this computer contacts cannot be evaluated on a "
                                     "GPU: this machine has no OpenCL device"));
  EXPECT_THAT(without.err, HasSubstr("--compute cpu"));
  EXPECT_THAT(without.err, HasSubstr("(/device/compute)"));
}

// With the driver that the tests install.
TEST(BadProtocol, WarnsThatTheComputeDeviceIsAProcessor) {
  if (ComputeDevice::all().front().name().is_gpu) GTEST_SKIP() << "this computer has a GPU";
  const TemporaryFolder place{};
  const Outcome on_processor = asperity({"check", protocol_on_gpu(place)});
  EXPECT_EQ(on_processor.status, 0) << on_processor.err;
  EXPECT_THAT(on_processor.err, HasSubstr("is a processor, not a GPU; use --compute cpu"));
}

// Form, meaning, files and warnings, each somewhere else in the text.
TEST(BadProtocol, IsReportedWithAllThatIsWrongWithItFromTheFirstLineToTheLast) {
  const SmallStudy small(1);
  const fs::path protocol = small.selection();
  std::string text = text_of(protocol);
  const auto replace = [&text](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  replace("\"explorations\": {", "\"explorations\": {\n\"spare\": {},");
  fs::remove(small.study() / "stimuli/walnut.png");
  write_text(protocol, text);
  const Outcome warned = asperity({"check", protocol, "--study", small.study()});
  EXPECT_EQ(warned.status, 1);
  EXPECT_NE(warned.err.find("stimuli/walnut.png is not in the study"), std::string::npos)
      << warned.err;
  EXPECT_NE(warned.err.find("warning: no block uses the exploration \"spare\""), std::string::npos)
      << warned.err;
  const std::vector<int> lines = lines_said(warned.err, protocol);
  EXPECT_GE(lines.size(), 2U);
  EXPECT_TRUE(std::is_sorted(lines.begin(), lines.end())) << warned.err;

  replace("\"title\": ", "\"title\": 3, \"x-title\": ");
  write_text(protocol, text);
  const Outcome refused = asperity({"check", protocol, "--study", small.study()});
  EXPECT_NE(refused.err.find("3 is not permitted here: write text in quotation marks"),
            std::string::npos)
      << refused.err;
  EXPECT_NE(refused.err.find("stimuli/walnut.png is not in the study"), std::string::npos)
      << refused.err;

  const Outcome picture = asperity({"check", small.study() / "stimuli/walnut_photo.png"});
  EXPECT_EQ(picture.status, 1);
  EXPECT_NE(picture.err.find("this is not a JSON text file, but a binary one"), std::string::npos)
      << picture.err;
}

/// What needs a study, on a folder that is none that this program can use.
void expect_study_refused(const SmallStudy& small, const fs::path& study,
                          const std::vector<std::string>& words) {
  const fs::path protocol = small.selection();
  const std::string out = small.place() / "out";
  expect_refused(small.place(), {"analyze", study}, words);
  expect_refused(small.place(), {"export", study, "--out", out}, words);
  expect_refused(small.place(), {"verify", study}, words);
  expect_refused(small.place(), {"copy", study, out}, words);
  expect_refused(small.place(), {"replay", study, "--attempt", "1", "--out", out}, words);
  expect_refused(small.place(),
                 {"run", protocol, "--study", study, "--participant", "p1", "--virtual"}, words);
}

TEST(BadStudy, IsNotThere) {
  const SmallStudy small(1);
  const fs::path bare = small.place() / "bare";  // stimuli but no store
  fs::create_directory(bare);
  fs::copy(small.study() / "stimuli", bare / "stimuli");
  expect_study_refused(small, bare, {"bare", "study"});
  expect_refused(small.place(), simulate_arguments(small, bare, 1, 1), {"bare"});
}

TEST(BadStudy, IsSomethingElse) {
  const SmallStudy small(1);
  write_text(small.study() / "study.sqlite", std::string(5000, 'x'));
  expect_study_refused(small, small.study(), {"study.sqlite"});
  expect_refused(small.place(), simulate_arguments(small, small.study(), 1, 1), {"study.sqlite"});
}

TEST(BadStudy, IsAnotherProgramsDatabase) {
  const SmallStudy small(1);
  fs::remove(small.study() / "study.sqlite");
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((small.study() / "study.sqlite").c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, "CREATE TABLE recipes (name TEXT)", nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(database);
  expect_study_refused(small, small.study(), {"study.sqlite"});
}

TEST(BadStudy, IsOfANewerProgram) {
  const SmallStudy small(1);
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((small.study() / "study.sqlite").c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, "PRAGMA user_version = 99", nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(database);
  expect_study_refused(small, small.study(), {"99", "newer"});
  expect_refused(small.place(), simulate_arguments(small, small.study(), 1, 1), {"99", "newer"});
}

TEST(BadStudy, IsNotMadeOverSomethingElse) {
  const SmallStudy small(1);
  expect_refused(small.place(), {"new", small.study()}, {"study"});
  write_text(small.place() / "notes.txt", "mine");
  expect_refused(small.place(), {"new", small.place(), "--demo"}, {small.place()});
}

TEST(BadStudy, IsAFileAndNotItsFolder) {
  const SmallStudy small(1);
  const fs::path file = small.study() / "study.sqlite";
  const std::vector<std::string> words{file, "is a file", "here the folder of this file",
                                       small.study().string()};
  expect_study_refused(small, file, words);
  const std::vector<std::vector<std::string>> commands{
#ifdef ASPERITY_WITH_REPORT
      {"report", file, "--out", small.place() / "report.pdf"},
#endif
      simulate_arguments(small, file, 1, 1)};
  for (const std::vector<std::string>& command : commands) {
    expect_refused(small.place(), command, words);
  }
  write_text(small.place() / "notes.txt", "mine");
  expect_refused(small.place(), {"new", small.place() / "notes.txt"},
                 {"notes.txt", "it is a file", "new or an empty folder"});
}

TEST(BadStudy, ToLookForFilesInIsNotThere) {
  const SmallStudy small(1);
  for (const char* const name : {"nowhere", "study/study.sqlite"}) {
    expect_refused(small.place(), {"check", small.selection(), "--study", small.place() / name},
                   {"there is no folder", name, "--study takes the folder of a study"});
  }
}

/// What `analyze --table` says of a table of this family that it refuses.
void expect_table_refused(const std::string& kind, const std::string& table,
                          const std::vector<std::string>& options,
                          const std::vector<std::string>& words) {
  const TemporaryFolder folder;
  write_text(folder / "table.csv", table);
  std::vector<std::string> arguments{"analyze", "--table", folder / "table.csv", "--as", kind};
  for (const std::string& option : options) {
    arguments.insert(arguments.end(), {"--option", option});
  }
  expect_refused(folder.path(), arguments, words);
}

TEST(BadTable, IsRefusedWithItsPlaceAndWhatWouldBeRight) {
  const std::string head = "id,k,n,p0,conf\n";
  expect_table_refused("proportion", "", {}, {"table.csv:1", "names of the columns"});
  expect_table_refused("proportion", head, {}, {"table.csv", "the table has no rows"});
  expect_table_refused("proportion", "name,hits\na,1\n", {}, {"no column \"id\"", "name, hits"});
  expect_table_refused("proportion", "id;k;n;p0\na;1;2;0,5\n", {}, {"semicolons", "commas"});
  expect_table_refused("proportion", "id\tk\tn\tp0\na\t1\t2\t0,5\n", {},
                       {"table.csv:2:4", "decimal comma"});
  expect_table_refused("proportion", head + "a,NaN,10,0.5,0.95\n", {},
                       {"table.csv:2:2", "NaN", "leave the cell empty"});
  expect_table_refused("proportion", head + "a,5,10,0.5\n", {}, {"4 cells", "5 columns"});
  expect_table_refused("proportion", head + "a,11,10,0.5,0.95\n", {}, {"k is 11 and n is 10"});
}

// A table from anywhere must not write a line that looks like one of the program, nor colour the terminal.
TEST(BadTable, IsQuotedWithItsControlCharactersShown) {
  const TemporaryFolder place{};
  write_text(place / "t.csv", "id,k,n,p0\na,\"\x1b[31mX\nasperity: all is well\",10,0.5\n");
  const Outcome outcome = asperity({"analyze", "--table", place / "t.csv", "--as", "proportion"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find(R"(\u001b[31mX\u000aasperity: all is well)"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos);
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << "one line";
}

TEST(GoodTable, IsPrintedWithALinePerRow) {
  const TemporaryFolder place{};
  write_text(place / "t.csv", "id,k,n,p0\n\"two\nlines\",5,10,0.5\n");
  const Outcome outcome = asperity({"analyze", "--table", place / "t.csv", "--as", "proportion"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\ntwo\\u000alines  "), std::string::npos) << outcome.out;
}

TEST(BadOption, OfATableIsToldFromOneThatTheDataHaveNoUseFor) {
  const std::string table = "id,k,n,p0\na,5,10,0.5\n";
  expect_table_refused("proportion", table, {"nonsense=1"},
                       {"proportion has no option \"nonsense\"", "choose one of: conf"});
  expect_table_refused("proportion", "id,k,n,p0,conf\na,5,10,0.5,0.95\n", {"conf=0.9"},
                       {"\"conf\" is not used", "has a column of that name"});
  expect_table_refused("seedpaper", table, {"conf=0.9"}, {"seedpaper has no option \"conf\""});
  // Nobody answered: the confidence is of no use, and no word that it is unknown.
  const TemporaryFolder folder;
  write_text(folder / "table.csv", "subject,stimulus,response\ns1,a,\ns2,b,\n");
  const Outcome nobody =
      asperity({"analyze", "--table", folder / "table.csv", "--as", "recognition", "--option",
                "labels=a,b", "--option", "conf=0.9"});
  EXPECT_EQ(nobody.status, 0) << nobody.err;
  EXPECT_EQ(nobody.err, "");
}

TEST(GoodTable, HasABomWindowsLineEndsAndOptionsOfItsOwn) {
  const TemporaryFolder folder;
  write_text(folder / "table.csv", "\xEF\xBB\xBFid,k,n,p0\r\na,5,10,0.5\r\n");
  const Outcome outcome = asperity({"analyze", "--table", folder / "table.csv", "--as",
                                    "proportion", "--option", "conf=0.9", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::size_t limits = 0;
  const OrderedJson told = OrderedJson::parse(outcome.out);
  for (const OrderedJson& finding : told.at("findings")) {
    if (finding.at("quantity") == "wilson.lower") {
      ++limits;
      // (p + z²/2n − z·√(p(1−p)/n + z²/4n²)) / (1 + z²/n) with z = 1.6449: 0.2693
      EXPECT_NEAR(finding.at("value").get<double>(), 0.2693, 1e-4);
    }
  }
  EXPECT_EQ(limits, 1U);
}

TEST(BadLabel, IsRefused) {
  const SmallStudy small(1);
  for (const std::string label : {"../p1", "a/b", "x'; DROP TABLE session; --", "p 1", "Zoë", "",
                                  "012345678901234567890123456789012"}) {
    expect_refused(
        small.place(),
        {"run", small.selection(), "--study", small.study(), "--participant=" + label, "--virtual"},
        {label, "1 to 32 letters and digits"});
  }
}

TEST(BadDevice, IsRefusedWithThoseThatThereAre) {
  const SmallStudy small(1);
  expect_refused(small.place(),
                 {"run", small.selection(), "--study", small.study(), "--participant", "p1",
                  "--virtual", "--device", "phantom"},
                 {"phantom", "simulated"});
  expect_refused(small.place(), {"check", small.selection(), "--device", "phantom"},
                 {"phantom", "simulated"});
  expect_refused(small.place(), {"check", small.selection(), "--device", "simulated:phantom"},
                 {"phantom", "falcon, delta.3"});
}

TEST(BadDevice, IsAProblemOfTheOptionAndNotOfTheProtocol) {
  const SmallStudy small(1);
  const std::string device = "simulated:falcon,mass_kg=heavy";
  const std::vector<std::string> words{"asperity: --device " + device,
                                       "mass_kg of the simulated device is \"heavy\""};
  expect_refused(small.place(), {"check", small.selection(), "--device", device}, words);
  expect_refused(small.place(),
                 {"run", small.selection(), "--study", small.study(), "--participant", "p1",
                  "--virtual", "--device", device},
                 words);
  expect_refused(small.place(), {"device-test", device},
                 {"asperity: NAME " + device, "mass_kg of the simulated device is \"heavy\""});
  const Outcome checked =
      asperity({"check", small.selection(), "--device", "simulated:falcon,mass_kg=0.2,"});
  EXPECT_EQ(checked.err.find("selection.json"), std::string::npos) << checked.err;
}

TEST(WrongUsage, EndsWithTwo) {
  const SmallStudy small(1);
  const std::vector<std::vector<std::string>> wrong{
      {"fly"},
      {"new"},
      {"models", "--jsn"},
      {"simulate", small.selection(), "--study", small.study(), "--participants", "0", "--seed",
       "1"},
      {"simulate", small.selection(), "--study", small.study(), "--participants", "1"},
      {"run", small.selection(), "--study", small.study(), "--participant", "p1", "--realtime"},
      {"run", small.selection(), "--study", small.study(), "--participant", "p1", "--virtual",
       "--realtime", "--as-fast-as-possible"},
      {"render", "--model", "sinusoid", "--param", "amplitude_m", "--path", "p", "--out", "o"}};
  const auto before = contents_of(small.place());
  for (const std::vector<std::string>& arguments : wrong) {
    const Outcome outcome = asperity(arguments);
    EXPECT_EQ(outcome.status, 2) << (arguments.empty() ? "" : arguments.front()) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err, "");
  }
  EXPECT_TRUE(contents_of(small.place()) == before);
}

TEST(WrongUsage, WithoutATerminalNamesTheWaysToTakePart) {
  const SmallStudy small(1);
  const Outcome outcome = asperity({"run", small.selection(), "--study", small.study(),
                                    "--participant", "p1", "--mode", "pilot"});
  EXPECT_EQ(outcome.status, 2);
  for (const std::string& way : {std::string("Start the command in a terminal"),
                                 "windows (asperity " + small.study().string() + ")",
                                 std::string("--virtual for a virtual participant")}) {
    EXPECT_THAT(outcome.err, testing::HasSubstr(way));
  }
}

TEST(WrongUsage, NamesTheOptionAndWhatWouldBeRight) {
  const TemporaryFolder place{};
  const std::vector<std::string> rendering{"render",    "--model", "sinusoid", "--path",
                                           place / "p", "--out",   place / "f"};
  const auto expect_wrong = [](std::vector<std::string> arguments,
                               const std::vector<std::string>& more, const char* sentence) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = asperity(arguments);
    EXPECT_EQ(outcome.status, 2) << sentence;
    EXPECT_THAT(outcome.err, testing::HasSubstr(sentence));
  };
  expect_wrong(rendering, {"--stiffness", "-5"},
               "asperity: render has no option --stiffness; did you mean --stiffness-n-per-m?\n");
  expect_wrong(rendering, {"--hardness=5"},
               "asperity: render has no option --hardness; see asperity render --help\n");
  expect_wrong(rendering, {"--stiffness-n-per-m", "-5"},
               "asperity: --stiffness-n-per-m is -5; it must be above 0 N/m\n");
  expect_wrong(rendering, {"--friction", "-0.1"},
               "asperity: --friction is -0.1; it must be at least 0\n");
  expect_wrong(rendering, {"--asset", "vibrations"},
               "asperity: --asset vibrations has no \"=\"; write ROLE=FILE\n");
  expect_wrong(rendering, {"--asset", "vibrations=f"},
               "asperity: --asset vibrations=f: the force model sinusoid needs no asset "
               "\"vibrations\"; asperity models lists those that it needs\n");
  write_text(place / "p", "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0.001\n0.001\t0\t0\t-0.001\n");
  write_text(place / "v.tsv", "speed\n1\n");
  const Outcome with_wrong_file = asperity({"render", "--model", "data_driven", "--asset",
                                            "vibration_models=" + (place / "v.tsv").string(),
                                            "--path", place / "p", "--out", place / "f"});
  EXPECT_EQ(with_wrong_file.status, 1);
  EXPECT_THAT(with_wrong_file.err,
              testing::StartsWith("asperity: " + (place / "v.tsv").string() + ":1: "));
  expect_wrong({"bake", "x.obj", "--triangles", "600", "--out", "x.mesh"}, {"--for", "hand"},
               "--for: \"hand\" is not permitted; write surface or tool\n");
}

TEST(WrongUsage, IsStatedInOneStyle) {
  struct Case {
    std::vector<std::string> arguments{};
    std::string sentence{};
  };
  const std::vector<std::string> simulation{"simulate", "p", "--study", "s", "--seed", "1"};
  const auto simulate = [&simulation](std::vector<std::string> more) {
    more.insert(more.begin(), simulation.begin(), simulation.end());
    return more;
  };
  const auto run = [](std::vector<std::string> more) {
    const std::vector<std::string> begin{"run", "p", "--study", "s", "--participant", "P01"};
    more.insert(more.begin(), begin.begin(), begin.end());
    return more;
  };
  const std::vector<Case> cases{
#ifdef ASPERITY_WITH_WINDOWS
      {{"fly"}, "there is no subcommand and no folder \"fly\"; see asperity --help"},
      {{"--widow"}, "asperity has no option --widow; did you mean --window?"},
      {{"--window", "models"},
       "--window and the subcommand models exclude each other; leave one out"},
#endif
      {{"analyse", "study"}, "there is no subcommand \"analyse\"; did you mean analyze?"},
      {{"verfy"}, "there is no subcommand \"verfy\"; did you mean verify?"},
      {{"--jsn"}, "asperity has no option --jsn; see asperity --help"},
      {{"models", "--jsno"}, "models has no option --jsno; did you mean --json?"},
      {{"models", "extra"},
       "\"extra\" is an unexpected argument; remove it, or see asperity models --help"},
      {{"new"}, "new needs DIR; see asperity new --help"},
      {{"bake", "x.obj", "--triangels", "600", "--out", "x.mesh"},
       "bake has no option --triangels; did you mean --triangles?"},
      {{"run", "p", "--study", "s"}, "run needs --participant; see asperity run --help"},
      {{"run", "p", "--study"}, "--study: its value is missing; see asperity run --help"},
      {simulate({"--participants", "1", "--study", "t"}), "--study is given 2 times; give it once"},
      {run({"--mode", "foo"}), "--mode: \"foo\" is not permitted; write pilot or run"},
      {run({"--realtime"}), "--realtime needs --virtual; add it, or leave out --realtime"},
      {run({"--virtual", "--realtime", "--as-fast-as-possible"}),
       "--as-fast-as-possible and --realtime exclude each other; leave one out"},
      {run({"--virtual", "--seed", "-1"}),
       "--seed: \"-1\" is not a whole number; write one, such as 10"},
      {simulate({"--participants", "0"}),
       "--participants: \"0\" is not permitted; write a whole number from 1 to 9999"},
      {simulate({"--participants", "1", "--recordings", "some"}),
       "--recordings: \"some\" is not permitted; write all, first or none"},
      {{"device-test", "simulated", "--rate-hz", "1"},
       "--rate-hz: \"1\" is not permitted; write a number from 100 to 10000"},
      {{"device-test", "simulated", "--force-n", "30"},
       "--force-n: \"30\" is not permitted; write a number from 0.1 to 20"},
      {{"texture", "p.png", "--width-m", "0.1", "--out", "o.png", "--sign", "3"},
       "--sign: \"3\" is not permitted; write 1 or -1"},
      {{"render", "--model", "sinusoid", "--path", "p", "--out", "o", "--coupling", "stiff"},
       "--coupling: \"stiff\" is not permitted; write none or virtual"},
      {{"export", "s", "--out", "o", "--formats", "wide,xls"},
       "--formats: \"xls\" is not permitted; write wide, sav, bids, psychds, physio, stimuli, fit, "
       "all "
       "or none"},
      {{"analyze"}, "analyze needs STUDY, --table or --case; see asperity analyze --help"}};
  for (const Case& wrong : cases) {
    const Outcome outcome = asperity(wrong.arguments);
    EXPECT_EQ(outcome.status, 2) << wrong.sentence;
    EXPECT_EQ(outcome.err, "asperity: " + wrong.sentence + '\n');
    EXPECT_EQ(outcome.out, "");
  }
}

TEST(BadName, OfAPictureIsRefusedBeforeTheWork) {
  const TemporaryFolder place{};
  const std::string grains = place / "grains.png";
  const std::string photo = place / "photo.png";
  ASSERT_EQ(asperity({"synth", "grating", "--out", grains, "--pixels", "64", "--width-m", "0.02",
                      "--photo", "bright_height", photo})
                .status,
            0);
  const auto before = contents_of(place.path());
  expect_refused(place.path(), {"synth", "noise", "--out", place / "z.jpg"},
                 {"z.jpg: the output is a PNG; name it ", "z.png"});
  expect_refused(place.path(), {"texture", photo, "--width-m", "0.02", "--out", place / "z.jpg"},
                 {"z.jpg: the output is a PNG; name it ", "z.png"});
  expect_refused(place.path(),
                 {"texture", photo, "--width-m", "0.02", "--out", place / "z.png", "--preview",
                  place / "steps.jpg"},
                 {"steps.jpg: the output is a PNG; name it ", "steps.png"});
  write_text(place / "path.tsv", "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0\n0.001\t0\t0\t0\n");
  expect_refused(place.path(),
                 {"render", "--model", "pd_gradient", "--stimulus", photo, "--tool", "sphere:0.005",
                  "--path", place / "path.tsv", "--out", place / "f.tsv"},
                 {"photo.png is a picture, not a height field: there is no ", "photo.png.json",
                  "asperity texture"});
  write_text(place / "ball.obj", "v 0 0 0\n");
  const auto expect_render_refused = [&](std::vector<std::string> options,
                                         const std::vector<std::string>& words) {
    options.insert(options.begin(), "render");
    options.insert(options.end(), {"--path", place / "path.tsv", "--out", place / "f.tsv"});
    expect_refused(place.path(), options, words);
  };
  expect_render_refused(
      {"--model", "sinusoid", "--stimulus", "sphere:0.06", "--height-field", place / "ball.obj"},
      {"ball.obj is a mesh, not a height field; make a textured mesh with asperity bake"});
  expect_render_refused({"--model", "sinusoid", "--stimulus", "cube:0.01"},
                        {"--stimulus cube:0.01: there is no shape \"cube\"; write one of ",
                         "box:[FILE.png,]X_m,Y_m,Z_m", "with sizes in metres"});
  expect_render_refused({"--model", "sinusoid", "--stimulus", "sphere:0.06mm"},
                        {"--stimulus sphere:0.06mm: the size \"0.06mm\" is not a number; write "
                         "sphere:[FILE.png,]D_m, with sizes in metres without a unit"});
  expect_render_refused({"--model", "rigdes"}, {"there is no force model \"rigdes\"",
                                                "load the plug-in with --plugin FILE"});
}

// A pipe that nobody writes to has no beginning, and a device may have no end.
TEST(BadFile, ThatIsNoRegularFileIsRefusedAtOnce) {
  const TemporaryFolder place{};
  const TemporaryFolder elsewhere{};  // the test reads all files of `place`
  ASSERT_EQ(mkfifo((elsewhere / "pipe").c_str(), 0600), 0);
  write_text(place / "t.csv", "subject,item,score\nA,a,6\n");
  for (const fs::path& file : {elsewhere / "pipe", fs::path("/dev/zero")}) {
    const std::vector<std::vector<std::string>> commands{
        {"check", file},
        {"texture", file, "--width-m", "0.1", "--out", place / "o.png"},
        {"bake", file, "--triangles", "100", "--out", place / "o.mesh"},
        {"analyze", "--table", file, "--as", "rating"},
        {"analyze", "--table", place / "t.csv", "--as", "rating", "--options", file},
        {"render", "--model", "stochastic", "--path", file, "--out", place / "o.tsv"}};
    for (const std::vector<std::string>& command : commands) {
      expect_refused(place.path(), command, {file.string(), "only regular files are read"});
    }
  }
}

TEST(Help, IsThereForEverything) {
  const Outcome all = asperity({"--help"});
  EXPECT_EQ(all.status, 0);
  for (const std::string command :
       {"new",    "check",    "run",      "simulate", "analyze", "export", "models",
        "render", "texture",  "synth",    "bake",     "verify",  "replay", "copy",
        "merge",  "metadata", "withdraw", "power",    "sweep",   "bench",  "fit-model"}) {
    EXPECT_NE(all.out.find("\n  " + command), std::string::npos) << command;
    const Outcome help = asperity({command, "--help"});
    EXPECT_EQ(help.status, 0) << command;
    EXPECT_NE(help.out, "") << command;
    for (const std::string internal : {"ENUM", ":TEXT", ":WORD"}) {
      EXPECT_THAT(help.out, testing::Not(HasSubstr(internal))) << command;
    }
  }
}

TEST(Version, SaysVersionCommitAndBuildType) {
  const Outcome version = asperity({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out,
              testing::MatchesRegex("asperity [0-9.]+ \\(commit [^ ]+, [A-Za-z]+\\)\n"));
}

}  // namespace
}  // namespace asperity::test
