// The demo study with people in it: sessions of every state, a broken protocol, notes.

#pragma once

#include <filesystem>

namespace asperity {

/// Adds to the study: P001 to P012 with sessions of chapter_recognition (complete but for P004, who
/// was stopped, and P012, who was interrupted), a pilot session of P002, two simulated ones, and the
/// protocol file "broken.json" with two problems.
void fill_with_participants(const std::filesystem::path& study);

}  // namespace asperity
