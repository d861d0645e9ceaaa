// render with two bodies: shapes and meshes against each other along a path, through the real program.

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results_schema/tables/table.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/stimuli/made_mesh.h"
#include "tests/stimuli/mesh_text.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

constexpr double kStiffness_N_per_m = 500.0;  // of the Material, unless it is said

struct Sample {
  double x_m = 0.0;
  double z_m = 0.0;
  double turn_about_y_rad = 0.0;
};

/// From above down to each of the samples, 1 ms apart.
std::string path_through(const std::vector<Sample>& samples) {
  std::string path = "time_s\tx_m\ty_m\tz_m\tqw\tqx\tqy\tqz\n";
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& at = samples[i];
    path += text_of_number(0.001 * static_cast<double>(i)) + '\t' + text_of_number(at.x_m) +
            "\t0\t" + text_of_number(at.z_m) + '\t' +
            text_of_number(std::cos(0.5 * at.turn_about_y_rad)) + "\t0\t" +
            text_of_number(std::sin(0.5 * at.turn_about_y_rad)) + "\t0\n";
  }
  return path;
}

class RenderBodies : public testing::Test {
 protected:
  Outcome render(const std::vector<Sample>& samples, const std::vector<std::string>& more) {
    write_text(place_ / "path.tsv", path_through(samples));
    std::vector<std::string> arguments{"render",
                                       "--model",
                                       "pd_gradient",
                                       "--path",
                                       place_ / "path.tsv",
                                       "--out",
                                       place_ / "forces.tsv",
                                       "--friction",
                                       "0",
                                       "--force"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return asperity(arguments);
  }
  /// The row of the last sample.
  double last(const std::string& column) const {
    return number_in(tsv(text_of(place_ / "forces.tsv")).column(column).back()).value();
  }

  TemporaryFolder place_{};
};

// δ of a ball of radius R whose middle is at z is R − z, and the force k·δ along z.
TEST_F(RenderBodies, ABallOnAPlateIsASpring) {
  const Outcome outcome = render({{.z_m = 0.0035}, {.z_m = 0.0028}, {.z_m = 0.0026}},
                                 {"--stimulus", "plane:0.02,0.02", "--tool", "sphere:0.006"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Tsv forces = tsv(text_of(place_ / "forces.tsv"));
  EXPECT_EQ(number_in(forces.column("fz_N").front()), 0.0);
  EXPECT_EQ(number_in(forces.column("penetration_m").front()), 0.0);
  EXPECT_NEAR(last("penetration_m"), 0.0004, 4e-6);
  EXPECT_NEAR(last("fz_N"), kStiffness_N_per_m * 0.0004, 0.004);
  EXPECT_NEAR(last("fx_N"), 0.0, 0.002);
}

// The driver that the tests install computes on the processor; it is named, and finds the depth of the closed form.
TEST_F(RenderBodies, ComputesContactsOnADevice) {
  const std::vector<Sample> samples{{.z_m = 0.0035}, {.z_m = 0.0028}, {.z_m = 0.0026}};
  const Outcome outcome = render(
      samples, {"--stimulus", "plane:0.02,0.02", "--tool", "sphere:0.006", "--compute", "gpu"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("Computed by "));
  EXPECT_THAT(outcome.err, HasSubstr(", driver "));
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("no_compute")));
  EXPECT_NEAR(last("penetration_m"), 0.0004, 4e-6);
  EXPECT_NEAR(last("fz_N"), kStiffness_N_per_m * 0.0004, 0.004);
  write_text(place_ / "path.tsv", path_through(samples));
  const Outcome point = asperity({"render", "--model", "sinusoid", "--path", place_ / "path.tsv",
                                  "--out", place_ / "forces.tsv", "--force", "--compute", "gpu"});
  EXPECT_EQ(point.status, 1);
  EXPECT_THAT(point.err, HasSubstr("--compute gpu needs a model with two bodies"));
}

// The ball sinks until both springs have the same force: the tool is above the device by F/k_t.
TEST_F(RenderBodies, TheToolOfAVirtualCouplingHasATableWithItsPose) {
  std::vector<Sample> samples(600, Sample{.z_m = 0.0026});
  samples.front().z_m = 0.0035;
  const Outcome outcome =
      render(samples, {"--stimulus", "plane:0.02,0.02", "--tool", "sphere:0.006", "--coupling",
                       "virtual", "--tool-out", place_ / "tool.tsv"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string text = text_of(place_ / "tool.tsv");
  EXPECT_TRUE(
      text.starts_with("time_s\tx_m\ty_m\tz_m\tqw\tqx\tqy\tqz\trx_rad\try_rad\trz_rad\t"
                       "fx_N\tfy_N\tfz_N\ttx_N_m\tty_N_m\ttz_N_m\tpenetration_m\n"));
  const Tsv tool = tsv(text);
  ASSERT_EQ(tool.rows.size(), samples.size());
  EXPECT_EQ(tool.column("fz_N"), tsv(text_of(place_ / "forces.tsv")).column("fz_N"));
  const double z_m = number_in(tool.column("z_m").back()).value();
  EXPECT_NEAR(last("fz_N"), 1000.0 * (z_m - 0.0026), 1e-4);
  EXPECT_NEAR(z_m, 0.003 - last("fz_N") / kStiffness_N_per_m, 1e-5);
  // Without a coupling the tool is where the path is.
  ASSERT_EQ(render({{.z_m = 0.0035}, {.z_m = 0.0028, .turn_about_y_rad = 0.3}},
                   {"--stimulus", "plane:0.02,0.02", "--tool", "sphere:0.006", "--tool-out",
                    place_ / "tool.tsv"})
                .status,
            0);
  const Tsv direct = tsv(text_of(place_ / "tool.tsv"));
  EXPECT_EQ(direct.column("z_m").back(), "0.0028");
  EXPECT_NEAR(number_in(direct.column("ry_rad").back()).value(), 0.3, 1e-9);
}

#ifdef ASPERITY_WITH_WINDOWS
TEST_F(RenderBodies, DrawsColumnsOfTheTool) {
  const std::vector<Sample> samples{{.z_m = 0.0035}, {.z_m = 0.0028}, {.z_m = 0.0026}};
  std::vector<std::string> order{"--stimulus", "plane:0.02,0.02",    "--tool",   "sphere:0.006",
                                 "--plot",     place_ / "force.svg", "--plot-x", "z_m",
                                 "--plot-y",   "fx_N,fz_N"};
  const Outcome outcome = render(samples, order);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(text_of(place_ / "force.svg"), HasSubstr("fx, fz (N)"));
  const auto refused = [&](const std::string& columns) {
    order.back() = columns;
    const Outcome answer = render(samples, order);
    EXPECT_EQ(answer.status, 2);
    return answer.err;
  };
  EXPECT_THAT(refused("fx_N,tz_N_m"), HasSubstr("--plot: the columns fx_N and tz_N_m have"));
  EXPECT_THAT(refused("f_N"), HasSubstr("there is no column \"f_N\"; write one of time_s, x_m"));
}

// A program that was killed between the two leaves the figure: the same command completes it, another one does not.
TEST_F(RenderBodies, AreCompletedWithTheirFigureByTheSameCommandOnly) {
  const auto render_anew = [this](double z_m) {
    write_text(place_ / "path.tsv", path_through({{.z_m = 0.0035}, {.z_m = 0.0028}, {.z_m = z_m}}));
    return asperity({"render", "--model", "pd_gradient", "--stimulus", "plane:0.02,0.02", "--tool",
                     "sphere:0.006", "--path", place_ / "path.tsv", "--out", place_ / "forces.tsv",
                     "--tool-out", place_ / "tool.tsv", "--plot", place_ / "force.svg"});
  };
  ASSERT_EQ(render_anew(0.0026).status, 0);
  const std::string forces = text_of(place_ / "forces.tsv");
  fs::remove(place_ / "forces.tsv");
  const Outcome other = render_anew(0.0025);
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr("tool.tsv already exists; use --force to replace it"));
  EXPECT_FALSE(fs::exists(place_ / "forces.tsv"));
  const Outcome again = render_anew(0.0026);
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(text_of(place_ / "forces.tsv"), forces);
  const Outcome complete = render_anew(0.0026);
  EXPECT_EQ(complete.status, 1);
  EXPECT_THAT(complete.err, HasSubstr("forces.tsv already exists"));
}
#endif

TEST_F(RenderBodies, NamesAModelThatIsNearlyCalledThat) {
  const Outcome outcome = asperity(
      {"render", "--model", "pd_gradiant", "--path", "path.tsv", "--out", place_ / "forces.tsv"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean \"pd_gradient\"?"));
  const Outcome sweep = asperity(
      {"sweep", "--model", "wool", "--vary", "applied_force", "--out", place_ / "sweep.tsv"});
  EXPECT_EQ(sweep.status, 1);
  EXPECT_THAT(sweep.err, HasSubstr("\"pd_gradient\""));
}

TEST_F(RenderBodies, SaysWhenThePathBeginsWhollyInside) {
  const std::vector<std::string> bodies{"--stimulus", "box:0.02,0.02,0.02", "--tool",
                                        "sphere:0.006"};
  const Outcome inside = render({{.z_m = 0.0}, {.z_m = -0.0001}}, bodies);
  EXPECT_EQ(inside.status, 0);
  EXPECT_THAT(inside.err, HasSubstr("wholly_inside, number of ticks: 2 of 2"));
  EXPECT_THAT(inside.err, HasSubstr("no force; begin the path outside the surface"));
  EXPECT_EQ(last("fz_N"), 0.0);
  const Outcome above = render({{.z_m = 0.0135}, {.z_m = 0.0128}}, bodies);
  EXPECT_GT(last("fz_N"), 0.0);
  EXPECT_THAT(above.err, testing::Not(HasSubstr("wholly_inside")));
}

// Upright the rod of 8 mm ends above the plate while its middle is above 4 mm; on its side, above 3 mm.
TEST_F(RenderBodies, OrientationsOfThePathTurnTheTool) {
  const std::vector<std::string> bodies{"--stimulus", "plane:0.02,0.02", "--tool",
                                        "cylinder:0.006,0.008"};
  ASSERT_EQ(render({{.z_m = 0.02}, {.z_m = 0.0042}}, bodies).status, 0);
  EXPECT_EQ(last("fz_N"), 0.0);
  constexpr double kQuarter_rad = 0.5 * std::numbers::pi;
  ASSERT_EQ(render({{.z_m = 0.0042, .turn_about_y_rad = kQuarter_rad},
                    {.z_m = 0.0027, .turn_about_y_rad = kQuarter_rad}},
                   bodies)
                .status,
            0);
  EXPECT_NEAR(last("penetration_m"), 0.0003, 5e-6);
  EXPECT_GT(last("fz_N"), 0.1);
}

TEST_F(RenderBodies, AHeightFieldLiesOnThePlateWhereItsSamplesAre) {
  ASSERT_EQ(asperity({"synth", "sinusoid", "--param", "amplitude_m=0.0002", "spacing_m=0.005",
                      "--pixels", "64", "--width-m", "0.02", "--out", place_ / "wave.png"})
                .status,
            0);
  // A ball of 2 mm over the crest at x = 1.25 mm and over the trough at 3.75 mm, its lowest point 0.3 mm
  // below the plane: the crest is 0.2 mm above it, and a trough that much below.
  const auto depth_at = [this](double x_m) {
    const Outcome outcome =
        render({{x_m, 0.002}, {x_m, 0.0007}},
               {"--stimulus", "plane:" + (place_ / "wave.png").string(), "--tool", "sphere:0.002"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return last("penetration_m");
  };
  EXPECT_NEAR(depth_at(0.00125), 0.0005, 2e-5);
  EXPECT_NEAR(depth_at(0.00375), 0.0001, 3e-5);
}

TEST_F(RenderBodies, TakesMeshesThatWereBakedInTheirOwnFrame) {
  write_text(place_ / "ball.obj", obj_of(bumpy_ball(4, 20.0, 0.5, 9.0)));
  ASSERT_EQ(
      asperity({"bake", place_ / "ball.obj", "--triangles", "200", "--out", place_ / "ball.mesh"})
          .status,
      0);
  // The ball's radius is 20 mm, its bumps 0.5 mm; a ball of 3 mm over it, 1 mm in.
  const Outcome outcome = render({{.z_m = 0.030}, {.z_m = 0.0225}},
                                 {"--stimulus", place_ / "ball.mesh", "--tool", "sphere:0.006"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NEAR(last("penetration_m"), 0.0005, 0.0006);
  EXPECT_GT(last("fz_N"), 0.0);
}

TEST_F(RenderBodies, WithoutACouplingThePathIsTheToolsOwn) {
  const std::vector<std::string> bodies{"--stimulus", "plane:0.02,0.02", "--tool", "sphere:0.006"};
  const std::vector<Sample> down{
      {.z_m = 0.0032}, {.z_m = 0.0030}, {.z_m = 0.0028}, {.z_m = 0.0026}};
  const auto force_with = [&](std::vector<std::string> more) {
    more.insert(more.end(), bodies.begin(), bodies.end());
    EXPECT_EQ(render(down, more).status, 0);
    return last("fz_N");
  };
  const double none_N = force_with({});
  EXPECT_EQ(force_with({"--coupling", "none"}), none_N);
  EXPECT_EQ(force_with({"--param", "coupling=none"}), none_N);
  const double coupled_N = force_with({"--coupling", "virtual"});
  EXPECT_NE(coupled_N, none_N);
  EXPECT_EQ(force_with({"--param", "coupling=virtual"}), coupled_N);
}

TEST_F(RenderBodies, SaysWhatIsMissingOrWrong) {
  const std::vector<Sample> down{{.z_m = 0.01}, {.z_m = 0.009}};
  const auto refused = [&](const std::vector<std::string>& more,
                           const std::vector<std::string>& words) {
    const Outcome outcome = render(down, more);
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_FALSE(fs::exists(place_ / "forces.tsv"));
    for (const std::string& word : words) EXPECT_THAT(outcome.err, HasSubstr(word));
  };
  refused({}, {"needs a surface", "--stimulus"});
  refused({"--stimulus", "plane:0.02,0.02"}, {"needs a tool", "sphere:D_m"});
  refused({"--stimulus", "sphere", "--tool", "sphere:0.01"},
          {"--stimulus sphere states no size", "sphere:[FILE.png,]D_m", "metres"});
  refused({"--stimulus", "plane:0.02,0.02", "--tool", "cylinder"}, {"D_m,L_m"});
  refused({"--stimulus", "plane:0.02", "--tool", "sphere:0.01"},
          {"--stimulus plane:0.02", "plane:[FILE.png,]X_m,Y_m"});
  refused({"--stimulus", "box:1,2", "--tool", "sphere:0.01"}, {"box:[FILE.png,]X_m,Y_m,Z_m"});
  refused({"--stimulus", "plane:0.02,0.02", "--tool", "sphere:0"}, {"sphere:0", "above 0"});
  refused({"--stimulus", "plane:0.02,0.02", "--tool", "cylinder:0.01"},
          {"cylinder:[FILE.png,]D_m,L_m"});
  refused({"--stimulus", place_ / "none.mesh", "--tool", "sphere:0.01"}, {"none.mesh"});
  write_text(place_ / "text.mesh", "a list of groceries\n");
  refused({"--stimulus", place_ / "text.mesh", "--tool", "sphere:0.01"}, {"text.mesh"});
  refused({"--stimulus", "plane:0.02,0.02", "--tool", "disc:0.01", "--coupling", "virtual",
           "--param", "coupling=none"},
          {"--coupling", "give one of them"});
}

TEST_F(RenderBodies, AModelOfAPointTakesOneBodyWithoutATool) {
  write_text(place_ / "path.tsv", path_through({{.z_m = 0.001}, {.z_m = 0.0}}));
  const auto refused = [this](std::vector<std::string> more, const std::string& words) {
    std::vector<std::string> arguments{"render",
                                       "--model",
                                       "height_map",
                                       "--path",
                                       place_ / "path.tsv",
                                       "--out",
                                       place_ / "forces.tsv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = asperity(arguments);
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(words));
  };
  refused({"--stimulus", "sphere:0.01"}, "give one with --height-field FILE.png");
  refused({"--height-field", place_ / "grating.png"}, "give the body with --stimulus");
  refused({"--tool", "sphere:0.01"}, "--tool needs a model with two bodies");
  refused({"--coupling", "none"}, "--coupling needs a model with two bodies");
}

}  // namespace
}  // namespace asperity::test
