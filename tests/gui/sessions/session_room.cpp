// Writes protocols, opens the windows, and waits for phases, keys and stored rows with a time limit.

#include "tests/gui/sessions/session_room.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include <QtCore/QThread>
#include <QtGui/QGuiApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include "analysis/numbers/number_text.h"
#include "app/gui/base/study_table.h"
#include "app/study_files/height_field_files.h"
#include "app/tasks/protocol_files.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/photographs/preview.h"
#include "tests/app/punctual_trial.h"
#include "tests/support/patient_servo.h"

namespace asperity {

namespace {

std::string levels(int count) {
  std::string text = "1";
  for (int level = 2; level <= count; ++level) text += ", " + std::to_string(level);
  return text;
}

std::string block_of(const ProtocolWish& wish) {
  const std::string common = R"("exploration": "short", "pause_before_trial_s": 0,
      "pause_between_surfaces_s": 0, )";
  if (wish.kind == "matching") {
    return common + R"("crossed": ["go"], "positions": "shuffle",
      "presented": [{"stimulus": "rendered", "with": {"texture": "slate", "model": "height_map"}},
                    {"stimulus": "rendered", "with": {"texture": "cork", "model": "height_map"}},
                    {"stimulus": "rendered", "with": {"texture": "linen", "model": "height_map"}}],
      "question": {"name": "match", "prompt": "Which picture belongs to which surface?",
                   "pictures": ["slate", "cork", "linen"], "reshuffle_pictures": true,
                   "pictures_after_feeling": true, "allow_revisit": false)" +
           wish.question + "}";
  }
  if (wish.kind == "recognition") {
    return common + R"("crossed": ["texture"],
      "presented": [{"stimulus": "rendered", "with": {"model": "height_map"}}],
      "question": {"name": "felt", "prompt": "Which one was it?",
                   "pictures": ["slate", "cork", "linen"], "reshuffle_pictures": true,
                   "pictures_after_feeling": true, "allow_revisit": false, "correct_factor": "texture")" +
           wish.question + "}";
  }
  return common + R"("crossed": ["go"], "positions": "shuffle",
      "presented": [{"stimulus": "rendered", "with": {"texture": "slate", "model": "height_map"}},
                    {"stimulus": "rendered", "with": {"texture": "slate", "model": "stochastic"}}],
      "question": {"name": "best", "prompt": "Which felt more real?")" +
         wish.question + "}";
}

std::string protocol_text(const ProtocolWish& wish) {
  std::string textures{};
  for (const std::string name : {"slate", "cork", "linen"}) {
    textures += (textures.empty() ? "" : ", ") + ('"' + name) + R"(": {"height_field": "stimuli/)" +
                name + R"(.png", "picture": "stimuli/)" + name + R"(_photo.png"})";
  }
  return R"({
  "format": "asperity.protocol/1", "kind": ")" +
         wish.kind + R"(", "design": "improved", "name": ")" + wish.name +
         R"(", "version": "1.0.0", "title": "A short session",
  "consent": {"version": "1.0", "statement": "I take part."},)" +
         (wish.kind == "selection" ? R"( "realism_standard": "memory",)" : "") + R"(
  "device": {"input_only": true, "rate_Hz": 200, "maximum_missed_deadlines": 100000, "maximum_gaps_in_contact": 100000, "maximum_lost_records": 100000},
  "textures": {)" +
         textures + R"(},
  "factors": {"go": {"levels": [)" +
         levels(wish.kind == "matching" ? 2 : wish.trials) +
         R"(]}, "texture": {"levels": ["slate", "cork", "linen"]},
              "model": {"levels": ["height_map", "stochastic"]}},
  "stimuli": {"rendered": {"model": {"factor": "model"}, "texture": {"factor": "texture"}}},
  "explorations": {"short": {"maximum_contact_s": 4, "minimum_contact_s": )" +
         number_text(wish.minimum_contact_s) + R"(}},
  "questions": {"comfort": {"prompt": "How is your hand?", "form": "choice", "options": ["well", "tired"]},
                "age": {"prompt": "How old are you?", "form": "number", "minimum": 18},
                "remarks": {"prompt": "What was it like?", "form": "text", "optional": true}},
  "blocks": {"main": {)" +
         block_of(wish) + "}" +
         (wish.blocks > 1 ? R"(, "second": {)" + block_of(wish) + "}" : std::string()) + R"(},
  "flow": [)" +
         wish.flow + "]" + wish.head + "}";
}

}  // namespace

SessionRoom::SessionRoom() = default;

SessionRoom::~SessionRoom() { close_windows(); }

// --- the study -----------------------------------------------------------------------------------

void SessionRoom::make_study() {
  std::filesystem::create_directories(folder().parent_path());
  Study::create(folder(), "small");
  std::filesystem::create_directories(folder() / "protocols");
  std::uint64_t seed = 5;
  for (const std::string name : {"slate", "cork", "linen"}) {
    const HeightField field =
        make_surface("noise", {}, SurfaceCanvas{.width_m = 0.02, .pixels = 128, .seed = seed++});
    save_height_field(folder() / "stimuli" / (name + ".png"), field, {.kind = "noise"},
                      Overwrite::refuse);
    save_picture(folder() / "stimuli" / (name + "_photo.png"), height_picture(field),
                 Overwrite::refuse);
  }
}

void SessionRoom::add_protocol(const ProtocolWish& wish) {
  const std::filesystem::path file = folder() / "protocols" / (wish.name + ".json");
  write_file(file, protocol_text(wish), Overwrite::refuse);
  load_protocol(file, built_in_models(), folder());  // says here what is wrong with it
}

SessionRow SessionRoom::stored_session() const {
  const Study study = Study::open(folder(), Access::read_only);
  const std::vector<SessionRow> sessions = study.sessions();
  const auto newest =
      std::max_element(sessions.begin(), sessions.end(),
                       [](const SessionRow& a, const SessionRow& b) { return a.id < b.id; });
  return newest == sessions.end() ? SessionRow{} : *newest;
}

std::vector<AttemptRow> SessionRoom::stored_attempts() const {
  return Study::open(folder(), Access::read_only).attempts(stored_session().id);
}

std::vector<EventRow> SessionRoom::stored_events() const {
  const Study study = Study::open(folder(), Access::read_only);
  const std::int64_t session = stored_session().id;
  std::vector<EventRow> events = study.events(session);
  for (const AttemptRow& attempt : study.attempts(session)) {
    events.insert(events.end(), attempt.events.begin(), attempt.events.end());
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const EventRow& a, const EventRow& b) { return a.time_ns < b.time_ns; });
  return events;
}

