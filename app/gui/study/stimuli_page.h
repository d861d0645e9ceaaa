// The study's height fields, pictures, textured meshes and shaped bodies.

#pragma once

#include <vector>

#include <QtGui/QImage>

#include "app/gui/base/study_page.h"
#include "app/tasks/study_overview.h"

class QFileSystemWatcher;
class QLineEdit;

namespace asperity {

class StimulusActions;
class StudyTable;

class StimuliPage final : public StudyPage {
  Q_OBJECT
 public:
  explicit StimuliPage(OpenStudy& study, QWidget* parent = nullptr);

  struct Shown {
    StimulusOverview stimulus{};
    QImage picture{};
  };

 signals:
  void open_wanted(const QString& file);  ///< in the workbench
  void use_wanted(const QStringList& renderings);
  void generate_wanted();

 public:
  /// Selects the stimulus once it is listed. `path` is relative to the study.
  void select_later(const QString& path);

 private:
  void show_stimuli(std::vector<Shown> stimuli);
  void show_selected();
  void copy_from_study();

  std::vector<Shown> stimuli_{};
  QString select_next_{};  ///< a file that was made just now

  QFileSystemWatcher* watcher_ = nullptr;
  QLineEdit* filter_ = nullptr;
  StudyTable* table_ = nullptr;
  StimulusActions* actions_ = nullptr;
};

}  // namespace asperity
