// Writes a complete translation in which every text is marked, for tests.

#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "protocols/texts/translatable_texts.h"

namespace asperity {

/// Translates each text of the protocol, at most 256 bytes, to "MARK text".
inline std::string marked_translation(const std::string& protocol, const std::string& mark) {
  nlohmann::json texts = nlohmann::json::object();
  for (const TranslatableText& each : translatable_texts(nlohmann::json::parse(protocol))) {
    texts[each.address][each.text] = mark + ' ' + each.text;
  }
  return nlohmann::json{{"format", "asperity.translation/1"}, {"texts", texts}}.dump(1);
}

}  // namespace asperity
