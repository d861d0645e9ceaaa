// The watchdog process of a device that this process drives.

#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <sys/types.h>

namespace asperity {

/// The child of this process that is called so; −1 where there is none. It takes its name itself, once it gets to run.
inline pid_t watchdog_child() {
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream children(task.path() / "children");
    for (pid_t child = 0; children >> child;) {
      std::ifstream comm("/proc/" + std::to_string(child) + "/comm");
      std::string name;
      if (comm >> name && name == "watchdog") return child;
    }
  }
  return -1;
}

}  // namespace asperity
