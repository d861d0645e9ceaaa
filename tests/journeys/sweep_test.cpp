// asperity sweep: rows that do not depend on the jobs, files that are gone on with, refusals.

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "results_schema/tables/table.h"
#include "tests/app/made_up_study.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> sweep_into(const fs::path& out, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"sweep", "--out", out.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

const std::vector<std::string> kSmall{"--model",  "pd_gradient", "--vary",     "probe_diameter",
                                      "--values", "0.001,0.002", "--spacings", "0.001:0.004:3"};

TEST(Sweep, HasTheSameRowsWhateverTheJobs) {
  const TemporaryFolder place{};
  std::vector<std::string> one = sweep_into(place / "one.tsv", kSmall);
  one.insert(one.end(), {"--jobs", "1"});
  std::vector<std::string> three = sweep_into(place / "three.tsv", kSmall);
  three.insert(three.end(), {"--jobs", "3"});
  const Outcome first = asperity(one);
  ASSERT_EQ(first.status, 0) << first.err;
  ASSERT_EQ(asperity(three).status, 0);
  EXPECT_EQ(text_of(place / "one.tsv"), text_of(place / "three.tsv"));
  EXPECT_EQ(text_of(place / "one.tsv.json"), text_of(place / "three.tsv.json"));
  EXPECT_THAT(first.out, HasSubstr("6 rows, constant_height"));

  const Tsv table = tsv(text_of(place / "one.tsv"));
  EXPECT_EQ(table.columns,
            (std::vector<std::string>{
                "model", "varied", "value", "spacing_m", "drag", "roughness_max_accel_m_per_s2",
                "roughness_rms_accel_m_per_s2", "roughness_fa1_m2_per_s4",
                "roughness_fa2_m2_per_s4", "roughness_pacinian_dB", "status"}));
  EXPECT_EQ(table.column("value"),
            (std::vector<std::string>{"0.001", "0.001", "0.001", "0.002", "0.002", "0.002"}));
  EXPECT_EQ(number_in(table.column("spacing_m")[1]).value(), 0.002);
  EXPECT_THAT(table.column("status"), Each("ok"));
  // A larger probe is smoother on the finest of them.
  const std::vector<std::string> greatest = table.column("roughness_max_accel_m_per_s2");
  EXPECT_GT(number_in(greatest[0]).value(), number_in(greatest[3]).value());
}

TEST(Sweep, ContinuesWithTheRowsThatAreThere) {
  const TemporaryFolder place{};
  const fs::path out = place / "sweep.tsv";
  ASSERT_EQ(asperity(sweep_into(out, kSmall)).status, 0);
  const std::string whole = text_of(out);
  // Without its last two rows, and with a number in the first that no stroke gives: it is kept.
  std::string part = whole;
  part.erase(part.rfind('\n', part.rfind('\n', part.rfind('\n') - 1) - 1) + 1);
  const std::string known = tsv(whole).column("roughness_max_accel_m_per_s2")[0];
  part.replace(part.find(known), known.size(), "123.5");
  write_text(out, part);
  ASSERT_EQ(asperity(sweep_into(out, kSmall)).status, 0);
  std::string expected = whole;
  expected.replace(expected.find(known), known.size(), "123.5");
  EXPECT_EQ(text_of(out), expected);
}

TEST(Sweep, IsDividedIntoShardsThatGatherJoins) {
  const TemporaryFolder place{};
  const std::string out = (place / "sweep.tsv").string();
  const auto shard = [&](const std::string& which) {
    std::vector<std::string> arguments = sweep_into(out, kSmall);
    arguments.insert(arguments.end(), {"--shard", which});
    return asperity(arguments);
  };
  const Outcome second = shard("2/2");
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_THAT(second.out, HasSubstr("sweep.tsv.shard-2-of-2: shard 2/2, 2 rows of 6"));
  EXPECT_THAT(shard("2/2").out, HasSubstr("already computed"));

  const std::string first_file = out + ".shard-1-of-2";
  const std::string second_file = out + ".shard-2-of-2";
  const Outcome missing = asperity({"gather", second_file, "--out", out});
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.err, HasSubstr("missing: " + first_file));
  EXPECT_FALSE(fs::exists(out));

  ASSERT_EQ(shard("1/2").status, 0);
  const std::vector<std::string> gather{"gather", first_file, second_file, "--out", out};
  const Outcome joined = asperity(gather);
  ASSERT_EQ(joined.status, 0) << joined.err;
  EXPECT_THAT(joined.out, HasSubstr("6 rows of sweep, from 2 shards"));
  const fs::path whole = place / "whole.tsv";
  ASSERT_EQ(asperity(sweep_into(whole, kSmall)).status, 0);
  EXPECT_EQ(text_of(out), text_of(whole));
  EXPECT_EQ(text_of(out + ".json"), text_of(place / "whole.tsv.json"));
  // As from a task that is repeated; and the undivided command has nothing left to compute.
  EXPECT_EQ(asperity(gather).status, 0);
  EXPECT_THAT(asperity(sweep_into(out, kSmall)).out, HasSubstr("6 rows, constant_height"));

  write_text(out, "of a user\n");
  const Outcome refused = asperity(gather);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr(out));
  EXPECT_EQ(text_of(out), "of a user\n");
}

