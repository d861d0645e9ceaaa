// Makes columns from quantiles of the times, without those for which there are too few ticks.

#include "app/timing/tick_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "analysis/numbers/number_text.h"

namespace asperity {

namespace {

/// With fewer, the 99th percentile is the maximum; at the beginning of a motion the tool has not settled.
constexpr std::size_t kFewestTicks = 100;

bool has_few_counted_ticks(const TickTimes& times) {
  return times.undisturbed_ns.size() < kFewestTicks;
}

bool has_settled(const TickTimes& times) {
  return times.undisturbed_ns.size() + static_cast<std::size_t>(times.preempted) >= kFewestTicks;
}

/// nullopt: too few ticks for a quantile.
std::optional<double> seconds(const TickTimes& times, double fraction) {
  if (fraction < 1.0 && has_few_counted_ticks(times)) return std::nullopt;
  const std::optional<std::int64_t> time_ns = times.quantile_ns(fraction);
  if (!time_ns) return std::nullopt;
  return 1e-9 * static_cast<double>(*time_ns);
}

std::optional<double> rate_Hz(const TimedRow& row) {
  const std::optional<double> p99_s = seconds(row.times, 0.99);
  if (!row.has_rate || !p99_s || !(*p99_s > 0.0)) return std::nullopt;
  return 1.0 / *p99_s;
}

std::optional<double> largest_force_N(const TimedRow& row) {
  return has_settled(row.times) ? row.largest_force_N : std::nullopt;
}

/// Whether a force is next to a quoted one.
bool has_comparable_force(const TimedRow& row) {
  return row.quoted && row.quoted->figure.find(" N in place of") != std::string_view::npos &&
         largest_force_N(row).has_value();
}

std::string few_ticks(const TickTimes& times) {
  std::string sentence = "counted ticks " + std::to_string(times.undisturbed_ns.size());
  if (times.preempted > 0) sentence += ", preempted " + std::to_string(times.preempted);
  return sentence + "; a median, a 99th percentile and a rate need at least " +
         std::to_string(kFewestTicks) + " counted ticks: " +
         (has_settled(times) ? "end other programs" : "increase --ticks and --seconds");
}

Cell cell_of(const std::optional<double>& number) {
  return number ? Cell(*number) : Cell(std::monostate{});
}

Cell text_cell(std::string_view text) {
  return text.empty() ? Cell(std::monostate{}) : Cell(std::string(text));
}

Cell count_cell(std::size_t count) { return static_cast<std::int64_t>(count); }

/// With three significant digits.
Cell rounded(const std::optional<double>& number, double unit) {
  if (!number) return std::monostate{};
  const double value = *number / unit;
  if (!(value > 0.0)) return value;
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  // Through text: a multiple of 0.01 has more digits than it shows.
  return *number_in(fixed(std::round(value / digit) * digit, digit < 1.0 ? 4 : 0));
}

void add_once(std::vector<std::string>& sentences, const std::string& sentence) {
  if (std::find(sentences.begin(), sentences.end(), sentence) == sentences.end()) {
    sentences.push_back(sentence);
  }
}

std::string size_text(const TimedSize& size) {
  if (size.original == size.simplified) return std::to_string(size.original);
  return std::to_string(size.original) + " → " + std::to_string(size.simplified);
}

}  // namespace

Table tick_table(const std::vector<TimedRow>& rows, const TimingMachine& machine) {
  Table table{.columns = {"scene",
                          "model",
                          "evaluated_on",
                          "device",
                          "caches",
                          "ticks",
                          "preempted",
                          "p50_s",
                          "p99_s",
                          "maximum_s",
                          "rate_Hz",
                          "largest_force_N",
                          "tool_triangles",
                          "tool_simplified_triangles",
                          "surface_triangles",
                          "surface_simplified_triangles",
                          "reason",
                          "quoted",
                          "quoted_source",
                          "processor",
                          "cores",
                          "load_per_core",
                          "program",
                          "compiler",
                          "instruction_set"}};
  for (const TimedRow& row : rows) {
    const auto size = [](const std::optional<TimedSize>& of, std::size_t TimedSize::*number) {
      return of ? count_cell((*of).*number) : Cell(std::monostate{});
    };
    table.rows.push_back({row.scene,
                          row.model,
                          std::string(name_of(row.place)),
                          text_cell(row.device),
                          std::string(row.has_cold_caches ? "cold" : "warm"),
                          count_cell(row.times.undisturbed_ns.size()),
                          row.times.preempted,
                          cell_of(seconds(row.times, 0.5)),
                          cell_of(seconds(row.times, 0.99)),
                          cell_of(seconds(row.times, 1.0)),
                          cell_of(rate_Hz(row)),
                          cell_of(largest_force_N(row)),
                          size(row.tool, &TimedSize::original),
                          size(row.tool, &TimedSize::simplified),
                          size(row.surface, &TimedSize::original),
                          size(row.surface, &TimedSize::simplified),
                          text_cell(row.reason),
                          text_cell(row.quoted ? row.quoted->figure : ""),
                          text_cell(row.quoted ? row.quoted->source : ""),
                          machine.processor,
                          count_cell(machine.cores),
                          machine.load_per_core,
                          machine.program,
                          machine.compiler,
                          machine.instruction_set});
  }
  return table;
}

Table short_tick_table(const std::vector<TimedRow>& rows) {
  Table table{.columns = {"scene", "model", "on", "ticks", "p50_us", "p99_us", "max_us", "rate_kHz",
                          "largest_force_N", "quoted"}};
  for (const TimedRow& row : rows) {
    table.rows.push_back(
        {row.scene, row.model, std::string(name_of(row.place)),
         count_cell(row.times.undisturbed_ns.size()), rounded(seconds(row.times, 0.5), 1e-6),
         rounded(seconds(row.times, 0.99), 1e-6), rounded(seconds(row.times, 1.0), 1e-6),
         rounded(rate_Hz(row), 1e3), rounded(largest_force_N(row), 1.0),
         text_cell(row.quoted ? row.quoted->figure : "")});
  }
  return table;
}

std::vector<std::string> tick_notes(const std::vector<TimedRow>& rows) {
  std::vector<std::string> notes;
  if (!rows.empty() && rows.front().has_cold_caches) {
    notes.emplace_back("Cold caches: other data were written before each tick.");
  }
  for (const TimedRow& row : rows) {
    if (row.tool && row.surface) {
      add_once(notes, row.scene + ": triangles of the tool " + size_text(*row.tool) +
                          ", of the surface " + size_text(*row.surface) + '.');
    } else if (row.surface) {
      add_once(notes, row.scene + ": " + size_text(*row.surface) + " facets.");
    }
    if (row.place != EvaluatedOn::cpu && !row.device.empty()) {
      add_once(notes, std::string("On ") + name_of(row.place) + ": " + row.device + '.');
    }
    if (row.reason.empty() && has_few_counted_ticks(row.times)) {
      add_once(notes, row.scene + ", " + row.model + " on " + name_of(row.place) + ": " +
                          few_ticks(row.times) + '.');
    }
    if (!row.reason.empty()) {
      add_once(notes, row.scene + ", " + row.model + " on " + name_of(row.place) +
                          ", not measured: " + row.reason);
    }
  }
  if (std::any_of(rows.begin(), rows.end(), has_comparable_force)) {
    notes.emplace_back(
        "largest_force_N is by each model's own law; only penalty forces are close to the 1 N "
        "with which the quoted forces are compared.");
  }
  for (const TimedRow& row : rows) {
    if (!row.quoted) continue;
    add_once(notes, "Quoted " + std::string(row.quoted->figure) + ": " +
                        std::string(row.quoted->source) + '.');
  }
  return notes;
}

}  // namespace asperity
