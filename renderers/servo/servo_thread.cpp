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
#include <cstddef>
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

}  // namespace

// What the servo thread and its watch use. The watch keeps it where a tick does not return.
struct ServoThread::Ticks {
  ServoLoop& loop;
  HapticDevice& device;
  const std::shared_ptr<void> kept;   // what both live in; null where they outlive every tick
  std::atomic<bool> stopping{false};  // no tick of the loop begins

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

  void look(TickWatch& watch, std::int64_t& looks_without_tick) noexcept {
    if (all_forces_end.load()) {
      // The tick sends zero first, where it returns.
      if (loop.status().fault == Fault::emergency_stop) device.zero_force_from_outside();
      loop.emergency_stop();
      return;
    }
    const TickWatch::Verdict verdict = watch.look(loop.progress(), monotonic_now_ns());
    if (verdict == TickWatch::Verdict::well) {
      looks_without_tick = 0;
      return;
    }
    // Again at each look, after a fault that was cleared in vain.
    if (verdict == TickWatch::Verdict::silent) {
      lose_device();
    } else {
      loop.stand_still();
    }
    // From the next look on: a tick that was only late sends zero by itself, in its own thread.
    if (++looks_without_tick == 1) return;
    device.zero_force_from_outside();
    if (looks_without_tick == kLooksBeforeDemotion) demote();
  }

  // The reason is stored first: a reader of the fault finds the device's message with it.
  void lose_device() noexcept {
    device.note_silence();
    loop.lose_device();
  }

  void watch_ticks() {
    TickWatch watch(loop.settings(), device.capability().pacing);
    std::int64_t looks_without_tick = 0;
    std::unique_lock lock(mutex);
    constexpr std::chrono::nanoseconds kBetween(TickWatch::kBetweenLooks_ns);
    while (!wake.wait_for(lock, kBetween, [this] { return state == Watch::ended; })) {
      if (state == Watch::left_behind && !is_under_way()) break;
      lock.unlock();
      look(watch, looks_without_tick);
      lock.lock();
    }
    const bool is_last = state == Watch::left_behind;
    lock.unlock();
    if (is_last) end();
    --watched_threads;
  }

  void tell_watch(Watch what) {
    {
      const std::lock_guard lock(mutex);
      state = what;
    }
    wake.notify_all();
  }

  // False where a tick does not return: after as long as it takes to be a fault where no surface is presented.
  bool ends_in_time() const {
    constexpr double kBetween_s = 2e-4;
    const double longest_s = TickWatch::kWithoutSurface * loop.settings().standstill_to_fault_s;
    for (double waited_s = 0.0; is_under_way(); waited_s += kBetween_s) {
      if (kept != nullptr && waited_s > longest_s) return false;
      std::this_thread::sleep_for(std::chrono::duration<double>(kBetween_s));
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
    is_demoted.store(true);
    const sched_param none{0};
    (void)pthread_setschedparam(thread.native_handle(), SCHED_OTHER, &none);
  }

  void run() noexcept {
    touch_stack();
    const std::int64_t period_ns = period_ns_of(loop.settings().rate_Hz);
    const DeadlineGrid grid{monotonic_now_ns() + period_ns, period_ns};
    NextTick next{grid.first_ns, grid.first_ns};
    while (!stopping.load(std::memory_order_relaxed)) {
      sleep_until(next.wake_ns);
      const std::int64_t started_ns = monotonic_now_ns();
      loop.tick(started_ns, next.due_ns, &monotonic_now_ns);
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
      tick_loop();
    }
    is_in_tick.store(false);
  }

  void tick_loop() noexcept {
    const std::int64_t started_ns = monotonic_now_ns();
    // The call that ends a silence may occur before the watch has detected the silence.
    if (has_ticked && started_ns - last_call_ns > longest_silence_ns) lose_device();
    last_call_ns = started_ns;
    loop.tick(started_ns, has_ticked ? due_ns : started_ns, &monotonic_now_ns);
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
  pacer->thread = std::thread(
      [pacer = pacer.get(), scheduling, &fifo_answer, start = may_start.get_future()]() mutable {
        // The timer slack of a normal thread is 50 µs unless it is set.
        prctl(PR_SET_TIMERSLACK, 1UL);
        fifo_answer.set_value(scheduling == Scheduling::normal ? 0 : ask_for_fifo());
        if (start.get()) pacer->run();
      });
  const int error = fifo_error.get();
  if (error != 0 && scheduling == Scheduling::fifo) {
    may_start.set_value(false);
    pacer->thread.join();
    throw std::runtime_error(
        "SCHED_FIFO was refused (" + reason_for(error) +
        "): raise the rtprio limit of this user to at least " + std::to_string(kFifoPriority) +
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
    ticks_->tell_watch(Ticks::Watch::ended);
    watch_.join();
    ticks_->end();
  } else {
    ticks_->tell_watch(Ticks::Watch::left_behind);
    watch_.detach();
  }
  if (locked_memory_) munlockall();
}

}  // namespace asperity
