// Makes the description of a force model in a plug-in from a C++ class. Header only; needs C++17.

#pragma once

#include <cstdio>
#include <exception>
#include <type_traits>
#include <utility>

#include "asperity_plugin.h"

namespace asperity_plugin {

/// Calls `work`, which must not end with an exception in a program that is written in another language or was compiled by another
/// compiler: an exception becomes a message and an error.
template <class Work>
int guarded(char* message, std::size_t message_size, Work&& work) noexcept {
  const auto write = [&](const char* text) { std::snprintf(message, message_size, "%s", text); };
  try {
    std::forward<Work>(work)();
    return 0;
  } catch (const std::exception& error) {
    write(error.what());
  } catch (...) {
    write("an exception that is not a std::exception");
  }
  return 1;
}

template <class Model, class = void>
inline constexpr bool has_reset = false;
template <class Model>
inline constexpr bool has_reset<Model, std::void_t<decltype(std::declval<Model&>().reset(
                                           std::declval<const asperity_sample&>()))>> = true;

/// Fills in the functions of `description` from a class with
///
///   explicit Model(const asperity_inputs&);            // throws for inputs that it refuses
///   static asperity_band band(const asperity_inputs&);
///   void reset(const asperity_sample& first);          // may be left out by a class without state
///   asperity_force tick(const asperity_sample&);
///
/// `reset` and `tick` should not throw: an exception allocates. If they do, it is caught, and the force is set to zero.
template <class Model>
asperity_model model_of(asperity_model description) {
  struct Renderer {
    explicit Renderer(const asperity_inputs& inputs) : model(inputs) {}
    Model model;
    char message[256]{};
  };
  description.abi_version = ASPERITY_PLUGIN_ABI_VERSION;
  description.band = [](const asperity_inputs* inputs, asperity_band* band) -> int {
    char ignored[1]{};
    return guarded(ignored, sizeof ignored, [&] { *band = Model::band(*inputs); });
  };
  description.create = [](const asperity_inputs* inputs, char* message,
                          std::size_t message_size) -> void* {
    Renderer* made = nullptr;
    guarded(message, message_size, [&] { made = new Renderer(*inputs); });
    return made;
  };
  description.destroy = [](void* renderer) { delete static_cast<Renderer*>(renderer); };
  description.reset = [](void* renderer, const asperity_sample* first) -> int {
    auto& own = *static_cast<Renderer*>(renderer);
    own.message[0] = 0;
    return guarded(own.message, sizeof own.message, [&] {
      if constexpr (has_reset<Model>) own.model.reset(*first);
    });
  };
  description.tick = [](void* renderer, const asperity_sample* sample,
                        asperity_force* force) -> int {
    auto& own = *static_cast<Renderer*>(renderer);
    return guarded(own.message, sizeof own.message, [&] { *force = own.model.tick(*sample); });
  };
  description.message = [](const void* renderer) -> const char* {
    return static_cast<const Renderer*>(renderer)->message;
  };
  return description;
}

}  // namespace asperity_plugin
