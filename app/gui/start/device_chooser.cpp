// The device that a session is to run on: chosen among what is there, and tried before anybody holds it.

#include "app/gui/start/device_chooser.h"

#include <algorithm>
#include <utility>

#include <QtCore/QSignalBlocker>
#include <QtGui/QStandardItemModel>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"
#include "app/gui/start/question_form.h"
#include "app/gui/study/open_study.h"
#include "app/gui/study/settings.h"

namespace asperity {

namespace {

constexpr int kDeviceWidth = 320;
constexpr const char* kFalcon = "falcon";

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
  if (choice.model.empty()) return text(choice.device);
  return DeviceChooser::tr("%1 (%2)").arg(text(choice.model), text(choice.device));
}

/// What somebody should know who chooses it.
QString remark_of_choice(const DeviceChoice& choice) {
  switch (choice.kind) {
    case DeviceKind::simulated:
      return choice.model.empty()
                 ? DeviceChooser::tr("A virtual hand holds it, and nobody feels anything.")
                 : DeviceChooser::tr(
                       "A virtual hand holds it, with the latency, steps and forces "
                       "of the device as far as they are known. Nobody feels "
                       "anything.");
    case DeviceKind::pointer:
      return DeviceChooser::tr(
          "The mouse over the participant's window moves the probe, and "
          "presses while its button is held; a pen as hard as it does. "
          "Nobody feels a force.");
    case DeviceKind::attached:
      break;
  }
  return text(choice.remark);
}

}  // namespace

DeviceChooser::DeviceChooser(OpenStudy& study, QWidget* parent) : QWidget(parent), study_(study) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  auto* row = new QHBoxLayout();
  row->setSpacing(kMargin);
  devices_ = new QComboBox(this);
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
  why_ = make_button(tr("Why others cannot be used"), ButtonRole::link, this);
  why_->setObjectName("device_why");
  why_->setCheckable(true);
  firmware_ = make_button(tr("Firmware file…"), ButtonRole::plain, this);
  firmware_->setObjectName("device_firmware");
  again_ = make_button(tr("Look again"), ButtonRole::plain, this);
  again_->setObjectName("device_look");
  try_ = make_button(tr("Try this device"), ButtonRole::plain, this);
  try_->setObjectName("device_try");
  buttons->addStretch(1);
  for (QPushButton* button : {firmware_, again_, try_}) buttons->addWidget(button);
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
  layout->addWidget(why_, 0, Qt::AlignLeft);
  why_text_ = make_text({}, this, true);
  why_text_->setObjectName("device_hindrances");
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
  connect(firmware_, &QPushButton::clicked, this, &DeviceChooser::choose_firmware);
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
  if (!has_looked_ && !survey_task_.is_running()) look();
}

