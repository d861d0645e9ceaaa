// Puts the mirror into a layout under its heading.

#include "app/gui/session/mirror_frame.h"

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>

#include "app/gui/look/controls.h"

namespace asperity {

MirrorFrame::MirrorFrame(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid / 2);
  auto* heading = new QLabel(tr("PARTICIPANT'S VIEW"), this);
  heading->setFont(text_font(TextSize::small, true));
  heading->setProperty("role", "muted");
  rows->addWidget(heading);
  QFrame* screen = make_card(this, place_);
  place_->setContentsMargins(1, 1, 1, 1);
  screen->setMinimumHeight(72);
  QLabel* const sentence = make_text(tr("The participant's window is not open."), screen, true);
  sentence->setAlignment(Qt::AlignCenter);
  mirror_ = sentence;
  place_->addWidget(mirror_);
  rows->addWidget(screen, 1);
}

void MirrorFrame::set_mirror(QWidget* mirror) {
  delete mirror_;
  mirror_ = mirror;
  place_->addWidget(mirror_);
}

}  // namespace asperity

#include "moc_mirror_frame.cpp"
