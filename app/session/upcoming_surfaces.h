// The surfaces of the trials that can follow, which are made while the present trial is carried out.

#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <future>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "app/session/layout.h"
#include "app/session/stimulus_builder.h"
#include "app/session/trial_surfaces.h"
#include "protocols/plan/plan.h"
#include "results_schema/rows.h"

namespace asperity {

/// A trial that can be next, and the number that its attempt would have.
struct NextTrial {
  Trial trial{};
  int attempt = 1;
};

/// Makes the surfaces of attempts, and on request those of the attempts that can follow.
///
/// A renderer can take a second to make (`pd_gradient`: both textures are analysed, once for every mesh and gain). While a
/// trial is carried out, a thread that preempts no other makes the surfaces of the trials that its outcomes lead to, in the order
/// given; `take` waits for surfaces that are under way, and makes those that are not. The surfaces are the same in every
/// case: they depend on the trial, the attempt and the seed of the session alone.
///
/// Surfaces of the first of these trials are always made, those of the others only while more than `kKeptFree` of memory is
/// available on the computer. Stimuli with a matched force are not made ahead: their solution is stored in the study, which
/// belongs to the thread of the session.
///
/// Threads: all functions belong to the thread of the session.
class UpcomingSurfaces final {
 public:
  /// In bytes.
  static constexpr std::size_t kKeptFree = std::size_t{1} << 30;

  /// Both must outlive the object.
  UpcomingSurfaces(StimulusBuilder& builder, Study& study);
  ~UpcomingSurfaces();
  UpcomingSurfaces(const UpcomingSurfaces&) = delete;
  UpcomingSurfaces& operator=(const UpcomingSurfaces&) = delete;

  /// Begins the session of this row; discards what was made.
  void begin(const SessionRow& session);
  /// Makes the surfaces of these trials from now on, and discards those of others. Those that are made or under way are
  /// kept. The likeliest comes first.
  void make_ahead(std::vector<NextTrial> trials);
  /// Errors: as the constructor of TrialSurfaces.
  TrialSurfaces take(const Trial& trial, int attempt);

 private:
  struct Candidate {
    NextTrial next{};
    bool is_likeliest = false;
    bool is_begun = false;  ///< guarded by the mutex
    std::promise<TrialSurfaces> made{};
    std::future<TrialSurfaces> result{};
  };

  void run(const std::stop_token& stop);
  Random random_of(const NextTrial& next) const;

  StimulusBuilder& builder_;
  Study& study_;
  SessionRow session_{};
  std::vector<std::shared_ptr<Candidate>> candidates_{};
  std::mutex mutex_{};
  std::condition_variable_any changed_{};
  std::deque<std::shared_ptr<Candidate>> waiting_{};  ///< guarded by the mutex
  std::jthread thread_{};                             ///< runs from the first `make_ahead` on
};

}  // namespace asperity
