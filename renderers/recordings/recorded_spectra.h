// Declares the spectra of a recorded texture at each of its speeds, and between them.

#pragma once

#include <cstddef>
#include <vector>

#include "renderers/recordings/even_stroke.h"
#include "renderers/recordings/texture_recording.h"

namespace asperity {

/// One-sided amplitude spectra of a texture at the speeds of its recording.
///
/// Line k = 1 … `lines` is a wave of the frequency k·`spacing`, in 1/m or Hz, with the amplitude A_k, in newtons at a
/// normal force of 1 N: half of its square is the mean square of the force in the band (k ± ½)·`spacing`, divided by
/// N^2β with N the mean normal force of the stroke and β the exponent. Each stroke is resampled in equal steps of the
/// path (or of time) and its trend removed; the mean square of the bands is that of its transform without a window
/// (Parseval), each line of which is spread evenly over its width. `spacing` is 1/(the shortest stroke), or wider so
/// that there are at most 4096 lines: the finest resolution that all strokes have. Strokes whose speeds differ by less
/// than 10 % are one speed, with the mean of their mean squares.
///
/// A speed covers the bands from half of 1/(its shortest stroke) to 0.45 of its lowest sampling rate, both on the axis.
///
/// Errors: std::invalid_argument of require_strokes.
class RecordedSpectra final {
 public:
  RecordedSpectra(const TextureRecording& recording, SpectrumAxis axis, double force_exponent);

  double spacing() const noexcept { return spacing_; }
  std::size_t lines() const noexcept { return lines_; }
  /// In increasing order.
  const std::vector<double>& speeds_m_per_s() const noexcept { return speeds_m_per_s_; }

  /// A_1 … A_lines at a speed: the logarithm of each is linear in the logarithm of the speed between the two next speeds that
  /// cover the line, and that of the nearest one beyond them.
  std::vector<double> amplitudes_at(double speed_m_per_s) const;

  /// The frequency below which 99 % of the mean square is, all speeds taken together.
  double band() const noexcept;

 private:
  struct Speed {
    std::vector<double> amplitude{};
    std::size_t first = 0;  ///< of the covered lines, from 0
    std::size_t end = 0;
  };

  double spacing_ = 0.0;
  std::size_t lines_ = 0;
  std::vector<double> speeds_m_per_s_{};
  std::vector<Speed> speeds_{};
};

}  // namespace asperity
