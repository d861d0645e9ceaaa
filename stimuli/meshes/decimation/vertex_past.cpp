// Implements quadrics and the thinning of samples.

#include "stimuli/meshes/decimation/vertex_past.h"

#include <cstddef>

#include <glm/geometric.hpp>

namespace asperity::decimation {

Quadric::Quadric(const glm::dvec3& normal, const glm::dvec3& point, double weight) {
  const double offset = -glm::dot(normal, point);
  const glm::dvec3 weighted = weight * normal;
  xx_ = weighted.x * normal.x;
  xy_ = weighted.x * normal.y;
  xz_ = weighted.x * normal.z;
  yy_ = weighted.y * normal.y;
  yz_ = weighted.y * normal.z;
  zz_ = weighted.z * normal.z;
  b_ = offset * weighted;
  c_ = weight * offset * offset;
}

Quadric& Quadric::operator+=(const Quadric& other) {
  xx_ += other.xx_;
  xy_ += other.xy_;
  xz_ += other.xz_;
  yy_ += other.yy_;
  yz_ += other.yz_;
  zz_ += other.zz_;
  b_ += other.b_;
  c_ += other.c_;
  return *this;
}

void keep_sample(VertexPast& past, const Sample& sample) {
  constexpr std::size_t kMostSamples = 32;
  std::vector<Sample>& samples = past.samples;
  samples.push_back(sample);
  if (samples.size() <= kMostSamples) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples.size(); i += 2) {
    Sample next = samples[i];
    if (i + 1 < samples.size()) next.area += samples[i + 1].area;
    samples[kept++] = next;
  }
  samples.resize(kept);
}

}  // namespace asperity::decimation
