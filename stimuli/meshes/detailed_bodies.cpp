// Turns or extrudes outlines with random relief, in as many rows as the number of triangles requires.

#include "stimuli/meshes/detailed_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>

#include "analysis/numbers/random.h"

namespace asperity {

namespace {

constexpr std::size_t kUsual = 300'000;
// The bodies have whole rows of triangles; these give the numbers of [Otaduy 2004] to three digits.
constexpr std::array kBodies{
    DetailedBody{"block", kUsual, 500},     DetailedBody{"ball", kUsual, 600},
    DetailedBody{"ten_balls", kUsual, 750}, DetailedBody{"wide_block", kUsual, 500},
    DetailedBody{"hammer", 434'400, 518},   DetailedBody{"file", 285'800, 632},
    DetailedBody{"part", 659'000, 720},     DetailedBody{"comb", kUsual, 600},
    DetailedBody{"ribs", kUsual, 600}};
constexpr std::size_t kFewest = 1000;

RandomWaves waves(std::uint64_t seed) { return RandomWaves({.seed = seed}); }

double smooth_step(double from, double to, double at) {
  const double share = std::clamp((at - from) / (to - from), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

/// A body around the z axis, from pole to pole: point(s, φ), s in [0, 1] from the lower pole.
template <typename Point>
TriangleMesh turned_body(std::size_t rows, std::size_t around, const Point& point) {
  TriangleMesh mesh;
  mesh.vertices_m.push_back(point(0.0, 0.0));
  for (std::size_t row = 1; row < rows; ++row) {
    for (std::size_t i = 0; i < around; ++i) {
      mesh.vertices_m.push_back(
          point(static_cast<double>(row) / static_cast<double>(rows),
                2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around)));
    }
  }
  mesh.vertices_m.push_back(point(1.0, 0.0));
  const auto top = static_cast<std::uint32_t>(mesh.vertices_m.size() - 1);
  const auto at = [around](std::size_t row, std::size_t i) {
    return static_cast<std::uint32_t>(1 + (row - 1) * around + i % around);
  };
  for (std::size_t i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, at(1, i + 1), at(1, i)});
    for (std::size_t row = 1; row + 1 < rows; ++row) {
      mesh.triangles.push_back({at(row, i), at(row, i + 1), at(row + 1, i + 1)});
      mesh.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row + 1, i)});
    }
    mesh.triangles.push_back({at(rows - 1, i), at(rows - 1, i + 1), top});
  }
  return mesh;
}

/// About the origin.
TriangleMesh rough_ball(double radius_m, const Relief& relief, std::size_t triangles) {
  const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 4.0));
  return turned_body(rows, 2 * rows, [&](double s, double angle_rad) {
    const double latitude_rad = std::numbers::pi * (s - 0.5);
    const glm::dvec3 out{std::cos(latitude_rad) * std::cos(angle_rad),
                         std::cos(latitude_rad) * std::sin(angle_rad), std::sin(latitude_rad)};
    return (radius_m + relief(radius_m * out)) * out;
  });
}

struct HalfWidths {
  double x_m = 0.0;
  double y_m = 0.0;
};

/// With the z axis through its middle and superellipses across, half as wide as half_widths(z) states, with rounded ends.
template <typename Widths>
TriangleMesh long_body(double length_m, const Widths& half_widths, const Relief& relief,
                       std::size_t triangles) {
  constexpr double kRoundness = 4.0;  // 2: an ellipse
  const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 2.0));
  return turned_body(rows, rows, [&](double s, double angle_rad) {
    // Equal steps along the sides, and over the ends.
    const double z_m = length_m * (s - 0.5);
    const double from_end = 1.0 - std::pow(std::abs(2.0 * s - 1.0), 24.0);
    const HalfWidths half = half_widths(z_m);
    const double cosine = std::cos(angle_rad);
    const double sine = std::sin(angle_rad);
    const double round =
        std::pow(std::pow(std::abs(cosine), kRoundness) + std::pow(std::abs(sine), kRoundness),
                 -1.0 / kRoundness);
    const glm::dvec3 plain{half.x_m * round * cosine * from_end, half.y_m * round * sine * from_end,
                           z_m};
    const glm::dvec3 out{cosine / half.x_m, sine / half.y_m, 0.0};
    return plain + relief(plain) * from_end * glm::normalize(out);
  });
}