TEST(Sweep, RefusesAShardThatIsNone) {
  const TemporaryFolder place{};
  for (const char* const wrong : {"3/2", "0/2", "2", "half"}) {
    std::vector<std::string> arguments = sweep_into(place / "sweep.tsv", kSmall);
    arguments.insert(arguments.end(), {"--shard", wrong});
    const Outcome refused = asperity(arguments);
    EXPECT_EQ(refused.status, 2) << wrong;
    EXPECT_THAT(refused.err, HasSubstr("--shard"));
    EXPECT_THAT(refused.err, HasSubstr("write K/N"));
  }
}

// So many strokes that none of the two commands can have come to the end before it is interrupted.
TEST(Sweep, KeepsWholeRowsWhenItIsInterruptedAndContinuesWithThem) {
  const TemporaryFolder place{};
  const std::vector<std::string> order{"--model",  "pd_gradient", "--vary", "applied_force",
                                       "--values", "0.5",         "--jobs", "1"};
  const auto of_spacings = [&order](const char* spacings) {
    std::vector<std::string> whole = order;
    whole.insert(whole.end(), {"--spacings", spacings});
    return whole;
  };
  const auto interrupted = [&] {
    Program program(
        {.arguments = sweep_into(place / "sweep.tsv", of_spacings("0.0005:0.008:10000"))});
    // Said when a row is there that was not there before.
    EXPECT_TRUE(program.read_until_told("sweeping: "));
    program.send(SIGINT);
    const Outcome stopped = program.finish();
    EXPECT_EQ(stopped.status, 1);
    EXPECT_THAT(stopped.err, HasSubstr("repeat the command to continue"));
    return text_of(place / "sweep.tsv");
  };
  const std::string first = interrupted();
  EXPECT_GE(tsv(first).rows.size(), 1U);
  ASSERT_TRUE(first.ends_with('\n'));
  const std::string second = interrupted();
  EXPECT_TRUE(second.starts_with(first));
  EXPECT_GT(tsv(second).rows.size(), tsv(first).rows.size());
  EXPECT_LT(tsv(second).rows.size(), 10000U);
  // The row of the first spacing, of a sweep that nobody interrupts.
  ASSERT_EQ(asperity(sweep_into(place / "short.tsv", of_spacings("0.0005:0.008:2"))).status, 0);
  EXPECT_EQ(tsv(text_of(place / "short.tsv")).rows[0], tsv(second).rows[0]);
}

