// What works without a study: surfaces, photographs, models, forces along a path, protocols.

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results_schema/tables/table.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using Json = nlohmann::json;

std::vector<double> numbers(const Tsv& table, const std::string& column) {
  std::vector<double> values{};
  for (const std::string& cell : table.column(column)) values.push_back(number_in(cell).value());
  return values;
}

std::string number(double value) { return text_of_number(value); }

/// Renders `path` and returns the forces.
Tsv forces_along(const fs::path& place, const std::string& path,
                 const std::vector<std::string>& more) {
  write_text(place / "path.tsv", path);
  std::vector<std::string> arguments{
      "render", "--path", place / "path.tsv", "--out", place / "forces.tsv", "--force"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = asperity(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return tsv(text_of(place / "forces.tsv"));
}

TEST(Synth, StatesHeightsBelowZeroWithAMinusSign) {
  const TemporaryFolder place{};
  const Outcome made = asperity({"synth", "sinusoid", "--param", "amplitude_m=0.0001", "--pixels",
                                 "64", "--width-m", "0.02", "--out", place / "wave.png"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, testing::HasSubstr(" µm, height −"));
}

// 2 nm/√2 is 1.41 nm.
TEST(Synth, StatesAReliefOfNanometresWithItsDigits) {
  const TemporaryFolder place{};
  const Outcome made = asperity({"synth", "sinusoid", "--param", "amplitude_m=2e-9", "--pixels",
                                 "64", "--width-m", "0.02", "--out", place / "wave.png"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, testing::HasSubstr("RMS 0.00141 µm\n"));
}

TEST(Render, OfAFlatFieldIsASpringWithFriction) {
  const TemporaryFolder place{};
  ASSERT_EQ(asperity({"synth", "sinusoid", "--param", "amplitude_m=0", "--pixels", "64",
                      "--width-m", "0.02", "--out", place / "flat.png"})
                .status,
            0);
  // Along +x at 60 mm/s, 1 mm deep, then above the surface.
  const Tsv forces = forces_along(
      place.path(),
      "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t-0.001\n0.001\t0.00006\t0\t-0.001\n"
      "0.002\t0.00012\t0\t-0.001\n0.003\t0.00018\t0\t0.001\n0.004\t0.00024\t0\t0.001\n",
      {"--model", "height_map", "--param", "friction_law=rounded", "--stimulus",
       place / "flat.png"});
  EXPECT_EQ(forces.columns, (std::vector<std::string>{"time_s", "fx_N", "fy_N", "fz_N", "tx_N_m",
                                                      "ty_N_m", "tz_N_m", "penetration_m"}));
  ASSERT_EQ(forces.rows.size(), 5U);
  EXPECT_EQ(forces.column("time_s"),
            (std::vector<std::string>{"0", "0.001", "0.002", "0.003", "0.004"}));
  // F_n = k w = 500 N/m · 1 mm; friction −μ F_n v/√(v² + v₀²), v₀ = 10 mm/s.
  const double friction_N = 0.2 * 0.5 * 0.06 / std::hypot(0.06, 0.01);
  EXPECT_NEAR(numbers(forces, "fz_N")[1], 0.5, 1e-12);
  EXPECT_NEAR(numbers(forces, "fx_N")[1], -friction_N, 1e-9);
  EXPECT_EQ(forces.column("fy_N")[1], "0");
  EXPECT_NEAR(numbers(forces, "penetration_m")[1], 0.001, 1e-15);
  EXPECT_EQ(forces.column("fz_N")[4], "0");
  EXPECT_EQ(forces.column("fx_N")[4], "0");
}

TEST(Render, OfASinusoidFollowsItsHeights) {
  const TemporaryFolder place{};
  constexpr double kAmplitude_m = 2e-4;
  constexpr double kSpacing_m = 2e-3;
  constexpr double kPitch_m = 0.02 / 128;
  ASSERT_EQ(asperity({"synth", "sinusoid", "--param", "amplitude_m=0.0002", "spacing_m=0.002",
                      "--pixels", "128", "--width-m", "0.02", "--out", place / "wave.png"})
                .status,
            0);
  // On samples, where nothing is interpolated: half a pitch beside the centre and whole ones on.
  std::string path = "time_s\tx_m\ty_m\tz_m\n";
  std::vector<double> x_m{};
  for (int i = 0; i < 6; ++i) {
    x_m.push_back((i - 2.5) * kPitch_m);
    path += number(i * 0.001) + '\t' + number(x_m.back()) + '\t' + number(0.5 * kPitch_m) +
            "\t-0.001\n";
  }
  const Tsv forces =
      forces_along(place.path(), path,
                   {"--model", "height_map", "--stimulus", "plane:" + (place / "wave.png").string(),
                    "--friction", "0", "--stiffness-n-per-m", "800"});
  const std::vector<double> normal_N = numbers(forces, "fz_N");
  for (std::size_t i = 0; i < x_m.size(); ++i) {
    const double height_m = kAmplitude_m * std::sin(2.0 * std::numbers::pi * x_m[i] / kSpacing_m);
    // 16 bits over 0.4 mm are steps of 6 nm, which are 5 µN here.
    EXPECT_NEAR(normal_N[i], 800.0 * (0.001 + height_m), 1e-5) << i;
  }
}

// A tick of 1 ms is 0.001 s, and so is its thousandfold: no 1.1980000000000002.
TEST(Render, WritesTheTimesThatWereAskedFor) {
  const TemporaryFolder place{};
  std::string path = "time_s\tx_m\ty_m\tz_m\n";
  std::vector<std::string> times{};
  for (int tick = 0; tick < 2000; ++tick) {
    std::string digits = std::to_string(1000 + tick % 1000).substr(1);
    while (!digits.empty() && digits.back() == '0') digits.pop_back();
    times.push_back(std::to_string(tick / 1000) + (digits.empty() ? "" : '.' + digits));
    path += times.back() + "\t0\t0\t0\n";
  }
  const Tsv forces = forces_along(place.path(), path, {"--model", "sinusoid"});
  EXPECT_EQ(forces.column("time_s"), times);
}

TEST(Render, SaysWhatIsWrongWithAPath) {
  const TemporaryFolder place{};
  const auto refused = [&place](const std::string& path, const std::vector<std::string>& words) {
    write_text(place / "path.tsv", path);
    const Outcome outcome = asperity({"render", "--model", "sinusoid", "--path", place / "path.tsv",
                                      "--out", place / "forces.tsv"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_FALSE(fs::exists(place / "forces.tsv"));
    EXPECT_NE(outcome.err.find("path.tsv"), std::string::npos) << outcome.err;
    for (const std::string& word : words) {
      EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " in " << outcome.err;
    }
  };
  refused("", {});
  refused("time_s\tx_m\ty_m\n0\t0\t0\n1\t0\t0\n", {"z_m"});
  refused("time_s\tx_m\ty_m\tz_mm\n0\t0\t0\t0\n1\t0\t0\t0\n", {"z_mm", "z_m"});
  refused("time_s\tx_m\ty_m\tz_m\tqw\n0\t0\t0\t0\t1\n1\t0\t0\t0\t1\n", {"qx qy qz"});
  refused("time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0\n", {"two rows"});
  refused("time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0\n0\t0\t0\t0\n", {":3:", "increase"});
  refused("time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0\n1\t0\tdeep\t0\n", {":3:", "y_m"});
  refused("time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0\n1\t0\t0\tn/a\n", {":3:", "z_m"});
  refused("time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0\n1\t0\t0\n", {":3"});
}

// Half a millimetre, written in a column of metres.
TEST(Render, WarnsOfAPathInMillimetres) {
  const TemporaryFolder place{};
  const auto warning_of = [&place](const std::string& depth_m) {
    write_text(place / "path.tsv",
               "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t" + depth_m + "\n0.001\t0\t0\t" + depth_m + "\n");
    const Outcome outcome = asperity({"render", "--model", "sinusoid", "--path", place / "path.tsv",
                                      "--out", place / ("forces" + depth_m + ".tsv")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(warning_of("-0.5"),
              testing::AllOf(testing::HasSubstr("asperity: warning: "),
                             testing::HasSubstr("path.tsv: z_m reaches -0.5 m"),
                             testing::HasSubstr("if the positions are in millimetres, divide them "
                                                "by 1000")));
  EXPECT_THAT(warning_of("-0.0005"), testing::Not(testing::HasSubstr("millimetres")));
}

TEST(Render, RefusesAModelOrParameterThatThereIsNot) {
  const TemporaryFolder place{};
  write_text(place / "path.tsv", "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0\n1\t0\t0\t0\n");
  const auto refused = [&place](std::vector<std::string> more, const std::string& word,
                                int status = 1) {
    std::vector<std::string> arguments{"render", "--path", place / "path.tsv", "--out",
                                       place / "forces.tsv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = asperity(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " in " << outcome.err;
    EXPECT_FALSE(fs::exists(place / "forces.tsv"));
  };
  refused({"--model", "velvet"}, "height_map");
  refused({"--model", "sinusoid", "--param", "amplitude=1"}, "amplitude_m");
  refused({"--model", "sinusoid", "--param", "amplitude_m=1"}, "0.005");
  refused({"--model", "sinusoid", "--param", "amplitude_m=0.001", "amplitude_m=0.002"},
          "amplitude_m is given twice");
  refused({"--model", "sinusoid", "--param", "amplitude_m=0,001"}, "0,001");
  refused({"--model", "height_map"}, "height field");
  refused({"--model", "height_map", "--stimulus", place / "nowhere.png"}, "nowhere.png");
  refused({"--model", "sinusoid", "--stiffness-n-per-m", "-5"}, "--stiffness-n-per-m", 2);
}

TEST(Render, OverwritesOnlyWithForce) {
  const TemporaryFolder place{};
  write_text(place / "path.tsv", "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0\n1\t0\t0\t0\n");
  write_text(place / "forces.tsv", "mine");
  const std::vector<std::string> arguments{
      "render", "--model", "sinusoid", "--path", place / "path.tsv", "--out", place / "forces.tsv"};
  const Outcome refused = asperity(arguments);
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("--force"), std::string::npos);
  EXPECT_EQ(text_of(place / "forces.tsv"), "mine");
}

TEST(Synth, MakesEveryKindAndItsPhotograph) {
  const TemporaryFolder place{};
  const std::vector<std::string> photographs{"bright_height", "lambert", "albedo"};
  std::size_t next = 0;
  for (const std::string kind :
       {"sinusoid", "grating", "cones", "noise", "metal", "stone", "wood", "brick", "sandpaper"}) {
    const fs::path file = place / (kind + ".png");
    const fs::path photo = place / (kind + "_photo.png");
    const Outcome outcome = asperity({"synth", kind, "--out", file, "--pixels", "128", "--width-m",
                                      "0.025", "--photo", photographs[next++ % 3], photo});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Json sidecar = Json::parse(text_of(file.string() + ".json"));
    EXPECT_DOUBLE_EQ(sidecar.at("pitch_m").get<double>(), 0.025 / 128);
    EXPECT_LT(sidecar.at("height_min_m"), sidecar.at("height_max_m"));
    EXPECT_NE(sidecar.dump().find(kind), std::string::npos);
    EXPECT_EQ(text_of(photo).substr(1, 3), "PNG");
    if (next > photographs.size()) continue;
    // A photograph is what texture takes.
    EXPECT_EQ(
        asperity({"texture", photo, "--out", place / (kind + "_again.png"), "--width-m", "0.025"})
            .status,
        0);
  }
}

TEST(Texture, StoresHeightsWithASidecarAndOverwritesOnlyWithForce) {
  const TemporaryFolder place{};
  make_small_stimuli(place.path());
  const fs::path made = place / "made.png";
  const std::vector<std::string> arguments{"texture",   place / "slate_photo.png",
                                           "--out",     made,
                                           "--width-m", "0.02",
                                           "--rms-m",   "0.00005",
                                           "--sign",    "-1",
                                           "--preview", place / "steps.png"};
  const Outcome outcome = asperity(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("RMS 50.0 µm"), std::string::npos) << outcome.out;
  const std::string png = text_of(made);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(png[24], 16);  // bit depth in the header
  const Json sidecar = Json::parse(text_of(made.string() + ".json"));
  EXPECT_DOUBLE_EQ(sidecar.at("pitch_m").get<double>(), 0.02 / 128);
  EXPECT_LT(sidecar.at("height_min_m"), 0.0);
  EXPECT_GT(sidecar.at("height_max_m"), 0.0);
  EXPECT_NE(sidecar.dump().find("slate_photo.png"), std::string::npos);
  EXPECT_TRUE(fs::exists(place / "steps.png"));

  const auto before = contents_of(place.path());
  EXPECT_EQ(asperity(arguments).status, 1);
  EXPECT_TRUE(contents_of(place.path()) == before);
  std::vector<std::string> again = arguments;
  again.emplace_back("--force");
  EXPECT_EQ(asperity(again).status, 0);
  EXPECT_TRUE(contents_of(place.path()) == before);  // the same recipe, the same bytes
}

TEST(Models, AreDeclaredInOneJsonDocument) {
  const Outcome outcome = asperity({"models", "--json"});
  ASSERT_EQ(outcome.status, 0);
  const auto document = nlohmann::ordered_json::parse(outcome.out);
  EXPECT_EQ(document.begin().key(), "format");
  EXPECT_EQ(document.at("format"), "asperity.models/1");
  std::vector<std::string> ids{};
  for (const auto& model : document.at("models")) {
    ids.push_back(model.at("id"));
    for (const char* key :
         {"version", "summary", "source", "conservative_with", "needs_height_field", "needs_bodies",
          "assets", "amplitude_parameter", "parameters", "layer_parameters", "is_potential",
          "band_Hz", "moves_by_itself", "moves_by_itself_with"}) {
      EXPECT_TRUE(model.contains(key)) << key;
    }
    for (const auto& parameter : model.at("parameters")) {
      std::vector<std::string> keys{};
      for (const auto& [key, value] : parameter.items()) keys.push_back(key);
      EXPECT_EQ(keys, (std::vector<std::string>{"name", "kind", "unit", "minimum", "maximum",
                                                "choices", "default", "meaning"}));
      EXPECT_THAT((std::vector<std::string>{"number", "integer", "choice"}),
                  testing::Contains(parameter.at("kind").get<std::string>()));
    }
  }
  EXPECT_THAT(ids,
              testing::IsSupersetOf({"height_map", "sinusoid", "stochastic", "lateral_gradient"}));
  const auto& height_map = document.at("models").at(0);
  EXPECT_EQ(height_map.at("id"), "height_map");
  EXPECT_EQ(height_map.at("conservative_with").dump(),
            R"({"lateral_gradient_gain":1.0,"law":"corrected"})");
  EXPECT_EQ(height_map.at("needs_height_field"), true);
  EXPECT_EQ(height_map.at("amplitude_parameter"), "height_scale");
  EXPECT_THAT(height_map.at("layer_parameters").get<std::vector<std::string>>(),
              testing::IsSupersetOf({"friction_law", "friction_speed_m_per_s"}));
  EXPECT_EQ(height_map.at("is_potential"), false);
  EXPECT_EQ(height_map.at("moves_by_itself"), false);
  EXPECT_EQ(height_map.at("band_Hz"), "v/(2*pitch of the height field)");
  const std::string list = asperity({"models"}).out;
  EXPECT_THAT(list, testing::HasSubstr("highest frequency of the texture in Hz: v/wavelength_m\n"));
  EXPECT_THAT(list, testing::HasSubstr("moves by itself: with "));
  EXPECT_THAT(list, testing::HasSubstr("conservative without friction: with "
                                       "lateral_gradient_gain=1, law=corrected\n"));
  EXPECT_THAT(list, testing::HasSubstr("conservative without friction: never\n"));
  // What the models share is described once.
  const std::string shared = "    friction_law = ";
  EXPECT_EQ(list.find(shared), list.rfind(shared));
  EXPECT_GT(list.find(shared), list.find("\npd_gradient  (version"));
}

TEST(Models, PrintTheTableOfTheConformanceSuite) {
  const Outcome table = asperity({"models", "--conformance", "--model", "sinusoid"});
  EXPECT_EQ(table.status, 0) << table.err;
  EXPECT_THAT(table.out, testing::HasSubstr("sinusoid  (version 2)"));
  EXPECT_THAT(table.out, testing::HasSubstr("zero_amplitude  met"));
  const Outcome json = asperity({"models", "--conformance", "--model", "normal_map", "--json"});
  EXPECT_EQ(json.status, 0) << json.err;
  const auto document = nlohmann::json::parse(json.out);
  EXPECT_EQ(document.at("format"), "asperity.conformance/1");
  ASSERT_EQ(document.at("models").size(), 1U);
  const auto& model = document.at("models").at(0);
  EXPECT_EQ(model.at("id"), "normal_map");
  EXPECT_EQ(model.at("conformant"), true);
  EXPECT_EQ(model.at("checks").size(), 6U);
  EXPECT_EQ(model.at("checks").at(0).at("name"), "zero_amplitude");
}

TEST(Check, SaysWhatAPlanAmountsTo) {
  const SmallStudy small(3);
  const Outcome outcome = asperity({"check", small.selection(), small.recognition(), "--study",
                                    small.study(), "--device", "simulated", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto document = nlohmann::ordered_json::parse(outcome.out);
  EXPECT_EQ(document.begin().key(), "format");
  EXPECT_EQ(document.at("format"), "asperity.check/1");
  const auto& selection = document.at("protocols").at(0);
  EXPECT_EQ(selection.at("valid"), true);
  EXPECT_EQ(selection.at("trials"), 6);     // 2 textures × 3
  EXPECT_EQ(selection.at("contacts"), 12);  // of two surfaces each
  EXPECT_NEAR(selection.at("contact_s").get<double>(), 12 * 0.2, 1e-9);
  EXPECT_EQ(document.at("protocols").at(1).at("contacts"), 6);
}

TEST(Check, PrintsTheMeanDragOfEachStimulus) {
  const fs::path library = fs::path(ASPERITY_SOURCE_DIR) / "protocols/library/amplitude_jnd.json";
  const Outcome printed = asperity({"check", library});
  ASSERT_EQ(printed.status, 0) << printed.err;
  EXPECT_THAT(printed.out, testing::ContainsRegex(": mean drag 0\\.19[0-9] N, 99\\.[0-9] % of "
                                                  "friction × normal force: grating_sinusoid"));
  const Json document = Json::parse(asperity({"check", library, "--json"}).out);
  const Json& drags = document.at("protocols").at(0).at("drag");
  EXPECT_GT(drags.size(), 1U);
  for (const Json& drag : drags) {
    EXPECT_EQ(drag.at("exploration"), "stroking");
    EXPECT_NEAR(drag.at("of_coulomb").get<double>(), 1.0, 0.01) << drag.dump();
    EXPECT_NEAR(drag.at("mean_N").get<double>(), 0.2, 0.005) << drag.dump();
  }
}

TEST(Check, NamesTheFilesThatItDoesNotExamineWithoutAStudy) {
  const SmallStudy small(1);
  const std::string words =
      ": not examined without --study: 4 files that the protocol names, "
      "and the stimuli made from them\n";
  EXPECT_THAT(asperity({"check", small.selection()}).out, testing::EndsWith(words));
  EXPECT_THAT(asperity({"check", small.selection(), "--study", small.study()}).out,
              testing::Not(testing::HasSubstr("not examined")));
  const auto left_out = [&small](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"check", small.selection(), "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Json::parse(asperity(arguments).out).at("protocols").at(0).at("files_not_examined");
  };
  EXPECT_THAT(left_out({}), testing::Contains("stimuli/walnut.png"));
  EXPECT_EQ(left_out({}).size(), 4U);
  EXPECT_TRUE(left_out({"--study", small.study()}).empty());
}

TEST(Check, PutsTheFaultsOfEveryFileIntoTheDocument) {
  const SmallStudy small(1);
  write_text(small.place() / "bad.json", "{\"kind\": \"selecting\"}");
  const Outcome outcome =
      asperity({"check", small.selection(), small.place() / "bad.json", "--json"});
  EXPECT_EQ(outcome.status, 1);
  const Json document = Json::parse(outcome.out);
  EXPECT_EQ(document.at("protocols").at(0).at("valid"), true);
  EXPECT_EQ(document.at("protocols").at(1).at("valid"), false);
  const Json& diagnostics = document.at("protocols").at(1).at("diagnostics");
  EXPECT_GT(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics.at(0).at("line"), 1);
  EXPECT_GT(diagnostics.at(0).at("column"), 0);
}

TEST(Check, SaysWhereFilesOfTheDemonstrationComeFrom) {
  const TemporaryFolder place{};
  ASSERT_EQ(asperity({"new", place / "study"}).status, 0);
  const fs::path library = fs::path(ASPERITY_SOURCE_DIR) / "protocols/library/roughness_force.json";
  const Outcome outcome = asperity({"check", library, "--study", place / "study"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("stimuli/cones_05.png is not in the study"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find(
                "the computed texture of this name from a demo study (asperity new DIR --demo)"),
            std::string::npos);
}

// Of a wave whose tile does not close, when it is made and when it is about to be felt.
TEST(Check, WarnsOfATileThatDoesNotClose) {
  const SmallStudy small{};
  const auto made = [&small](const char* width_m) {
    return asperity({"synth", "sinusoid", "--param", "spacing_m=0.0016", "--width-m", width_m,
                     "--pixels", "400", "--force", "--out",
                     small.study() / "stimuli" / "walnut.png"});
  };
  const auto checked = [&small] {
    return asperity({"check", small.selection(), "--study", small.study(), "--json"});
  };
  const Outcome closed = made("0.016");
  EXPECT_EQ(closed.status, 0);
  EXPECT_EQ(closed.err, "");
  EXPECT_EQ(nlohmann::json::parse(checked().out)["protocols"][0]["warnings"].size(), 0U);
  const Outcome cut = made("0.02");
  EXPECT_EQ(cut.status, 0);
  EXPECT_NE(cut.err.find("warning: "), std::string::npos);
  EXPECT_NE(cut.err.find("0.02 m along x contain 12.5 spacings of 0.0016 m"), std::string::npos);
  const Outcome warned = checked();
  EXPECT_EQ(warned.status, 0) << warned.err;
  EXPECT_NE(warned.err.find("the texture \"walnut\" (stimuli/walnut.png), used in "),
            std::string::npos)
      << warned.err;
  EXPECT_NE(warned.err.find("0.0192 m or 0.0208 m, which contains only complete ones"),
            std::string::npos);
}

TEST(Check, AcceptsEveryProtocolOfTheLibrary) {
  std::vector<std::string> arguments{"check"};
  for (const fs::directory_entry& file :
       fs::directory_iterator(fs::path(ASPERITY_SOURCE_DIR) / "protocols" / "library")) {
    if (file.is_regular_file()) arguments.push_back(file.path());
  }
  ASSERT_GT(arguments.size(), 6U);
  const Outcome outcome = asperity(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

}  // namespace
}  // namespace asperity::test
