// The device that a session is to run on: chosen among what is there, and tried before anybody holds it.

#include "app/gui/start/device_chooser.h"

#include <algorithm>
#include <utility>

#include <QtCore/QSignalBlocker>
#include <QtGui/QKeyEvent>
#include <QtGui/QStandardItemModel>
#include <QtWidgets/QApplication>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include "app/gui/base/open_study.h"
#include "app/gui/base/question_form.h"
#include "app/gui/base/session_keys.h"
#include "app/gui/base/settings.h"
#include "app/gui/devices/driver_setup.h"
#include "app/gui/devices/driver_words.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

constexpr int kDeviceWidth = 320;
constexpr const char* kReplay = "replay";

QString name_of_choice(const DeviceChoice& choice) {
  switch (choice.kind) {
    case DeviceKind::simulated:
      return choice.model.empty() ? DeviceChooser::tr("Simulated device")
                                  : DeviceChooser::tr("Simulated: %1").arg(text(choice.model));
    case DeviceKind::pointer:
      return DeviceChooser::tr("Mouse or pen (input only)");
    case DeviceKind::attached:
      break;
  }
  const QString driver = text(choice.driver);
  if (choice.model.empty()) return driver.isEmpty() ? text(choice.device) : driver;
  const QString model = text(choice.model);
  QStringList parts{};
  if (!driver.isEmpty() && !model.contains(driver, Qt::CaseInsensitive)) parts << driver;
  if (const QString which = text(choice.device).section(':', 1); !which.isEmpty()) parts << which;
  return parts.isEmpty() ? model : DeviceChooser::tr("%1 (%2)").arg(model, parts.join(", "));
}

/// What somebody should know who chooses it.
QString remark_of_choice(const DeviceChoice& choice) {
  switch (choice.kind) {
    case DeviceKind::simulated:
      return choice.model.empty()
                 ? DeviceChooser::tr("A virtual hand holds it; the participant feels nothing.")
                 : DeviceChooser::tr(
                       "A virtual hand holds it, with the latency, position steps and forces "
                       "of the device as far as they are known. The participant feels "
                       "nothing.");
    case DeviceKind::pointer:
      return DeviceChooser::tr(
          "In the participant's window, the mouse moves the probe and presses it "
          "while the button is held; a pen presses it with its own pressure. The "
          "participant feels no force.");
    case DeviceKind::attached:
      break;
  }
  return words_of(phrase_of_driver(choice.remark));
}

}  // namespace

DeviceChooser::DeviceChooser(OpenStudy& study, QWidget* parent) : QWidget(parent), study_(study) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  auto* row = new QHBoxLayout();
  row->setSpacing(kMargin);
  devices_ = new ChoiceBox(this);
  devices_->setObjectName("device");
  devices_->setFixedWidth(kDeviceWidth);
  ignore_wheel(*devices_);
  QLabel* label = make_text(tr("Device"), this);
  label->setBuddy(devices_);
  row->addWidget(label, 1);
  row->addWidget(devices_);
  layout->addLayout(row);
  text_ = make_text({}, this, true);
  text_->setObjectName("device_text");
  layout->addWidget(text_);
  auto* buttons = new QHBoxLayout();
  buttons->setSpacing(kGrid);
  set_up_ = make_button(tr("Set up…"), ButtonRole::plain, this);
  set_up_->setObjectName("device_set_up");
  set_up_->setToolTip(
      tr("Location of the firmware, the manufacturer's library or the service of a device, if it "
         "is not found."));
  again_ = make_button(tr("Rescan"), ButtonRole::plain, this);
  again_->setObjectName("device_look");
  try_ = make_button(tr("Try this device"), ButtonRole::plain, this);
  try_->setObjectName("device_try");
  buttons->addStretch(1);
  for (QPushButton* button : {set_up_, again_, try_}) buttons->addWidget(button);
  layout->addLayout(buttons);
  question_ = new QWidget(this);
  auto* asked = new QHBoxLayout(question_);
  asked->setContentsMargins(0, 0, 0, 0);
  asked->setSpacing(kGrid);
  question_text_ = new StateLabel(question_);
  question_text_->setObjectName("device_question");
  question_text_->setWordWrap(true);
  yes_ = make_button({}, ButtonRole::danger, question_);
  yes_->setObjectName("device_yes");
  QPushButton* no = make_button(tr("Not now"), ButtonRole::plain, question_);
  no->setObjectName("device_no");
  asked->addWidget(question_text_, 1);
  asked->addWidget(yes_);
  asked->addWidget(no);
  layout->addWidget(question_);
  question_->hide();
  state_ = new StateLabel(this);
  state_->setObjectName("device_state");
  state_->setWordWrap(true);
  layout->addWidget(state_);
  why_ = make_button(tr("Show devices that cannot be used"), ButtonRole::link, this);
  why_->setObjectName("device_why");
  why_->setCheckable(true);
  layout->addWidget(why_, 0, Qt::AlignLeft);
  why_text_ = make_text({}, this, true);
  why_text_->setObjectName("device_blockers");
  why_text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(why_text_);

  connect(devices_, &QComboBox::currentIndexChanged, this, [this] {
    const std::string device = devices_->currentData().toString().toStdString();
    if (device.empty()) return;
    if (whom_ == For::people) {
      of_people_ = device;
      remember_device(study_.folder(), device);
    } else {
      of_virtual_ = device;
    }
    drop_question();
    show_chosen();
    emit changed();
  });
  connect(again_, &QPushButton::clicked, this, &DeviceChooser::look);
  connect(try_, &QPushButton::clicked, this, [this] {
    if (try_task_.is_running()) {
      try_task_.cancel();
    } else {
      try_now();
    }
  });
  connect(set_up_, &QPushButton::clicked, this, &DeviceChooser::set_up);
  connect(why_, &QPushButton::toggled, why_text_, &QWidget::setVisible);
  connect(yes_, &QPushButton::clicked, this, [this] {
    const auto yes = std::exchange(on_yes_, nullptr);
    drop_question();
    if (yes) yes();
  });
  connect(no, &QPushButton::clicked, this, &DeviceChooser::drop_question);
  const std::string remembered = remembered_device(study_.folder());
  if (!remembered.empty()) of_people_ = remembered;
  list();
}

