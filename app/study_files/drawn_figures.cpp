// Keeps the checksums of drawn figures in a JSON file; an unchanged figure may be replaced.

#include "app/study_files/drawn_figures.h"

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "results_schema/hashes/sha256.h"

namespace asperity {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kFiguresFormat = "asperity.drawn_figures/1";
constexpr FileKind kFiguresRecord{"a record of figures", std::uint64_t{1} << 20};

/// The SHA-256 of each figure, by its path.
Json figures_in(const fs::path& record) {
  if (!fs::is_regular_file(record)) return Json::object();
  const Json read = Json::parse(read_file(record, kFiguresRecord), nullptr, false);
  const bool is_record = read.is_object() && read.value("format", Json()) == kFiguresFormat &&
                         read.contains("figures") && read["figures"].is_object();
  return is_record ? read["figures"] : Json::object();
}

std::string recorded_name(const fs::path& figure, const fs::path& record) {
  const fs::path folder = fs::weakly_canonical(fs::absolute(record)).parent_path();
  return fs::weakly_canonical(fs::absolute(figure)).lexically_proximate(folder).generic_string();
}

}  // namespace

Overwrite DrawnFigures::overwrite_of(const fs::path& figure, Overwrite given) const {
  if (!fs::is_regular_file(figure)) return given;
  const Json figures = figures_in(record_);
  const auto known = figures.find(recorded_name(figure, record_));
  const bool is_own = known != figures.end() && *known == sha256_of_file(figure);
  return is_own ? Overwrite::allow : given;
}

void DrawnFigures::record(const fs::path& figure) const {
  Json figures = figures_in(record_);
  figures[recorded_name(figure, record_)] = sha256_of_file(figure);
  const Json record{{"format", kFiguresFormat}, {"figures", figures}};
  write_file(record_, record.dump(2) + '\n', Overwrite::allow);
}

}  // namespace asperity
