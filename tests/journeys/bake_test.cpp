// bake: from a mesh file to a textured mesh, through the real program.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/study_files/textured_mesh_files.h"
#include "results_schema/tables/table.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/stimuli/made_mesh.h"
#include "tests/stimuli/mesh_text.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

/// In millimetres, as files are.
TriangleMesh original() { return bumpy_ball(4, 20.0, 0.5, 9.0); }

TEST(Bake, MakesATexturedMeshAndSaysHowGoodItIs) {
  const TemporaryFolder place{};
  write_text(place / "ball.obj", obj_of(original()));
  const Outcome outcome = asperity(
      {"bake", place / "ball.obj", "--triangles", "200", "--out", place / "ball.mesh", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(outcome.out.find("\"format\": \"asperity.bake/1\""), 4U);
  EXPECT_EQ(json.at("triangles_in"), 2048);
  EXPECT_EQ(json.at("triangles_out"), 200);
  EXPECT_LT(json.at("textured_error_rms_m").get<double>(),
            0.2 * json.at("error_rms_m").get<double>());
  EXPECT_LE(json.at("textured_error_max_m").get<double>(), json.at("error_max_m").get<double>());
  EXPECT_GT(json.at("wall_s").get<double>(), 0.0);
  EXPECT_THAT(outcome.err, HasSubstr("baking: 100 %"));

  const LoadedTexturedMesh loaded = load_textured_mesh(place / "ball.mesh");
  EXPECT_EQ(loaded.stored->mesh.triangles.size(), 200U);
  EXPECT_EQ(loaded.stored->provenance.source_name, "ball.obj");
  EXPECT_EQ(loaded.stored->plain.rms_m, json.at("error_rms_m").get<double>());
  for (const glm::dvec3& vertex : loaded.stored->mesh.vertices_m) {
    EXPECT_NEAR(glm::length(vertex), 0.020, 0.0006);
  }
}

TEST(Bake, TellsPeopleWhatItFoundAndMade) {
  const TemporaryFolder place{};
  write_text(place / "ball.stl", binary_stl_of(original()));
  const Outcome outcome = asperity({"bake", place / "ball.stl", "--triangles", "100", "--out",
                                    place / "ball.mesh", "--unit-m", "0.01", "--jobs", "2"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("2048 → 100 triangles"));
  EXPECT_THAT(outcome.out,
              HasSubstr("Vertices merged with another one at the same position: 5118."));
  EXPECT_THAT(outcome.out, HasSubstr("with texture: RMS"));
  EXPECT_NEAR(glm::length(load_textured_mesh(place / "ball.mesh").stored->mesh.vertices_m[0]), 0.2,
              0.006);
}

TEST(Bake, GivesTheSameFileWithAnyNumberOfThreads) {
  const TemporaryFolder place{};
  write_text(place / "ball.off", off_of(original()));
  for (const char* jobs : {"1", "3"}) {
    ASSERT_EQ(asperity({"bake", place / "ball.off", "--triangles", "150", "--out",
                        place / (std::string(jobs) + ".mesh"), "--jobs", jobs})
                  .status,
              0);
  }
  EXPECT_TRUE(text_of(place / "1.mesh") == text_of(place / "3.mesh"));
}

TEST(Bake, ReplacesNothingUnlessItIsTold) {
  const TemporaryFolder place{};
  write_text(place / "ball.obj", obj_of(original()));
  write_text(place / "ball.mesh", "mine");
  std::vector<std::string> arguments{"bake",  place / "ball.obj", "--triangles", "50",
                                     "--out", place / "ball.mesh"};
  const Outcome refused = asperity(arguments);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("ball.mesh already exists"));
  EXPECT_EQ(text_of(place / "ball.mesh"), "mine");
  arguments.emplace_back("--force");
  EXPECT_EQ(asperity(arguments).status, 0);
  EXPECT_NE(text_of(place / "ball.mesh"), "mine");
}

TEST(Bake, RefusesBadMeshesInASentenceAndWritesNothing) {
  const TemporaryFolder place{};
  const std::string good = obj_of(original());
  const std::tuple<std::string, std::string, std::string, std::string> all[] = {
      {"empty.obj", "", "200", "empty"},
      {"torn.ply", ply_of(original()).substr(0, 9000), "200", "truncated"},
      {"garbage.stl", std::string(300, '\x9c'), "200",
       "in none of the formats OBJ, PLY, STL and OFF"},
      {"garbage.ply", "ply\nformat binary_little_endian 1.0\n\x1b\x02\xff\n", "200",
       "garbage.ply:3: \"???\" is not a keyword of a PLY header"},
      {"nan.obj", "v nan 0 0\nv 10 0 0\nv 0 10 0\nf 1 2 3\n", "200", "number 1"},
      {"one.obj", "v 0 0 0\nv 10 0 0\nv 0 10 0\nf 1 2 3\n", "200", "flat"},
      {"many.obj", good, "2050", "has only 2048"}};
  for (const auto& [name, content, triangles, words] : all) {
    write_text(place / name, content);
    const Outcome outcome =
        asperity({"bake", place / name, "--triangles", triangles, "--out", place / "out.mesh"});
    EXPECT_EQ(outcome.status, 1) << name;
    EXPECT_EQ(outcome.out, "") << name;
    EXPECT_THAT(outcome.err, HasSubstr("asperity: ")) << name;
    EXPECT_THAT(outcome.err, HasSubstr(name)) << name;
    EXPECT_THAT(outcome.err, HasSubstr(words)) << name;
    EXPECT_FALSE(fs::exists(place / "out.mesh")) << name;
  }
  const Outcome nowhere = asperity(
      {"bake", place / "many.obj", "--triangles", "200", "--out", (place / "no") / "such.mesh"});
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_THAT(nowhere.err, HasSubstr("there is no folder"));
  EXPECT_THAT(nowhere.err, testing::Not(HasSubstr("baking")));
  const Outcome missing =
      asperity({"bake", place / "nowhere.obj", "--triangles", "200", "--out", place / "out.mesh"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.err, HasSubstr("nowhere.obj"));
  EXPECT_EQ(asperity({"bake", place / "many.obj", "--triangles", "3", "--out", place / "x"}).status,
            2);
  const Outcome named =
      asperity({"bake", place / "many.obj", "--triangles", "200", "--out", place / "simple.obj"});
  EXPECT_EQ(named.status, 1);
  EXPECT_THAT(named.err, HasSubstr("simple.obj: the output is a textured mesh"));
  EXPECT_THAT(named.err, HasSubstr("simple.mesh"));
  EXPECT_FALSE(fs::exists(place / "simple.obj"));
}

TEST(Bake, PutsAToolOnItsTip) {
  const TemporaryFolder place{};
  TriangleMesh ball = original();
  for (glm::dvec3& vertex : ball.vertices_m) vertex += glm::dvec3{100.0, 7.0, -30.0};
  write_text(place / "ball.obj", obj_of(ball));
  const Outcome outcome = asperity({"bake", place / "ball.obj", "--triangles", "150", "--out",
                                    place / "ball.mesh", "--for", "tool"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("The mesh was moved by -"));
  EXPECT_THAT(outcome.out, HasSubstr("its lowest point lies in the plane z = 0"));
  // Its tip on a plate: in contact as soon as the path is below the plane.
  write_text(place / "path.tsv", "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0.01\n0.001\t0\t0\t-0.001\n");
  ASSERT_EQ(
      asperity({"render", "--model", "pd_gradient", "--stimulus", "plane:0.02,0.02", "--tool",
                place / "ball.mesh", "--path", place / "path.tsv", "--out", place / "forces.tsv"})
          .status,
      0);
  const Tsv forces = tsv(text_of(place / "forces.tsv"));
  EXPECT_NEAR(number_in(forces.column("penetration_m").back()).value(), 0.001, 0.0005);
}

TEST(Bake, ClosesAWideHoleWhenItIsAskedTo) {
  const TemporaryFolder place{};
  TriangleMesh open = original();
  std::erase_if(open.triangles, [&](const auto& t) { return open.vertices_m[t[0]].z > 10.0; });
  write_text(place / "cup.ply", ply_of(open));
  std::vector<std::string> arguments{"bake", place / "cup.ply", "--triangles",
                                     "100",  "--out",           place / "cup.mesh"};
  const Outcome refused = asperity(arguments);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("not closed"));
  arguments.insert(arguments.end(), {"--fill-holes-m", "0.1"});
  const Outcome outcome = asperity(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Holes closed"));
}

}  // namespace
}  // namespace asperity::test
