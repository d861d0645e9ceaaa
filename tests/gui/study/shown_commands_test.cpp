// The command lines that pages show: the real program accepts each of them in a shell, with the result of the page's action.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <QtCore/QProcess>
#include <QtGui/QClipboard>
#include <QtGui/QGuiApplication>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

#include "app/gui/base/command_lines.h"
#include "app/gui/base/study_table.h"
#include "app/gui/window/session_desk.h"
#include "app/gui/window/study_window.h"
#include "app/study_files/rendering_files.h"
#include "app/tasks/checked_rendering_use.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/app/small_study.h"
#include "tests/gui/editor/library_text.h"
#include "tests/gui/study/quiet_home.h"

namespace asperity {
namespace {

class ShownCommands : public QuietHome {
 protected:
  ShownCommands() { make_study("study"); }

  std::filesystem::path folder(const std::string& name = "study") const {
    return home() / "a \"$HOME\" with blanks" / name;
  }
  std::filesystem::path protocol(const std::string& study = "study") const {
    return folder(study) / "protocols" / "small.json";
  }
  void make_study(const std::string& name) const {
    std::filesystem::create_directories(folder(name).parent_path());
    make_small_study(folder(name));
    write_file(protocol(name), small_protocol(), Overwrite::refuse);
  }
  SimulationInputs simulation(const std::string& study) const {
    SimulationInputs inputs{};
    inputs.protocols = {protocol(study)};
    inputs.study = folder(study);
    inputs.participants = 2;
    inputs.seed = 18'000'000'000'000'000'000U;
    return inputs;
  }

  struct Ended {
    int status = -1;
    std::string err{};
  };
  /// In a shell, in another folder than the study.
  static Ended run(const std::string& line) {
    const std::filesystem::path program = ASPERITY_PROGRAM;
    QProcess shell;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", QString::fromStdString(program.parent_path().string()) + ':' +
                                   environment.value("PATH"));
    shell.setProcessEnvironment(environment);
    shell.setWorkingDirectory("/");
    shell.setStandardInputFile(QProcess::nullDevice());
    shell.start("/bin/sh", {"-c", QString::fromStdString(line)});
    shell.waitForFinished(kPatience_ms);
    return {shell.exitCode(), shell.readAllStandardError().toStdString()};
  }
  static void expect_done(const std::string& line) {
    const Ended ended = run(line);
    EXPECT_EQ(ended.status, 0) << line << '\n' << ended.err;
  }