// Without a file the model plays strokes over the texture of each spacing; a given file is the same at every spacing.
TEST(Sweep, TakesTheFilesOfAModelOrThoseOfTheTexture) {
  const TemporaryFolder place{};
  const std::vector<std::string> order{
      "--model",         "recorded", "--vary", "exploratory_speed", "--drag",
      "constant_height", "--values", "0.06",   "--spacings",        "0.001:0.004:2"};
  const auto accelerations = [&](const fs::path& out, const std::vector<std::string>& more) {
    std::vector<std::string> whole = sweep_into(out, order);
    whole.insert(whole.end(), more.begin(), more.end());
    const Outcome outcome = asperity(whole);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return tsv(text_of(out)).column("roughness_rms_accel_m_per_s2");
  };
  const auto of_texture = accelerations(place / "texture.tsv", {});
  ASSERT_EQ(of_texture.size(), 2U);
  EXPECT_NE(of_texture[0], of_texture[1]);
  EXPECT_THAT(text_of(place / "texture.tsv.json"), Not(HasSubstr("assets_sha256")));

  ASSERT_EQ(asperity({"synth", "sinusoid", "--param", "spacing_m=0.002", "--width-m", "0.04",
                      "--pixels", "512", "--out", (place / "wave.png").string()})
                .status,
            0);
  const std::string recording = (place / "wave.tsv").string();
  const Outcome recorded = asperity(
      {"texture-recording", "--relief", (place / "wave.png").string(), "--out", recording});
  ASSERT_EQ(recorded.status, 0) << recorded.err;
  const auto of_file = accelerations(place / "file.tsv", {"--asset", "recording=" + recording});
  ASSERT_EQ(of_file.size(), 2U);
  EXPECT_NE(of_file[0], of_texture[0]);
  EXPECT_NE(of_file[1], of_texture[1]);
  EXPECT_THAT(text_of(place / "file.tsv.json"), HasSubstr("\"assets_sha256\""));

  // What differs between spacings is the phase of the file, which has no greatest value.
  std::vector<std::string> four =
      sweep_into(place / "four.tsv", {"--model", "recorded", "--vary", "exploratory_speed",
                                      "--drag", "constant_height", "--values", "0.06", "--spacings",
                                      "0.001:0.004:4", "--asset", "recording=" + recording});
  const Outcome fitted = asperity(four);
  ASSERT_EQ(fitted.status, 0) << fitted.err;
  EXPECT_THAT(fitted.err, HasSubstr("is the same at every spacing"));
  EXPECT_THAT(fitted.err, Not(HasSubstr("widen --spacings")));
  const Outcome refused =
      asperity(sweep_into(place / "no.tsv", {"--model", "sinusoid", "--vary", "applied_force",
                                             "--asset", "recording=" + recording}));
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("needs no asset \"recording\""));
}

TEST(Sweep, MeasuresTheTorqueOfAToolThatTurns) {
  const TemporaryFolder place{};
  const std::vector<std::string> order{
      "--model",    "pd_gradient",   "--vary",    "turning_rad", "--values",           "0.1,0.3",
      "--spacings", "0.001:0.004:3", "--measure", "rms_torque",  "--turning-radius-m", "0.01"};
  const fs::path out = place / "turning.tsv";
  const Outcome outcome = asperity(sweep_into(out, order));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("6 rows, constant_height, rms_torque"));
  const std::string whole = text_of(out);
  const Tsv table = tsv(whole);
  EXPECT_THAT(whole, HasSubstr("roughness_pacinian_dB\troughness_rms_torque_N_m\t"
                               "roughness_fa1_torque_N2_m2\troughness_fa2_torque_N2_m2\t"
                               "roughness_rms_force_N\troughness_fa1_force_N2\t"
                               "roughness_fa2_force_N2\tstatus\n"));
  for (const std::string& torque : table.column("roughness_rms_torque_N_m")) {
    EXPECT_GT(number_in(torque).value(), 1e-4);
  }
  EXPECT_THAT(text_of(place / "turning.tsv.json"), HasSubstr("\"turning_radius_m\": 0.01"));
  // The rows that are read again are those that were written.
  std::string part = whole;
  part.erase(part.rfind('\n', part.size() - 2) + 1);
  write_text(out, part);
  ASSERT_EQ(asperity(sweep_into(out, order)).status, 0);
  EXPECT_EQ(text_of(out), whole);

  // Another quantity of a tool that turns, and what has no meaning without turning.
  const Outcome fixed = asperity(sweep_into(
      place / "force.tsv", {"--model", "pd_gradient", "--vary", "applied_force", "--values", "0.5",
                            "--spacings", "0.001:0.004:2", "--turning-rad", "0.2"}));
  ASSERT_EQ(fixed.status, 0) << fixed.err;
  EXPECT_THAT(text_of(place / "force.tsv.json"), HasSubstr("\"turning_rad\": 0.2"));
  const auto refused = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"--model", "pd_gradient", "--vary", "applied_force"};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome answer = asperity(sweep_into(place / "no.tsv", all));
    EXPECT_EQ(answer.status, 2);
    return answer.err;
  };
  EXPECT_THAT(refused({"--measure", "rms_torque"}), HasSubstr("add --turning-rad or --vary"));
  EXPECT_THAT(refused({"--turning-radius-m", "0.02"}), HasSubstr("add --turning-rad or --vary"));
  EXPECT_THAT(refused({"--turning-rad", "10"}), HasSubstr("write 10 degrees as 0.1745"));
  EXPECT_FALSE(fs::exists(place / "no.tsv"));
}

