// Makes studies so that an unfinished one is known, and fills the demo study.

#include "app/tasks/new_study.h"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/study_files/program.h"
#include "app/study_files/stimulus_names.h"
#include "app/tasks/demo_stimuli.h"
#include "app/tasks/protocol_templates.h"
#include "protocols/file/library_protocols.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/files/part_folder.h"
#include "results_schema/study.h"
#include "results_schema/study_sharing.h"

namespace asperity {

namespace {

void fill_demo_study(const std::filesystem::path& folder,
                     const std::function<void(double)>& progress) {
  for (const LibraryProtocol& protocol : library_protocols()) {
    // The protocols of the demo data: one session without sight, one with tools in six degrees of
    // freedom, those of numbers and ratings, and one of a threshold, which needs no files.
    if (!protocol.name.starts_with("chapter_") && protocol.name != "improved_selection_blindfold" &&
        protocol.name != "tools_matching" && protocol.name != "amplitude_jnd" &&
        protocol.name != "models_in_pairs" && protocol.name != "map_of_renderings" &&
        protocol.name != "semantic_differential" && !protocol.name.starts_with("roughness_")) {
      continue;
    }
    write_library_protocol(folder, protocol);
  }
  const std::vector<std::string> names = demo_stimuli();
  for (std::size_t i = 0; i < names.size(); ++i) {
    progress(static_cast<double>(i) / static_cast<double>(names.size()));
    make_demo_stimulus(names[i], folder / "stimuli");
  }
  progress(1.0);
}

/// The name of the folder: "s" for "s/" and for "." in the folder s.
std::string name_of(const std::filesystem::path& folder) {
  std::string name{};
  if (!folder.empty()) {
    const std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
    name = (path.has_filename() ? path : path.parent_path()).filename().string();
  }
  if (name.empty()) {
    throw std::invalid_argument("the name of a study must not be empty; give a name");
  }
  return name;
}

/// Whether the folder has a study as it was made with these settings, without anything that was added later.
bool holds_unused_study(const std::filesystem::path& folder, const NewStudySettings& settings) {
  if (!Study::exists(folder)) return false;
  try {
    const Study study = Study::open(folder, Access::read_only);
    return study.name() == name_of(folder) && study.metadata() == settings.metadata &&
           study.participants().empty() && study.protocols().empty() && study.outputs().empty() &&
           study.withdrawals().empty();
  } catch (const ResultsError&) {
    return false;
  }
}

bool is_of_store(const std::filesystem::path& path) {
  return path.filename().string().starts_with("study.sqlite");
}

/// Whether the folders of a study are empty but for locks, and nothing else but files of desktops is next to its store.
bool holds_no_files(const std::filesystem::path& folder) {
  for (const auto& entry : entries_in(folder)) {
    const bool is_known = is_of_store(entry.path()) || entry.path().filename() == "locks";
    const bool is_empty = entry.is_directory() && std::filesystem::is_empty(entry.path());
    if (!is_known && !is_empty && !is_of_desktop(entry)) return false;
  }
  return true;
}

using FillFolder = std::function<void(const std::filesystem::path&)>;

void remove_study(const std::filesystem::path& folder) noexcept {
  try {
    for (const auto& entry : entries_in(folder)) {
      const std::string name = entry.path().filename().string();
      const bool is_ours = is_of_store(entry.path()) || name == "protocols" || name == "stimuli" ||
                           name == "recordings" || name == "locks";
      std::error_code ignored{};
      if (is_ours) std::filesystem::remove_all(entry.path(), ignored);
    }
  } catch (const std::exception&) {  // what stopped the making of the study is reported
  }
}

/// Makes the study in a new folder or one that is free.
void make_study(const std::filesystem::path& folder, const NewStudySettings& settings,
                const FillFolder& fill) {
  const std::string name = name_of(folder);
  bool is_made = false;  // until then, what is in the folder is another program's
  const auto make_in = [&](const std::filesystem::path& content) {
    {
      Study study = Study::create(content, name);
      is_made = true;
      if (settings.metadata != StudyMetadata{}) study.set_metadata(settings.metadata);
    }
    fill(content);
    if (settings.group) share_study(content, *settings.group);
  };
  if (!std::filesystem::exists(folder)) {
    make_folder_at_once(folder, kOwnersFolder, make_in);
    return;
  }
  try {
    make_in(folder);
  } catch (...) {
    if (is_made) remove_study(folder);
    throw;
  }
}

NewStudy make_or_find(const std::filesystem::path& folder, const NewStudySettings& settings,
                      bool (*is_filled)(const std::filesystem::path&), const FillFolder& fill) {
  if (!holds_unused_study(folder, settings) || !is_filled(folder)) {
    make_study(folder, settings, fill);
    return NewStudy::made;
  }
  PartFolder::remove_leftover(folder);
  if (settings.group) share_study(folder, *settings.group);
  return NewStudy::found;
}

}  // namespace

bool may_become_study(const std::filesystem::path& folder) {
  try {
    return std::filesystem::is_directory(folder) && is_free(folder);
  } catch (const std::exception&) {
    return false;
  }
}

NewStudy new_study(const std::filesystem::path& folder, const NewStudySettings& settings) {
  return make_or_find(folder, settings, holds_no_files, [](const std::filesystem::path&) {});
}

NewStudy new_demo_study(const std::filesystem::path& folder,
                        const std::function<void(double)>& progress,
                        const NewStudySettings& settings) {
  return make_or_find(
      folder, settings, holds_demo_study,
      [&progress](const std::filesystem::path& content) { fill_demo_study(content, progress); });
}

Phrase one_version_per_study() {
  return phrase("NewStudy",
                "This is version %1. Before 1.0.0, finish a study with the version that began it; "
                "the package of each version stays available.")
      .with(program_version());
}

bool holds_demo_study(const std::filesystem::path& folder) {
  std::error_code ignored{};
  if (!std::filesystem::is_regular_file(folder / "study.sqlite", ignored)) return false;
  for (const LibraryProtocol& protocol : library_protocols()) {
    if (!protocol.name.starts_with("chapter_")) continue;
    if (!std::filesystem::is_regular_file(
            folder / "protocols" / (std::string(protocol.name) + ".json"), ignored)) {
      return false;
    }
  }
  // The textures are made last; the last file of each is its relief, or the photograph of one that is only seen.
  for (const std::string& name : demo_stimuli()) {
    const std::vector<std::string> files = files_of_demo_stimulus(name);
    const auto has = [&files](const std::string& file) {
      return std::find(files.begin(), files.end(), file) != files.end();
    };
    if (!has(name + "_true.png")) continue;
    const std::filesystem::path relief = folder / "stimuli" / (name + ".png");
    const std::filesystem::path last = has(name + ".png") ? relief : photograph_of(relief);
    if (!std::filesystem::is_regular_file(last, ignored)) return false;
  }
  // Of another schema it cannot be opened.
  try {
    Study::open(folder, Access::read_only);
  } catch (const ResultsError&) {
    return false;
  }
  return true;
}

}  // namespace asperity
