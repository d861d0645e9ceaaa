// Names the formats, and selects those of an export without options.

#include "app/exports/export_options.h"

namespace asperity {

const char* name_of(ExportFormat format) noexcept {
  switch (format) {
    case ExportFormat::wide:
      return "wide";
    case ExportFormat::sav:
      return "sav";
    case ExportFormat::bids:
      return "bids";
    case ExportFormat::psychds:
      return "psychds";
    case ExportFormat::physio:
      return "physio";
    case ExportFormat::stimuli:
      return "stimuli";
    case ExportFormat::fit:
      return "fit";
  }
  return "";
}

std::set<ExportFormat> usual_export_formats() {
  return {ExportFormat::wide,    ExportFormat::sav,     ExportFormat::bids,
          ExportFormat::psychds, ExportFormat::stimuli, ExportFormat::fit};
}

}  // namespace asperity
