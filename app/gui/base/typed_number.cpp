// Implements the conversion of typed and shown numbers.

#include "app/gui/base/typed_number.h"

#include <QtCore/QLocale>

#include "app/gui/look/words.h"

namespace asperity {

std::string decimal_of(QString typed) {
  typed = typed.trimmed().replace(QChar(0x2212), '-').replace(',', '.');
  if (typed.endsWith('.')) typed.chop(1);  // decimals are about to follow
  return typed.toStdString();
}

QString shown_decimal(std::string_view in_file) {
  return text(std::string(in_file))
      .replace('.', QLocale().decimalPoint())
      .replace('-', QChar(0x2212));
}

std::optional<std::string> number_typed(const NumberShape& shape, const QString& typed) {
  return number_in_file(shape, decimal_of(typed));
}

QString shown_unit(const NumberShape& shape) {
  const std::string_view unit = shape.display.unit.empty() ? shape.unit : shape.display.unit;
  return text(std::string(unit == "1" ? "" : unit));
}

QString shown_in_unit(const NumberShape& shape, std::string_view in_file) {
  return shown_decimal(displayed_number(shape, in_file).value_or(std::string(in_file)));
}

}  // namespace asperity
