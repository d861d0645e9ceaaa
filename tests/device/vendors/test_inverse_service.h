// A stand-in for Haply's Inverse Service, on the loopback and a free port.

#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace asperity {

/// Speaks the documented messages: a list of devices on connection, then one update for each message, with what the
/// message asked for applied.
class TestInverseService final {
 public:
  /// What tests arrange and see; held with `mutex`.
  struct Bench {
    std::mutex mutex{};
    std::vector<std::string> ids{"049D"};
    std::string force_field = "vector";  ///< the one that it understands
    bool tells_forces = true;
    bool numbers_sessions = true;
    bool omits_identity = false;
    std::vector<std::string> grips{};
    bool turns = true;  ///< false: what the grips tell as their turn is four zeros
    std::string preset = "defaults";
    std::string axes = "XYZ";
    double scale = 1.0;  ///< of the workspace
    std::array<double, 3> position_m{0.0, -0.12, 0.15};
    bool answers_forces = true;  ///< false: what asks for any but zero gets no answer
    int answers_to_drop = 0;
    bool was_dropped = false;     ///< the last answer
    double after_a_drop_N = 0.0;  ///< the strongest force asked for next
    int delay_ms = 0;
    int answers_to_delay = 0;         ///< as long as delay_ms says; 0: all
    bool counts_in_position = false;  ///< x is the number of the answer
    bool talks_nonsense = false;
    bool lists_nothing = false;  ///< says no word to whoever connects
    bool refuses_connections = false;
    bool stalls = false;  ///< takes one message, and then nothing off the line until this is over

    int messages = 0;
    int answers = 0;
    int connections = 0;
    std::array<double, 3> force_N{0.0, 0.0, 0.0};
    double strongest_N = 0.0;
    std::vector<std::string> profiles{};
  };

  TestInverseService();
  ~TestInverseService();
  TestInverseService(const TestInverseService&) = delete;
  TestInverseService& operator=(const TestInverseService&) = delete;

  Bench& bench() noexcept;
  std::string place() const;  ///< "127.0.0.1:PORT"
  /// Ends every connection.
  void disconnect();

 private:
  struct Server;
  std::unique_ptr<Server> server_;
};

}  // namespace asperity
