// Simulates observers and prints the errors of their thresholds, or the coverage of their intervals or posteriors, as TSV: see
// scripts/recovery.

#include <charconv>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tests/recovery/posterior_coverage.h"
#include "tests/recovery/recovery.h"
#include "tests/recovery/threshold_coverage.h"

namespace {

std::size_t positive_number(std::string_view name, std::string_view text) {
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
  RecoveryRun run{};
  std::string_view only{};
  bool of_intervals = false;
  bool of_posteriors = false;
  bool is_bayesian = false;
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument == "--list") {
      for (const auto& procedures : {recovery_procedures(), bayesian_recovery_procedures()}) {
        for (const RecoveryProcedure& procedure : procedures) {
          std::printf("%s\t%s\n", std::string(procedure.name).c_str(),
                      std::string(procedure.meaning).c_str());
        }
      }
      return 0;
    }
    if (argument == "--intervals") {
      of_intervals = true;
      continue;
    }
    if (argument == "--bayesian") {
      is_bayesian = true;
      continue;
    }
    if (argument == "--posteriors") {
      of_posteriors = true;
      continue;
    }
    if (argument != "--observers" && argument != "--jobs" && argument != "--seed" &&
        argument != "--procedure") {
      throw std::runtime_error("there is no option " + std::string(argument) +
                               "; there are --list, --bayesian, --intervals, --posteriors, "
                               "--observers, --jobs, --seed and "
                               "--procedure");
    }
    if (++i == count) throw std::runtime_error(std::string(argument) + " needs a value");
    if (argument == "--procedure") {
      only = arguments[i];
      continue;
    }
    const std::size_t number = positive_number(argument, arguments[i]);
    (argument == "--observers" ? run.observers
     : argument == "--jobs"    ? run.jobs
                               : run.seed) = number;
  }
  if (of_intervals) {
    std::printf("%s\n", interval_coverage_header().c_str());
    for (const CoverageCell& cell : coverage_cells()) {
      const IntervalCoverage coverage =
          interval_coverage(cell, {.observers = run.observers, .jobs = run.jobs, .seed = run.seed});
      std::printf("%s\n", row_text(cell, coverage).c_str());
      std::fflush(stdout);
    }
    return 0;
  }
  if (of_posteriors) {
    std::printf("%s\n", posterior_coverage_header().c_str());
    for (const PosteriorCell& cell : posterior_cells()) {
      const PosteriorCoverage coverage = posterior_coverage(
          cell, {.observers = run.observers, .jobs = run.jobs, .seed = run.seed});
      std::printf("%s\n", row_text(cell, coverage).c_str());
      std::fflush(stdout);
    }
    return 0;
  }
  std::printf("%s\n", recovery_header().c_str());
  for (const RecoveryProcedure& procedure :
       is_bayesian ? bayesian_recovery_procedures() : recovery_procedures()) {
    if (!only.empty() && procedure.name != only) continue;
    for (const RecoveryObserver& observer :
         is_bayesian ? bayesian_recovery_observers() : recovery_observers()) {
      for (const RecoveryRow& row : recovery_rows(procedure, observer, run)) {
        std::printf("%s\n", row_text(row).c_str());
      }
      std::fflush(stdout);
    }
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "recovery: %s\n", error.what());
  return 1;
}
