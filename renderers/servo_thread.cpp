// The thread behind the servo loop: asks for its privileges and sleeps to absolute deadlines.

#include "renderers/servo_thread.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <future>
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

#include "renderers/servo_time.h"

namespace asperity {
namespace {

// Above everything of a desktop, below the kernel's own threads (watchdog, migration).
constexpr int kFifoPriority = 80;
// More than a tick uses, touched before the first one, so that no tick meets a page fault.
constexpr std::size_t kStack_bytes = 256 * 1024;

std::string reason_for(int error) { return std::generic_category().message(error); }

// A process with this capability may lock any amount, whatever its limit.
bool may_lock_without_limit() noexcept {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct sets[2]{};
  return syscall(SYS_capget, &header, sets) == 0 && (sets[0].effective & (1U << CAP_IPC_LOCK)) != 0;
}

// Lock the memory only where there is no limit to it: under a finite limit MCL_FUTURE would make
// some later, innocent allocation fail.
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

// What the calling thread got: 0, or the error that refused SCHED_FIFO.
int ask_for_fifo() noexcept {
  const sched_param priority{kFifoPriority};
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
}

}  // namespace

std::int64_t monotonic_now_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

struct ServoThread::Pacer {
  ServoLoop& loop;
  HapticDevice& device;
  std::atomic<bool> stopping{false};
  bool locked_memory = false;
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

ServoThread::ServoThread(ServoLoop& loop, HapticDevice& device, Scheduling scheduling)
    : pacer_(std::make_unique<Pacer>(loop, device)) {
  std::promise<int> fifo_answer;
  std::future<int> fifo_error = fifo_answer.get_future();
  std::promise<bool> may_start;
  pacer_->thread = std::thread(
      [pacer = pacer_.get(), scheduling, &fifo_answer, start = may_start.get_future()]() mutable {
        // A normal thread's sleeps are rounded up by 50 µs unless it asks otherwise.
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
        " in /etc/security/limits.d, or allow the servo thread to run without it");
  }
  pacer_->locked_memory = memory_locked();
  if (scheduling == Scheduling::normal) {
    scheduling_ = "SCHED_OTHER";
  } else if (error == 0) {
    scheduling_ = "SCHED_FIFO " + std::to_string(kFifoPriority);
  } else {
    scheduling_ = "SCHED_OTHER (SCHED_FIFO was refused: " + reason_for(error) + ")";
  }
  scheduling_ += pacer_->locked_memory ? ", memory locked" : ", memory not locked";
  may_start.set_value(true);
}

ServoThread::~ServoThread() {
  pacer_->stopping.store(true, std::memory_order_relaxed);
  pacer_->thread.join();
  if (pacer_->locked_memory) munlockall();
}

}  // namespace asperity
