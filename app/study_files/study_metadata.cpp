// Lists the missing items in one phrase.

#include "app/study_files/study_metadata.h"

namespace asperity {

std::optional<Phrase> missing_metadata(const StudyMetadata& metadata) {
  if (metadata.authors.empty() && !metadata.license) {
    return phrase("StudyMetadata",
                  "The study has neither authors nor a licence; data archives require both.");
  }
  if (metadata.authors.empty()) {
    return phrase("StudyMetadata", "The study has no authors; data archives require them.");
  }
  if (!metadata.license) {
    return phrase("StudyMetadata", "The study has no licence; data archives require one.");
  }
  return std::nullopt;
}

}  // namespace asperity
