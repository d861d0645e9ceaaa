// Implements the storage of window samplers that are not in use.

#include "renderers/pd_gradient/sampling/spare_samplers.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <mutex>
#include <utility>
#include <vector>

#include "renderers/pd_gradient/sampling/newest_within.h"

namespace asperity {
namespace {

/// What decides which windows and cells there are.
struct Order {
  WindowSampling sampling{};
  double widest_m = 0.0;
  std::size_t most_triangles = 0;
  InstructionSet instructions{};

  bool operator==(const Order&) const = default;
};

struct Spare {
  Order order{};
  std::unique_ptr<WindowSamplers> samplers{};
};

}  // namespace

class SpareSamplers::Shelf final {
 public:
  explicit Shelf(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Null if there are none.
  std::unique_ptr<WindowSamplers> find(const Order& order) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(spare_.rbegin(), spare_.rend(),
                                    [&order](const Spare& each) { return each.order == order; });
    if (found == spare_.rend()) return nullptr;
    std::unique_ptr<WindowSamplers> samplers = std::move(found->samplers);
    spare_.erase(std::next(found).base());
    return samplers;
  }

  void put(const Order& order, std::unique_ptr<WindowSamplers> samplers) {
    samplers->reset();
    std::vector<Spare> released{};  // after the lock
    const std::lock_guard lock(mutex_);
    spare_.push_back({.order = order, .samplers = std::move(samplers)});
    const auto first = newest_within(spare_, most_bytes_,
                                     [](const Spare& each) { return each.samplers->bytes(); });
    released.assign(std::make_move_iterator(spare_.begin()), std::make_move_iterator(first));
    spare_.erase(spare_.begin(), first);
  }

 private:
  std::size_t most_bytes_ = 0;
  std::mutex mutex_{};
  std::vector<Spare> spare_{};  // guarded by the mutex; the last returned one at the end
};

SpareSamplers::SpareSamplers(std::size_t most_bytes)
    : shelf_(std::make_shared<Shelf>(most_bytes)) {}

std::shared_ptr<WindowSamplers> SpareSamplers::take(const WindowSampling& sampling, double widest_m,
                                                    std::size_t most_triangles,
                                                    InstructionSet instructions) {
  const Order order{.sampling = sampling,
                    .widest_m = widest_m,
                    .most_triangles = most_triangles,
                    .instructions = instructions};
  std::unique_ptr<WindowSamplers> samplers = shelf_->find(order);
  if (samplers == nullptr) {
    samplers = std::make_unique<WindowSamplers>(sampling, widest_m, most_triangles, instructions);
  }
  const auto put_back = [order, shelf = shelf_](WindowSamplers* used) {
    std::unique_ptr<WindowSamplers> own(used);
    try {
      shelf->put(order, std::move(own));
    } catch (const std::exception&) {  // no memory: they are released
    }
  };
  return {samplers.release(), put_back};
}

}  // namespace asperity
