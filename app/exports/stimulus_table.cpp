// Collects the force of each stimulus while attempts are added, and copies files whose checksum is unchanged.

#include "app/exports/stimulus_table.h"

#include <algorithm>
#include <exception>
#include <set>
#include <utility>

#include "analysis/numbers/summary.h"
#include "analysis/signals/spectrum.h"
#include "app/exports/columns/column_making.h"
#include "app/study_files/height_field_files.h"
#include "results_schema/analysis_use.h"
#include "results_schema/tables/table_file.h"

namespace asperity {

using namespace export_columns;

namespace {

constexpr const char* kSidecarEnding = ".png.json";

std::optional<double> mean_if_any(const std::vector<double>& values) {
  const std::optional<Summary> summary = summary_of(values);
  return summary ? std::optional(summary->mean) : std::nullopt;
}

std::optional<double> sd_if_any(const std::vector<double>& values) {
  if (values.size() < 2) return {};
  return summary_of(values)->sd;
}

}  // namespace

StimulusTable::StimulusTable(ExportFolder& folder, std::filesystem::path study,
                             bool copies_height_fields)
    : folder_(folder), study_(std::move(study)), copies_height_fields_(copies_height_fields) {}

Columns StimulusTable::columns() {
  Columns columns{};
  const auto add = [&columns](const char* name, const char* type, const char* unit,
                              const char* description, const char* when = "never") {
    columns.push_back(missing(when, column(name, type, unit, description, {})));
  };
  constexpr const char* kNoField = "no height field is involved";
  constexpr const char* kNoFile =
      "no height field is involved, or its file in the study is missing or changed";
  add("protocol", "text", "", "name of the protocol");
  add("protocol_version", "text", "", "version of the protocol");
  add("virtual", "boolean", "", "1: presented to virtual participants");
  add("mode", "text", "", "mode of the sessions");
  columns.back().levels = {"run", "pilot", "simulate"};
  add("stimulus", "text", "", "stimulus of the protocol");
  add("model", "text", "", "force model");
  add("model_version", "text", "", "version of the force model");
  add("texture", "text", "", "texture of the protocol", "no texture is involved");
  add("parameters_json", "json", "", "parameters of the force model, as rendered");
  add("height_field_sha256", "text", "",
      "SHA-256 of the height field's sidecar, as in presentations.tsv", kNoField);
  add("height_field_state", "text", "",
      "complete: the study has the height field that the sessions used; missing: the file or its "
      "sidecar is missing; changed: the file is a different one",
      kNoField);
  columns.back().levels = {name_of(FileState::complete), name_of(FileState::missing),
                           name_of(FileState::changed)};
  add("height_field", "text", "",
      "file of the height field in the study, and in this folder if it contains stimuli/; the name "
      "of its sidecar, which has the pitch and the range of the heights, ends with .json",
      kNoFile);
  add("height_field_width_m", "number", "m", "width of the height field", kNoFile);
  add("height_field_rms_m", "number", "m", "RMS of the heights about their mean", kNoFile);
  add("height_field_range_m", "number", "m",
      "difference between the greatest and the smallest height", kNoFile);
  add("height_field_dominant_wavelength_m", "number", "m",
      "dominant wavelength: of the third-octave band with the greatest power, over all directions",
      "no height field is involved, its file in the study is missing or changed, or the height "
      "field is a plane");
  add("presentations", "integer", "1", "number of presentations");
  add("matched_texture_force_N", "number", "N",
      "intended RMS of the texture force on the prescribed path",
      "the stimulus has no equal_force");
  add("achieved_presentations", "integer", "1",
      "number of presentations used for the following two columns: those touched for long enough, "
      "in attempts that analyses include");
  add("achieved_texture_force_mean_N", "number", "N",
      "RMS of the texture force along the participants' own paths: mean over presentations",
      "no such presentation");
  add("achieved_texture_force_sd_N", "number", "N",
      "RMS of the texture force along the participants' own paths: standard deviation over "
      "presentations",
      "fewer than two such presentations");
  for (ExportColumn& made : columns) {
    if (made.type == "number" || made.type == "integer") made.minimum = 0.0;
  }
  return columns;
}

void StimulusTable::begin_session(const ExportPlace& at) {
  for (const StimulusFileRow& file : at.session->files) {
    if (!file.path.ends_with(kSidecarEnding)) continue;
    paths_[file.sha256] = file.path.substr(0, file.path.size() - std::string(".json").size());
  }
}

void StimulusTable::add(const ExportPlace& at) {
  const PresentationRow& surface = *at.presentation;
  Presented& row =
      rows_[{at.protocol->name, at.protocol->version, at.participant->is_virtual,
             text_of(at.session->mode), surface.stimulus, surface.model, surface.model_version,
             surface.texture, surface.parameters_json, asset_sha256(surface.assets, "height_field"),
             surface.matched_texture_force_N}];
  ++row.presentations;
  if (surface.achieved_texture_force_N &&
      use_in_analyses(*at.trial, *at.attempt) == AnalysisUse::counted) {
    row.achieved_N.push_back(*surface.achieved_texture_force_N);
  }
}

const char* StimulusTable::name_of(FileState state) {
  switch (state) {
    case FileState::complete:
      return "complete";
    case FileState::missing:
      return "missing";
    case FileState::changed:
      return "changed";
  }
  return "";
}

StimulusTable::Relief StimulusTable::relief_of(const std::string& sidecar_sha256) {
  const auto path = paths_.find(sidecar_sha256);
  if (path == paths_.end()) return {.state = FileState::missing};
  const std::filesystem::path png = study_ / path->second;
  if (!std::filesystem::exists(png) || !std::filesystem::exists(sidecar_of(png))) {
    return {.state = FileState::missing};
  }
  std::optional<LoadedHeightField> loaded{};
  try {
    loaded = load_height_field(png);
  } catch (const std::exception&) {
    return {.state = FileState::changed};  // `asperity verify` reports the problem of the file
  }
  if (loaded->sha256 != sidecar_sha256) return {.state = FileState::changed};
  const HeightField& field = *loaded->field;
  if (copies_height_fields_) {
    folder_.write(path->second, read_file(png));
    folder_.write(path->second + ".json", read_file(sidecar_of(png)));
  }
  return {.path = path->second,
          .width_m = field.width_m(),
          .rms_m = field.rms_m(),
          .range_m = field.maximum_m() - field.minimum_m(),
          .dominant_wavelength_m = dominant_wavelength_m({.heights_m = field.heights_m(),
                                                          .rows = field.grid().rows,
                                                          .columns = field.grid().columns,
                                                          .pitch_m = field.grid().pitch_m})};
}

Phrase StimulusTable::complaint_about(const std::string& sidecar_sha256, FileState state) const {
  std::set<std::pair<std::string, std::string>> users{};  // stimulus, texture
  for (const auto& [key, row] : rows_) {
    if (key.height_field_sha256 == sidecar_sha256) users.insert({key.stimulus, key.texture});
  }
  std::string stimuli{};
  for (const auto& [stimulus, texture] : users) {
    stimuli += (stimuli.empty() ? "\"" : ", \"") + stimulus + '"';
    if (!texture.empty() && texture != stimulus) stimuli += " (" + texture + ')';
  }
  const auto path = paths_.find(sidecar_sha256);
  const std::string file = path == paths_.end() ? sidecar_sha256 : path->second;
  const Phrase complaint =
      state == FileState::missing
          ? phrase("StimulusTable",
                   "%1, the height field of the stimulus %2, is missing from the study: the export "
                   "has neither the file nor its features. Restore it from a backup or a copy of "
                   "the study, then export again.")
          : phrase("StimulusTable",
                   "%1, the height field of the stimulus %2, is not the file that the sessions "
                   "used: the export has neither that file nor its features. Restore it from a "
                   "backup or a copy of the study, then export again.");
  return complaint.with(file, stimuli);
}

std::vector<Phrase> StimulusTable::finish() {
  std::vector<Phrase> complaints{};
  std::map<std::string, Relief> reliefs{};
  TableFile file(folder_.path_of("stimuli.tsv"), TableFile::Format::tsv, column_names(columns()));
  for (const auto& [key, row] : rows_) {
    Relief relief{};
    if (const auto& sha256 = key.height_field_sha256) {
      const auto [found, is_new] = reliefs.try_emplace(*sha256);
      if (is_new) found->second = relief_of(*sha256);
      relief = found->second;
      if (is_new && relief.state != FileState::complete) {
        complaints.push_back(complaint_about(*sha256, relief.state));
      }
    }
    const auto text = [](const std::string& value) { return value.empty() ? Cell{} : Cell{value}; };
    file.add({key.protocol,
              key.version,
              boolean(key.is_virtual),
              key.mode,
              text(key.stimulus),
              key.model,
              key.model_version,
              text(key.texture),
              key.parameters_json,
              optional_cell(key.height_field_sha256),
              key.height_field_sha256 ? Cell{name_of(relief.state)} : Cell{},
              text(relief.path),
              optional_cell(relief.width_m),
              optional_cell(relief.rms_m),
              optional_cell(relief.range_m),
              optional_cell(relief.dominant_wavelength_m),
              row.presentations,
              optional_cell(key.matched_texture_force_N),
              integer(static_cast<std::int64_t>(row.achieved_N.size())),
              optional_cell(mean_if_any(row.achieved_N)),
              optional_cell(sd_if_any(row.achieved_N))});
  }
  folder_.add("stimuli.tsv", file.finish());
  return complaints;
}

}  // namespace asperity
