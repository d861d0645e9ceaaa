// Welding, pairing faces at their edges, turning, closing, leaving out.

#include "stimuli/meshes/mesh_repair.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "analysis/number_text.h"
#include "stimuli/meshes/mesh_edges.h"

namespace asperity {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

constexpr double kShortestDiagonal_m = 1e-4;
constexpr double kLongestDiagonal_m = 10.0;
constexpr double kWidestHole = 0.1;  // of the diagonal
/// A part whose volume is below this times its area to the power 3/2 is flat; a plate a million times as wide
/// as thick has 3.5·10⁻⁷.
constexpr double kFlat = 1e-9;

std::string millimetres(double length_m) {
  return number_text(std::round(length_m * 1e6) / 1e3) + " mm";
}

struct Box {
  glm::dvec3 low_m{std::numeric_limits<double>::infinity()};
  glm::dvec3 high_m{-std::numeric_limits<double>::infinity()};
  void add(const glm::dvec3& point_m) {
    low_m = glm::min(low_m, point_m);
    high_m = glm::max(high_m, point_m);
  }
  double diagonal_m() const { return low_m.x > high_m.x ? 0.0 : glm::length(high_m - low_m); }
};

/// Sets that grow together; the smallest member speaks for its set.
class Sets final {
 public:
  explicit Sets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::uint32_t of(std::uint32_t member) {
    while (parent_[member] != member) {
      parent_[member] = parent_[parent_[member]];
      member = parent_[member];
    }
    return member;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

class Repair final {
 public:
  Repair(TriangleMesh mesh, const MeshRepairLimits& limits, const std::string& name)
      : mesh_(std::move(mesh)), limits_(limits), name_(name) {}

  RepairedMesh run() {
    if (const auto widest_m = limits_.widest_hole_m; widest_m && !(*widest_m >= 0.0)) {
      throw std::invalid_argument("the widest hole that is closed, widest_hole_m, is " +
                                  number_text(*widest_m) + "; it must be a length of at least 0.");
    }
    found_.triangles_in = mesh_.triangles.size();
    refuse_not_finite();
    weld();
    leave_out_bad_faces();
    measure();
    pair_at_edges();
    turn_to_agree();
    pair_at_crowded_edges();
    split_vertices();
    divide_double_edges();
    fill_holes();
    sort_out_parts();
    return {std::move(mesh_), found_};
  }

 private:
  [[noreturn]] void refuse(const std::string& sentence) const {
    throw std::invalid_argument(name_ + ' ' + sentence);
  }

  void refuse_not_finite() const {
    for (const Triangle& triangle : mesh_.triangles) {
      for (const std::uint32_t vertex : triangle) {
        const glm::dvec3& point_m = mesh_.vertices_m[vertex];
        if (!std::isfinite(point_m.x + point_m.y + point_m.z)) {
          refuse("has a vertex, number " + std::to_string(vertex + 1ULL) +
                 ", with a coordinate that is not a finite number; its place cannot be determined. "
                 "Correct it in the program that made the mesh.");
        }
      }
    }
  }

  void weld() {
    std::vector<std::uint32_t> order(mesh_.vertices_m.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    const std::vector<glm::dvec3>& points_m = mesh_.vertices_m;
    // Vertices that no face uses may be NaN, which has no order.
    std::vector<char> used(points_m.size(), 0);
    for (const Triangle& triangle : mesh_.triangles) {
      for (const std::uint32_t vertex : triangle) used[vertex] = 1;
    }
    std::erase_if(order, [&](std::uint32_t vertex) { return used[vertex] == 0; });
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const glm::dvec3& p = points_m[a];
      const glm::dvec3& q = points_m[b];
      if (p.x != q.x) return p.x < q.x;
      if (p.y != q.y) return p.y < q.y;
      if (p.z != q.z) return p.z < q.z;
      return a < b;
    });
    std::vector<std::uint32_t> stands_for(points_m.size(), kNone);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool same = i > 0 && points_m[order[i]] == points_m[order[i - 1]];
      stands_for[order[i]] = same ? stands_for[order[i - 1]] : order[i];
      if (same) ++found_.vertices_welded;
    }
    for (Triangle& triangle : mesh_.triangles) {
      for (std::uint32_t& vertex : triangle) vertex = stands_for[vertex];
    }
  }