std::vector<EventRow> SessionRoom::stored_events(const std::string& kind) const {
  std::vector<EventRow> events = stored_events();
  std::erase_if(events, [&](const EventRow& event) { return event.kind != kind; });
  return events;
}

std::vector<std::string> SessionRoom::stored_outcomes() const {
  std::vector<std::string> outcomes{};
  for (const AttemptRow& attempt : stored_attempts()) {
    outcomes.push_back(std::to_string(attempt.trial) + "/" + std::to_string(attempt.attempt) + " " +
                       asperity::text_of(attempt.outcome) + (attempt.valid ? "" : ", not valid"));
  }
  return outcomes;
}

// --- the windows ---------------------------------------------------------------------------------

void SessionRoom::make_windows() {
  window = std::make_unique<StudyWindow>();
  desk = std::make_unique<SessionDesk>(*window, nullptr, [this](const SessionOrder& order) {
    sound_is_made_by_a_window = QThread::currentThread() == qApp->thread();
    return order.inputs.is_virtual ? nullptr : std::make_unique<ScriptedSound>(sound);
  });
  window->resize(1366, 768);
  window->show();
  window->activateWindow();
}

void SessionRoom::close_windows() {
  desk.reset();
  window.reset();
}

void SessionRoom::open() {
  make_windows();
  window->open_study(folder());
  wait_for("the study", [this] { return window->study() != nullptr; });
  window->study()->set_device_trial(punctual_trial);
  window->study()->set_servo(patient_servo());
}

bool SessionRoom::is_in(SessionPhase phase) {
  return desk->runner() != nullptr && monitor().snapshot().phase == phase;
}

bool SessionRoom::is_in(SessionPhase phase, int trial) {
  return is_in(phase) && monitor().snapshot().trial == trial;
}

bool SessionRoom::is_pushed(int trial) {
  if (!is_in(SessionPhase::contact, trial)) return false;
  std::vector<LiveBin> bins{};
  monitor().bins_from(0, bins);
  return !bins.empty() && bins.back().touching && bins.back().force_minimum_N > 0.1F;
}

bool SessionRoom::can_be_perceived() {
  const SessionSnapshot now = monitor().snapshot();
  const auto shown_s = 1e-9 * static_cast<double>(now.now_ns - now.scene->shown_ns);
  return shown_s > PersonAtWindow::kTooSoon_s;
}

void SessionRoom::wait_until_feeling_again_counts() {
  wait_for("feeling again to count", [this] {
    const SessionSnapshot now = monitor().snapshot();
    const auto shown_s = 1e-9 * static_cast<double>(now.now_ns - now.scene->shown_ns);
    return shown_s > PersonAtWindow::kUnexpected_s;
  });
}

// --- hands ---------------------------------------------------------------------------------------

void SessionRoom::require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

