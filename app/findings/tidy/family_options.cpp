// Parses options from JSON and from NAME=VALUE.

#include "app/findings/tidy/family_options.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/repeated_key.h"
#include "protocols/file/json_document.h"
#include "results_schema/tables/table.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

OptionValue value_of(const Json& json) {
  if (json.is_boolean()) return {json.get<bool>()};
  if (json.is_number()) return {json.get<double>()};
  if (json.is_string()) return {json.get<std::string>()};
  if (json.is_array()) {
    OptionValue::List list{};
    for (const Json& item : json) list.push_back(value_of(item));
    return {std::move(list)};
  }
  if (json.is_object()) {
    OptionValue::Object object{};
    for (const auto& [name, item] : json.items()) object.emplace_back(name, value_of(item));
    return {std::move(object)};
  }
  return {};
}

[[noreturn]] void refuse_option(const std::string& name, const std::string& what) {
  throw std::runtime_error("the option \"" + name + "\" " + what);
}

double option_number(const OptionValue& option, const std::string& name) {
  if (const auto* number = std::get_if<double>(&option.value)) return *number;
  refuse_option(name, "is not a number; set it to a number");
}

// Levels and names that look like numbers are accepted without quotes.
std::string option_text(const OptionValue& option, const std::string& name) {
  if (const auto* text = std::get_if<std::string>(&option.value)) return *text;
  if (const auto* number = std::get_if<double>(&option.value)) return number_text(*number);
  if (const auto* truth = std::get_if<bool>(&option.value)) return *truth ? "TRUE" : "FALSE";
  refuse_option(name, "is a list or an object; set it to one text");
}

template <class Item>
auto list_of(const OptionValue& option, const std::string& name, Item item) {
  std::vector<decltype(item(option, name))> list{};
  if (const auto* items = std::get_if<OptionValue::List>(&option.value)) {
    for (const OptionValue& one : *items) list.push_back(item(one, name));
  } else {
    list.push_back(item(option, name));
  }
  return list;
}

/// A list of names; a repeated name would duplicate the same numbers.
std::vector<std::string> distinct_names(const OptionValue& option, const std::string& name) {
  std::vector<std::string> names = list_of(option, name, option_text);
  std::set<std::string_view> seen{};
  for (const std::string& one : names) {
    if (!seen.insert(one).second) refuse_option(name, "names \"" + one + "\" twice; name it once");
  }
  return names;
}

OptionValue list_value(const std::vector<std::string>& texts) {
  OptionValue::List list{};
  for (const std::string& text : texts) list.push_back({text});
  return {std::move(list)};
}

/// ": line 2, column 7: PROBLEM" of a text that is not JSON.
std::string place_of_error(const std::string& text, const std::string& file_name) {
  try {
    const JsonDocument read(text, file_name);
  } catch (const ProtocolError& error) {
    const Diagnostic& first = error.diagnostics().front();
    return ": line " + std::to_string(first.line) + ", column " + std::to_string(first.column) +
           ": " + first.message.english();
  }
  return {};
}

}  // namespace

FamilyOptions FamilyOptions::of_json(const std::string& text, const std::string& file_name) {
  Json json{};
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error&) {
    throw std::runtime_error(file_name + ": the options are not valid JSON; correct them" +
                             place_of_error(text, file_name));
  } catch (const Json::out_of_range& error) {
    // "[json.exception.out_of_range.406] number overflow parsing '1e400'"
    const std::string what = error.what();
    throw std::runtime_error(
        file_name + ": the options contain a number that is too large, " +
        what.substr(what.rfind(' ') + 1) +
        "; the largest possible number is 1.8e308. Correct it, then analyse again");
  }
  if (const auto key = repeated_key<Json>(text)) {
    throw std::runtime_error(file_name + ": the options have the key \"" + *key +
                             "\" twice in one object; keep one");
  }
  FamilyOptions options{};
  const OptionValue value = value_of(json);
  if (const auto* object = std::get_if<OptionValue::Object>(&value.value)) {
    options.options_ = *object;
  } else if (!json.empty()) {
    throw std::runtime_error(
        file_name +
        ": the options are not an object; they must be names with values, as {\"conf\": 0.9}");
  }
  return options;
}

void FamilyOptions::set(const std::string& name, double number) {
  options_.emplace_back(name, OptionValue{number});
}

void FamilyOptions::set(const std::string& name, std::string text) {
  options_.emplace_back(name, OptionValue{std::move(text)});
}

void FamilyOptions::set(const std::string& name, const std::vector<std::string>& texts) {
  options_.emplace_back(name, list_value(texts));
}

void FamilyOptions::set(
    const std::string& name,
    const std::vector<std::pair<std::string, std::vector<std::string>>>& levels) {
  OptionValue::Object object{};
  for (const auto& [factor, texts] : levels) object.emplace_back(factor, list_value(texts));
  options_.emplace_back(name, OptionValue{std::move(object)});
}