/// Looks up, its upper side about z = 0; as many triangles below, in a plane.
TriangleMesh rough_block(double size_m, const Relief& relief, std::size_t triangles) {
  const auto cells = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 4.0));
  const std::size_t side = cells + 1;
  TriangleMesh mesh;
  for (const bool upper : {true, false}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
    const auto at = [&](std::size_t row, std::size_t column) {
      return static_cast<std::uint32_t>(first + row * side + column);
    };
    for (std::size_t i = 0; i < side * side; ++i) {
      const auto place = [&](std::size_t k) {
        return size_m * (static_cast<double>(k) / static_cast<double>(cells) - 0.5);
      };
      const glm::dvec3 plain{place(i % side), place(i / side), 0.0};
      mesh.vertices_m.push_back({plain.x, plain.y, upper ? relief(plain) : -0.2 * size_m});
    }
    for (std::size_t row = 0; row < cells; ++row) {
      for (std::size_t column = 0; column < cells; ++column) {
        const std::array corners{at(row, column), at(row, column + 1), at(row + 1, column + 1),
                                 at(row + 1, column)};
        if (upper) {
          mesh.triangles.push_back({corners[0], corners[1], corners[2]});
          mesh.triangles.push_back({corners[0], corners[2], corners[3]});
        } else {
          mesh.triangles.push_back({corners[0], corners[2], corners[1]});
          mesh.triangles.push_back({corners[0], corners[3], corners[2]});
        }
      }
    }
  }
  // Once around the upper rim, counter-clockwise from above.
  std::vector<std::uint32_t> rim;
  const auto last = static_cast<std::uint32_t>(cells);
  const auto across = static_cast<std::uint32_t>(side);
  for (std::uint32_t i = 0; i < last; ++i) rim.push_back(i);
  for (std::uint32_t i = 0; i < last; ++i) rim.push_back(i * across + last);
  for (std::uint32_t i = last; i > 0; --i) rim.push_back(last * across + i);
  for (std::uint32_t i = last; i > 0; --i) rim.push_back(i * across);
  const std::uint32_t below = across * across;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::uint32_t next = rim[(i + 1) % rim.size()];
    mesh.triangles.push_back({rim[i], rim[i] + below, next + below});
    mesh.triangles.push_back({rim[i], next + below, next});
  }
  return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& more, const glm::dvec3& at_m) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
  for (const glm::dvec3& vertex_m : more.vertices_m) mesh.vertices_m.push_back(vertex_m + at_m);
  for (const auto& [a, b, c] : more.triangles) {
    mesh.triangles.push_back({a + first, b + first, c + first});
  }
}

TriangleMesh ten_balls(std::size_t triangles) {
  TriangleMesh balls;
  for (int i = 0; i < 10; ++i) {
    append(balls, rough_ball(0.0035, waves(10 + static_cast<std::uint64_t>(i)), triangles / 10),
           {0.011 * (i % 5 - 2), 0.011 * (i / 5 - 0.5), 0.0});
  }
  return balls;
}

TriangleMesh comb(std::size_t triangles) {
  TriangleMesh teeth;
  for (int i = 0; i < 6; ++i) {
    append(teeth, rough_ball(0.002, waves(30 + static_cast<std::uint64_t>(i)), triangles / 6),
           {0.0035 * (i - 2.5), 0.0, 0.2e-3 * (i % 3)});
  }
  return teeth;
}

TriangleMesh hammer(std::size_t triangles) {
  const auto head_on_handle = [](double z_m) {
    const double head = smooth_step(0.025, 0.032, z_m);
    return HalfWidths{0.006 + 0.012 * head, 0.006 + 0.003 * head};
  };
  return long_body(0.11, head_on_handle, waves(4), triangles);
}

TriangleMesh file(std::size_t triangles) {
  const auto flat = [](double) { return HalfWidths{0.007, 0.003}; };
  const RandomWaves grain = waves(5);
  const auto teeth_in_rows = [&grain](const glm::dvec3& p) {
    const double tooth = std::sin(2.0 * std::numbers::pi * (p.z + 0.4 * p.x) / 2e-3);
    return 0.06e-3 * tooth + 0.5 * grain(p);
  };
  return long_body(0.09, flat, teeth_in_rows, triangles);
}

