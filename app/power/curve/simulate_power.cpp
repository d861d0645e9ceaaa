#include "app/power/curve/simulate_power.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "app/power/curve/study_rows.h"
#include "results_schema/error_text.h"
#include "results_schema/files/growing_file.h"
#include "results_schema/study_sharing.h"

namespace asperity {

namespace {

constexpr auto kBetweenWrites = std::chrono::seconds(1);
constexpr std::int64_t kAhead = 4096;  // studies that wait for an earlier one to be written

/// The table of studies, with its declaration next to it.
class StudiesTable final {
 public:
  StudiesTable(const PowerOrder& order, const PowerFiles& files)
      : order_(order),
        path_(files.folder / kStudiesFile),
        file_(made(files.folder) / kStudiesFile) {
    const std::filesystem::path beside = files.folder / kDeclarationFile;
    const std::string declaration = declaration_of(order);
    const bool is_declared = std::filesystem::exists(beside);
    std::string foreign{};
    if (is_declared) {
      const std::string different = differences(declaration, read_file(beside, kOptionsFile));
      if (!different.empty()) foreign = "is from other inputs, which differ in " + different;
    } else if (std::filesystem::file_size(path_) > 0) {
      foreign = std::string("has no ") + kDeclarationFile + " that states how it was made";
    }
    if (!foreign.empty()) {
      if (files.overwrite == Overwrite::refuse) {
        throw std::runtime_error(path_.string() + ' ' + foreign +
                                 "; repeat the command with the same inputs to add runs to it, "
                                 "choose another --out to keep it, or use --force to replace it");
      }
      file_.cut_to(0);
    }
    if (!is_declared || !foreign.empty()) write_file(beside, declaration, Overwrite::allow);
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

  void append(const std::string& rows) { file_.append(rows); }

 private:
  static const std::filesystem::path& made(const std::filesystem::path& folder) {
    std::filesystem::path named = std::filesystem::absolute(folder).lexically_normal();
    if (!named.has_filename()) named = named.parent_path();  // "FOLDER/"
    if (!std::filesystem::is_directory(named.parent_path())) {
      throw std::runtime_error("there is no folder " + named.parent_path().string() + " for " +
                               named.filename().string() +
                               "; create it first, or choose another --out");
    }
    make_folders(named);
    return folder;
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
};

/// The studies from `first` to `last`, which are tallied and written in their order.
class PowerWork final {
 public:
  struct Span {
    std::int64_t first = 0;
    std::int64_t last = 0;
  };

  PowerWork(const PowerOrder& order, const SimulateStudy& simulate, Span span, PowerTally& tally,
            StudiesTable* table, const std::stop_token& stop,
            const std::function<void(double)>& progress)
      : order_(order),
        simulate_(simulate),
        last_(span.last),
        tally_(tally),
        table_(table),
        stop_(stop),
        progress_(progress),
        next_(span.first),
        settled_(span.first) {}

  /// Returns the number of studies that are settled, those before the first included.
  std::int64_t done(int jobs) {
    {
      std::vector<std::jthread> workers{};
      for (int job = 1; job < jobs; ++job) workers.emplace_back([this] { work(); });
      work();
    }
    write();
    if (failure_) std::rethrow_exception(failure_);
    return settled_;
  }

 private:
  bool is_ended() const { return stop_.stop_requested() || failure_ || next_ >= last_; }

  void work() {
    for (;;) {
      std::unique_lock lock(mutex_);
      moved_.wait(lock, [this] { return is_ended() || next_ < settled_ + kAhead; });
      if (is_ended()) return;
      const std::int64_t index = next_++;
      lock.unlock();
      try {
        std::vector<SimulatedOutcome> outcomes = simulated(index);
        lock.lock();
        waiting_[index] = std::move(outcomes);
        settle();
      } catch (...) {
        if (!lock.owns_lock()) lock.lock();
        if (!failure_) failure_ = std::current_exception();
      }
      lock.unlock();
      moved_.notify_all();
    }
  }

  std::vector<SimulatedOutcome> simulated(std::int64_t index) const {
    const StudyPlace place = place_of(order_, index);
    const int participants = order_.participants[place.size];
    try {
      std::vector<SimulatedOutcome> outcomes =
          simulate_(place.effect, participants, order_.seed, place.run);
      if (outcomes.empty()) {
        throw std::runtime_error(
            "the analysis has no test; declare the tests of the protocol under analysis.family");
      }
      return outcomes;
    } catch (const std::exception& error) {
      throw std::runtime_error("the simulated study of run " + std::to_string(place.run) +
                               " with " + std::to_string(participants) + " participants and " +
                               order_.effects[place.effect] + ": " + message_of(error));
    }
  }

  // Under the lock: the studies that follow those that are settled. None after a failure, which may be one to write: the table would
  // have a gap.
  void settle() {
    if (failure_) return;
    for (auto next = waiting_.begin(); next != waiting_.end() && next->first == settled_;
         next = waiting_.erase(next)) {
      const StudyPlace place = place_of(order_, settled_);
      tally_.add(place, next->second);
      if (table_ != nullptr) rows_ += rows_of(order_, place, next->second);
      ++settled_;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - written_ < kBetweenWrites) return;
    write();
    written_ = now;
  }

  void write() {
    const std::string rows = std::exchange(rows_, {});
    if (!rows.empty()) table_->append(rows);
    if (progress_) progress_(static_cast<double>(settled_) / static_cast<double>(last_));
  }

  const PowerOrder& order_;
  const SimulateStudy& simulate_;
  std::int64_t last_;
  PowerTally& tally_;
  StudiesTable* table_;
  std::stop_token stop_;
  const std::function<void(double)>& progress_;
  std::mutex mutex_{};  // guards the following members
  std::condition_variable moved_{};
  std::int64_t next_;
  std::int64_t settled_;
  std::map<std::int64_t, std::vector<SimulatedOutcome>> waiting_{};
  std::string rows_{};  ///< settled and not yet in the table
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
  std::exception_ptr failure_{};
};

}  // namespace

SimulatedPower simulate_power(const PowerOrder& order, const SimulateStudy& simulate, int jobs,
                              const std::optional<PowerFiles>& files, const std::stop_token& stop,
                              const std::function<void(double)>& progress) {
  require_order(order);
  PowerTally tally(order);
  std::unique_ptr<StudiesTable> table{};
  SimulatedPower power{};
  if (files) {
    table = std::make_unique<StudiesTable>(order, *files);
    power.there = table->resume(tally);
  }
  const std::int64_t of_run = studies_per_run(order);
  const std::int64_t runs = std::max(order.runs, (power.there + of_run - 1) / of_run);
  const PowerWork::Span span{.first = table ? table->first() : 0, .last = runs * of_run};
  PowerWork work(order, simulate, span, tally, table.get(), stop, progress);
  const std::int64_t settled = work.done(jobs);
  power.runs = settled / of_run;
  power.is_complete = settled == span.last;
  power.curves = tally.curves();
  return power;
}

}  // namespace asperity
