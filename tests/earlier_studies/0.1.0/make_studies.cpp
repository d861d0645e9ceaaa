// Makes the studies of this folder with the program and the windows of 0.1.0; `make` compiles it there.
//
// The table in ../README.md lists what happens in them. `make` runs each TEST as a step, in this order; one of them kills
// itself.

#include <algorithm>
#include <csignal>
#include <functional>
#include <string>
#include <vector>

#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <gtest/gtest.h>

#include "app/gui/base/settings.h"
#include "app/gui/base/study_table.h"
#include "app/gui/data/attempt_page.h"
#include "app/gui/session/fault_panel.h"
#include "app/gui/session/reason_form.h"
#include "app/gui/study/trials_page.h"
#include "tests/gui/sessions/session_room.h"
#include "tests/journeys/program.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using test::Program;

const fs::path kStudies = ASPERITY_STUDIES;

class MakeStudies : public SessionRoom {
 protected:
  // --- the program ---

  static void must(const std::vector<std::string>& arguments) {
    const test::Outcome outcome = test::asperity(arguments);
    require(outcome.status == 0, outcome.err);
  }

  /// A new study with these stimuli and protocols.
  static fs::path made(const std::string& name, const std::vector<std::string>& stimuli,
                       const std::vector<std::string>& protocols) {
    const fs::path study = place_of(name);
    fs::create_directories(study.parent_path());
    must({"new", study});
    for (const std::string& stimulus : stimuli) make_stimulus(study / "stimuli", stimulus);
    fs::create_directories(study / "protocols");
    for (const std::string& protocol : protocols) {
      fs::copy_file(kStudies / "protocols" / protocol, study / "protocols" / protocol);
    }
    return study;
  }
  static fs::path place_of(const std::string& name) { return kStudies / name / "study"; }

  /// 32 × 32 pixels, which keep the files small; eight samples or more for each spacing.
  static void make_stimulus(const fs::path& folder, const std::string& name) {
    const std::string file = folder / (name + ".png");
    const std::string photo = folder / (name + "_photo.png");
    const auto wave = [&](const char* spacing_m, const char* width_m, const char* pixels) {
      must({"synth", "sinusoid", "--param", std::string("spacing_m=") + spacing_m, "--param",
            "amplitude_m=0.0001", "--width-m", width_m, "--pixels", pixels, "--out", file});
    };
    if (name == "fine") return wave("0.001", "0.004", "32");
    if (name == "middle") return wave("0.002", "0.004", "32");
    if (name == "coarse") return wave("0.004", "0.004", "32");
    std::vector<std::string> words{"synth"};
    if (name == "walnut") {
      words.insert(words.end(), {"sinusoid", "--param", "spacing_m=0.004"});
    } else if (name == "slate") {
      words.insert(words.end(), {"noise", "--param", "shortest_wavelength_m=0.0015"});
    } else {
      words.insert(words.end(),
                   {"cones", "--param", "spacing_m=0.004", "--param", "base_diameter_m=0.003"});
    }
    words.insert(words.end(), {"--out", file, "--pixels", "32", "--width-m", "0.016", "--photo",
                               "bright_height", photo});
    must(words);
  }

  // --- a terminal ---

  /// Answers every question until the program ends or `done`.
  static void sit_at_terminal(
      Program& program, const std::function<std::string(const std::string& asked)>& answer,
      const std::function<bool()>& done = [] { return false; }) {
    std::size_t answered = 0;
    while (program.read_until([&](const std::string& out, const std::string&) {
      return (out.size() > answered && (out.ends_with(": ") || out.ends_with(". "))) || done();
    })) {
      if (done()) return;
      answered = program.out().size();
      program.type(answer(program.out()) + '\n');
    }
  }
  static test::Invocation on_terminal(std::vector<std::string> arguments) {
    test::Invocation invocation{};
    invocation.arguments = std::move(arguments);
    invocation.on_terminal = true;
    return invocation;
  }
  static std::size_t done_in(const std::string& err) {
    std::size_t count = 0;
    for (std::size_t at = err.find("done "); at != std::string::npos;
         at = err.find("done ", at + 1)) {
      if (at == 0 || err[at - 1] == '\n') ++count;
    }
    return count;
  }

