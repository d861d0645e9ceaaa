// Repeats its reads when the study changes, those for the visible page only while it is shown.

#include "app/gui/base/study_page.h"

#include <utility>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QStackedLayout>

namespace asperity {

StudyPage::StudyPage(OpenStudy& study, const QString& title, QWidget* parent)
    : QWidget(parent), study_(study) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  layout->setSpacing(kMargin);
  head_ = new QHBoxLayout();
  head_->setSpacing(kGrid);
  title_ = make_title(title, this);
  head_->addWidget(title_, 1);
  layout->addLayout(head_);
  banner_ = new Banner(this);
  layout->addWidget(banner_);
  stack_ = new QStackedLayout();
  layout->addLayout(stack_, 1);
  auto* body = new QWidget(this);
  body_ = new QVBoxLayout(body);
  body_->setContentsMargins(0, 0, 0, 0);
  body_->setSpacing(kMargin);
  stack_->addWidget(body);
  connect(&study_, &OpenStudy::changed, this, &StudyPage::refresh);
}

void StudyPage::refresh() {
  for (RepeatedRead* reading : always_) reading->want();
  stale_ = !isVisible();
  if (stale_) return;
  for (RepeatedRead* reading : when_shown_) reading->want();
}

void StudyPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!std::exchange(stale_, false)) return;
  for (RepeatedRead* reading : when_shown_) reading->read();
}

void StudyPage::add_reading(Need need, RepeatedRead* reading) {
  (need == Need::always ? always_ : when_shown_).push_back(reading);
  if (need == Need::always || isVisible()) reading->read();
}

void StudyPage::forget_readings() {
  for (RepeatedRead* reading : always_) delete reading;
  for (RepeatedRead* reading : when_shown_) delete reading;
  always_.clear();
  when_shown_.clear();
}

void StudyPage::set_empty_state(EmptyState* empty) { stack_->addWidget(empty); }

void StudyPage::show_empty(bool empty) { stack_->setCurrentIndex(empty ? 1 : 0); }

void StudyPage::show_failure(const QString& what) {
  banner_->show_news(State::stop, tr("The study could not be read: %1").arg(what), tr("Try again"),
                     [this] { refresh(); });
}

}  // namespace asperity

#include "moc_repeated_read.cpp"
#include "moc_study_page.cpp"
