// Computes the whole texture in a background task, and writes it with its photograph under the chosen name.

#include "app/gui/workbench/save_panel.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <utility>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLineEdit>

#include "app/findings/outcome/display_number.h"
#include "app/gui/base/command_lines.h"
#include "app/gui/base/open_study.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/task_line.h"
#include "app/gui/look/words.h"
#include "app/study_files/stimulus_names.h"

namespace asperity {

namespace {

constexpr int kLongestName = 40;
constexpr const char* kPhotoEnding = "_photo";

struct StimulusFiles {
  StimulusFiles(const std::filesystem::path& folder, const std::string& name)
      : png(folder / (name + ".png")), photo(photograph_of(png)) {}

  std::vector<std::filesystem::path> all() const { return {png, sidecar_of(png), photo}; }
  bool any_exists() const {
    const auto files = all();
    return std::any_of(files.begin(), files.end(), [](const std::filesystem::path& file) {
      std::error_code error{};
      return std::filesystem::exists(file, error);
    });
  }

  std::filesystem::path png{};
  std::filesystem::path photo{};
};

/// Errors: as texture_from_photograph, and a sentence for people where the memory does not suffice.
PhotographTexture whole_texture(const GreyImage& grey, const TextureRecipe& recipe,
                                const std::string& name) {
  try {
    return texture_from_photograph(grey, recipe, name);
  } catch (const std::bad_alloc&) {
    throw std::runtime_error(
        SavePanel::tr("The photograph does not fit into the memory of this computer as a whole; "
                      "scale it down and open it again")
            .toStdString());
  }
}

QString in_micrometres(double height_m) {
  const double height_um = height_m * 1e6;
  return shown_number(height_um, 'f', decimals_of_height(height_um, 0));
}

}  // namespace

QString proposed_name(const std::filesystem::path& file, const std::filesystem::path& stimuli) {
  // Letters with accents become letters and accents, of which the letters stay.
  const QString own = QString::fromStdString(file.stem().string())
                          .normalized(QString::NormalizationForm_KD)
                          .toLower();
  QString name{};
  for (const QChar letter : own) {
    if (letter.isMark()) continue;
    if (letter != '_' && is_stimulus_name(QString(letter).toStdString())) {
      name += letter;
    } else if (!name.isEmpty() && !name.endsWith('_')) {
      name += '_';
    }
  }
  name.truncate(kLongestName);
  while (name.endsWith('_') || name.endsWith(kPhotoEnding)) name.truncate(name.lastIndexOf('_'));
  if (name.isEmpty()) name = "relief";
  QString free = name;
  for (int k = 2; StimulusFiles(stimuli, free.toStdString()).any_exists(); ++k) {
    free = QString("%1_%2").arg(name).arg(k);
  }
  return free;
}

QString facts_of(const HeightField& field) {
  return SavePanel::tr("%1 × %2 mm, %3 µm from the lowest to the highest point, RMS %4 µm")
      .arg(shown_number(field.width_m() * 1e3, 'f', 0))
      .arg(shown_number(field.length_m() * 1e3, 'f', 0))
      .arg(in_micrometres(field.maximum_m() - field.minimum_m()), in_micrometres(field.rms_m()));
}

SavePanel::SavePanel(OpenStudy& study, Banner& banner, std::function<TextureRecipe()> recipe,
                     std::function<QString()> unready, QWidget* parent)
    : QFrame(parent),
      study_(study),
      banner_(banner),
      recipe_(std::move(recipe)),
      unready_(std::move(unready)) {
  setProperty("role", "card");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  layout->setSpacing(kGrid);
  facts_ = make_text({}, this, true);
  facts_->setObjectName("facts");
  facts_->setFont(text_font(TextSize::small));
  layout->addWidget(facts_);
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  name_ = new QLineEdit(this);
  name_->setObjectName("name");
  name_->setPlaceholderText(tr("Name in the study"));
  name_->setAccessibleName(tr("Name in the study"));
  save_ = make_button(tr("Save to study"), ButtonRole::primary, this);
  save_->setObjectName("save");
  row->addWidget(name_, 1);
  row->addWidget(save_);
  layout->addLayout(row);
  commands_ = make_commands_button([this] { return commands(); }, this);
  name_problem_ = make_text({}, this, true);
  name_problem_->setObjectName("name_problem");
  name_problem_->setFont(text_font(TextSize::small));
  layout->addWidget(name_problem_);
  layout->addWidget(commands_, 0, Qt::AlignLeft);
  line_ = new TaskLine(saving_, this);
  line_->setObjectName("saving");
  line_->set_words(tr("Saving…"));
  layout->addWidget(line_);
  connect(name_, &QLineEdit::textChanged, this, &SavePanel::check);
  connect(name_, &QLineEdit::returnPressed, save_, &QPushButton::click);
  connect(save_, &QPushButton::clicked, this, [this] { save(Overwrite::refuse); });
  connect(line_, &TaskLine::cancelWanted, &saving_, &BackgroundTask::cancel);
  connect(&saving_, &BackgroundTask::finished, this, &SavePanel::check);
}

void SavePanel::show_opened(std::shared_ptr<const OpenedPicture> opened) {
  opened_ = std::move(opened);
  name_->setText(opened_->is_photograph()
                     ? proposed_name(opened_->file, study_.folder() / "stimuli")
                     : QString::fromStdString(opened_->file.stem().string()));
  name_->setCursorPosition(0);  // a long name is read from its beginning
  check();
}

void SavePanel::show_facts(const HeightField& field) { facts_->setText(facts_of(field)); }

void SavePanel::check() {
  QString problem{};
  QString advice = tr("The relief will be saved in stimuli/ with its sidecar and its photograph.");
  const QString name = name_->text();
  if (opened_ == nullptr || !opened_->is_photograph()) {
    problem =
        tr("A relief from a file is already saved; open a photograph to make another relief.");
  } else if (!study_.can_be_written()) {
    problem = tr("This study is read-only; copy it to a folder that you may write to.");
  } else if (const QString reason = unready_(); !reason.isEmpty()) {
    problem = reason;
  } else if (name.isEmpty()) {
    problem = tr("Enter a name for the relief.");
  } else if (!is_stimulus_name(name.toStdString())) {
    problem = tr("Use at most %1 unaccented letters, digits, _ and -.").arg(kLongestStimulusName);
  } else if (name.endsWith(kPhotoEnding)) {
    problem =
        tr("Names ending in _photo are reserved for the photographs stored with the reliefs; "
           "choose another name.");
  } else if (saving_.is_running()) {
    problem = tr("Saving …");
  } else if (StimulusFiles(study_.folder() / "stimuli", name.toStdString()).any_exists()) {
    advice = tr("The study has a stimulus of this name; you will be asked before it is replaced.");
  }
  for (QPushButton* const button : {save_, commands_}) button->setEnabled(problem.isEmpty());
  name_problem_->setText(problem.isEmpty() ? advice : problem);
}

std::vector<ShownCommand> SavePanel::commands() const {
  const StimulusFiles files(study_.folder() / "stimuli", name_->text().toStdString());
  return {{.action = save_->text(),
           .line = texture_line(opened_->file, recipe_(), files.png),
           .remark = tr("The photograph is not stored with it.")}};
}

void SavePanel::save(Overwrite overwrite) {
  if (!save_->isEnabled()) return;
  const QString shown = name_->text();
  const std::filesystem::path folder = study_.folder() / "stimuli";
  const StimulusFiles files(folder, shown.toStdString());
  if (overwrite == Overwrite::refuse && files.any_exists()) {
    banner_.show_news(
        State::look,
        tr("The study already has a stimulus “%1”. Protocols that use it would present the new "
           "one; sessions that were run keep the SHA-256 of the old one.")
            .arg(shown),
        tr("Replace “%1”").arg(shown), [this, shown] {
          // Another name may have been typed since.
          save(name_->text() == shown ? Overwrite::allow : Overwrite::refuse);
        });
    return;
  }
  saving_.run<bool>(
      [opened = opened_, recipe = recipe_(), folder, files, overwrite](
          const std::stop_token& stop, const BackgroundTask::Progress& progress) {
        std::filesystem::create_directories(folder);
        refuse_existing({files.png}, overwrite);
        const GreyImage& grey = opened->loaded.photograph.grey;
        const std::string source = opened->file.filename().string();
        const PhotographTexture texture = whole_texture(grey, recipe, source);
        progress(0.6);
        if (stop.stop_requested()) return false;  // from here on it is written whole
        save_height_field(
            files.png, texture.field,
            {"photograph", parameter_values(recipe), {}, source, opened->loaded.sha256, ""},
            overwrite, {{files.photo, photograph_png(*opened)}});
        return true;
      },
      [this, shown, opened = opened_, recipe = recipe_()](bool written) {
        if (!written) {
          banner_.show_news(
              State::look,
              tr("Saving “%1” was cancelled; to keep the relief, save it again.").arg(shown));
          return;
        }
        banner_.show_news(
            State::fine,
            tr("Saved as stimuli/%1.png, with its sidecar and stimuli/%1_photo.png.").arg(shown));
        if (opened == opened_ && parameter_values(recipe) == parameter_values(recipe_())) {
          emit saved(shown);
        }
        study_.announce_change();
      },
      [this](const QString& what) {
        banner_.show_news(State::stop, tr("The relief was not saved: %1").arg(what));
      });
  check();
}

}  // namespace asperity

#include "moc_save_panel.cpp"
