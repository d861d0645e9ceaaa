// Looks for references in protocols, renderings and stored sessions, and edits them when a stimulus is renamed.

#include "app/tasks/stimulus_files.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/study_files/height_field_files.h"
#include "app/study_files/protocol_languages.h"
#include "app/study_files/rendering_files.h"
#include "app/study_files/study_protocols.h"
#include "app/tasks/study_overview.h"
#include "app/words/phrase.h"
#include "protocols/design/json_pointer.h"
#include "protocols/editing/edits.h"
#include "protocols/file/json_document.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/files/folder_entries.h"

namespace asperity {

namespace {

using nlohmann::json;

constexpr const char* kFolder = "stimuli/";
constexpr const char* kPhotoEnding = "_photo.png";
constexpr std::size_t kLongestStem = 60;

/// The pointers of all texts that are this path.
void find_places(const json& value, const std::string& pointer, const std::string& path,
                 std::vector<std::string>& places) {
  if (value.is_string()) {
    if (value == path) places.push_back(pointer);
  } else if (value.is_object()) {
    for (const auto& [key, entry] : value.items()) {
      find_places(entry, pointer_to(pointer, key), path, places);
    }
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      find_places(value[i], pointer_to(pointer, i), path, places);
    }
  }
}

/// Of a text that is not JSON, whether the path occurs in quotation marks.
bool names_it(const std::string& text, const std::string& path) {
  const json root = json::parse(text, nullptr, false);
  if (root.is_discarded()) return text.find('"' + path + '"') != std::string::npos;
  std::vector<std::string> places{};
  find_places(root, "", path, places);
  return !places.empty();
}

std::string with_path(std::string text, const std::filesystem::path& file, const std::string& path,
                      const std::string& renamed) {
  try {
    std::vector<std::string> places{};
    find_places(JsonDocument(text, {}).root(), "", path, places);
    for (const std::string& place : places) {
      text = changed(text, set_value(JsonDocument(text, {}), place, json_string(renamed)));
    }
  } catch (const ProtocolError&) {
    throw PhrasedError(phrase("StimulusFiles",
                              "%1 names %2 and cannot be changed, because it is not valid JSON. "
                              "Fix the file first.")
                           .with(file.filename().string(), path));
  }
  return text;
}

bool is_there(const std::filesystem::path& file) {
  std::error_code unknown{};
  return std::filesystem::exists(std::filesystem::symlink_status(file, unknown));
}

bool is_stem(const std::string& stem) {
  return !stem.empty() && stem.size() <= kLongestStem &&
         std::all_of(stem.begin(), stem.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '_' || c == '-';
         });
}

/// What follows the stem: ".rendering.json", ".png".
std::string ending_of(const std::string& path) {
  return is_rendering(path) ? kRenderingEnding : std::filesystem::path(path).extension().string();
}

/// "stimuli/brick_photo.png" of "stimuli/brick.png".
std::string photograph_of(const std::string& path) {
  return path.substr(0, path.size() - ending_of(path).size()) + kPhotoEnding;
}

bool has_photograph(const std::filesystem::path& study, const std::string& path) {
  return has_sidecar(study / path) && is_there(study / photograph_of(path));
}

/// The text of a file, and the one that replaces it.
struct ChangedText {
  std::filesystem::path file{};
  std::string before{};
  std::string after{};
};

/// Writes all of them; if one cannot be written or has been edited meanwhile, none.
void replace_texts(const std::vector<ChangedText>& texts) {
  std::vector<const ChangedText*> written{};
  try {
    for (const ChangedText& text : texts) {
      if (!holds({text.file, text.before})) {
        throw PhrasedError(phrase("StimulusFiles",
                                  "%1 has been changed meanwhile, and nothing was renamed. Rename "
                                  "the stimulus again.")
                               .with(text.file.filename().string()));
      }
      write_file(text.file, text.after, Overwrite::allow);
      written.push_back(&text);
    }
  } catch (...) {
    for (const ChangedText* const text : written) {
      write_file(text->file, text->before, Overwrite::allow);
    }
    throw;
  }
}