  void leave_out_bad_faces() {
    std::vector<Triangle>& triangles = mesh_.triangles;
    found_.degenerate_faces = std::erase_if(
        triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    std::vector<std::pair<Triangle, std::uint32_t>> corners(triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      corners[i] = {triangles[i], i};
      std::sort(corners[i].first.begin(), corners[i].first.end());
    }
    std::sort(corners.begin(), corners.end());
    std::vector<char> again(triangles.size(), 0);
    for (std::size_t i = 1; i < corners.size(); ++i) {
      if (corners[i].first == corners[i - 1].first) again[corners[i].second] = 1;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (again[i] == 0) triangles[kept++] = triangles[i];
    }
    found_.duplicate_faces = triangles.size() - kept;
    triangles.resize(kept);
    if (kept == 0) refuse("has no face with three corners in different places.");
  }

  void measure() {
    Box box{};
    for (const Triangle& triangle : mesh_.triangles) {
      for (const std::uint32_t vertex : triangle) box.add(mesh_.vertices_m[vertex]);
    }
    found_.diagonal_m = box.diagonal_m();
    if (found_.diagonal_m < kShortestDiagonal_m || found_.diagonal_m > kLongestDiagonal_m) {
      refuse("is " + number_text(found_.diagonal_m) +
             " m from corner to corner of its bounding box; an object to be explored measures "
             "between 0.0001 m and 10 m. Mesh files do not state their unit: enter the length of "
             "one unit in metres.");
    }
    refuse_flat();
  }

  /// Everything lies in the plane of the largest face.
  void refuse_flat() const {
    glm::dvec3 largest{0.0};
    glm::dvec3 in_plane_m{0.0};
    for (const Triangle& triangle : mesh_.triangles) {
      const glm::dvec3& a_m = mesh_.vertices_m[triangle[0]];
      const glm::dvec3 doubled =
          glm::cross(mesh_.vertices_m[triangle[1]] - a_m, mesh_.vertices_m[triangle[2]] - a_m);
      if (glm::dot(doubled, doubled) > glm::dot(largest, largest)) {
        largest = doubled;
        in_plane_m = a_m;
      }
    }
    if (glm::dot(largest, largest) > 0.0) {
      const glm::dvec3 normal = glm::normalize(largest);
      for (const Triangle& triangle : mesh_.triangles) {
        for (const std::uint32_t vertex : triangle) {
          const double above_m = glm::dot(mesh_.vertices_m[vertex] - in_plane_m, normal);
          if (std::abs(above_m) > kFlat * found_.diagonal_m) return;
        }
      }
    }
    refuse_nothing_inside();
  }
  [[noreturn]] void refuse_nothing_inside() const {
    refuse("is flat: nothing in it encloses a volume, so it has no inside.");
  }

  // A half-edge is 3·face + corner: from that corner to the next.
  std::uint32_t from(std::uint32_t half) const { return mesh_.triangles[half / 3][half % 3]; }
  std::uint32_t to(std::uint32_t half) const { return from(next_half_edge(half)); }
  std::uint32_t opposite_corner(std::uint32_t half) const {
    return mesh_.triangles[half / 3][(half % 3 + 2) % 3];
  }

  void pair_at_edges() {
    const auto halves = static_cast<std::uint32_t>(3 * mesh_.triangles.size());
    partner_.assign(halves, kNone);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> edges(halves);
    for (std::uint32_t half = 0; half < halves; ++half) {
      edges[half] = {edge_key(from(half), to(half)), half};
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t begin = 0; begin < edges.size();) {
      std::size_t end = begin + 1;
      while (end < edges.size() && edges[end].first == edges[begin].first) ++end;
      if (end - begin == 2) {
        partner_[edges[begin].second] = edges[begin + 1].second;
        partner_[edges[begin + 1].second] = edges[begin].second;
      } else if (end - begin > 2) {
        ++found_.non_manifold_edges;
        std::vector<std::uint32_t> crowd{};
        for (std::size_t i = begin; i < end; ++i) crowd.push_back(edges[i].second);
        crowds_.push_back(std::move(crowd));
      }
      begin = end;
    }
  }

  /// From face to face, each is turned to run against its neighbour at their edge; the smaller part
  /// of a sheet counts as turned.
  void turn_to_agree() {
    const auto faces = static_cast<std::uint32_t>(mesh_.triangles.size());
    std::vector<signed char> turned(faces, -1);
    std::vector<std::uint32_t> sheet{};
    for (std::uint32_t seed = 0; seed < faces; ++seed) {
      if (turned[seed] >= 0) continue;
      sheet.assign(1, seed);
      turned[seed] = 0;
      std::size_t count = 0;
      for (std::size_t next = 0; next < sheet.size(); ++next) {
        const std::uint32_t face = sheet[next];
        for (std::uint32_t half = 3 * face; half < 3 * face + 3; ++half) {
          if (partner_[half] == kNone) continue;
          const std::uint32_t other = partner_[half] / 3;
          const bool agree = from(half) != from(partner_[half]);
          const auto wanted = static_cast<signed char>(agree ? turned[face] : 1 - turned[face]);
          if (turned[other] < 0) {
            turned[other] = wanted;
            count += wanted == 1 ? 1 : 0;
            sheet.push_back(other);
          } else if (turned[other] != wanted) {
            refuse("has a surface with one side only, like a Möbius strip, near triangle " +
                   std::to_string(other + 1ULL) + "; it has no inside.");
          }
        }
      }
      const bool other_way = 2 * count > sheet.size();
      found_.faces_turned += other_way ? sheet.size() - count : count;
      if (!other_way) continue;
      for (const std::uint32_t face : sheet)
        turned[face] = static_cast<signed char>(1 - turned[face]);
    }
    // Turning exchanges the last two corners: half-edge 0 ↔ 2, and 1 stays.
    const auto moved = [&](std::uint32_t half) {
      return turned[half / 3] == 1 ? half / 3 * 3 + 2 - half % 3 : half;
    };
    std::vector<std::uint32_t> partner(partner_.size(), kNone);
    for (std::uint32_t half = 0; half < partner_.size(); ++half) {
      if (partner_[half] != kNone) partner[moved(half)] = moved(partner_[half]);
    }
    partner_ = std::move(partner);
    for (std::vector<std::uint32_t>& crowd : crowds_) {
      for (std::uint32_t& half : crowd) half = moved(half);
    }
    for (std::uint32_t face = 0; face < faces; ++face) {
      // (a, b, c) → (a, c, b): the edges ab, bc, ca become ac, cb, ba.
      if (turned[face] == 1) std::swap(mesh_.triangles[face][1], mesh_.triangles[face][2]);
    }
  }

  void join_faces(std::uint32_t one, std::uint32_t other) {
    partner_[one] = other;
    partner_[other] = one;
  }

  /// Around an edge a → b, of the faces in the order of their angles: one that runs b → a has the
  /// body on the side of the growing angle, one that runs a → b on the other side.
  void pair_at_crowded_edges() {
    for (const std::vector<std::uint32_t>& crowd : crowds_) {
      const std::uint32_t low = std::min(from(crowd[0]), to(crowd[0]));
      const std::uint32_t high = std::max(from(crowd[0]), to(crowd[0]));
      const glm::dvec3 a_m = mesh_.vertices_m[low];
      const glm::dvec3 axis = glm::normalize(mesh_.vertices_m[high] - a_m);
      const glm::dvec3 aside = std::abs(axis.x) < 0.6 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
      const glm::dvec3 u = glm::normalize(glm::cross(axis, aside));
      const glm::dvec3 v = glm::cross(axis, u);
      std::vector<std::pair<double, std::uint32_t>> around{};
      for (const std::uint32_t half : crowd) {
        const glm::dvec3 apex_m = mesh_.vertices_m[opposite_corner(half)] - a_m;
        around.emplace_back(std::atan2(glm::dot(apex_m, v), glm::dot(apex_m, u)), half);
      }
      std::sort(around.begin(), around.end());
      const auto runs_up = [&](std::uint32_t half) { return from(half) == low; };
      const auto pair_neighbours = [&] {
        for (std::size_t i = 0; i < around.size() && around.size() > 1; ++i) {
          const std::size_t next = (i + 1) % around.size();
          const std::uint32_t first = around[i].second;
          const std::uint32_t second = around[next].second;
          if (runs_up(first) || !runs_up(second)) continue;
          join_faces(first, second);
          around.erase(around.begin() + static_cast<std::ptrdiff_t>(std::max(i, next)));
          around.erase(around.begin() + static_cast<std::ptrdiff_t>(std::min(i, next)));
          return true;
        }
        return false;
      };
      while (pair_neighbours()) {
      }
    }
  }

  /// The corners of faces that hang together around a vertex become one vertex of their own.
  void split_vertices() {
    const auto corners = static_cast<std::uint32_t>(partner_.size());
    Sets fans(corners);
    for (std::uint32_t half = 0; half < corners; ++half) {
      const std::uint32_t other = partner_[half];
      if (other == kNone || other < half) continue;
      fans.join(half, next_half_edge(other));  // paired half-edges run in opposite directions
      fans.join(next_half_edge(half), other);
    }
    std::vector<glm::dvec3> vertices_m{};
    std::vector<std::uint32_t> name_of_fan(corners, kNone);
    std::vector<char> seen(mesh_.vertices_m.size(), 0);
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
      std::uint32_t& vertex = mesh_.triangles[corner / 3][corner % 3];
      std::uint32_t& name = name_of_fan[fans.of(corner)];
      if (name == kNone) {
        name = static_cast<std::uint32_t>(vertices_m.size());
        vertices_m.push_back(mesh_.vertices_m[vertex]);
        found_.vertices_split += static_cast<std::size_t>(seen[vertex]);
        seen[vertex] = 1;
      }
      vertex = name;
    }
    mesh_.vertices_m = std::move(vertices_m);
  }