void DeviceChooser::set_for(For whom) {
  if (whom_ == whom) return;
  whom_ = whom;
  drop_question();
  list();
}

void DeviceChooser::set_protocol(std::shared_ptr<const Protocol> protocol) {
  protocol_ = std::move(protocol);
  show_chosen();
}

// --- what is there -------------------------------------------------------------------------------

void DeviceChooser::look_once() {
  const bool is_up_to_date = has_looked_ || survey_task_.is_running();
  if (!is_up_to_date || told_ != driver_places()) look();
}

void DeviceChooser::look() {
  // What was tried may be another one by now, or lie on its side.
  tried_.reset();
  drop_question();
  told_ = driver_places();
  if (setup_ != nullptr) setup_->show_looking();
  const auto done = [this](const std::vector<DeviceChoice>& choices) {
    const bool was_attached = kind() == DeviceKind::attached;
    has_looked_ = true;
    choices_ = choices;
    // It takes a file, and windows offer none.
    std::erase_if(choices_, [](const DeviceChoice& choice) { return choice.device == kReplay; });
    list();
    // Of the others nothing has changed.
    if (was_attached || kind() == DeviceKind::attached) emit changed();
  };
  survey_task_.run<std::vector<SurveyedDriver>>(
      [drivers = study_.drivers()](const std::stop_token& stop, const BackgroundTask::Progress&) {
        return survey_devices(drivers, [&stop](const std::string& driver) {
          DriverOptions options = driver_options(driver);
          options.stop = stop;
          return options;
        });
      },
      [this, done](const std::vector<SurveyedDriver>& surveyed) {
        drivers_ = surveyed;
        done(device_choices(surveyed));
        if (setup_ != nullptr) setup_->show_found(surveyed);
      },
      [this, done](const QString& what) {
        done(devices_without_hardware());
        state_->set_state(State::look, tr("The search for devices failed: %1").arg(what));
        state_->show();
        if (setup_ != nullptr) setup_->show_failure(what);
      });
  show_chosen();
  if (kind() == DeviceKind::attached) emit changed();
}

