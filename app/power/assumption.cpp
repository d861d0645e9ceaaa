// Reads assumptions from a JSON file, checking names, units and ranges, and writes them with their sources.

#include "app/power/assumption.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "protocols/design/wording.h"

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

const char* text_of(Assumption::Part part) {
  switch (part) {
    case Assumption::Part::effect:
      return "effect";
    case Assumption::Part::effect_sd:
      return "effect_sd";
    case Assumption::Part::other:
      return "other";
  }
  return "";
}

Json read_json(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw std::runtime_error("the file of assumptions " + file.string() +
                             " cannot be read; check its path and its permissions");
  }
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  Json read = Json::parse(text, nullptr, false);
  if (!read.is_array()) {
    throw std::runtime_error("the file of assumptions " + file.string() +
                             " is not a JSON array of objects with \"name\", \"value\" and "
                             "\"source\"; start from the list that the command writes");
  }
  return read;
}

void check_keys(const Json& entry, const std::string& place) {
  static const std::set<std::string> kKnown{"name", "value",   "source", "unit",
                                            "part", "meaning", "tests",  "null_value"};
  for (const auto& [key, value] : entry.items()) {
    if (kKnown.contains(key)) continue;
    throw std::runtime_error(place + " has the unknown key \"" + key + "\"; remove it" +
                             did_you_mean(key, {kKnown.begin(), kKnown.end()}));
  }
}

std::string text_at(const Json& entry, const char* key, const std::string& place) {
  const auto found = entry.find(key);
  if (found != entry.end() && found->is_string() && !found->get<std::string>().empty()) {
    return found->get<std::string>();
  }
  throw std::runtime_error(place + " has no text as \"" + key + "\"; state it");
}

void check_unit(const Json& entry, const std::string& name, std::span<const Assumption> assumptions,
                const std::string& place) {
  const auto unit = entry.find("unit");
  if (unit == entry.end()) return;
  for (const Assumption& assumption : assumptions) {
    if (!is_named(assumption, name) || *unit == Json(assumption.unit)) continue;
    throw std::runtime_error(place + " states " + name + " in the unit " + unit->dump() +
                             "; its unit is \"" + assumption.unit +
                             "\": convert the value, or remove the key");
  }
}

}  // namespace

bool is_named(const Assumption& assumption, std::string_view name) {
  const std::string& full = assumption.name;
  if (full == name) return true;
  return full.size() > name.size() && full.ends_with(name) &&
         full[full.size() - name.size() - 1] == '.';
}

void set_assumption(std::span<Assumption> assumptions, std::string_view name, double value,
                    const std::string& source) {
  if (source.empty()) {
    throw std::runtime_error("the value of " + std::string(name) +
                             " has no source; state where it is from, or \"assumed\"");
  }
  bool is_known = false;
  for (Assumption& assumption : assumptions) {
    if (!is_named(assumption, name)) continue;
    is_known = true;
    assumption.value = value;
    assumption.source = source;
  }
  if (is_known) return;
  std::vector<std::string> names{};
  for (const Assumption& assumption : assumptions) names.push_back(assumption.name);
  throw std::runtime_error(
      with_declared_names("there is no assumption " + in_quotes(name), std::string(name), names)
          .english());
}

std::vector<Assumption> with_assumptions_of_file(std::vector<Assumption> assumptions,
                                                 const std::string& path) {
  const std::filesystem::path file(path);
  std::size_t number = 0;
  for (const Json& entry : read_json(file)) {
    const std::string place = "entry " + std::to_string(++number) + " of " + file.string();
    if (!entry.is_object()) {
      throw std::runtime_error(place +
                               " is not an object; write {\"name\": …, \"value\": …, "
                               "\"source\": …}");
    }
    check_keys(entry, place);
    const std::string name = text_at(entry, "name", place);
    const auto value = entry.find("value");
    if (value != entry.end() && value->is_null()) continue;
    if (value == entry.end() || !value->is_number()) {
      throw std::runtime_error(place + " has no number as \"value\" of " + name + "; state it");
    }
    check_unit(entry, name, assumptions, place);
    try {
      set_assumption(assumptions, name, value->get<double>(), text_at(entry, "source", place));
    } catch (const std::runtime_error& problem) {
      throw std::runtime_error(place + ": " + problem.what());
    }
  }
  return assumptions;
}

std::string json_of(std::span<const Assumption> assumptions) {
  Json all = Json::array();
  for (const Assumption& assumption : assumptions) {
    Json entry{{"name", assumption.name},
               {"value", assumption.value ? Json(*assumption.value) : Json(nullptr)},
               {"unit", assumption.unit},
               {"source", assumption.source},
               {"part", text_of(assumption.part)},
               {"meaning", assumption.meaning.english()}};
    if (assumption.part == Assumption::Part::effect) {
      entry["tests"] = assumption.tests;
      entry["null_value"] = assumption.null_value;
    }
    all.push_back(std::move(entry));
  }
  return all.dump(2) + "\n";
}

}  // namespace asperity