void FamilyOptions::add(const std::string& name, const std::string& text) {
  if (const auto [earlier, is_first] = added_.emplace(name, text);
      !is_first && earlier->second != text) {
    refuse_option(name,
                  "is given twice, as " + earlier->second + " and as " + text + "; give it once");
  }
  OptionValue value{};
  const Json json = Json::parse(text, nullptr, false);
  const std::optional<double> number_without_zero =
      number_in(text);  // ".3", which JSON does not know
  if (!json.is_discarded()) {
    value = value_of(json);
  } else if (number_without_zero && std::isfinite(*number_without_zero)) {
    value.value = *number_without_zero;
  } else if (text.find(',') == std::string::npos) {
    value.value = text;
  } else {
    OptionValue::List list{};
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      const std::string item = text.substr(begin, end - begin);
      const Json number = Json::parse(item, nullptr, false);
      list.push_back(number.is_number() ? value_of(number) : OptionValue{item});
      begin = end + 1;
    }
    value.value = std::move(list);
  }
  const auto found = std::find_if(options_.begin(), options_.end(),
                                  [&name](const auto& option) { return option.first == name; });
  if (found == options_.end()) {
    options_.emplace_back(name, std::move(value));
  } else {
    found->second = std::move(value);
  }
}

const OptionValue* FamilyOptions::find(const std::string& name) const {
  asked_for_.insert(name);
  const auto found = std::find_if(options_.begin(), options_.end(),
                                  [&name](const auto& option) { return option.first == name; });
  const bool absent =
      found == options_.end() || std::holds_alternative<std::monostate>(found->second.value);
  return absent ? nullptr : &found->second;
}

const OptionValue& FamilyOptions::at(const std::string& name) const {
  const OptionValue* option = find(name);
  if (option == nullptr) refuse_option(name, "is missing and has no default; give it a value");
  return *option;
}

std::vector<std::string> FamilyOptions::names() const {
  std::vector<std::string> names{};
  for (const auto& [name, value] : options_) names.push_back(name);
  return names;
}

bool FamilyOptions::has(const std::string& name) const { return find(name) != nullptr; }

double FamilyOptions::number(const std::string& name) const {
  return option_number(at(name), name);
}

double FamilyOptions::number_or(const std::string& name, double otherwise) const {
  return number_if(name).value_or(otherwise);
}

std::optional<double> FamilyOptions::number_if(const std::string& name) const {
  const OptionValue* option = find(name);
  return option == nullptr ? std::nullopt : std::optional(option_number(*option, name));
}

std::string FamilyOptions::text(const std::string& name) const {
  return option_text(at(name), name);
}

std::string FamilyOptions::text_or(const std::string& name, const std::string& otherwise) const {
  const OptionValue* option = find(name);
  return option == nullptr ? otherwise : option_text(*option, name);
}

std::vector<std::string> FamilyOptions::texts(const std::string& name) const {
  return distinct_names(at(name), name);
}

std::vector<double> FamilyOptions::numbers(const std::string& name) const {
  return list_of(at(name), name, option_number);
}

std::vector<std::pair<std::string, std::vector<std::string>>> FamilyOptions::levels(
    const std::string& name) const {
  std::vector<std::pair<std::string, std::vector<std::string>>> factors{};
  const OptionValue* option = find(name);
  if (option == nullptr) return factors;
  const auto* object = std::get_if<OptionValue::Object>(&option->value);
  if (object == nullptr) {
    refuse_option(name, "is not an object; set it to the factors with their levels, as {\"" +
                            std::string(name == "between" ? "group\": [\"a\", \"b\"]"
                                                          : "spacing\": [1, 2, 4]") +
                            "}");
  }
  for (const auto& [factor, levels] : *object) {
    factors.emplace_back(factor, distinct_names(levels, name + '.' + factor));
  }
  return factors;
}

bool FamilyOptions::truth_or(const std::string& name, bool otherwise) const {
  const OptionValue* option = find(name);
  if (option == nullptr) return otherwise;
  if (const auto* truth = std::get_if<bool>(&option->value)) return *truth;
  refuse_option(name, "is neither true nor false; set it to one of them");
}

std::vector<std::pair<std::string, FamilyOptions>> FamilyOptions::objects(
    const std::string& name) const {
  const auto* items = std::get_if<OptionValue::Object>(&at(name).value);
  if (items == nullptr || items->empty()) {
    refuse_option(name,
                  "is empty or not an object; set it to names with their options, as {\"a\": {…}}");
  }
  std::vector<std::pair<std::string, FamilyOptions>> all{};
  for (const auto& [item, value] : *items) {
    const auto* options = std::get_if<OptionValue::Object>(&value.value);
    if (options == nullptr) {
      refuse_option(name + '.' + item,
                    "is not an object; set it to options with their values, as {\"start\": 10}");
    }
    FamilyOptions of_item{};
    of_item.options_ = *options;
    all.emplace_back(item, std::move(of_item));
  }
  return all;
}

double FamilyOptions::confidence() const {
  const double confidence = number_or("conf", 0.95);
  if (!(confidence > 0.0 && confidence < 1.0)) {
    refuse_option("conf", "is " + number_text(confidence) + "; it must lie between 0 and 1");
  }
  return confidence;
}

std::vector<std::string> FamilyOptions::never_asked_for() const {
  std::vector<std::string> names{};
  for (const auto& [name, value] : options_) {
    if (!asked_for_.contains(name)) names.push_back(name);
  }
  return names;
}

}  // namespace asperity
