#include "app/gui/study/devices_page.h"

#include <QtWidgets/QGridLayout>

#include "app/tasks/study_overview.h"

namespace asperity {

namespace {

constexpr int kCardWidth = 720;

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

}  // namespace

DevicesPage::DevicesPage(OpenStudy& study, QWidget* parent)
    : StudyPage(study, tr("Devices"), parent) {
  setObjectName("devices_page");
  for (const DeviceCapability& device : device_overviews()) {
    ++ready_;
    QVBoxLayout* layout = nullptr;
    QFrame* card = make_card(this, layout);
    card->setMaximumWidth(kCardWidth);
    auto* top = new QHBoxLayout();
    top->addWidget(make_heading(QString::fromStdString(device.name), card), 1);
    auto* state = new StateLabel(card);
    state->set_state(State::fine, tr("ready"));
    top->addWidget(state);
    layout->addLayout(top);
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
    body().addWidget(card);
  }
  QLabel* note = make_text(
      tr("The simulated device is always there: a virtual hand holds its probe. What a protocol "
         "asks for is compared with the device before a session starts."),
      this, true);
  note->setMaximumWidth(kCardWidth);
  body().addWidget(note);
  body().addStretch(1);
}

QString DevicesPage::count() const { return tr("%1 ready").arg(ready_); }

}  // namespace asperity
