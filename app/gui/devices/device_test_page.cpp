// Shows the overview before and after a test and the course during it, which runs on another thread.

#include "app/gui/devices/device_test_page.h"

#include <algorithm>
#include <any>
#include <filesystem>
#include <utility>

#include <QtCore/QSignalBlocker>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QStackedWidget>

#include "app/gui/base/question_form.h"
#include "app/gui/base/session_keys.h"
#include "app/gui/base/settings.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/base/study_table.h"
#include "app/gui/devices/device_test_steps.h"
#include "app/gui/devices/driver_words.h"
#include "app/gui/devices/motion_picture.h"
#include "app/gui/devices/profile_view.h"
#include "app/gui/devices/profile_words.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/decimal_field.h"
#include "app/gui/look/words.h"
#include "app/plugins/stored_plugins.h"
#include "app/profiles/profile_verdict.h"
#include "app/session/rig/clock.h"
#include "app/study_files/protocol_languages.h"
#include "app/tasks/protocol_files.h"
#include "device/simulated_models.h"
#include "renderers/built_in_models.h"

namespace asperity {

namespace {

constexpr const char* kLeftHere = "device_test";
constexpr int kTestFrame_ms = 33;
constexpr int kPageWidth = 1120;
constexpr int kBesideEachOther = 920;  // narrower, one card stands below the other
constexpr int kTestFieldWidth = 260;
constexpr int kProfilesHeight = 168;
constexpr int kStepsWidth = 208;

}  // namespace

DeviceTestPage::DeviceTestPage(OpenStudy& study, QWidget* parent)
    : DeviceTestPage(study, MeasureOrder{}, parent) {}

DeviceTestPage::DeviceTestPage(OpenStudy& study, MeasureOrder usual, QWidget* parent)
    : StudyPage(study, tr("Device test"), parent), usual_(std::move(usual)) {
  setObjectName("device_test_page");
  usual_.study = study.folder();
  usual_.borders_s = kBorders_s;
  back_ = make_button(tr("← All devices"), ButtonRole::link, this);
  back_->setObjectName("device_test_back");
  stop_ = make_button({}, ButtonRole::danger, this);
  stop_->setObjectName("device_test_stop");
  stop_->setToolTip(tr("Esc, F12, Pause and Ctrl+Space do the same."));
  head().addWidget(back_);
  head().addWidget(stop_);
  stack_ = new QStackedWidget(this);
  stack_->addWidget(make_overview());
  stack_->addWidget(make_course());
  body().addWidget(stack_, 1);
  connect(back_, &QPushButton::clicked, this, &DeviceTestPage::back_wanted);
  connect(not_now_, &QPushButton::clicked, this, &DeviceTestPage::back_wanted);
  connect(stop_, &QPushButton::clicked, this, &DeviceTestPage::stop);
  connect(begin_, &QPushButton::clicked, this, &DeviceTestPage::begin);
  frames_.setInterval(kTestFrame_ms);
  connect(&frames_, &QTimer::timeout, this, [this] { picture_->take(run_.take_motion()); });
  connect_run();
  stop_->hide();
  auto* empty = new EmptyState(tr("No device chosen"),
                               tr("The Devices page lists the devices that can be tested."), this);
  empty->add_action(tr("Show devices"), ButtonRole::primary, [this] { emit back_wanted(); });
  set_empty_state(empty);
  show_empty(true);
  const std::any left = study.take_left(kLeftHere);
  if (const auto* device = std::any_cast<TestedDevice>(&left)) show_device(*device);
}

DeviceTestPage::~DeviceTestPage() {
  if (!device_.device.empty()) study().leave(kLeftHere, device_);
}

// --- what is made once ---------------------------------------------------------------------------

QWidget* DeviceTestPage::make_overview() {
  area_ = new QScrollArea(this);
  area_->setWidgetResizable(true);
  area_->setFrameShape(QFrame::NoFrame);
  area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area_->viewport()->setAutoFillBackground(false);
  auto* inside = new QWidget(area_);
  inside->setMaximumWidth(kPageWidth);
  auto* rows = new QVBoxLayout(inside);
  rows->setContentsMargins(0, 0, kGrid, 0);
  rows->setSpacing(kMargin);
  cards_ = new QBoxLayout(QBoxLayout::LeftToRight);
  cards_->setSpacing(kMargin);
  cards_->addWidget(make_order_card(inside), 1);
  cards_->addWidget(make_profiles_card(inside), 1);
  rows->addLayout(cards_);
  QVBoxLayout* layout = nullptr;
  QFrame* card = make_card(inside, layout);
  card->setObjectName("profile_card");
  profile_ = new ProfileView(card);
  layout->addWidget(profile_);
  rows->addWidget(card);
  rows->addStretch(1);
  card->hide();
  area_->setWidget(inside);
  inside->setAutoFillBackground(false);  // which setWidget turns on
  return area_;
}

QWidget* DeviceTestPage::make_order_card(QWidget* parent) {
  QVBoxLayout* layout = nullptr;
  QFrame* card = make_card(parent, layout);
  device_name_ = make_heading({}, card);
  device_name_->setObjectName("device_test_name");
  layout->addWidget(device_name_);
  what_ = new StateLabel(card);
  what_->setObjectName("device_test_what");
  what_->setWordWrap(true);
  layout->addWidget(what_);
  auto* form = new QGridLayout();
  form->setHorizontalSpacing(kMargin);
  form->setVerticalSpacing(kGrid);
  form->setColumnStretch(0, 1);
  limits_ = new ChoiceBox(card);
  limits_->setObjectName("device_test_limits");
  limits_->setFixedWidth(kTestFieldWidth);
  ignore_wheel(*limits_);
  force_ = new DecimalField(card);
  force_->setObjectName("device_test_force");
  force_->setRange(0.1, 20.0);
  force_->setSingleStep(0.5);
  force_->setDecimals(1);
  force_->setSuffix(tr(" N"));
  force_->setValue(usual_.test.force_N);
  force_->setFixedWidth(kTestFieldWidth);
  ignore_wheel(*force_);
  const auto add_row = [&](const QString& name, QWidget* field) {
    const int row = form->rowCount();
    QLabel* label = make_text(name, card);
    label->setBuddy(field);
    form->addWidget(label, row, 0);
    form->addWidget(field, row, 1);
  };
  add_row(tr("Limits of"), limits_);
  add_row(tr("Maximum force"), force_);
  layout->addLayout(form);
  limits_text_ = make_text({}, card, true);
  limits_text_->setFont(text_font(TextSize::small));
  layout->addWidget(limits_text_);
  layout->addStretch(1);
  auto* buttons = new QHBoxLayout();
  buttons->setSpacing(kGrid);
  begin_ = make_button({}, ButtonRole::primary, card);
  begin_->setObjectName("device_test_begin");
  not_now_ = make_button(tr("Not now"), ButtonRole::plain, card);
  not_now_->setObjectName("device_test_not_now");
  reason_ = make_text({}, card, true);
  reason_->setObjectName("device_test_reason");
  buttons->addWidget(begin_);
  buttons->addWidget(not_now_);
  buttons->addWidget(reason_, 1);
  layout->addLayout(buttons);
  connect(force_, &QDoubleSpinBox::valueChanged, this, &DeviceTestPage::write_what_it_does);
  connect(limits_, &QComboBox::currentIndexChanged, this, &DeviceTestPage::show_limits);
  return card;
}

QWidget* DeviceTestPage::make_profiles_card(QWidget* parent) {
  QVBoxLayout* layout = nullptr;
  QFrame* card = make_card(parent, layout);
  layout->addWidget(make_heading(tr("Profiles of this device"), card));
  profile_problems_ = make_text({}, card, true);
  profile_problems_->setObjectName("device_test_profile_problems");
  layout->addWidget(profile_problems_, 0, Qt::AlignTop);
  using Align = StudyTable::Align;
  profiles_ = new StudyTable({{tr("Measured"), 144, Align::text},
                              {tr("Age"), 112, Align::text},
                              {tr("Result"), 0, Align::text}},
                             card);
  profiles_->setObjectName("device_test_profiles");
  profiles_->setMinimumHeight(kProfilesHeight);
  profiles_->sortByColumn(0, Qt::DescendingOrder);
  layout->addWidget(profiles_, 1);
  layout->addStretch();  // takes the room of a table that is hidden, because it would be empty
  connect(profiles_, &StudyTable::row_selected, this, [this](const QString& key) {
    const auto found =
        std::find_if(found_.kept.profiles.begin(), found_.kept.profiles.end(),
                     [&key](const DeviceProfile& one) { return text(one.measured_utc) == key; });
    if (found == found_.kept.profiles.end() || found->measured_utc == shown_utc_) return;
    shown_utc_ = found->measured_utc;
    profile_->show_profile(*found);
    profile_->parentWidget()->show();
  });
  return card;
}

QWidget* DeviceTestPage::make_course() {
  auto* course = new QWidget(this);
  auto* columns = new QHBoxLayout(course);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(kGroupGap);
  steps_ = new DeviceTestSteps(course);
  steps_->setFixedWidth(kStepsWidth);
  columns->addWidget(steps_);
  auto* rows = new QVBoxLayout();
  rows->setSpacing(kGrid);
  do_now_ = make_text({}, course);
  do_now_->setObjectName("device_test_do_now");
  do_now_->setFont(text_font(TextSize::heading));
  // Its words change: what is below stays where it is.
  do_now_->setMinimumHeight(3 * do_now_->fontMetrics().lineSpacing());
  do_now_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  rows->addWidget(do_now_);
  question_ = new QWidget(course);
  auto* asked = new QHBoxLayout(question_);
  asked->setContentsMargins(0, 0, 0, 0);
  asked->setSpacing(kGrid);
  question_text_ = new StateLabel(question_);
  question_text_->setObjectName("device_test_question");
  question_text_->setWordWrap(true);
  QPushButton* yes = make_button(tr("Allow motion"), ButtonRole::danger, question_);
  yes->setObjectName("device_test_yes");
  QPushButton* no = make_button(tr("Do not allow motion"), ButtonRole::plain, question_);
  no->setObjectName("device_test_no");
  asked->addWidget(question_text_, 1);
  asked->addWidget(yes);
  asked->addWidget(no);
  rows->addWidget(question_);
  question_->hide();
  progress_ = new QProgressBar(course);
  progress_->setObjectName("device_test_progress");
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  rows->addWidget(progress_);
  rows->addSpacing(kGrid);
  picture_ = new MotionPicture(course);
  rows->addWidget(picture_, 1);
  columns->addLayout(rows, 1);
  connect(yes, &QPushButton::clicked, this, [this] {
    drop_question();
    do_now_->setText(
        tr("Keep hands away: the device moves by itself until it has found its zero position. To "
           "stop it, press Stop or switch it off."));
    run_.answer(true);
  });
  connect(no, &QPushButton::clicked, this, [this] {
    drop_question();
    run_.answer(false);
  });
  return course;
}

void DeviceTestPage::connect_run() {
  connect(&run_, &DeviceTestRun::wished, do_now_, &QLabel::setText);
  connect(&run_, &DeviceTestRun::asked, this, &DeviceTestPage::ask);
  connect(&run_, &DeviceTestRun::opened, this, [this](const DeviceCapability& capability) {
    if (!stop_wanted_) offer_stop();
    picture_->set_device(capability);
  });
  connect(&run_, &DeviceTestRun::came_to, this, &DeviceTestPage::show_news);
  connect(&run_, &DeviceTestRun::measured, this, &DeviceTestPage::show_measured);
  connect(&run_, &DeviceTestRun::stopped, this, [this](const QString& last_words) {
    end(State::look, last_words.isEmpty()
                         ? tr("Stopped: the force is zero, and nothing was stored. To measure the "
                              "device, begin the test again.")
                         : tr("Stopped, and nothing was stored: %1").arg(last_words));
  });
  connect(&run_, &DeviceTestRun::failed, this, [this](const QString& sentence) {
    end(State::stop, tr("Nothing was measured: %1").arg(sentence));
  });
}

// --- before --------------------------------------------------------------------------------------

DeviceTestPage::Found DeviceTestPage::look_into(const Study& study, const WhichDevice& device) {
  Found found{.kept = profiles_in(study.folder(), device), .now_utc = SystemClock(0).utc()};
  const ModelRegistry models = with_stored_plugins(built_in_models(), study);
  for (const std::filesystem::path& file : protocol_files(study.folder())) {
    try {
      const Protocol protocol = load_protocol(file, models, study.folder());
      if (protocol.device_limits.empty()) continue;
      found.limits.push_back({.name = text(protocol.name + ' ' + protocol.version),
                              .rate_Hz = protocol.rate_Hz,
                              .limits = protocol.device_limits});
    } catch (const std::exception&) {
      // What is wrong with it is said where protocols are listed.
    }
  }
  std::sort(found.limits.begin(), found.limits.end(),
            [](const Limits& a, const Limits& b) { return a.name < b.name; });
  return found;
}

void DeviceTestPage::show_device(const TestedDevice& device) {
  if (run_.is_running()) return;
  device_ = device;
  found_ = {};
  {
    const QSignalBlocker silent(limits_);
    limits_->clear();  // those of another device's reading are not what it would be held to
  }
  show_empty(false);
  shown_utc_.clear();
  profile_->parentWidget()->hide();
  banner().hide();
  device_name_->setText(device.name);
  const bool can_be_kept = study().can_be_written();
  const bool moves = device.has_motors && !device.is_simulated;
  begin_->setText(moves ? tr("Begin: the handle moves") : tr("Begin the test"));
  force_->setEnabled(device.has_motors);
  begin_->setEnabled(can_be_kept);
  not_now_->setVisible(!device.is_simulated);
  reason_->setText(can_be_kept ? QString()
                               : tr("This study is read-only: no profile can be stored. Copy it to "
                                    "a folder that you may write to."));
  write_what_it_does();
  stack_->setCurrentIndex(0);
  area_->ensureVisible(0, 0);
  forget_readings();
  read_with<Found>(
      Need::when_shown,
      [which = device.which](const Study& own, const std::stop_token&) {
        return look_into(own, which);
      },
      [this](const Found& found) { show_found(found); });
}

void DeviceTestPage::write_what_it_does() {
  if (device_.is_simulated) {
    what_->set_state(State::fine,
                     tr("Nothing moves: a virtual hand holds the device, and its mechanics are "
                        "measured faster than real time. Its timing is that of this computer."));
    return;
  }
  if (!device_.has_motors) {
    what_->set_state(State::fine,
                     tr("The device has no motors: it does not move by itself and exerts no force. "
                        "The timing of the servo loop is measured; then the probe has to be moved "
                        "by hand along the borders of its workspace."));
    return;
  }
  QString said = words_of(what_measuring_does(device_.handle, force_->value()).as_sentence()) +
                 ' ' +
                 tr("Esc, F12 and the red button set the force to zero at once. At the end, move "
                    "the handle along the borders of its workspace.");
  if (!device_.remark.empty()) said += ' ' + words_of(phrase_of_driver(device_.remark));
  what_->set_state(State::look, said);
}

void DeviceTestPage::show_found(const Found& found) {
  found_ = found;
  std::vector<StudyTable::Row> rows{};
  for (const DeviceProfile& profile : found.kept.profiles) {
    const ItemResult verdict = short_verdict_of(profile);
    QStandardItem* result = text_cell(shape_of(verdict.state) + ' ' + verdict.words);
    result->setForeground(color_of(verdict.state));
    const double days = age_days(profile, found.now_utc);
    rows.push_back({text(profile.measured_utc),
                    {text_cell(date_in_words(profile.measured_utc), text(profile.measured_utc)),
                     text_cell(text_of_age(days), days), result}});
  }
  {
    const QSignalBlocker silent(profiles_);
    profiles_->fill(rows);
    if (!shown_utc_.empty()) profiles_->select(text(shown_utc_));
  }
  profiles_->setVisible(!rows.empty());
  QStringList beside{};
  if (rows.empty()) {
    beside << tr(
        "The study has no profile of this device yet; this test measures one. Before a session, "
        "its plan is compared with the latest profile.");
  }
  for (const std::string& complaint : found.kept.complaints) {
    beside << tr("Not listed: %1").arg(text(complaint));
  }
  profile_problems_->setVisible(!beside.isEmpty());
  profile_problems_->setText(beside.join('\n'));
  if (shown_utc_.empty() && !found.kept.profiles.empty()) {
    profiles_->select(text(found.kept.profiles.front().measured_utc));
  }
  const QSignalBlocker silent(limits_);
  const QString chosen = limits_->currentText();
  limits_->clear();
  limits_->addItem(tr("Asperity (defaults)"));
  for (const Limits& limits : found.limits) limits_->addItem(limits.name);
  limits_->setCurrentIndex(std::max(0, limits_->findText(chosen)));
  show_limits();
}

const DeviceTestPage::Limits* DeviceTestPage::chosen_limits() const {
  const int chosen = limits_->currentIndex() - 1;  // the first are the usual ones
  const bool is_one = chosen >= 0 && chosen < static_cast<int>(found_.limits.size());
  return is_one ? &found_.limits[static_cast<std::size_t>(chosen)] : nullptr;
}

void DeviceTestPage::show_limits() {
  const Limits* const chosen = chosen_limits();
  if (chosen == nullptr) {
    limits_text_->setText(
        found_.limits.empty()
            ? tr("Rate at least 950 Hz, 99th percentile of the lateness at most 1 ms. Protocols "
                 "with “limits” in their “device” are listed here; the study has none.")
            : tr("Rate at least 950 Hz, 99th percentile of the lateness at most 1 ms."));
    return;
  }
  QStringList parts{};
  for (const auto& [name, limit] : chosen->limits) {
    const DeviceQuantity* const quantity = device_quantity(name);
    if (quantity == nullptr) continue;
    parts << title_of_item(name) + ' ' +
                 limit_in_words({.name = name, .limit = limit, .bound = quantity->bound});
  }
  limits_text_->setText(
      tr("At %1 Hz: %2.").arg(shown_number(chosen->rate_Hz, 'f', 0)).arg(parts.join(", ")));
}

// --- while it is measured ------------------------------------------------------------------------

void DeviceTestPage::begin() {
  if (run_.is_running() || device_.device.empty()) return;
  MeasureOrder order = usual_;
  order.test.force_N = force_->value();
  if (const Limits* const chosen = chosen_limits()) {
    order.protocol_limits = chosen->limits;
    order.test.rate_Hz = chosen->rate_Hz;
  }
  banner().hide();
  stop_wanted_ = false;
  back_->hide();
  offer_stop();
  qApp->installEventFilter(this);
  const QString reason = tr("A device is being measured. Stop the measurement first.");
  setProperty("keep", reason);
  setProperty("uncovered", reason);
  steps_->begin({.by_motors = device_.has_motors,
                 .by_a_person = !device_.is_simulated,
                 .not_known = not_known_of(device_.which.model)});
  do_now_->setText(tr("The device is being opened."));
  progress_->setValue(0);
  drop_question();
  picture_->begin();
  stack_->setCurrentIndex(1);
  stop_->setFocus();
  frames_.start();
  hold_ = study().examiner().hold();
  run_.begin(study().drivers(), driver_options(device_.device), device_.device, order);
}

void DeviceTestPage::offer_stop() {
  stop_->setText(tr("■ Stop: no force (Esc)"));
  stop_->setEnabled(true);
  stop_->show();
}

void DeviceTestPage::stop() {
  if (!run_.is_running()) return;
  run_.stop();
  if (std::exchange(stop_wanted_, true)) return;
  drop_question();
  stop_->setText(tr("Stopping…"));
  stop_->setEnabled(false);
}

void DeviceTestPage::ask(const QString& sentence) {
  if (stop_wanted_) return;
  question_text_->set_state(State::look, sentence);
  do_now_->hide();
  question_->show();
}

void DeviceTestPage::drop_question() {
  question_->hide();
  do_now_->show();
}

void DeviceTestPage::show_news(const DeviceTestNews& news) {
  steps_->come_to(news.part);
  do_now_->setText(what_to_do(news.part, news.axis));
  progress_->setValue(static_cast<int>(100.0 * news.done));
  picture_->come_to(news.part);
}

// --- afterwards ----------------------------------------------------------------------------------

void DeviceTestPage::show_measured(const MeasuredDevice& measured) {
  const DeviceProfile& profile = measured.profile;
  shown_utc_ = profile.measured_utc;
  profile_->show_profile(profile);
  profile_->parentWidget()->show();
  const QString file =
      measured.file ? text_of_path(measured.file->lexically_relative(study().folder())) : QString();
  const auto title = [](const std::string& item) { return title_of_item(item).toStdString(); };
  end(verdict_of(profile).state, words_of(verdict_on(profile, title)) + ' ' +
                                     tr("The profile has been stored as %1.").arg(file));
  study().announce_change();
  // What was found comes into sight, once everything has its place.
  constexpr int kSettled_ms = 150;
  QTimer::singleShot(kSettled_ms, this, [this] {
    area_->verticalScrollBar()->setValue(profile_->parentWidget()->geometry().top());
  });
}

void DeviceTestPage::end(State state, const QString& sentence) {
  hold_.reset();
  frames_.stop();
  drop_question();
  stop_->hide();
  back_->show();
  qApp->removeEventFilter(this);
  setProperty("keep", {});
  setProperty("uncovered", {});
  stack_->setCurrentIndex(0);
  banner().show_news(state, sentence);
  // Whoever presses Space to stop it may press it twice: that must not begin it again.
  back_->setFocus();
}

// An open menu or dialog has the keys of the window; these stop a moving arm all the same.
bool DeviceTestPage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && run_.is_running()) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (key.key() == Qt::Key_Escape) stop();
    if (is_emergency(key)) {
      stop();
      return true;  // Ctrl+Space would press the button that has the focus, which may be a yes
    }
  }
  return StudyPage::eventFilter(watched, event);
}

// A moving arm needs the button that stops it in sight.
void DeviceTestPage::hideEvent(QHideEvent* event) {
  stop();
  StudyPage::hideEvent(event);
}

void DeviceTestPage::resizeEvent(QResizeEvent* event) {
  StudyPage::resizeEvent(event);
  arrange();
}

void DeviceTestPage::arrange() {
  cards_->setDirection(width() < kBesideEachOther ? QBoxLayout::TopToBottom
                                                  : QBoxLayout::LeftToRight);
}

}  // namespace asperity

#include "moc_device_test_page.cpp"