TEST(Sweep, StrokesABodyWithAModelOfAPoint) {
  const TemporaryFolder place{};
  const auto rms_on = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> all{"--model",  "height_map",    "--vary",     "applied_force",
                                 "--values", "0.5",           "--spacings", "0.001:0.002:2",
                                 "--drag",   "constant_force"};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = asperity(sweep_into(place / name, all));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return number_in(tsv(text_of(place / name)).column("roughness_rms_accel_m_per_s2").front())
        .value();
  };
  const double plane = rms_on("plane.tsv", {});
  const double box = rms_on("box.tsv", {"--stimulus", "box:0.12,0.02,0.01"});
  EXPECT_NEAR(box, plane, 0.01 * plane);
  EXPECT_THAT(text_of(place / "box.tsv.json"), HasSubstr("\"body\": \"box:0.12,0.02,0.01\""));
  EXPECT_THAT(text_of(place / "plane.tsv.json"), Not(HasSubstr("\"body\"")));

  const auto refused = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"--vary", "applied_force"};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome answer = asperity(sweep_into(place / "no.tsv", all));
    EXPECT_NE(answer.status, 0);
    return answer.err;
  };
  EXPECT_THAT(refused({"--model", "pd_gradient", "--stimulus", "box:0.12,0.02,0.01"}),
              HasSubstr("leave out the body"));
  EXPECT_THAT(refused({"--model", "height_map", "--stimulus", "grain.png"}),
              HasSubstr("takes as --texture grain.png"));
  EXPECT_THAT(refused({"--model", "height_map", "--stimulus", "sphere:0.02"}),
              HasSubstr("it must be at least the length of the stroke"));
}

TEST(Sweep, SaysWhatCannotHaveAnEffect) {
  const TemporaryFolder place{};
  const Outcome outcome =
      asperity(sweep_into(place / "sweep.tsv", {"--model", "lateral_gradient", "--vary",
                                                "probe_diameter", "--spacings", "0.002:0.004:2"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("no_effect_by_construction: lateral_gradient cannot depend on "
                                     "the probe diameter"));
  const Tsv table = tsv(text_of(place / "sweep.tsv"));
  ASSERT_EQ(table.rows.size(), 6U);
  EXPECT_THAT(table.column("status"), Each("no_effect_by_construction"));
  const std::vector<std::string> greatest = table.column("roughness_max_accel_m_per_s2");
  EXPECT_GT(number_in(greatest[0]).value(), 0.0);
  EXPECT_EQ(greatest[0], greatest[2]);
  EXPECT_EQ(greatest[0], greatest[4]);
}

TEST(Sweep, ReplacesNothingOfAnotherSweep) {
  const TemporaryFolder place{};
  const fs::path out = place / "sweep.tsv";
  write_text(out, "mine\n");
  const Outcome refused = asperity(sweep_into(out, kSmall));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("use --force to replace it"));
  EXPECT_EQ(text_of(out), "mine\n");
}

TEST(Sweep, RefusesWhatMakesNoSense) {
  const TemporaryFolder place{};
  const fs::path out = place / "sweep.tsv";
  const auto outcome = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"--model", "pd_gradient", "--vary", "probe_diameter"};
    all.insert(all.end(), more.begin(), more.end());
    return asperity(sweep_into(out, all));
  };
  EXPECT_EQ(outcome({"--spacings", "0.001:0.004"}).status, 2);
  EXPECT_THAT(outcome({"--spacings", "0.001:0.004"}).err, HasSubstr("has 2 numbers instead of"));
  for (const char* count : {"40.5", "20000", "1"}) {
    EXPECT_THAT(outcome({"--spacings", "0.001:0.004:" + std::string(count)}).err,
                HasSubstr("COUNT is " + std::string(count) +
                          "; it must be a whole number from 2 to 10000"));
  }
  EXPECT_EQ(outcome({"--values", "0.001,much"}).status, 2);
  EXPECT_EQ(outcome({"--hand", "0.05,3"}).status, 2);
  EXPECT_EQ(outcome({"--texture", "sinusoid,spacing_m=0.002"}).status, 2);
  const Outcome in_millimetres = outcome({"--values", "1,2,3"});
  EXPECT_EQ(in_millimetres.status, 2);
  EXPECT_THAT(in_millimetres.err, HasSubstr("--values 1,2,3: a probe diameter is given in m"));
  EXPECT_THAT(
      outcome({"--spacings", "0.5:8:4"}).err,
      HasSubstr("--spacings 0.5:8:4: a spacing is given in m and is at most 0.1 m, not 0.5"));
  EXPECT_EQ(outcome({"--applied-force-n", "500"}).status, 2);
  EXPECT_EQ(outcome({"--values", "0"}).status, 1);
  EXPECT_EQ(outcome({"--texture", "noise"}).status, 1);
  EXPECT_EQ(outcome({"--hand", "0,3,200"}).status, 1);
  EXPECT_EQ(outcome({"--tool", "point"}).status, 1);
  EXPECT_THAT(outcome({"--tool", "sphre"}).err,
              HasSubstr("write sphere, disc, point, or the file"));
  EXPECT_EQ(outcome({"--probe-diameter-m", "0.004"}).status, 2);  // that is what is varied
  EXPECT_THAT(outcome({"--drag", "constant"}).err, HasSubstr("constant_force or constant_height"));
  EXPECT_EQ(asperity(sweep_into(
                         out, {"--model", "sinusoid", "--vary", "applied_force", "--tool", "disc"}))
                .status,
            2);
  EXPECT_THAT(asperity(sweep_into(place / "no" / "such.tsv", kSmall)).err,
              HasSubstr("there is no folder"));
  EXPECT_THAT(outcome({"--texture", "velvet"}).err, HasSubstr("There is no synthetic surface"));
  EXPECT_FALSE(fs::exists(out));
}

