// Implements the table of a recorded texture.

#include "renderers/recordings/texture_recording.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>

#include "analysis/number_text.h"

namespace asperity {
namespace {

constexpr std::array<std::string_view, 5> kColumns{"stroke", "time_s", "path_m", "normal_force_N",
                                                   "force_N"};
constexpr const char* kColumnNames = "stroke time_s path_m normal_force_N force_N";

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells{};
  while (true) {
    const std::size_t tab = line.find('\t');
    cells.push_back(line.substr(0, tab));
    if (tab == std::string_view::npos) return cells;
    line.remove_prefix(tab + 1);
  }
}

[[noreturn]] void refuse_line(const std::string& name, std::size_t line,
                              const std::string& problem) {
  throw std::invalid_argument(name + ':' + std::to_string(line) + ": " + problem);
}

/// For each of kColumns, its place in the table.
std::array<std::size_t, kColumns.size()> places_of(std::string_view heading,
                                                   const std::string& name) {
  const std::vector<std::string_view> cells = cells_of(heading);
  std::array<std::size_t, kColumns.size()> places{};
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const auto found = std::find(cells.begin(), cells.end(), kColumns[i]);
    if (found == cells.end()) {
      refuse_line(name, 1,
                  "the column " + std::string(kColumns[i]) +
                      " is missing; a recorded texture has the tab-separated columns " +
                      kColumnNames);
    }
    places[i] = static_cast<std::size_t>(found - cells.begin());
  }
  if (cells.size() != kColumns.size()) {
    refuse_line(name, 1,
                std::string("a recorded texture has only the columns ") + kColumnNames +
                    "; remove the others");
  }
  return places;
}

}  // namespace

double RecordedStroke::speed_m_per_s() const {
  return (path_m.back() - path_m.front()) / (time_s.back() - time_s.front());
}

double RecordedStroke::mean_normal_N() const {
  double sum_N = 0.0;
  for (const double each_N : normal_N) sum_N += each_N;
  return sum_N / static_cast<double>(normal_N.size());
}

void require_strokes(const TextureRecording& recording, const std::string& name) {
  if (recording.strokes.empty()) {
    throw std::invalid_argument(name + ": the recording has no stroke; record at least two speeds");
  }
  for (std::size_t i = 0; i < recording.strokes.size(); ++i) {
    const RecordedStroke& stroke = recording.strokes[i];
    const auto complain = [&](const std::string& problem) {
      throw std::invalid_argument(name + ": stroke " + std::to_string(i + 1) + ' ' + problem);
    };
    const std::size_t count = stroke.time_s.size();
    if (count < kFewestSamplesOfStroke) {
      complain("has " + counted(count, "sample", "samples") + "; record at least " +
               std::to_string(kFewestSamplesOfStroke));
    }
    for (std::size_t j = 1; j < count; ++j) {
      if (!(stroke.time_s[j] > stroke.time_s[j - 1])) {
        complain("has a time_s that does not increase at " + number_text(stroke.time_s[j]) +
                 " s; sort its samples by time");
      }
      if (!(stroke.path_m[j] >= stroke.path_m[j - 1])) {
        complain("has a path_m that decreases at " + number_text(stroke.time_s[j]) +
                 " s; state the length of the path from the start of the stroke");
      }
    }
    if (!(stroke.path_m.back() > stroke.path_m.front())) {
      complain("does not move; record while the probe strokes the texture");
    }
    if (!(stroke.mean_normal_N() > 0.0)) {
      complain("has a mean normal force of " + number_text(stroke.mean_normal_N()) +
               " N; record in contact, with the normal force positive");
    }
  }
}

TextureRecording texture_recording_in(std::string_view tsv, const std::string& name) {
  TextureRecording recording{};
  std::array<std::size_t, kColumns.size()> places{};
  std::set<double> finished{};
  double current = 0.0;
  std::size_t line_number = 0;
  while (!tsv.empty()) {
    const std::size_t end = std::min(tsv.find('\n'), tsv.size());
    std::string_view line = tsv.substr(0, end);
    tsv.remove_prefix(std::min(end + 1, tsv.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++line_number;
    if (line_number == 1) {
      places = places_of(line, name);
      continue;
    }
    if (line.empty()) continue;
    const std::vector<std::string_view> cells = cells_of(line);
    if (cells.size() != kColumns.size()) {
      refuse_line(name, line_number,
                  "the row has " + counted(cells.size(), "cell", "cells") + "; it needs " +
                      std::to_string(kColumns.size()));
    }
    std::array<double, kColumns.size()> row{};
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string_view cell = cells[places[i]];
      const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), row[i]);
      if (read.ec != std::errc() || read.ptr != cell.data() + cell.size() ||
          !std::isfinite(row[i])) {
        refuse_line(name, line_number,
                    "the column " + std::string(kColumns[i]) + " needs a finite number, not \"" +
                        std::string(cell) + '"');
      }
    }
    if (recording.strokes.empty() || row[0] != current) {
      if (!recording.strokes.empty()) finished.insert(current);
      if (finished.contains(row[0])) {
        refuse_line(
            name, line_number,
            "stroke " + number_text(row[0]) +
                " has rows in two places; keep the rows of a stroke together, or number the "
                "second one as another stroke");
      }
      current = row[0];
      recording.strokes.emplace_back();
    }
    RecordedStroke& stroke = recording.strokes.back();
    stroke.time_s.push_back(row[1]);
    stroke.path_m.push_back(row[2]);
    stroke.normal_N.push_back(row[3]);
    stroke.force_N.push_back(row[4]);
  }
  if (line_number == 0) places_of({}, name);
  require_strokes(recording, name);
  return recording;
}

std::string tsv_of(const TextureRecording& recording) {
  std::string text{};
  for (const std::string_view column : kColumns) {
    text += (text.empty() ? "" : "\t") + std::string(column);
  }
  text += '\n';
  for (std::size_t i = 0; i < recording.strokes.size(); ++i) {
    const RecordedStroke& stroke = recording.strokes[i];
    for (std::size_t j = 0; j < stroke.time_s.size(); ++j) {
      text += std::to_string(i + 1);
      for (const double value :
           {stroke.time_s[j], stroke.path_m[j], stroke.normal_N[j], stroke.force_N[j]}) {
        text += '\t';
        text += number_text(value);
      }
      text += '\n';
    }
  }
  return text;
}

}  // namespace asperity
