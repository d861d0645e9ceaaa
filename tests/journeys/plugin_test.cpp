// A force model in a plug-in, as a laboratory writes one: built with the installed headers alone, checked, felt in a study,
// changed and lost.

#include <csignal>
#include <memory>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results_schema/hashes/sha256.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

using Json = nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

void succeed(const Outcome& outcome) {
  if (outcome.status != 0) throw std::runtime_error(outcome.out + outcome.err);
}

void cmake(const std::vector<std::string>& arguments) {
  succeed(run({.program = ASPERITY_CMAKE, .arguments = arguments}));
}

/// The example, configured and built in a folder against what the interface installs, and built anew after a change.
class Example final {
 public:
  Example() {
    cmake({"--install", ASPERITY_BUILD_FOLDER, "--component", "plugin_interface", "--prefix",
           folder_ / "prefix"});
    fs::copy(ASPERITY_SOURCE_DIR "/renderers/plugin/example", source_);
    cmake({"-G", "Ninja", "-S", source_, "-B", folder_ / "build", "-DCMAKE_BUILD_TYPE=Release",
           "-DCMAKE_PREFIX_PATH=" + prefix().string()});
    build_into(plugin());
    const std::string text = text_of(source_ / "ridges.cpp");
    write_text(source_ / "ridges.cpp",
               std::regex_replace(text, std::regex("version = \"1\""), "version = \"2\""));
    build_into(changed_plugin());
  }

  fs::path prefix() const { return folder_ / "prefix"; }
  fs::path plugin() const { return folder_ / "ridges.so"; }
  /// Of another version.
  fs::path changed_plugin() const { return folder_ / "changed_ridges.so"; }
  fs::path protocol() const { return source_ / "ridges.json"; }

 private:
  void build_into(const fs::path& file) const {
    cmake({"--build", folder_ / "build"});
    fs::copy_file(folder_ / "build" / "ridges.so", file);
  }

  TemporaryFolder folder_{};
  fs::path source_ = folder_ / "ridges";
};

class Plugin : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    example_ = std::make_unique<Example>();
    simulated_ = std::make_unique<TemporaryFolder>();
    simulate(*simulated_ / "study");
  }
  static void TearDownTestSuite() {
    example_.reset();
    simulated_.reset();
  }

  static std::unique_ptr<Example> example_;
  static std::unique_ptr<TemporaryFolder> simulated_;

  /// A study of two virtual participants who felt the example.
  static void simulate(const fs::path& study) {
    succeed(asperity({"simulate", example_->protocol(), "--study", study, "--participants", "2",
                      "--seed", "3", "--plugin", example_->plugin()}));
  }
  /// A copy of that study.
  void copy_simulated() const {
    fs::copy(*simulated_ / "study", study(), fs::copy_options::recursive);
  }
  fs::path study() const { return folder_ / "study"; }

  /// Each command that calls a model of a plug-in in a process of its own, with the model "faulty".
  std::vector<std::vector<std::string>> commands_that_call_it() const {
    write_text(folder_ / "faulty.json", faulty_discrimination().dump());
    write_text(folder_ / "path.tsv",
               "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0.001\n0.001\t0\t0\t-0.001\n");
    return {{"models", "--conformance"},
            {"check", folder_ / "faulty.json"},
            {"render", "--model", "faulty", "--path", folder_ / "path.tsv", "--out",
             folder_ / "forces.tsv"},
            {"simulate", folder_ / "faulty.json", "--study", study(), "--participants", "1",
             "--seed", "1"}};
  }

  TemporaryFolder folder_{};
};

std::unique_ptr<Example> Plugin::example_{};
std::unique_ptr<TemporaryFolder> Plugin::simulated_{};

TEST_F(Plugin, NeedsOnlyTwoHeadersAndATarget) {
  std::vector<std::string> installed{};
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(example_->prefix())) {
    const std::string name = entry.path().lexically_relative(example_->prefix());
    if (entry.is_regular_file() && name.find("/doc/") == std::string::npos) {
      installed.push_back(entry.path().filename());
    }
  }
  EXPECT_THAT(installed,
              testing::UnorderedElementsAre("asperity_plugin.h", "asperity_plugin.hpp",
                                            "asperityConfig.cmake", "asperityConfigVersion.cmake"));
}

