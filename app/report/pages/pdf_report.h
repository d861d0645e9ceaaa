// Writes a report as a PDF for print.

#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "app/report/text/report.h"

namespace asperity {

/// A4, with the pages of report_pages.h: text as characters (with embedded fonts), figures as
/// vectors. Requires a Qt application (LettersWithoutWindows, where there is no other). After a
/// stop request, returns the part that is finished.
std::string pdf_of(const Report& report, const std::stop_token& stop = {},
                   const std::function<void(double)>& progress = {});

}  // namespace asperity
