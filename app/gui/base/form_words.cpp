// Translates the labels of the pages and keys that lead to a value, and writes them into sentences about it.

#include "app/gui/base/form_words.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QtCore/QCoreApplication>
#include <QtCore/QRegularExpression>
#include <QtCore/QStringList>
#include <nlohmann/json.hpp>

#include "app/gui/base/typed_number.h"
#include "app/gui/look/words.h"
#include "protocols/design/wording.h"
#include "protocols/file/diagnostic.h"
#include "protocols/form/form_entries.h"
#include "protocols/form/form_pages.h"
#include "protocols/keys/form_sentences.h"
#include "protocols/keys/tables.h"
#include "protocols/keys/texts_of_keys.h"
#include "stimuli/properties/other_unit.h"

namespace asperity {

namespace {

/// Between the parts of a path.
const QString kOfPath = QStringLiteral(" › ");

struct FormWords {
  Q_DECLARE_TR_FUNCTIONS(FormWords)
};

/// A label that is a quotation has its own.
QString in_quotes_of_form(const QString& label) {
  const bool is_quoted = QStringLiteral("\"“„").contains(label.left(1));
  return is_quoted ? label : FormWords::tr("“%1”").arg(label);
}

/// The label of a key: that of the innermost object that has such a key, or else the only one that any object has. Empty where there
/// is none.
std::string_view label_of_key(const std::vector<const KeyTable*>& around, std::string_view name) {
  static const std::map<std::string_view, std::string_view> kLabels = labels_of_keys();
  const auto only = kLabels.find(name);
  std::string_view label = only == kLabels.end() ? std::string_view() : only->second;
  for (const KeyTable* const table : around) {  // the innermost last
    const ProtocolKey* const key = table == nullptr ? nullptr : table->find(name);
    if (key != nullptr) label = key->label;
  }
  return label;
}

/// The name of a key, given in quotation marks; unchanged where there is no label.
QString label_in_quotes(const std::vector<const KeyTable*>& around, std::string_view quoted) {
  const std::string_view label = label_of_key(around, quoted.substr(1, quoted.size() - 2));
  return label.empty() ? text(std::string(quoted)) : in_quotes_of_form(text_of_keys(label));
}

/// A word, given in quotation marks.
QString word_in_quotes(std::string_view quoted) {
  return in_quotes_of_form(name_of_word(quoted.substr(1, quoted.size() - 2)));
}

/// The number at the place, as the form displays it; nullopt for another value.
std::optional<NumberShape> number_at(const nlohmann::json& protocol, const std::string& pointer) {
  if (!protocol.contains(nlohmann::json::json_pointer(pointer))) return {};
  const std::optional<ValueShape> shape = shape_at(kProtocolTable, protocol, pointer);
  const NumberShape* const number = shape ? number_in(*shape) : nullptr;
  return number == nullptr ? std::nullopt : std::optional(displayed_shape(*number, pointer));
}

/// "500 mm" of 0.5 m.
std::string number_in_form(const std::optional<NumberShape>& shape, const std::string& in_file,
                           const Phrase::LookUp& windows) {
  if (!shape) return windows(nullptr, in_file.c_str());
  const std::string shown = displayed_number(*shape, in_file).value_or(in_file);
  const std::string unit = shown_unit(*shape).toStdString();
  constexpr const char* kNoBreakSpace = "\u00a0";
  return windows(nullptr, shown.c_str()) + (unit.empty() ? "" : kNoBreakSpace + unit);
}

/// Only English sentences have the words of the file; translations have those of the form.
QString with_settings(const std::string& sentence) {
  static const QRegularExpression kKey("\\bkey(?=s?\\b)");
  return text(sentence).replace(kKey, "setting");
}

/// Where the meaning of a key is read.
enum class Meaning { in_sentence, next_to_field };

QString sentence(const nlohmann::json& protocol, const Diagnostic& remark, Meaning meaning,
                 const std::optional<NumberShape>& parameter = {}) {
  std::vector<const KeyTable*> tables{&kProtocolTable};  // of the objects around the value
  for (const PathPart& part : path_of(protocol, remark.pointer)) {
    const bool is_known = tables.back() == nullptr || part.is_label;
    if (!is_known) return words_of(remark.message);
    tables.push_back(part.table);
  }
  if (tables.size() == 1) return words_of(remark.message);  // about the whole text
  const std::optional<NumberShape> number =
      parameter ? parameter : number_at(protocol, remark.pointer);
  const Phrase::LookUp look_up = [&, windows = words_of_windows()](const char* context,
                                                                   const char* words) {
    if (context == nullptr) return windows(context, words);
    const std::string_view of(context);
    if (of == kPlacesOfKeys) return in_quotes_of_form(place_in_form(protocol, words)).toStdString();
    if (of == kNumbersOfFile) return number_in_form(number, words, windows);
    if (of == kMeaningsOfKeys && meaning == Meaning::next_to_field) return std::string("%1");
    if (of == kJsonOfFile) return std::string();
    if (of == kUnitOfNumber) return number ? std::string() : std::string(words);
    const bool has_other_unit = number && !number->display.unit.empty();
    if (of == kUnitsOfFile && has_other_unit) return std::string();
    if (of == kNamesOfKeys) return label_in_quotes(tables, words).toStdString();
    if (of == kWordsOfKeys) return word_in_quotes(words).toStdString();
    const std::string shown =
        of == kTextsOfKeys ? meaning_in_form(words).toStdString() : windows(context, words);
    return shown == words ? with_settings(shown).toStdString() : shown;
  };
  return text(remark.message.translated(look_up));
}

}  // namespace

QString text_of_keys(std::string_view english) {
  return QCoreApplication::translate(kTextsOfKeys, std::string(english).c_str());
}

QString name_of_word(std::string_view word) {
  return QCoreApplication::translate(kWordsOfKeys, std::string(word).c_str()).replace('_', ' ');
}

QString meaning_in_form(std::string_view english) {
  static const QRegularExpression kName("`(\\w+)`");
  QString meaning = text_of_keys(english);
  for (auto name = kName.match(meaning); name.hasMatch(); name = kName.match(meaning)) {
    const std::string named = name.captured(1).toStdString();
    const std::string_view label = label_of_key({}, named);
    const QString shown = label.empty() ? name_of_word(named) : text_of_keys(label);
    meaning.replace(name.capturedStart(), name.capturedLength(), in_quotes_of_form(shown));
  }
  return meaning;
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

QString sentence_in_form(const nlohmann::json& protocol, const Diagnostic& remark,
                         const std::optional<NumberShape>& parameter) {
  return sentence(protocol, remark, Meaning::next_to_field, parameter);
}

QString remark_in_form(const nlohmann::json& protocol, const Diagnostic& remark) {
  if (protocol.is_discarded() && remark.line > 0) {
    return FormWords::tr("Line %1: %2").arg(remark.line).arg(words_of(remark.message));
  }
  const QString place = place_in_form(protocol, remark.pointer);
  const QString said = sentence(protocol, remark, Meaning::in_sentence);
  return place.isEmpty() ? said : place + ": " + said;
}

}  // namespace asperity