  /// Seeds, responses and measures of all attempts.
  std::vector<std::string> results(const std::string& name) const {
    const Study study = Study::open(folder(name), Access::read_only);
    std::vector<std::string> all{};
    for (const SessionRow& session : study.sessions()) {
      for (const AttemptRow& attempt : study.attempts(session.id)) {
        all.push_back(session.participant + ' ' + session.seed + ' ' +
                      attempt.responses.at(0).answer + ' ' +
                      std::to_string(attempt.responses.at(0).time_ns) + ' ' +
                      std::to_string(attempt.presentations.at(0).contact_s));
      }
    }
    return all;
  }
};

TEST_F(ShownCommands, AreAcceptedByTheProgram) {
  expect_done(check_line(protocol(), folder(), {}));
  SimulationInputs simulated = simulation("study");
  simulated.recordings = Recordings::none;
  simulated.device = "simulated:delta.3";
  expect_done(simulate_line(simulated, {}));
  simulated.resume = true;
  expect_done(simulate_line(simulated, {}));

  RunInputs person{};
  person.protocol = protocol();
  person.study = folder();
  person.participant = "virtual0003";
  person.is_virtual = true;
  person.pacing = RunPacing::stepped;
  expect_done(run_line(person, {}));
  person.participant = "P01";
  person.is_virtual = false;
  person.mode = SessionMode::pilot;
  // Read to its end: what is missing is the terminal.
  const Ended ended = run(run_line(person, {}));
  EXPECT_NE(ended.err.find("asks the participant at a terminal"), std::string::npos) << ended.err;
  person.resume = true;
  person.late_reason = "the participant's \"flight\"";
  person.device = "falcon:0$1";
  person.driver_options.firmware = "/tmp/a firmware";
  EXPECT_NE(run(run_line(person, {})).err.find("asks the participant at a terminal"),
            std::string::npos);

  const std::filesystem::path jnd = folder().parent_path() / "amplitude_jnd.json";
  write_file(jnd, library_text("amplitude_jnd"), Overwrite::refuse);
  expect_done(power_line({.protocol = jnd,
                          .participants = 2,
                          .runs = 2,
                          .effects = {{"comparisons.rougher.order", -0.5}},
                          .assumed = {{"comparisons.rougher.order_sd", 0.0}}},
                         {}));

  expect_done(analyze_line(folder(), {}));
  expect_done(analyze_line(folder(), "small"));
  expect_done(report_line(folder(), folder("the report.html")));
  expect_done(export_line(folder(), folder("tables"), {}));
  ExportOptions options{};
  options.audience = ExportAudience::relabelled;
  options.has_age_bands = true;
  options.formats = {ExportFormat::physio, ExportFormat::wide};
  expect_done(export_line(folder(), folder("published"), options));
  options.formats = {};
  expect_done(export_line(folder(), folder("few"), options));
}

TEST_F(ShownCommands, PassPluginsAndLevelProgramsOn) {
  SimulationInputs inputs = simulation("study");
  inputs.level_program = ExternalProgram{.file = "/tmp/a program", .arguments = {"--steps", "a b"}};
  const std::string line = simulate_line(inputs, {"/tmp/a plug-in.so"});
  EXPECT_TRUE(
      line.ends_with("--external \"/tmp/a program\" --external-argument=--steps "
                     "\"--external-argument=a b\" --plugin \"/tmp/a plug-in.so\""))
      << line;
  const Ended ended = run(line);
  EXPECT_EQ(ended.status, 1) << ended.err;  // such files do not exist
}

TEST_F(ShownCommands, ChangeStimuliAsTheirActionsDo) {
  make_study("other");
  const auto stimulus = [this](const std::string& study, const std::string& name) {
    return folder(study) / "stimuli" / name;
  };
  save_rendering(folder(), "strong",
                 {.model = "height_map",
                  .version = "0",
                  .texture = {"stimuli/grain.png", std::string(64, 'a')}});
  const std::filesystem::path rendering = rendering_file(folder(), "strong");
  const RenderingPlace place{};
  const std::string after = use_of_rendering({.study = folder(),
                                              .rendering = rendering,
                                              .protocol = read_file(protocol()),
                                              .place = place},
                                             built_in_models())
                                .after;
  expect_done(use_rendering_line(rendering, protocol(), place, {}));
  EXPECT_EQ(read_file(protocol()), after);
  EXPECT_NE(after.find("\"x-rendering\": \"strong\""), std::string::npos) << after;

  TextureRecipe recipe{};
  recipe.width_m = 0.02;
  recipe.gaussian_wavelength_m = 0.004;
  recipe.sign = HeightSign::dark_is_high;
  recipe.method = "brightness";
  EXPECT_EQ(texture_line("photo.png", recipe, "made.png"),
            "asperity texture photo.png --out made.png --gaussian-wavelength-m 0.004 --method "
            "brightness --sign -1 --width-m 0.02");

  expect_done(rename_stimulus_line(stimulus("study", "grain.png"), "sand"));
  EXPECT_TRUE(std::filesystem::exists(stimulus("study", "sand.png")));
  expect_done(copy_stimuli_line({stimulus("study", "sand.png"), rendering}, folder("other")));
  EXPECT_TRUE(std::filesystem::exists(rendering_file(folder("other"), "strong")));
  expect_done(delete_stimulus_line(rendering_file(folder("other"), "strong")));
  expect_done(delete_stimulus_line(stimulus("other", "sand.png")));
  EXPECT_FALSE(std::filesystem::exists(stimulus("other", "sand.png")));
}

TEST_F(ShownCommands, GiveTheSameResults) {
  make_study("other");
  simulate(simulation("study"), built_in_models(), {}, {}, {});
  expect_done(simulate_line(simulation("other"), {}));
  EXPECT_EQ(results("study").size(), 6U);
  EXPECT_EQ(results("study"), results("other"));
}

class PagesWithCommands : public ShownCommands {
 protected:
  PagesWithCommands() : desk_(window_, nullptr) {
    window_.resize(1366, 768);
    window_.show();
    EXPECT_TRUE(window_.open_study(folder()));
    auto& table = child<StudyTable>(window_, "protocols_table");
    require([&] { return table.shown_rows() == 1; }, "protocols");
  }
  void click(QWidget& in, const char* button) {
    QTest::mouseClick(&child<QPushButton>(in, button), Qt::LeftButton);
  }
  /// Copies the command with this number.
  std::string copied(const char* page, int number) {
    QWidget& shown = *window_.page(page);
    click(shown, "show_commands");
    auto& popup = child<QWidget>(shown, "commands");
    EXPECT_TRUE(popup.isVisible());
    click(popup, ("copy_" + std::to_string(number)).c_str());
    require([&] { return shown.findChild<QWidget*>("commands") == nullptr; }, "end of the popup");
    return QGuiApplication::clipboard()->text().toStdString();
  }