TEST_F(Plugin, MeetsTheConformanceSuite) {
  const Outcome table =
      asperity({"models", "--conformance", "--plugin", example_->plugin(), "--json"});
  EXPECT_EQ(table.status, 0) << table.out << table.err;
  const Json document = Json::parse(table.out);
  ASSERT_EQ(document.at("models").size(), 1U) << "only the plug-in";
  EXPECT_EQ(document.at("models").at(0).at("id"), "ridges");
  for (const Json& check : document.at("models").at(0).at("checks")) {
    EXPECT_EQ(check.at("result"), "met") << check.dump();
    if (check.at("name") == "band") {
      // The force of a cosine of 0.1 mm at 1 kN/m, as it is in the guide.
      EXPECT_EQ(check.at("measured"), "100.0 % of 70.71 mN RMS");
    }
  }
  const Outcome listed = asperity({"models", "--plugin", example_->plugin(), "--json"});
  EXPECT_EQ(Json::parse(listed.out).at("models").back().at("plugin").at("sha256"),
            sha256_of_file(example_->plugin()));
}

TEST_F(Plugin, RendersTheLawOfItsHeader) {
  // On a crest, in a trough, and above: k = 500 N/m, A = 0.1 mm, L = 2 mm.
  write_text(
      folder_ / "path.tsv",
      "time_s\tx_m\ty_m\tz_m\n0\t0\t0\t0.001\n0.001\t0\t0\t-0.001\n0.002\t0.001\t0\t-0.001\n");
  succeed(asperity({"render", "--model", "ridges", "--plugin", example_->plugin(), "--friction",
                    "0", "--path", folder_ / "path.tsv", "--out", folder_ / "forces.tsv"}));
  const std::vector<std::string> forces_N = tsv(text_of(folder_ / "forces.tsv")).column("fz_N");
  EXPECT_EQ(forces_N.at(0), "0");
  EXPECT_NEAR(std::stod(forces_N.at(1)), 500 * 0.0012, 1e-12);
  EXPECT_NEAR(std::stod(forces_N.at(2)), 500 * 0.0010, 1e-12);
}

TEST_F(Plugin, IsNeverLoadedBecauseAProtocolNamesItsModel) {
  const Outcome refused = asperity({"check", example_->protocol()});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err,
              AllOf(HasSubstr("there is no force model \"ridges\""),
                    HasSubstr("if it is in a plug-in, load the plug-in with --plugin")));
  const Outcome accepted =
      asperity({"check", example_->protocol(), "--plugin", example_->plugin()});
  EXPECT_EQ(accepted.status, 0) << accepted.err;
}

TEST_F(Plugin, IsStoredWithItsNameVersionAndHash) {
  copy_simulated();
  const std::string hash = sha256_of_file(example_->plugin());
  const auto tables = exported(study(), folder_ / "out");  // without the plug-in
  const Tsv presentations = tsv(tables.at("presentations.tsv"));
  EXPECT_THAT(presentations.column("model"), testing::Each("ridges"));
  EXPECT_THAT(presentations.column("model_version"), testing::Each("1"));
  EXPECT_THAT(presentations.column("plugin_sha256"), testing::Each(hash));
  EXPECT_THAT(tables.at("codebook.tsv"), HasSubstr("Spacing L of the ridges along x"));
  EXPECT_THAT(tables.at("events.tsv"), AllOf(HasSubstr("\tplugin\t"), HasSubstr(hash)));
}

TEST_F(Plugin, RepeatsItsForcesInAVerification) {
  copy_simulated();
  const Outcome verified =
      asperity({"verify", study(), "--replay", "--plugin", example_->plugin()});
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  EXPECT_THAT(verified.out, HasSubstr("compared bit for bit"));
}

TEST_F(Plugin, IsReportedMissingWhileTheRestOfTheStudyIsVerifiedAndRead) {
  copy_simulated();
  const Outcome verified = asperity({"verify", study()});
  EXPECT_EQ(verified.status, 1);
  EXPECT_THAT(verified.err, AllOf(HasSubstr("the plug-in model ridges, version 1 (SHA-256 "),
                                  HasSubstr("and is not loaded; load it with --plugin FILE")));
  EXPECT_THAT(verified.out, HasSubstr("1 problem found"));
  EXPECT_EQ(asperity({"analyze", study()}).status, 0);
#ifdef ASPERITY_WITH_REPORT
  const Outcome report = asperity({"report", study(), "--out", folder_ / "report.html"});
  EXPECT_EQ(report.status, 0) << report.err;
  EXPECT_THAT(text_of(folder_ / "report.html"), HasSubstr("ridges"));
#endif
}