  /// Where bodies touch along an edge and hang together at both its ends, two edges have the same ends
  /// even now. All but one of such edges get a vertex in their middle.
  void divide_double_edges() {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> edges(partner_.size());
    for (std::uint32_t half = 0; half < edges.size(); ++half) {
      edges[half] = {edge_key(from(half), to(half)), half};
    }
    std::sort(edges.begin(), edges.end());
    std::vector<std::uint32_t> middles(partner_.size(), kNone);
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
      while (end < edges.size() && edges[end].first == edges[begin].first) ++end;
      const std::uint32_t first = edges[begin].second;
      for (std::size_t i = begin + 1; i < end; ++i) {
        const std::uint32_t half = edges[i].second;
        if (half == partner_[first] || middles[half] != kNone) continue;
        middles[half] = static_cast<std::uint32_t>(mesh_.vertices_m.size());
        if (partner_[half] != kNone) middles[partner_[half]] = middles[half];
        mesh_.vertices_m.push_back(0.5 *
                                   (mesh_.vertices_m[from(half)] + mesh_.vertices_m[to(half)]));
        ++found_.edges_divided;
      }
    }
    if (found_.edges_divided == 0) return;
    std::vector<Triangle> divided{};
    for (std::size_t face = 0; face < mesh_.triangles.size(); ++face) {
      divide(mesh_.triangles[face],
             {middles[3 * face], middles[3 * face + 1], middles[3 * face + 2]}, divided);
    }
    mesh_.triangles = std::move(divided);
    partner_ = opposite_half_edges(mesh_.triangles);
  }