void SessionRoom::wait_for(const std::string& what, const std::function<bool()>& condition) {
  require(until(condition), "waited in vain for " + what);
}

bool SessionRoom::until(const std::function<bool()>& condition) { return eventually(condition); }

void SessionRoom::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  if (QGuiApplication::focusWindow() == nullptr) {
    // Off screen nobody hands the focus on when a window goes.
    (desk->session_window() != nullptr ? static_cast<QWidget*>(desk->session_window())
                                       : window.get())
        ->activateWindow();
  }
  wait_for("a window with the focus", [] { return QGuiApplication::focusWindow() != nullptr; });
  QTest::keyClick(QGuiApplication::focusWindow(), key, modifiers);
}

void SessionRoom::click(QWidget& widget) {
  wait_for(widget.objectName().toStdString() + " to be pressed",
           [&] { return widget.isVisible() && widget.isEnabled(); });
  ++clicks;
  // Off screen nobody activates the window that is clicked.
  QWidget* top = widget.window();
  top->activateWindow();
  wait_for("the focus", [&] { return QGuiApplication::focusWindow() == top->windowHandle(); });
  const bool is_box = qobject_cast<QCheckBox*>(&widget) != nullptr;
  QTest::mouseClick(&widget, Qt::LeftButton, {},
                    is_box ? QPoint(8, widget.height() / 2) : widget.rect().center());
}

void SessionRoom::click_row(QWidget& in, const char* table, const QString& with_text) {
  auto& rows = child<StudyTable>(in, table);
  QModelIndex found{};
  wait_for(std::string("a row of ") + table + " with " + with_text.toStdString(), [&] {
    for (int row = 0; row < rows.shown_rows(); ++row) {
      for (int column = 0; column < rows.model()->columnCount(); ++column) {
        if (rows.text_at(row, column).contains(with_text)) found = rows.model()->index(row, column);
      }
    }
    return found.isValid() && rows.isVisible();
  });
  ++clicks;
  QTest::mouseClick(rows.viewport(), Qt::LeftButton, {}, rows.visualRect(found).center());
}

QPoint SessionRoom::place_of(ParticipantItem::Kind kind, const QString& key) {
  // In a narrow window, as it is printed on the key.
  const QString sign = key == "Return" ? QStringLiteral("⏎") : key;
  for (const ParticipantItem& item : view().items()) {
    const bool has_key = item.key == key || item.key == sign;
    if (item.kind == kind && has_key) return item.rect.center().toPoint();
  }
  ADD_FAILURE() << "nothing has the key " << key.toStdString();
  return {};
}

void SessionRoom::click_item(ParticipantItem::Kind kind, const QString& key) {
  QTest::mouseClick(&view(), Qt::LeftButton, {}, place_of(kind, key));
}

// --- what people do ------------------------------------------------------------------------------

void SessionRoom::start(const QString& protocol, const char* mode) {
  window->show_page("protocols");
  click_row(*window, "protocols_table", protocol);
  click(*window, "protocol_start");
  wait_for("the start page", [&] { return window->shown_page() == "start"; });
  click(*window, mode);
  agree();
  press_start();
}

void SessionRoom::start_by_mouse(const QString& protocol, const char* mode) {
  window->show_page("protocols");
  click_row(*window, "protocols_table", protocol);
  click(*window, "protocol_start");
  wait_for("the start page", [&] { return window->shown_page() == "start"; });
  click(*window, mode);
  auto& devices = child<QComboBox>(*window->page("start"), "device");
  devices.setCurrentIndex(devices.findData("mouse"));
  require(devices.currentData().toString() == "mouse", "there is no mouse to choose");
  agree();
  press_start();
}

void SessionRoom::stroke_by_mouse(double contact_s) {
  constexpr std::int64_t kPressedInVain_ns = 1'000'000'000;
  const SessionSnapshot now = monitor().snapshot();
  if (now.trial != stroked_trial_) enough_of_ = 0;
  stroked_trial_ = now.trial;
  if (is_in(SessionPhase::contact) && now.contact_s > contact_s && now.surface != enough_of_) {
    enough_of_ = now.surface;
    key(Qt::Key_Space);
  }
  const bool can_be_felt =
      is_in(SessionPhase::fore) || (is_in(SessionPhase::contact) && now.surface != enough_of_);
  const QPoint middle = view().surface_rect().value_or(QRectF(view().rect())).center().toPoint();
  // A press on the page before, which was still drawn, touches nothing: a person presses again.
  const bool touches_nothing =
      is_mouse_down_ && is_in(SessionPhase::fore) && now.now_ns - pressed_ns_ > kPressedInVain_ns;
  if (can_be_felt && !is_mouse_down_) {
    QTest::mouseMove(&view(), middle);
    QTest::mousePress(&view(), Qt::LeftButton, {}, middle);
    is_mouse_down_ = true;
    pressed_ns_ = now.now_ns;
  } else if (can_be_felt && !touches_nothing) {
    ++mouse_steps_;
    QTest::mouseMove(&view(), middle + QPoint(30 - mouse_steps_ % 60, 0));
  } else if (is_mouse_down_) {
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, middle);
    is_mouse_down_ = false;
  }
}

