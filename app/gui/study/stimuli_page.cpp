#include "app/gui/study/stimuli_page.h"

#include <algorithm>

#include <QtCore/QFileSystemWatcher>
#include <QtGui/QImageReader>
#include <QtGui/QPixmap>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLineEdit>

#include "app/gui/study/study_table.h"

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

QImage picture_of(const std::filesystem::path& study, const StimulusOverview& stimulus) {
  if (!stimulus.problem.empty()) return {};
  if (stimulus.is_height_field) return image_of(stimulus.relief);
  QImageReader reader(QString::fromStdString((study / stimulus.path).string()));
  reader.setScaledSize(reader.size().scaled(2 * kPicture, 2 * kPicture, Qt::KeepAspectRatio));
  return reader.read();
}

QStandardItem* maybe_number_cell(bool there, double value, int decimals) {
  return there ? number_cell(QString::number(value, 'f', decimals), value) : empty_number_cell();
}

}  // namespace

StimuliPage::StimuliPage(OpenStudy& study, QWidget* parent)
    : StudyPage(study, tr("Stimuli"), parent) {
  setObjectName("stimuli_page");
  set_empty_state(new EmptyState(
      tr("No stimuli yet"),
      tr("Stimuli are pictures and height fields in the study's folder \"stimuli\". Make one from "
         "a photograph on the page Workbench, or copy files there: they appear here at once."),
      this));
  filter_ = new QLineEdit(this);
  filter_->setObjectName("stimuli_filter");
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setClearButtonEnabled(true);
  filter_->setFixedWidth(280);
  head().addWidget(filter_);

  using Align = StudyTable::Align;
  table_ = new StudyTable({{tr("File"), 208, Align::text},
                           {tr("What it is"), 184, Align::text},
                           {tr("Size, mm"), 112, Align::number},
                           {tr("Pixels"), 104, Align::number},
                           {tr("Pitch, µm"), 96, Align::number},
                           {tr("RMS, µm"), 96, Align::number},
                           {tr("Used by"), 0, Align::text}},
                          this);
  table_->setObjectName("stimuli_table");
  table_->leave_out_when_tight({3});  // size and pitch say as much
  table_->setIconSize({kPicture, kPicture});
  table_->verticalHeader()->setDefaultSectionSize(kPicture + kGrid);
  body().addWidget(table_, 1);
  connect(filter_, &QLineEdit::textChanged, table_, &StudyTable::set_filter);

  const std::filesystem::path& folder = study.folder();
  watcher_ = new QFileSystemWatcher({QString::fromStdString((folder / "stimuli").string())}, this);
  connect(watcher_, &QFileSystemWatcher::directoryChanged, this, &StimuliPage::refresh);
  read_with<int>(
      Need::always,
      [](const Study& own, const std::stop_token&) { return count_stimuli(own.folder()); },
      [this](const int& count) { emit counted(QString::number(count)); });
  read_with<std::vector<Shown>>(
      Need::when_shown,
      [&models = study.models()](const Study& own, const std::stop_token& stop) {
        std::vector<Shown> shown{};
        for (StimulusOverview& stimulus :
             stimulus_overviews(own.folder(), models, 2 * kPicture, stop)) {
          QImage picture = picture_of(own.folder(), stimulus);
          shown.push_back({std::move(stimulus), std::move(picture)});
        }
        return shown;
      },
      [this](const std::vector<Shown>& stimuli) { show_stimuli(stimuli); });
}

void StimuliPage::show_stimuli(const std::vector<Shown>& stimuli) {
  std::vector<StudyTable::Row> rows{};
  for (const auto& [stimulus, picture] : stimuli) {
    const QString path = QString::fromStdString(stimulus.path);
    QStandardItem* name = text_cell(path.mid(path.indexOf('/') + 1));
    if (!picture.isNull()) name->setIcon(QIcon(QPixmap::fromImage(picture)));
    QString what = tr("picture");
    if (stimulus.is_height_field) {
      what = tr("height field (%1)").arg(QString::fromStdString(stimulus.made_from));
    }
    QStandardItem* kind = text_cell(what);
    if (!stimulus.problem.empty()) {
      kind = text_cell(tr("▲ %1").arg(QString::fromStdString(stimulus.problem)));
      kind->setForeground(theme().look);
    }
    QStringList users{};
    for (const std::string& user : stimulus.used_by) users.append(QString::fromStdString(user));
    const bool is_relief = stimulus.is_height_field && stimulus.problem.empty();
    QStandardItem* size = empty_number_cell();
    if (is_relief) {
      size = number_cell(tr("%1 × %2").arg(QString::number(1e3 * stimulus.width_m, 'g', 4),
                                           QString::number(1e3 * stimulus.length_m, 'g', 4)),
                         stimulus.width_m * stimulus.length_m);
    }
    rows.push_back({path,
                    {name, kind, size,
                     number_cell(tr("%1 × %2").arg(stimulus.columns).arg(stimulus.rows),
                                 static_cast<double>(stimulus.columns * stimulus.rows)),
                     maybe_number_cell(is_relief, 1e6 * stimulus.pitch_m, 1),
                     maybe_number_cell(is_relief, 1e6 * stimulus.rms_m, 1),
                     text_cell(users.isEmpty() ? tr("no protocol") : users.join(", "))}});
  }
  table_->fill(rows);
  show_empty(stimuli.empty());
}

}  // namespace asperity
