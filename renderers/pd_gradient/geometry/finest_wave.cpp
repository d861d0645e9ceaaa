// Implements the analysis of a texture's finest waves.

#include "renderers/pd_gradient/geometry/finest_wave.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace asperity {
namespace {

constexpr double kLeastSlope = 0.005;  // changes the direction of a force by 0.3°
constexpr double kMostDrawnOut = 1e6;  // at a greater aspect ratio there is no perceptible relief

/// A step between texels of a face, in columns and rows and on the surface.
struct Chord {
  long long columns = 0;
  long long rows = 0;
  glm::dvec3 way_m{0.0};
};

Chord difference(const Chord& one, const Chord& other, double times = 1.0) {
  const auto whole = static_cast<long long>(times);
  return {one.columns - whole * other.columns, one.rows - whole * other.rows,
          one.way_m - times * other.way_m};
}

/// The shortest steps between texels of a face (Lagrange's lattice reduction), at 60° to 90° to each other, the shorter
/// one first.
std::pair<Chord, Chord> shortest(Chord a, Chord b) {
  constexpr int kMostSteps = 64;
  for (int step = 0; step < kMostSteps; ++step) {
    if (glm::dot(a.way_m, a.way_m) > glm::dot(b.way_m, b.way_m)) std::swap(a, b);
    const double times =
        std::round(glm::dot(a.way_m, b.way_m) / std::max(1e-300, glm::dot(a.way_m, a.way_m)));
    if (times == 0.0 || !(std::abs(times) < 1e9)) break;
    b = difference(b, a, times);
  }
  if (glm::dot(a.way_m, b.way_m) < 0.0) b = difference({}, b);
  return {a, b};
}

Chord times(const Chord& chord, long long factor) {
  return {chord.columns * factor, chord.rows * factor, static_cast<double>(factor) * chord.way_m};
}

/// The texels within a face, row by row.
class FaceTexels final {
 public:
  struct Span {
    long long first = 0;
    long long last = -1;
  };

  FaceTexels(const std::array<glm::dvec2, 3>& places, const DisplacementAtlas& atlas)
      : atlas_(atlas) {
    constexpr double kRounding = 1e-9;
    const auto [low, high] = std::minmax({places[0].y, places[1].y, places[2].y});
    first_row_ = std::max(0LL, std::llround(std::ceil(low - kRounding)));
    const long long last_row = std::min(static_cast<long long>(atlas.rows) - 1,
                                        std::llround(std::floor(high + kRounding)));
    for (long long row = first_row_; row <= last_row; ++row) {
      const auto y = static_cast<double>(row);
      double left = std::numeric_limits<double>::infinity();
      double right = -left;
      for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2& from = places[i];
        const glm::dvec2& to = places[(i + 1) % 3];
        if (std::abs(from.y - y) <= kRounding) {
          left = std::min(left, from.x);
          right = std::max(right, from.x);
        }
        if ((from.y - y) * (to.y - y) >= 0.0) continue;
        const double x = from.x + (to.x - from.x) * (y - from.y) / (to.y - from.y);
        left = std::min(left, x);
        right = std::max(right, x);
      }
      if (!(left <= right)) left = right = -1.0;
      spans_.push_back({std::max(0LL, std::llround(std::ceil(left - kRounding))),
                        std::min(static_cast<long long>(atlas.columns) - 1,
                                 std::llround(std::floor(right + kRounding)))});
    }
  }

