// A report as one HTML file.

#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "app/report/text/report.h"

namespace asperity {

/// HTML5 that is well-formed XML as well, with its style sheet and its figures (SVG) in it: it needs
/// no network, runs no script and prints as it reads. Tables have headings that a screen reader can
/// follow, figures their words. The same report gives the same bytes.
///
/// Where there is an application of Qt (LettersWithoutWindows, where there is no other). When asked
/// to stop, what there is by then.
std::string html_of(const Report& report, const std::stop_token& stop = {},
                    const std::function<void(double)>& progress = {});

}  // namespace asperity
