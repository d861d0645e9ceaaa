// An attempt as tables: answers, surfaces, compliance, the loop; and what happened and was decided.

#pragma once

#include <QtWidgets/QScrollArea>
#include <QtWidgets/QWidget>

#include "app/records/attempt_detail.h"

class QLabel;

namespace asperity {

class StudyTable;

/// What was answered and measured.
class MeasureTables final : public QScrollArea {
  Q_OBJECT
 public:
  explicit MeasureTables(QWidget* parent = nullptr);
  void show_attempt(const AttemptDetail& detail);

 private:
  StudyTable* answers_ = nullptr;
  QLabel* surfaces_heading_ = nullptr;
  StudyTable* surfaces_ = nullptr;
  StudyTable* instability_ = nullptr;
  StudyTable* compliance_ = nullptr;
  StudyTable* loop_ = nullptr;
  QLabel* limits_heading_ = nullptr;
  StudyTable* limits_ = nullptr;
};

/// Events of the attempt, and every decision about it.
class HistoryTables final : public QWidget {
  Q_OBJECT
 public:
  explicit HistoryTables(QWidget* parent = nullptr);
  void show_attempt(const AttemptDetail& detail);

 private:
  StudyTable* events_ = nullptr;
  StudyTable* decisions_ = nullptr;
};

}  // namespace asperity