TEST_F(Plugin, IsReportedChangedAfterItIsBuiltAnew) {
  copy_simulated();
  const fs::path changed = example_->changed_plugin();
  const Outcome verified = asperity({"verify", study(), "--replay", "--plugin", changed});
  EXPECT_EQ(verified.status, 1);
  EXPECT_THAT(verified.err,
              AllOf(HasSubstr("differs: version 2 (SHA-256 " + sha256_of_file(changed)),
                    HasSubstr("load the one that rendered the attempts")));
  EXPECT_THAT(verified.out,
              AllOf(HasSubstr("1 problem found"), Not(HasSubstr("Restore")),
                    HasSubstr("recordings that were not replayed because their plug-in is not "
                              "loaded: 4\n")));
}

TEST_F(Plugin, StopsASessionWithItsMessageWhenItFails) {
  // A plate that throws in the hundredth tick of a contact of less than 1 mm.
  write_text(folder_ / "faulty.json", faulty_discrimination().dump());
  const Outcome stopped =
      asperity({"simulate", folder_ / "faulty.json", "--study", study(), "--participants", "1",
                "--seed", "1", "--plugin", ASPERITY_FAULTY_PLUGINS "/faulty_late.so"});
  EXPECT_EQ(stopped.status, 1);
  const std::string message = "the plug-in of the force model faulty failed: the hundredth tick";
  EXPECT_THAT(stopped.err, HasSubstr(message));
  const auto tables = exported(study(), folder_ / "out");
  const Tsv attempts = tsv(tables.at("attempts.tsv"));
  EXPECT_THAT(attempts.column("outcome"), testing::ElementsAre("device_fault"));
  EXPECT_THAT(attempts.column("invalid_reason"), testing::ElementsAre(message));
  EXPECT_THAT(attempts.column("invalid_code"), testing::ElementsAre("plugin_failed"));
  EXPECT_THAT(tsv(tables.at("presentations.tsv")).column("limit_plugin_error_ticks"),
              testing::Contains("1"));
  EXPECT_THAT(
      tables.at("codebook.tsv"),
      AllOf(HasSubstr("because the plug-in of the force model reported an error or threw an "
                      "exception (docs/write-a-force-model.md); models: faulty"),
            Not(HasSubstr("pd_gradient.md"))));
}

TEST_F(Plugin, IsEvaluatedWithTheValuesOfTheProtocolBeforeASession) {
  Json protocol = Json::parse(text_of(example_->protocol()));
  protocol["stimuli"]["ridges"]["parameters"] = {{"amplitude_m", 0.001}, {"spacing_m", 0.0015}};
  write_text(folder_ / "steep.json", protocol.dump());
  const auto problem = AllOf(
      HasSubstr("cannot be rendered: the plug-in model ridges: amplitude_m exceeds spacing_m"),
      HasSubstr("(/stimuli/ridges)"));
  const Outcome checked =
      asperity({"check", folder_ / "steep.json", "--plugin", example_->plugin()});
  EXPECT_EQ(checked.status, 1);
  EXPECT_THAT(checked.err, problem);
  Json faulty = faulty_discrimination();
  faulty["stimuli"]["ridges"]["parameters"]["amplitude_m"] = 0.0005;
  write_text(folder_ / "faulty.json", faulty.dump());
  const Outcome failing = asperity(
      {"check", folder_ / "faulty.json", "--plugin", ASPERITY_FAULTY_PLUGINS "/faulty_stroke.so"});
  EXPECT_EQ(failing.status, 1);
  EXPECT_THAT(failing.err, HasSubstr("failed in a stroke across the surface: no such amplitude; "
                                     "correct the plug-in, or the values of the stimulus"));
  succeed(asperity({"new", study()}));
  const Outcome in_study = asperity(
      {"check", folder_ / "steep.json", "--study", study(), "--plugin", example_->plugin()});
  EXPECT_EQ(in_study.status, 1);
  EXPECT_THAT(in_study.err, problem);
  const Outcome simulated =
      asperity({"simulate", folder_ / "steep.json", "--study", study(), "--participants", "1",
                "--seed", "1", "--plugin", example_->plugin()});
  EXPECT_EQ(simulated.status, 1);
  EXPECT_THAT(simulated.err, problem);
}

