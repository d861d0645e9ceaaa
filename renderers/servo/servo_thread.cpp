// Implements the thread of the servo loop, which requests its privileges and sleeps until absolute deadlines, or the calls of
// a device with its own pacing; and the watch over the ticks of either.

#include "renderers/servo/servo_thread.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <future>
#include <mutex>
#include <pthread.h>
#include <sched.h>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

#include <linux/capability.h>
#include <time.h>

#include "renderers/servo/servo_time.h"
#include "renderers/servo/tick_watch.h"

namespace asperity {
namespace {

// Above all threads of a desktop, below the kernel's own threads (watchdog, migration).
constexpr int kFifoPriority = 80;
// Above the servo thread and the threads of drivers: it sleeps, and looks for a few microseconds.
constexpr int kWatchPriority = kFifoPriority + 2;
// A second, in looks of the watch. A tick that is only late keeps its priority.
constexpr std::int64_t kLooksBeforeDemotion = 1'000'000'000 / TickWatch::kBetweenLooks_ns;
// Larger than the stack use of a tick; touched before the first tick, so that no tick causes a page fault.
constexpr std::size_t kStack_bytes = 256 * 1024;

// Of the process, as the signals that end it are.
constinit std::atomic<bool> all_forces_end{false};
constinit std::atomic<int> watched_threads{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

std::string reason_for(int error) { return std::generic_category().message(error); }

// A process with this capability may lock any amount of memory, regardless of its limit.
bool may_lock_without_limit() noexcept {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct sets[2]{};
  return syscall(SYS_capget, &header, sets) == 0 && (sets[0].effective & (1U << CAP_IPC_LOCK)) != 0;
}

// Memory is locked only if there is no limit: under a finite limit MCL_FUTURE would make a later, unrelated allocation
// fail.
bool memory_locked() noexcept {
  rlimit limit{};
  const bool unlimited = getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
  if (!unlimited && !may_lock_without_limit()) return false;
  return mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
}

void touch_stack() noexcept {
  std::array<volatile char, kStack_bytes> stack;
  for (std::size_t i = 0; i < stack.size(); i += 1024) stack[i] = 0;
}

void sleep_until(std::int64_t time_ns) noexcept {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  const timespec time{static_cast<time_t>(time_ns / kSecond_ns),
                      static_cast<long>(time_ns % kSecond_ns)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
  }
}

// The result of the request of the calling thread: 0, or the error code with which SCHED_FIFO was refused.
int ask_for_fifo(int level = kFifoPriority) noexcept {
  const sched_param priority{level};
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
}

/// While it lives, no signal is handled in this thread, and in those that it creates, except those of an error in the thread
/// itself: a handler must not delay a tick or the watch.
class BlockedSignals final {
 public:
  BlockedSignals() noexcept {
    sigset_t blocked{};
    sigfillset(&blocked);
    for (const int of_error : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP}) {
      sigdelset(&blocked, of_error);
    }
    pthread_sigmask(SIG_BLOCK, &blocked, &before_);
  }
  ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

// What the servo thread and its watch use. The watch keeps it where a tick does not return.
struct ServoThread::Ticks {
  ServoLoop& loop;
  HapticDevice& device;
  const std::shared_ptr<void> kept;   // what both live in; null where they outlive every tick
  std::atomic<bool> stopping{false};  // no tick of the loop begins
  std::atomic<bool> watch_has_ended{false};

  std::mutex mutex{};
  std::condition_variable wake{};
  enum class Watch {
    watching,
    ended,
    left_behind
  } state = Watch::watching;  // guarded by the mutex

  Ticks(ServoLoop& the_loop, HapticDevice& the_device, std::shared_ptr<void> what_is_kept)
      : loop(the_loop), device(the_device), kept(std::move(what_is_kept)) {}
  virtual ~Ticks() = default;
  Ticks(const Ticks&) = delete;
  Ticks& operator=(const Ticks&) = delete;

  /// Whether a tick can be under way, once `stopping` is set.
  virtual bool is_under_way() const noexcept = 0;
  /// Ends the thread of the ticks and leaves zero force; no tick is under way.
  virtual void end() noexcept = 0;
  /// The thread has been in one tick for so long that others may need its processor.
  virtual void demote() noexcept {}

  // Consecutive looks of the watch.
  struct Looks {
    std::uint64_t ended = 0;       // ticks, at the last look
    std::int64_t without_end = 0;  // of another tick
    std::int64_t with_fault = 0;   // that the watch raised
  };

  // The servo thread or the device's: an end of all forces does not depend on the watch alone.
  void tick_loop(std::int64_t now_ns, std::int64_t deadline_ns) noexcept {
    if (all_forces_end.load(std::memory_order_relaxed)) loop.emergency_stop();
    loop.tick(now_ns, deadline_ns, &monotonic_now_ns);
  }

  void look(TickWatch& watch, Looks& looks) noexcept {
    const TickProgress progress = loop.progress();
    const TickWatch::Verdict verdict = watch.look(progress, monotonic_now_ns());
    const bool is_end = all_forces_end.load();
    if (is_end) loop.emergency_stop();
    looks.without_end = progress.ended == looks.ended ? looks.without_end + 1 : 0;
    looks.ended = progress.ended;
    looks.with_fault = verdict == TickWatch::Verdict::well ? 0 : looks.with_fault + 1;
    // Again at each look, after a fault that was cleared in vain.
    if (verdict == TickWatch::Verdict::silent) lose_device();
    if (verdict == TickWatch::Verdict::standing) loop.stand_still();
    // From the second look on: a tick that was only late sends zero by itself, in its own thread.
    if (looks.with_fault > 1 || (is_end && looks.without_end > 1)) device.zero_force_from_outside();
    if (looks.with_fault == kLooksBeforeDemotion) demote();
  }

  // The reason is stored first: a reader of the fault finds the device's message with it.
  void lose_device() noexcept {
    device.note_silence();
    loop.lose_device();
  }

  void watch_ticks() {
    TickWatch watch(loop.settings(), device.capability().pacing);
    Looks looks{};
    std::unique_lock lock(mutex);
    constexpr std::chrono::nanoseconds kBetween(TickWatch::kBetweenLooks_ns);
    while (!wake.wait_for(lock, kBetween, [this] { return state == Watch::ended; })) {
      if (state == Watch::left_behind && !is_under_way()) break;
      lock.unlock();
      look(watch, looks);
      lock.lock();
    }
    const bool is_last = state == Watch::left_behind;
    lock.unlock();
    if (is_last) end();
    --watched_threads;
    watch_has_ended.store(true);
  }

  void set_watch(Watch what) {
    {
      const std::lock_guard lock(mutex);
      state = what;
    }
    wake.notify_all();
  }

  // False where a tick does not return: after as long as it takes to be a fault where no surface is presented.
  bool ends_in_time() const {
    return comes_in_time([this] { return !is_under_way(); });
  }
  // False where the manufacturer's functions do not return to the watch, after the same time.
  bool watch_ends_in_time() const {
    return comes_in_time([this] { return watch_has_ended.load(); });
  }

 private:
  template <typename Condition>
  bool comes_in_time(const Condition& has_come) const {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    constexpr Seconds kBetween(2e-4);
    const Seconds longest(TickWatch::kWithoutSurface * loop.settings().standstill_to_fault_s);
    const Clock::time_point begin = Clock::now();
    while (!has_come()) {
      if (kept != nullptr && Seconds(Clock::now() - begin) > longest) return false;
      std::this_thread::sleep_for(kBetween);
    }
    return true;
  }
};

// The thread that paces the loop.
struct ServoThread::Pacer final : Ticks {
  using Ticks::Ticks;
  std::atomic<bool> has_ended{false};
  std::atomic<bool> is_demoted{false};
  std::thread thread{};

  bool is_under_way() const noexcept override { return !has_ended.load(); }
  void end() noexcept override { thread.join(); }
  void demote() noexcept override {
    int policy = SCHED_OTHER;
    sched_param priority{};
    if (pthread_getschedparam(thread.native_handle(), &policy, &priority) != 0) return;
    if (policy != SCHED_FIFO) return;
    const sched_param none{0};
    (void)pthread_setschedparam(thread.native_handle(), SCHED_OTHER, &none);
    // Last: a tick that returns in between is followed by one after which the thread gets its priority back.
    is_demoted.store(true);
  }

  void run() noexcept {
    touch_stack();
    const std::int64_t period_ns = period_ns_of(loop.settings().rate_Hz);
    const DeadlineGrid grid{monotonic_now_ns() + period_ns, period_ns};
    NextTick next{grid.first_ns, grid.first_ns};
    while (!stopping.load(std::memory_order_relaxed)) {
      sleep_until(next.wake_ns);
      const std::int64_t started_ns = monotonic_now_ns();
      tick_loop(started_ns, next.due_ns);
      next = grid.after(started_ns, monotonic_now_ns());
      if (is_demoted.exchange(false, std::memory_order_relaxed)) (void)ask_for_fifo();
    }
    device.zero_force();
    has_ended.store(true);
  }
};

// The callback of the device's own thread.
struct ServoThread::Called final : Ticks {
  const std::int64_t period_ns;
  const std::int64_t longest_silence_ns;

  // Accessed by the device's thread only; its calls are sequential.
  std::int64_t due_ns = 0;
  std::int64_t last_call_ns = 0;
  bool has_ticked = false;

  std::atomic<bool> is_in_tick{false};

  Called(ServoLoop& the_loop, HapticDevice& the_device, std::shared_ptr<void> what_is_kept)
      : Ticks(the_loop, the_device, std::move(what_is_kept)),
        period_ns(period_ns_of(the_loop.settings().rate_Hz)),
        longest_silence_ns(
            std::llround(1e9 * std::min(the_loop.settings().silence_to_fault_s, 1e9))) {}

  bool is_under_way() const noexcept override { return is_in_tick.load(); }
  void end() noexcept override {
    device.stop_calls();
    device.zero_force();
  }

  void start() {
    device.start_calls(
        {.function = [](void* called) noexcept { static_cast<Called*>(called)->tick(); },
         .argument = this,
         .rate_Hz = loop.settings().rate_Hz});
  }

  void tick() noexcept {
    // Before the look at `stopping`: the destructor sets that first, and then looks at this.
    is_in_tick.store(true);
    if (stopping.load()) {
      device.zero_force();
    } else {
      tick_in_time();
    }
    is_in_tick.store(false);
  }

  void tick_in_time() noexcept {
    const std::int64_t started_ns = monotonic_now_ns();
    // The call that ends a silence may occur before the watch has detected the silence.
    if (has_ticked && started_ns - last_call_ns > longest_silence_ns) lose_device();
    last_call_ns = started_ns;
    tick_loop(started_ns, has_ticked ? due_ns : started_ns);
    due_ns = started_ns + period_ns;
    has_ticked = true;
  }
};

ServoThread::ServoThread(ServoLoop& loop, HapticDevice& device, Scheduling scheduling,
                         std::shared_ptr<void> kept) {
  if (device.capability().pacing == Pacing::theirs) {
    start_being_called(loop, device, scheduling, std::move(kept));
  } else {
    start_pacing(loop, device, scheduling, std::move(kept));
  }
  ++watched_threads;
  try {
    const BlockedSignals blocked;
    watch_ = std::thread([ticks = ticks_, scheduling] {
      // A servo thread in an endless loop must not keep its own watch from running.
      if (scheduling != Scheduling::normal && ask_for_fifo(kWatchPriority) != 0) {
        (void)ask_for_fifo();
      }
      ticks->watch_ticks();
    });
  } catch (...) {
    --watched_threads;
    ticks_->stopping.store(true);
    ticks_->ends_in_time();
    ticks_->end();
    if (locked_memory_) munlockall();
    throw;
  }
}

void ServoThread::start_being_called(ServoLoop& loop, HapticDevice& device, Scheduling scheduling,
                                     std::shared_ptr<void> kept) {
  const std::string& name = device.capability().name;
  if (scheduling == Scheduling::fifo) {
    throw std::runtime_error(
        "SCHED_FIFO cannot be required with the device " + name +
        ", whose own thread runs the servo loop; allow the servo loop to run without SCHED_FIFO");
  }
  locked_memory_ = memory_locked();
  scheduling_ = "called by the thread of " + name;
  scheduling_ += locked_memory_ ? ", memory locked" : ", memory not locked";
  const auto called = std::make_shared<Called>(loop, device, std::move(kept));
  ticks_ = called;
  try {
    called->start();
  } catch (...) {
    called->end();
    if (locked_memory_) munlockall();
    throw;
  }
}

void ServoThread::start_pacing(ServoLoop& loop, HapticDevice& device, Scheduling scheduling,
                               std::shared_ptr<void> kept) {
  const auto pacer = std::make_shared<Pacer>(loop, device, std::move(kept));
  ticks_ = pacer;
  std::promise<int> fifo_answer;
  std::future<int> fifo_error = fifo_answer.get_future();
  std::promise<bool> may_start;
  {
    const BlockedSignals blocked;
    pacer->thread = std::thread(
        [pacer = pacer.get(), scheduling, &fifo_answer, start = may_start.get_future()]() mutable {
          // The timer slack of a normal thread is 50 µs unless it is set.
          prctl(PR_SET_TIMERSLACK, 1UL);
          fifo_answer.set_value(scheduling == Scheduling::normal ? 0 : ask_for_fifo());
          if (start.get()) pacer->run();
        });
  }
  const int error = fifo_error.get();
  if (error != 0 && scheduling == Scheduling::fifo) {
    may_start.set_value(false);
    pacer->thread.join();
    throw std::runtime_error(
        "SCHED_FIFO was refused (" + reason_for(error) +
        "): raise the rtprio limit of this user to at least " + std::to_string(kWatchPriority) +
        " in /etc/security/limits.d, or allow the servo loop to run without SCHED_FIFO");
  }
  locked_memory_ = memory_locked();
  if (scheduling == Scheduling::normal) {
    scheduling_ = "SCHED_OTHER";
  } else if (error == 0) {
    scheduling_ = "SCHED_FIFO " + std::to_string(kFifoPriority);
  } else {
    scheduling_ = "SCHED_OTHER (SCHED_FIFO was refused: " + reason_for(error) + ")";
  }
  scheduling_ += locked_memory_ ? ", memory locked" : ", memory not locked";
  may_start.set_value(true);
}

bool ServoThread::end_all_forces() noexcept {
  all_forces_end.store(true);
  return watched_threads.load() > 0;
}

ServoThread::~ServoThread() {
  ticks_->stopping.store(true);
  if (ticks_->ends_in_time()) {
    ticks_->set_watch(Ticks::Watch::ended);
    if (ticks_->watch_ends_in_time()) {
      watch_.join();
    } else {
      watch_.detach();  // it ends by itself where the manufacturer's functions return after all
    }
    ticks_->end();
  } else {
    ticks_->set_watch(Ticks::Watch::left_behind);
    watch_.detach();
  }
  if (locked_memory_) munlockall();
}

}  // namespace asperity
