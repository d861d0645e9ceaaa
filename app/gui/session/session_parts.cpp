// Places the parts by the form of the window, with switches where only one is visible.

#include "app/gui/session/session_parts.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"

namespace asperity {

namespace {

int lowest(const QWidget& widget) {
  return std::max(widget.minimumHeight(), widget.minimumSizeHint().height());
}

}  // namespace

SessionParts::SessionParts(const Widgets& widgets, QWidget* parent)
    : QWidget(parent), widgets_(widgets) {
  grid_ = new QGridLayout(this);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(kMargin);
  grid_->setVerticalSpacing(kGrid);
  make_switches();
  for (QWidget* part : {widgets_.plan, widgets_.tracks, widgets_.plots, widgets_.sight,
                        widgets_.answers, widgets_.notes}) {
    // Behind the switches also for Tab, whose order follows that in which widgets come into a window.
    part->setParent(nullptr);
    part->setParent(this);
    part->setSizePolicy(QSizePolicy::Ignored, part->sizePolicy().verticalPolicy());
  }
  set_form(SessionForm::wide);
}

void SessionParts::make_switches() {
  switches_ = new QWidget(this);
  auto* row = new QHBoxLayout(switches_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGrid);
  // Five have to stand side by side on half a screen; notes are with the responses.
  const std::array words{tr("Plan"), tr("Force and path"), tr("Tracks"), tr("Responses"),
                         tr("Mirror")};
  const std::array names{"show_plan", "show_plots", "show_tracks", "show_notes", "show_sight"};
  for (std::size_t i = 0; i < kParts.size(); ++i) {
    QPushButton* button = make_button(words[i], ButtonRole::selector, switches_);
    button->setObjectName(names[i]);
    button->setFont(text_font(TextSize::small));
    // By Tab, not by a click: what was clicked would hear the next Space of the participant.
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QPushButton::clicked, this, [this, part = kParts[i]] { show_part(part); });
    row->addWidget(button, 1);
    switch_of_[i] = button;
  }
}

void SessionParts::set_form(SessionForm form) {
  if (form == form_) return;
  form_ = form;
  while (QLayoutItem* item = grid_->takeAt(0)) delete item;
  for (int i = 0; i < 4; ++i) {
    grid_->setColumnStretch(i, 0);
    grid_->setRowStretch(i, 0);
  }
  const auto& [plan, plots, tracks, sight, answers, notes] = widgets_;
  switch (form) {
    case SessionForm::wide:
      grid_->addWidget(plan, 0, 0, has_tracks_ ? 2 : 3, 1);
      if (has_tracks_) grid_->addWidget(tracks, 2, 0);
      grid_->addWidget(plots, 0, 1, 3, 1);
      grid_->addWidget(sight, 0, 2);
      grid_->addWidget(answers, 1, 2);
      grid_->addWidget(notes, 2, 2);
      grid_->setColumnStretch(0, 42);
      grid_->setColumnStretch(1, 48);
      grid_->setColumnStretch(2, 41);
      grid_->setRowStretch(0, 1);
      grid_->setRowStretch(2, 1);
      break;
    case SessionForm::medium:
      grid_->addWidget(plan, 0, 0);
      grid_->addWidget(answers, 1, 0);
      grid_->addWidget(notes, 2, 0);
      if (has_tracks_) grid_->addWidget(tracks, 3, 0);
      grid_->addWidget(plots, 0, 1, has_tracks_ ? 4 : 3, 1);
      grid_->setColumnStretch(0, 44);
      grid_->setColumnStretch(1, 56);
      grid_->setRowStretch(0, 3);
      grid_->setRowStretch(2, 2);
      if (has_tracks_) grid_->setRowStretch(3, 2);
      break;
    case SessionForm::narrow:
      grid_->addWidget(switches_, 0, 0);
      // In one cell: one of them is shown.
      grid_->addWidget(plan, 1, 0, 2, 1);
      grid_->addWidget(plots, 1, 0, 2, 1);
      grid_->addWidget(tracks, 1, 0, 2, 1);
      grid_->addWidget(sight, 1, 0, 2, 1);
      grid_->addWidget(answers, 1, 0);
      grid_->addWidget(notes, 2, 0);
      grid_->setColumnStretch(0, 1);
      grid_->setRowStretch(2, 1);
      break;
  }
  show_parts();
}

void SessionParts::set_has_tracks(bool has_tracks) {
  if (has_tracks == has_tracks_) return;
  has_tracks_ = has_tracks;
  if (!has_tracks && part_ == Part::tracks) part_ = Part::plan;
  const std::optional<SessionForm> form = std::exchange(form_, std::nullopt);
  if (form) set_form(*form);
}

void SessionParts::show_part(Part part) {
  part_ = part;
  show_parts();
}

void SessionParts::show_parts() {
  const bool one = form_ == SessionForm::narrow;
  // Where banners need the room, a part that would be clipped is not shown at all.
  const int of_switches = std::max(kControlHeight, switches_->sizeHint().height());
  const int room = height() - of_switches - kGrid;
  const auto fits = [&](Part part) {
    if (!one) return true;
    switch (part) {
      case Part::plan:
        return lowest(*widgets_.plan) <= room;
      case Part::plots:
        return lowest(*widgets_.plots) <= room;
      case Part::tracks:
        return lowest(*widgets_.tracks) <= room;
      case Part::notes:
        return lowest(*widgets_.answers) + kGrid + lowest(*widgets_.notes) <= room;
      case Part::sight:
        return lowest(*widgets_.sight) <= room;
    }
    return true;
  };
  const bool has_room = fits(part_);
  switches_->setVisible(one && height() >= of_switches);
  for (std::size_t i = 0; i < kParts.size(); ++i) {
    switch_of_[i]->setChecked(kParts[i] == part_);
    if (kParts[i] == Part::tracks) switch_of_[i]->setVisible(has_tracks_);
  }
  const auto shows = [&](Part part) { return has_room && (!one || part == part_); };
  widgets_.plan->setVisible(shows(Part::plan));
  widgets_.plots->setVisible(shows(Part::plots));
  widgets_.tracks->setVisible(has_tracks_ && shows(Part::tracks));
  widgets_.sight->setVisible(shows(Part::sight) && form_ != SessionForm::medium);
  widgets_.answers->setVisible(shows(Part::notes));
  widgets_.notes->setVisible(shows(Part::notes));
}

void SessionParts::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  show_parts();
}

}  // namespace asperity

#include "moc_session_parts.cpp"
