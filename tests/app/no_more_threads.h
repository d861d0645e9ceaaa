// A system that has no more threads for this process.

#pragma once

#include <pthread.h>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace asperity {

/// While it lives, no thread begins: each would have a stack that no memory holds.
class NoMoreThreads final {
 public:
  NoMoreThreads() {
    pthread_getattr_default_np(&before_);
    pthread_attr_t huge;
    pthread_attr_init(&huge);
    pthread_attr_setstacksize(&huge, std::size_t{1} << 46);
    pthread_setattr_default_np(&huge);
    pthread_attr_destroy(&huge);
    try {
      std::thread([] {}).join();
    } catch (const std::system_error&) {
      return;
    }
    pthread_setattr_default_np(&before_);
    pthread_attr_destroy(&before_);
    throw std::runtime_error("threads begin all the same");
  }
  NoMoreThreads(const NoMoreThreads&) = delete;
  NoMoreThreads& operator=(const NoMoreThreads&) = delete;
  ~NoMoreThreads() {
    pthread_setattr_default_np(&before_);
    pthread_attr_destroy(&before_);
  }

 private:
  pthread_attr_t before_{};
};

}  // namespace asperity