  // --- the windows ---

  /// The windows of SessionRoom, with a study outside its temporary folder.
  void open_windows(const std::string& name) {
    make_windows();
    require(window->open_study(place_of(name)), "the study does not open");
  }
  void start_as(const QString& participant, const QString& protocol, const char* mode,
                const char* device = "simulated") {
    window->show_page("protocols");
    click_row(*window, "protocols_table", protocol);
    click(*window, "protocol_start");
    wait_for("the start page", [&] { return window->shown_page() == "start"; });
    click(*window, mode);
    QWidget& page = *window->page("start");
    auto& label = child<QLineEdit>(page, "participant_label");
    // The page enables and fills in its form when it has read the study.
    wait_for("the form", [&] { return label.isEnabled() && label.isVisible(); });
    label.setText(participant);
    if (auto* age = page.findChild<QLineEdit*>("question_age")) age->setText("31");
    if (auto* sex = page.findChild<QComboBox*>("question_sex")) sex->setCurrentIndex(0);
    auto& devices = child<QComboBox>(page, "device");
    devices.setCurrentIndex(devices.findData(QString(device)));
    agree();
    press_start();
  }
  void close_session() {
    click(experimenter(), "close");
    wait_for("the end of the session's windows", [&] { return desk->runner() == nullptr; });
  }
  /// The first of the ready-made reasons, in the language of the windows.
  void give_first_reason(QWidget& in) {
    auto& form = child<ReasonForm>(in, "reason_form");
    wait_for("the question for a reason", [&] { return form.isVisible(); });
    for (QPushButton* button : form.findChildren<QPushButton*>()) {
      if (!button->isVisible() || !button->objectName().isEmpty()) continue;
      click(*button);
      click(form, "reason_given");
      return;
    }
    throw std::runtime_error("no reason is offered");
  }
  void write_note(const QString& text) {
    key(Qt::Key_F2);
    child<QLineEdit>(experimenter(), "note").setText(text);  // no key of QTest has an umlaut
    key(Qt::Key_Return);
  }
  void decide(QWidget& page, const char* button, const QString& reason) {
    const auto& form = child<QWidget>(page, "decision_form");
    wait_for("the form", [&] {  // the page may close it when it reads the study again
      if (!form.isVisible()) click(page, button);
      return form.isVisible();
    });
    child<QComboBox>(page, "decision_reason").setEditText(reason);
    child<QLineEdit>(page, "decision_by").setText("A. Keller");
    click(page, "decision_write");
    wait_for("the decision", [&] { return !form.isVisible(); });
  }
  /// From the Sessions page.
  QWidget& show_trials_of(const QString& participant) {
    window->show_page("sessions");
    click_row(*window, "sessions_table", participant);
    click(*window, "sessions_open");
    wait_for("the trials", [&] { return window->shown_page() == "trials"; });
    return *window->page("trials");
  }
  QWidget& show_attempt(int row) {
    auto& trials = child<StudyTable>(*window, "trials_table");
    wait_for("the attempts", [&] { return trials.shown_rows() > row; });
    trials.selectRow(row);
    click(*window, "trials_open");
    wait_for("the attempt", [&] { return window->shown_page() == "attempt"; });
    QWidget& page = *window->page("attempt");
    const auto& number = child<QLabel>(page, "attempt_place");
    wait_for("its number",
             [&] { return number.text().startsWith(QString("%1 of ").arg(row + 1)); });
    return page;
  }
};

TEST_F(MakeStudies, Simulated) {
  const std::vector<std::string> protocols{"selection.json", "matching.json", "recognition.json",
                                           "magnitude.json", "two_bodies.json"};
  const fs::path study =
      made("simulated", {"walnut", "slate", "cork", "fine", "middle", "coarse"}, protocols);
  const fs::path box = home() / "rasp.obj";
  write_file(box,
             "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nv -2 -2 4\nv 2 -2 4\nv 2 2 4\nv -2 2 4\n"
             "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\n"
             "f 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n",
             Overwrite::refuse);
  must({"bake", box, "--triangles", "12", "--for", "tool", "--out",
        study / "stimuli" / "rasp.mesh"});
  std::vector<std::string> words{"simulate", "--study", study,          "--participants", "3",
                                 "--seed",   "11",      "--recordings", "first"};
  for (const std::string& protocol : protocols) words.push_back(study / "protocols" / protocol);
  must(words);
}

