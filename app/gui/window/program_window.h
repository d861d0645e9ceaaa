// The program with windows, from the start to the last window closed.

#pragma once

#include <filesystem>
#include <optional>

namespace asperity {

/// Shows the study, or the welcome page without one, and returns the exit status when the window is
/// closed. Numbers are read and written with a point throughout, whatever the person's locale.
///
/// Errors: std::runtime_error, a sentence, where there is no screen to show a window on.
int run_windows(int& argc, char** argv, const std::optional<std::filesystem::path>& study);

}  // namespace asperity