#ifdef ASPERITY_WITH_WINDOWS
TEST(Sweep, DrawsACurveForEveryValue) {
  const TemporaryFolder place{};
  std::vector<std::string> order = sweep_into(place / "sweep.tsv", kSmall);
  order.insert(order.end(), {"--plot", place / "sweep.svg"});
  ASSERT_EQ(asperity(order).status, 0);
  const std::string svg = text_of(place / "sweep.svg");
  EXPECT_THAT(svg, HasSubstr("<svg"));
  EXPECT_THAT(svg, HasSubstr("maximum acceleration"));
  EXPECT_EQ(asperity(order).status, 0);  // it replaces the figure that it drew itself
  std::ofstream(place / "sweep.svg") << "another drawing";
  EXPECT_EQ(asperity(order).status, 1);
  // Another measure of the rows that are there.
  order.back() = place / "powers.svg";
  order.insert(order.end(), {"--measure", "pacinian"});
  const Outcome powers = asperity(order);
  ASSERT_EQ(powers.status, 0) << powers.err;
  EXPECT_THAT(powers.out, HasSubstr("6 rows, constant_height, pacinian"));
  EXPECT_THAT(text_of(place / "powers.svg"), HasSubstr("power relative to the threshold"));
}

TEST(Sweep, RefusesAFigureThatCannotBeWrittenBeforeItBegins) {
  const TemporaryFolder place{};
  std::vector<std::string> order = sweep_into(place / "sweep.tsv", kSmall);
  order.insert(order.end(), {"--plot", place / "sweep.bmp"});
  const Outcome refused = asperity(order);
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr(".svg, .png or .pdf"));
  order.back() = place / "no" / "sweep.svg";
  EXPECT_THAT(asperity(order).err, HasSubstr("there is no folder"));
  EXPECT_FALSE(fs::exists(place / "sweep.tsv"));
}

TEST(Sweep, StandsBesideEstimatesOnlyInAFigureAndOfAStudyThatHasThem) {
  const TemporaryFolder place{};
  ASSERT_EQ(asperity({"new", place / "study"}).status, 0);
  std::vector<std::string> order = sweep_into(place / "sweep.tsv", kSmall);
  order.insert(order.end(), {"--beside", place / "study"});
  EXPECT_EQ(asperity(order).status, 2);
  order.insert(order.end(), {"--plot", place / "sweep.svg"});
  const Outcome refused = asperity(order);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("has no estimates of roughness"));
  EXPECT_FALSE(fs::exists(place / "sweep.tsv")) << "nothing was computed in vain";
}

/// Three people who gave numbers under every condition of a library protocol.
void add_estimates(MadeUpStudy& made, const std::string& name, const std::string& factor,
                   const std::vector<std::string>& conditions, const std::string& version = "1") {
  const auto library = library_protocols();
  const auto found = std::find_if(library.begin(), library.end(),
                                  [&](const LibraryProtocol& one) { return one.name == name; });
  ASSERT_NE(found, library.end());
  const std::int64_t protocol =
      made.add_protocol(name, "magnitude", std::string(found->text), version);
  for (int person = 0; person < 3; ++person) {
    const std::string label = "P" + std::to_string(protocol) + std::to_string(person);
    made.add_person(label, "F");
    std::vector<MadeUpTrial> trials{};
    double number = 1.0 + person;
    for (const std::string& condition : conditions) {
      for (const char* spacing : {"spacing_05", "spacing_10", "spacing_20", "spacing_35"}) {
        MadeUpTrial trial{};
        trial.surfaces = {surface_of("s", "pd_gradient", spacing)};
        trial.factors_json = std::string(R"({"texture": ")") + spacing + R"(", ")" + factor +
                             R"(": ")" + condition + "\"}";
        trial.answers = {text_of_number(number)};
        number = number * 1.7 > 9.0 ? number / 5.0 : number * 1.7;
        trials.push_back(trial);
      }
    }
    made.add_session(label, protocol, trials);
  }
}

