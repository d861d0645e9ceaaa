// The study's height fields, pictures, textured meshes and shaped bodies.

#pragma once

#include <vector>

#include <QtGui/QImage>

#include "app/gui/base/study_page.h"
#include "app/tasks/study_overview.h"

class QFileSystemWatcher;
class QLineEdit;

namespace asperity {

class StudyTable;

class StimuliPage final : public StudyPage {
  Q_OBJECT
 public:
  explicit StimuliPage(OpenStudy& study, QWidget* parent = nullptr);

  struct Shown {
    StimulusOverview stimulus{};
    QImage picture{};
  };

 private:
  void show_stimuli(const std::vector<Shown>& stimuli);

  QFileSystemWatcher* watcher_ = nullptr;
  QLineEdit* filter_ = nullptr;
  StudyTable* table_ = nullptr;
};

}  // namespace asperity
