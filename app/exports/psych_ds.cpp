// Writes one data file per session, and the description of the dataset at the end.

#include "app/exports/psych_ds.h"

#include <cctype>

#include <nlohmann/json.hpp>

#include "app/exports/columns/export_tables.h"

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

/// Removes characters other than letters and digits, as required for keywords and values of file
/// names.
std::string plain(const std::string& text) {
  std::string label{};
  for (const char letter : text) {
    if (std::isalnum(static_cast<unsigned char>(letter)) != 0) label += letter;
  }
  return label.empty() ? "task" : label;
}

}  // namespace

PsychDataset::PsychDataset(ExportFolder& folder, std::string root, const std::string& study_name,
                           const StudyVocabulary& vocabulary, ExportAudience audience,
                           const MadeBy& made_by)
    : folder_(folder),
      root_(std::move(root)),
      study_name_(study_name),
      made_by_(made_by),
      columns_(columns_for(audience, answered_trial_columns(vocabulary), left_out_)) {}

void PsychDataset::begin_session(const ExportPlace& at) {
  std::string session = std::to_string(at.session->session);
  if (session.size() < 2) session.insert(0, "0");
  file_ = root_ + "data/subject-" + at.participant->label + "_session-" + session + "_task-" +
          plain(at.protocol->name) + "_data.csv";
  std::vector<std::string> names{};
  for (const ExportColumn& column : columns_) names.push_back(column.name);
  table_.emplace(folder_.path_of(file_), TableFile::Format::csv, names);
}

void PsychDataset::add_row(const std::vector<Cell>& row) { table_->add(row); }

void PsychDataset::end_session() {
  folder_.add(file_, table_->finish(), left_out_);
  table_.reset();
}

void PsychDataset::finish() {
  Json variables = Json::array();
  for (const ExportColumn& column : columns_) {
    Json variable{
        {"@type", "PropertyValue"}, {"name", column.name}, {"description", column.description}};
    if (!column.unit.empty()) variable["unitText"] = column.unit;
    if (column.minimum) variable["minValue"] = *column.minimum;
    if (column.maximum) variable["maxValue"] = *column.maximum;
    if (!column.levels.empty()) variable["valueReference"] = column.levels;
    variables.push_back(std::move(variable));
  }
  const Json description{
      {"@context", "https://schema.org/"},
      {"@type", "Dataset"},
      {"name", study_name_ + made_by_.in_title},
      {"description",
       (made_by_.sentence.empty() ? "" : made_by_.sentence + " ") +
           "Responses to haptic textures, one file per session, one row per response. Empty cells "
           "are missing values; analyses include the rows with counts_in_analyses 1. A text that "
           "a spreadsheet would read as a formula is preceded by an apostrophe; the same applies "
           "to a text that begins with one."},
      {"variableMeasured", std::move(variables)}};
  folder_.write(root_ + "dataset_description.json", description.dump(2) + "\n");
}

}  // namespace asperity
