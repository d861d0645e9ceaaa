// Makes the textures once, composes protocols as JSON, and parses exported tables and lines.

#include "tests/journeys/small_study.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "tests/journeys/program.h"

namespace asperity::test {

namespace {

using OrderedJson = nlohmann::ordered_json;

void must(const Outcome& outcome) {
  if (outcome.status != 0) throw std::runtime_error("the program refused: " + outcome.err);
}

OrderedJson common(const std::string& kind) {
  return OrderedJson::parse(R"({
    "format": "asperity.protocol/1",
    "kind": ")" + kind +
                            R"(",
    "design": "improved",
    "name": "small_)" + kind +
                            R"(",
    "version": "1.0.0",
    "title": "A small one",
    "consent": {"version": "1.0", "statement": "I take part."},
    "textures": {
      "walnut": {"code": "T1", "height_field": "stimuli/walnut.png",
                 "picture": "stimuli/walnut_photo.png", "true_height_field": "stimuli/walnut.png"},
      "slate": {"code": "T2", "height_field": "stimuli/slate.png",
                "picture": "stimuli/slate_photo.png", "true_height_field": "stimuli/slate.png"}
    },
    "device": {"rate_Hz": 1000, "force_limit_N": 5, "maximum_missed_deadlines": 100000, "maximum_gaps_in_contact": 100000,
               "maximum_lost_records": 100000},
    "explorations": {"short": {"minimum_contact_s": 0.2, "maximum_contact_s": 1}},
    "observer": {"expectation": "true_surface", "deaf": false, "feature_noise": 0.5,
                 "position_bias": 0, "lapse": 0.2}
  })");
}

}  // namespace

OrderedJson faulty_discrimination() {
  OrderedJson protocol =
      OrderedJson::parse(text_of(ASPERITY_SOURCE_DIR "/renderers/plugin/example/ridges.json"));
  protocol["stimuli"]["ridges"] = {{"model", "faulty"}, {"parameters", {{"amplitude_m", 0.0001}}}};
  protocol["material"] = {{"stiffness_N_per_m", 2000}, {"friction", 0.2}};
  return protocol;
}

OrderedJson small_selection(int repetitions) {
  OrderedJson protocol = common("selection");
  protocol["realism_standard"] = "photograph";
  protocol["factors"] = OrderedJson::parse(R"({"texture": {"levels": ["walnut", "slate"]},
                                        "model": {"levels": ["height_map", "sinusoid"]}})");
  protocol["stimuli"] = OrderedJson::parse(
      R"({"rendered": {"model": {"factor": "model"}, "texture": {"factor": "texture"}}})");
  protocol["blocks"] = OrderedJson::parse(R"({"main": {
      "crossed": ["texture"],
      "presented": [{"stimulus": "rendered", "with": {"model": "height_map"}},
                    {"stimulus": "rendered", "with": {"model": "sinusoid"}}],
      "positions": "balanced",
      "pause_before_trial_s": 0,
      "pause_between_surfaces_s": 0,
      "question": {"name": "most_realistic", "prompt": "Which was most like the picture?"},
      "exploration": "short"}})");
  protocol["blocks"]["main"]["repetitions"] = repetitions;
  protocol["flow"] = OrderedJson::parse(R"([{"screen": "Welcome. You may stop at any moment."},
                                     {"run": "main"}, {"screen": "Thank you."}])");
  return protocol;
}

OrderedJson small_recognition(int repetitions) {
  OrderedJson protocol = common("recognition");
  protocol["factors"] = OrderedJson::parse(R"({"texture": {"levels": ["walnut", "slate"]}})");
  protocol["stimuli"] = OrderedJson::parse(
      R"({"rendered": {"model": "height_map", "texture": {"factor": "texture"}}})");
  protocol["blocks"] = OrderedJson::parse(R"({"main": {
      "crossed": ["texture"],
      "order": "shuffle",
      "pause_before_trial_s": 0,
      "presented": [{"stimulus": "rendered"}],
      "question": {"name": "recognised", "prompt": "Which did you feel?",
                   "pictures": ["walnut", "slate"], "correct_factor": "texture"},
      "exploration": "short"}})");
  protocol["blocks"]["main"]["repetitions"] = repetitions;
  protocol["flow"] = OrderedJson::parse(R"([{"screen": "Welcome. You may stop at any moment."},
                                     {"run": "main"}, {"screen": "Thank you."}])");
  return protocol;
}

