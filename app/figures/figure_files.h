// Writes figures as files: SVG and PDF as vectors, PNG with 300 dots per inch, in light colours.

#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/findings/outcome/figure.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

/// The width of one column of a journal, and of two.
inline constexpr double kColumnWidth_mm = 85.0;
inline constexpr double kPageWidth_mm = 170.0;

struct FigurePrint {
  double width_mm = kPageWidth_mm;
  Phrase::LookUp look_up{};  ///< the language; empty: English
};

/// The bytes of the file. The same figure gives the same bytes: no dates, no random names. Any
/// thread; requires a Qt application (LettersWithoutWindows, where there is no other).
std::string svg_of(const Figure& figure, const FigurePrint& print = {});
std::string png_of(const Figure& figure, const FigurePrint& print = {});
std::string pdf_of(const Figure& figure, const FigurePrint& print = {});

/// Checks a path before there is a figure. Errors: std::invalid_argument for an extension other
/// than .svg, .png or .pdf.
void require_figure_ending(const std::filesystem::path& path);
/// The bytes of the file in the format of that extension. Errors: those of require_figure_ending.
std::string figure_bytes(const std::filesystem::path& path, const Figure& figure,
                         const FigurePrint& print = {});
/// Writes them to the file. Errors: those of require_figure_ending and write_file.
void write_figure(const std::filesystem::path& path, const Figure& figure, const FigurePrint& print,
                  Overwrite overwrite);

/// Lets a program without windows draw: Qt has no fonts without an application. Requires no screen.
/// One at a time, on the main thread, and not together with a QApplication.
class LettersWithoutWindows final {
 public:
  LettersWithoutWindows();
  ~LettersWithoutWindows();
  LettersWithoutWindows(const LettersWithoutWindows&) = delete;
  LettersWithoutWindows& operator=(const LettersWithoutWindows&) = delete;

 private:
  struct Application;
  std::unique_ptr<Application> application_;
};

}  // namespace asperity
