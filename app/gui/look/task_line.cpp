// Appears only if the task lasts for a moment, and shows its progress as a bar with a button to cancel.

#include "app/gui/look/task_line.h"

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QProgressBar>

#include "app/gui/look/background_task.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/focus_order.h"

namespace asperity {

namespace {

constexpr int kMoment_ms = 300;  // what is over sooner would only flicker
constexpr int kBarWidth = 160;
constexpr int kBarSteps = 1000;

}  // namespace

TaskLine::TaskLine(BackgroundTask& task, QWidget* parent) : QWidget(parent), task_(task) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGrid);
  words_ = make_text({}, this, true);
  words_->setObjectName("task_words");
  bar_ = new QProgressBar(this);
  bar_->setObjectName("task_progress");
  bar_->setTextVisible(false);
  bar_->setFixedWidth(kBarWidth);
  cancel_ = make_button(tr("Cancel"), ButtonRole::plain, this);
  cancel_->setObjectName("task_cancel");
  row->addWidget(words_, 1);
  row->addWidget(bar_);
  row->addWidget(cancel_);
  hide();
  moment_.setSingleShot(true);
  moment_.setInterval(kMoment_ms);
  connect(&moment_, &QTimer::timeout, this, [this] { setVisible(task_.is_running()); });
  connect(&task_, &BackgroundTask::started, this, &TaskLine::begin);
  connect(&task_, &BackgroundTask::progressed, this, [this](double fraction) {
    bar_->setRange(0, kBarSteps);
    bar_->setValue(static_cast<int>(fraction * kBarSteps));
  });
  connect(&task_, &BackgroundTask::finished, this, [this] {
    moment_.stop();
    hide();
  });
  connect(cancel_, &QPushButton::clicked, this, [this] {
    cancel_->setEnabled(false);
    cancel_->setText(tr("Cancelling…"));
    emit cancelWanted();
  });
}

void TaskLine::set_words(const QString& words) { words_->setText(words); }

void TaskLine::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  place_in_focus_order(*this);
}

void TaskLine::begin() {
  bar_->setRange(0, 0);
  cancel_->setEnabled(true);
  cancel_->setText(tr("Cancel"));
  if (!isVisible()) moment_.start();
}

}  // namespace asperity

#include "moc_task_line.cpp"