namespace {

/// A study with the textures and without protocols.
const fs::path& pattern() {
  static const TemporaryFolder folder{};
  static const fs::path study = [] {
    fs::path made = folder / "study";
    const fs::path stimuli = made / "stimuli";
    must(asperity({"new", made}));
    must(asperity({"synth", "sinusoid", "--out", stimuli / "walnut.png", "--pixels", "128",
                   "--width-m", "0.02", "--photo", "bright_height", stimuli / "walnut_photo.png"}));
    must(asperity({"synth", "noise", "--out", stimuli / "slate.png", "--pixels", "128", "--width-m",
                   "0.02", "--photo", "bright_height", stimuli / "slate_photo.png"}));
    return made;
  }();
  return study;
}

}  // namespace

void make_small_stimuli(const fs::path& folder) { fs::copy(pattern() / "stimuli", folder); }

SmallStudy::SmallStudy(int repetitions) {
  fs::copy(pattern(), study(), fs::copy_options::recursive);
  write_text(selection(), small_selection(repetitions).dump(2));
  write_text(recognition(), small_recognition(repetitions).dump(2));
}

SmallStudy::SmallStudy(const SmallStudy& other) {
  fs::copy(other.place(), place(), fs::copy_options::recursive);
}

SmallStudy simulated_study(int participants, int seed, const std::vector<std::string>& more) {
  SmallStudy small(1);
  std::vector<std::string> arguments = simulate_arguments(small, small.study(), participants, seed);
  arguments.insert(arguments.end(), more.begin(), more.end());
  must(asperity(arguments));
  return small;
}

void copy_stimuli(const SmallStudy& small, const fs::path& study) {
  must(asperity({"new", study}));
  fs::copy(small.study() / "stimuli", study / "stimuli");
}

std::vector<std::string> simulate_arguments(const SmallStudy& small, const fs::path& study,
                                            int participants, int seed) {
  return {"simulate",
          small.selection(),
          small.recognition(),
          "--study",
          study,
          "--participants",
          std::to_string(participants),
          "--seed",
          std::to_string(seed)};
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::map<std::string, std::string> contents_of(const fs::path& folder) {
  std::map<std::string, std::string> contents{};
  if (!fs::exists(folder)) return contents;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    contents[entry.path().lexically_relative(folder)] =
        entry.is_regular_file() ? text_of(entry.path()) : "";
  }
  return contents;
}

std::map<std::string, std::string> exported(const fs::path& study, const fs::path& out) {
  // Without the datasets, which tell the name of the study: two that are compared have two names.
  must(asperity({"export", study, "--out", out, "--formats", "none"}));
  return contents_of(out);
}

std::vector<std::string> Tsv::column(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) throw std::runtime_error("there is no column " + name);
  std::vector<std::string> cells{};
  for (const std::vector<std::string>& row : rows) {
    cells.push_back(row.at(static_cast<std::size_t>(found - columns.begin())));
  }
  return cells;
}

Tsv tsv(const std::string& text) {
  Tsv table{};
  std::istringstream lines(text);
  for (std::string line{}; std::getline(lines, line);) {
    std::vector<std::string> cells{};
    std::istringstream rest(line);
    for (std::string cell{}; std::getline(rest, cell, '\t');) cells.push_back(cell);
    if (table.columns.empty()) {
      table.columns = cells;
    } else {
      table.rows.push_back(cells);
    }
  }
  return table;
}

namespace {

/// The last line may have been cut by a kill; without its end it was not written.
std::vector<std::string> whole_lines(const std::string& text) {
  std::vector<std::string> found{};
  std::istringstream lines(text);
  for (std::string line{}; std::getline(lines, line) && !lines.eof();) found.push_back(line);
  return found;
}

}  // namespace

std::vector<std::string> done_lines(const std::string& err) {
  std::vector<std::string> found = whole_lines(err);
  std::erase_if(found, [](const std::string& line) { return !line.starts_with("done "); });
  return found;
}

std::vector<std::string> stored_attempts_in(const std::string& err) {
  std::vector<std::string> found{};
  for (const std::string& line : whole_lines(err)) {
    if (line.starts_with("done ")) found.push_back(line.substr(5));
    // Its last word is the outcome.
    if (line.starts_with("stored ")) found.push_back(line.substr(7, line.rfind(' ') - 7));
  }
  return found;
}

}  // namespace asperity::test
