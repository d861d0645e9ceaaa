// How the form of a protocol names keys and the places of values.

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <QtCore/QString>
#include <nlohmann/json_fwd.hpp>

#include "protocols/shapes/shape.h"

namespace asperity {

struct Diagnostic;

/// A text of the tables of keys, which are English, in the language of the windows.
QString text_of_keys(std::string_view english);
/// A word of a choice: with blanks in place of underscores in English.
QString name_of_word(std::string_view word);
/// A meaning of the tables of keys, with the labels of the keys and the names of the words that it has in backticks.
QString meaning_in_form(std::string_view english);

/// The path to a value in the words of the form: "Blocks › main › Question".
QString path_in_form(const nlohmann::json& protocol, const std::string& pointer);
/// The same after the page of the form, and empty for the whole protocol. Any thread.
QString place_in_form(const nlohmann::json& protocol, const std::string& pointer);
/// The sentence of a problem or a warning next to its field, where the meaning of the key is read already: with the labels of keys in
/// place of their names. That about a value that the form does not know stays in the words of the file. Numbers are in the unit of the form: that of `parameter` where the value is a parameter of a
/// force model, whose declaration is not in the protocol. Any thread.
QString sentence_in_form(const nlohmann::json& protocol, const Diagnostic& remark,
                         const std::optional<NumberShape>& parameter = {});
/// The sentence with the meaning of the key, after its place in the form; without a place alone. In a text that cannot be read as JSON (a discarded value) no
/// place is known, and the line precedes the sentence. Any thread.
QString remark_in_form(const nlohmann::json& protocol, const Diagnostic& remark);

}  // namespace asperity