TEST(Sweep, IsCheckedAgainstTheProtocolThatItStandsBesideBeforeItBegins) {
  const TemporaryFolder place{};
  MadeUpStudy made{};
  add_estimates(made, "roughness_force", "force", {"light", "medium", "firm"});
  const fs::path out = place / "sweep.tsv";
  const auto outcome = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"--model",  "pd_gradient", "--spacings", "0.0005:0.004:3",
                                 "--beside", made.folder(), "--plot",     place / "sweep.svg"};
    all.insert(all.end(), more.begin(), more.end());
    return asperity(sweep_into(out, all));
  };
  const Outcome other = outcome({"--vary", "probe_diameter"});
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr("--vary applied_force --values 0.5,1,2"));
  EXPECT_THAT(outcome({"--vary", "applied_force"}).err, HasSubstr("0.25 N is not one of them"));
  EXPECT_FALSE(fs::exists(out)) << "nothing was computed in vain";

  const std::vector<std::string> right{"--vary",  "applied_force", "--values",
                                       "2,0.5,1", "--friction",    "0.2"};
  const Outcome drawn = outcome(right);
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_THAT(drawn.err,
              HasSubstr("warning: the stiffness of the surface is 1000 N/m in the sweep"));
  EXPECT_THAT(drawn.err, testing::Not(HasSubstr("--friction")));
  const std::string svg = text_of(place / "sweep.svg");
  EXPECT_THAT(svg, HasSubstr("predicted by pd_gradient: force 0.5 N"));
  EXPECT_THAT(svg, HasSubstr("predicted by pd_gradient: force 2 N"));

  add_estimates(made, "roughness_speed", "speed", {"slow", "fast"});
  std::vector<std::string> again = right;
  again.push_back("--force");
  const Outcome unnamed = outcome(again);
  EXPECT_EQ(unnamed.status, 1);
  EXPECT_THAT(unnamed.err, HasSubstr("name one with --protocol, roughness_force, roughness_speed"));
  again.insert(again.end(), {"--protocol", "roughness_force"});
  EXPECT_EQ(outcome(again).status, 0);

  // Another version is another experiment, which nobody chooses by accident.
  add_estimates(made, "roughness_force", "force", {"light", "medium", "firm"}, "2.1.0");
  const Outcome either = outcome(again);
  EXPECT_EQ(either.status, 1);
  EXPECT_THAT(either.err, HasSubstr("2 versions of roughness_force: name one with --protocol, "
                                    "roughness_force@1, roughness_force@2.1.0"));
  for (const char* version : {"1", "2.1.0"}) {
    again.back() = std::string("roughness_force@") + version;
    const Outcome one = outcome(again);
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_THAT(one.err, HasSubstr(std::string("estimates in the figure: roughness_force ") +
                                   version + ", people, 36"));
  }
  again.back() = "roughness_force@3.0.0";
  EXPECT_THAT(outcome(again).err,
              HasSubstr("no session of roughness_force, version 3.0.0; name a version that it has: "
                        "1, 2.1.0"));
}
#endif

TEST(Sweep, SaysWhyANumberIsMissing) {
  const TemporaryFolder place{};
  std::vector<std::string> order = sweep_into(place / "two.tsv", kSmall);
  order.back() = "0.001:0.004:2";
  const Outcome two = asperity(order);
  EXPECT_EQ(two.status, 0) << two.err;
  EXPECT_THAT(two.out, HasSubstr("n/a"));
  EXPECT_THAT(two.err, HasSubstr("need at least three fitted spacings"));
}

