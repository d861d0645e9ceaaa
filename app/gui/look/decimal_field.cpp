// Replaces a typed point by the decimal point of the locale before Qt validates and converts the text.

#include "app/gui/look/decimal_field.h"

#include <QtCore/QLocale>

namespace asperity {

namespace {

QString with_point_of(const QLocale& locale, QString text) {
  for (const QChar typed : {QChar('.'), QChar(',')}) text.replace(typed, locale.decimalPoint());
  return text;
}

}  // namespace

QValidator::State DecimalField::validate(QString& text, int& position) const {
  text = with_point_of(locale(), text);
  return QDoubleSpinBox::validate(text, position);
}

double DecimalField::valueFromText(const QString& text) const {
  return QDoubleSpinBox::valueFromText(with_point_of(locale(), text));
}

}  // namespace asperity