  /// The covariances of the second differences h(x + ℓ) − 2 h(x) + h(x − ℓ) along three chords at one position, in
  /// counts², corrected for the rounding to counts.
  struct Bends {
    long long places = 0;
    std::array<std::array<double, 3>, 3> covariances{};
  };
  Bends bends(const std::array<Chord, 3>& chords, long long stride) const {
    Bends bends{};
    std::array<double, 3> sums{};
    const auto count = static_cast<long long>(spans_.size());
    for (long long row = 0; row < count; row += stride) {
      Span within = span(row);
      bool is_room = true;
      for (const Chord& chord : chords) {
        const long long above = row - chord.rows;
        const long long below = row + chord.rows;
        is_room = is_room && std::min(above, below) >= 0 && std::max(above, below) < count;
        if (!is_room) break;
        within.first = std::max(
            {within.first, span(above).first + chord.columns, span(below).first - chord.columns});
        within.last = std::min(
            {within.last, span(above).last + chord.columns, span(below).last - chord.columns});
      }
      if (!is_room) continue;
      for (long long column = within.first; column <= within.last; column += stride) {
        std::array<double, 3> bend{};
        for (std::size_t i = 0; i < 3; ++i) {
          const Chord& chord = chords[i];
          bend[i] = values(row + chord.rows)[column + chord.columns] - 2 * values(row)[column] +
                    values(row - chord.rows)[column - chord.columns];
        }
        for (std::size_t i = 0; i < 3; ++i) {
          sums[i] += bend[i];
          for (std::size_t j = 0; j <= i; ++j) bends.covariances[i][j] += bend[i] * bend[j];
        }
        ++bends.places;
      }
    }
    if (bends.places == 0) return bends;
    const auto places = static_cast<double>(bends.places);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        // The variance is steps²/12 for each value: 1 + 4 + 1, of which different chords share the 4.
        const double of_rounding = (i == j ? 6.0 : 4.0) / 12.0;
        bends.covariances[i][j] =
            bends.covariances[i][j] / places - sums[i] / places * (sums[j] / places) - of_rounding;
        bends.covariances[j][i] = bends.covariances[i][j];
      }
    }
    return bends;
  }

  /// The mean square of h(x + ℓ) − h(x) in counts², corrected for rounding.
  double steps(const Chord& chord) const {
    const auto count = static_cast<long long>(spans_.size());
    long long places = 0;
    double squares = 0.0;
    for (long long row = std::max(0LL, -chord.rows); row + std::max(0LL, chord.rows) < count;
         ++row) {
      const Span& here = span(row);
      const Span& there = span(row + chord.rows);
      const long long last = std::min(here.last, there.last - chord.columns);
      for (long long column = std::max(here.first, there.first - chord.columns); column <= last;
           ++column) {
        const double step = values(row + chord.rows)[column + chord.columns] - values(row)[column];
        squares += step * step;
        ++places;
      }
    }
    constexpr double kOfRounding = 2.0 / 12.0;
    return places == 0 ? 0.0 : std::max(0.0, squares / static_cast<double>(places) - kOfRounding);
  }

 private:
  const Span& span(long long row) const { return spans_[static_cast<std::size_t>(row)]; }
  const std::int16_t* values(long long row) const {
    return atlas_.values.data() + static_cast<std::size_t>(first_row_ + row) * atlas_.columns;
  }

  const DisplacementAtlas& atlas_;
  long long first_row_ = 0;
  std::vector<Span> spans_{};
};

/// Slope² times area that is lost when chords grow from `from_m` to twice that length.
struct Loss {
  double from_m = 0.0;
  double slope_m2 = 0.0;
  double least = 1.0;  ///< chords in `from_m` at which it begins: 0 if unknown below
};

// Proportional to the square of the length; the loss up to ℓ is then a third of the loss from there to 2ℓ.
double lost_m2(const Loss& loss, double chord_m) {
  const double part = std::clamp(chord_m / loss.from_m, loss.least, 2.0);
  return loss.slope_m2 / 3.0 * (part * part - loss.least * loss.least);
}

/// Slope² times area of a relief, and the part of it that chords lose.
struct Slopes {
  double all_m2 = 0.0;
  double area_m2 = 0.0;  ///< of the faces with a relief
  std::vector<Loss> losses{};
};

/// Along the two shortest steps between texels, and across: |∇h|² = Σ cot·Δh²/(2·area) over the sides of a triangle,
/// each with the cotangent of the opposite angle.
double slope2(const FaceTexels& texels, const Chord& a, const Chord& b) {
  const double doubled_m2 = glm::length(glm::cross(a.way_m, b.way_m));
  const double across_m2 = glm::dot(a.way_m, b.way_m);
  const std::array<double, 3> weights_m2{glm::dot(b.way_m, b.way_m) - across_m2,
                                         glm::dot(a.way_m, a.way_m) - across_m2, across_m2};
  const std::array<Chord, 3> chords{a, b, difference(a, b)};
  double sum_m2 = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (weights_m2[i] > 0.0) sum_m2 += weights_m2[i] * texels.steps(chords[i]);
  }
  return sum_m2 / (doubled_m2 * doubled_m2);
}

/// ∇∇h|² = tr(G⁻¹HG⁻¹H), with G the scalar products of two chords and H the second differences along them.
double bend2_per_m2(const FaceTexels::Bends& bends, const Chord& a, const Chord& b) {
  const double aa = glm::dot(a.way_m, a.way_m);
  const double ab = glm::dot(a.way_m, b.way_m);
  const double bb = glm::dot(b.way_m, b.way_m);
  const double determinant = aa * bb - ab * ab;
  const auto& of = bends.covariances;
  // H_ab is (H_aa + H_bb − H_cc)/2 with c = a − b.
  const auto with_ab = [&](std::size_t i) { return 0.5 * (of[i][0] + of[i][1] - of[i][2]); };
  const double ab_ab = 0.5 * (with_ab(0) + with_ab(1) - with_ab(2));
  // G⁻¹H is this divided by the determinant: [bb·Haa − ab·Hab, bb·Hab − ab·Hbb; aa·Hab − ab·Haa, aa·Hbb − ab·Hab].
  const double diagonal = bb * bb * of[0][0] + aa * aa * of[1][1] + 2.0 * ab * ab * ab_ab -
                          2.0 * ab * (bb * with_ab(0) + aa * with_ab(1));
  const double others =
      aa * bb * ab_ab - ab * bb * with_ab(0) - ab * aa * with_ab(1) + ab * ab * of[0][1];
  return (diagonal + 2.0 * others) / (determinant * determinant);
}