TEST(Sweep, SaysThatNothingMovedTheToolWhereEveryStrokeWentWell) {
  const TemporaryFolder place{};
  std::vector<std::string> order = sweep_into(
      place / "sweep.tsv", {"--model", "height_map", "--vary", "applied_force", "--values", "0.5",
                            "--spacings", "0.001:0.004:3", "--drag", "constant_height"});
  const Outcome still = asperity(order);
  EXPECT_EQ(still.status, 0) << still.err;
  EXPECT_THAT(tsv(text_of(place / "sweep.tsv")).column("status"), Each("ok"));
  EXPECT_THAT(still.err, HasSubstr("not fitted: 3 rows with a complete stroke whose max_accel is "
                                   "0: the tool was not accelerated"));
  EXPECT_THAT(still.err,
              HasSubstr("height_map has none with these parameters; use --drag constant_force"));
  EXPECT_THAT(still.err, testing::Not(HasSubstr("see the column status")));
}

/// The columns of the table that the command prints, a row per value.
std::vector<std::vector<double>> printed_numbers(const std::string& out) {
  std::vector<std::vector<double>> rows{};
  std::istringstream lines(out.substr(out.find('\n', out.find('\n') + 1) + 1));
  for (std::string line{}; std::getline(lines, line);) {
    std::istringstream words(line);
    std::vector<double>& row = rows.emplace_back();
    for (std::string word{}; words >> word;) row.push_back(number_in(word).value_or(NAN));
  }
  return rows;
}

// The columns of the printed table.
constexpr std::size_t kFitted = 1;
constexpr std::size_t kGreatest = 6;
constexpr std::size_t kPeak = 7;
constexpr std::size_t kLow = 8;
constexpr std::size_t kHigh = 9;

/// The figures of docs/sweep.md: the cones, the stiffness and the forces of the library's protocols.
std::vector<std::string> firm_on_cones(const std::string& varied, const std::string& values) {
  std::vector<std::string> order{
      "--model",
      "pd_gradient",
      "--hand",
      "firm",
      "--drag",
      "constant_force",
      "--stiffness-n-per-m",
      "3000",
      "--texture",
      "cones,height_m=0.0002,top_diameter_m=0.0001,base_diameter_m=0.00045,angle_rad=0.643501",
      "--spacings",
      "0.0005:0.0035:13",
      "--measure",
      "rms_accel",
      "--vary",
      varied,
      "--values",
      values};
  if (varied != "applied_force") order.insert(order.end(), {"--applied-force-n", "0.8"});
  return order;
}

// The effects in participants [Klatzky 1999, Lederman 1999, Klatzky 2003] by one hand on one texture, without a stroke that is
// left out: the peak moves to larger spacings with diameter and with speed, and roughness rises with force at every spacing.
TEST(Sweep, OfAFirmHandOnConesHasTheThreeEffects) {
  const TemporaryFolder place{};
  const auto swept = [&](const std::string& varied, const std::string& values) {
    const fs::path out = place / (varied + ".tsv");
    const Outcome outcome = asperity(sweep_into(out, firm_on_cones(varied, values)));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    Tsv rows = tsv(text_of(out));
    EXPECT_THAT(rows.column("status"), Each("ok")) << varied;
    return std::pair(printed_numbers(outcome.out), std::move(rows));
  };
  const auto expect_disjoint = [](const std::vector<std::vector<double>>& peaks, double first_mm,
                                  double last_mm) {
    ASSERT_EQ(peaks.size(), 2U);
    EXPECT_NEAR(peaks[0][kPeak], first_mm, 0.02);
    EXPECT_NEAR(peaks[1][kPeak], last_mm, 0.02);
    EXPECT_GT(peaks[1][kLow], peaks[0][kHigh]) << "the 95 % CIs are disjoint";
  };
  expect_disjoint(swept("probe_diameter", "0.001,0.003").first, 0.88, 1.24);
  expect_disjoint(swept("exploratory_speed", "0.05,0.2").first, 0.96, 1.23);

  const Tsv rows = swept("applied_force", "0.5,2").second;
  const std::vector<std::string> rms = rows.column("roughness_rms_accel_m_per_s2");
  const std::size_t half = rms.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    const double exponent =
        std::log(number_in(rms[half + i]).value() / number_in(rms[i]).value()) / std::log(4.0);
    EXPECT_GT(exponent, 0.65) << i;
    EXPECT_LT(exponent, 1.0) << i;
  }
}