void SessionRoom::agree() {
  QWidget& page = *window->page("start");
  click(page, "consent_given");
  auto& seen_by = child<QLineEdit>(page, "consent_seen_by");
  if (seen_by.text().isEmpty()) {  // otherwise remembered from the session before
    click(seen_by);
    QTest::keyClicks(&seen_by, "AB");
  }
  // Where the protocol asks for masking noise: read off a sound level meter.
  auto* level = page.findChild<QDoubleSpinBox*>("measured_level");
  if (level == nullptr || !level->isVisible()) return;
  level->setValue(60.0);
  child<QLineEdit>(page, "verified_by").setText("AB");
}

void SessionRoom::press_start() {
  QWidget& page = *window->page("start");
  auto& button = child<QPushButton>(page, "start");
  // News of the study may take the button away just before it is pressed.
  const bool has_begun = until([&] {
    if (desk->runner() == nullptr && button.isEnabled()) QTest::mouseClick(&button, Qt::LeftButton);
    return desk->runner() != nullptr;
  });
  ++clicks;
  require(has_begun, child<QWidget>(page, "start_reason").toolTip().toStdString());
  wait_for("the session", [&] { return monitor().facts() != nullptr || !desk->is_running(); });
  const std::optional<SessionTrouble> trouble = monitor().snapshot().trouble;
  require(monitor().facts() != nullptr,
          trouble ? trouble->what.english() : "the session did not begin");
}

void SessionRoom::choose(Qt::Key option) {
  key(option);
  wait_for("a complete answer", [&] { return view().scene().can_confirm; });
  key(Qt::Key_Return);
}

void SessionRoom::take_part(const std::function<void(const Scene&)>& answer,
                            const std::function<bool()>& done) {
  std::int64_t acted_on_ns = -1;
  const bool came_to_it = until([&] {
    if (testing::Test::HasFatalFailure()) return true;
    if (done ? done() : !desk->is_running()) return true;
    if (desk->participant_window() == nullptr) return false;
    const Scene scene = view().scene();
    const bool is_shown = scene.shown_ns == monitor().snapshot().scene->shown_ns;
    if (!is_shown || scene.shown_ns == acted_on_ns || !view().waits()) return false;
    if (!can_be_perceived()) return false;
    switch (scene.kind) {
      case Scene::Kind::text:
      case Scene::Kind::mask_on:
      case Scene::Kind::mask_off:
        acted_on_ns = scene.shown_ns;
        key(Qt::Key_Return);
        break;
      case Scene::Kind::question:
        acted_on_ns = scene.shown_ns;
        answer(scene);
        break;
      case Scene::Kind::form:
        acted_on_ns = scene.shown_ns;
        key(Qt::Key_1);
        key(Qt::Key_Return);
        break;
      case Scene::Kind::rest:
        if (monitor().snapshot().now_ns < scene.rest_until_ns.value_or(0)) return false;
        acted_on_ns = scene.shown_ns;
        key(Qt::Key_Return);
        break;
      case Scene::Kind::blank:
      case Scene::Kind::feel:
      case Scene::Kind::feedback:
      case Scene::Kind::paused:
      case Scene::Kind::ended:
        break;
    }
    return false;
  });
  if (came_to_it) return;
  const SessionSnapshot now = desk->runner() == nullptr ? SessionSnapshot{} : monitor().snapshot();
  throw std::runtime_error(std::string("it stays in phase ") + asperity::text_of(now.phase) +
                           ", trial " + std::to_string(now.trial) +
                           (now.trouble ? ": " + now.trouble->what.english() : ""));
}

void SessionRoom::wait_for_end() {
  wait_for("the end", [&] { return !desk->is_running(); });
}

std::vector<std::map<std::string, std::string>> read_exported(const std::filesystem::path& file) {
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char sign : line) {
      if (sign == '\t') {
        cells.emplace_back();
      } else {
        cells.back() += sign;
      }
    }
    return cells;
  };
  std::ifstream stream(file);
  std::string line{};
  std::getline(stream, line);
  const std::vector<std::string> columns = cells_of(line);
  std::vector<std::map<std::string, std::string>> rows{};
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = cells_of(line);
    std::map<std::string, std::string> row{};
    for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = cells.at(i);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace asperity