TriangleMesh part(std::size_t triangles) {
  const auto grooved = [](double z_m) {
    const double groove = smooth_step(0.006, 0.008, std::abs(z_m));
    return HalfWidths{0.010 + 0.003 * groove, 0.010 + 0.003 * groove};
  };
  const RandomWaves cast = waves(6);
  const auto traces_of_cutter = [&cast](const glm::dvec3& p) {
    return 0.04e-3 * std::sin(2.0 * std::numbers::pi * p.z / 1.5e-3) + 0.5 * cast(p);
  };
  return long_body(0.06, grooved, traces_of_cutter, triangles);
}

TriangleMesh ribs(std::size_t triangles) {
  const RandomWaves on_ribs = waves(7);
  const auto relief = [&on_ribs](const glm::dvec3& p) {
    return 0.6e-3 * std::cos(2.0 * std::numbers::pi * p.x / 5e-3) + on_ribs(p);
  };
  return rough_block(0.045, relief, triangles);
}

}  // namespace

RandomWaves::RandomWaves(const Settings& settings) {
  constexpr std::size_t kWaves = 24;
  Random random(settings.seed);
  double variance_m2 = 0.0;
  for (std::size_t i = 0; i < kWaves; ++i) {
    const double length_m = settings.shortest_m * std::pow(4.0, random.uniform());
    const glm::dvec3 way = glm::normalize(
        glm::dvec3(random.normal(), random.normal(), random.normal()) + glm::dvec3(1e-9));
    waves_.push_back({.per_m = 2.0 * std::numbers::pi / length_m * way,
                      .height_m = std::pow(length_m, 0.8),
                      .phase_rad = 2.0 * std::numbers::pi * random.uniform()});
    variance_m2 += 0.5 * waves_.back().height_m * waves_.back().height_m;
  }
  for (Wave& wave : waves_) wave.height_m *= settings.rms_m / std::sqrt(variance_m2);
}

double RandomWaves::operator()(const glm::dvec3& place_m) const {
  double sum_m = 0.0;
  for (const Wave& wave : waves_) {
    sum_m += wave.height_m * std::cos(glm::dot(wave.per_m, place_m) + wave.phase_rad);
  }
  return sum_m;
}

std::span<const DetailedBody> detailed_bodies() noexcept { return kBodies; }

TriangleMesh make_detailed_body(std::string_view name, std::size_t triangles) {
  if (triangles < kFewest) {
    throw std::invalid_argument(std::string(name) + " of " + std::to_string(triangles) +
                                " triangles has no shape; ask for at least 1000");
  }
  if (name == "block") return rough_block(0.03, waves(1), triangles);
  if (name == "ball") return rough_ball(0.0055, waves(2), triangles);
  if (name == "ten_balls") return ten_balls(triangles);
  if (name == "wide_block") return rough_block(0.07, waves(3), triangles);
  if (name == "hammer") return hammer(triangles);
  if (name == "file") return file(triangles);
  if (name == "part") return part(triangles);
  if (name == "comb") return comb(triangles);
  if (name == "ribs") return ribs(triangles);
  throw std::invalid_argument("there is no body \"" + std::string(name) +
                              "\"; choose one of detailed_bodies()");
}

TriangleMesh bumpy_torus(std::uint32_t around, std::uint32_t along) {
  TriangleMesh mesh{};
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < along; ++j) {
      const double a = 2.0 * std::numbers::pi * i / around;
      const double b = 2.0 * std::numbers::pi * j / along;
      const double tube_m = 0.012 * (1.0 + 0.15 * std::sin(5.0 * a + 0.3) * std::cos(3.0 * b));
      const double radius_m = 0.03 + tube_m * std::cos(b);
      mesh.vertices_m.push_back(
          {radius_m * std::cos(a), radius_m * std::sin(a), tube_m * std::sin(b)});
      const auto at = [=](std::uint32_t k, std::uint32_t l) {
        return (k % around) * along + l % along;
      };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

}  // namespace asperity
