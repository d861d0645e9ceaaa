// The steps of a session as a protocol would lay them out: for an example of everything random.

#pragma once

#include <cstdint>
#include <filesystem>

#include <QtWidgets/QWidget>

#include "app/gui/look/background_task.h"
#include "app/tasks/protocol_files.h"

class QLabel;

namespace asperity {

class StudyTable;

class PlanPreview final : public QWidget {
  Q_OBJECT
 public:
  explicit PlanPreview(QWidget* parent = nullptr);

  /// A protocol without problems.
  void show_protocol(const Protocol& protocol);

 private:
  void make_example();

  std::shared_ptr<const Protocol> protocol_{};
  std::uint64_t seed_ = 1;
  BackgroundTask task_{};
  QLabel* words_ = nullptr;
  StudyTable* table_ = nullptr;
};

}  // namespace asperity
