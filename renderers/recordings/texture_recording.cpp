// Implements the table of a recorded texture.

#include "renderers/recordings/texture_recording.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "renderers/recordings/number_table.h"

namespace asperity {
namespace {

constexpr std::array<std::string_view, 5> kColumns{"stroke", "time_s", "path_m", "normal_force_N",
                                                   "force_N"};
constexpr const char* kColumnNames = "stroke time_s path_m normal_force_N force_N";

/// For each of kColumns, its place in the table.
std::array<std::size_t, kColumns.size()> places_of(const std::vector<std::string>& columns,
                                                   const std::string& name) {
  std::array<std::size_t, kColumns.size()> places{};
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const auto found = std::find(columns.begin(), columns.end(), kColumns[i]);
    if (found == columns.end()) {
      refuse_table_line(
          name, 1,
          "the column " + std::string(kColumns[i]) +
              " is missing; add it. A recorded texture has the tab-separated columns " +
              kColumnNames);
    }
    places[i] = static_cast<std::size_t>(found - columns.begin());
  }
  if (columns.size() != kColumns.size()) {
    refuse_table_line(name, 1,
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

std::vector<std::string> uneven_strokes(const TextureRecording& recording) {
  constexpr std::size_t kParts = 10;
  std::vector<std::string> sentences{};
  for (std::size_t i = 0; i < recording.strokes.size(); ++i) {
    const RecordedStroke& stroke = recording.strokes[i];
    const std::size_t intervals = stroke.time_s.size() - 1;
    std::vector<double> speeds_m_per_s{};
    std::vector<double> normals_N{};
    for (std::size_t part = 0; part < kParts; ++part) {
      const std::size_t from = part * intervals / kParts;
      const std::size_t to = (part + 1) * intervals / kParts;
      speeds_m_per_s.push_back((stroke.path_m[to] - stroke.path_m[from]) /
                               (stroke.time_s[to] - stroke.time_s[from]));
      double sum_N = 0.0;
      for (std::size_t sample = from; sample < to; ++sample) sum_N += stroke.normal_N[sample];
      normals_N.push_back(sum_N / static_cast<double>(to - from));
    }
    const auto compare = [&](const std::vector<double>& parts, double mean, double per_unit,
                             const std::string& what, const std::string& unit) {
      const auto [least, greatest] = std::minmax_element(parts.begin(), parts.end());
      if (std::max(mean - *least, *greatest - mean) <= kMostUneven * mean) return;
      sentences.push_back("stroke " + std::to_string(i + 1) + ": the " + what +
                          " is not constant, but between " + fixed(per_unit * *least, 2) + " and " +
                          fixed(per_unit * *greatest, 2) + ' ' + unit +
                          "; shorten the stroke to the part where it is, or record it again");
    };
    compare(speeds_m_per_s, stroke.speed_m_per_s(), 1e3, "speed", "mm/s");
    compare(normals_N, stroke.mean_normal_N(), 1.0, "normal force", "N");
  }
  return sentences;
}

TextureRecording texture_recording_in(std::string_view tsv, const std::string& name) {
  TextureRecording recording{};
  std::array<std::size_t, kColumns.size()> places{};
  const NumberTable table = number_table_in(
      tsv, name,
      [&](const std::vector<std::string>& columns) { places = places_of(columns, name); });
  std::set<double> finished{};
  double current = 0.0;
  for (const NumberTable::Row& row : table.rows) {
    const auto cell = [&](std::size_t i) { return row.cells[places[i]]; };
    if (recording.strokes.empty() || cell(0) != current) {
      if (!recording.strokes.empty()) finished.insert(current);
      if (finished.contains(cell(0))) {
        refuse_table_line(
            name, row.line,
            "stroke " + number_text(cell(0)) +
                " has rows in two places; keep the rows of a stroke together, or number the "
                "second one as another stroke");
      }
      current = cell(0);
      recording.strokes.emplace_back();
    }
    RecordedStroke& stroke = recording.strokes.back();
    stroke.time_s.push_back(cell(1));
    stroke.path_m.push_back(cell(2));
    stroke.normal_N.push_back(cell(3));
    stroke.force_N.push_back(cell(4));
  }
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
