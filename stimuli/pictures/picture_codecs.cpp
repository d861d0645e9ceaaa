// Implements the search for and loading of the codecs' module.

#include "stimuli/pictures/picture_codecs.h"

#include <stdexcept>
#include <string>

#include <dlfcn.h>

namespace asperity {

namespace {

const PictureCodecs& load_codecs() {
  // The program's run path contains the module's folder (cmake/AsperityTargets.cmake).
  void* module = dlopen("picture_codecs.so", RTLD_NOW | RTLD_LOCAL);
  const void* codecs = module == nullptr ? nullptr : dlsym(module, "asperity_picture_codecs");
  if (codecs == nullptr) {
    const char* reason = dlerror();
    throw std::runtime_error(
        "Pictures can be neither read nor written: the program's module picture_codecs.so cannot "
        "be loaded (" +
        std::string(reason == nullptr ? "it is empty" : reason) +
        "). Install Asperity again, or build all its targets.");
  }
  return *static_cast<const PictureCodecs*>(codecs);
}

}  // namespace

const PictureCodecs& picture_codecs() {
  // Libraries are loaded once per process, so the reference is static.
  static const PictureCodecs& codecs = load_codecs();
  return codecs;
}

}  // namespace asperity
