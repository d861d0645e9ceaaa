// Figures as files: SVG and PDF of vectors, PNG of 300 points per inch, light.

#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/findings/figure.h"
#include "results_schema/atomic_file.h"

namespace asperity {

/// One column of a journal, and both.
inline constexpr double kColumnWidth_mm = 85.0;
inline constexpr double kPageWidth_mm = 170.0;

struct FigurePrint {
  double width_mm = kPageWidth_mm;
  Phrase::LookUp look_up{};  ///< the language; empty: English
};

/// The bytes of the file. The same figure gives the same bytes: no dates, no random names. Any
/// thread, where there is an application of Qt (LettersWithoutWindows, where there is no other).
std::string svg_of(const Figure& figure, const FigurePrint& print = {});
std::string png_of(const Figure& figure, const FigurePrint& print = {});
std::string pdf_of(const Figure& figure, const FigurePrint& print = {});

/// The same into a file. Errors: as write_file.
void write_svg(const std::filesystem::path& path, const Figure& figure, const FigurePrint& print,
               Overwrite overwrite);
void write_png(const std::filesystem::path& path, const Figure& figure, const FigurePrint& print,
               Overwrite overwrite);
void write_pdf(const std::filesystem::path& path, const Figure& figure, const FigurePrint& print,
               Overwrite overwrite);
/// Before there is a figure. Errors: std::invalid_argument for an ending that is not .svg, .png or .pdf.
void require_figure_ending(const std::filesystem::path& path);
/// By that ending. Errors: as both.
void write_figure(const std::filesystem::path& path, const Figure& figure, const FigurePrint& print,
                  Overwrite overwrite);

/// Lets a program without windows draw: Qt knows no letters without an application. Needs no screen.
/// One at a time, on the main thread, and none where a QApplication is.
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
