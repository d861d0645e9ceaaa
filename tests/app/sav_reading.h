// An SPSS file read back by the library that other programs read it with.

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <readstat.h>

namespace asperity {

/// An SPSS file as ReadStat reads it back.
struct Sav {
  struct Variable {
    std::string name{};
    std::string label{};
    std::string labels{};
    readstat_measure_t measure{};
    int missing_ranges = 0;
  };
  std::vector<Variable> variables{};
  std::vector<std::map<std::string, std::string>> rows{};  ///< "." for missing
  std::map<std::string, std::map<double, std::string>> value_labels{};
};

Sav sav(const std::filesystem::path& path);

}  // namespace asperity
