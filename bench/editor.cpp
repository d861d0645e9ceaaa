// The editor of a protocol with 500 trials: how long its pages, a keystroke, the examination of the stimuli and a step of the
// participant's screen take.
//
// A study with the textures of the demonstration is made in a temporary folder, and edited off screen. Times are by the wall,
// from the key to what it changes on the screen; `NAME/longest` is the longest task of the windows' thread in processor time.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <QtCore/QElapsedTimer>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <nlohmann/json.hpp>

#include "app/gui/editor/form/form_part.h"
#include "app/gui/editor/form/protocol_form.h"
#include "app/gui/editor/protocol_editor_page.h"
#include "app/gui/editor/protocol_text_edit.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/plan/plan_preview.h"
#include "app/gui/window/study_window.h"
#include "app/tasks/new_study.h"
#include "app/tasks/protocol_templates.h"
#include "bench/timed_application.h"
#include "device/machine.h"
#include "protocols/editing/edits.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {
namespace {

/// The times of one action, repeated.
struct Case {
  std::string name{};
  std::vector<double> times_s{};
  std::vector<double> longest_s{};
};

double quantile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(part * last + 0.5)];
}

template <class Widget>
Widget& named(const QWidget& window, const char* name) {
  auto* widget = window.findChild<Widget*>(QString::fromUtf8(name));
  if (widget == nullptr) throw std::runtime_error(std::string("no ") + name);
  return *widget;
}

/// Ten textures, fifty times each.
std::filesystem::path make_protocol(const std::filesystem::path& study) {
  new_study(study);
  const std::filesystem::path file =
      protocol_from_template(study, {.name = "semantic_differential",
                                     .textures = {.from = TemplateTextures::From::demonstration}});
  const std::string text = read_file(file, kProtocolFile);
  write_file(file,
             changed(text, set_value(JsonDocument(text, {}), "/blocks/ratings/repetitions", "50")),
             Overwrite::allow);
  return file;
}

class EditorBench final {
 public:
  EditorBench(TimedApplication& application, const std::filesystem::path& folder, int rounds)
      : application_(application), rounds_(rounds), file_(make_protocol(folder)) {
    window_.resize(1920, 1080);
    window_.show();
    if (!window_.open_study(folder)) throw std::runtime_error("the study cannot be opened");
  }

  std::vector<Case> run() {
    window_.show_page("editor");
    editor_ = window_.findChild<ProtocolEditorPage*>();
    plan_ = editor_->findChild<PlanPreview*>();
    QObject::connect(plan_, &PlanPreview::step_shown, plan_, [this] { is_planned_ = true; });
    Case open{"open"};
    time(
        open, [this] { editor_->open(file_); }, [this] { return is_up_to_date(); });
    cases_.push_back(open);
    open_pages();
    type_in_form();
    type_in_text();
    step_screens();
    type_with_screen();
    examine();
    return std::move(cases_);
  }

 private:
  /// Does it and lets the windows work until `is_done`; then what has changed is painted.
  void time(Case& of, const std::function<void()>& begin, const std::function<bool()>& is_done) {
    constexpr qint64 kPatience_ms = 30'000;
    settle();
    // Without an event the windows would wait for ever for what does not come.
    QTimer wake{};
    wake.start(1'000);
    application_.longest = {};
    is_planned_ = false;
    QElapsedTimer wall{};
    wall.start();
    application_.longest.time(begin, [] { return std::string("the call itself"); });
    while (!is_done()) {
      if (wall.elapsed() > kPatience_ms)
        throw std::runtime_error(of.name + ": it did not end" + what_is_wrong());
      QApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
    }
    settle();
    of.times_s.push_back(static_cast<double>(wall.nsecsElapsed()) * 1e-9);
    of.longest_s.push_back(application_.longest.cpu_s);
  }
  /// Layouts and paints what is pending.
  static void settle() {
    QApplication::processEvents();
    QApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    QApplication::processEvents();
  }
  static void press(QWidget& widget, int key, const QString& letter) {
    for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
      QKeyEvent event(type, key, Qt::NoModifier, letter);
      QApplication::sendEvent(&widget, &event);
    }
  }
  std::string what_is_wrong() const {
    if (!editor_->is_checked()) return ", nor did the check";
    const auto result = editor_->result();
    return result->diagnostics.empty() ? std::string()
                                       : ": " + result->diagnostics.front().message.english();
  }
  bool is_up_to_date() const {
    return is_planned_ && editor_->is_checked() && editor_->result()->is_valid();
  }