  /// A triangle with vertices in the middle of some of its sides, in triangles.
  static void divide(Triangle corners, Triangle middles, std::vector<Triangle>& into) {
    const auto count = std::count_if(middles.begin(), middles.end(),
                                     [](std::uint32_t middle) { return middle != kNone; });
    // One is on the first side then, two are on the first two.
    while ((count == 1 && middles[0] == kNone) || (count == 2 && middles[2] != kNone)) {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      std::rotate(middles.begin(), middles.begin() + 1, middles.end());
    }
    const auto [a, b, c] = corners;
    const auto [ab, bc, ca] = middles;
    if (count == 0) {
      into.push_back(corners);
    } else if (count == 1) {
      into.insert(into.end(), {{a, ab, c}, {ab, b, c}});
    } else if (count == 2) {
      into.insert(into.end(), {{ab, b, bc}, {a, ab, bc}, {a, bc, c}});
    } else {
      into.insert(into.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
  }

  void fill_holes() {
    // Every vertex has one fan, so at most one border edge leaves it.
    std::vector<std::uint32_t> leaving(mesh_.vertices_m.size(), kNone);
    for (std::uint32_t half = 0; half < partner_.size(); ++half) {
      if (partner_[half] == kNone) leaving[from(half)] = half;
    }
    const double widest_m = limits_.widest_hole_m.value_or(kWidestHole * found_.diagonal_m);
    std::size_t too_wide = 0;
    std::vector<std::vector<std::uint32_t>> holes{};
    for (std::uint32_t start = 0; start < leaving.size(); ++start) {
      if (leaving[start] == kNone) continue;
      std::vector<std::uint32_t> hole{};
      Box box{};
      for (std::uint32_t vertex = start; leaving[vertex] != kNone;) {
        hole.push_back(vertex);
        box.add(mesh_.vertices_m[vertex]);
        vertex = to(std::exchange(leaving[vertex], kNone));
      }
      found_.widest_hole_m = std::max(found_.widest_hole_m, box.diagonal_m());
      if (box.diagonal_m() > widest_m) ++too_wide;
      holes.push_back(std::move(hole));
    }
    if (too_wide > 0) {
      refuse("is not closed: it has " + std::to_string(holes.size()) +
             (holes.size() == 1 ? " opening" : " openings") + ", the widest " +
             millimetres(found_.widest_hole_m) + " across, and only those up to " +
             millimetres(widest_m) +
             " are closed. Close them in the mesh, or allow wider ones to be closed.");
    }
    for (const std::vector<std::uint32_t>& hole : holes) fill(hole);
    found_.holes_filled = holes.size();
  }

  void fill(const std::vector<std::uint32_t>& hole) {
    const std::size_t count = hole.size();
    if (count == 3) {
      mesh_.triangles.push_back({hole[2], hole[1], hole[0]});
      return;
    }
    glm::dvec3 middle_m{0.0};
    for (const std::uint32_t vertex : hole) middle_m += mesh_.vertices_m[vertex];
    const auto middle = static_cast<std::uint32_t>(mesh_.vertices_m.size());
    mesh_.vertices_m.push_back(middle_m / static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
      mesh_.triangles.push_back({hole[(i + 1) % count], hole[i], middle});
    }
  }

  struct Part {
    Box box{};
    double volume_m3 = 0.0;
    double area_m2 = 0.0;
    std::size_t faces = 0;
    std::uint32_t first_face = 0;
    bool dropped = false;
    bool turned = false;
  };

  void sort_out_parts() {
    Sets sets(mesh_.vertices_m.size());
    for (const Triangle& triangle : mesh_.triangles) {
      sets.join(triangle[0], triangle[1]);
      sets.join(triangle[0], triangle[2]);
    }
    std::vector<std::uint32_t> part_of(mesh_.vertices_m.size(), kNone);
    std::vector<Part> parts{};
    for (std::uint32_t face = 0; face < mesh_.triangles.size(); ++face) {
      const Triangle& triangle = mesh_.triangles[face];
      const std::uint32_t root = sets.of(triangle[0]);
      if (part_of[root] == kNone) {
        part_of[root] = static_cast<std::uint32_t>(parts.size());
        parts.emplace_back().first_face = face;
      }
      Part& part = parts[part_of[root]];
      const glm::dvec3& origin_m = mesh_.vertices_m[mesh_.triangles[part.first_face][0]];
      std::array<glm::dvec3, 3> corners_m{};
      for (std::size_t i = 0; i < 3; ++i) {
        part_of[triangle[i]] = part_of[root];
        part.box.add(mesh_.vertices_m[triangle[i]]);
        corners_m[i] = mesh_.vertices_m[triangle[i]] - origin_m;
      }
      const glm::dvec3 doubled =
          glm::cross(corners_m[1] - corners_m[0], corners_m[2] - corners_m[0]);
      part.volume_m3 += glm::dot(corners_m[0], doubled) / 6.0;
      part.area_m2 += 0.5 * glm::length(doubled);
      ++part.faces;
    }
    for (Part& part : parts) {
      if (part.box.diagonal_m() < limits_.smallest_part * found_.diagonal_m) {
        ++found_.debris_parts;
        part.dropped = true;
      } else if (std::abs(part.volume_m3) < kFlat * std::pow(part.area_m2, 1.5)) {
        ++found_.flat_parts;
        part.dropped = true;
      }
      if (part.dropped) {
        found_.dropped_faces += part.faces;
      } else {
        ++found_.parts;
      }
    }
    if (found_.parts == 0) refuse_nothing_inside();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Part& part = parts[i];
      if (part.dropped) continue;
      const bool cavity = found_.parts > 1 && lies_within_another(i, parts, part_of);
      if (cavity) ++found_.cavities;
      part.turned = (part.volume_m3 < 0.0) != cavity;
      if (part.turned) ++found_.inside_out_parts;
    }
    keep(parts, part_of);
  }

  /// A ray from a corner of the part crosses the others an odd number of times.
  bool lies_within_another(std::size_t which, const std::vector<Part>& parts,
                           const std::vector<std::uint32_t>& part_of) const {
    const Box& box = parts[which].box;
    std::vector<char> encloses(parts.size(), 0);
    bool any = false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const bool around = i != which && !parts[i].dropped &&
                          glm::all(glm::lessThan(parts[i].box.low_m, box.low_m)) &&
                          glm::all(glm::lessThan(box.high_m, parts[i].box.high_m));
      encloses[i] = around ? 1 : 0;
      any = any || around;
    }
    if (!any) return false;
    const glm::dvec3 origin_m = mesh_.vertices_m[mesh_.triangles[parts[which].first_face][0]];
    // A direction that no face or edge of a made object is likely to have.
    const glm::dvec3 direction = glm::normalize(glm::dvec3{0.5377, 0.3319, 0.7751});
    std::size_t crossings = 0;
    for (const Triangle& triangle : mesh_.triangles) {
      if (encloses[part_of[triangle[0]]] == 0) continue;
      const glm::dvec3 a_m = mesh_.vertices_m[triangle[0]] - origin_m;
      const glm::dvec3 ab_m = mesh_.vertices_m[triangle[1]] - origin_m - a_m;
      const glm::dvec3 ac_m = mesh_.vertices_m[triangle[2]] - origin_m - a_m;
      const glm::dvec3 p = glm::cross(direction, ac_m);
      const double determinant = glm::dot(ab_m, p);
      if (determinant == 0.0) continue;
      const double b = -glm::dot(a_m, p) / determinant;
      const glm::dvec3 q = glm::cross(-a_m, ab_m);
      const double c = glm::dot(direction, q) / determinant;
      if (b >= 0.0 && c >= 0.0 && b + c <= 1.0 && glm::dot(ac_m, q) / determinant > 0.0) {
        ++crossings;
      }
    }
    return crossings % 2 == 1;
  }

