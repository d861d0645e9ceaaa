// Translates the labels of the pages and keys that lead to a value, and writes them into sentences about it.

#include "app/gui/base/form_words.h"

#include <vector>

#include <QtCore/QCoreApplication>
#include <QtCore/QRegularExpression>
#include <QtCore/QStringList>
#include <nlohmann/json.hpp>

#include "app/gui/look/words.h"
#include "protocols/file/diagnostic.h"
#include "protocols/form/form_entries.h"
#include "protocols/form/form_pages.h"
#include "protocols/keys/tables.h"

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

QString sentence_in_form(const nlohmann::json& protocol, const Diagnostic& remark) {
  QString sentence = text(remark.message);
  std::vector<const KeyTable*> tables{&kProtocolTable};  // of the objects around the value
  for (const PathPart& part : path_of(protocol, remark.pointer)) {
    if (tables.back() != nullptr && !part.is_label) return sentence;  // an unknown key
    tables.push_back(part.table);
  }
  if (tables.size() == 1) return sentence;  // about the whole text
  static const QRegularExpression quoted("\"([^\"]+)\"");
  for (qsizetype from = 0;;) {
    const QRegularExpressionMatch match = quoted.match(sentence, from);
    if (!match.hasMatch()) break;
    QString shown = match.captured();
    // Elsewhere than in the names of keys, the words of a sentence often occur as keys of the whole protocol.
    const bool is_key = sentence.first(match.capturedStart()).endsWith("key ");
    for (const KeyTable* const table : tables) {  // the innermost last
      const bool can_have_it = table != nullptr && (is_key || table != &kProtocolTable);
      const ProtocolKey* const key =
          can_have_it ? table->find(match.captured(1).toStdString()) : nullptr;
      if (key != nullptr) shown = "“" + text_of_keys(key->label) + "”";
    }
    sentence.replace(match.capturedStart(), match.capturedLength(), shown);
    from = match.capturedStart() + shown.size();
  }
  static const QRegularExpression key_word("\\bkey(?=s?\\b)");
  return sentence.replace(key_word, "setting");
}

QString remark_in_form(const nlohmann::json& protocol, const Diagnostic& remark) {
  if (protocol.is_discarded() && remark.line > 0) {
    return QCoreApplication::translate("FormWords", "Line %1: %2")
        .arg(remark.line)
        .arg(text(remark.message));
  }
  const QString place = place_in_form(protocol, remark.pointer);
  const QString sentence = sentence_in_form(protocol, remark);
  return place.isEmpty() ? sentence : place + ": " + sentence;
}

}  // namespace asperity
