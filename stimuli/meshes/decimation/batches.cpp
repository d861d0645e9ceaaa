// Implements the batches of collapses.

#include "stimuli/meshes/decimation/batches.h"

#include <algorithm>
#include <utility>

#include "stimuli/meshes/side_by_side.h"

namespace asperity::decimation {

Batches::Batches(ClosedSurface& surface, std::vector<VertexPast>& pasts, unsigned jobs)
    : surface_(surface),
      pasts_(pasts),
      jobs_(jobs),
      best_(surface.vertices()),
      batch_of_(surface.vertices(), 0) {
  for (std::uint32_t vertex = 0; vertex < surface.vertices(); ++vertex) {
    if (surface.exists(vertex)) left_.push_back(vertex);
  }
}

void Batches::run(std::size_t triangles, const Permission& permission,
                  const std::function<void()>& progress) {
  stale_ = left_;
  evaluate(permission);
  while (surface_.triangles() > triangles) {
    choose_cheapest();
    if (order_.empty()) return;
    stale_.clear();
    ++batch_;
    for (const Order& each : order_) {
      if (surface_.triangles() <= triangles) break;
      remove_or_postpone(each.vertex);
    }
    std::erase_if(left_, [this](std::uint32_t vertex) { return !surface_.exists(vertex); });
    evaluate(permission);
    progress();
  }
}

void Batches::evaluate(const Permission& permission) {
  // Starting a thread takes as long as some ten costs.
  constexpr std::size_t kWorthThreads = 100;
  const unsigned jobs = stale_.size() < kWorthThreads ? 1 : jobs_;
  side_by_side(stale_.size(), {jobs, {}}, [&](std::size_t begin, std::size_t end) {
    CollapseChoice choice(surface_, pasts_);
    for (std::size_t i = begin; i < end; ++i) {
      best_[stale_[i]] = choice.best_of(stale_[i], permission);
    }
  });
}

/// The vertices of the next batch, in order of cost, and of number where costs are equal.
void Batches::choose_cheapest() {
  constexpr std::size_t kOfAll = 64;
  order_.clear();
  for (const std::uint32_t vertex : left_) {
    if (best_[vertex].half != kNoHalfEdge) order_.push_back({best_[vertex].cost, vertex});
  }
  const auto is_cheaper = [](const Order& one, const Order& other) {
    return one.cost != other.cost ? one.cost < other.cost : one.vertex < other.vertex;
  };
  const std::size_t most = std::max<std::size_t>(1, left_.size() / kOfAll);
  if (order_.size() > most) {
    std::nth_element(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(most),
                     order_.end(), is_cheaper);
    order_.resize(most);
  }
  std::sort(order_.begin(), order_.end(), is_cheaper);
}

void Batches::touch(std::uint32_t vertex) {
  if (batch_of_[vertex] == batch_) return;
  batch_of_[vertex] = batch_;
  stale_.push_back(vertex);
}

void Batches::remove_or_postpone(std::uint32_t vertex) {
  if (batch_of_[vertex] == batch_) return;
  const std::uint32_t half = best_[vertex].half;
  const std::uint32_t kept = surface_.to(half);
  ring_.clear();  // begins after the vertex that is kept, and ends with it
  std::uint32_t spoke = half;
  do {
    spoke = surface_.turned(spoke);
    ring_.push_back(surface_.to(spoke));
  } while (spoke != half);
  // A collapse elsewhere can make another one impossible, or dearer where both lead to the same vertex.
  if (batch_of_[kept] == batch_ || !surface_.can_collapse(half, ring_)) {
    touch(vertex);
    return;
  }
  batch_of_[vertex] = batch_;
  for (const std::uint32_t neighbour : ring_) touch(neighbour);
  hand_over(vertex, kept);
  surface_.collapse(half);
}

/// Gives the samples of a vertex to the nearest corners of the faces that will be there, and its planes to the vertex that
/// is kept.
void Batches::hand_over(std::uint32_t vertex, std::uint32_t kept) {
  const VertexPast past = std::exchange(pasts_[vertex], {});
  pasts_[kept].quadric += past.quadric;
  pasts_[kept].deviation = pasts_[kept].quadric.at(surface_.point(kept));
  fan_.begin(surface_.point(kept));
  for (std::size_t i = 0; i + 1 < ring_.size(); ++i) fan_.add(surface_.point(ring_[i]));
  for (const Sample& sample : past.samples) {
    const std::size_t face = fan_.nearest(sample.place).face;
    const std::size_t corner = fan_.nearest_corner(face);
    keep_sample(pasts_[corner == 0 ? kept : ring_[face + corner - 1]], sample);
  }
}

}  // namespace asperity::decimation