  void open_pages() {
    auto& pages = named<QListWidget>(window_, "form_pages");
    for (int page = 0; page < pages.count(); ++page) {
      Case one{"page/" + std::string(form_pages()[static_cast<std::size_t>(page)].id)};
      for (int round = 0; round < rounds_; ++round) {
        pages.setCurrentRow(page == 0 ? 1 : 0);
        time(
            one, [&] { pages.setCurrentRow(page); }, [] { return true; });
      }
      cases_.push_back(one);
    }
    pages.setCurrentRow(0);
    settle();
  }

  void type_in(const std::string& name, QWidget& field) {
    Case one{name};
    for (int round = 0; round < rounds_; ++round) {
      time(
          one, [&] { press(field, Qt::Key_X, "x"); }, [this] { return is_up_to_date(); });
    }
    cases_.push_back(one);
  }
  void type_in_form() {
    QWidget* const field = named<FormPart>(window_, "/title").focusProxy();
    field->setFocus();
    type_in("key/form", *field);
  }
  void type_in_text() {
    named<QPushButton>(window_, "editor_to_text").click();
    auto& edit = named<ProtocolTextEdit>(window_, "editor_text");
    QTextCursor cursor = edit.document()->find("\"title\": \"");
    cursor.setPosition(cursor.selectionEnd());
    edit.setTextCursor(cursor);
    edit.setFocus();
    type_in("key/text", edit);
  }

  void step_screens() {
    named<QPushButton>(window_, "editor_show_screen").click();
    settle();
    plan_->select_step(0);
    auto& next = named<QPushButton>(window_, "screen_next");
    Case one{"screen_step"};
    for (int round = 0; round < 4 * rounds_; ++round) {
      time(
          one, [&next] { next.click(); }, [] { return true; });
    }
    cases_.push_back(one);
  }
  void type_with_screen() {
    type_in("key/text_and_screen", named<ProtocolTextEdit>(window_, "editor_text"));
  }

  /// From the key to its sign, and to the end.
  void examine() {
    const auto& state = named<StateLabel>(window_, "editor_state");
    const auto is_shown = [&state] { return state.text().contains("being examined"); };
    auto& edit = named<ProtocolTextEdit>(window_, "editor_text");
    Case begun{"examination/sign"};
    Case ended{"examination/end"};
    for (int round = 0; round < std::min(rounds_, 5); ++round) {
      time(
          begun, [&] { press(edit, Qt::Key_X, "x"); }, is_shown);
      time(
          ended, [] {}, [&] { return !is_shown(); });
      ended.times_s.back() += begun.times_s.back();
    }
    cases_.push_back(begun);
    cases_.push_back(ended);
  }

  TimedApplication& application_;
  int rounds_;
  std::filesystem::path file_;
  StudyWindow window_{};
  ProtocolEditorPage* editor_ = nullptr;
  PlanPreview* plan_ = nullptr;
  bool is_planned_ = false;
  std::vector<Case> cases_{};
};

void print(const std::vector<Case>& cases, bool json) {
  constexpr double kTail = 0.99;
  if (!json) {
    std::printf("%-24s %9s %9s %9s   %s\n", "", "p50, ms", "p99, ms", "count",
                "longest task of the windows' thread, ms");
    for (const Case& one : cases) {
      std::printf("%-24s %9.1f %9.1f %9zu   %.1f\n", one.name.c_str(),
                  1e3 * quantile(one.times_s, 0.5), 1e3 * quantile(one.times_s, kTail),
                  one.times_s.size(), 1e3 * quantile(one.longest_s, kTail));
    }
    return;
  }
  nlohmann::ordered_json document{{"format", "asperity.bench/1"},
                                  {"machine", machine()},
                                  {"commit", ASPERITY_COMMIT},
                                  {"cases", nlohmann::ordered_json::array()}};
  for (const Case& one : cases) {
    for (const auto& [name, values] :
         {std::pair{one.name, one.times_s}, std::pair{one.name + "/longest", one.longest_s}}) {
      document["cases"].push_back({{"name", name},
                                   {"unit", "s"},
                                   {"p50", quantile(values, 0.5)},
                                   {"p99", quantile(values, kTail)},
                                   {"count", values.size()}});
    }
  }
  std::cout << document.dump(2) << '\n';
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool json = arguments == std::vector<std::string>{"--json"};
  if (!arguments.empty() && !json) {
    std::cerr << "bench_editor [--json]\n";
    return 2;
  }
  constexpr int kRounds = 20;
  const QTemporaryDir home{};
  qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  try {
    asperity::TimedApplication application(argc, argv);
    QApplication::setOrganizationName("asperity");
    QApplication::setApplicationName("asperity");
    asperity::apply_theme(application, asperity::ThemeChoice::light);
    const std::filesystem::path study = home.filePath("study").toStdString();
    asperity::print(asperity::EditorBench(application, study, kRounds).run(), json);
  } catch (const std::exception& error) {
    std::cerr << "bench_editor: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