  void keep(const std::vector<Part>& parts, const std::vector<std::uint32_t>& part_of) {
    TriangleMesh kept{};
    std::vector<std::uint32_t> renamed(mesh_.vertices_m.size(), kNone);
    for (Triangle triangle : mesh_.triangles) {
      const Part& part = parts[part_of[triangle[0]]];
      if (part.dropped) continue;
      if (part.turned) std::swap(triangle[1], triangle[2]);
      for (std::uint32_t& vertex : triangle) {
        if (renamed[vertex] == kNone) {
          renamed[vertex] = static_cast<std::uint32_t>(kept.vertices_m.size());
          kept.vertices_m.push_back(mesh_.vertices_m[vertex]);
        }
        vertex = renamed[vertex];
      }
      kept.triangles.push_back(triangle);
    }
    mesh_ = std::move(kept);
  }

  TriangleMesh mesh_;
  MeshRepairLimits limits_;
  std::string name_;
  MeshFindings found_{};
  std::vector<std::uint32_t> partner_{};              ///< of each half-edge
  std::vector<std::vector<std::uint32_t>> crowds_{};  ///< half-edges of each non-manifold edge
};

}  // namespace

RepairedMesh repair_mesh(TriangleMesh mesh, const MeshRepairLimits& limits,
                         const std::string& name) {
  return Repair(std::move(mesh), limits, name).run();
}

