// Computes the surface of the newest values in the background, and saves it with its provenance.

#include "app/gui/workbench/surface_dialog.h"

#include <utility>

#include <QtGui/QPixmap>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QStackedWidget>

#include "app/gui/base/command_lines.h"
#include "app/gui/base/open_study.h"
#include "app/gui/base/parameter_words.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/workbench/parameter_form.h"
#include "app/gui/workbench/relief_picture.h"
#include "app/gui/workbench/save_panel.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/stimulus_names.h"
#include "stimuli/heights/synthetic_surface.h"

namespace asperity {

namespace {

constexpr QSize kSurfaceSize{960, 640};
constexpr QSize kSurfacePicture{400, 300};
constexpr std::size_t kSurfaceMeshSide = 256;

QString millimetres(double length_m) { return shown_number(1e3 * length_m, 'g', 6); }

QString text_of_parts(const SurfaceSeam& seam) {
  switch (seam.part) {
    case RegularPart::spacing:
      break;
    case RegularPart::spacing_at_angle:
      return SurfaceDialog::tr("%1 mm along %2 contain %3 spacings, of %4 mm at this angle.");
    case RegularPart::brick:
      return SurfaceDialog::tr("%1 mm along %2 contain %3 bricks of %4 mm.");
    case RegularPart::pair_of_courses:
      return SurfaceDialog::tr("%1 mm along %2 contain %3 pairs of courses of %4 mm.");
  }
  return SurfaceDialog::tr("%1 mm along %2 contain %3 spacings of %4 mm.");
}

QString words_of(const SurfaceSeam& seam) {
  const QString widths =
      seam.narrower_m
          ? SurfaceDialog::tr("Choose a width of %1 mm or %2 mm.")
                .arg(millimetres(*seam.narrower_m), millimetres(seam.wider_m))
          : SurfaceDialog::tr("Choose a width of %1 mm.").arg(millimetres(seam.wider_m));
  return text_of_parts(seam).arg(millimetres(seam.width_m), QString(QChar(seam.axis)),
                                 shown_number(seam.count, 'g', 4), millimetres(seam.part_m)) +
         ' ' +
         SurfaceDialog::tr(
             "Where the surface is repeated, the last one is cut, which makes an "
             "unintended step.") +
         ' ' + widths;
}

QString words_of(const CoarseSamples& coarse) {
  return SurfaceDialog::tr(
             "The samples are %1 mm apart, %2 per spacing of %3 mm: heights and shape differ from "
             "those requested. Choose at least %4 samples per side.")
      .arg(millimetres(coarse.pitch_m), shown_number(coarse.samples, 'g', 2),
           millimetres(coarse.spacing_m), shown_number(coarse.pixels, 'f', 0));
}

}  // namespace

struct SurfaceDialog::Preview {
  std::shared_ptr<const HeightField> field{};
  QImage picture{};
  double exaggeration = 1.0;
  QStringList warnings{};
};

SurfaceDialog::SurfaceDialog(OpenStudy& study, QWidget* parent)
    : QDialog(parent), study_(study), surfaces_(synthetic_surfaces()) {
  setObjectName("surface_dialog");
  setWindowTitle(tr("Compute a texture"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(parent == nullptr ? kSurfaceSize : kSurfaceSize.boundedTo(parent->window()->size()));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  layout->addWidget(make_heading(tr("Compute a texture with known heights"), this));
  auto* columns = new QHBoxLayout();
  columns->setSpacing(kGroupGap);
  columns->addWidget(make_forms(), 1);
  columns->addWidget(make_picture());
  layout->addLayout(columns, 1);
  state_ = new StateLabel(this);
  state_->setObjectName("surface_state");
  state_->setWordWrap(true);
  layout->addWidget(state_);
  auto* buttons = new QHBoxLayout();
  buttons->setSpacing(kGrid);
  QLabel* caption = make_text(tr("Name in the study"), this);
  name_ = new QLineEdit(this);
  name_->setObjectName("surface_name");
  caption->setBuddy(name_);
  caption->setWordWrap(false);
  QPushButton* shown_commands = make_commands_button([this] { return commands(); }, this);
  QPushButton* cancel = make_button(tr("Cancel"), ButtonRole::plain, this);
  save_ = make_button(tr("Save to study"), ButtonRole::primary, this);
  save_->setObjectName("surface_save");
  buttons->addWidget(caption);
  buttons->addWidget(name_, 1);
  buttons->addWidget(shown_commands);
  buttons->addWidget(cancel);
  buttons->addWidget(save_);
  layout->addLayout(buttons);
  connect(kind_, &QComboBox::currentIndexChanged, this, &SurfaceDialog::choose_kind);
  connect(name_, &QLineEdit::textChanged, this, &SurfaceDialog::check);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(save_, &QPushButton::clicked, this, &SurfaceDialog::save);
  // Return ends the typing of a value.
  for (QPushButton* const button : findChildren<QPushButton*>()) button->setAutoDefault(false);
  choose_kind();
}

QWidget* SurfaceDialog::make_forms() {
  auto* side = new QWidget(this);
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  kind_ = new ChoiceBox(side);
  kind_->setObjectName("surface_kind");
  kind_->setAccessibleName(tr("Kind of surface"));
  layout->addWidget(kind_);
  summary_ = make_text({}, side, true);
  layout->addWidget(summary_);
  auto* inside = new QWidget(side);
  auto* forms = new QVBoxLayout(inside);
  forms->setContentsMargins(0, 0, kGrid, 0);
  forms->setSpacing(kGrid);
  parameters_ = new QStackedWidget(inside);
  for (const SurfaceDeclaration& surface : surfaces_) {
    kind_->addItem(surface_name(surface.kind));
    auto* form = new ParameterForm(surface.parameters, FormStyle::fields, parameters_);
    form->setObjectName("surface_" + text(surface.kind));
    connect(form, &ParameterForm::edited, this, &SurfaceDialog::compute);
    parameters_->addWidget(form);
    forms_.push_back(form);
  }
  forms->addWidget(parameters_);
  canvas_ = new ParameterForm(canvas_parameters(), FormStyle::fields, inside);
  canvas_->setObjectName("surface_canvas");
  connect(canvas_, &ParameterForm::edited, this, &SurfaceDialog::compute);
  forms->addWidget(canvas_);
  forms->addStretch(1);
  auto* scroll = new QScrollArea(side);
  scroll->setAccessibleName(tr("Parameters"));
  scroll->setWidget(inside);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFrameShape(QFrame::NoFrame);
  layout->addWidget(scroll, 1);
  return side;
}

QWidget* SurfaceDialog::make_picture() {
  auto* side = new QWidget(this);
  side->setFixedWidth(kSurfacePicture.width());
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  picture_ = new QLabel(side);
  picture_->setObjectName("surface_picture");
  picture_->setAccessibleName(tr("Preview"));
  picture_->setFixedHeight(kSurfacePicture.height());
  facts_ = make_text({}, side, true);
  facts_->setObjectName("surface_facts");
  warnings_ = make_text({}, side);
  warnings_->setObjectName("surface_warnings");
  layout->addWidget(picture_);
  layout->addWidget(facts_);
  layout->addWidget(warnings_);
  layout->addStretch(1);
  return side;
}

std::string SurfaceDialog::kind() const {
  return surfaces_[static_cast<std::size_t>(kind_->currentIndex())].kind;
}

ParameterValues SurfaceDialog::given() const {
  return forms_[static_cast<std::size_t>(kind_->currentIndex())]->given();
}

SurfaceCanvas SurfaceDialog::canvas() const { return canvas_with(canvas_->values()); }

std::string SurfaceDialog::path() const {
  return "stimuli/" + name_->text().toStdString() + ".png";
}

void SurfaceDialog::choose_kind() {
  const int index = kind_->currentIndex();
  parameters_->setCurrentIndex(index);
  // A stack is as high as its highest page otherwise.
  for (int i = 0; i < parameters_->count(); ++i) {
    parameters_->widget(i)->setSizePolicy(
        QSizePolicy::Preferred, i == index ? QSizePolicy::Preferred : QSizePolicy::Ignored);
  }
  summary_->setText(asperity::words_of(surfaces_[static_cast<std::size_t>(index)].summary));
  name_->setText(proposed_name(kind(), study_.folder() / "stimuli"));
  compute();
}

void SurfaceDialog::compute() {
  field_.reset();
  refusal_.clear();
  check();
  work_.ask(
      [this, kind = kind(), given = given(), canvas = canvas(),
       ratio = devicePixelRatioF()]() -> NewestWork::Delivery {
        auto preview = std::make_shared<Preview>();
        preview->field = std::make_shared<const HeightField>(make_surface(kind, given, canvas));
        const ReliefMesh mesh = relief_mesh(*preview->field, kSurfaceMeshSide);
        preview->exaggeration = mesh.exaggeration;
        preview->picture = draw_relief(mesh, ReliefLook{}, kSurfacePicture * ratio);
        preview->picture.setDevicePixelRatio(ratio);
        const auto warn = [&warnings = preview->warnings](const auto& warning) {
          if (warning) warnings << "▲ " + words_of(*warning);
        };
        warn(seam_of(kind, given, canvas));
        warn(coarse_samples_of(kind, given, canvas));
        return [this, preview] { take(*preview); };
      },
      [this](const QString& what) {
        refusal_ = what;
        picture_->clear();
        facts_->clear();
        warnings_->clear();
        check();
      });
}

void SurfaceDialog::take(const Preview& preview) {
  if (!work_.is_busy()) field_ = preview.field;  // otherwise newer values are being computed
  picture_->setPixmap(QPixmap::fromImage(preview.picture));
  facts_->setText(facts_of(*preview.field) + '\n' +
                  (preview.exaggeration > 1.0
                       ? tr("Heights are exaggerated by a factor of %1.").arg(preview.exaggeration)
                       : tr("Heights are drawn to scale.")));
  warnings_->setText(preview.warnings.join('\n'));
  check();
}

void SurfaceDialog::check() {
  const QString name = name_->text();
  const auto is_taken = [this](const std::string& file) {
    std::error_code unknown{};
    return std::filesystem::exists(study_.folder() / file, unknown);
  };
  QString problem = refusal_;
  State state = State::stop;
  if (!problem.isEmpty()) {
  } else if (name.isEmpty()) {
    problem = tr("Enter a name for the texture.");
  } else if (!is_stimulus_name(name.toStdString())) {
    problem = tr("Use at most %1 unaccented letters, digits, _ and -.").arg(kLongestStimulusName);
  } else if (is_taken(path()) || is_taken(path() + ".json")) {
    problem = tr("The study already has a stimulus “%1”. Choose another name.").arg(name);
  } else if (saving_.is_running() || field_ == nullptr) {
    state = State::unknown;
    problem = saving_.is_running() ? tr("Saving …") : tr("Computing…");
  }
  save_->setEnabled(problem.isEmpty());
  if (problem.isEmpty()) {
    state_->set_state(State::fine, tr("Will be saved as %1, with its sidecar.").arg(text(path())));
  } else {
    state_->set_state(state, problem);
  }
}

std::vector<ShownCommand> SurfaceDialog::commands() const {
  return {{.action = tr("Compute the texture"),
           .line = synth_line(kind(), given(), canvas(), study_.folder() / path())}};
}

void SurfaceDialog::save() {
  if (!save_->isEnabled()) return;
  saving_.run<bool>(
      [field = field_, kind = kind(), given = given(), seed = canvas().seed,
       png = study_.folder() / path()](const std::stop_token&, const BackgroundTask::Progress&) {
        std::filesystem::create_directories(png.parent_path());
        refuse_existing({png, sidecar_of(png)}, Overwrite::refuse);
        save_height_field(png, *field, {kind, given, seed, "", "", ""}, Overwrite::refuse);
        return true;
      },
      [this](bool) {
        emit saved(text(path()));
        accept();
      },
      [this](const QString& what) {
        refusal_ = what;
        check();
        refusal_.clear();
      });
  check();
}

}  // namespace asperity

#include "moc_surface_dialog.cpp"
