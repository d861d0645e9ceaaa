// Implements the lists for the choice of a template.

#include "app/tasks/template_overviews.h"

#include <algorithm>
#include <cctype>
#include <exception>

#include "app/study_files/height_field_files.h"
#include "app/study_files/stimulus_names.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/form/new_values.h"
#include "protocols/plan/course.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/hashes/sha256.h"

namespace asperity {

namespace {

/// The parameter of computed surfaces whose elements have a distance.
constexpr std::string_view kSpacing = "spacing_m";

/// The languages of a protocol of the library, that of the reader first if it has this one.
std::vector<std::string> languages_of(const LibraryProtocol& protocol, const std::string& reader) {
  std::vector<std::string> languages{language_of(std::string(protocol.text))};
  for (const LibraryTranslation& each : protocol.translations) {
    languages.insert(each.language == reader ? languages.begin() : languages.end(),
                     std::string(each.language));
  }
  return languages;
}

/// A relief with its spacing, and with the photograph that it was made from if the study has it. The file of the photograph's name
/// is used only with its content: the relief of a photograph brick.png is saved as brick.png, too.
OwnTexture texture_in(const std::filesystem::path& stimuli, const std::filesystem::path& png,
                      const std::string& name) {
  OwnTexture texture{.name = name, .height_field = "stimuli/" + png.filename().string()};
  std::error_code unknown{};
  try {
    const HeightFieldProvenance made = provenance_of(png);
    if (made.parameters.contains(kSpacing)) {
      texture.spacing_m = number_of(made.parameters, kSpacing);
    }
    const std::filesystem::path source =
        stimuli / std::filesystem::path(made.source_name).filename();
    if (!made.source_name.empty() && std::filesystem::is_regular_file(source, unknown) &&
        sha256_of_file(source) == made.source_sha256) {
      texture.picture = "stimuli/" + source.filename().string();
    }
  } catch (const std::exception&) {  // the check of the protocol states what is wrong with the file
  }
  const std::filesystem::path saved = stimuli / photograph_of(png).filename();
  if (texture.picture.empty() && std::filesystem::is_regular_file(saved, unknown)) {
    texture.picture = "stimuli/" + saved.filename().string();
  }
  return texture;
}

}  // namespace

std::string name_in_protocol(const std::string& stem) {
  std::string name{};
  for (const char c : stem) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte < 0x80U && std::isalnum(byte) != 0;
    name += is_plain ? static_cast<char>(std::tolower(byte)) : '_';
  }
  if (name.empty() || std::isalpha(static_cast<unsigned char>(name.front())) == 0) {
    name.insert(0, "texture_");
  }
  constexpr std::size_t kForANumber = 4;  // that distinguishes equal names
  return name.substr(0, kMaximumNameLength - kForANumber);
}

std::vector<TemplateOverview> template_overviews(const ModelRegistry& models,
                                                 const std::string& language,
                                                 const std::stop_token& stop) {
  const std::vector<ModelDeclaration> declarations = declarations_of(models);
  std::vector<TemplateOverview> overviews{};
  for (const LibraryProtocol& protocol : library_protocols()) {
    if (stop.stop_requested()) break;
    TemplateOverview overview{.name = std::string(protocol.name),
                              .textures = textures_of(protocol)};
    for (const std::string& each : languages_of(protocol, language)) {
      overview.protocols.push_back(
          read_protocol(text_in_language(protocol, each), overview.name, declarations));
    }
    const Protocol& read = overview.protocols.front();
    overview.cost = cost_of(read, example_plan(read, {1, 0}));
    overviews.push_back(std::move(overview));
  }
  return overviews;
}

std::vector<OwnTexture> reliefs_of_study(const std::filesystem::path& study) {
  const std::filesystem::path stimuli = study / "stimuli";
  std::vector<OwnTexture> reliefs{};
  if (!std::filesystem::is_directory(stimuli)) return reliefs;
  std::vector<std::filesystem::path> files{};
  for (const auto& entry : entries_in(stimuli)) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() == ".png" && std::filesystem::exists(sidecar_of(file)) &&
        !file.stem().string().ends_with("_true")) {
      files.push_back(file);
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> names{};
  for (const std::filesystem::path& file : files) {
    names.push_back(free_name(names, name_in_protocol(file.stem().string())));
    reliefs.push_back(texture_in(stimuli, file, names.back()));
  }
  return reliefs;
}

}  // namespace asperity
