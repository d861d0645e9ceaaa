// Reads case.json and its tables, and writes findings as quantity, key and value.

#include "app/findings/tidy/reference_case.h"

#include <stdexcept>
#include <string_view>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

std::string csv_cell(std::string_view cell) {
  if (cell.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(cell);
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

std::vector<std::string> inputs_of(const Json& json) {
  if (json.is_string()) return {json.get<std::string>()};
  return json.get<std::vector<std::string>>();
}

}  // namespace

ReferenceCase read_reference_case(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "case.json";
  ReferenceCase result{};
  try {
    const Json json = Json::parse(read_file(path));
    result.family = json.at("family").get<std::string>();
    for (const std::string& name : inputs_of(json.at("inputs"))) {
      result.input.tables.emplace_back(read_file(folder / name), (folder / name).string());
    }
    if (json.contains("options")) {
      result.input.options = FamilyOptions::of_json(json["options"].dump(), path.string());
    }
  } catch (const Json::exception&) {
    throw std::runtime_error(path.string() +
                             " must be a JSON object with \"family\", a text, and \"inputs\", "
                             "names of tables; correct it");
  }
  return result;
}

std::string case_csv_of(std::span<const Finding> findings) {
  std::string text = "quantity,key,value\n";
  for (const Finding& finding : findings) {
    text += csv_cell(finding.quantity) + ',' + csv_cell(finding.key.text()) + ',' +
            (finding.value ? number_text(*finding.value) : csv_cell(finding.word)) + '\n';
  }
  return text;
}

}  // namespace asperity
