// A program that is made to drive a device and to be killed.

#pragma once

#include <csignal>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace asperity {

/// Dies at once of any signal. While a core is dumped the watchdog would act as for a program that stands still, over
/// the program's own file, of which an emulated bus serves one conversation at a time; a sanitizer's handler takes so
/// long to tell of the signal that the driver has time for its own zero.
inline void die_at_once() {
  prctl(PR_SET_DUMPABLE, 0);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  for (const int signal : {SIGSEGV, SIGABRT}) std::signal(signal, SIG_DFL);
}

}  // namespace asperity
