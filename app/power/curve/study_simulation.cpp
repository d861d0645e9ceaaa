// Takes studies from a common counter, and keeps early results until their turn.

#include "app/power/curve/study_simulation.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "results_schema/error_text.h"

namespace asperity {

namespace {

constexpr auto kBetweenWrites = std::chrono::seconds(1);
constexpr std::int64_t kAhead = 4096;  // studies that wait for an earlier one to be passed on

class StudySimulation final {
 public:
  StudySimulation(const PowerOrder& order, const SimulateStudy& simulate, const StudyRange& range,
                  const StudyReceiver& receiver, const std::stop_token& stop,
                  const std::function<void(double)>& progress)
      : order_(order),
        simulate_(simulate),
        range_(range),
        receiver_(receiver),
        stop_(stop),
        progress_(progress),
        next_(range.first),
        settled_(range.first) {}

  std::int64_t done(int jobs) {
    {
      std::vector<std::jthread> workers{};
      for (int job = 1; job < jobs; ++job) workers.emplace_back([this] { work(); });
      work();
    }
    write();
    if (failure_) std::rethrow_exception(failure_);
    return settled_;
  }

 private:
  bool is_ended() const { return stop_.stop_requested() || failure_ || next_ >= range_.last; }

  StudyPlace place_of_study(std::int64_t index) const {
    StudyPlace place = place_of(order_, index);
    place.run = place.run * range_.shard.count + range_.shard.index - 1;
    return place;
  }

  void work() {
    for (;;) {
      std::unique_lock lock(mutex_);
      moved_.wait(lock, [this] { return is_ended() || next_ < settled_ + kAhead; });
      if (is_ended()) return;
      const std::int64_t index = next_++;
      lock.unlock();
      try {
        std::vector<SimulatedOutcome> outcomes = simulated(place_of_study(index));
        lock.lock();
        if (!outcomes.empty()) waiting_[index] = std::move(outcomes);
        settle();
      } catch (...) {
        if (!lock.owns_lock()) lock.lock();
        if (!failure_) failure_ = std::current_exception();
      }
      lock.unlock();
      moved_.notify_all();
    }
  }

  // None where the study was not completed after a stop request.
  std::vector<SimulatedOutcome> simulated(const StudyPlace& place) const {
    const int participants = order_.participants[place.size];
    const std::string& effect = order_.effects[place.effect];
    try {
      std::vector<SimulatedOutcome> outcomes =
          simulate_(place.effect, participants, order_.seed, place.run);
      if (outcomes.empty() && !stop_.stop_requested()) {
        throw std::runtime_error(
            "the analysis has no test; declare the tests of the protocol under analysis.family");
      }
      return outcomes;
    } catch (const std::exception& error) {
      throw std::runtime_error("the simulated study of run " + std::to_string(place.run) +
                               " with " + std::to_string(participants) + " participants" +
                               (effect.empty() ? "" : " and " + effect) + ": " + message_of(error));
    }
  }

  // Under the lock: the studies that follow those that are settled. None after a failure, which may be one to write: the table would
  // have a gap.
  void settle() {
    if (failure_) return;
    for (auto next = waiting_.begin(); next != waiting_.end() && next->first == settled_;
         next = waiting_.erase(next)) {
      receiver_.add(place_of_study(settled_), next->second);
      ++settled_;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - written_ < kBetweenWrites) return;
    write();
    written_ = now;
  }

  void write() {
    if (receiver_.write) receiver_.write();
    if (progress_) progress_(static_cast<double>(settled_) / static_cast<double>(range_.last));
  }

  const PowerOrder& order_;
  const SimulateStudy& simulate_;
  const StudyRange range_;
  const StudyReceiver& receiver_;
  std::stop_token stop_;
  const std::function<void(double)>& progress_;
  std::mutex mutex_{};  // guards the following members
  std::condition_variable moved_{};
  std::int64_t next_;
  std::int64_t settled_;
  std::map<std::int64_t, std::vector<SimulatedOutcome>> waiting_{};
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
  std::exception_ptr failure_{};
};

}  // namespace

std::int64_t simulate_studies(const PowerOrder& order, const SimulateStudy& simulate,
                              const StudyRange& range, int jobs, const StudyReceiver& receiver,
                              const std::stop_token& stop,
                              const std::function<void(double)>& progress) {
  return StudySimulation(order, simulate, range, receiver, stop, progress).done(jobs);
}

}  // namespace asperity