// A tool on a stiff surface bounces, if little in the hand damps it: its accelerations are those of impacts.
TEST(Sweep, LeavesOutStrokesInTheAir) {
  const TemporaryFolder place{};
  const Outcome bounced = asperity(
      sweep_into(place / "sweep.tsv", {"--model", "pd_gradient", "--vary", "exploratory_speed",
                                       "--values", "0.1", "--spacings", "0.0016:0.0034:3"}));
  ASSERT_EQ(bounced.status, 0) << bounced.err;
  const Tsv rows = tsv(text_of(place / "sweep.tsv"));
  EXPECT_THAT(rows.column("drag"), Each("constant_force"));
  EXPECT_THAT(rows.column("status"), Each("lost_contact"));
  EXPECT_THAT(rows.column("roughness_rms_accel_m_per_s2"), Each(Not("n/a")));
  EXPECT_EQ(printed_numbers(bounced.out).at(0)[kFitted], 0.0);
  EXPECT_THAT(bounced.err, HasSubstr("lost_contact: 3 rows left out, in which the tool was in the "
                                     "air for more than 5 % of the time"));
  EXPECT_THAT(bounced.err, HasSubstr("--hand firm"));
}

TEST(Sweep, TakesAHandByItsNameOrItsNumbers) {
  const TemporaryFolder place{};
  const auto declaration = [&](const std::string& name, const std::vector<std::string>& hand) {
    std::vector<std::string> order = sweep_into(place / name, kSmall);
    order.insert(order.end(), hand.begin(), hand.end());
    const Outcome outcome = asperity(order);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return text_of((place / name).string() + ".json");
  };
  EXPECT_EQ(declaration("a.tsv", {"--hand", "firm"}),
            declaration("b.tsv", {"--hand", "0.02,30,200"}));
  EXPECT_EQ(declaration("c.tsv", {"--hand", "light"}), declaration("d.tsv", {}));
  std::vector<std::string> order = sweep_into(place / "e.tsv", kSmall);
  order.insert(order.end(), {"--hand", "soft"});
  const Outcome refused = asperity(order);
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("\"soft\" is not a number; write "
                                     "M_kg,B_N_s_per_m,K_N_per_m, such as 0.05,3,200, or light, "
                                     "or firm"));
}

// At a constant height the peak does not move to larger spacings with speed.
TEST(Sweep, OfSpeedAtAConstantHeightHasPeaksThatStay) {
  const TemporaryFolder place{};
  const Outcome outcome = asperity(
      sweep_into(place / "height.tsv",
                 {"--model", "pd_gradient", "--vary", "exploratory_speed", "--values", "0.05,0.2",
                  "--drag", "constant_height", "--spacings", "0.0005:0.008:13"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(tsv(text_of(place / "height.tsv")).column("drag"), Each("constant_height"));
  const auto held = printed_numbers(outcome.out);
  EXPECT_LT(held.back()[kPeak], 1.1 * held.front()[kPeak]);
}

// Each measure has its own peak: of the same strokes the power relative to the threshold of touch, whose
// decibels are logarithms already, is greatest elsewhere than the greatest acceleration.
TEST(Sweep, PrintsThePeaksOfTheMeasureThatIsChosen) {
  const TemporaryFolder place{};
  std::vector<std::string> order =
      sweep_into(place / "sweep.tsv", {"--model", "pd_gradient", "--vary", "probe_diameter",
                                       "--values", "0.001", "--spacings", "0.0005:0.008:9"});
  const auto greatest_at_mm = [&order] {
    const Outcome outcome = asperity(order);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::istringstream last(outcome.out.substr(outcome.out.rfind('\n', outcome.out.size() - 2)));
    std::vector<std::string> words{std::istream_iterator<std::string>(last), {}};
    return words.at(kGreatest);
  };
  for (const auto& [measure, column] :
       std::map<std::string, std::string>{{"max_accel", "roughness_max_accel_m_per_s2"},
                                          {"rms_accel", "roughness_rms_accel_m_per_s2"},
                                          {"fa1", "roughness_fa1_m2_per_s4"},
                                          {"fa2", "roughness_fa2_m2_per_s4"},
                                          {"pacinian", "roughness_pacinian_dB"}}) {
    order.insert(order.end(), {"--measure", measure});
    const std::string said = greatest_at_mm();
    order.resize(order.size() - 2);
    const Tsv rows = tsv(text_of(place / "sweep.tsv"));
    std::vector<double> values{};
    for (const std::string& cell : rows.column(column)) values.push_back(number_in(cell).value());
    const auto at =
        static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
    const bool is_inside = at > 0 && at + 1 < values.size();
    EXPECT_EQ(said,
              is_inside
                  ? text_of_number(
                        std::round(1e6 * number_in(rows.column("spacing_m")[at]).value()) / 1e3)
                  : "n/a")
        << measure;
  }
}

}  // namespace
}  // namespace asperity::test
