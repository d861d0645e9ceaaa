// Looks for references in protocols, renderings and stored sessions, and edits them when a stimulus is renamed.

#include "app/tasks/stimulus_files.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/words/phrase.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/protocol_languages.h"
#include "app/study_files/rendering_files.h"
#include "app/study_files/stimulus_names.h"
#include "app/study_files/study_protocols.h"
#include "app/tasks/rendering_use.h"
#include "app/tasks/study_overview.h"
#include "app/tasks/template_overviews.h"
#include "app/words/phrase_of_error.h"
#include "protocols/design/json_pointer.h"
#include "protocols/editing/edits.h"
#include "protocols/file/json_document.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/files/folder_entries.h"

namespace asperity {

namespace {

using nlohmann::json;

constexpr const char* kFolder = "stimuli/";

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

/// With another name of the stimulus, and of a rendering in the notes of the surfaces that have its values.
std::string with_name(std::string text, const std::filesystem::path& file, const std::string& path,
                      const std::string& renamed) {
  const auto replace = [&text](const std::vector<std::string>& places, const std::string& value) {
    for (const std::string& place : places) {
      text = changed(text, set_value(JsonDocument(text, {}), place, json_string(value)));
    }
  };
  try {
    std::vector<std::string> places{};
    find_places(JsonDocument(text, {}).root(), "", path, places);
    replace(places, renamed);
    if (is_rendering(path)) replace(notes_of(text, rendering_name(path)), rendering_name(renamed));
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

/// What follows the stem: ".rendering.json", ".png".
std::string ending_of(const std::string& path) {
  return is_rendering(path) ? kRenderingEnding : std::filesystem::path(path).extension().string();
}

bool has_photograph(const std::filesystem::path& study, const std::string& path) {
  return has_sidecar(study / path) && is_there(photograph_of(study / path));
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

/// Why a stimulus with these uses keeps its name and its content.
std::optional<Phrase> complaint_about_sessions(const StimulusUses& uses, const std::string& path) {
  if (uses.in_sessions) {
    return phrase("StimulusFiles",
                  "%1 belongs to stored sessions, which refer to its name and its content. It can "
                  "be neither renamed nor deleted.")
        .with(file_name(path));
  }
  if (uses.protocols_run.empty()) return {};
  return phrase("StimulusFiles",
                "%1 is used by protocols with stored sessions: %2. Remove it there first.")
      .with(file_name(path), file_names(uses.protocols_run));
}

void sort_once(std::vector<std::filesystem::path>& files) {
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
}

/// All texts in the protocols of a study that can be a file in `stimuli/`.
std::set<std::string> paths_in_protocols(const std::filesystem::path& study) {
  std::set<std::string> paths{};
  const std::function<void(const json&)> collect = [&](const json& value) {
    if (value.is_string() && value.get_ref<const std::string&>().starts_with(kFolder)) {
      paths.insert(value.get<std::string>());
    }
    if (!value.is_structured()) return;
    for (const json& part : value) collect(part);
  };
  for (const std::filesystem::path& file : protocol_files(study)) {
    collect(json::parse(read_file(file, kProtocolFile), nullptr, false));
  }
  return paths;
}

/// Those of the texture before those of the rendering: the last file is of use with all the others only.
std::vector<std::string> files_to_copy(const std::filesystem::path& study,
                                       const std::string& path) {
  std::vector<std::string> files{};
  if (is_rendering(path)) {
    try {
      const std::string texture = load_rendering(study / path).texture.height_field;
      const bool is_stimulus = std::filesystem::path(texture).parent_path() == "stimuli";
      if (is_stimulus && has_sidecar(study / texture)) {
        files = files_to_copy(study, texture);
      }
    } catch (const std::exception&) {  // its problem is shown on the page of the stimuli
    }
  }
  if (has_photograph(study, path)) files.push_back(photograph_of(path).string());
  for (const std::string& file : files_of_stimulus(study, path)) files.push_back(file);
  return files;
}

using NewNames = std::vector<std::pair<std::string, std::string>>;  // of stimuli

/// The files of the stimuli under their new names, the first stimulus last. Errors: PhrasedError for a name that a file has.
std::vector<NewFile> files_with_names(const std::filesystem::path& study, const NewNames& names) {
  std::vector<NewFile> files{};
  for (const auto& [from, to] : names) {
    std::vector<NewFile> together{};
    for (const std::string& file : files_of_stimulus(study, from)) {
      const std::filesystem::path wanted = study / (to + file.substr(from.size()));
      if (is_there(wanted)) {
        throw PhrasedError(
            phrase("StimulusFiles", "The study already has a file %1. Choose another name.")
                .with(wanted.filename().string()));
      }
      together.push_back({wanted, read_file(study / file, kPictureFile)});
    }
    files.insert(files.begin(), together.begin(), together.end());
  }
  return files;
}

std::vector<ChangedText> texts_with_names(const std::vector<std::filesystem::path>& files,
                                          const NewNames& names) {
  std::vector<ChangedText> texts{};
  for (const std::filesystem::path& file : files) {
    const std::string before = read_file(file, kProtocolFile);
    std::string after = before;
    for (const auto& [from, to] : names) after = with_name(std::move(after), file, from, to);
    texts.push_back({file, before, std::move(after)});
  }
  return texts;
}

}  // namespace

std::optional<Phrase> complaint_about_deletion(const StimulusUses& uses, const std::string& path) {
  if (uses.is_stored()) return complaint_about_sessions(uses, path);
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
  for (const OwnTexture& relief : reliefs_of_study(study.folder())) {
    if (relief.picture == path) uses.reliefs.push_back(relief.height_field);
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

RenamePlan plan_of_renaming(const Study& study, const std::string& path) {
  const std::filesystem::path& folder = study.folder();
  RenamePlan plan{.stimuli = {path}};
  if (has_photograph(folder, path)) plan.stimuli.push_back(photograph_of(path).string());
  for (const std::string& stimulus : plan.stimuli) {
    const StimulusUses uses = uses_of_stimulus(study, stimulus);
    if (!plan.complaint) plan.complaint = complaint_about_sessions(uses, stimulus);
    for (const auto* const files : {&uses.protocols, &uses.renderings}) {
      plan.changed.insert(plan.changed.end(), files->begin(), files->end());
    }
    if (stimulus == path) plan.reliefs = uses.reliefs;
    for (std::string& file : files_of_stimulus(folder, stimulus)) {
      plan.files.push_back(std::move(file));
    }
  }
  if (is_rendering(path)) {
    for (const std::filesystem::path& file : protocol_files(folder)) {
      if (notes_of(read_file(file, kProtocolFile), rendering_name(path)).empty()) continue;
      (sessions_of_protocol(study, file) > 0 ? plan.unchanged : plan.changed).push_back(file);
    }
  }
  sort_once(plan.changed);
  return plan;
}

std::string rename_stimulus(const Study& study, const std::string& path, const std::string& stem) {
  return rename_stimulus(study, plan_of_renaming(study, path), stem);
}

std::string rename_stimulus(const Study& study, const RenamePlan& plan, const std::string& stem) {
  if (!is_stimulus_name(stem)) {
    throw PhrasedError(phrase("StimulusFiles",
                              "“%1” cannot be the name of a stimulus. Use at most %2 unaccented "
                              "letters, digits, _ and -.")
                           .with(stem, std::to_string(kLongestStimulusName)));
  }
  const std::string& path = plan.stimuli.front();
  const std::string renamed = kFolder + stem + ending_of(path);
  if (renamed == path) return path;
  if (plan.complaint) throw PhrasedError(*plan.complaint);
  NewNames names{};
  for (const std::string& from : plan.stimuli) {
    names.emplace_back(from, from == path ? renamed : photograph_of(renamed).string());
  }
  const std::vector<NewFile> files = files_with_names(study.folder(), names);
  const std::vector<ChangedText> texts = texts_with_names(plan.changed, names);
  write_files_together(files, Overwrite::refuse);
  try {
    replace_texts(texts);
  } catch (...) {
    for (const NewFile& file : files) remove_file(file.path);
    throw;
  }
  for (const std::string& file : plan.files) remove_file(study.folder() / file);
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
  const std::set<std::string> named = paths_in_protocols(other);
  std::vector<ForeignStimulus> stimuli{};
  for (const auto& entry : entries_in(other / "stimuli")) {
    ForeignStimulus stimulus{.path = kFolder + entry.path().filename().string()};
    std::error_code unknown{};
    if (!entry.is_regular_file(unknown)) continue;
    if (!is_stimulus_file(entry.path()) && !named.contains(stimulus.path)) continue;
    stimulus.files = files_to_copy(other, stimulus.path);
    std::size_t same = 0;
    bool is_taken = false;
    for (const std::string& file : stimulus.files) {
      if (!is_there(study / file)) continue;
      const bool is_same = holds({study / file, read_file(other / file, kPictureFile)});
      same += is_same ? 1 : 0;
      is_taken = is_taken || !is_same;
    }
    if (is_taken) {
      stimulus.state = ForeignStimulus::State::name_is_taken;
    } else if (same == stimulus.files.size()) {
      stimulus.state = ForeignStimulus::State::is_there;
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
    for (const std::string& part : files_to_copy(other, path)) {
      NewFile file{study / part, read_file(other / part, kPictureFile)};
      if (!holds(file)) files.push_back(std::move(file));  // otherwise it has been copied before
    }
    if (!files.empty()) write_files_together(files, Overwrite::refuse);
    ++copied;
  }
  return copied;
}

}  // namespace asperity
