// Writes a report as one HTML file.

#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "app/report/text/report.h"

namespace asperity {

/// HTML5 that is also well-formed XML, with embedded style sheet and figures (SVG): it requires no
/// network, runs no script and is printable. Tables have headings for screen readers, figures a
/// text alternative. The same report gives the same bytes.
///
/// Requires a Qt application (LettersWithoutWindows, where there is no other). After a stop
/// request, returns the part that is finished.
std::string html_of(const Report& report, const std::stop_token& stop = {},
                    const std::function<void(double)>& progress = {});

}  // namespace asperity
