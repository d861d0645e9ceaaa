// Reads the events of merges, and extends each key by those of later merges.

#include "app/study_files/session_origins.h"

#include <nlohmann/json.hpp>

namespace asperity {

std::vector<SessionOrigin> session_origins(const std::vector<EventRow>& events) {
  std::vector<SessionOrigin> origins{};
  for (const EventRow& event : events) {
    if (event.kind != kMergedEvent) continue;
    const auto data = nlohmann::json::parse(event.data_json, nullptr, false);
    if (!data.is_object()) continue;
    SessionOrigin& origin = origins.emplace_back();
    origin.key = nlohmann::json{data.value("study", ""), data.value("created_utc", ""),
                                data.value("source", 0)}
                     .dump();
    origin.session_id = data.value("session_id", std::int64_t{0});
  }
  // A number identifies a study in one merge: those before it follow from the merges after it.
  std::string later{};
  for (std::size_t i = origins.size(); i > 0; --i) {
    later += origins[i - 1].key;
    origins[i - 1].key = later;
  }
  return origins;
}

}  // namespace asperity
