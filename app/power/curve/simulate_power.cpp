// Appends every study to a growing file with its declaration, and continues after the last whole row.

#include "app/power/curve/simulate_power.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "app/power/curve/study_rows.h"
#include "results_schema/files/growing_file.h"

namespace asperity {

namespace {

/// The table of studies, with its declaration next to it.
class StudiesTable final {
 public:
  StudiesTable(const PowerOrder& order, const PowerFiles& files)
      : order_(order), path_(files.studies()), file_(with_folder(files)) {
    const std::filesystem::path beside = files.declaration();
    const std::string declaration = declaration_of(order);
    const bool is_declared = std::filesystem::exists(beside);
    const std::string different =
        is_declared ? differences(declaration, read_file(beside, kOptionsFile)) : std::string();
    if (is_declared && different.empty()) return;
    if (std::filesystem::file_size(path_) > 0) {
      if (files.overwrite == Overwrite::refuse) {
        throw std::runtime_error(
            path_.string() +
            (is_declared
                 ? " is from other inputs, which differ in " + different
                 : std::string(" has no ") + kDeclarationFile + " that states how it was made") +
            "; repeat the command with the same inputs to add runs to it, "
            "choose another --out to keep it, or use --force to replace it");
      }
      file_.cut_to(0);
    }
    // Last: a stop before it leaves an empty table, never studies of other inputs with this declaration.
    write_file(beside, declaration, Overwrite::allow);
  }

  /// Passes all studies but the last to the tally, and removes the last. Returns how many there were before, with the last.
  std::int64_t resume(PowerTally& tally) {
    std::vector<SimulatedOutcome> outcomes{};  // of the study at `index`
    std::int64_t index = 0;
    std::uint64_t kept = 0;      // bytes before this study
    std::uint64_t previous = 0;  // bytes before this line
    std::size_t number = 0;
    file_.for_each_line([&](std::string_view line, std::uint64_t end) {
      if (++number == 1) {
        if (line != study_columns()) refuse(number);
        kept = end;
      } else {
        const std::optional<StudyRow> row = study_row_in(line);
        if (!row) refuse(number);
        if (!row->is_of(order_, place_of(order_, index))) {
          if (outcomes.empty() || !row->is_of(order_, place_of(order_, index + 1))) refuse(number);
          tally.add(place_of(order_, index), outcomes);
          outcomes.clear();
          ++index;
          kept = previous;
        }
        outcomes.push_back(row->outcome);
      }
      previous = end;
    });
    file_.cut_to(kept);
    if (kept == 0) file_.append(study_columns() + '\n');
    first_ = index;
    return index + (outcomes.empty() ? 0 : 1);
  }

  std::int64_t first() const noexcept { return first_; }

  /// Keeps the rows of a study for `write`.
  void add(const StudyPlace& place, std::span<const SimulatedOutcome> outcomes) {
    rows_ += rows_of(order_, place, outcomes);
  }
  void write() {
    const std::string rows = std::exchange(rows_, {});
    if (!rows.empty()) file_.append(rows);
  }

 private:
  static std::filesystem::path with_folder(const PowerFiles& files) {
    make_folder(files);
    return files.studies();
  }

  [[noreturn]] void refuse(std::size_t line) const {
    throw std::runtime_error(path_.string() + ", line " + std::to_string(line) +
                             ", is not the row that follows in the table of these studies; restore "
                             "the file, or delete all lines from this one on: their studies are "
                             "simulated again");
  }

  const PowerOrder& order_;
  std::filesystem::path path_;
  GrowingFile file_;
  std::int64_t first_ = 0;
  std::string rows_{};  ///< not yet in the file
};

}  // namespace

SimulatedPower simulate_power(const PowerOrder& order, const SimulateStudy& simulate, int jobs,
                              const std::optional<PowerFiles>& files, const std::stop_token& stop,
                              const std::function<void(double)>& progress) {
  require_order(order);
  PowerTally tally(order);
  std::optional<StudiesTable> table{};
  SimulatedPower power{};
  StudyReceiver receiver{
      .add = [&](const StudyPlace& place, std::span<const SimulatedOutcome> outcomes) {
        tally.add(place, outcomes);
        if (table) table->add(place, outcomes);
      }};
  if (files) {
    table.emplace(order, *files);
    power.there = table->resume(tally);
    receiver.write = [&table] { table->write(); };
  }
  const std::int64_t of_run = studies_per_run(order);
  const std::int64_t runs = std::max(order.runs, (power.there + of_run - 1) / of_run);
  const StudyRange range{.first = table ? table->first() : 0, .last = runs * of_run};
  const std::int64_t settled =
      simulate_studies(order, simulate, range, jobs, receiver, stop, progress);
  power.runs = settled / of_run;
  power.is_complete = settled == range.last;
  power.curves = tally.curves();
  return power;
}

}  // namespace asperity
