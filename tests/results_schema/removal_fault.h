// Files that cannot be removed, or whose removal the program does not survive.

#pragma once

#include <string>

namespace asperity {

/// While it lives, the `n`-th call of unlink(2) or rmdir(2) from now on for a path that contains `part`, and all such calls
/// after it, fail with EIO; or this process ends before the n-th, as by kill -9. One at a time.
class RemovalFault final {
 public:
  enum class Kind { error, killed };

  RemovalFault(const std::string& part, int n, Kind kind);
  ~RemovalFault();
  RemovalFault(const RemovalFault&) = delete;
  RemovalFault& operator=(const RemovalFault&) = delete;
};

}  // namespace asperity
