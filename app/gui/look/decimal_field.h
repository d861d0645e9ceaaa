// A field for a number, shown in the user's locale and typed with a point or a comma.

#pragma once

#include <QtWidgets/QDoubleSpinBox>

namespace asperity {

/// Separators of thousands are neither shown nor taken (apply_language), so that either sign can only be the
/// decimal point.
class DecimalField : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;

  QValidator::State validate(QString& text, int& position) const override;
  double valueFromText(const QString& text) const override;
};

}  // namespace asperity
