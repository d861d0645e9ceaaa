#include "app/study_metadata.h"

namespace asperity {

std::optional<Phrase> missing_metadata(const StudyMetadata& metadata) {
  if (metadata.authors.empty() && !metadata.license) {
    return phrase("StudyMetadata",
                  "The study states neither authors nor a license, which data archives require.");
  }
  if (metadata.authors.empty()) {
    return phrase("StudyMetadata", "The study states no authors, which data archives require.");
  }
  if (!metadata.license) {
    return phrase("StudyMetadata", "The study states no license, which data archives require.");
  }
  return std::nullopt;
}

}  // namespace asperity
