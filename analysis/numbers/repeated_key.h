// Finds keys that occur twice in an object of a JSON text.

#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity {

/// The first key that occurs twice in one object of a text: parsers keep one of the two values without a word. `Json` is
/// nlohmann::json or its ordered form. Nothing where there is none before the text ends or stops being JSON.
template <class Json>
std::optional<std::string> repeated_key(std::string_view text) {
  std::vector<std::set<std::string>> keys{};  // of the objects that are open
  std::optional<std::string> repeated{};
  const auto note = [&](int, typename Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !repeated) {
      std::string key = parsed.template get<std::string>();
      if (!keys.back().insert(key).second) repeated = std::move(key);
    }
    return true;
  };
  [[maybe_unused]] const Json read = Json::parse(text, note, /*allow_exceptions=*/false);
  return repeated;
}

}  // namespace asperity
