#include "app/gui/session/fault_panel.h"

#include <QtCore/QEvent>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"

namespace asperity {

FaultPanel::FaultPanel(QWidget* parent) : QFrame(parent) {
  setObjectName("fault_panel");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kMargin, kGrid, kMargin, kGrid);
  row->setSpacing(kMargin);
  shape_ = new QLabel("■", this);
  shape_->setFont(text_font(TextSize::title, true));
  row->addWidget(shape_);
  auto* words = new QVBoxLayout();
  words->setSpacing(kGrid / 2);
  text_ = make_text({}, this);
  text_->setObjectName("fault_text");
  words->addWidget(text_);
  safe_ = new QCheckBox(tr("It is safe: no hand is caught, nothing touches the device"), this);
  safe_->setObjectName("fault_safe");
  words->addWidget(safe_);
  row->addLayout(words, 1);
  auto* ways = new QVBoxLayout();
  ways->setSpacing(kGrid / 2);
  auto* buttons = new QHBoxLayout();
  clear_ = make_button(tr("Clear and go on"), ButtonRole::plain, this);
  clear_->setObjectName("fault_clear");
  auto* end = make_button(tr("End the session…"), ButtonRole::plain, this);
  end->setObjectName("fault_end");
  buttons->addWidget(clear_);
  buttons->addWidget(end);
  ways->addLayout(buttons);
  why_ = make_text(tr("Going on asks that it is safe: tick the box."), this, true);
  why_->setFont(text_font(TextSize::small));
  why_->setWordWrap(false);
  QSizePolicy keeps_place = why_->sizePolicy();
  keeps_place.setRetainSizeWhenHidden(true);
  why_->setSizePolicy(keeps_place);
  ways->addWidget(why_);
  row->addLayout(ways);
  connect(safe_, &QCheckBox::toggled, this, [this](bool safe) {
    clear_->setEnabled(safe);
    why_->setVisible(!safe);
  });
  connect(clear_, &QPushButton::clicked, this, &FaultPanel::clear_wanted);
  connect(end, &QPushButton::clicked, this, &FaultPanel::end_wanted);
  restyle();
  hide();
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
