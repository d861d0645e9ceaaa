// Where on the network a host is, asked so that nobody waits for a resolver that does not answer.

#include "device/inverse3/host_address.h"

#include <array>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <sys/socket.h>
#include <thread>
#include <utility>

#include <netdb.h>

namespace asperity {
namespace {

struct Addresses {
  int error = 0;  ///< of getaddrinfo
  std::string first{};
};

Addresses addresses_of(const std::string& host, int flags) {
  addrinfo wanted{};
  wanted.ai_family = AF_UNSPEC;
  wanted.ai_socktype = SOCK_STREAM;
  wanted.ai_flags = flags;
  addrinfo* answer = nullptr;
  Addresses found{.error = ::getaddrinfo(host.c_str(), nullptr, &wanted, &answer)};
  if (found.error != 0) return found;
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> all(answer, &::freeaddrinfo);
  const addrinfo* best = answer;
  for (const addrinfo* one = answer; one != nullptr; one = one->ai_next) {
    if (one->ai_family != AF_INET) continue;
    best = one;
    break;
  }
  std::array<char, NI_MAXHOST> text{};
  found.error = ::getnameinfo(best->ai_addr, best->ai_addrlen, text.data(), text.size(), nullptr, 0,
                              NI_NUMERICHOST);
  if (found.error == 0) found.first = text.data();
  return found;
}

// What the asking thread and the waiting one share; the last of them lets go of it.
struct Lookup {
  std::mutex mutex{};
  std::condition_variable_any changed{};
  bool is_here = false;
  std::string address{};
  std::string refusal{};
};

}  // namespace

std::string look_up(const std::string& host) {
  const Addresses found = addresses_of(host, 0);
  if (found.error != 0) {
    throw std::runtime_error("The host \"" + host + "\" cannot be found (" +
                             ::gai_strerror(found.error) +
                             "): correct its name, or give its IP address, such as 127.0.0.1.");
  }
  return found.first;
}

std::string host_address(const std::string& host, std::chrono::milliseconds patience,
                         const std::stop_token& stop,
                         const std::function<std::string(const std::string&)>& ask) {
  const Addresses number = addresses_of(host, AI_NUMERICHOST);
  if (number.error == 0) return number.first;
  if (host == "localhost") return "127.0.0.1";
  const auto lookup = std::make_shared<Lookup>();
  std::thread([lookup, host, ask] {
    std::string address;
    std::string refusal;
    try {
      address = ask(host);
    } catch (const std::exception& error) {
      refusal = error.what();
    }
    const std::lock_guard lock(lookup->mutex);
    lookup->address = std::move(address);
    lookup->refusal = std::move(refusal);
    lookup->is_here = true;
    lookup->changed.notify_all();
  }).detach();
  std::unique_lock lock(lookup->mutex);
  if (!lookup->changed.wait_for(lock, stop, patience, [&lookup] { return lookup->is_here; })) {
    throw std::runtime_error("The host \"" + host + "\" was not found " +
                             (stop.stop_requested()
                                  ? "before the search was stopped on request."
                                  : "within " + std::to_string(patience.count()) +
                                        " ms: give its IP address, such as 127.0.0.1."));
  }
  if (!lookup->refusal.empty()) throw std::runtime_error(lookup->refusal);
  return lookup->address;
}

}  // namespace asperity