/// Errors: ResultsError naming the file.
void remove_file(const std::filesystem::path& file) {
  std::error_code error{};
  std::filesystem::remove(file, error);
  if (!error) return;
  throw ResultsError("the file " + file.string() + " cannot be deleted: " + error.message(), file,
                     error.value());
}

std::string file_names(const std::vector<std::filesystem::path>& files) {
  std::string names{};
  for (const std::filesystem::path& file : files) {
    names += (names.empty() ? "" : ", ") + file.filename().string();
  }
  return names;
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

std::optional<Phrase> complaint_about_renaming(const StimulusUses& uses, const std::string& path) {
  if (!uses.is_stored()) return {};
  return phrase("StimulusFiles",
                "%1 belongs to stored sessions, which refer to its name and its content. It can be "
                "neither renamed nor deleted.")
      .with(file_name(path));
}

std::optional<Phrase> complaint_about_deletion(const StimulusUses& uses, const std::string& path) {
  if (uses.is_stored()) return complaint_about_renaming(uses, path);
  if (uses.is_unused()) return {};
  std::vector<std::filesystem::path> users = uses.protocols;
  users.insert(users.end(), uses.renderings.begin(), uses.renderings.end());
  return phrase("StimulusFiles", "%1 is used by %2. Remove it there before you delete it.")
      .with(file_name(path), file_names(users));
}

StimulusUses uses_of_stimulus(const Study& study, const std::string& path) {
  StimulusUses uses{};
  for (const std::filesystem::path& file : protocol_files(study.folder())) {
    if (!names_it(read_file(file, kProtocolFile), path)) continue;
    (sessions_of_protocol(study, file) > 0 ? uses.protocols_run : uses.protocols).push_back(file);
  }
  for (const std::filesystem::path& file : rendering_files(study.folder())) {
    if (names_it(read_file(file, kProtocolFile), path)) uses.renderings.push_back(file);
  }
  const std::vector<ProtocolRow> stored = study.protocols();
  uses.in_sessions = std::any_of(stored.begin(), stored.end(), [&path](const ProtocolRow& row) {
    return names_it(row.source, path);
  });
  return uses;
}

std::vector<std::string> files_of_stimulus(const std::filesystem::path& study,
                                           const std::string& path) {
  std::vector<std::string> files{};
  if (has_sidecar(study / path)) files.push_back(sidecar_of(path).string());
  files.push_back(path);  // last: it is there with all the others or not at all
  return files;
}

std::vector<std::string> files_renamed_with(const std::filesystem::path& study,
                                            const std::string& path) {
  std::vector<std::string> files = files_of_stimulus(study, path);
  if (has_photograph(study, path)) files.insert(files.begin(), photograph_of(path));
  return files;
}

std::string rename_stimulus(const Study& study, const std::string& path, const std::string& stem) {
  if (!is_stem(stem)) {
    throw PhrasedError(phrase("StimulusFiles",
                              "“%1” cannot be the name of a stimulus. Use unaccented letters, "
                              "digits, _ and -.")
                           .with(stem));
  }
  const std::filesystem::path& folder = study.folder();
  const std::string renamed = kFolder + stem + ending_of(path);
  if (renamed == path) return path;
  std::vector<std::pair<std::string, std::string>> moved{{path, renamed}};
  if (has_photograph(folder, path)) {
    moved.emplace_back(photograph_of(path), photograph_of(renamed));
  }
  std::vector<NewFile> written{};
  std::vector<std::filesystem::path> removed{};
  std::vector<std::filesystem::path> referring{};
  for (const auto& [from, to] : moved) {
    const StimulusUses uses = uses_of_stimulus(study, from);
    if (const auto complaint = complaint_about_renaming(uses, from)) {
      throw PhrasedError(*complaint);
    }
    for (const auto* const files : {&uses.protocols, &uses.renderings}) {
      referring.insert(referring.end(), files->begin(), files->end());
    }
    std::vector<NewFile> together{};
    for (const std::string& file : files_of_stimulus(folder, from)) {
      const std::filesystem::path wanted = folder / (to + file.substr(from.size()));
      if (is_there(wanted)) {
        throw PhrasedError(
            phrase("StimulusFiles", "The study already has a file %1. Choose another name.")
                .with(wanted.filename().string()));
      }
      together.push_back({wanted, read_file(folder / file, kPictureFile)});
      removed.push_back(folder / file);
    }
    written.insert(written.begin(), together.begin(), together.end());  // the stimulus itself last
  }
  std::sort(referring.begin(), referring.end());
  referring.erase(std::unique(referring.begin(), referring.end()), referring.end());
  std::vector<ChangedText> texts{};
  for (const std::filesystem::path& file : referring) {
    const std::string before = read_file(file, kProtocolFile);
    std::string after = before;
    for (const auto& [from, to] : moved) after = with_path(std::move(after), file, from, to);
    texts.push_back({file, before, std::move(after)});
  }
  write_files_together(written, Overwrite::refuse);
  try {
    replace_texts(texts);
  } catch (...) {
    for (const NewFile& file : written) remove_file(file.path);
    throw;
  }
  for (const std::filesystem::path& file : removed) remove_file(file);
  return renamed;
}

void delete_stimulus(const Study& study, const std::string& path) {
  const StimulusUses uses = uses_of_stimulus(study, path);
  if (const auto complaint = complaint_about_deletion(uses, path)) throw PhrasedError(*complaint);
  std::vector<std::string> files = files_of_stimulus(study.folder(), path);
  std::reverse(files.begin(), files.end());  // a sidecar without its picture is not a stimulus
  for (const std::string& file : files) remove_file(study.folder() / file);
}

std::vector<ForeignStimulus> foreign_stimuli(const std::filesystem::path& study,
                                             const std::filesystem::path& other) {
  if (!is_there(other / "study.sqlite")) {
    throw PhrasedError(phrase("StimulusFiles", "%1 is not a study. Choose the folder of a study.")
                           .with(other.string()));
  }
  std::vector<ForeignStimulus> stimuli{};
  for (const auto& entry : entries_in(other / "stimuli")) {
    const std::filesystem::path& file = entry.path();
    std::error_code unknown{};
    const bool is_sidecar =
        file.extension() == ".json" && has_sidecar(file.parent_path() / file.stem());
    if (!entry.is_regular_file(unknown) || is_sidecar) continue;
    ForeignStimulus stimulus{.path = kFolder + file.filename().string()};
    for (const std::string& part : files_of_stimulus(other, stimulus.path)) {
      if (!is_there(study / part)) continue;
      const bool is_same = holds({study / part, read_file(other / part, kPictureFile)});
      if (!is_same) stimulus.state = ForeignStimulus::State::name_is_taken;
      if (is_same && stimulus.state == ForeignStimulus::State::can_be_copied &&
          part == stimulus.path) {
        stimulus.state = ForeignStimulus::State::is_there;
      }
    }
    stimuli.push_back(std::move(stimulus));
  }
  return stimuli;
}

int copy_stimuli(const std::filesystem::path& study, const std::filesystem::path& other,
                 const std::vector<std::string>& paths, const std::stop_token& stop) {
  std::filesystem::create_directories(study / kFolder);
  int copied = 0;
  for (const std::string& path : paths) {
    if (stop.stop_requested()) break;
    std::vector<NewFile> files{};
    for (const std::string& part : files_of_stimulus(other, path)) {
      files.push_back({study / part, read_file(other / part, kPictureFile)});
    }
    write_files_together(files, Overwrite::refuse);
    ++copied;
  }
  return copied;
}

}  // namespace asperity
