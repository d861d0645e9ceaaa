// A report as a PDF for print.

#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "app/report/text/report.h"

namespace asperity {

/// A4, with the pages of report_pages.h: letters as letters (the fonts are in it), figures as
/// vectors. Where there is an application of Qt (LettersWithoutWindows, where there is no other).
/// When asked to stop, what there is by then.
std::string pdf_of(const Report& report, const std::stop_token& stop = {},
                   const std::function<void(double)>& progress = {});

}  // namespace asperity
