// Who has taken part, and what the next one would be called.

#pragma once

#include <vector>

#include "app/gui/base/study_page.h"
#include "app/tasks/study_overview.h"

class QLineEdit;

namespace asperity {

class StudyTable;

class ParticipantsPage final : public StudyPage {
  Q_OBJECT
 public:
  explicit ParticipantsPage(OpenStudy& study, QWidget* parent = nullptr);

 signals:
  void sessions_wanted(const QString& label);

 private:
  void show_people(const std::vector<ParticipantOverview>& people);
  void fill();
  void show_selected();
  void ask_to_withdraw();

  std::vector<ParticipantOverview> all_{};
  bool show_virtual_ = false;
  bool chosen_ = false;  ///< the person has said which ones to show
  QPushButton* people_ = nullptr;
  QPushButton* virtual_people_ = nullptr;
  QLineEdit* filter_ = nullptr;
  QLabel* next_label_ = nullptr;
  StudyTable* table_ = nullptr;
  QLabel* answers_ = nullptr;
  QPushButton* sessions_ = nullptr;
  QPushButton* withdraw_ = nullptr;
};

}  // namespace asperity
