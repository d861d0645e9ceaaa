// A large study in the window: how long it takes until it can be used, and for how long the thread of
// the windows is kept from answering.
//
// `--study DIR` opens it off screen, as somebody does who then looks at its sessions, the trials of
// one and the analysis. Each step is measured by the wall, of the processor (all threads) and by the
// longest piece of work of the windows' thread, of which the processor time is told: that is how long
// a click would wait on a machine with nothing beside it.

#include "app/gui/window/study_window.h"

#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <QtCore/QElapsedTimer>
#include <QtCore/QTemporaryDir>
#include <QtWidgets/QPushButton>
#include <nlohmann/json.hpp>

#include "app/gui/base/study_table.h"
#include "app/gui/data/analysis_page.h"
#include "app/gui/look/theme.h"
#include "bench/timed_application.h"
#include "device/machine.h"

namespace asperity {
namespace {

struct Step {
  std::string name{};
  double wall_s = 0.0;
  double cpu_s = 0.0;
  LongestWork longest{};
};

/// Does `begin`, and lets the windows work until `is_done`.
Step step(TimedApplication& application, const std::string& name,
          const std::function<void()>& begin, const std::function<bool()>& is_done) {
  constexpr qint64 kPatience_ms = 1'800'000;
  application.longest = {};
  QElapsedTimer wall{};
  wall.start();
  const double began_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
  application.longest.time(begin, [] { return std::string("the call itself"); });
  while (!is_done()) {
    if (wall.elapsed() > kPatience_ms) throw std::runtime_error(name + ": it did not end");
    QApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
  }
  const Step taken{name, static_cast<double>(wall.nsecsElapsed()) * 1e-9,
                   seconds_of(CLOCK_PROCESS_CPUTIME_ID) - began_s, application.longest};
  // What is painted next is a step's own.
  application.longest = {};
  for (int i = 0; i < 10; ++i) QApplication::processEvents();
  Step with_paint = taken;
  if (application.longest.cpu_s > with_paint.longest.cpu_s) {
    with_paint.longest = application.longest;
  }
  return with_paint;
}

template <class Widget>
Widget& named(QWidget& window, const char* name) {
  auto* widget = window.findChild<Widget*>(name);
  if (widget == nullptr) throw std::runtime_error(std::string("no ") + name);
  return *widget;
}

std::vector<Step> steps(TimedApplication& application, const std::filesystem::path& folder) {
  std::vector<Step> taken{};
  StudyWindow window{};
  window.resize(1920, 1080);
  window.show();
  for (int i = 0; i < 10; ++i) QApplication::processEvents();
  const auto rows = [&window](const char* table) {
    const auto* found = window.findChild<StudyTable*>(table);
    return found == nullptr ? 0 : found->shown_rows();
  };
  taken.push_back(step(
      application, "open",
      [&] {
        if (!window.open_study(folder)) throw std::runtime_error("the study cannot be opened");
      },
      [&] { return rows("sessions_table") > 0 && rows("participants_table") > 0; }));
  for (const char* page : {"participants", "sessions"}) {
    taken.push_back(step(
        application, std::string("show_") + page, [&] { window.show_page(page); },
        [] { return true; }));
  }
  auto& sessions = named<StudyTable>(window, "sessions_table");
  taken.push_back(step(
      application, "show_trials",
      [&] {
        sessions.selectRow(0);
        named<QPushButton>(window, "sessions_open").click();
      },
      [&] { return rows("trials_table") > 0; }));
  bool analysed = false;
  auto& analysis = named<AnalysisPage>(window, "analysis_page");
  QObject::connect(&analysis, &AnalysisPage::refreshed, [&analysed] { analysed = true; });
  taken.push_back(step(
      application, "show_analysis", [&] { window.show_page("analysis"); },
      [&] { return analysed; }));
  return taken;
}

nlohmann::ordered_json case_of(const std::string& name, double value_s) {
  return {{"name", name}, {"unit", "s"}, {"p50", value_s}, {"count", 1}};
}

void print(const std::vector<Step>& steps, bool json) {
  if (!json) {
    for (const Step& step : steps) {
      std::printf("%-20s %8.3f s, %7.3f s of processor; windows' thread at most %6.1f ms: %s\n",
                  step.name.c_str(), step.wall_s, step.cpu_s, 1e3 * step.longest.cpu_s,
                  step.longest.what.c_str());
    }
    return;
  }
  nlohmann::ordered_json document{{"format", "asperity.bench/1"},
                                  {"machine", machine()},
                                  {"commit", ASPERITY_COMMIT},
                                  {"cases", nlohmann::ordered_json::array()}};
  for (const Step& step : steps) {
    document["cases"].push_back(case_of(step.name, step.wall_s));
    document["cases"].push_back(case_of(step.name + "/cpu", step.cpu_s));
    document["cases"].push_back(case_of(step.name + "/longest", step.longest.cpu_s));
  }
  std::cout << document.dump(2) << '\n';
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 2 || arguments[0] != "--study") {
    std::cerr << "bench_study_window --study DIR [--json]\n";
    return 2;
  }
  const QTemporaryDir home{};  // nobody's own list of studies
  qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  try {
    asperity::TimedApplication application(argc, argv);
    QApplication::setOrganizationName("asperity");
    QApplication::setApplicationName("asperity");
    asperity::apply_theme(application, asperity::ThemeChoice::light);
    asperity::Study::read_beside_writers();
    asperity::print(asperity::steps(application, arguments[1]),
                    arguments.size() > 2 && arguments[2] == "--json");
  } catch (const std::exception& error) {
    std::cerr << "bench_study_window: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
