// Examines a study up to 1 GiB, and adds what was found to errors while it is read.

#include "app/study_files/study_condition.h"

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "results_schema/error_text.h"

namespace asperity {

namespace {

constexpr std::uintmax_t kMost_bytes = std::uintmax_t{1} << 30;

bool is_looked_at(const Study& study) {
  return std::filesystem::file_size(study.folder() / "study.sqlite") <= kMost_bytes;
}

}  // namespace

std::optional<Phrase> remark_on(const Study& study) {
  if (!is_looked_at(study)) {
    return phrase("Analysis",
                  "The file study.sqlite is larger than 1 GiB, so its checksum was not compared. "
                  "Run \"asperity verify\" to check the study.");
  }
  switch (study.condition()) {
    case StudyCondition::whole:
    case StudyCondition::broken:
      return {};
    case StudyCondition::changed:
      return phrase(
          "Analysis",
          "The file study.sqlite has changed since Asperity last closed it: data read from it may "
          "be incorrect. Run \"asperity verify\" to list the errors and their possible causes.");
  }
  return {};
}

void refuse_if_broken(const Study& study) {
  if (!is_looked_at(study) || study.condition() != StudyCondition::broken) return;
  const std::string folder = study.folder().string();
  throw ResultsError("the study " + folder +
                         " is damaged: SQLite found errors in its study.sqlite, and rows may be "
                         "incorrect or missing. Run \"asperity verify " +
                         folder + "\" to list the errors, and restore the study from a copy",
                     study.folder());
}

void read_unless_broken(const Study& study, const std::function<void()>& read,
                        const std::stop_token& stop) {
  if (is_looked_at(study)) study.begin_condition();
  try {
    read();
  } catch (const std::exception& error) {
    if (stop.stop_requested()) throw;
    refuse_if_broken(study);
    const std::optional<Phrase> remark = remark_on(study);
    if (!remark) throw;
    throw ResultsError(message_of(error) + (". " + remark->english()), study.folder());
  }
  if (!stop.stop_requested()) refuse_if_broken(study);
}

}  // namespace asperity
