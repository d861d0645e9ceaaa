// Declares the card for a value that a form does not show.

#pragma once

#include "app/gui/editor/form/form_part.h"

class QLabel;

namespace asperity {

/// "Defined in the text (line 12)", with a button that shows the line.
class TextCard final : public FormPart {
  Q_OBJECT
 public:
  TextCard(FormContext& context, const std::string& pointer, QWidget* parent);
  void refresh() override;

 private:
  QLabel* words_ = nullptr;
};

}  // namespace asperity
