// Hides one side where the width is less than both need.

#include "app/gui/editor/editor_sides.h"

#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSplitter>
#include <QtWidgets/QVBoxLayout>

#include "app/gui/look/controls.h"

namespace asperity {

namespace {

/// Labels of fields, values and units on one line, next to a plan with readable columns.
constexpr int kWidthOfBoth = 1000;

}  // namespace

EditorSides::EditorSides(QWidget* protocol, QWidget* plan, QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  // The sides have less room than both need until one of them is hidden.
  layout->setSizeConstraint(QLayout::SetNoConstraint);
  tabs_ = new QWidget(this);
  auto* row = new QHBoxLayout(tabs_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  auto* group = new QButtonGroup(this);
  const auto add_tab = [&](const QString& name, const char* object) {
    QPushButton* tab = make_button(name, ButtonRole::selector, tabs_);
    tab->setObjectName(object);
    group->addButton(tab);
    row->addWidget(tab);
    connect(tab, &QPushButton::clicked, this, &EditorSides::arrange);
    return tab;
  };
  to_protocol_ = add_tab(tr("Protocol"), "editor_side_protocol");
  to_plan_ = add_tab(tr("Plan, screen, precision"), "editor_side_plan");
  to_protocol_->setChecked(true);
  row->addStretch();
  layout->addWidget(tabs_);
  splitter_ = make_splitter(Qt::Horizontal, this);
  splitter_->addWidget(protocol);
  splitter_->addWidget(plan);
  splitter_->setStretchFactor(0, 5);
  splitter_->setStretchFactor(1, 3);
  splitter_->setSizes({960, 640});
  layout->addWidget(splitter_, 1);
  arrange();
}

QSize EditorSides::minimumSizeHint() const {
  QSize least{};
  for (int side = 0; side < splitter_->count(); ++side) {
    least = least.expandedTo(splitter_->widget(side)->minimumSizeHint());
  }
  return least + QSize(0, tabs_->sizeHint().height() + kGrid);
}

void EditorSides::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void EditorSides::arrange() {
  const bool has_both = width() >= kWidthOfBoth;
  tabs_->setVisible(!has_both);
  splitter_->widget(0)->setVisible(has_both || to_protocol_->isChecked());
  splitter_->widget(1)->setVisible(has_both || to_plan_->isChecked());
}

}  // namespace asperity

#include "moc_editor_sides.cpp"
