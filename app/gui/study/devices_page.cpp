// Surveys the drivers in the background, and shows a card with facts or the blocker for each device.

#include "app/gui/study/devices_page.h"

#include <algorithm>
#include <utility>

#include <QtWidgets/QGridLayout>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>

#include "app/device_bench/device_choice.h"
#include "app/gui/base/settings.h"
#include "app/gui/devices/driver_setup.h"
#include "app/gui/devices/driver_words.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/tasks/study_overview.h"

namespace asperity {

namespace {

constexpr int kCardWidth = 720;
constexpr const char* kMouseDriver = "mouse";    // has no handle that could be pushed
constexpr const char* kReplayDriver = "replay";  // takes a file, and windows offer none

QString fixed_number(double value, int decimals) { return shown_number(value, 'f', decimals); }

/// What a device can do, as name and value.
std::vector<std::pair<QString, QString>> device_facts(const DeviceCapability& device) {
  const glm::dvec3 size_mm = 1e3 * (device.workspace_maximum_m - device.workspace_minimum_m);
  std::vector<std::pair<QString, QString>> facts{
      {DevicesPage::tr("Motion sensed"),
       DevicesPage::tr("%1 degrees of freedom").arg(device.sensed_degrees_of_freedom)},
      {DevicesPage::tr("Force output"),
       DevicesPage::tr("%1 degrees of freedom").arg(device.actuated_degrees_of_freedom)},
      {DevicesPage::tr("Workspace"),
       DevicesPage::tr("%1 × %2 × %3 mm")
           .arg(fixed_number(size_mm.x, 0), fixed_number(size_mm.y, 0),
                fixed_number(size_mm.z, 0))},
      {DevicesPage::tr("Peak force"),
       DevicesPage::tr("%1 N").arg(fixed_number(device.peak_force_N, 1))},
      {DevicesPage::tr("Continuous force"),
       device.continuous_force_N > 0.0
           ? DevicesPage::tr("%1 N").arg(fixed_number(device.continuous_force_N, 1))
           : DevicesPage::tr("not stated")},
      {DevicesPage::tr("Position resolution"),
       device.position_resolution_m > 0.0
           ? DevicesPage::tr("%1 µm").arg(fixed_number(1e6 * device.position_resolution_m, 1))
           : DevicesPage::tr("exact (simulated)")},
      {DevicesPage::tr("Highest servo rate"),
       DevicesPage::tr("%1 Hz").arg(fixed_number(device.maximum_rate_Hz, 0))},
      {DevicesPage::tr("Timing source"), device.pacing == Pacing::ours
                                             ? DevicesPage::tr("this program")
                                             : DevicesPage::tr("the manufacturer's driver")}};
  if (!device.serial.empty()) {
    facts.insert(facts.begin(),
                 {DevicesPage::tr("Serial number"), QString::fromStdString(device.serial)});
  }
  return facts;
}

struct FoundState {
  State state = State::unknown;
  QString words{};
};

FoundState found_state(const DriverSurvey& survey) {
  int usable = 0;
  for (const AttachedDevice& device : survey.attached) usable += device.is_usable() ? 1 : 0;
  if (usable > 0) return {State::fine, DevicesPage::tr("%1 ready").arg(usable)};
  if (!survey.attached.empty()) return {State::look, DevicesPage::tr("not usable yet")};
  if (!survey.blocker.empty()) return {State::unknown, DevicesPage::tr("not set up")};
  return {State::unknown, DevicesPage::tr("none attached")};
}

QString attached_name(const AttachedDevice& device) {
  const QString model = QString::fromStdString(device.model);
  const QString serial = QString::fromStdString(device.serial);
  const QString place = QString::fromStdString(device.place);
  if (!serial.isEmpty() && !place.isEmpty()) {
    return DevicesPage::tr("%1, serial number %2, at %3").arg(model, serial, place);
  }
  if (!serial.isEmpty()) return DevicesPage::tr("%1, serial number %2").arg(model, serial);
  if (!place.isEmpty()) return DevicesPage::tr("%1, at %2").arg(model, place);
  return model;
}

/// A card with a name and a state at its head.
QFrame* make_device_card(const QString& name, State state, const QString& words, QWidget* parent,
                         QVBoxLayout*& layout) {
  QFrame* card = make_card(parent, layout);
  auto* top = new QHBoxLayout();
  top->addWidget(make_heading(name, card), 1);
  auto* label = new StateLabel(card);
  label->set_state(state, words);
  top->addWidget(label);
  layout->addLayout(top);
  return card;
}

}  // namespace

DevicesPage::DevicesPage(OpenStudy& study, QWidget* parent)
    : DevicesPage(
          study,
          [drivers = study.drivers()](const std::stop_token& stop) {
            // The mouse needs a window that feeds it; sessions have one.
            LatestValue<PointerSample> pointer{};
            return survey_devices(drivers, [&](const std::string& driver) {
              DriverOptions options = driver_options(driver);
              options.pointer = &pointer;
              options.stop = stop;
              return options;
            });
          },
          parent) {}

DevicesPage::DevicesPage(OpenStudy& study, Survey survey, QWidget* parent)
    : StudyPage(study, tr("Devices"), parent), survey_(std::move(survey)) {
  setObjectName("devices_page");
  look_button_ = make_button(tr("Rescan"), ButtonRole::plain, this);
  look_button_->setObjectName("devices_look");
  head().addWidget(look_button_);
  connect(look_button_, &QPushButton::clicked, this, &DevicesPage::look);
  auto* area = new QScrollArea(this);
  area->setAccessibleName(tr("Devices"));
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->viewport()->setAutoFillBackground(false);
  auto* inside = new QWidget(area);
  // Here and not on what is in it: a layout asks how high words are at the width that it has itself.
  inside->setMaximumWidth(kCardWidth + kGrid);
  cards_ = new QVBoxLayout(inside);
  cards_->setContentsMargins(0, 0, kGrid, 0);
  cards_->setSpacing(kMargin);
  area->setWidget(inside);
  inside->setAutoFillBackground(false);  // which setWidget turns on
  body().addWidget(area, 1);
  add_simulated();
  QLabel* note = make_text(
      tr("The simulated device is always available: a virtual hand holds its probe. The "
         "requirements of a protocol are compared with the device before a session starts."),
      inside, true);
  cards_->addWidget(note);
  udev_ = new StateLabel(inside);
  udev_->setObjectName("devices_udev");
  udev_->hide();
  cards_->addWidget(udev_);
  found_ = new QWidget(inside);
  auto* found = new QVBoxLayout(found_);
  found->setContentsMargins(0, 0, 0, 0);
  found->setSpacing(kMargin);
  cards_->addWidget(found_);
  add_models();
  cards_->addStretch(1);
}

void DevicesPage::add_simulated() {
  for (const DeviceCapability& device : device_overviews()) {
    ++simulated_;
    QVBoxLayout* layout = nullptr;
    const Driver* driver = study().drivers().find(device.name);
    const bool has_name = driver != nullptr && !driver->name.empty();
    const std::string& title = has_name ? driver->name : device.name;
    QFrame* card =
        make_device_card(QString::fromStdString(title), State::fine, tr("ready"), this, layout);
    layout->addWidget(make_text(QString::fromStdString(device.model), card, true));
    layout->addSpacing(kGrid);
    auto* grid = new QGridLayout();
    grid->setHorizontalSpacing(kGroupGap);
    grid->setVerticalSpacing(kGrid);
    grid->setColumnMinimumWidth(0, 240);
    grid->setColumnStretch(1, 1);
    for (const auto& [name, value] : device_facts(device)) {
      const int row = grid->rowCount();
      grid->addWidget(make_text(name, card, true), row, 0);
      QLabel* text = make_text(value, card);
      text->setTextInteractionFlags(Qt::TextSelectableByMouse);
      grid->addWidget(text, row, 1);
    }
    layout->addLayout(grid);
    layout->addSpacing(kGrid);
    layout->addWidget(make_test_button({.device = device.name,
                                        .handle = device.model,
                                        .name = tr("Simulated device"),
                                        .which = {device.name, device.model, device.serial},
                                        .is_simulated = true},
                                       card),
                      0, Qt::AlignLeft);
    cards_->addWidget(card);
  }
}

void DevicesPage::add_models() {
  QVBoxLayout* layout = nullptr;
  models_ = make_card(this, layout);
  QFrame* const card = models_;
  card->setObjectName("device_models");
  layout->addWidget(make_heading(tr("Simulated models of devices"), card));
  layout->addWidget(make_text(
      tr("The simulated device with the workspace, forces, latency and position steps of a real "
         "one, as far as they are known: for rehearsing a protocol before the device is "
         "available."),
      card, true));
  for (const DeviceChoice& choice : devices_without_hardware()) {
    if (choice.kind != DeviceKind::simulated || choice.model.empty()) continue;
    const QString model = QString::fromStdString(choice.model);
    auto* row = new QHBoxLayout();
    row->addWidget(make_text(model, card), 1);
    row->addWidget(make_test_button({.device = choice.device,
                                     .handle = choice.model,
                                     .name = tr("Simulated: %1").arg(model),
                                     .which = which_device(choice.device),
                                     .is_simulated = true},
                                    card));
    layout->addLayout(row);
  }
  cards_->addWidget(card);
}

void DevicesPage::showEvent(QShowEvent* event) {
  StudyPage::showEvent(event);
  if (!looked_ || told_ != driver_places()) look();
}

void DevicesPage::look() {
  looked_ = true;
  told_ = driver_places();
  if (setup_ != nullptr) setup_->show_looking();
  look_button_->setEnabled(false);
  look_button_->setText(tr("Searching…"));
  const auto done = [this] {
    look_button_->setText(tr("Rescan"));
    look_button_->setEnabled(true);
  };
  task_.run<std::vector<SurveyedDriver>>(
      [survey = survey_](const std::stop_token& stop, const BackgroundTask::Progress&) {
        return survey(stop);
      },
      [this, done](const std::vector<SurveyedDriver>& drivers) {
        done();
        show_found(drivers);
      },
      [this, done](const QString& what) {
        done();
        banner().show_news(State::look, tr("The search for devices failed: %1").arg(what));
        if (setup_ != nullptr) setup_->show_failure(what);
      });
}

void DevicesPage::show_found(const std::vector<SurveyedDriver>& drivers) {
  const Phrase missing = missing_udev_rule();
  udev_->setVisible(!missing.empty());
  udev_->set_state(State::look, words_of(missing));
  // Who was at a button is there again, though it is another one.
  const QWidget* const focus = window()->focusWidget();
  const bool had_focus = focus != nullptr && found_->isAncestorOf(focus);
  const QString focused = had_focus ? focus->objectName() : QString();
  while (QLayoutItem* item = found_->layout()->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  attached_ = 0;
  drivers_ = drivers;
  for (const SurveyedDriver& driver : drivers) {
    if (driver.id != "simulated") add_driver(driver);
  }
  // By the key as by the eye: what was made later comes before what stands below it.
  const auto found_buttons = found_->findChildren<QPushButton*>();
  QWidget* before = found_buttons.empty() ? nullptr : found_buttons.last();
  for (QPushButton* button : models_->findChildren<QPushButton*>()) {
    if (before != nullptr) setTabOrder(before, button);
    before = button;
  }
  if (auto* same = had_focus ? found_->findChild<QWidget*>(focused) : nullptr) same->setFocus();
  if (setup_ != nullptr) setup_->show_found(drivers);
  emit counted(count());
}

void DevicesPage::add_driver(const SurveyedDriver& driver) {
  const FoundState state = found_state(driver.survey);
  QVBoxLayout* layout = nullptr;
  QFrame* card = make_device_card(QString::fromStdString(driver.name), state.state, state.words,
                                  found_, layout);
  card->setObjectName("device_" + QString::fromStdString(driver.id));
  layout->addWidget(make_text(words_of(phrase_of_driver(driver.summary)), card, true));
  const auto say = [&](const QString& words) {
    if (words.isEmpty()) return;
    QLabel* text = make_text(words, card);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(text);
  };
  const auto say_sentence = [&](const std::string& sentence) {
    if (!sentence.empty()) say(words_of(phrase_of_driver(sentence).as_sentence(), tr("“Set up…”")));
  };
  say(text(driver.survey.found));
  for (const AttachedDevice& device : driver.survey.attached) {
    // The mouse is always there: it says nothing of what is attached.
    attached_ += device.is_usable() && driver.id != kMouseDriver ? 1 : 0;
    QLabel* name = make_text(attached_name(device), card);
    if (!device.is_usable() || driver.id == kMouseDriver) {
      layout->addWidget(name);
    } else {
      const std::string& tag = device.serial.empty() ? device.place : device.serial;
      auto* row = new QHBoxLayout();
      row->addWidget(name, 1);
      row->addWidget(make_test_button(
          {.device = driver.id + (tag.empty() ? "" : ":" + tag),
           .handle = device.model + (tag.empty() ? "" : " " + tag),
           .name = attached_name(device),
           .which = {driver.id, device.serial.empty() ? device.model : "", device.serial},
           .remark = device.remark,
           .has_motors = driver.has_motors},
          card));
      layout->addLayout(row);
    }
    say_sentence(device.remark);
    say_sentence(device.blocker);
  }
  if (driver.id == kReplayDriver) {
    say(
        tr("It replays a recording and is available only at a terminal: asperity run PROTOCOL "
           "--device replay:FILE."));
  } else {
    say_sentence(driver.survey.blocker);
  }
  if (need_of(driver.id)) {
    QPushButton* button = make_button(tr("Set up…"), ButtonRole::plain, card);
    button->setObjectName("device_setup_" + QString::fromStdString(driver.id));
    button->setAccessibleName(tr("Set up %1").arg(QString::fromStdString(driver.name)));
    button->setToolTip(what_to_set_up(driver.id));
    connect(button, &QPushButton::clicked, this, [this, id = driver.id] { set_up(id); });
    layout->addWidget(button, 0, Qt::AlignLeft);
  }
  found_->layout()->addWidget(card);
}

void DevicesPage::set_up(const std::string& driver) {
  if (setup_ != nullptr) return;
  setup_ = new DriverSetup({driver}, this);
  connect(setup_, &DriverSetup::changed, this, &DevicesPage::look);
  if (task_.is_running()) {
    setup_->show_looking();
  } else {
    setup_->show_found(drivers_);
  }
  setup_->open();
}

QPushButton* DevicesPage::make_test_button(const TestedDevice& device, QWidget* parent) {
  QPushButton* button = make_button(tr("Test this device…"), ButtonRole::plain, parent);
  button->setObjectName("device_test_" + QString::fromStdString(device.device));
  connect(button, &QPushButton::clicked, this, [this, device] { emit test_wanted(device); });
  return button;
}

QString DevicesPage::count() const { return tr("%1 ready").arg(simulated_ + attached_); }

}  // namespace asperity

#include "moc_devices_page.cpp"
