// asperity bench: its scenes, its table, bodies that are kept, a user's mesh, refusals. No test judges a time.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results_schema/tables/table.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/stimuli/made_mesh.h"
#include "tests/stimuli/mesh_text.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// On a computer without an OpenCL driver.
Outcome bench(const TemporaryFolder& place, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "bench");
  fs::create_directories(place / "no-drivers");
  return run({.arguments = std::move(arguments),
              .environment = {{"OCL_ICD_VENDORS", (place / "no-drivers").string()}}});
}

/// The ticks of a row, those that are left out included.
std::vector<std::string> all_ticks(const Tsv& table) {
  std::vector<std::string> sums;
  const std::vector<std::string> ticks = table.column("ticks");
  const std::vector<std::string> preempted = table.column("preempted");
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    sums.push_back(text_of_number(*number_in(ticks[i]) + *number_in(preempted[i])));
  }
  return sums;
}

TEST(BenchCommand, ListsItsScenes) {
  const TemporaryFolder place{};
  const Outcome outcome = bench(place, {"--list", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::vector<std::string> names;
  const auto json = nlohmann::json::parse(outcome.out);
  for (const auto& scene : json.at("scenes")) {
    names.push_back(scene.at("name"));
  }
  EXPECT_THAT(names,
              ElementsAre("simple", "ten_contacts", "hammer", "file", "part", "comb", "plane",
                          "loop", "mesh_100k", "mesh_600k", "hung_tick", "hung_tick_busy"));
}

TEST(BenchCommand, MeasuresEveryModelOfAPointWithTheOrderedTicksAndQuotesAFigure) {
  const TemporaryFolder place{};
  const std::string out = (place / "ticks.tsv").string();
  const std::vector<std::string> arguments{"--scene",     "plane", "--scene", "mesh_100k",
                                           "--triangles", "1000",  "--ticks", "30",
                                           "--out",       out};
  const Outcome outcome = bench(place, arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Quoted p50 0.76 µs, p99 0.91 µs: CHAI3D 3.3.0"));
  const Tsv table = tsv(text_of(out));
  EXPECT_THAT(
      table.columns,
      ElementsAre("scene", "model", "evaluated_on", "device", "caches", "ticks", "preempted",
                  "p50_s", "p99_s", "maximum_s", "rate_Hz", "largest_force_N", "tool_triangles",
                  "tool_simplified_triangles", "surface_triangles", "surface_simplified_triangles",
                  "reason", "quoted", "quoted_source", "processor", "cores", "load_per_core",
                  "program", "compiler", "instruction_set"));
  EXPECT_THAT(table.column("model"), testing::IsSupersetOf({"height_map", "sinusoid", "recorded"}));
  EXPECT_THAT(table.column("model"), Each(Not("pd_gradient")));
  EXPECT_THAT(table.column("caches"), Each("warm"));
  EXPECT_THAT(table.column("reason"), Each("n/a"));
  EXPECT_THAT(all_ticks(table), Each("30"));
  // Not enough for quantiles, and too soon for a force.
  for (const char* column : {"p50_s", "p99_s", "rate_Hz", "largest_force_N"}) {
    EXPECT_THAT(table.column(column), Each("n/a")) << column;
  }
  EXPECT_THAT(table.column("maximum_s"), Each(Not("n/a")));
  EXPECT_THAT(outcome.out,
              HasSubstr("; a median, a 99th percentile and a rate need at least 100 counted ticks: "
                        "increase --ticks and --seconds."));
  // The figure is that of a point.
  const auto models = table.column("model");
  const auto quoted = table.column("quoted");
  for (std::size_t i = 0; i < models.size(); ++i) {
    const bool is_soft = models[i] == "elastic_halfspace" || models[i] == "winkler";
    EXPECT_EQ(quoted[i] == "n/a", is_soft) << table.column("scene")[i] << ' ' << models[i];
  }
  EXPECT_EQ(bench(place, arguments).status, 1);  // the table exists
}

TEST(BenchCommand, MeasuresTheWholeTickOfASession) {
  const TemporaryFolder place{};
  const Outcome outcome = bench(place, {"--scene", "loop", "--ticks", "300", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto rows = nlohmann::json::parse(outcome.out).at("rows");
  EXPECT_GT(rows.size(), 10U);
  for (const auto& row : rows) {
    EXPECT_EQ(row.at("reason"), nullptr) << row;
    EXPECT_GT(row.at("largest_force_N"), 0.5) << row;  // of a hand that presses with about 1 N
  }
}

TEST(BenchCommand, MeasuresForHowLongATickThatDoesNotReturnExertsItsForce) {
  const TemporaryFolder place{};
  const Outcome outcome =
      bench(place, {"--scene", "hung_tick", "--scene", "hung_tick_busy", "--ticks", "3", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto rows = nlohmann::json::parse(outcome.out).at("rows");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    EXPECT_GT(row.at("maximum_s"), 0.05) << row;  // a shorter stall is no fault
    EXPECT_EQ(row.at("rate_Hz"), nullptr) << row;
  }
}

TEST(BenchCommand, MeasuresWithColdCachesOnRequest) {
  const TemporaryFolder place{};
  const std::string out = (place / "ticks.tsv").string();
  const Outcome outcome =
      bench(place, {"--scene", "plane", "--ticks", "2", "--cold-caches", "--out", out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Cold caches: other data were written before each tick."));
  EXPECT_THAT(tsv(text_of(out)).column("caches"), Each("cold"));
}

TEST(BenchCommand, StatesWhyTheGpuIsNotMeasuredAndKeepsTheBodies) {
  const TemporaryFolder place{};
  const std::string out = (place / "ticks.tsv").string();
  const std::vector<std::string> arguments{"--scene", "simple",   "--triangles",   "1000",
                                           "--ticks", "100",      "--out",         out,
                                           "--force", "--bodies", place / "bodies"};
  const Outcome outcome = bench(place, arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("simplifying ball"));
  const Tsv table = tsv(text_of(out));
  EXPECT_THAT(table.column("evaluated_on"), ElementsAre("cpu", "gpu"));
  EXPECT_THAT(all_ticks(table), ElementsAre("100", "0"));
  EXPECT_THAT(table.column("reason"),
              ElementsAre("n/a", HasSubstr("has no OpenCL device with double precision; install")));
  EXPECT_THAT(table.column("p99_s")[1], "n/a");
  EXPECT_THAT(table.column("tool_simplified_triangles"), Each("600"));
  EXPECT_THAT(table.column("quoted"), Each("0.5 kHz"));
  EXPECT_GT(number_in(table.column("largest_force_N")[0]).value(), 0.01);

  const Outcome again = bench(place, arguments);
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.err, Not(HasSubstr("simplifying")));
  EXPECT_EQ(tsv(text_of(out)).column("surface_triangles"), table.column("surface_triangles"));

  fs::copy_file(place / "bodies" / "ball-1000.mesh", place / "bodies" / "block-1000.mesh",
                fs::copy_options::overwrite_existing);
  const Outcome refused = bench(place, arguments);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("block-1000.mesh: the textured mesh was made from another"));
}

TEST(BenchCommand, MeasuresAMeshOfTheUserOverTheBlock) {
  const TemporaryFolder place{};
  write_text(place / "ball.obj", obj_of(bumpy_ball(3, 6.0, 0.2, 9.0)));  // in millimetres
  const Outcome outcome = bench(
      place, {"--mesh", place / "ball.obj", "--triangles", "1000", "--ticks", "10", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto rows = nlohmann::json::parse(outcome.out).at("rows");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("scene"), "ball.obj");
  EXPECT_EQ(rows[0].at("tool_triangles"), 512);
  EXPECT_EQ(rows[0].at("quoted"), nullptr);
  EXPECT_EQ(rows[0].at("reason"), nullptr);
}

TEST(BenchCommand, MeasuresATexturedMeshOfTheUserAsItIs) {
  const TemporaryFolder place{};
  write_text(place / "ball.obj", obj_of(bumpy_ball(3, 6.0, 0.2, 9.0)));
  const Outcome baked =
      asperity({"bake", place / "ball.obj", "--triangles", "200", "--out", place / "ball.mesh"});
  ASSERT_EQ(baked.status, 0) << baked.err;
  const Outcome outcome = bench(
      place, {"--mesh", place / "ball.mesh", "--triangles", "1000", "--ticks", "100", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto row = nlohmann::json::parse(outcome.out).at("rows").at(0);
  EXPECT_EQ(row.at("scene"), "ball.mesh");
  EXPECT_EQ(row.at("tool_simplified_triangles"), 200);
  EXPECT_EQ(row.at("reason"), nullptr);
  EXPECT_GT(row.at("largest_force_N"), 0.01);
}

TEST(BenchCommand, RefusesAnUnknownSceneAndABrokenMesh) {
  const TemporaryFolder place{};
  const Outcome unknown = bench(place, {"--scene", "anvil"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.err, HasSubstr("\"anvil\" is not permitted; write simple, ten_contacts, "
                                     "hammer, file, part, comb, plane, loop, mesh_100k, mesh_600k, "
                                     "hung_tick or hung_tick_busy"));
  write_text(place / "broken.obj", "v 0 0 0\nf 1 2 3\n");
  const Outcome broken = bench(place, {"--mesh", place / "broken.obj", "--scene", "plane"});
  EXPECT_EQ(broken.status, 1);
  EXPECT_THAT(broken.err, HasSubstr((place / "broken.obj").string()));
  EXPECT_THAT(broken.err, Not(HasSubstr("measuring")));
}

}  // namespace
}  // namespace asperity::test
