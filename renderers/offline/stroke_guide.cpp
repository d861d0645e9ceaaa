// Implements the curves of strokes.

#include "renderers/offline/stroke_guide.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "device/refusal.h"
#include "renderers/proxy/surface_proxy.h"

namespace asperity {
namespace {

constexpr std::size_t kProfileSamples = 2048;
constexpr double kSteepest = 0.5;  // the sine of 30°
constexpr double kRim_m = 0.001;   // the normals of a sharp edge are those of both sides
constexpr double kShortest_m = 0.004;
constexpr double kLevel_m = 1e-6;  // heights that differ by less are the same
constexpr double kAbove_m = 1e-5;
constexpr double kRounding = 1e-6;  // of the distance between samples

/// The highest place of the body at each x, in the plane y = line; −∞ where there is none.
class Profile final {
 public:
  Profile(const BodySurface& body, double line_m) : line_m_(line_m) {
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -low_m;
    const auto each_facet = [&](const auto& take) {
      for (std::uint32_t facet = 0; facet < body.facets(); ++facet) take(facet);
    };
    each_facet([&](std::uint32_t facet) {
      for (const std::uint32_t corner : body.corners(facet)) {
        low_m = std::min(low_m, body.vertex_m(corner).x);
        high_m = std::max(high_m, body.vertex_m(corner).x);
      }
    });
    from_m_ = low_m;
    pitch_m_ = (high_m - low_m) / static_cast<double>(kProfileSamples - 1);
    heights_m_.assign(kProfileSamples, -std::numeric_limits<double>::infinity());
    each_facet([&](std::uint32_t facet) { cut(body, facet); });
  }

  double x_m(std::size_t i) const { return from_m_ + static_cast<double>(i) * pitch_m_; }
  double height_m(std::size_t i) const { return heights_m_[i]; }
  bool is_there(std::size_t i) const { return std::isfinite(heights_m_[i]); }

  /// The middle of the longest row of samples at the greatest height; nullopt without any.
  std::optional<std::size_t> top() const {
    const double most_m = *std::max_element(heights_m_.begin(), heights_m_.end());
    if (!std::isfinite(most_m)) return {};
    std::size_t longest = 0;
    std::size_t length = 0;
    std::size_t middle = 0;
    for (std::size_t i = 0; i < heights_m_.size(); ++i) {
      length = heights_m_[i] > most_m - kLevel_m ? length + 1 : 0;
      if (length <= longest) continue;
      longest = length;
      middle = i - length / 2;
    }
    return middle;
  }

 private:
  void cut(const BodySurface& body, std::uint32_t facet) {
    const auto& corners = body.corners(facet);
    double low_x_m = std::numeric_limits<double>::infinity();
    double high_x_m = -low_x_m;
    glm::dvec3 low_m{0.0};
    glm::dvec3 high_m{0.0};
    const auto meets = [&](const glm::dvec3& point_m) {
      if (point_m.x < low_x_m) low_x_m = (low_m = point_m).x;
      if (point_m.x > high_x_m) high_x_m = (high_m = point_m).x;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3& a_m = body.vertex_m(corners[i]);
      const glm::dvec3& b_m = body.vertex_m(corners[(i + 1) % 3]);
      if (a_m.y == line_m_) meets(a_m);
      if ((a_m.y < line_m_) == (b_m.y < line_m_)) continue;
      meets(a_m + (line_m_ - a_m.y) / (b_m.y - a_m.y) * (b_m - a_m));
    }
    if (!(high_x_m >= low_x_m)) return;
    // A sample on the edge of two facets must not fall between them.
    const double first = std::ceil((low_x_m - from_m_) / pitch_m_ - kRounding);
    const double last_m = high_x_m + kRounding * pitch_m_;
    for (auto i = static_cast<std::size_t>(std::max(0.0, first));
         i < kProfileSamples && x_m(i) <= last_m; ++i) {
      const double part = high_x_m > low_x_m
                              ? std::clamp((x_m(i) - low_x_m) / (high_x_m - low_x_m), 0.0, 1.0)
                              : 0.0;
      heights_m_[i] = std::max(heights_m_[i], low_m.z + part * (high_m.z - low_m.z));
    }
  }

