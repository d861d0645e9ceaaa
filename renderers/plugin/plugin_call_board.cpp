// Keeps the calls in shared memory, with a place for each thread.

#include "renderers/plugin/plugin_call_board.h"

#include <cerrno>
#include <cstring>
#include <new>
#include <sys/mman.h>
#include <system_error>

namespace asperity {

const char* text_of(PluginFunction function) noexcept {
  switch (function) {
    case PluginFunction::initialisation:
      return "its initialisation";
    case PluginFunction::model:
      return "its function asperity_plugin_model";
    case PluginFunction::description:
      return "its description";
    case PluginFunction::band:
      return "its function band";
    case PluginFunction::create:
      return "its function create";
    case PluginFunction::destroy:
      return "its function destroy";
    case PluginFunction::reset:
      return "its function reset";
    case PluginFunction::tick:
      return "its function tick";
    case PluginFunction::finalisation:
      return "its finalisation";
  }
  return "";
}

PluginCallBoard::PluginCallBoard() {
  void* const memory =
      mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    throw std::system_error(errno, std::generic_category(),
                            "no memory for the process that calls the plug-ins; close other "
                            "programs, then try again");
  }
  shared_ = new (memory) Shared{};
}

PluginCallBoard::~PluginCallBoard() { munmap(shared_, sizeof(Shared)); }

std::size_t PluginCallBoard::begin(std::size_t from, const char* name,
                                   PluginFunction function) noexcept {
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const std::size_t place = (from + i) % kPlaces;
    if (shared_->places[place].is_taken.exchange(true, std::memory_order_acquire)) continue;
    change(place, name, function);
    return place;
  }
  return kNone;
}

void PluginCallBoard::change(std::size_t place, const char* name,
                             PluginFunction function) noexcept {
  Place& of_thread = shared_->places[place];
  std::size_t length = 0;
  while (length + 1 < of_thread.name.size() && name[length] != 0) ++length;
  std::memcpy(of_thread.name.data(), name, length);
  of_thread.name[length] = 0;
  of_thread.function.store(function, std::memory_order_relaxed);
  of_thread.number.fetch_add(1, std::memory_order_release);
}

void PluginCallBoard::end(std::size_t place) noexcept {
  shared_->places[place].is_taken.store(false, std::memory_order_release);
}

void PluginCallBoard::note_signal(std::size_t place, int number) noexcept {
  shared_->place_of_signal.store(place, std::memory_order_relaxed);
  shared_->signal.store(number, std::memory_order_release);
}

void PluginCallBoard::finish(int status) noexcept {
  shared_->finished_with.store(status, std::memory_order_release);
}

std::vector<PluginCallBoard::Call> PluginCallBoard::running() const {
  std::vector<Call> calls{};
  for (std::size_t place = 0; place < kPlaces; ++place) {
    const Place& of_thread = shared_->places[place];
    if (!of_thread.is_taken.load(std::memory_order_acquire)) continue;
    calls.push_back({.place = place,
                     .number = of_thread.number.load(std::memory_order_acquire),
                     .function = of_thread.function.load(std::memory_order_relaxed),
                     .name = std::string(of_thread.name.data(),
                                         strnlen(of_thread.name.data(), of_thread.name.size()))});
  }
  return calls;
}

std::optional<PluginCallBoard::Signal> PluginCallBoard::signal() const noexcept {
  const int number = shared_->signal.load(std::memory_order_acquire);
  if (number == 0) return {};
  return Signal{number, shared_->place_of_signal.load(std::memory_order_relaxed)};
}

std::optional<int> PluginCallBoard::finished_with() const noexcept {
  const int status = shared_->finished_with.load(std::memory_order_acquire);
  if (status < 0) return {};
  return status;
}

}  // namespace asperity
