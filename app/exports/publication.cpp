// Lists the columns by kind of publication, and composes the sentences from these lists.

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

std::string publication_text(const std::vector<ExportFile>& files, ExportAudience audience) {
  std::map<Publication, ListedColumns> columns{};
  for (const ExportFile& file : files) {
    for (const ExportColumn& column : file.columns) {
      if (column.publication == Publication::kept && file.name != "participants") continue;
      const bool is_dropped_here = column.publication == Publication::dropped_with_new_labels &&
                                   is_left_out(column.publication, audience);
      columns[is_dropped_here ? Publication::dropped : column.publication].add(file.name,
                                                                               column.name);
    }
  }
  return columns[Publication::dropped].sentence("Left out") +
         columns[Publication::dropped_unless_named].sentence(
             "Left out unless named by --with-questions") +
         columns[Publication::dropped_with_new_labels].sentence("Left out with --relabel") +
         columns[Publication::without_questionnaires].sentence(
             "n/a for answers to questionnaires, unless named by --with-questions, and for free "
             "text") +
         columns[Publication::without_free_text].sentence(
             "n/a for texts entered by hand or reported by a driver (columns of codes: \"typed\"; "
             "columns of data: without the members that contain such texts)") +
         columns[Publication::kept].sentence("Kept for each participant");
}

std::string identifying_text(const ExportOptions& options) {
  const char* const recordings =
      options.formats.contains(ExportFormat::physio)
          ? "Recordings contain the movement of the hand in every tick. Movements differ between "
            "participants: recordings of the same participant can be recognised."
          : "Recordings, which contain the movement of the hand in every tick, are left out unless "
            "--formats names physio. Summaries of the movement are kept: paths, forces, speeds and "
            "times of presentations, visits, compliance and responses.";
  const char* const age =
      options.has_age_bands
          ? "A band of ages contains at least five participants, but fewer of them have the same "
            "sex, handedness and group."
          : "The exact age is often unique together with sex, handedness and group (--age-bands "
            "replaces ages by bands of at least five participants).";
  const char* const label =
      options.audience == ExportAudience::relabelled
          ? "Labels were drawn at random for this export, and the rows are in their order. The "
            "assignment to the labels of the study is stored neither here nor in the study. The "
            "group, the order of the conditions, the number of sessions, the times within a "
            "session, the driver and model of the device, and the versions of protocols and force "
            "models are kept. With the study, or an export that has its labels, a participant can "
            "be found by comparing the data."
          : "The label identifies a participant to every reader of the list of labels and names. "
            "It often contains initials, a birthday or the order of the sessions, and gaps in the "
            "labels show who withdrew. Seeds, the row of the counterbalancing, and the versions of "
            "the program and of the consent text, checksums of protocols, stimuli and plug-ins, "
            "and "
            "the device narrow down when a session was run (--relabel draws new labels and leaves "
            "these columns out, except the device).";
  constexpr const char* kNames =
      "Names of files and programs are kept: stimuli, height fields and, in their sidecars, the "
      "photographs from which they were made, external programs, plug-ins, protocols.";
  std::string text = "The following data can still identify a participant:\n";
  for (const char* const sentences : {recordings, age, label, kNames}) {
    text += std::string("- ") + sentences + '\n';
  }
  return text + "Check whether these data could identify a participant before publishing them.\n";
}

std::string publication_text_of_any_study() {
  StudyVocabulary vocabulary{};
  vocabulary.participant_answers = {"NAME"};
  vocabulary.questions["NAME"].free_text = false;
  return publication_text(export_files(vocabulary), ExportAudience::published) +
         identifying_text({.audience = ExportAudience::published});
}

std::string left_out_answers_to(const std::string& question) { return "answer(" + question + ")"; }

}  // namespace asperity