  double line_m_ = 0.0;
  double from_m_ = 0.0;
  double pitch_m_ = 0.0;
  std::vector<double> heights_m_{};
};

}  // namespace

GuidePlace StraightGuide::at(double s_m) const noexcept { return {.origin_m = {s_m, 0.0, 0.0}}; }

TurningGuide::TurningGuide(double radius_m) : radius_m_(radius_m) {
  require_positive("TurningGuide::radius_m", radius_m);
}

GuidePlace TurningGuide::at(double s_m) const noexcept {
  const double angle_rad = s_m / radius_m_;
  const double sine = std::sin(angle_rad);
  const double cosine = std::cos(angle_rad);
  return {.origin_m = {radius_m_ * sine, radius_m_ * (1.0 - cosine), 0.0},
          .along = {cosine, sine, 0.0},
          .orientation = glm::angleAxis(angle_rad, glm::dvec3{0.0, 0.0, 1.0})};
}

BodyGuide::BodyGuide(const std::shared_ptr<const BodySurface>& body, double line_m) {
  const Profile profile(*body, line_m);
  const std::optional<std::size_t> top = profile.top();
  if (!top) {
    throw std::invalid_argument("the body does not reach the line y = " + number_text(line_m) +
                                " m of the stroke; choose a wider body");
  }
  SurfaceProxy proxy(body);
  const auto place_at = [&](std::size_t i) -> std::optional<GuidePlace> {
    if (!profile.is_there(i)) return {};
    const auto found = proxy.follow({profile.x_m(i), line_m, profile.height_m(i) + kAbove_m});
    if (!found) return {};
    const glm::dvec3 normal = glm::normalize(glm::dvec3{found->normal.x, 0.0, found->normal.z});
    if (!(normal.z > 0.0) || std::abs(normal.x) > kSteepest) return {};
    return GuidePlace{.origin_m = {profile.x_m(i), line_m, profile.height_m(i)},
                      .along = {normal.z, 0.0, -normal.x},
                      .normal = normal};
  };
  std::vector<GuidePlace> before{};
  for (std::size_t i = *top; i-- > 0;) {
    const auto place = place_at(i);
    if (!place) break;
    before.push_back(*place);
  }
  std::reverse(before.begin(), before.end());
  const std::size_t middle = before.size();
  places_ = std::move(before);
  proxy.reset();  // it follows a probe that moves in small steps
  for (std::size_t i = *top; i < kProfileSamples; ++i) {
    const auto place = place_at(i);
    if (!place) break;
    places_.push_back(*place);
  }
  if (places_.size() <= middle) {
    throw std::invalid_argument(
        "the body has no upper side at its highest point; choose a body that is rounder there");
  }
  for (std::size_t i = 0; i < places_.size(); ++i) {
    s_m_.push_back(
        i == 0 ? 0.0 : s_m_.back() + glm::distance(places_[i - 1].origin_m, places_[i].origin_m));
  }
  body_origin_m_ = -places_[middle].origin_m;
  const double middle_m = s_m_[middle];
  const double from_m = s_m_.front() + kRim_m;
  const double to_m = s_m_.back() - kRim_m;
  if (!(to_m - from_m >= kShortest_m)) {
    throw std::invalid_argument(
        "the upper side of the body, as far as it is inclined by less than 30°, is " +
        number_text(std::max(0.0, to_m - from_m)) +
        " m long; it must be at least 0.004 m long: choose a larger body");
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (s_m_[i] < from_m || s_m_[i] > to_m) continue;
    s_m_[kept] = s_m_[i] - middle_m;
    places_[kept] = places_[i];
    places_[kept].origin_m += body_origin_m_;
    ++kept;
  }
  s_m_.resize(kept);
  places_.resize(kept);
}

GuidePlace BodyGuide::at(double s_m) const noexcept {
  const auto above = std::upper_bound(s_m_.begin(), s_m_.end(), s_m);
  if (above == s_m_.begin() || above == s_m_.end()) {
    const bool is_before = above == s_m_.begin();
    GuidePlace end = is_before ? places_.front() : places_.back();
    end.origin_m += (s_m - (is_before ? s_m_.front() : s_m_.back())) * end.along;
    return end;
  }
  const auto i = static_cast<std::size_t>(above - s_m_.begin()) - 1;
  const double part = (s_m - s_m_[i]) / (s_m_[i + 1] - s_m_[i]);
  const GuidePlace& a = places_[i];
  const GuidePlace& b = places_[i + 1];
  const glm::dvec3 normal = glm::normalize(a.normal + part * (b.normal - a.normal));
  return {.origin_m = a.origin_m + part * (b.origin_m - a.origin_m),
          .along = {normal.z, 0.0, -normal.x},
          .normal = normal};
}

}  // namespace asperity
