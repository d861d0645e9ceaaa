// Chooses the form by the extension of the file, and replaces the file at once.

#include "app/report/pages/report_file.h"

#include <stdexcept>
#include <system_error>
#include <unistd.h>
#include <vector>

#include "app/report/pages/html_report.h"
#include "app/report/pages/pdf_report.h"
#include "app/report/text/study_report.h"

namespace asperity {

namespace {

// The proportion of the total time with few responses and many pages.
constexpr double kReadingShare = 0.5;

bool is_pdf(const std::filesystem::path& path) {
  if (path.extension() == ".pdf") return true;
  if (path.extension() == ".html") return false;
  throw std::invalid_argument("the report \"" + path.string() +
                              "\" cannot be written; its name must end in .pdf or .html");
}

}  // namespace

void require_report_path(const std::filesystem::path& path, Overwrite overwrite) {
  is_pdf(path);
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code error{};
  if (!std::filesystem::is_directory(folder, error)) {
    throw ResultsError("there is no folder " + folder.string() + " for " +
                           path.filename().string() + "; create it first, or choose another folder",
                       path);
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    throw ResultsError("no file can be written to the folder " + folder.string() +
                           ": permission denied; choose another folder, or correct its permissions",
                       path);
  }
  if (std::filesystem::is_directory(path, error)) {
    throw ResultsError(path.string() + " is a folder; choose the name of a file", path);
  }
  if (overwrite == Overwrite::refuse && std::filesystem::exists(path, error)) {
    throw ResultsError("the file " + path.string() +
                           " already exists; choose another name, or replace it with --force",
                       path);
  }
}

bool write_report(const Study& study, const std::filesystem::path& path, Overwrite overwrite,
                  const std::optional<std::string>& protocol, const std::stop_token& stop,
                  const std::function<void(double)>& progress) {
  require_report_path(path, overwrite);
  const auto told = [&progress](double from, double to) {
    return [&progress, from, to](double fraction) {
      if (progress) progress(from + (to - from) * fraction);
    };
  };
  const Report report = study_report(study, protocol, stop, told(0.0, kReadingShare));
  const std::string bytes = is_pdf(path) ? pdf_of(report, stop, told(kReadingShare, 1.0))
                                         : html_of(report, stop, told(kReadingShare, 1.0));
  if (stop.stop_requested()) return false;
  write_file(path, bytes, overwrite);
  return true;
}

}  // namespace asperity
