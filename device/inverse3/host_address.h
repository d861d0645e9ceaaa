// Where on the network a host is, asked so that nobody waits for a resolver that does not answer.

#pragma once

#include <chrono>
#include <functional>
#include <stop_token>
#include <string>

namespace asperity {

/// The number of a host that is a name ("192.168.0.7", "fe80::1%eth0"), from whoever knows names on this computer: of
/// IPv4 where it has one, otherwise the first. Takes as long as that takes.
/// Errors: std::runtime_error with a sentence that names the host.
std::string look_up(const std::string& host);

/// The number of `host`. Of a number, and of "localhost", which is 127.0.0.1, nobody is asked. For any other name `ask`
/// is called in a thread of its own, which outlives the call where the answer does not come within `patience` or before
/// `stop`.
/// Errors: std::runtime_error with a sentence that names the host, also for the patience and the stop.
std::string host_address(const std::string& host, std::chrono::milliseconds patience,
                         const std::stop_token& stop = {},
                         const std::function<std::string(const std::string&)>& ask = &look_up);

}  // namespace asperity
