// Implements the thread of the servo loop: it requests its privileges and sleeps until absolute deadlines, or it
// supervises the calls of a device with its own pacing.

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

#include <linux/capability.h>
#include <time.h>

#include "renderers/servo/servo_time.h"

namespace asperity {
namespace {

// Above all threads of a desktop, below the kernel's own threads (watchdog, migration).
constexpr int kFifoPriority = 80;
// Larger than the stack use of a tick; touched before the first tick, so that no tick causes a page fault.
constexpr std::size_t kStack_bytes = 256 * 1024;

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
int ask_for_fifo() noexcept {
  const sched_param priority{kFifoPriority};
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
}

}  // namespace

struct ServoThread::Pacer {
  ServoLoop& loop;
  HapticDevice& device;
  std::atomic<bool> stopping{false};
  std::thread thread{};

  Pacer(ServoLoop& the_loop, HapticDevice& the_device) : loop(the_loop), device(the_device) {}

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
    }
    device.zero_force();
  }
};

// The callback of the device's own thread and the supervision of its calls.
struct ServoThread::Called {
  ServoLoop& loop;
  HapticDevice& device;
  const std::int64_t period_ns;
  const std::int64_t longest_silence_ns;

  // Accessed by the device's thread only; its calls are sequential.
  std::int64_t due_ns = 0;
  bool has_ticked = false;

  std::atomic<std::int64_t> last_call_ns{0};
  std::mutex mutex{};
  std::condition_variable wake{};
  bool stopping = false;
  std::thread watch{};

  Called(ServoLoop& the_loop, HapticDevice& the_device)
      : loop(the_loop),
        device(the_device),
        period_ns(period_ns_of(the_loop.settings().rate_Hz)),
        longest_silence_ns(
            std::llround(1e9 * std::min(the_loop.settings().silence_to_fault_s, 1e9))) {}

  ~Called() {
    device.stop_calls();
    {
      const std::lock_guard lock(mutex);
      stopping = true;
    }
    wake.notify_all();
    if (watch.joinable()) watch.join();
    device.zero_force();
  }

  void start() {
    last_call_ns.store(monotonic_now_ns());
    device.start_calls(
        {.function = [](void* called) noexcept { static_cast<Called*>(called)->tick(); },
         .argument = this,
         .rate_Hz = loop.settings().rate_Hz});
    last_call_ns.store(
        monotonic_now_ns());  // starting may take a device longer than its permitted silence
    watch = std::thread([this] { watch_calls(); });
  }

  void tick() noexcept {
    const std::int64_t started_ns = monotonic_now_ns();
    // The call that ends a silence may occur before the watch thread has detected the silence.
    if (has_ticked &&
        started_ns - last_call_ns.load(std::memory_order_relaxed) > longest_silence_ns) {
      lose_device();
    }
    last_call_ns.store(started_ns, std::memory_order_relaxed);
    loop.tick(started_ns, has_ticked ? due_ns : started_ns, &monotonic_now_ns);
    due_ns = started_ns + period_ns;
    has_ticked = true;
  }

  void watch_calls() {
    const std::chrono::nanoseconds between(
        std::clamp<std::int64_t>(longest_silence_ns / 5, 1, 100'000'000));
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, between, [this] { return stopping; })) {
      const std::int64_t silence_ns =
          monotonic_now_ns() - last_call_ns.load(std::memory_order_relaxed);
      if (silence_ns > longest_silence_ns) lose_device();
    }
  }

  // The reason is stored first: a reader of the fault finds the device's message with it.
  void lose_device() noexcept {
    device.note_silence();
    loop.lose_device();
  }
};

ServoThread::ServoThread(ServoLoop& loop, HapticDevice& device, Scheduling scheduling) {
  if (device.capability().pacing == Pacing::theirs) {
    start_being_called(loop, device, scheduling);
  } else {
    start_pacing(loop, device, scheduling);
  }
}

void ServoThread::start_being_called(ServoLoop& loop, HapticDevice& device, Scheduling scheduling) {
  const std::string& name = device.capability().name;
  if (scheduling == Scheduling::fifo) {
    throw std::runtime_error(
        "SCHED_FIFO cannot be required with the device " + name +
        ", whose own thread runs the servo loop; allow the servo loop to run without SCHED_FIFO");
  }
  locked_memory_ = memory_locked();
  scheduling_ = "called by the thread of " + name;
  scheduling_ += locked_memory_ ? ", memory locked" : ", memory not locked";
  called_ = std::make_unique<Called>(loop, device);
  try {
    called_->start();
  } catch (...) {
    called_.reset();
    if (locked_memory_) munlockall();
    throw;
  }
}

void ServoThread::start_pacing(ServoLoop& loop, HapticDevice& device, Scheduling scheduling) {
  pacer_ = std::make_unique<Pacer>(loop, device);
  std::promise<int> fifo_answer;
  std::future<int> fifo_error = fifo_answer.get_future();
  std::promise<bool> may_start;
  pacer_->thread = std::thread(
      [pacer = pacer_.get(), scheduling, &fifo_answer, start = may_start.get_future()]() mutable {
        // The timer slack of a normal thread is 50 µs unless it is set.
        prctl(PR_SET_TIMERSLACK, 1UL);
        fifo_answer.set_value(scheduling == Scheduling::normal ? 0 : ask_for_fifo());
        if (start.get()) pacer->run();
      });
  const int error = fifo_error.get();
  if (error != 0 && scheduling == Scheduling::fifo) {
    may_start.set_value(false);
    pacer_->thread.join();
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

ServoThread::~ServoThread() {
  called_.reset();
  if (pacer_) {
    pacer_->stopping.store(true, std::memory_order_relaxed);
    pacer_->thread.join();
  }
  if (locked_memory_) munlockall();
}

}  // namespace asperity
