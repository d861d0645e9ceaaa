// A device that another process opens and closes when the program that drove it was killed.

#include "device/closing_process.h"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <stdexcept>
#include <unistd.h>

namespace asperity {

ClosingProcess::ClosingProcess(const std::filesystem::path& program, const std::string& device,
                               const std::string& claim, const std::filesystem::path& library) {
  add(program.string());
  add("close-device");
  add(device);
  add("--claim");
  add(claim);
  if (!library.empty()) {
    add("--library");
    add(std::filesystem::absolute(library).string());
  }
  watchdog_.emplace(&start, &command_, -1);
}

void ClosingProcess::add(const std::string& word) {
  std::array<char, kLongest_bytes>& place = command_.words.at(command_.count);
  if (word.size() >= place.size()) {
    throw std::length_error("\"" + word + "\" has " + std::to_string(word.size()) +
                            " bytes; it must have fewer than " + std::to_string(place.size()) +
                            " for the process that closes the device if this program is killed");
  }
  std::copy(word.begin(), word.end(), place.begin());
  command_.pointers[command_.count++] = place.data();
}

// System calls only.
void ClosingProcess::start(WatchdogProcess::Cause cause, const void* about) noexcept {
  if (cause != WatchdogProcess::Cause::ended) return;
  const Command& command = *static_cast<const Command*>(about);
  // The files of this process are closed: what the program opens first must not be its output.
  for (int file = STDIN_FILENO; file <= STDERR_FILENO; ++file) {
    const int nothing = open("/dev/null", O_RDWR);
    if (nothing != file) dup2(nothing, file);
  }
  sigset_t none{};
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  execv(command.pointers[0], command.pointers.data());
}

}  // namespace asperity
