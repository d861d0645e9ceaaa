// Lists the files in rows whose long paths are shortened in the middle.

#include "app/gui/study/plugins_dialog.h"

#include <QtWidgets/QFileDialog>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QStyledItemDelegate>
#include <QtWidgets/QVBoxLayout>

#include "app/gui/look/controls.h"
#include "app/gui/look/dialog_buttons.h"

namespace asperity {

namespace {

/// Rows no wider than the list, so that the view shortens a long path. The name of the file, at its end, remains legible.
class PathRows final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return {0, QStyledItemDelegate::sizeHint(option, index).height()};
  }
};

}  // namespace

PluginsDialog::PluginsDialog(const std::vector<std::filesystem::path>& files, QWidget* parent)
    : QDialog(parent) {
  setObjectName("plugins_dialog");
  setWindowTitle(tr("Plug-ins"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(560);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  layout->addWidget(make_heading(tr("Plug-ins with force models"), this));
  layout->addWidget(make_text(
      tr("A plug-in is a program: it can do everything that you can do on this computer. Add only "
         "plug-ins from a source that you trust. They are checked and loaded when a study is "
         "opened."),
      this, true));
  list_ = new QListWidget(this);
  list_->setObjectName("plugins_list");
  list_->setAccessibleName(tr("Files of the plug-ins"));
  list_->setTextElideMode(Qt::ElideMiddle);
  list_->setItemDelegate(new PathRows(list_));
  connect(list_->model(), &QAbstractItemModel::rowsInserted, list_,
          [this](const QModelIndex&, int first, int last) {
            for (int row = first; row <= last; ++row) {
              list_->item(row)->setToolTip(list_->item(row)->text());
            }
          });
  for (const std::filesystem::path& file : files) {
    list_->addItem(QString::fromStdString(file.string()));
  }
  layout->addWidget(list_);

  QPushButton* add = make_button(tr("Add…"), ButtonRole::plain, this);
  QPushButton* remove = make_button(tr("Remove"), ButtonRole::plain, this);
  remove->setObjectName("plugins_remove");
  QPushButton* load = make_button(tr("Load"), ButtonRole::primary, this);
  load->setObjectName("plugins_load");
  load->setDefault(true);
  add_dialog_buttons(*this, *layout, load, {add, remove});

  connect(add, &QPushButton::clicked, this, &PluginsDialog::add_files);
  remove->setEnabled(false);  // until a plug-in is selected
  connect(list_, &QListWidget::itemSelectionChanged, this,
          [this, remove] { remove->setEnabled(!list_->selectedItems().isEmpty()); });
  connect(remove, &QPushButton::clicked, this, [this] { qDeleteAll(list_->selectedItems()); });
  connect(load, &QPushButton::clicked, this, [this] {
    emit wanted(listed_files());
    accept();
  });
}

void PluginsDialog::add_files() {
  const QStringList chosen =
      QFileDialog::getOpenFileNames(this, tr("Add plug-ins"), {}, tr("Shared libraries (*.so)"));
  for (const QString& file : chosen) list_->addItem(file);
}

std::vector<std::filesystem::path> PluginsDialog::listed_files() const {
  std::vector<std::filesystem::path> files{};
  for (int row = 0; row < list_->count(); ++row) {
    files.emplace_back(list_->item(row)->text().toStdString());
  }
  return files;
}

}  // namespace asperity

#include "moc_plugins_dialog.cpp"
