#include "app/exports/publication.h"

#include <map>

#include "app/exports/columns/export_tables.h"

namespace asperity {

namespace {

/// "created_utc (participants.tsv), consent_utc, started_utc (sessions.tsv)": the columns of one kind of publication.
class ListedColumns final {
 public:
  void add(const std::string& file, const std::string& column) {
    std::string& columns = of_file_[file];
    if (columns.empty()) files_.push_back(file);
    columns += (columns.empty() ? "" : ", ") + column;
  }
  /// A sentence that begins with `what`; empty where there is no column.
  std::string sentence(const std::string& what) const {
    std::string text{};
    for (const std::string& file : files_) {
      text += (text.empty() ? what + ": " : ", ") + of_file_.at(file) + " (" + file + ".tsv)";
    }
    return text.empty() ? text : text + ".\n";
  }

 private:
  std::vector<std::string> files_{};  ///< in the order of an export
  std::map<std::string, std::string> of_file_{};
};

}  // namespace

std::string publication_text(const std::vector<ExportFile>& files) {
  std::map<Publication, ListedColumns> columns{};
  for (const ExportFile& file : files) {
    for (const ExportColumn& column : file.columns) {
      if (column.publication == Publication::kept && file.name != "participants") continue;
      columns[column.publication].add(file.name, column.name);
    }
  }
  return columns[Publication::dropped].sentence("Left out") +
         columns[Publication::dropped_unless_named].sentence(
             "Left out unless named by --with-questions") +
         columns[Publication::without_questionnaires].sentence(
             "n/a for answers to questionnaires, unless named by --with-questions") +
         columns[Publication::without_free_text].sentence(
             "n/a for texts entered by hand or reported by a driver (columns of codes: \"typed\"; "
             "columns of data: without the members that contain such texts)") +
         columns[Publication::kept].sentence("Kept for each participant") +
         "Check whether these columns could identify a participant before publishing them.\n";
}

std::string publication_text_of_any_study() {
  StudyVocabulary vocabulary{};
  vocabulary.participant_answers = {"NAME"};
  vocabulary.questions["NAME"].free_text = false;
  return publication_text(export_files(vocabulary));
}

std::string left_out_answers_to(const std::string& question) { return "answer(" + question + ")"; }

}  // namespace asperity