void DeviceChooser::list() {
  std::vector<DeviceChoice> lines = choices_;
  const bool is_there = std::any_of(lines.begin(), lines.end(), [this](const DeviceChoice& choice) {
    return choice.device == of_people_;
  });
  if (!is_there) {
    // Its driver may be what is missing.
    const std::string driver = of_people_.substr(0, of_people_.find(':'));
    const auto of_driver =
        std::find_if(lines.begin(), lines.end(), [&driver](const DeviceChoice& choice) {
          return choice.device == driver && !choice.is_usable();
        });
    const Driver* of_it = study_.drivers().find(driver);
    gone_ = {.device = of_people_,
             .kind = DeviceKind::attached,
             .model = of_it == nullptr || of_it->name.empty() ? driver : of_it->name,
             .blocker = of_driver != lines.end()
                            ? of_driver->blocker
                            : tr("The device is not connected: plug it in, check its power "
                                 "supply, and press “Rescan”.")
                                  .toStdString()};
    lines.push_back(gone_);
  }
  const QSignalBlocker silent(devices_);
  devices_->clear();
  auto* rows = qobject_cast<QStandardItemModel*>(devices_->model());
  QStringList why_not{};
  for (const DeviceChoice& choice : lines) {
    if (whom_ != For::people && choice.kind != DeviceKind::simulated) continue;
    const QString name = name_of_choice(choice);
    devices_->addItem(choice.is_usable() ? name : tr("%1: not usable").arg(name),
                      text(choice.device));
    if (choice.is_usable()) continue;
    rows->item(devices_->count() - 1)->setEnabled(false);
    const QString why = words_of(phrase_of_driver(choice.blocker).as_sentence(), tr("“Set up…”"));
    rows->item(devices_->count() - 1)->setToolTip(why);
    if (choice.device != of_people_) why_not << tr("%1: %2").arg(name, why);
  }
  devices_->setCurrentIndex(devices_->findData(text(device())));
  devices_->setEnabled(whom_ != For::virtual_participants);
  set_up_->setVisible(whom_ == For::people && !drivers_to_set_up(study_.drivers()).empty());
  why_text_->setText(why_not.join('\n'));
  why_->setVisible(!why_not.isEmpty());
  why_text_->setVisible(!why_not.isEmpty() && why_->isChecked());
  show_chosen();
}

std::string DeviceChooser::device() const {
  switch (whom_) {
    case For::people:
      return of_people_;
    case For::virtual_participant:
      return of_virtual_;
    case For::virtual_participants:
      break;
  }
  return "simulated";  // what many of them are simulated on
}

const DeviceChoice& DeviceChooser::chosen() const {
  const std::string wanted = device();
  const auto found =
      std::find_if(choices_.begin(), choices_.end(),
                   [&wanted](const DeviceChoice& choice) { return choice.device == wanted; });
  return found == choices_.end() ? gone_ : *found;
}

void DeviceChooser::show_chosen() {
  const DeviceChoice& now = chosen();
  const bool is_attached = now.kind == DeviceKind::attached;
  const bool is_looking = survey_task_.is_running();
  const bool is_trying = try_task_.is_running();
  again_->setVisible(whom_ == For::people);
  again_->setEnabled(!is_looking && !is_trying);
  again_->setText(is_looking ? tr("Searching…") : tr("Rescan"));
  set_up_->setEnabled(!is_trying);
  devices_->setEnabled(whom_ != For::virtual_participants && !is_trying);
  try_->setVisible(is_attached && whom_ == For::people);
  try_->setText(is_trying ? tr("Cancel") : tr("Try this device"));
  try_->setEnabled(is_trying || (now.is_usable() && has_looked_ && !is_looking &&
                                 protocol_ != nullptr && !question_->isVisibleTo(this)));
  QString said = remark_of_choice(now);
  if (is_attached && !now.is_usable()) {
    said = has_looked_ ? words_of(phrase_of_driver(now.blocker).as_sentence(), tr("“Set up…”"))
                       : QString();
  }
  if (whom_ == For::virtual_participants) {
    said = tr("Several virtual participants are simulated on the plain simulated device.");
  }
  text_->setText(said);
  text_->setVisible(!said.isEmpty());
  if (is_trying) return;  // the device says there what it wants
  state_->setVisible(is_attached);
  if (!is_attached) return;
  const auto found = tried();
  if (is_looking || !has_looked_) {
    state_->set_state(State::unknown, tr("Searching for devices…"));
  } else if (!now.is_usable()) {
    state_->set_state(State::stop, tr("The device cannot be used at present: resolve the problem "
                                      "stated here, or choose another device."));
  } else if (found == nullptr) {
    state_->set_state(State::look, tr("Not tried yet. “Try this device” opens it and runs the "
                                      "servo loop for a third of a second without force."));
  } else if (!found->failure.empty()) {
    state_->set_state(State::stop, words_of(found->failure, tr("“Set up…”")));
  } else {
    state_->set_state(State::fine, tr("Tried: the device responds. Details are in the checklist."));
  }
}

QString DeviceChooser::name() const { return name_of_choice(chosen()); }

