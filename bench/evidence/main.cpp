// Measures tables of the documents.

#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bench/evidence/evidence.h"

namespace asperity {
namespace {

constexpr const char* kUsage =
    "Usage: scripts/evidence NAME; scripts/evidence --help describes the names.\n";

void measure_instability(const std::vector<std::string>& words) {
  DetectionSeries order{};
  if (words.size() > 1) order.clean = std::stoull(words[1]);
  if (words.size() > 2) order.planted = std::stoull(words[2]);
  if (words.size() > 3) order.seed = std::stoull(words[3]);
  if (words.size() > 4) order.model = words[4];
  print_perceived_instability(order);
}

int run(const std::vector<std::string>& words) {
  const std::map<std::string, std::function<void()>> plain{{"friction", print_friction},
                                                           {"pd_continuity", print_pd_continuity},
                                                           {"pd_errors", print_pd_errors}};
  if (!words.empty() && words.size() <= 5 && words.front() == "perceived_instability") {
    measure_instability(words);
    return 0;
  }
  if (words.size() != 1 || !plain.contains(words.front())) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  plain.at(words.front())();
  return 0;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  try {
    return asperity::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "asperity_evidence: %s\n", error.what());
    return 1;
  }
}