std::vector<std::string> sentences_of(const MeshFindings& found) {
  std::vector<std::string> sentences{};
  const auto say = [&sentences](const std::string& what, std::size_t count) {
    if (count > 0) sentences.push_back(what + ": " + std::to_string(count) + '.');
  };
  say("Vertices joined with another one in the same place", found.vertices_welded);
  say("Faces left out because two corners lay in one place", found.degenerate_faces);
  say("Faces left out because another one has the same corners", found.duplicate_faces);
  say("Faces reversed because their orientation differed from that of their neighbours",
      found.faces_turned);
  say("Edges of more than two faces, separated", found.non_manifold_edges);
  say("Vertices added where surfaces met only in a point or at such an edge", found.vertices_split);
  say("Edges divided because others had the same two ends", found.edges_divided);
  say("Holes closed, up to " + millimetres(found.widest_hole_m) + " wide", found.holes_filled);
  say("Parts left out as debris, each far smaller than the whole", found.debris_parts);
  say("Parts left out because they are flat and enclose nothing", found.flat_parts);
  say("Faces left out with these parts", found.dropped_faces);
  say("Parts inverted because they were inside out", found.inside_out_parts);
  say("Cavities, which cannot be reached from outside", found.cavities);
  if (found.parts > 1) say("Separate parts", found.parts);
  return sentences;
}

}  // namespace asperity
