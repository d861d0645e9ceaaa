// Compares the files of both studies in the background, and copies the chosen ones.

#include "app/gui/study/copy_stimuli_dialog.h"

#include <initializer_list>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>

#include "app/gui/base/command_lines.h"
#include "app/gui/base/open_study.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/dialog_buttons.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

constexpr QSize kCopySize{640, 520};
constexpr int kFiles = Qt::UserRole + 1;

}  // namespace

CopyStimuliDialog::CopyStimuliDialog(OpenStudy& study, QWidget* parent)
    : QDialog(parent), study_(study) {
  setObjectName("copy_stimuli_dialog");
  setWindowTitle(tr("Copy stimuli from another study"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(parent == nullptr ? kCopySize : kCopySize.boundedTo(parent->window()->size()));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  layout->addWidget(make_heading(tr("Copy stimuli from another study"), this));
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  folder_ = make_text(tr("No study chosen yet."), this, true);
  folder_->setObjectName("copy_folder");
  choose_ = make_button(tr("Choose a study…"), ButtonRole::plain, this);
  choose_->setObjectName("copy_choose");
  row->addWidget(folder_, 1);
  row->addWidget(choose_);
  layout->addLayout(row);
  list_ = new QListWidget(this);
  list_->setObjectName("copy_list");
  list_->setAccessibleName(tr("Stimuli of the other study"));
  layout->addWidget(list_, 1);
  state_ = new StateLabel(this);
  state_->setObjectName("copy_state");
  state_->setWordWrap(true);
  layout->addWidget(state_);
  copy_ = make_button(tr("Copy"), ButtonRole::primary, this);
  copy_->setObjectName("copy_copy");
  commands_ = make_commands_button([this] { return commands(); }, this);
  add_dialog_buttons(*this, *layout, copy_, {commands_});
  connect(choose_, &QPushButton::clicked, this, &CopyStimuliDialog::choose_study);
  connect(list_, &QListWidget::itemChanged, this, &CopyStimuliDialog::show_whether_chosen);
  connect(copy_, &QPushButton::clicked, this, &CopyStimuliDialog::copy);
  show_whether_chosen();
}

void CopyStimuliDialog::choose_study() {
  auto* chooser = new QFileDialog(this, tr("Choose the folder of a study"),
                                  path_text(study_.folder().parent_path()));
  chooser->setObjectName("copy_chooser");
  chooser->setAttribute(Qt::WA_DeleteOnClose);
  chooser->setFileMode(QFileDialog::Directory);
  chooser->setOption(QFileDialog::ShowDirsOnly);
  connect(chooser, &QFileDialog::fileSelected, this,
          [this](const QString& folder) { show_study(folder.toStdString()); });
  chooser->open();
}

void CopyStimuliDialog::show_study(const std::filesystem::path& other) {
  other_ = other;
  folder_->setText(text_of_path(other));
  list_->clear();
  for (QPushButton* const button : {commands_, copy_}) button->setEnabled(false);
  state_->set_state(State::unknown, tr("Comparing the files…"));
  task_.run<std::vector<ForeignStimulus>>(
      [other, folder = study_.folder()](const std::stop_token&, const BackgroundTask::Progress&) {
        return foreign_stimuli(folder, other);
      },
      [this](const std::vector<ForeignStimulus>& stimuli) { show_stimuli(stimuli); },
      [this](const QString& what) { state_->set_state(State::stop, what); });
}

void CopyStimuliDialog::show_stimuli(const std::vector<ForeignStimulus>& stimuli) {
  using Kept = ForeignStimulus::State;
  for (const ForeignStimulus& stimulus : stimuli) {
    const QString name = text(stimulus.path).section('/', -1);
    auto* item = new QListWidgetItem(list_);
    item->setData(Qt::UserRole, text(stimulus.path));
    QStringList files{};
    for (const std::string& file : stimulus.files) files << text(file).section('/', -1);
    item->setData(kFiles, files);
    switch (stimulus.state) {
      case Kept::can_be_copied:
        item->setText(name);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(Qt::Unchecked);
        break;
      case Kept::is_there:
        item->setText(tr("%1 (this study has the same file)").arg(name));
        item->setFlags(Qt::NoItemFlags);
        break;
      case Kept::name_is_taken:
        item->setText(tr("%1 (this study has another file of this name)").arg(name));
        item->setFlags(Qt::NoItemFlags);
        break;
    }
  }
  show_whether_chosen();
}

std::vector<std::string> CopyStimuliDialog::chosen() const {
  std::vector<std::string> paths{};
  for (int i = 0; i < list_->count(); ++i) {
    const QListWidgetItem& item = *list_->item(i);
    if (item.checkState() == Qt::Checked) {
      paths.push_back(item.data(Qt::UserRole).toString().toStdString());
    }
  }
  return paths;
}

void CopyStimuliDialog::show_whether_chosen() {
  QStringList files{};
  for (int i = 0; i < list_->count(); ++i) {
    const QListWidgetItem& item = *list_->item(i);
    if (item.checkState() == Qt::Checked) files << item.data(kFiles).toStringList();
  }
  files.removeDuplicates();
  for (QPushButton* const button : {commands_, copy_}) button->setEnabled(!files.isEmpty());
  if (!files.isEmpty()) {
    state_->set_state(State::fine,
                      tr("Files to copy: %1. No file is replaced.").arg(files.join(", ")));
  } else if (other_.empty()) {
    state_->set_state(State::unknown, tr("Choose a study."));
  } else {
    state_->set_state(State::unknown, list_->count() == 0 ? tr("This study has no stimuli.")
                                                          : tr("Tick the stimuli to copy."));
  }
}

void CopyStimuliDialog::reject() {
  if (is_copying_) return task_.cancel();
  QDialog::reject();
}

void CopyStimuliDialog::set_copying(bool is_copying) {
  is_copying_ = is_copying;
  for (QWidget* const part : std::initializer_list<QWidget*>{choose_, list_, copy_}) {
    part->setEnabled(!is_copying);
  }
}

std::vector<ShownCommand> CopyStimuliDialog::commands() const {
  std::vector<std::filesystem::path> files{};
  for (const std::string& path : chosen()) files.push_back(other_ / path);
  return {{.action = copy_->text(), .line = copy_stimuli_line(files, study_.folder())}};
}

void CopyStimuliDialog::copy() {
  set_copying(true);
  task_.run<int>(
      [paths = chosen(), other = other_, folder = study_.folder()](
          const std::stop_token& stop, const BackgroundTask::Progress&) {
        return copy_stimuli(folder, other, paths, stop);
      },
      [this](int count) {
        set_copying(false);
        emit copied(count);
        accept();
      },
      [this](const QString& what) {
        set_copying(false);
        state_->set_state(State::stop, what);
      });
}

}  // namespace asperity

#include "moc_copy_stimuli_dialog.cpp"
