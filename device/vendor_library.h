// A maker's shared library, found and loaded while the program runs: never linked, never shipped.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// One loaded library and its functions.
///
/// Errors are sentences that name the product, the file and what would help: no library of these
/// names, a file for another architecture, a library that itself lacks one, a function that this
/// version does not have.
///
/// The library stays loaded until the process ends: makers' libraries leave threads of their own behind, which would
/// go on in code that is no longer there.
class VendorLibrary final {
 public:
  /// Loads the first of `names` that the system's loader finds: file names ("libdhd.so"), or paths. `product`
  /// is what people call it, e.g. "Force Dimension's SDK".
  ///
  /// Errors: std::runtime_error. A name that is not there is passed over; a file that is there and
  /// cannot be loaded is an error.
  VendorLibrary(std::string product, const std::vector<std::filesystem::path>& names);

  /// The file that was loaded.
  const std::filesystem::path& file() const noexcept { return file_; }

  /// Errors: std::runtime_error when this version of the library has no such function.
  template <typename Function>
  void find(const char* name, Function*& function) const {
    function = reinterpret_cast<Function*>(address_of(name));
  }
  /// Null where this version has no such function.
  template <typename Function>
  void find_if_there(const char* name, Function*& function) const {
    function = reinterpret_cast<Function*>(address_or_null(name));
  }

 private:
  void* address_of(const char* name) const;
  void* address_or_null(const char* name) const noexcept;

  std::string product_{};
  void* library_ = nullptr;
  std::filesystem::path file_{};
};

}  // namespace asperity