  StudyWindow window_{};
  SessionDesk desk_;
};

TEST_F(PagesWithCommands, CopyWhatThePageDoesNext) {
  std::vector<SimulationInputs> wanted{};
  QObject::connect(
      &window_, &StudyWindow::session_wanted, &window_,
      [&wanted](const SessionWish& wish) { wanted.push_back(wish.simulation.value()); });
  const std::string check = copied("protocols", 1);
  EXPECT_EQ(check, check_line(protocol(), folder(), {}));
  const std::string line = copied("protocols", 2);
  click(window_, "protocol_simulate_several");
  ASSERT_EQ(wanted.size(), 1U);
  EXPECT_EQ(line, simulate_line(wanted.front(), {}));
  EXPECT_EQ(wanted.front().participants, 12);
  EXPECT_NE(line, copied("protocols", 2)) << "another seed";

  ASSERT_TRUE(eventually([this] { return window_.shown_page() == "analysis"; }));
  const auto& outcomes = child<QListWidget>(*window_.page("analysis"), "outcomes");
  ASSERT_TRUE(eventually([&outcomes] { return outcomes.currentRow() >= 0; }));
  EXPECT_EQ(copied("analysis", 1), analyze_line(folder(), "small"));
  EXPECT_EQ(copied("analysis", 2), report_line(folder(), "small-report.pdf"));
  EXPECT_EQ(copied("analysis", 3), export_line(folder(), "tables", {}));
}

TEST_F(PagesWithCommands, CopyWhatTheStartPageStarts) {
  click(window_, "protocol_simulate");
  require([this] { return child<QPushButton>(window_, "start").isEnabled(); }, "checks");
  const std::string run = copied("start", 1);
  EXPECT_NE(run.find(" --participant virtual0001 "), std::string::npos) << run;
  EXPECT_TRUE(run.ends_with(" --virtual")) << run;
  expect_done(run);
  child<QSpinBox>(window_, "virtual_participants").setValue(3);
  const std::string simulate = copied("start", 1);
  EXPECT_NE(simulate.find("asperity simulate "), std::string::npos);
  EXPECT_NE(simulate.find(" --participants 3 "), std::string::npos) << simulate;

  // The mouse has no command.
  click(window_, "mode_pilot");
  auto& devices = child<QComboBox>(window_, "device");
  devices.setCurrentIndex(devices.findData("mouse"));
  click(*window_.page("start"), "show_commands");
  auto& popup = child<QWidget>(*window_.page("start"), "commands");
  EXPECT_EQ(popup.findChild<QLineEdit*>(), nullptr);
  popup.close();
}

}  // namespace
}  // namespace asperity
