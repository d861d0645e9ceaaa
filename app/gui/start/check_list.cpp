// Shows a line with state and remedy for each check, and the progress of those still running.

#include "app/gui/start/check_list.h"

#include <algorithm>
#include <functional>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QScrollArea>
#include <nlohmann/json.hpp>

#include "app/gui/base/form_words.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

State check_state(SessionCheck::State state) {
  switch (state) {
    case SessionCheck::State::fine:
      return State::fine;
    case SessionCheck::State::look:
      return State::look;
    case SessionCheck::State::stop:
      break;
  }
  return State::stop;
}

/// The title, what was found, and what to do.
QString line_text(const SessionCheck& check, const nlohmann::json& protocol) {
  QStringList found{};
  if (!check.text.empty()) found += words_of(check.text).toHtmlEscaped();
  for (const Diagnostic& warning : check.warnings) {
    found += remark_in_form(protocol, warning).toHtmlEscaped() + '.';
  }
  QString text =
      QString("<b>%1</b>&ensp;%2").arg(words_of(check.title).toHtmlEscaped(), found.join("<br>"));
  if (!check.remedy.empty()) {
    text +=
        QString("<br><span style='color:%1'>%2</span>")
            .arg(color_of(check_state(check.state)).name(), words_of(check.remedy).toHtmlEscaped());
  }
  return text;
}

}  // namespace

CheckList::CheckList(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  auto* head = new QHBoxLayout();
  head->addWidget(make_heading(tr("Checklist"), this), 1);
  again_ = make_button(tr("Check again"), ButtonRole::plain, this);
  again_->setObjectName("check_again");
  connect(again_, &QPushButton::clicked, this, &CheckList::again_wanted);
  head->addWidget(again_);
  layout->addLayout(head);
  summary_ = make_text({}, this, true);
  summary_->setObjectName("check_summary");
  layout->addWidget(summary_);
  note_ = make_text({}, this, true);
  note_->setObjectName("note_of_checks");
  note_->hide();
  layout->addWidget(note_);
  course_ = new QWidget(this);
  auto* course = new QHBoxLayout(course_);
  course->setContentsMargins(0, 0, 0, 0);
  course->setSpacing(kGrid);
  bar_ = new QProgressBar(course_);
  bar_->setObjectName("check_progress");
  bar_->setTextVisible(false);
  cancel_ = make_button(tr("Cancel"), ButtonRole::plain, course_);
  cancel_->setObjectName("check_cancel");
  course->addWidget(bar_, 1);
  course->addWidget(cancel_);
  course_->hide();
  connect(cancel_, &QPushButton::clicked, this, [this] {
    cancel_->setEnabled(false);
    summary_->setText(tr("Cancelling the checks…"));
    emit cancel_wanted();
  });
  layout->addWidget(course_);
  area_ = new QScrollArea(this);
  area_->setWidgetResizable(true);
  area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area_->setFocusPolicy(Qt::NoFocus);
  area_->viewport()->setAutoFillBackground(false);
  lines_ = new QWidget(area_);
  grid_ = new QGridLayout(lines_);
  grid_->setContentsMargins(0, 0, kGrid, 0);
  grid_->setHorizontalSpacing(kGrid);
  grid_->setVerticalSpacing(kGrid);
  grid_->setColumnStretch(1, 1);
  area_->setWidget(lines_);
  lines_->setAutoFillBackground(false);  // which setWidget turns on
  layout->addWidget(area_, 1);
  layout->addStretch(0);
  area_->hide();
}

void CheckList::set_checks(std::vector<SessionCheck> checks, const std::string& protocol) {
  const auto json = nlohmann::json::parse(protocol, nullptr, false);
  // What keeps the session from starting comes first, then what should be looked at.
  const auto is_fine = [](const SessionCheck& check) {
    return check.state == SessionCheck::State::fine;
  };
  const auto stops = [](const SessionCheck& check) {
    return check.state == SessionCheck::State::stop;
  };
  std::stable_partition(checks.begin(), checks.end(), std::not_fn(is_fine));
  std::stable_partition(checks.begin(), checks.end(), stops);
  const int rows = grid_->rowCount();
  while (QLayoutItem* item = grid_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  for (int row = 0; row < rows; ++row) grid_->setRowStretch(row, 0);
  int row = 0;
  for (const SessionCheck& check : checks) {
    const State state = check_state(check.state);
    auto* shape = new QLabel(shape_of(state), lines_);
    shape->setFont(text_font(TextSize::small, true));
    shape->setStyleSheet("color: " + color_of(state).name());
    shape->setFixedWidth(kMargin);
    auto* text = new QLabel(line_text(check, json), lines_);
    text->setFont(text_font(TextSize::small));
    text->setTextFormat(Qt::RichText);
    text->setWordWrap(true);
    text->setObjectName("check_" + QString::fromStdString(check.id));
    grid_->addWidget(shape, row, 0, Qt::AlignTop);
    grid_->addWidget(text, row, 1, Qt::AlignTop);
    ++row;
  }
  grid_->setRowStretch(row, 1);
  area_->show();
  const auto count = [&checks](SessionCheck::State state) {
    return static_cast<int>(std::count_if(
        checks.begin(), checks.end(), [state](const auto& check) { return check.state == state; }));
  };
  const int stopping = count(SessionCheck::State::stop);
  const int looks = count(SessionCheck::State::look);
  if (stopping == 1) {
    summary_->setText(tr("1 item must be resolved before the session can start."));
  } else if (stopping > 0) {
    summary_->setText(
        tr("%n items must be resolved before the session can start.", nullptr, stopping));
  } else if (looks > 0) {
    summary_->setText(tr("Ready (%n warning(s)).", nullptr, looks));
  } else {
    summary_->setText(tr("Everything is ready."));
  }
}

void CheckList::set_note(const QString& note) {
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
}

void CheckList::set_running(bool running) {
  if (running) area_->hide();  // the lines are of what was chosen before
  course_->setVisible(running);
  again_->setEnabled(!running);
  if (!running) return;
  bar_->setRange(0, 0);  // how long it takes is unknown until the device is compared
  cancel_->setEnabled(true);
  summary_->setText(tr("Checking stimuli, device and timing (up to a minute)…"));
}

void CheckList::set_progress(double fraction) {
  if (!cancel_->isEnabled()) return;
  bar_->setRange(0, 100);
  bar_->setValue(static_cast<int>(100.0 * fraction));
  summary_->setText(tr("Comparing every stimulus with the device: %1 %.").arg(bar_->value()));
}

void CheckList::set_cancelled() {
  set_running(false);
  summary_->setText(
      tr("The checks were cancelled. Press “Check again”: the session can start once they have "
         "been completed."));
}

}  // namespace asperity

#include "moc_check_list.cpp"
