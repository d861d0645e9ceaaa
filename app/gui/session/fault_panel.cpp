// Places text and button next to or below each other, as the width allows.

#include "app/gui/session/fault_panel.h"

#include <QtCore/QEvent>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"

namespace asperity {

FaultPanel::FaultPanel(QWidget* parent) : QFrame(parent) {
  setObjectName("fault_panel");
  grid_ = new QGridLayout(this);
  grid_->setContentsMargins(kMargin, kGrid, kMargin, kGrid);
  grid_->setHorizontalSpacing(kMargin);
  grid_->setVerticalSpacing(kGrid / 2);
  grid_->setColumnStretch(1, 1);
  shape_ = new QLabel("■", this);
  shape_->setFont(text_font(TextSize::title, true));
  text_ = make_text({}, this);
  text_->setObjectName("fault_text");
  safe_ = new QCheckBox(tr("It is safe: no hand is trapped, nothing touches the device"), this);
  safe_->setObjectName("fault_safe");
  ways_ = new QVBoxLayout();
  ways_->setSpacing(kGrid / 2);
  auto* buttons = new QHBoxLayout();
  buttons->setSpacing(kGrid);
  clear_ = make_button(tr("Clear and resume"), ButtonRole::plain, this);
  clear_->setObjectName("fault_clear");
  auto* end = make_button(tr("End the session…"), ButtonRole::plain, this);
  end->setObjectName("fault_end");
  buttons->addWidget(clear_);
  buttons->addWidget(end);
  buttons->addStretch(1);
  ways_->addLayout(buttons);
  why_ = make_text(tr("Confirm that it is safe before resuming."), this, true);
  why_->setFont(text_font(TextSize::small));
  why_->setWordWrap(false);
  QSizePolicy keeps_place = why_->sizePolicy();
  keeps_place.setRetainSizeWhenHidden(true);
  why_->setSizePolicy(keeps_place);
  ways_->addWidget(why_);
  arrange(false);
  connect(safe_, &QCheckBox::toggled, this, [this](bool safe) {
    clear_->setEnabled(safe);
    why_->setVisible(!safe);
  });
  connect(clear_, &QPushButton::clicked, this, &FaultPanel::clear_wanted);
  connect(end, &QPushButton::clicked, this, &FaultPanel::end_wanted);
  restyle();
  hide();
}

void FaultPanel::arrange(bool narrow) {
  narrow_ = narrow;
  grid_->removeItem(ways_);
  grid_->addWidget(shape_, 0, 0);
  grid_->addWidget(text_, 0, 1);
  grid_->addWidget(safe_, 1, narrow ? 0 : 1, 1, narrow ? 2 : 1);
  ways_->setParent(nullptr);
  if (narrow) {
    grid_->addLayout(ways_, 2, 0, 1, 2);
  } else {
    grid_->addLayout(ways_, 0, 2, 2, 1);
  }
}

void FaultPanel::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  constexpr int kNarrow = 1120;
  if (const bool narrow = width() < kNarrow; narrow != narrow_) arrange(narrow);
}

void FaultPanel::show_fault(const QString& what, bool can_clear) {
  const bool anew = isHidden();
  if (!anew && text_->text() == what && safe_->isHidden() != can_clear) return;
  if (anew) safe_->setChecked(false);
  text_->setText(what);
  safe_->setVisible(can_clear);
  clear_->setVisible(can_clear);
  clear_->setEnabled(can_clear && safe_->isChecked());
  why_->setVisible(can_clear && !safe_->isChecked());
  show();
}

void FaultPanel::restyle() {
  const QString color = theme().stop.name();
  const QString style = QString(
                            "asperity--FaultPanel { background: %1; border: 1px solid %2; "
                            "border-left: 6px solid %2; border-radius: 4px; }")
                            .arg(theme().panel.name(), color);
  if (style == styleSheet()) return;
  setStyleSheet(style);
  shape_->setStyleSheet("color: " + color);
}

void FaultPanel::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && shape_ != nullptr) restyle();
}

QString FaultPanel::text() const { return text_->text(); }

}  // namespace asperity

#include "moc_fault_panel.cpp"
