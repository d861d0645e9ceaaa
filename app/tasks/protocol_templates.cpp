// Finds the first free names of a protocol and of its textures, and changes them in the protocol accordingly.

#include "app/tasks/protocol_templates.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/study_files/study_protocols.h"
#include "app/tasks/demo_stimuli.h"
#include "protocols/editing/edits.h"
#include "protocols/file/protocol_problems.h"
#include "protocols/file/translation.h"
#include "protocols/form/form_edits.h"
#include "protocols/form/new_values.h"
#include "protocols/keys/names_in.h"
#include "protocols/kinds/estimation.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/course.h"
#include "protocols/shapes/key.h"
#include "protocols/warnings/plan_warnings.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/files/part_folder.h"
#include "results_schema/study_sharing.h"

namespace asperity {

namespace {

const LibraryProtocol& library_protocol(std::string_view name) {
  std::string names{};
  for (const LibraryProtocol& protocol : library_protocols()) {
    if (protocol.name == name) return protocol;
    names += (names.empty() ? "" : ", ") + std::string(protocol.name);
  }
  throw std::invalid_argument("the library has no protocol \"" + std::string(name) +
                              "\"; choose one of: " + names);
}

/// The files in `stimuli/` that a value names, at any depth.
void collect_files(const nlohmann::json& value, std::set<std::string>& files) {
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    if (text.starts_with("stimuli/")) files.insert(text);
  } else if (value.is_structured()) {
    for (const nlohmann::json& part : value) collect_files(part, files);
  }
}

std::set<std::string> files_of(std::string_view text) {
  std::set<std::string> files{};
  collect_files(nlohmann::json::parse(text), files);
  return files;
}

/// The file of another name of the stimulus: "brick_2_photo.png" of "brick_photo.png".
std::string renamed_file(const std::string& file, const std::string& stimulus,
                         const std::string& name) {
  return name + file.substr(stimulus.size());
}

/// Writes the files of a stimulus of the demonstration and returns its name in the study: files that the study has already are
/// used if they are the same.
std::string write_demo_stimulus(const std::string& stimulus, const std::filesystem::path& made,
                                const std::filesystem::path& stimuli) {
  const std::vector<std::string> files = files_of_demo_stimulus(stimulus);
  const auto has_others = [&](const std::string& name) {
    return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
      const std::filesystem::path there = stimuli / renamed_file(file, stimulus, name);
      // A sidecar states the version of the program, so that the pictures are compared.
      return !file.ends_with(".json") && std::filesystem::exists(there) &&
             read_file(there) != read_file(made / file);
    });
  };
  const std::string name = free_name(stimulus, has_others);
  for (const std::string& file : files) {
    const std::filesystem::path there = stimuli / renamed_file(file, stimulus, name);
    if (!std::filesystem::exists(there)) {
      write_file(there, read_file(made / file), Overwrite::refuse);
    }
  }
  return name;
}

/// The protocol's text with the names that its textures of the demonstration have in the study, where they are written.
std::string with_demo_stimuli(std::string text, const std::filesystem::path& study) {
  std::map<std::string, std::string> names{};
  for (const std::string& file : files_of(text)) {
    const std::string stimulus = demo_stimulus_of(file);
    if (stimulus.empty() || names.contains(stimulus)) continue;
    const PartFolder part(study / "stimuli" / ("computed_" + stimulus), kOwnersFolder);
    make_demo_stimulus(stimulus, part.content());
    names[stimulus] = write_demo_stimulus(stimulus, part.content(), study / "stimuli");
  }
  for (const std::string& file : files_of(text)) {
    const std::string stimulus = demo_stimulus_of(file);
    if (stimulus.empty() || names.at(stimulus) == stimulus) continue;
    const std::string prefix = "stimuli/";
    const std::string renamed =
        prefix + renamed_file(file.substr(prefix.size()), stimulus, names.at(stimulus));
    const std::string before = nlohmann::json(file).dump();
    for (std::size_t at = 0; (at = text.find(before, at)) != std::string::npos;) {
      text.replace(at, before.size(), nlohmann::json(renamed).dump());
    }
  }
  return text;
}

/// Without the levels that are force models which need files that reliefs do not have, such as recordings.
std::string without_models_of_files(std::string text, const std::string& name,
                                    const std::vector<ModelDeclaration>& models) {
  const JsonDocument protocol(text, name);
  const ProtocolNames names = names_in(protocol.root());
  std::vector<std::string> removed{};
  for (const ModelDeclaration& model : models) {
    if (model.assets.empty()) continue;
    for (const NameUse& use : uses_of(names, std::string(kModelNames), model.id)) {
      if (use.is_declared) removed.push_back(use.pointer);
    }
  }
  return removed.empty() ? text : with_removed(protocol, std::move(removed)).text;
}

/// An estimation by the spacing of textures that do not state enough for a curve compares them as any other stimuli, by their
/// factor.
std::string with_estimated_stimuli(std::string text, const std::string& name) {
  const nlohmann::json root = nlohmann::json::parse(text);
  const nlohmann::json::json_pointer by_spacing("/estimation/spacing");
  if (!root.contains(by_spacing)) return text;
  const auto textures = root.value("textures", nlohmann::json::object());
  const auto levels = root.value("factors", nlohmann::json::object())
                          .value(root.at(by_spacing).get<std::string>(), nlohmann::json::object())
                          .value("levels", nlohmann::json::array());
  std::set<double> spacings{};  // 0: a texture has none
  for (const nlohmann::json& level : levels) {
    spacings.insert(level.is_number()
                        ? level.get<double>()
                        : textures.at(level.get<std::string>()).value("spacing_m", 0.0));
  }
  if (!spacings.contains(0.0) && spacings.size() >= kLevelsOfCurve) return text;
  const auto with = [&](const std::string& pointer, const nlohmann::json& value) {
    text = with_value(JsonDocument(text, name), pointer, value.dump()).text;
  };
  with("/estimation/factor", root.at(by_spacing));
  text = without(JsonDocument(text, name), std::vector{by_spacing.to_string()}).text;
  const nlohmann::json::json_pointer family("/analysis/family");
  if (!root.contains(family)) return text;
  std::vector<std::string> tests{};
  for (const std::string test : root.at(family)) {
    const KindTest* const found = find_test(kind_named("magnitude"), test);
    const bool is_by_spacing = found != nullptr && found->estimated_by == kBySpacing;
    if (!is_by_spacing) tests.push_back(test);
    if (is_by_spacing && !found->by_factor.empty()) tests.emplace_back(found->by_factor);
  }
  with(family.to_string(), tests);
  return text;
}

