// Translates the labels of the pages and keys that lead to a value.

#include "app/gui/base/form_words.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QStringList>
#include <nlohmann/json.hpp>

#include "app/gui/look/words.h"
#include "protocols/file/diagnostic.h"
#include "protocols/form/form_entries.h"
#include "protocols/form/form_pages.h"

namespace asperity {

namespace {

/// Between the parts of a path.
const QString kOfPath = QStringLiteral(" › ");

}  // namespace

QString text_of_keys(std::string_view english) {
  return QCoreApplication::translate("Keys", std::string(english).c_str());
}

QString path_in_form(const nlohmann::json& protocol, const std::string& pointer) {
  QStringList parts{};
  for (const PathPart& part : path_of(protocol, pointer)) {
    parts.append(part.is_label ? text_of_keys(part.text) : text(part.text));
  }
  return parts.join(kOfPath);
}

QString place_in_form(const nlohmann::json& protocol, const std::string& pointer) {
  if (pointer.empty()) return {};
  return text_of_keys(form_page_of(pointer).label) + kOfPath + path_in_form(protocol, pointer);
}

QString remark_in_form(const nlohmann::json& protocol, const Diagnostic& remark) {
  const QString place = place_in_form(protocol, remark.pointer);
  return place.isEmpty() ? text(remark.message) : place + ": " + text(remark.message);
}

}  // namespace asperity
