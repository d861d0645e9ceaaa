// Reads what the scripts of this folder wrote.

#pragma once

#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity {

/// A table with a line of names; an empty cell is nothing.
class RTable final {
 public:
  explicit RTable(const std::string& file) {
    std::ifstream in(std::string(ASPERITY_SOURCE_DIR) + "/tests/analysis/computed_in_r/" + file);
    if (!in) throw std::runtime_error(file + " cannot be read");
    std::string line{};
    std::getline(in, line);
    names_ = cells_of(line);
    while (std::getline(in, line)) {
      rows_.push_back(cells_of(line));
      if (rows_.back().size() != names_.size()) throw std::runtime_error(file + ": " + line);
    }
  }

  std::size_t rows() const { return rows_.size(); }
  std::size_t columns() const { return names_.size(); }
  const std::string& text(std::size_t row, std::size_t column) const {
    return rows_.at(row).at(column);
  }
  double number(std::size_t row, std::size_t column) const { return std::stod(text(row, column)); }
  double number(std::size_t row, const std::string& name) const {
    for (std::size_t column = 0; column < names_.size(); ++column) {
      if (names_[column] == name) return number(row, column);
    }
    throw std::runtime_error("no column " + name);
  }

 private:
  static std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells{};
    std::stringstream in(line + ',');
    for (std::string cell{}; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
  }

  std::vector<std::string> names_{};
  std::vector<std::vector<std::string>> rows_{};
};

/// The numbers of a file `…_expected.csv`.
class RResults final {
 public:
  explicit RResults(const std::string& file) {
    const RTable table(file);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      values_[table.text(row, 0) + ',' + table.text(row, 1)] = table.number(row, 2);
    }
  }

  double at(const std::string& quantity, const std::string& key = {}) const {
    return values_.at(quantity + ',' + key);
  }
  double at(const std::string& quantity, std::size_t number) const {
    return at(quantity, std::to_string(number));
  }
  bool has(const std::string& quantity, const std::string& key = {}) const {
    return values_.contains(quantity + ',' + key);
  }

 private:
  std::map<std::string, double> values_{};
};

}  // namespace asperity