/// Without breaks after more trials than runs of fewer stimuli have.
std::string without_unreached_breaks(const std::string& text, const std::string& name,
                                     const std::vector<ModelDeclaration>& models) {
  const ProtocolReading reading = read_protocol_with_problems(text, name, models);
  if (!reading.protocol || !reading.problems.empty()) return text;
  std::vector<std::string> removed{};
  const nlohmann::json root = nlohmann::json::parse(text);
  const Plan plan = example_plan(*reading.protocol, {1, 0});
  for (const Diagnostic& warning : warnings_about_plan(*reading.protocol, name, plan)) {
    const nlohmann::json::json_pointer place(warning.pointer);
    if (place.empty() || place.back() != "break_every_trials") continue;
    removed.push_back(warning.pointer);
    // The rest is also that after a time of contact, and between the runs of a block.
    const nlohmann::json& step = root.at(place.parent_pointer());
    const bool is_needed =
        step.contains("break_every_contact_minutes") || step.contains("for_each");
    if (step.contains("pause") && !is_needed) {
      removed.push_back((place.parent_pointer() / "pause").to_string());
    }
  }
  return without(JsonDocument(text, name), removed).text;
}

}  // namespace

std::string text_in_language(const LibraryProtocol& protocol, const std::string& language) {
  for (const LibraryTranslation& each : protocol.translations) {
    if (each.language != language) continue;
    const std::string name(protocol.name);
    return translated(protocol.text, name, {each.text, name, language}).text;
  }
  return std::string(protocol.text);
}

std::filesystem::path protocol_from_template(const std::filesystem::path& study,
                                             const TemplateChoice& choice) {
  const std::filesystem::path folder = study / "protocols";
  std::set<std::string> taken{};  // also by translations, which would be those of the new protocol
  for (const auto& entry : entries_in(folder)) {
    taken.insert(entry.path().stem().stem().string());
  }
  const std::string name =
      free_name(choice.name, [&taken](const std::string& one) { return taken.contains(one); });
  std::string text = text_from_template(choice);
  if (choice.textures.from == TemplateTextures::From::demonstration) {
    text = with_demo_stimuli(std::move(text), study);
  }
  const std::filesystem::path file = folder / (name + ".json");
  write_file(file, with_protocol_name(std::move(text), name), Overwrite::refuse);
  return file;
}

std::string text_from_template(const TemplateChoice& choice) {
  std::string text = text_in_language(library_protocol(choice.name), choice.language);
  // Its authors and its licence are not those of the library.
  text =
      without(JsonDocument(text, choice.name), std::array<std::string, 2>{"/authors", "/license"})
          .text;
  if (!choice.title.empty()) {
    const std::string title = json_string(choice.title);
    text = with_value(JsonDocument(text, choice.name), "/title", title).text;
  }
  if (choice.textures.from != TemplateTextures::From::study) return text;
  const std::vector<ModelDeclaration> models = declarations_of(built_in_models());
  text = with_textures(JsonDocument(text, choice.name), choice.textures.own);
  text = without_models_of_files(std::move(text), choice.name, models);
  text = with_estimated_stimuli(std::move(text), choice.name);
  return without_unreached_breaks(text, choice.name, models);
}

CheckedTemplate check_of_template(const std::filesystem::path& study, const TemplateChoice& choice,
                                  const ModelRegistry& models, KeptHeightFields* kept) {
  // The files of the demonstration are not written yet.
  const bool has_files = choice.textures.from != TemplateTextures::From::demonstration;
  CheckedTemplate checked{.text = text_from_template(choice)};
  checked.check =
      check_protocol_text(checked.text, choice.name, models,
                          has_files ? std::optional(study) : std::nullopt, std::nullopt, kept);
  return checked;
}

void write_library_protocol(const std::filesystem::path& study, const LibraryProtocol& protocol) {
  const std::string file = (study / "protocols" / protocol.name).string();
  write_file(file + ".json", protocol.text, Overwrite::refuse);
  for (const LibraryTranslation& each : protocol.translations) {
    write_file(file + '.' + std::string(each.language) + ".json", each.text, Overwrite::refuse);
  }
}

TexturesOfTemplate textures_of(const LibraryProtocol& protocol) {
  TexturesOfTemplate textures{};
  const nlohmann::json parsed = nlohmann::json::parse(protocol.text);
  const nlohmann::json declared = parsed.value("textures", nlohmann::json::object());
  for (const auto& [name, texture] : declared.items()) {
    if (is_comment(name)) continue;
    textures.names.push_back(name);
    textures.have_pictures = textures.have_pictures || texture.contains("picture");
  }
  const std::set<std::string> files = files_of(protocol.text);
  textures.are_of_demonstration =
      !files.empty() && std::all_of(files.begin(), files.end(), [](const std::string& file) {
        return !demo_stimulus_of(file).empty();
      });
  return textures;
}

}  // namespace asperity