QString DeviceChooser::waits_for() const {
  if (chosen().kind != DeviceKind::attached) return {};
  if (try_task_.is_running()) return tr("The device is being tried; wait for the result.");
  if (survey_task_.is_running() || !has_looked_) return tr("Searching for devices…");
  return {};
}

// --- trying --------------------------------------------------------------------------------------

std::shared_ptr<const TriedDevice> DeviceChooser::tried() const {
  const bool is_it = tried_ != nullptr && protocol_ != nullptr && tried_->device == device() &&
                     tried_->rate_Hz == protocol_->rate_Hz;
  return is_it ? tried_ : nullptr;
}

void DeviceChooser::forget_try() {
  tried_.reset();
  show_chosen();
}

void DeviceChooser::try_now(const std::string& agreed) {
  tried_.reset();
  DriverOptions options = driver_options(device());
  options.tell = [this](const std::string& sentence) {
    // The task is waited for before this goes.
    QMetaObject::invokeMethod(
        this, [this, sentence] { state_->set_state(State::look, text(sentence)); },
        Qt::QueuedConnection);
  };
  qApp->installEventFilter(this);
  try_task_.run<TriedDevice>(
      [trial = study_.device_trial(), device = device(), protocol = protocol_,
       drivers = study_.drivers(), options,
       agreed](const std::stop_token& stop, const BackgroundTask::Progress&) {
        DriverOptions mine = options;
        mine.stop = stop;
        return trial(device, *protocol, drivers, mine, agreed);
      },
      [this, told = driver_places(), moved = !agreed.empty()](const TriedDevice& found) {
        qApp->removeEventFilter(this);
        show_try(found, told == driver_places());
        // Of an arm that was stopped while it moved: that its handle sinks.
        if (moved && found.was_stopped) state_->set_state(State::look, words_of(found.failure));
      },
      [this](const QString& what) {
        qApp->removeEventFilter(this);
        show_chosen();
        state_->set_state(State::stop, what);
        emit changed();
      });
  show_chosen();
  if (agreed.empty()) {
    state_->set_state(State::unknown, tr("Opening the device…"));
  } else {
    state_->set_state(State::look,
                      tr("Keep hands away: the device moves by itself until it has found its zero "
                         "position. To stop it, press Esc or Cancel, or switch it off."));
    try_->setFocus();
  }
  state_->show();
  emit changed();
}

// An open menu or dialog has the keys of the window; these stop an arm that moves all the same.
bool DeviceChooser::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && try_task_.is_running()) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (key.key() == Qt::Key_Escape) try_task_.cancel();
    if (is_emergency(key)) {
      try_task_.cancel();
      return true;  // Ctrl+Space would press the button that has the focus
    }
  }
  return QWidget::eventFilter(watched, event);
}

// An arm that moves by itself needs the button that stops it in sight.
void DeviceChooser::hideEvent(QHideEvent* event) {
  if (try_task_.is_running()) try_task_.cancel();
  drop_question();
  QWidget::hideEvent(event);
}

void DeviceChooser::show_try(const TriedDevice& found, bool is_as_told) {
  const bool is_asked = is_as_told && isVisible() && !found.wants_to_move.empty();
  if (is_as_told && found.wants_to_move.empty() && !found.was_stopped)
    tried_ = std::make_shared<const TriedDevice>(found);
  show_chosen();
  // Somebody may have turned to virtual participants meanwhile.
  if (is_asked && whom_ == For::people && found.device == device()) {
    ask(words_of(Phrase(found.wants_to_move).as_sentence()).simplified(), tr("Allow motion"),
        [this, agreed = found.wants_to_move] { try_now(agreed); });
  }
  emit changed();
}

void DeviceChooser::ask(const QString& question, const QString& verb, std::function<void()> yes) {
  on_yes_ = std::move(yes);
  question_text_->set_state(State::look, question);
  yes_->setText(verb);
  question_->show();
  state_->hide();
  try_->setEnabled(false);
}

void DeviceChooser::drop_question() {
  on_yes_ = nullptr;
  if (question_->isHidden()) return;
  question_->hide();
  show_chosen();
}

void DeviceChooser::set_up() {
  if (setup_ != nullptr) return;
  setup_ = new DriverSetup(drivers_to_set_up(study_.drivers()), this);
  connect(setup_, &DriverSetup::changed, this, &DeviceChooser::look);
  if (survey_task_.is_running()) {
    setup_->show_looking();
  } else {
    setup_->show_found(drivers_);
  }
  setup_->open();
}

}  // namespace asperity

#include "moc_device_chooser.cpp"
