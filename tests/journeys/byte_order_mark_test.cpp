// A byte order mark, with which many programs begin a text in UTF-8: every command reads the text behind it, or names the mark.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

constexpr const char* kMark = "\xEF\xBB\xBF";

/// A command, the text files that it reads, and the file that it makes, all by their names in a folder.
struct Reader {
  std::vector<std::string> arguments{};
  std::vector<std::string> files{};
  std::string made{};  ///< empty: only what the command prints is compared
};

Outcome run_in(const fs::path& folder, const Reader& reader) {
  Invocation invocation{};
  invocation.arguments = reader.arguments;
  invocation.folder = folder;
  return run(invocation);
}

/// The files of `plain` and copies that begin with the mark have the same result.
void expect_same_with_mark(const fs::path& plain, const Reader& reader) {
  SCOPED_TRACE(testing::PrintToString(reader.arguments));
  const TemporaryFolder marked;
  fs::copy(plain, marked.path(), fs::copy_options::recursive);
  for (const std::string& file : reader.files) {
    write_text(marked / file, kMark + text_of(plain / file));
  }
  const Outcome without = run_in(plain, reader);
  const Outcome with = run_in(marked.path(), reader);
  ASSERT_EQ(without.status, 0) << without.err;
  ASSERT_EQ(with.status, 0) << with.err;
  EXPECT_EQ(with.out, without.out);
  if (reader.made.empty()) return;
  EXPECT_TRUE(text_of(marked / reader.made) == text_of(plain / reader.made)) << reader.made;
}

void write_path(const fs::path& file) {
  write_text(file,
             "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t-0.0005\n0.001\t0.0001\t0\t-0.0005\n"
             "0.002\t0.00025\t0\t-0.00075\n");
}

TEST(ByteOrderMark, ChangesNoTableAndNoOptions) {
  const TemporaryFolder folder;
  write_text(folder / "shares.csv", "id,k,n,p0\na,5,10,0.5\n");
  write_text(folder / "options.json", R"({"conf": 0.9})");
  expect_same_with_mark(folder.path(),
                        {.arguments = {"analyze", "--table", "shares.csv", "--as", "proportion",
                                       "--options", "options.json", "--json"},
                         .files = {"shares.csv", "options.json"}});
}

TEST(ByteOrderMark, ChangesNoReliefAndNoPath) {
  const TemporaryFolder folder;
  write_path(folder / "path.tsv");
  const Outcome made = asperity({"synth", "sinusoid", "--pixels", "512", "--param",
                                 "amplitude_m=0.0001", "--out", folder / "relief.png"});
  ASSERT_EQ(made.status, 0) << made.err;
  expect_same_with_mark(
      folder.path(), {.arguments = {"render", "--model", "height_map", "--stimulus", "relief.png",
                                    "--path", "path.tsv", "--out", "forces.tsv"},
                      .files = {"relief.png.json", "path.tsv"},
                      .made = "forces.tsv"});
}

