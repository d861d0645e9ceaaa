// Declares the list of all texts that participants read.

#pragma once

#include <string>
#include <vector>

#include "app/gui/editor/form/form_part.h"

class QVBoxLayout;

namespace asperity {

/// A field for each text of the protocol that a translation replaces, with its place above it.
class TextsList final : public FormPart {
  Q_OBJECT
 public:
  TextsList(FormContext& context, QWidget* parent);
  void refresh() override;

 private:
  std::vector<std::string> made_{};  ///< the pointers
  std::vector<FormPart*> fields_{};
  QVBoxLayout* layout_ = nullptr;
};

}  // namespace asperity
