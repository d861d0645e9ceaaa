// Embeds the scripts that load an export into R and Python: import.R and import.py of this folder.

#pragma once

#include <string_view>

namespace asperity {

std::string_view import_script_for_r() noexcept;
std::string_view import_script_for_python() noexcept;

}  // namespace asperity