TEST(ByteOrderMark, ChangesNoRecordingAndNoVibrations) {
  const TemporaryFolder folder;
  write_path(folder / "path.tsv");
  ASSERT_EQ(
      asperity({"synth", "sandpaper", "--pixels", "256", "--out", folder / "rough.png"}).status, 0);
  const Outcome recorded = asperity(
      {"texture-recording", "--relief", folder / "rough.png", "--out", folder / "strokes.tsv"});
  ASSERT_EQ(recorded.status, 0) << recorded.err;
  expect_same_with_mark(folder.path(), {.arguments = {"texture-recording", "--table", "strokes.tsv",
                                                      "--out", "recorded.tsv"},
                                        .files = {"strokes.tsv"},
                                        .made = "recorded.tsv"});
  expect_same_with_mark(folder.path(),
                        {.arguments = {"fit-model", "strokes.tsv", "--out", "vibrations.tsv"},
                         .files = {"strokes.tsv"},
                         .made = "vibrations.tsv"});
  write_text(folder / "toolkit.xml",
             "<modelSet><AccelUnits>m/s^2</AccelUnits><SpeedUnits>mm/s</SpeedUnits>"
             "<ForceUnits>N</ForceUnits><SampleRate>1000</SampleRate><mu>0.31</mu>"
             "<model><ARlsf><value>1.0471975511965976</value><value>2.0943951023931953</value>"
             "</ARlsf><var>0.04</var><speedMod>60</speedMod><forceMod>1</forceMod></model>"
             "</modelSet>\n");
  expect_same_with_mark(folder.path(), {.arguments = {"fit-model", "--import", "toolkit.xml",
                                                      "--out", "imported.tsv"},
                                        .files = {"toolkit.xml"},
                                        .made = "imported.tsv"});
  const auto expect_same_forces = [&folder](const std::string& model, const std::string& role,
                                            const std::string& file) {
    expect_same_with_mark(folder.path(),
                          {.arguments = {"render", "--model", model, "--asset", role + '=' + file,
                                         "--path", "path.tsv", "--out", "by_" + model + ".tsv"},
                           .files = {file},
                           .made = "by_" + model + ".tsv"});
  };
  expect_same_forces("recorded", "recording", "strokes.tsv");
  expect_same_forces("data_driven", "vibration_models", "vibrations.tsv");
}

TEST(ByteOrderMark, ChangesNoMesh) {
  const TemporaryFolder folder;
  const std::string vertices = "0 0 0\n10.5 0 0\n0 10.5 0\n0 0 10.5\n";
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  write_text(folder / "solid.obj",
             "v 0 0 0\nv 10.5 0 0\nv 0 10.5 0\nv 0 0 10.5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  write_text(folder / "solid.off", "OFF\n4 4 6\n" + vertices + faces);
  write_text(folder / "solid.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
             "property float z\nelement face 4\nproperty list uchar int vertex_indices\n"
             "end_header\n" +
                 vertices + faces);
  const auto facet = [](const char* a, const char* b, const char* c) {
    return std::string("facet normal 0 0 0\nouter loop\nvertex ") + a + "\nvertex " + b +
           "\nvertex " + c + "\nendloop\nendfacet\n";
  };
  write_text(folder / "solid.stl", "solid a\n" + facet("0 0 0", "0 10.5 0", "10.5 0 0") +
                                       facet("0 0 0", "10.5 0 0", "0 0 10.5") +
                                       facet("0 0 0", "0 0 10.5", "0 10.5 0") +
                                       facet("10.5 0 0", "0 10.5 0", "0 0 10.5") + "endsolid a\n");
  for (const std::string mesh : {"solid.obj", "solid.off", "solid.ply", "solid.stl"}) {
    // The file that is made has the SHA-256 of the mesh, and the same numbers, which are printed.
    expect_same_with_mark(folder.path(),
                          {.arguments = {"bake", mesh, "--triangles", "4", "--out", mesh + ".mesh"},
                           .files = {mesh}});
  }
}

// A protocol is stored as it is, and places in it are counted in its bytes.
TEST(ByteOrderMark, IsRefusedInAProtocolWithItsRemedy) {
  const SmallStudy small(1);
  const fs::path marked = small.place() / "marked.json";
  write_text(marked, kMark + text_of(small.selection()));
  const std::vector<std::vector<std::string>> commands{
      {"check", marked},
      {"simulate", marked, "--study", small.study(), "--participants", "1", "--seed", "1"},
      {"run", marked, "--study", small.study(), "--participant", "p1", "--virtual"},
      {"power", marked, "--participants", "4", "--list-assumptions"}};
  for (const std::vector<std::string>& arguments : commands) {
    const Outcome outcome = asperity(arguments);
    EXPECT_EQ(outcome.status, 1) << arguments.front();
    EXPECT_THAT(outcome.err, HasSubstr("marked.json:1:1: error: begins with a byte order mark; "
                                       "save the file as UTF-8 without one"))
        << arguments.front();
  }
}

}  // namespace
}  // namespace asperity::test
