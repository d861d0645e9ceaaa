// Makes surfaces on a thread of the batch policy, ahead of time while memory is available.

#include "app/session/upcoming_surfaces.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iterator>
#include <pthread.h>
#include <sched.h>
#include <utility>

#include "app/session/session_setup.h"

namespace asperity {

namespace {

/// Memory that programs can use without swapping; unlimited where the system does not state it.
std::size_t available_memory() {
  std::ifstream file("/proc/meminfo");
  for (std::string name{}; file >> name;) {
    std::size_t kibibytes = 0;
    if (name == "MemAvailable:" && file >> kibibytes) return kibibytes * 1024;
  }
  return SIZE_MAX;
}

/// Threads that wake up, such as the servo loop and the windows, preempt this one, and it preempts none. Its share of a
/// busy processor remains that of the others: the session may wait for it.
void yield_to_others() {
  const sched_param parameters{};
  // If it fails, the thread is scheduled like the others.
  static_cast<void>(pthread_setschedparam(pthread_self(), SCHED_BATCH, &parameters));
}

bool is_same(const NextTrial& one, const NextTrial& other) {
  return one.attempt == other.attempt && one.trial.ordinal == other.trial.ordinal &&
         json_of(one.trial) == json_of(other.trial);
}

bool has_matched_force(const Trial& trial) {
  return std::any_of(trial.presentations.begin(), trial.presentations.end(),
                     [](const PlannedPresentation& each) { return each.equal_force.has_value(); });
}

}  // namespace

UpcomingSurfaces::UpcomingSurfaces(StimulusBuilder& builder, Study& study)
    : builder_(builder), study_(study) {}

UpcomingSurfaces::~UpcomingSurfaces() = default;

void UpcomingSurfaces::begin(const SessionRow& session) {
  make_ahead({});
  // A candidate under way reads the row.
  if (thread_.joinable()) {
    thread_.request_stop();
    thread_.join();
  }
  session_ = session;
}

void UpcomingSurfaces::make_ahead(std::vector<NextTrial> trials) {
  const std::vector<std::shared_ptr<Candidate>> earlier = std::exchange(candidates_, {});
  for (NextTrial& next : trials) {
    if (has_matched_force(next.trial)) continue;
    const auto known = std::find_if(earlier.begin(), earlier.end(), [&next](const auto& each) {
      return is_same(each->next, next);
    });
    if (known != earlier.end()) {
      candidates_.push_back(*known);
      continue;
    }
    auto candidate = std::make_shared<Candidate>();
    candidate->next = std::move(next);
    candidate->is_likeliest = candidates_.empty();
    candidate->result = candidate->made.get_future();
    candidates_.push_back(std::move(candidate));
  }
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
    std::copy_if(candidates_.begin(), candidates_.end(), std::back_inserter(waiting_),
                 [](const auto& candidate) { return !candidate->is_begun; });
  }
  if (candidates_.empty()) return;
  if (!thread_.joinable()) {
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }
  changed_.notify_one();
}

void UpcomingSurfaces::run(const std::stop_token& stop) {
  yield_to_others();
  for (;;) {
    std::shared_ptr<Candidate> candidate{};
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, stop, [this] { return !waiting_.empty(); });
      if (stop.stop_requested()) return;
      candidate = std::move(waiting_.front());
      waiting_.pop_front();
      candidate->is_begun = candidate->is_likeliest || available_memory() > kKeptFree;
      if (!candidate->is_begun) continue;
    }
    try {
      const PrepareStimulus prepare = [this](const PlannedPresentation& planned) {
        return builder_.unmatched(planned.stimulus);
      };
      candidate->made.set_value(TrialSurfaces(candidate->next.trial, Layout{session_.mirrored},
                                              prepare, random_of(candidate->next)));
    } catch (...) {
      candidate->made.set_exception(std::current_exception());
    }
  }
}

Random UpcomingSurfaces::random_of(const NextTrial& next) const {
  return random_of_attempt(session_, next.trial.ordinal, next.attempt);
}

TrialSurfaces UpcomingSurfaces::take(const Trial& trial, int attempt) {
  const NextTrial wanted{.trial = trial, .attempt = attempt};
  const auto found =
      std::find_if(candidates_.begin(), candidates_.end(),
                   [&wanted](const auto& each) { return is_same(each->next, wanted); });
  if (found != candidates_.end()) {
    const std::shared_ptr<Candidate> candidate = *found;
    candidates_.erase(found);
    bool is_begun = false;
    {
      const std::lock_guard lock(mutex_);
      std::erase(waiting_, candidate);
      is_begun = candidate->is_begun;
    }
    // Surfaces that could not be made are made again below, where the error is reported.
    try {
      if (is_begun) return candidate->result.get();
    } catch (const std::exception&) {
    }
  }
  return TrialSurfaces(
      trial, Layout{session_.mirrored},
      [this](const PlannedPresentation& planned) { return builder_.prepare(planned, &study_); },
      random_of(wanted));
}

}  // namespace asperity
