// Whether the path of an output names a participant.

#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// Whether a folder or the file of `path` has the label as its whole name, or the name of the file contains it between
/// characters that are neither letters nor digits, in any letter case: "/out/p013/tables" and "/out/report-P013.html" name
/// P013; "/out/P0135.html", "/out/reportP013.html" and "/study P013/tables" do not. A label such as "1" would be found in nearly
/// every path otherwise. `label` consists of ASCII letters and digits; other bytes than ASCII belong to letters.
bool names_label(std::string_view path, std::string_view label) noexcept;

}  // namespace asperity