TEST_F(Plugin, IsSweptWithItsHashInTheDescriptionOfTheTable) {
  const std::vector<std::string> sweep{"sweep",
                                       "--model",
                                       "ridges",
                                       "--vary",
                                       "exploratory_speed",
                                       "--values",
                                       "0.05,0.1",
                                       "--spacings",
                                       "0.002:0.004:2",
                                       "--drag",
                                       "constant_height",
                                       "--out",
                                       folder_ / "sweep.tsv"};
  const Outcome unknown = asperity(sweep);
  EXPECT_NE(unknown.status, 0);
  EXPECT_THAT(unknown.err, HasSubstr("load the plug-in with --plugin FILE"));
  std::vector<std::string> with_plugin = sweep;
  with_plugin.insert(with_plugin.end(), {"--plugin", example_->plugin()});
  succeed(asperity(with_plugin));
  const Tsv table = tsv(text_of(folder_ / "sweep.tsv"));
  EXPECT_EQ(table.rows.size(), 4U);
  EXPECT_THAT(table.column("model"), testing::Each("ridges"));
  EXPECT_THAT(table.column("status"), testing::Each("ok"));
  EXPECT_THAT(text_of(folder_ / "sweep.tsv.json"),
              HasSubstr("\"plugin_sha256\": \"" + sha256_of_file(example_->plugin()) + '"'));
}

TEST_F(Plugin, IsLoadedToRecordTheTextureOfAnAttempt) {
  copy_simulated();
  const std::vector<std::string> record{
      "texture-recording",    "--study", study(), "--attempt", "virtual0001/1/1/1", "--out",
      folder_ / "texture.tsv"};
  const Outcome missing = asperity(record);
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.err, HasSubstr("load its plug-in with --plugin FILE"));
  std::vector<std::string> with_plugin = record;
  with_plugin.insert(with_plugin.end(), {"--plugin", example_->plugin()});
  succeed(asperity(with_plugin));
  EXPECT_GT(tsv(text_of(folder_ / "texture.tsv")).rows.size(), 100U);
}

TEST_F(Plugin, GivesTheSameStudyWithTheSameSeed) {
  copy_simulated();
  const auto once = exported(study(), folder_ / "once");
  fs::remove_all(study());
  simulate(study());
  EXPECT_TRUE(once == exported(study(), folder_ / "again"));
}

TEST_F(Plugin, IsNamedByTheCommandThatItEnds) {
  for (const std::vector<std::string>& command : commands_that_call_it()) {
    for (const auto& [plugin, named] :
         {std::pair{"faulty_crash.so",
                    "the plug-in faulty (faulty_crash.so) ended the program with an "
                    "invalid memory access (SIGSEGV) in its function tick; correct"},
          std::pair{"faulty_exits.so",
                    "the plug-in faulty (faulty_exits.so) ended the program with "
                    "exit status 0 in its function tick; correct"},
          std::pair{"faulty_quits.so",
                    "the plug-in faulty (faulty_quits.so) ended the program with "
                    "exit status 0 in its function create; correct"},
          std::pair{"faulty_quits_loading.so",
                    "the plug-in faulty_quits_loading.so ended the program "
                    "with exit status 0 in its initialisation; correct"}}) {
      std::vector<std::string> arguments = command;
      arguments.insert(arguments.end(),
                       {"--plugin", std::string(ASPERITY_FAULTY_PLUGINS "/") + plugin});
      // The copy of a plug-in that ends the program while it is loaded stays there.
      const Outcome ended =
          run({.arguments = arguments, .environment = {{"TMPDIR", folder_.path().string()}}});
      EXPECT_EQ(ended.status, 1) << command.front() << ' ' << plugin;
      EXPECT_EQ(ended.out, "");
      EXPECT_THAT(ended.err, HasSubstr(named)) << command.front();
    }
  }
}

