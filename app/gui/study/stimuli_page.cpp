// Reads the stimuli and their pictures, and fills a table with kind, size and resolution.

#include "app/gui/study/stimuli_page.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>
#include <variant>

#include <QtCore/QFileSystemWatcher>
#include <QtGui/QImageReader>
#include <QtGui/QPixmap>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLineEdit>

#include "app/gui/base/study_table.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"
#include "app/gui/scene/body_picture.h"
#include "app/gui/study/copy_stimuli_dialog.h"
#include "app/gui/study/stimulus_actions.h"

namespace asperity {

namespace {

constexpr int kPicture = 72;

QImage image_of(const GreyImage& grey) {
  QImage image(static_cast<int>(grey.columns), static_cast<int>(grey.rows),
               QImage::Format_Grayscale8);
  for (int row = 0; row < image.height(); ++row) {
    uchar* line = image.scanLine(row);
    const float* values = grey.values.data() + static_cast<std::size_t>(row) * grey.columns;
    for (std::size_t column = 0; column < grey.columns; ++column) {
      line[column] = static_cast<uchar>(255.0F * std::clamp(values[column], 0.0F, 1.0F) + 0.5F);
    }
  }
  return image;
}

/// Of a file that is no body.
QImage picture_of(const std::filesystem::path& study, const StimulusOverview& stimulus) {
  if (!stimulus.problem.empty() || stimulus.kind == StimulusOverview::Kind::asset ||
      stimulus.kind == StimulusOverview::Kind::rendering) {
    return {};
  }
  if (stimulus.kind == StimulusOverview::Kind::height_field) return image_of(stimulus.relief);
  QImageReader reader(QString::fromStdString((study / stimulus.path).string()));
  reader.setScaledSize(reader.size().scaled(2 * kPicture, 2 * kPicture, Qt::KeepAspectRatio));
  return reader.read();
}

std::vector<StimuliPage::Shown> stimuli_of(const std::filesystem::path& study,
                                           const ModelRegistry& models,
                                           const std::stop_token& stop) {
  std::map<std::size_t, QImage> bodies{};
  const auto see = [&bodies](std::size_t place, const std::shared_ptr<const TexturedMesh>& body) {
    bodies[place] = picture_of_body(body, 2 * kPicture);
  };
  std::vector<StimuliPage::Shown> shown{};
  for (StimulusOverview& stimulus : stimulus_overviews(study, models, 2 * kPicture, stop, see)) {
    const auto body = bodies.find(shown.size());
    QImage picture = body != bodies.end() ? body->second : picture_of(study, stimulus);
    shown.push_back({std::move(stimulus), std::move(picture)});
  }
  return shown;
}

bool is_body(const StimulusOverview& stimulus) {
  return stimulus.kind == StimulusOverview::Kind::textured_mesh ||
         stimulus.kind == StimulusOverview::Kind::shape;
}

QString shape_name(const Shape& shape) {
  struct Name {
    QString operator()(const PlateShape&) const { return StimuliPage::tr("plate"); }
    QString operator()(const BoxShape&) const { return StimuliPage::tr("box"); }
    QString operator()(const CylinderShape&) const { return StimuliPage::tr("cylinder"); }
    QString operator()(const SphereShape&) const { return StimuliPage::tr("ball"); }
  };
  return std::visit(Name{}, shape);
}

QString kind_of(const StimulusOverview& stimulus) {
  using Kind = StimulusOverview::Kind;
  const QString triangles = QString::number(stimulus.triangles);
  switch (stimulus.kind) {
    case Kind::picture:
      break;
    case Kind::height_field:
      return StimuliPage::tr("height field (%1)").arg(QString::fromStdString(stimulus.made_from));
    case Kind::textured_mesh:
      return StimuliPage::tr("mesh of %1 triangles").arg(triangles);
    case Kind::shape:
      return StimuliPage::tr("%1 of %2 triangles").arg(shape_name(*stimulus.shape), triangles);
    case Kind::asset:
      return StimuliPage::tr("data file");
    case Kind::rendering:
      return StimuliPage::tr("rendering (%1)").arg(QString::fromStdString(stimulus.model));
  }
  return StimuliPage::tr("picture");
}

/// "100 × 60", or "100 × 60 × 10" of a body.
QStandardItem* size_cell(const StimulusOverview& stimulus) {
  const auto millimetres = [](double size_m) { return shown_number(1e3 * size_m, 'g', 3); };
  if (is_body(stimulus)) {
    const glm::dvec3& size_m = stimulus.size_m;
    return number_cell(
        StimuliPage::tr("%1 × %2 × %3")
            .arg(millimetres(size_m.x), millimetres(size_m.y), millimetres(size_m.z)),
        size_m.x * size_m.y);
  }
  if (stimulus.kind != StimulusOverview::Kind::height_field) return empty_number_cell();
  return number_cell(StimuliPage::tr("%1 × %2").arg(shown_number(1e3 * stimulus.width_m, 'g', 4),
                                                    shown_number(1e3 * stimulus.length_m, 'g', 4)),
                     stimulus.width_m * stimulus.length_m);
}

QStandardItem* pixels_cell(const StimulusOverview& stimulus) {
  if (stimulus.columns == 0) return empty_number_cell();
  return number_cell(StimuliPage::tr("%1 × %2").arg(stimulus.columns).arg(stimulus.rows),
                     static_cast<double>(stimulus.columns * stimulus.rows));
}

QStandardItem* maybe_number_cell(bool there, double value, int decimals) {
  return there ? number_cell(shown_number(value, 'f', decimals), value) : empty_number_cell();
}

}  // namespace

StimuliPage::StimuliPage(OpenStudy& study, QWidget* parent)
    : StudyPage(study, tr("Stimuli"), parent) {
  setObjectName("stimuli_page");
  filter_ = new QLineEdit(this);
  filter_->setObjectName("stimuli_filter");
  filter_->setAccessibleName(tr("Filter"));
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setClearButtonEnabled(true);
  filter_->setFixedWidth(280);
  head().addWidget(filter_);
  auto* empty = new EmptyState(
      tr("No stimuli yet"),
      tr("Stimuli are pictures, height fields and textured meshes in the study's folder “stimuli”, "
         "and the bodies of its protocols. Make one from a photograph on the Workbench page, "
         "compute "
         "one, or copy files into the folder: they appear here at once."),
      this);
  QPushButton* first = empty->add_action(tr("Compute a texture…"), ButtonRole::plain,
                                         [this] { emit generate_wanted(); });
  QPushButton* second = empty->add_action(tr("Copy from another study…"), ButtonRole::plain,
                                          [this] { copy_from_study(); });
  set_empty_state(empty);
  auto* made = new WrappingRow(nullptr, kGrid);
  QPushButton* generate = make_button(tr("Compute a texture…"), ButtonRole::plain, this);
  generate->setObjectName("stimuli_generate");
  generate->setToolTip(tr("A grating, noise, cones or another surface with known heights"));
  QPushButton* copy = make_button(tr("Copy from another study…"), ButtonRole::plain, this);
  copy->setObjectName("stimuli_copy");
  for (QPushButton* const button : {generate, copy}) made->addWidget(button);
  for (QPushButton* const button : {first, second, generate, copy}) {
    button->setEnabled(study.can_be_written());
  }
  body().addLayout(made);
  connect(generate, &QPushButton::clicked, this, &StimuliPage::generate_wanted);
  connect(copy, &QPushButton::clicked, this, &StimuliPage::copy_from_study);

  using Align = StudyTable::Align;
  table_ = new StudyTable({{tr("Name"), 208, Align::text},
                           {tr("Kind"), 184, Align::text},
                           {tr("Size, mm"), 112, Align::number},
                           {tr("Pixels"), 104, Align::number},
                           {tr("Pitch, µm"), 96, Align::number},
                           {tr("RMS, µm"), 96, Align::number},
                           {tr("Used by"), 0, Align::text}},
                          this);
  table_->setObjectName("stimuli_table");
  table_->setAccessibleName(tr("Stimuli"));
  // Size and pitch give the pixels; the workbench has the RMS.
  table_->leave_out_when_tight({3, 5});
  table_->wrap_texts();
  table_->setIconSize({kPicture, kPicture});
  table_->verticalHeader()->setMinimumSectionSize(kPicture + kGrid);
  body().addWidget(table_, 1);
  actions_ = new StimulusActions(study, this);
  body().addWidget(actions_);
  connect(table_, &StudyTable::row_selected, this, &StimuliPage::show_selected);
  connect(actions_, &StimulusActions::open_wanted, this, &StimuliPage::open_wanted);
  connect(actions_, &StimulusActions::use_wanted, this, &StimuliPage::use_wanted);
  connect(actions_, &StimulusActions::changed, this, [this](const QString& path) {
    banner().hide();
    select_next_ = path;
    this->study().announce_change();
  });
  connect(actions_, &StimulusActions::asked, &banner(), &Banner::hide);
  connect(actions_, &StimulusActions::refused, this,
          [this](const QString& why) { banner().show_news(State::look, why); });
  connect(filter_, &QLineEdit::textChanged, table_, &StudyTable::set_filter);

  const std::filesystem::path& folder = study.folder();
  watcher_ = new QFileSystemWatcher({QString::fromStdString((folder / "stimuli").string())}, this);
  connect(watcher_, &QFileSystemWatcher::directoryChanged, this, &StimuliPage::refresh);
  read_with<int>(
      Need::always,
      [&models = study.models()](const Study& own, const std::stop_token&) {
        return count_stimuli(own.folder(), models);
      },
      [this](const int& count) { emit counted(QString::number(count)); });
  read_with<std::vector<Shown>>(
      Need::when_shown,
      [&models = study.models()](const Study& own, const std::stop_token& stop) {
        return stimuli_of(own.folder(), models, stop);
      },
      [this](const std::vector<Shown>& stimuli) { show_stimuli(stimuli); });
}

void StimuliPage::copy_from_study() {
  auto* dialog = new CopyStimuliDialog(study(), this);
  connect(dialog, &CopyStimuliDialog::copied, this, [this](int stimuli) {
    banner().show_news(State::fine, tr("%n stimuli were copied.", nullptr, stimuli));
    study().announce_change();
  });
  dialog->open();
}

void StimuliPage::select_later(const QString& path) { select_next_ = path; }

void StimuliPage::show_selected() {
  const QString key = table_->selected_key();
  const auto found = std::find_if(stimuli_.begin(), stimuli_.end(), [&key](const Shown& shown) {
    return text(shown.stimulus.path) == key;
  });
  actions_->set_stimulus(found == stimuli_.end() ? nullptr : &found->stimulus);
}

void StimuliPage::show_stimuli(std::vector<Shown> stimuli) {
  stimuli_ = std::move(stimuli);
  std::vector<StudyTable::Row> rows{};
  for (const auto& [stimulus, picture] : stimuli_) {
    const QString path = QString::fromStdString(stimulus.path);
    // A shape has no file; its protocol stands under "Used by".
    QStandardItem* name = text_cell(path.mid(path.indexOf('/') + 1));
    if (!picture.isNull()) name->setIcon(QIcon(QPixmap::fromImage(picture)));
    QStandardItem* kind = text_cell(kind_of(stimulus));
    if (!stimulus.source_name.empty()) {
      kind->setToolTip(tr("Made from %1.").arg(QString::fromStdString(stimulus.source_name)));
    }
    if (!stimulus.problem.empty()) {
      kind = text_cell(tr("▲ %1").arg(words_of(stimulus.problem)));
      kind->setForeground(theme().look);
    }
    const RenderingRemarks& remarks = stimulus.remarks;
    const std::vector<Phrase>& sentences =
        remarks.problems.empty() ? remarks.warnings : remarks.problems;
    if (!sentences.empty()) {
      kind->setText(tr("▲ %1").arg(words_of(sentences.front())));
      kind->setForeground(theme().look);
    }
    QStringList users{};
    for (const std::string& user : stimulus.used_by) users.append(QString::fromStdString(user));
    const bool is_relief =
        stimulus.kind == StimulusOverview::Kind::height_field && stimulus.problem.empty();
    rows.push_back(
        {path,
         {name, kind, stimulus.problem.empty() ? size_cell(stimulus) : empty_number_cell(),
          pixels_cell(stimulus), maybe_number_cell(is_relief, 1e6 * stimulus.pitch_m, 1),
          maybe_number_cell(is_relief, 1e6 * stimulus.rms_m, 1),
          text_cell(users.isEmpty() ? tr("no protocol") : users.join(", "))}});
  }
  table_->fill(rows);
  if (!select_next_.isEmpty()) table_->select(select_next_);
  if (table_->selected_key() == select_next_) select_next_.clear();  // otherwise listed later
  show_selected();
  show_empty(stimuli_.empty());
}

}  // namespace asperity

#include "moc_stimuli_page.cpp"