// --- people ---------------------------------------------------------------------------------------

TEST_F(MakeStudies, PeopleBegin) {
  made("people", {"walnut", "slate", "cork", "fine", "middle", "coarse"},
       {"selection.json", "matching.json", "recognition.json", "magnitude.json"});
}

TEST_F(MakeStudies, PeopleInEnglishWindows) {
  open_windows("people");
  start_as("P01", "choose", "mode_run");
  take_part(chooses_a(), [&] { return is_in(SessionPhase::contact, 1); });
  wait_for("a force", [&] { return is_pushed(1); });
  key(Qt::Key_F12);
  wait_for("the fault", [&] { return is_in(SessionPhase::fault); });
  auto& panel = child<FaultPanel>(experimenter(), "fault_panel");
  wait_for("the panel", [&] { return panel.isVisible(); });
  click(panel, "fault_safe");
  click(panel, "fault_clear");
  take_part(chooses_a(), [&] { return is_in(SessionPhase::contact, 3); });
  write_note("looked away, 2 s");
  key(Qt::Key_R, Qt::ControlModifier);  // trial 3
  give_first_reason(experimenter());
  take_part(chooses_a(), [&] { return is_in(SessionPhase::contact, 4); });
  click(experimenter(), "unblind");
  give_first_reason(experimenter());
  take_part([&](const Scene&) { choose(Qt::Key_B); });
  close_session();

  start_as("P02", "choose", "mode_run");
  take_part([&](const Scene&) { choose(Qt::Key_C); });
  close_session();

  show_trials_of("P01");
  decide(show_attempt(1), "attempt_flag", "hesitated for long");
  show_trials_of("P01");
  decide(show_attempt(2), "attempt_exclude", "interrupted by a fire alarm");
  QWidget& page = show_trials_of("P02");
  decide(page, "trials_exclude", "was run to try things out");
}

TEST_F(MakeStudies, PeopleInGermanWindows) {
  apply_language("de");
  open_windows("people");
  start_as("P03", "recognise", "mode_run");
  take_part([&](const Scene&) { choose(Qt::Key_2); },
            [&] { return is_in(SessionPhase::contact, 2); });
  wait_for("the surface in the window", [&] { return view().scene().kind == Scene::Kind::feel; });
  wait_for("it to be perceived", [&] { return can_be_perceived(); });
  key(Qt::Key_A);  // refused: nothing is asked yet
  write_note(QString::fromUtf8("Hörte kurz auf"));
  key(Qt::Key_R, Qt::ControlModifier);
  give_first_reason(experimenter());
  take_part([&](const Scene&) { choose(Qt::Key_2); },
            [&] { return is_in(SessionPhase::contact, 6); });
  click(experimenter(), "unblind");
  give_first_reason(experimenter());
  take_part([&](const Scene&) { choose(Qt::Key_1); });
  close_session();
  apply_language("en");
}

TEST_F(MakeStudies, PeopleByMouse) {
  open_windows("people");
  start_as("P04", "match", "mode_run", "mouse");
  int enough_of = 0;
  bool is_down = false;
  int steps = 0;
  int trial = 0;
  // Holds the button and strokes while a surface can be felt.
  const auto stroke = [&] {
    const SessionSnapshot now = monitor().snapshot();
    if (now.trial != trial) enough_of = 0;
    trial = now.trial;
    if (is_in(SessionPhase::contact) && now.contact_s > 0.6 && now.surface != enough_of) {
      enough_of = now.surface;
      key(Qt::Key_Space);
    }
    const bool can_be_felt =
        is_in(SessionPhase::fore) || (is_in(SessionPhase::contact) && now.surface != enough_of);
    const QPoint middle = view().rect().center();
    if (can_be_felt && !is_down) {
      QTest::mouseMove(&view(), middle);
      QTest::mousePress(&view(), Qt::LeftButton, {}, middle);
      is_down = true;
    } else if (can_be_felt) {
      ++steps;
      QTest::mouseMove(&view(), middle + QPoint(30 - steps % 60, 0));
    } else if (is_down) {
      QTest::mouseRelease(&view(), Qt::LeftButton, {}, middle);
      is_down = false;
    }
  };
  take_part(
      [&](const Scene&) {
        wait_for("the pictures", [&] { return view().pictures_are_there(); });
        for (const Qt::Key picture : {Qt::Key_1, Qt::Key_2, Qt::Key_3}) key(picture);
        wait_for("a complete answer", [&] { return view().scene().can_confirm; });
        key(Qt::Key_Return);
      },
      [&] {
        stroke();
        return !desk->is_running();
      });
  close_session();
}

