// Hashes lattice points to directions, and blends them with the derivative in closed form.

#include "renderers/force/gradient_noise.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace asperity {

namespace {

/// The finaliser of SplitMix64: every bit of the input changes every bit of the output with probability ½.
std::uint64_t mixed(std::uint64_t bits) noexcept {
  bits ^= bits >> 30;
  bits *= 0xbf58476d1ce4e5b9ULL;
  bits ^= bits >> 27;
  bits *= 0x94d049bb133111ebULL;
  return bits ^ (bits >> 31);
}

const glm::dvec3& direction_of(std::uint64_t hash) noexcept {
  static constexpr std::array<glm::dvec3, 12> kEdges{{{1, 1, 0},
                                                      {-1, 1, 0},
                                                      {1, -1, 0},
                                                      {-1, -1, 0},
                                                      {1, 0, 1},
                                                      {-1, 0, 1},
                                                      {1, 0, -1},
                                                      {-1, 0, -1},
                                                      {0, 1, 1},
                                                      {0, -1, 1},
                                                      {0, 1, -1},
                                                      {0, -1, -1}}};
  return kEdges[((hash >> 32) * kEdges.size()) >> 32];
}

/// The weight S(t) of a corner at the distance t along an axis, and S′(t).
struct Fade {
  double weight = 0.0;
  double slope = 0.0;
};
Fade fade(double t) noexcept {
  return {.weight = 1.0 - t * t * t * (t * (6.0 * t - 15.0) + 10.0),
          .slope = -30.0 * t * t * (t * (t - 2.0) + 1.0)};
}

/// The weights of the two corners along an axis, with their derivatives by the coordinate.
struct AxisWeights {
  std::array<double, 2> weight{};
  std::array<double, 2> slope{};
};
AxisWeights weights_of(double fraction) noexcept {
  const Fade low = fade(fraction);
  return {.weight = {low.weight, 1.0 - low.weight}, .slope = {low.slope, -low.slope}};
}

}  // namespace

GradientNoise::GradientNoise(const Random& stream) noexcept : key_(Random(stream).bits()) {}

NoiseAtPlace GradientNoise::at(const glm::dvec3& place) const noexcept {
  constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ULL;
  const glm::dvec3 corner(std::floor(place.x), std::floor(place.y), std::floor(place.z));
  const glm::dvec3 fraction = place - corner;
  const AxisWeights along_x = weights_of(fraction.x);
  const AxisWeights along_y = weights_of(fraction.y);
  const AxisWeights along_z = weights_of(fraction.z);
  const auto first = [](double whole) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(whole));
  };
  NoiseAtPlace noise{};
  for (std::uint64_t i = 0; i < 2; ++i) {
    const std::uint64_t of_x = mixed(key_ + (first(corner.x) + i) * kStep);
    for (std::uint64_t j = 0; j < 2; ++j) {
      const std::uint64_t of_y = mixed(of_x + (first(corner.y) + j) * kStep);
      for (std::uint64_t k = 0; k < 2; ++k) {
        const glm::dvec3& g = direction_of(mixed(of_y + (first(corner.z) + k) * kStep));
        const glm::dvec3 d = fraction - glm::dvec3(static_cast<double>(i), static_cast<double>(j),
                                                   static_cast<double>(k));
        const double dot = glm::dot(g, d);
        const double x = along_x.weight[i];
        const double y = along_y.weight[j];
        const double z = along_z.weight[k];
        noise.value += x * y * z * dot;
        noise.gradient +=
            x * y * z * g + dot * glm::dvec3(along_x.slope[i] * y * z, x * along_y.slope[j] * z,
                                             x * y * along_z.slope[k]);
      }
    }
  }
  return noise;
}

}  // namespace asperity