void DeviceChooser::look() {
  // What was tried may be another one by now, or lie on its side.
  tried_.reset();
  drop_question();
  const auto done = [this](const std::vector<DeviceChoice>& choices) {
    const bool was_attached = kind() == DeviceKind::attached;
    has_looked_ = true;
    choices_ = choices;
    list();
    // Of the others nothing has changed.
    if (was_attached || kind() == DeviceKind::attached) emit changed();
  };
  survey_task_.run<std::vector<SurveyedDriver>>(
      [drivers = study_.drivers(), options = driver_options()](const std::stop_token&,
                                                               const BackgroundTask::Progress&) {
        return survey_devices(drivers, options);
      },
      [done](const std::vector<SurveyedDriver>& surveyed) { done(device_choices(surveyed)); },
      [this, done](const QString& what) {
        done(devices_without_hardware());
        state_->set_state(State::look, tr("Devices could not be looked for: %1").arg(what));
        state_->show();
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
    gone_ = {.device = of_people_,
             .kind = DeviceKind::attached,
             .hindrance = tr("%1 is not there: plug it in, see that it has power, and look again.")
                              .arg(text(of_people_))
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
    rows->item(devices_->count() - 1)->setToolTip(text(choice.hindrance));
    if (choice.device != of_people_) why_not << tr("%1: %2").arg(name, text(choice.hindrance));
  }
  devices_->setCurrentIndex(devices_->findData(text(device())));
  devices_->setEnabled(whom_ != For::virtual_participants);
  const bool has_falcon = std::any_of(lines.begin(), lines.end(), [](const DeviceChoice& choice) {
    return choice.device.starts_with(kFalcon);
  });
  firmware_->setVisible(whom_ == For::people && has_falcon);
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
  again_->setText(is_looking ? tr("Looking…") : tr("Look again"));
  firmware_->setEnabled(!is_looking && !is_trying);
  devices_->setEnabled(whom_ != For::virtual_participants && !is_trying);
  try_->setVisible(is_attached && whom_ == For::people);
  try_->setText(is_trying ? tr("Stop trying") : tr("Try this device"));
  try_->setEnabled(is_trying || (now.is_usable() && has_looked_ && !is_looking &&
                                 protocol_ != nullptr && !question_->isVisibleTo(this)));
  QString said = remark_of_choice(now);
  if (is_attached && !now.is_usable()) said = has_looked_ ? text(now.hindrance) : QString();
  if (whom_ == For::virtual_participants) {
    said = tr("Several virtual participants are simulated on the simulated device as it is.");
  }
  text_->setText(said);
  text_->setVisible(!said.isEmpty());
  if (is_trying) return;  // the device says there what it wants
  state_->setVisible(is_attached);
  if (!is_attached) return;
  const auto found = tried();
  if (is_looking || !has_looked_) {
    state_->set_state(State::unknown, tr("Devices are being looked for."));
  } else if (!now.is_usable()) {
    state_->set_state(State::stop, tr("It cannot be used now."));
  } else if (found == nullptr) {
    state_->set_state(State::look,
                      tr("Not tried yet. Trying it opens it and runs the loop for a third of a "
                         "second, without force."));
  } else if (!found->failure.empty()) {
    state_->set_state(State::stop, words_of(found->failure));
  } else {
    state_->set_state(State::fine, tr("Tried: it answers. The checklist says the rest."));
  }
}

QString DeviceChooser::waits_for() const {
  if (chosen().kind != DeviceKind::attached) return {};
  if (try_task_.is_running()) return tr("The device is being tried.");
  if (survey_task_.is_running() || !has_looked_) return tr("Devices are being looked for.");
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
  DriverOptions options = driver_options();
  options.tell = [this](const std::string& sentence) {
    // The task is waited for before this goes.
    QMetaObject::invokeMethod(
        this, [this, sentence] { state_->set_state(State::look, text(sentence)); },
        Qt::QueuedConnection);
  };
  try_task_.run<TriedDevice>(
      [device = device(), protocol = protocol_, drivers = study_.drivers(), options, agreed](
          const std::stop_token& stop, const BackgroundTask::Progress&) {
        DriverOptions mine = options;
        mine.stop = stop;
        return try_device(device, *protocol, drivers, mine, agreed);
      },
      [this](const TriedDevice& found) { show_try(found); },
      [this](const QString& what) {
        show_chosen();
        state_->set_state(State::stop, what);
        emit changed();
      });
  show_chosen();
  state_->set_state(State::unknown, tr("It is being opened."));
  state_->show();
  emit changed();
}

void DeviceChooser::show_try(const TriedDevice& found) {
  const bool is_asked = !found.wants_to_move.empty();
  if (!is_asked && !found.was_stopped) tried_ = std::make_shared<const TriedDevice>(found);
  show_chosen();
  // Somebody may have turned to virtual participants meanwhile.
  if (is_asked && whom_ == For::people && found.device == device()) {
    ask(words_of(Phrase(found.wants_to_move).as_sentence()).simplified(), tr("Let it move"),
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

void DeviceChooser::choose_firmware() {
  auto* dialog = new QFileDialog(this, tr("The file of a Falcon's firmware"));
  dialog->setObjectName("firmware_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    remember_firmware(file.toStdString());
    look();
  });
  dialog->open();
}

}  // namespace asperity