TEST_F(MakeStudies, PeopleAtATerminal) {
  const fs::path study = place_of("people");
  Program program(on_terminal({"run", study / "protocols" / "magnitude.json", "--study", study,
                               "--participant", "P05", "--mode", "pilot", "--seed", "13"}));
  int numbers = 0;
  sit_at_terminal(program, [&](const std::string& asked) -> std::string {
    if (asked.ends_with("Your answer: ")) return "1";
    if (!asked.ends_with("Your number: ")) return "";
    // A tenth of an earlier number for the same stimulus is doubted.
    static const std::vector<std::string> kNumbers{"20", "8",  "12.5", "30", "300",
                                                   "25", "10", "15",   "40"};
    return kNumbers.at(static_cast<std::size_t>(numbers++));
  });
  const test::Outcome outcome = program.finish();
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

// --- interrupted sessions -------------------------------------------------------------------------

TEST_F(MakeStudies, InterruptedBegins) {
  made("interrupted", {"walnut", "slate", "cork"}, {"selection.json", "recognition.json"});
}

/// A power failure in trial 2.
TEST_F(MakeStudies, InterruptedByDeath) {
  open_windows("interrupted");
  start_as("P01", "recognise", "mode_run");
  take_part([&](const Scene&) { choose(Qt::Key_2); },
            [&] { return is_in(SessionPhase::contact, 2); });
  std::raise(SIGKILL);
}

/// The experimenter aborts in trial 2.
TEST_F(MakeStudies, InterruptedInGermanWindows) {
  apply_language("de");
  open_windows("interrupted");
  start_as("P03", "choose", "mode_run");
  take_part(chooses_a(), [&] { return is_in(SessionPhase::contact, 2); });
  key(Qt::Key_Q, Qt::ControlModifier | Qt::ShiftModifier);
  give_first_reason(child<QDialog>(experimenter(), "abort_dialog"));
  wait_for_end();
  close_session();
  apply_language("en");
}

TEST_F(MakeStudies, InterruptedSimulation) {
  const fs::path study = place_of("interrupted");
  test::Invocation invocation{};
  invocation.arguments = {"simulate",
                          study / "protocols" / "selection.json",
                          study / "protocols" / "recognition.json",
                          "--study",
                          study,
                          "--participants",
                          "2",
                          "--seed",
                          "14",
                          "--recordings",
                          "none"};
  Program program(invocation);
  ASSERT_TRUE(program.read_until(
      [](const std::string&, const std::string& err) { return done_in(err) >= 6; }));
  program.send(SIGKILL);
  ASSERT_EQ(program.finish().signal, SIGKILL);
}

/// Ctrl-C in trial 2, which is completed first.
TEST_F(MakeStudies, InterruptedAtATerminal) {
  const fs::path study = place_of("interrupted");
  Program program(on_terminal({"run", study / "protocols" / "selection.json", "--study", study,
                               "--participant", "P02", "--mode", "pilot", "--seed", "15"}));
  const auto answer = [](const std::string& asked) -> std::string {
    if (asked.ends_with("Your answer: ")) return "1";
    return "";
  };
  sit_at_terminal(
      program,
      [&](const std::string& asked) {
        // The question for the age has no numbered options.
        return asked.find("How old are you") != std::string::npos &&
                       asked.rfind("How old are you") > asked.rfind("  1  ")
                   ? std::string("31")
                   : answer(asked);
      },
      [&] { return done_in(program.err()) >= 1; });
  program.type("\x03");
  sit_at_terminal(program, answer);
  const test::Outcome outcome = program.finish();
  ASSERT_EQ(outcome.status, 1) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace asperity
