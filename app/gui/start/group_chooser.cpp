// Offers the groups of the protocol in a list without a preselection.

#include "app/gui/start/group_chooser.h"

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>

#include "app/gui/base/question_form.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"

namespace asperity {

namespace {

constexpr int kGroupFieldWidth = 240;  // as the fields above it

}  // namespace

GroupChooser::GroupChooser(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kMargin);
  groups_ = new ChoiceBox(this);
  groups_->setObjectName("group");
  groups_->setPlaceholderText(tr("Choose"));
  groups_->setFixedWidth(kGroupFieldWidth);
  ignore_wheel(*groups_);
  QLabel* label = make_text(tr("Group *"), this);
  label->setBuddy(groups_);
  row->addWidget(label, 1);
  row->addWidget(groups_);
  connect(groups_, &QComboBox::currentIndexChanged, this, &GroupChooser::changed);
  hide();
}

void GroupChooser::set_groups(const std::vector<std::string>& groups) {
  const std::optional<std::string> before = group();
  {
    const QSignalBlocker silent(groups_);
    groups_->clear();
    for (const std::string& each : groups) groups_->addItem(QString::fromStdString(each));
    groups_->setCurrentIndex(-1);
  }
  setVisible(!groups.empty());
  choose(before);
}

void GroupChooser::choose(const std::optional<std::string>& group) {
  const QSignalBlocker silent(groups_);
  groups_->setCurrentIndex(group ? groups_->findText(QString::fromStdString(*group)) : -1);
}

std::optional<std::string> GroupChooser::group() const {
  if (groups_->currentIndex() < 0) return {};
  return groups_->currentText().toStdString();
}

bool GroupChooser::is_missing() const { return groups_->count() > 0 && !group(); }

}  // namespace asperity

#include "moc_group_chooser.cpp"
