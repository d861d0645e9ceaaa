// Draws tables from stated models and counts how often intervals cover and tests reject: see scripts/coverage.

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/coverage/coverage.h"

namespace {

std::size_t positive(std::string_view name, std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number == 0) {
    throw std::runtime_error(std::string(name) + " needs a positive whole number, not \"" +
                             std::string(text) + '"');
  }
  return number;
}

}  // namespace

int main(int count, char** arguments) try {
  using namespace asperity;
  CoverageRun run{};
  std::string file{};
  std::vector<CoveragePart> parts{};
  const std::vector<CoveragePart> all = coverage_parts();
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument == "--list") {
      for (const CoveragePart& part : all) {
        std::printf("%s\t%s\t%s\t%s\t%zu\n", std::string(part.name).c_str(),
                    std::string(part.model).c_str(), std::string(part.effect).c_str(),
                    std::string(part.spread).c_str(), part.settings.size());
      }
      return 0;
    }
    if (argument.starts_with("--")) {
      if (++i == count) throw std::runtime_error(std::string(argument) + " needs a value");
      if (argument == "--out") {
        file = arguments[i];
      } else if (argument == "--tables") {
        run.tables = positive(argument, arguments[i]);
      } else if (argument == "--seed") {
        run.seed = positive(argument, arguments[i]);
      } else if (argument == "--jobs") {
        run.jobs = positive(argument, arguments[i]);
      } else {
        throw std::runtime_error("there is no option " + std::string(argument) +
                                 "; there are --list, --out, --tables, --seed and --jobs");
      }
      continue;
    }
    const auto found = std::find_if(all.begin(), all.end(), [argument](const CoveragePart& part) {
      return part.name == argument;
    });
    if (found == all.end()) {
      throw std::runtime_error("there is no part \"" + std::string(argument) +
                               "\"; --list lists them");
    }
    parts.push_back(*found);
  }
  if (file.empty()) throw std::runtime_error("--out FILE is needed: the counts are added to it");
  if (parts.empty()) parts = all;
  append_counts(file, parts, run, [](const std::string& rows) {
    std::fputs(rows.c_str(), stdout);
    std::fflush(stdout);
  });
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "coverage: %s\n", error.what());
  return 1;
}
