// Adds the SHA-256 of the texture in the background, and writes the files.

#include "app/gui/workbench/rendering_panel.h"

#include <utility>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLineEdit>

#include "analysis/words/phrase.h"
#include "app/gui/base/open_study.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/stimulus_names.h"
#include "app/words/phrase_of_error.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

RenderingPanel::RenderingPanel(OpenStudy& study, Banner& banner, std::function<Compared()> compared,
                               QWidget* parent)
    : QFrame(parent), study_(study), banner_(banner), compared_(std::move(compared)) {
  setProperty("role", "card");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  layout->setSpacing(kGrid);
  name_ = new QLineEdit(this);
  name_->setObjectName("rendering_name");
  name_->setPlaceholderText(tr("Name of the renderings"));
  name_->setAccessibleName(tr("Name of the renderings"));
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  save_ = make_button(tr("Save"), ButtonRole::plain, this);
  save_->setObjectName("rendering_save");
  save_->setToolTip(
      tr("The chosen force models with their values, the texture, stiffness and friction"));
  use_ = make_button(tr("Use in an experiment…"), ButtonRole::primary, this);
  use_->setObjectName("rendering_use");
  use_->setToolTip(
      tr("Saves the renderings, then copies the values of one of them into a protocol"));
  layout->addWidget(name_);
  row->addWidget(save_);
  row->addWidget(use_, 1);
  layout->addLayout(row);
  note_ = make_text({}, this, true);
  note_->setObjectName("rendering_note");
  note_->setFont(text_font(TextSize::small));
  layout->addWidget(note_);
  connect(name_, &QLineEdit::textChanged, this, &RenderingPanel::check);
  connect(save_, &QPushButton::clicked, this, [this] { save(false); });
  connect(use_, &QPushButton::clicked, this, [this] { save(true); });
  connect(&saving_, &BackgroundTask::finished, this, &RenderingPanel::check);
}

void RenderingPanel::show_relief(const std::string& stem) {
  name_->setText(text(stem));
  name_->setCursorPosition(0);
  check();
}

std::string RenderingPanel::name_of(const Rendering& rendering) const {
  return name_->text().toStdString() + '_' + rendering.model;
}

void RenderingPanel::check() {
  const Compared compared = compared_();
  QString problem = compared.problem;
  const QString name = name_->text();
  if (!study_.can_be_written()) {
    problem = tr("This study is read-only; copy it to a folder that you may write to.");
  } else if (problem.isEmpty() && compared.renderings.empty()) {
    problem = compared.left_out.isEmpty() ? tr("Choose a force model.") : compared.left_out;
  } else if (problem.isEmpty() && name.isEmpty()) {
    problem = tr("Enter a name for the renderings.");
  } else if (problem.isEmpty() && !is_stimulus_name(name.toStdString())) {
    problem = tr("Use at most %1 unaccented letters, digits, _ and -.").arg(kLongestStimulusName);
  } else if (problem.isEmpty() && saving_.is_running()) {
    problem = tr("Saving …");
  }
  for (QPushButton* const button : {save_, use_}) button->setEnabled(problem.isEmpty());
  QStringList files{};
  for (const Rendering& rendering : compared.renderings) {
    files << text(name_of(rendering)) + kRenderingEnding;
  }
  note_->setText(
      !problem.isEmpty()
          ? problem
          : (tr("Will be saved in stimuli/ as %1.").arg(files.join(", ")) + ' ' + compared.left_out)
                .trimmed());
}

void RenderingPanel::save(bool then_use) {
  if (saving_.is_running()) return;
  std::vector<std::pair<std::string, Rendering>> named{};
  for (Rendering& rendering : compared_().renderings) {
    const std::string name = name_of(rendering);
    named.emplace_back(name, std::move(rendering));
  }
  if (named.empty()) return;
  saving_.run<QStringList>(
      [named, folder = study_.folder()](const std::stop_token&,
                                        const BackgroundTask::Progress&) mutable {
        const std::string sha256 =
            load_height_field(folder / named.front().second.texture.height_field).sha256;
        QStringList files{};
        std::vector<NewFile> fresh{};
        for (auto& [name, rendering] : named) {
          std::string& felt = rendering.texture.sha256;
          if (!felt.empty() && felt != sha256) {
            throw PhrasedError(phrase("Renderings",
                                      "%1 has changed since it was opened. Open it again, then "
                                      "save the renderings.")
                                   .with(rendering.texture.height_field));
          }
          felt = sha256;
          NewFile file{rendering_file(folder, name), text_of(rendering)};
          files << path_text(file.path);
          if (!holds(file)) fresh.push_back(std::move(file));
        }
        if (!fresh.empty()) write_files_together(fresh, Overwrite::refuse);
        return files;
      },
      [this, then_use](const QStringList& files) {
        QStringList names{};
        for (const QString& file : files) names << file.section('/', -1);
        banner_.show_news(State::fine, tr("Saved in stimuli/: %1.").arg(names.join(", ")));
        study_.announce_change();
        if (then_use) emit use_wanted(files);
      },
      [this](const QString& what) {
        banner_.show_news(State::stop, tr("The renderings were not saved: %1").arg(what));
      });
  check();
}

}  // namespace asperity

#include "moc_rendering_panel.cpp"