TEST_F(Plugin, IsNamedByTheCommandThatWaitsForItInVain) {
  const std::vector<std::vector<std::string>> commands = commands_that_call_it();
  std::vector<std::unique_ptr<Program>> waiting{};  // for the limit, all at once
  for (std::vector<std::string> command : commands) {
    command.insert(command.end(), {"--plugin", ASPERITY_FAULTY_PLUGINS "/faulty_hang.so"});
    waiting.push_back(std::make_unique<Program>(Invocation{.arguments = command}));
  }
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const Outcome ended = waiting[i]->finish();
    EXPECT_EQ(ended.status, 1) << commands[i].front();
    EXPECT_THAT(
        ended.err,
        HasSubstr("the plug-in faulty (faulty_hang.so) did not return from its function "
                  "tick within 5 s, the limit of a call, and the command was ended; correct"))
        << commands[i].front();
  }
}

// The streams of the program are open until the process that calls the plug-in has ended as well.
TEST_F(Plugin, EndsWithTheCommandThatWaitsForIt) {
  const auto waiting = [&](bool on_terminal) {
    return Invocation{.arguments = {"check", example_->protocol(), "--plugin",
                                    ASPERITY_FAULTY_PLUGINS "/faulty_hang.so"},
                      .on_terminal = on_terminal};
  };
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    Program program(waiting(false));
    ASSERT_TRUE(program.read_until_told("the tick does not return")) << program.err();
    program.send(signal);
    const Outcome ended = program.finish();
    EXPECT_EQ(ended.signal, signal) << ended.err;
    EXPECT_EQ(ended.err, "the tick does not return\n");
  }
  Program program(waiting(true));
  ASSERT_TRUE(program.read_until_told("the tick does not return")) << program.err();
  program.type("\x03");
  EXPECT_EQ(program.finish().signal, SIGINT) << program.err();
}

TEST_F(Plugin, LetsASimulationStopAfterItsTrialAtTheFirstCtrlC) {
  for (const bool on_terminal : {false, true}) {
    const std::string label = on_terminal ? "typed" : "sent";
    const bool resumes = on_terminal;
    std::vector<std::string> arguments{"simulate",       example_->protocol(),
                                       "--study",        folder_ / label,
                                       "--participants", "100",
                                       "--seed",         "3",
                                       "--plugin",       example_->plugin()};
    if (resumes) arguments.emplace_back("--resume");
    Program program(Invocation{.arguments = arguments, .on_terminal = on_terminal});
    ASSERT_TRUE(program.read_until([](const std::string&, const std::string& err) {
      return !done_lines(err).empty();
    })) << program.err();
    if (on_terminal) {
      program.type("\x03");
    } else {
      program.send(SIGINT);
    }
    const Outcome stopped = program.finish();
    EXPECT_EQ(stopped.status, 1) << label << stopped.err;
    EXPECT_THAT(stopped.err, HasSubstr(resumes ? "start it again with the same arguments"
                                               : "add --resume to the same arguments"));
    const std::string saying = "stopping after the trials that are running";
    const std::size_t first = stopped.err.find(saying);
    EXPECT_NE(first, std::string::npos) << stopped.err;
    EXPECT_EQ(stopped.err.find(saying, first + 1), std::string::npos) << stopped.err;
  }
}

// 1e100 N is finite, and infinite in a recording.
TEST_F(Plugin, IsADeviceFaultWhereItsForceIsTooGreatToBeStored) {
  write_text(folder_ / "faulty.json", faulty_discrimination().dump());
  const auto simulate_with = [&](const std::string& plugin, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"simulate",       folder_ / "faulty.json",
                                       "--study",        study(),
                                       "--participants", "1",
                                       "--seed",         "1",
                                       "--plugin",       ASPERITY_FAULTY_PLUGINS "/" + plugin};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return asperity(arguments);
  };
  const Outcome stopped = simulate_with("faulty_huge.so", {});
  EXPECT_EQ(stopped.status, 1);
  EXPECT_THAT(stopped.err,
              HasSubstr("the plug-in of the force model faulty failed: a result is not "
                        "finite (more than 3.4e38 counts as infinite)"));
  const auto tables = exported(study(), folder_ / "out");
  EXPECT_THAT(tsv(tables.at("attempts.tsv")).column("outcome"),
              testing::ElementsAre("device_fault"));
  const Outcome resumed = simulate_with("faulty_none.so", {"--resume"});
  EXPECT_EQ(resumed.status, 0) << resumed.err;
}

}  // namespace
}  // namespace asperity::test
