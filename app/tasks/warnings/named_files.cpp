// Reads each file as its kind requires, and makes bodies and renderers once.

#include "app/tasks/warnings/named_files.h"

#include <exception>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "app/tasks/demo_stimuli.h"
#include "app/tasks/warnings/rehearsed_stimuli.h"
#include "app/words/phrase_of_error.h"
#include "protocols/design/wording.h"
#include "protocols/file/protocol_reader.h"
#include "results_schema/files/atomic_file.h"
#include "stimuli/pictures/photograph.h"

namespace asperity {

namespace {

/// Whether the file lies below the study, with links resolved.
bool lies_in(const std::filesystem::path& study, const std::filesystem::path& file) {
  const std::filesystem::path relative =
      std::filesystem::canonical(file).lexically_relative(std::filesystem::canonical(study));
  return !relative.empty() && *relative.begin() != "..";
}

/// Whether the content begins as a WAV file does. Its encoding is checked when it is played.
bool is_wav(const std::string& content) {
  return content.starts_with("RIFF") && content.size() > 12 && content.compare(8, 4, "WAVE") == 0;
}

/// Why a file that a protocol names cannot be used; nothing when it can.
std::optional<Phrase> complaint_about_file(const NamedFile& named,
                                           const std::filesystem::path& study,
                                           StimulusBuilder& builder) {
  for (const std::string& path : paths_of(named)) {
    std::error_code unknown{};
    // What is there and is no file is refused below, as the file that is read.
    if (std::filesystem::status(study / path, unknown).type() ==
        std::filesystem::file_type::not_found) {
      const Phrase sentence =
          !demo_stimulus_of(path).empty()
              ? phrase("Protocols",
                       "the file %1 is not in the study %2; copy the file into the study, or the "
                       "computed texture of this name from a demo study (asperity new DIR --demo), "
                       "together with its .json if there is one")
              : phrase("Protocols",
                       "the file %1 is not in the study %2; copy the file into the study");
      return sentence.with(path, study.string());
    }
  }
  try {
    for (const std::string& path : paths_of(named)) {
      if (lies_in(study, study / path)) continue;
      return phrase("Protocols",
                    "the file %1 is a symbolic link to %2, which is outside the study %3; copy the "
                    "file into the study")
          .with(path, std::filesystem::canonical(study / path).string(), study.string());
    }
    switch (named.kind) {
      case NamedFile::Kind::height_field:
        builder.height_field(named.path);
        break;
      case NamedFile::Kind::asset:
        builder.asset(named.path);  // its content: problems_of_assets
        break;
      case NamedFile::Kind::textured_mesh:
        builder.require_body({.mesh = named.path});
        break;
      case NamedFile::Kind::picture: {
        const std::string content = read_file(study / named.path, kPictureFile);
        inspect_picture(std::as_bytes(std::span(content)), (study / named.path).string());
        break;
      }
      case NamedFile::Kind::speech:
        if (!is_wav(read_file(study / named.path, kSpeechFile))) {
          return phrase("Protocols", "the file %1 is not a WAV file; save it as WAV")
              .with(named.path);
        }
        break;
    }
  } catch (const std::exception& error) {
    return phrase_of(error);
  }
  return {};
}

/// Checks shapes with a relief: whether they can be made depends on the pitch of its file.
std::vector<Diagnostic> problems_of_shapes(const CheckedProtocol& checked,
                                           StimulusBuilder& builder) {
  std::map<std::pair<std::string, std::string>, const BodyDescription*> bodies{};
  for (const auto& [trial, planned] : checked.presentations()) {
    for (const auto* const body : {&planned.stimulus.surface, &planned.stimulus.tool}) {
      if (*body && (*body)->shape) {
        bodies.emplace(std::pair((*body)->name, (*body)->height_field.value_or("")), &**body);
      }
    }
  }
  std::vector<Diagnostic> problems{};
  for (const auto& [name, body] : bodies) {
    try {
      builder.require_body(*body);
    } catch (const std::exception& error) {
      problems.push_back(
          checked.at_body(body->name, phrase("Protocols", "the body %1 cannot be made: %2")
                                          .with(in_quotes(body->name), phrase_of(error))));
    }
  }
  return problems;
}

/// Declared assets whose content their model refuses: only the model can read it.
std::vector<Diagnostic> problems_of_assets(const CheckedProtocol& checked,
                                           StimulusBuilder& builder) {
  std::vector<Diagnostic> problems{};
  std::set<std::string> made{};
  for (const auto& [trial, planned] : checked.presentations()) {
    const ForceModel* const model = builder.models().find(planned.stimulus.model);
    if (model == nullptr || model->declaration.assets.empty()) continue;
    if (!made.insert(name_of_making(planned.stimulus)).second) continue;
    try {
      make_renderer(*model, builder.unmatched(planned.stimulus).inputs);
    } catch (const std::exception& error) {
      problems.push_back(checked.cannot_be_rendered(planned, phrase_of(error)));
    }
  }
  return problems;
}

}  // namespace

std::vector<Diagnostic> problems_of_named_files(
    const Protocol& protocol, const std::string& file_name, const std::filesystem::path& study,
    StimulusBuilder& builder, const std::function<bool(const Diagnostic& place)>& is_looked_at) {
  std::vector<Diagnostic> problems{};
  for (const NamedFile& named : files_of(protocol, file_name)) {
    if (!is_looked_at(named.place)) continue;
    if (const auto complaint = complaint_about_file(named, study, builder)) {
      problems.push_back(named.place);
      problems.back().message = *complaint;
    }
  }
  return problems;
}

std::vector<Diagnostic> problems_of_files(const CheckedProtocol& checked,
                                          const std::filesystem::path& study,
                                          StimulusBuilder& builder) {
  std::vector<Diagnostic> problems = problems_of_named_files(
      checked.protocol, checked.file_name, study, builder, [](const Diagnostic&) { return true; });
  if (problems.empty()) problems = problems_of_shapes(checked, builder);
  if (problems.empty()) problems = problems_of_assets(checked, builder);
  return problems;
}

}  // namespace asperity
