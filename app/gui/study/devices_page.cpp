#include "app/gui/study/devices_page.h"

#include <algorithm>
#include <utility>

#include <QtWidgets/QGridLayout>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>

#include "app/gui/study/settings.h"
#include "app/tasks/device_choice.h"
#include "app/tasks/study_overview.h"

namespace asperity {

namespace {

constexpr int kCardWidth = 720;
constexpr const char* kMouseDriver = "mouse";  // has no handle that could be pushed

QString number(double value, int decimals) { return QString::number(value, 'f', decimals); }

/// What a device can do, as name and value.
std::vector<std::pair<QString, QString>> facts_of(const DeviceCapability& device) {
  const glm::dvec3 size_mm = 1e3 * (device.workspace_maximum_m - device.workspace_minimum_m);
  std::vector<std::pair<QString, QString>> facts{
      {DevicesPage::tr("Motion sensed"),
       DevicesPage::tr("%1 degrees of freedom").arg(device.sensed_degrees_of_freedom)},
      {DevicesPage::tr("Force given"),
       DevicesPage::tr("%1 degrees of freedom").arg(device.actuated_degrees_of_freedom)},
      {DevicesPage::tr("Workspace"),
       DevicesPage::tr("%1 × %2 × %3 mm")
           .arg(number(size_mm.x, 0), number(size_mm.y, 0), number(size_mm.z, 0))},
      {DevicesPage::tr("Largest force"),
       DevicesPage::tr("%1 N").arg(number(device.peak_force_N, 1))},
      {DevicesPage::tr("Lasting force"),
       device.continuous_force_N > 0.0
           ? DevicesPage::tr("%1 N").arg(number(device.continuous_force_N, 1))
           : DevicesPage::tr("not stated")},
      {DevicesPage::tr("Resolution of position"),
       device.position_resolution_m > 0.0
           ? DevicesPage::tr("%1 µm").arg(number(1e6 * device.position_resolution_m, 1))
           : DevicesPage::tr("exact (simulated)")},
      {DevicesPage::tr("Fastest loop"),
       DevicesPage::tr("%1 Hz").arg(number(device.maximum_rate_Hz, 0))},
      {DevicesPage::tr("Who keeps time"), device.pacing == Pacing::ours
                                              ? DevicesPage::tr("this program")
                                              : DevicesPage::tr("the maker's driver")}};
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

FoundState state_of(const DriverSurvey& survey) {
  int usable = 0;
  for (const AttachedDevice& device : survey.attached) usable += device.is_usable() ? 1 : 0;
  if (usable > 0) return {State::fine, DevicesPage::tr("%1 ready").arg(usable)};
  if (!survey.attached.empty()) return {State::look, DevicesPage::tr("not usable yet")};
  if (!survey.hindrance.empty()) return {State::unknown, DevicesPage::tr("not set up")};
  return {State::unknown, DevicesPage::tr("none attached")};
}

/// Whether what is advised can be done at a terminal only.
bool names_an_option(const DriverSurvey& survey) {
  const auto names_one = [](const std::string& sentence) {
    return sentence.find("--") != std::string::npos;
  };
  return names_one(survey.hindrance) ||
         std::any_of(survey.attached.begin(), survey.attached.end(),
                     [&](const AttachedDevice& device) { return names_one(device.hindrance); });
}

QString name_of(const AttachedDevice& device) {
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
          [drivers = study.drivers()] {
            DriverOptions options = driver_options();
            // The mouse needs a window that feeds it; sessions have one.
            LatestValue<PointerSample> pointer{};
            options.pointer = &pointer;
            return survey_devices(drivers, options);
          },
          parent) {}

DevicesPage::DevicesPage(OpenStudy& study, Survey survey, QWidget* parent)
    : StudyPage(study, tr("Devices"), parent), survey_(std::move(survey)) {
  setObjectName("devices_page");
  look_button_ = make_button(tr("Look again"), ButtonRole::plain, this);
  look_button_->setObjectName("devices_look");
  head().addWidget(look_button_);
  connect(look_button_, &QPushButton::clicked, this, &DevicesPage::look);
  auto* area = new QScrollArea(this);
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
      tr("The simulated device is always there: a virtual hand holds its probe. What a protocol "
         "asks for is compared with the device before a session starts."),
      inside, true);
  cards_->addWidget(note);
  found_ = new QWidget(inside);
  auto* found = new QVBoxLayout(found_);
  found->setContentsMargins(0, 0, 0, 0);
  found->setSpacing(kMargin);
  cards_->addWidget(found_);
  cards_->addStretch(1);
}

void DevicesPage::add_simulated() {
  for (const DeviceCapability& device : device_overviews()) {
    ++simulated_;
    QVBoxLayout* layout = nullptr;
    QFrame* card = make_device_card(QString::fromStdString(device.name), State::fine, tr("ready"),
                                    this, layout);
    layout->addWidget(make_text(QString::fromStdString(device.model), card, true));
    layout->addSpacing(kGrid);
    auto* grid = new QGridLayout();
    grid->setHorizontalSpacing(kGroupGap);
    grid->setVerticalSpacing(kGrid);
    grid->setColumnMinimumWidth(0, 240);
    grid->setColumnStretch(1, 1);
    for (const auto& [name, value] : facts_of(device)) {
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
  add_models();
}

void DevicesPage::add_models() {
  QVBoxLayout* layout = nullptr;
  QFrame* card = make_card(this, layout);
  card->setObjectName("device_models");
  layout->addWidget(make_heading(tr("In place of a real device"), card));
  layout->addWidget(make_text(
      tr("The simulated device with the workspace, forces, latency and steps of a real one, as far "
         "as they are known: to rehearse a protocol before the device is there."),
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
  if (!looked_) look();
}

void DevicesPage::look() {
  looked_ = true;
  look_button_->setEnabled(false);
  look_button_->setText(tr("Looking…"));
  const auto done = [this] {
    look_button_->setText(tr("Look again"));
    look_button_->setEnabled(true);
  };
  task_.run<std::vector<SurveyedDriver>>(
      [survey = survey_](const std::stop_token&, const BackgroundTask::Progress&) {
        return survey();
      },
      [this, done](const std::vector<SurveyedDriver>& drivers) {
        done();
        show_found(drivers);
      },
      [this, done](const QString& what) {
        done();
        banner().show_news(State::look, tr("Devices could not be looked for: %1").arg(what));
      });
}

void DevicesPage::show_found(const std::vector<SurveyedDriver>& drivers) {
  while (QLayoutItem* item = found_->layout()->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  attached_ = 0;
  for (const SurveyedDriver& driver : drivers) {
    if (driver.id != "simulated") add_driver(driver);
  }
  emit counted(count());
}

void DevicesPage::add_driver(const SurveyedDriver& driver) {
  const FoundState state = state_of(driver.survey);
  QVBoxLayout* layout = nullptr;
  QFrame* card =
      make_device_card(QString::fromStdString(driver.id), state.state, state.words, found_, layout);
  card->setObjectName("device_" + QString::fromStdString(driver.id));
  layout->addWidget(make_text(QString::fromStdString(driver.summary), card, true));
  const auto say = [&](const std::string& sentence) {
    if (sentence.empty()) return;
    QLabel* text = make_text(QString::fromStdString(sentence), card);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(text);
  };
  say(driver.survey.found);
  for (const AttachedDevice& device : driver.survey.attached) {
    attached_ += device.is_usable() ? 1 : 0;
    QLabel* name = make_text(name_of(device), card);
    if (!device.is_usable() || driver.id == kMouseDriver) {
      layout->addWidget(name);
    } else {
      const std::string& tag = device.serial.empty() ? device.place : device.serial;
      auto* row = new QHBoxLayout();
      row->addWidget(name, 1);
      row->addWidget(make_test_button(
          {.device = driver.id + (tag.empty() ? "" : ":" + tag),
           .handle = device.model + (tag.empty() ? "" : " " + tag),
           .name = name_of(device),
           .which = {driver.id, device.serial.empty() ? device.model : "", device.serial},
           .remark = device.remark,
           .has_motors = driver.has_motors},
          card));
      layout->addLayout(row);
    }
    say(device.remark);
    say(device.hindrance);
  }
  say(driver.survey.hindrance);
  if (names_an_option(driver.survey)) {
    auto* note = make_text(tr("What begins with -- is an option of the commands asperity devices, "
                              "device-test, check and run; the window has none of them."),
                           card, true);
    note->setObjectName("device_options_" + QString::fromStdString(driver.id));
    layout->addWidget(note);
  }
  found_->layout()->addWidget(card);
}

QPushButton* DevicesPage::make_test_button(const TestedDevice& device, QWidget* parent) {
  QPushButton* button = make_button(tr("Test this device…"), ButtonRole::plain, parent);
  button->setObjectName("device_test_" + QString::fromStdString(device.device));
  connect(button, &QPushButton::clicked, this, [this, device] { emit test_wanted(device); });
  return button;
}

QString DevicesPage::count() const { return tr("%1 ready").arg(simulated_ + attached_); }

}  // namespace asperity
