// Finding a host, and not waiting for one that nobody finds.

#include "device/inverse3/host_address.h"

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/patience.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;
using testing::AllOf;
using testing::HasSubstr;

std::string is_not_asked(const std::string& host) { throw std::logic_error("asked for " + host); }

/// A resolver that does not answer while this lives, nor for longer than a test may take.
class SilentResolver final {
 public:
  ~SilentResolver() { state_->enough.set_value(); }
  std::function<std::string(const std::string&)> ask() const {
    // It is asked by a thread that may outlive us.
    return [state = state_](const std::string& host) {
      state->asked.set_value();
      state->enough.get_future().wait_for(kPatience);
      return host;
    };
  }
  void wait_until_asked() const { state_->asked.get_future().wait_for(kPatience); }

 private:
  struct State {
    std::promise<void> asked{};
    std::promise<void> enough{};
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

TEST(HostAddress, OfANumberAndOfThisComputerIsAskedOfNobody) {
  EXPECT_EQ(host_address("127.0.0.1", hours(1), {}, is_not_asked), "127.0.0.1");
  EXPECT_EQ(host_address("::1", hours(1), {}, is_not_asked), "::1");
  EXPECT_EQ(host_address("localhost", milliseconds(0), {}, is_not_asked), "127.0.0.1");
}

TEST(HostAddress, OfANameIsWhatTheResolverSays) {
  const auto ask = [](const std::string& host) { return host + " is 10.0.0.7"; };
  EXPECT_EQ(host_address("rig.lab", hours(1), {}, ask), "rig.lab is 10.0.0.7");
  EXPECT_THAT(refusal_of([] { host_address("rig.lab", hours(1), {}, is_not_asked); }),
              HasSubstr("asked for rig.lab"));
}

TEST(HostAddress, IsNotWaitedForBeyondThePatience) {
  const SilentResolver resolver;
  EXPECT_THAT(refusal_of([&] { host_address("rig.lab", milliseconds(20), {}, resolver.ask()); }),
              AllOf(HasSubstr("\"rig.lab\""), HasSubstr("20 ms"), HasSubstr("127.0.0.1")));
}

TEST(HostAddress, IsNotWaitedForAfterAStop) {
  const SilentResolver resolver;
  std::stop_source stop;
  std::jthread stopping([&] {
    resolver.wait_until_asked();
    stop.request_stop();
  });
  EXPECT_THAT(
      refusal_of([&] { host_address("rig.lab", hours(1), stop.get_token(), resolver.ask()); }),
      AllOf(HasSubstr("\"rig.lab\""), HasSubstr("stop")));
}

}  // namespace
}  // namespace asperity
