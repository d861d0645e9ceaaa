// A maker's shared library, found and loaded while the program runs.

#include "device/vendor_library.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <utility>

#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <locale.h>

namespace asperity {
namespace {

// While it lives, this thread's messages of the C library are the untranslated ones: whether a file was not found,
// the loader tells by its words alone.
class UntranslatedMessages final {
 public:
  UntranslatedMessages()
      : plain_(newlocale(LC_ALL_MASK, "C", nullptr)),
        before_(plain_ == nullptr ? nullptr : uselocale(plain_)) {}
  ~UntranslatedMessages() {
    if (plain_ == nullptr) return;
    uselocale(before_);
    freelocale(plain_);
  }
  UntranslatedMessages(const UntranslatedMessages&) = delete;
  UntranslatedMessages& operator=(const UntranslatedMessages&) = delete;

 private:
  locale_t plain_ = nullptr;
  locale_t before_ = nullptr;
};

std::string last_words() {
  const char* words = dlerror();
  return words == nullptr ? "no reason reported" : words;
}

// What an ELF file says of the machine that it is for.
struct Architecture {
  unsigned bits = 0;
  unsigned machine = 0;
  bool operator==(const Architecture&) const = default;
};

std::optional<Architecture> architecture_of(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  std::array<char, EI_NIDENT + 4> head{};
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(head.data(), head.size()) || std::memcmp(head.data(), ELFMAG, SELFMAG) != 0) {
    return std::nullopt;
  }
  // e_ident, e_type and e_machine stand at the same place for 32 and for 64 bits.
  const auto low = static_cast<unsigned char>(head[EI_NIDENT + 2]);
  const auto high = static_cast<unsigned char>(head[EI_NIDENT + 3]);
  return Architecture{.bits = head[EI_CLASS] == ELFCLASS64 ? 64U : 32U,
                      .machine = static_cast<unsigned>(low) | static_cast<unsigned>(high) << 8U};
}

std::string name_of(const Architecture& architecture) {
  std::string machine = "machine " + std::to_string(architecture.machine);
  switch (architecture.machine) {
    case EM_386:
      machine = "x86";
      break;
    case EM_X86_64:
      machine = "x86_64";
      break;
    case EM_ARM:
      machine = "ARM";
      break;
    case EM_AARCH64:
      machine = "ARM 64";
      break;
    default:
      break;
  }
  return machine + ", " + std::to_string(architecture.bits) + " bits";
}

// Why a file that is there was not loaded. The loader itself calls one for another machine "not found".
std::string refusal_of(const std::string& product, const std::filesystem::path& file,
                       const std::string& words) {
  const std::optional<Architecture> theirs = architecture_of(file);
  const std::optional<Architecture> ours = architecture_of("/proc/self/exe");
  const std::string beginning = product + " cannot be loaded from " + file.string() + ": ";
  if (!theirs) return beginning + "this is not a shared library; name the file of the library";
  if (ours && *theirs != *ours) {
    return beginning + "it is for another architecture (" + name_of(*theirs) +
           "); install the one for " + name_of(*ours);
  }
  return beginning + words;
}

std::filesystem::path file_of(void* library, const std::filesystem::path& name) {
  const link_map* map = nullptr;
  if (dlinfo(library, RTLD_DI_LINKMAP, &map) == 0 && map != nullptr && *map->l_name != '\0') {
    return map->l_name;
  }
  return name;
}

}  // namespace

VendorLibrary::VendorLibrary(std::string product, const std::vector<std::filesystem::path>& names)
    : product_(std::move(product)) {
  const UntranslatedMessages untranslated;
  std::string tried;
  for (const std::filesystem::path& name : names) {
    // A pipe would be waited for.
    std::error_code error;
    if (name.has_parent_path() && std::filesystem::exists(name, error) &&
        !std::filesystem::is_regular_file(name, error)) {
      throw std::runtime_error(refusal_of(product_, name, "") + ".");
    }
    // All of its own needs at once: later, in a tick, would be too late to tell.
    if (void* loaded = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
      library_ = loaded;
      file_ = file_of(loaded, name);
      return;
    }
    const std::string words = last_words();
    if (name.has_parent_path() && std::filesystem::exists(name)) {
      throw std::runtime_error(refusal_of(product_, name, words) + ".");
    }
    // Somebody named this one; whoever named none is told below that they can.
    if (name.has_parent_path()) {
      throw std::runtime_error(product_ + " is not installed at " + name.string() +
                               ": there is no such file; correct the path.");
    }
    // Otherwise the loader found something else amiss: a file that it cannot use, or one that itself needs another.
    const std::string not_found = name.string() + ": cannot open shared object file: No such file";
    if (words.compare(0, not_found.size(), not_found) != 0) {
      throw std::runtime_error(product_ + " cannot be loaded: " + words +
                               ". Install it again, or name its library with --library FILE.");
    }
    tried += (tried.empty() ? "" : ", ") + name.string();
  }
  throw std::runtime_error(product_ + " is not installed: there is no " + tried +
                           " in the system's library folders. Install it from its "
                           "manufacturer, or name its library with --library FILE.");
}

void* VendorLibrary::address_or_null(const char* name) const noexcept {
  return dlsym(library_, name);
}

void* VendorLibrary::address_of(const char* name) const {
  void* address = address_or_null(name);
  if (address == nullptr) {
    throw std::runtime_error(product_ + " in " + file_.string() + " has no function " + name +
                             ": it is not the version that this program needs. Install that "
                             "version, or name its library with --library FILE.");
  }
  return address;
}

}  // namespace asperity
