// A study that runs in a moment: two small textures, and protocols of a few short trials.

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/temporary_folder.h"

namespace asperity::test {

namespace fs = std::filesystem;

/// A selection between two models, felt for a fraction of a second; textures "walnut" and "slate".
nlohmann::ordered_json small_selection(int repetitions);
/// A recognition of one texture among two pictures.
nlohmann::ordered_json small_recognition(int repetitions);

/// A discrimination of two surfaces with the model of the plug-ins in tests/plugins.
nlohmann::ordered_json faulty_discrimination();

/// A folder "study" with the textures in stimuli/ and the protocols in protocols/: a copy of one that the
/// program makes once in a process.
class SmallStudy final {
 public:
  explicit SmallStudy(int repetitions = 4);
  /// A new folder with a copy of all that is in the other one.
  SmallStudy(const SmallStudy& other);
  SmallStudy& operator=(const SmallStudy&) = delete;

  const fs::path& place() const noexcept { return folder_.path(); }
  fs::path study() const { return folder_ / "study"; }
  fs::path selection() const { return study() / "protocols" / "small_selection.json"; }
  fs::path recognition() const { return study() / "protocols" / "small_recognition.json"; }

 private:
  TemporaryFolder folder_{};
};

/// The stimuli that the small protocols name, without a study around them.
void make_small_stimuli(const fs::path& folder);

/// simulate of the small selection and recognition into `study`.
std::vector<std::string> simulate_arguments(const SmallStudy& small, const fs::path& study,
                                            int participants, int seed);

/// A small study with one repetition in which virtual participants took part; `more` are options of simulate.
SmallStudy simulated_study(int participants, int seed, const std::vector<std::string>& more = {});

/// A new study with the stimuli of `small`.
void copy_stimuli(const SmallStudy& small, const fs::path& study);

std::string text_of(const fs::path& file);
void write_text(const fs::path& file, const std::string& text);

/// Every file below a folder with its content: equal when nothing was written.
std::map<std::string, std::string> contents_of(const fs::path& folder);

/// The tables of `export`, by file name.
std::map<std::string, std::string> exported(const fs::path& study, const fs::path& out);

/// Rows of a TSV without its heading; the heading of a column → its cells.
struct Tsv {
  std::vector<std::string> columns{};
  std::vector<std::vector<std::string>> rows{};
  std::vector<std::string> column(const std::string& name) const;
};
Tsv tsv(const std::string& text);

/// The lines that begin with "done ": attempts that are stored and count.
std::vector<std::string> done_lines(const std::string& err);
/// "PARTICIPANT SESSION TRIAL ATTEMPT" of each attempt that was reported stored, whether or not it counts.
std::vector<std::string> stored_attempts_in(const std::string& err);

}  // namespace asperity::test