void add(Slopes& slopes, const FaceTexels& texels, const std::pair<Chord, Chord>& ways,
         double step_m, double area_m2) {
  const auto& [a, b] = ways;
  const double first_m = glm::length(a.way_m);
  if (!(glm::length(b.way_m) < kMostDrawnOut * first_m)) return;
  const double face_slope2 = step_m * step_m * slope2(texels, a, b);
  if (!(face_slope2 > kLeastSlope * kLeastSlope)) return;
  slopes.all_m2 += face_slope2 * area_m2;
  slopes.area_m2 += area_m2;
  // Chords of nearly equal length along both; below this length only the shorter step is known.
  long long ratio = 1;
  while (1.5 * static_cast<double>(ratio) * first_m < glm::length(b.way_m)) ratio *= 2;
  const auto add_loss = [&](double from_m, double least, double slope2_of_counts) {
    const double slope_m2 = step_m * step_m * slope2_of_counts * area_m2;
    if (!(slope_m2 > 0.0)) return;
    slopes.losses.push_back({.from_m = from_m, .slope_m2 = slope_m2, .least = least});
  };
  const auto stride = [](long long length) { return std::max(1LL, length / 4); };
  for (long long length = 1; length < ratio; length *= 2) {
    const Chord chord = times(a, length);
    const FaceTexels::Bends bends = texels.bends({chord, chord, chord}, stride(length));
    const double chord_m = static_cast<double>(length) * first_m;
    add_loss(chord_m, length == 1 ? 0.0 : 1.0, bends.covariances[0][0] / (4.0 * chord_m * chord_m));
  }
  for (long long length = 1;; length *= 2) {
    const Chord along = times(a, length * ratio);
    const Chord aside = times(b, length);
    const FaceTexels::Bends bends =
        texels.bends({along, aside, difference(along, aside)}, stride(length));
    if (bends.places == 0) break;
    const double chord_m2 = glm::length(along.way_m) * glm::length(aside.way_m);
    add_loss(std::sqrt(chord_m2), ratio == 1 && length == 1 ? 0.0 : 1.0,
             0.25 * chord_m2 * bend2_per_m2(bends, along, aside));
  }
}

double sum_m2(const std::vector<Loss>& losses, double chord_m) {
  double sum = 0.0;
  for (const Loss& loss : losses) sum += lost_m2(loss, chord_m);
  return sum;
}

}  // namespace

FineWaves fine_waves_of(const TexturedMesh& mesh, double gain) {
  Slopes slopes{};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const glm::dvec3 along_m = mesh.vertices_m[b] - mesh.vertices_m[a];
    const glm::dvec3 aside_m = mesh.vertices_m[c] - mesh.vertices_m[a];
    const double face_m2 = 0.5 * glm::length(glm::cross(along_m, aside_m));
    const auto& places = mesh.places[i];
    const glm::dvec2 along = places[1] - places[0];
    const glm::dvec2 aside = places[2] - places[0];
    const double determinant = along.x * aside.y - along.y * aside.x;
    if (!(face_m2 > 0.0) || !(std::abs(determinant) > 0.0)) continue;
    const auto ways =
        shortest({.columns = 1, .way_m = (aside.y * along_m - along.y * aside_m) / determinant},
                 {.rows = 1, .way_m = (along.x * aside_m - aside.x * along_m) / determinant});
    add(slopes, FaceTexels(places, mesh.atlas), ways, gain * mesh.atlas.step_m, face_m2);
  }
  constexpr double kWaves = 8.0;
  const double phase = std::numbers::pi / kWaves;
  const double share = 1.0 - std::pow(std::sin(phase) / phase, 2.0);
  const double wanted_m2 =
      std::max(share * slopes.all_m2, kLeastSlope * kLeastSlope * slopes.area_m2);
  double long_m = 0.0;
  for (const Loss& loss : slopes.losses) long_m = std::max(long_m, 2.0 * loss.from_m);
  if (!(sum_m2(slopes.losses, long_m) > wanted_m2)) {
    return {.finest_m = std::numeric_limits<double>::infinity(), .crest_per_m = 0.0};
  }
  double short_m = 0.0;
  constexpr double kNear = 1e-3;
  while (long_m - short_m > kNear * long_m) {
    const double between_m = 0.5 * (short_m + long_m);
    (sum_m2(slopes.losses, between_m) < wanted_m2 ? short_m : long_m) = between_m;
  }
  const double finest_m = kWaves * long_m;
  return {.finest_m = finest_m,
          .crest_per_m =
              2.0 * std::numbers::pi / finest_m * std::sqrt(2.0 * slopes.all_m2 / slopes.area_m2)};
}

double finest_wave_m(const TexturedMesh& mesh, double gain) {
  return fine_waves_of(mesh, gain).finest_m;
}

}  // namespace asperity
