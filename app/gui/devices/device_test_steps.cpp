// Makes a line for each part of the test and axis, with a mark for done, current or pending.

#include "app/gui/devices/device_test_steps.h"

#include <algorithm>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>

#include "app/device_bench/measure_device.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"

namespace asperity {

QString what_to_do(DeviceTestPart part, const std::optional<int>& axis) {
  const QString along = QString("xyz").mid(axis.value_or(0), 1);
  switch (part) {
    case DeviceTestPart::timing:
      return DeviceTestSteps::tr(
          "Do not touch the handle: it hangs free, and no force acts on it. The timing of the "
          "servo loop is measured, and the force has to be exactly zero.");
    case DeviceTestPart::safety:
      return DeviceTestSteps::tr(
          "Keep hands away: the handle is pushed softly. A stop, a force that is not finite and "
          "an unresponsive program are then tested; each has to end in zero force.");
    case DeviceTestPart::sweeps:
      return DeviceTestSteps::tr(
                 "Keep hands away: the handle is pulled to and fro along %1, slowly and then "
                 "faster. Friction and damping are determined from the resistance.")
          .arg(along);
    case DeviceTestPart::pushes:
      return DeviceTestSteps::
          tr("Keep hands away: sudden force steps act along %1, to and fro. The latency is "
             "determined from the delay until the motion begins, the mass from the acceleration.")
              .arg(along);
    case DeviceTestPart::tones:
      return DeviceTestSteps::tr(
                 "Keep hands away: the handle is driven along %1 at frequencies from 8 to 200 Hz. "
                 "Its resonance is determined from its motion.")
          .arg(along);
    case DeviceTestPart::springs:
      return DeviceTestSteps::
          tr("Keep hands away: increasingly stiff springs are rendered along %1, each with a small "
             "impulse. The result is the stiffest spring on which the handle comes to rest.")
              .arg(along);
    case DeviceTestPart::small_pushes:
      return DeviceTestSteps::tr(
                 "Keep hands away: increasingly strong small pushes act along %1 until the handle "
                 "moves.")
          .arg(along);
    case DeviceTestPart::workspace:
      return DeviceTestSteps::tr(
                 "Now take the handle and move it along all borders of its workspace: left and "
                 "right, forwards and backwards, up and down. This step lasts %1 seconds; no force "
                 "is exerted.")
          .arg(shown_number(kBorders_s, 'f', 0));
  }
  return {};
}

DeviceTestSteps::DeviceTestSteps(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid);
  steps_ = {{DeviceTestPart::timing, tr("Zero force and timing")},
            {DeviceTestPart::safety, tr("Safety")},
            {DeviceTestPart::sweeps, tr("Slow sweeps")},
            {DeviceTestPart::pushes, tr("Force steps")},
            {DeviceTestPart::tones, tr("Frequency sweep"), DeviceTrait::resonance},
            {DeviceTestPart::springs, tr("Stiff springs"), DeviceTrait::stiffness},
            {DeviceTestPart::small_pushes, tr("Weakest force"), DeviceTrait::force_resolution},
            {DeviceTestPart::workspace, tr("Workspace")}};
  for (Step& step : steps_) {
    step.label = new QLabel(this);
    rows->addWidget(step.label);
  }
  rows->addStretch(1);
  write();
}

void DeviceTestSteps::begin(const Parts& parts) {
  now_.reset();
  for (const Step& step : steps_) {
    const bool is_timing = step.part == DeviceTestPart::timing;
    const bool is_workspace = step.part == DeviceTestPart::workspace;
    const bool is_there = is_workspace ? parts.by_a_person : parts.by_motors;
    const bool is_known = !step.trait || std::find(parts.not_known.begin(), parts.not_known.end(),
                                                   *step.trait) == parts.not_known.end();
    step.label->setVisible(is_timing || (is_there && is_known));
  }
  write();
}

void DeviceTestSteps::come_to(DeviceTestPart part) {
  now_ = part;
  write();
}

void DeviceTestSteps::write() {
  for (Step& step : steps_) {
    const bool is_now = now_ == step.part;
    const bool is_done = now_ && step.part < *now_;
    step.label->setText((is_now ? "▶ " : is_done ? shape_of(State::fine) + " " : "· ") + step.name);
    step.label->setFont(text_font(TextSize::body, is_now));
    const QColor color = is_now ? theme().text : is_done ? theme().fine : theme().muted;
    step.label->setStyleSheet("color: " + color.name());
  }
}

}  // namespace asperity

#include "moc_device_test_steps.cpp"
