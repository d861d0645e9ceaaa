// Recorded speech, read from a WAV file.

#pragma once

#include <filesystem>

#include "app/session/sound/masking_sound.h"

namespace asperity {

/// A WAV file of one or two channels in 16-bit PCM; two are averaged.
///
/// Errors: std::runtime_error, a sentence with the file's name, for a file that cannot be read or is
/// of another form, or longer than 30 s.
CueRecording read_speech(const std::filesystem::path& file);

}  // namespace asperity
