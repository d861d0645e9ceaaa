// Declares recordings of the force of a texture on a stroking hand or probe, and their file.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// One stroke over a texture at a nearly constant speed and normal force: four columns of equal length.
struct RecordedStroke {
  std::vector<double> time_s{};    ///< increases
  std::vector<double> path_m{};    ///< the length of the path; does not decrease
  std::vector<double> normal_N{};  ///< the normal force
  /// The component of the force that carries the texture: along the path, positive against the motion, or along the
  /// normal. Its mean and its trend are not part of the texture.
  std::vector<double> force_N{};

  /// The path divided by the time.
  double speed_m_per_s() const;
  double mean_normal_N() const;
};

/// A texture as its forces on strokes, in any order. Strokes at different speeds show what changes with the speed.
struct TextureRecording {
  std::vector<RecordedStroke> strokes{};
};

/// The fewest samples of a stroke.
inline constexpr std::size_t kFewestSamplesOfStroke = 64;

/// The shortest path and the fewest samples from which a spectrum can be computed, numbers that are finite and in order,
/// and a normal force above 0 on average.
///
/// Errors: std::invalid_argument that begins with `name`, with the stroke (from 1) and the correction.
void require_strokes(const TextureRecording& recording, const std::string& name);

/// The strokes whose speed or normal force is not nearly constant: in one of ten equal parts its mean deviates by more than
/// kMostUneven from that of the stroke. Their spectra mix conditions that a model keeps apart. One sentence each, with the
/// stroke (from 1), the range and the correction. The recording fulfils require_strokes.
inline constexpr double kMostUneven = 0.2;
std::vector<std::string> uneven_strokes(const TextureRecording& recording);

/// Reads a table with the columns `stroke time_s path_m normal_force_N force_N` in any order and tab-separated
/// (docs/formats/texture_recording.md); `name` names it in messages. The rows of a stroke stand together.
///
/// Errors: std::invalid_argument that begins with `name` and the line, for columns that are missing or unknown, cells that
/// are not finite numbers and a stroke in two places; as require_strokes.
TextureRecording texture_recording_in(std::string_view tsv, const std::string& name);

/// The table of a recording, in the fewest digits that give the same numbers when read.
std::string tsv_of(const TextureRecording& recording);

}  // namespace asperity
