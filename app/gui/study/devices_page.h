// The devices that a session can run on, and what each can do.

#pragma once

#include "app/gui/study/study_page.h"

namespace asperity {

class DevicesPage final : public StudyPage {
  Q_OBJECT
 public:
  explicit DevicesPage(OpenStudy& study, QWidget* parent = nullptr);

  /// "1 ready"
  QString count() const;

 private:
  int ready_ = 0;
};

}  // namespace asperity
