// Reads the file, then checks files, assets and shapes, and strokes each surface with a simulated hand.

#include "app/tasks/protocol_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <system_error>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/random.h"
#include "app/profiles/device_kind.h"
#include "app/session/attempt_measures.h"
#include "app/session/trial_attempt.h"
#include "app/study_files/parameter_json.h"
#include "app/study_files/protocol_languages.h"
#include "app/tasks/demo_stimuli.h"
#include "app/tasks/warnings/level_problems.h"
#include "app/tasks/warnings/plugin_stimuli.h"
#include "app/tasks/warnings/plugin_warnings.h"
#include "device/simulated_device.h"
#include "device/simulated_models.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/file/protocol_problems.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/plan/block_design.h"
#include "protocols/plan/course.h"
#include "protocols/plan/plan.h"
#include "protocols/warnings/analysis_warnings.h"
#include "protocols/warnings/design_warnings.h"
#include "protocols/warnings/plan_warnings.h"
#include "protocols/warnings/text_warnings.h"
#include "protocols/warnings/warnings.h"
#include "renderers/pd_gradient/geometry/finest_wave.h"
#include "renderers/servo/contact.h"
#include "results_schema/error_text.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "results_schema/tables/table.h"
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
std::optional<std::string> complaint_about_file(const NamedFile& named,
                                                const std::filesystem::path& study,
                                                StimulusBuilder& builder) {
  for (const std::string& path : paths_of(named)) {
    std::error_code unknown{};
    // What is there and is no file is refused below, as the file that is read.
    if (std::filesystem::status(study / path, unknown).type() ==
        std::filesystem::file_type::not_found) {
      const char* const from =
          !demo_stimulus_of(path).empty()
              ? "; the demo study has one of this name (asperity new DIR --demo creates "
                "it): copy it from there, together with its .json if there is one"
              : "; copy the file into the study";
      return "the file " + path + " is not in the study " + study.string() + from;
    }
  }
  try {
    for (const std::string& path : paths_of(named)) {
      if (lies_in(study, study / path)) continue;
      return "the file " + path + " is a symbolic link to " +
             std::filesystem::canonical(study / path).string() + ", which is outside the study " +
             study.string() + "; copy the file into the study";
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
          return "the file " + named.path + " is not a WAV file; save it as WAV";
        }
        break;
    }
  } catch (const std::exception& error) {
    return message_of(error);
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
      problems.push_back(checked.at_body(
          body->name, "the body \"" + body->name + "\" cannot be made: " + message_of(error)));
    }
  }
  return problems;
}

/// Everything that a stimulus is rendered from, as a name.
std::string name_of_making(const StimulusDescription& stimulus) {
  std::string name = stimulus.model + json_text_of(stimulus.parameters);
  for (const auto* const body : {&stimulus.surface, &stimulus.tool}) {
    if (*body) name += ' ' + (*body)->name;
  }
  for (const StimulusAsset& asset : assets_of(stimulus)) {
    name += ' ' + asset.role + ' ' + asset.path;
  }
  return name;
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
      problems.push_back(checked.at_stimulus(planned.stimulus_template,
                                             "the stimulus \"" + planned.stimulus.name +
                                                 "\" cannot be rendered: " + message_of(error)));
    }
  }
  return problems;
}

enum class FirstTouch { from_outside, never, never_outside };

/// Finds the first contact of the simulated device's hand, which strokes to and fro, with the
/// surface. It meets no force before, so that no servo loop is required. As in a session, a tool
/// that begins inside the surface has to leave it first. The stroke then continues for `beyond_s`,
/// to evaluate the model's limits.
FirstTouch first_touch(ForceRenderer& renderer, const HandHabits& habits, double rate_Hz,
                       double beyond_s) {
  constexpr double kSeveralStrokes_s = 10.0;
  VirtualHand hand(habits, Random(0));
  SimulatedDevice device(hand, {});
  hand.stroke();
  bool has_been_free = false;
  std::optional<int> last_tick{};
  for (int tick = 0; tick < kSeveralStrokes_s * rate_Hz; ++tick) {
    const ProbeState probe = device.read(std::llround(1e9 * tick / rate_Hz)).value();
    if (tick == 0) renderer.reset(probe);
    const bool is_free = !is_in_contact(renderer.tick(probe, 1.0 / rate_Hz));
    if (has_been_free && !is_free && !last_tick) {
      last_tick = tick + static_cast<int>(beyond_s * rate_Hz);
    }
    if (last_tick && tick >= *last_tick) return FirstTouch::from_outside;
    has_been_free = has_been_free || is_free;
  }
  if (last_tick) return FirstTouch::from_outside;
  return has_been_free ? FirstTouch::never : FirstTouch::never_outside;
}

std::string in_mm(double from_m, double to_m) {
  return fixed(1e3 * from_m, 1) + " to " + fixed(1e3 * to_m, 1) + " mm";
}

/// The positions of the strokes and of the surface, and the correction.
std::string never_touched(const StimulusDescription& stimulus, const TexturedMesh& surface,
                          const HandHabits& habits, FirstTouch touch) {
  glm::dvec3 low_m = surface.vertices_m.front();
  glm::dvec3 high_m = low_m;
  for (const glm::dvec3& vertex_m : surface.vertices_m) {
    low_m = glm::min(low_m, vertex_m);
    high_m = glm::max(high_m, vertex_m);
  }
  const glm::dvec2 end_m =
      0.5 * habits.stroke_length_m *
      glm::dvec2(std::cos(habits.direction_rad), std::sin(habits.direction_rad));
  std::string surface_name = "the surface \"" + stimulus.surface->name + '"';
  if (stimulus.surface->mesh) surface_name += " (" + *stimulus.surface->mesh + ')';
  const std::string tool_name =
      stimulus.tool ? "the tool \"" + stimulus.tool->name + '"' : std::string("the hand");
  std::string sentence =
      touch == FirstTouch::never
          ? "no part of " + surface_name + " lies under the path of " + tool_name
          : tool_name + " begins inside " + surface_name + " and never leaves it";
  sentence += ": strokes begin in the plane z = 0, " + fixed(0.5e3 * habits.stroke_length_m, 1) +
              " mm from the middle, and the surface lies at x " + in_mm(low_m.x, high_m.x) +
              ", y " + in_mm(low_m.y, high_m.y) + ", z " + in_mm(low_m.z, high_m.z);
  const double off_m = 0.01 * (high_m.z - low_m.z);
  if (stimulus.surface->mesh && std::abs(high_m.z) > off_m) {
    sentence += std::abs(low_m.z) <= off_m
                    ? "; its lowest point lies in that plane, as after `asperity bake --for tool`: "
                      "bake it again with `--for surface`"
                    : "; the highest point of a surface must lie in that plane: bake it again with "
                      "`--for surface`";
  }
  const auto ends_before = [&](const glm::dvec2& place_m) {
    return place_m.x < low_m.x || place_m.x > high_m.x || place_m.y < low_m.y ||
           place_m.y > high_m.y;
  };
  if (ends_before(end_m) || ends_before(-end_m)) {
    sentence +=
        "; the strokes extend beyond the surface: make the surface longer, or reduce "
        "`stroke_length_m` of the exploration";
  }
  return sentence;
}

std::string micrometres_text(double length_m) {
  constexpr double kMicrometres_per_m = 1e6;
  return fixed(kMicrometres_per_m * length_m, 0) + " µm";
}

/// To whole micrometres: a cell of this width contains the waves from which it was computed.
double rounded_down_m(double cell_m) {
  constexpr double kMicrometre_m = 1e-6;
  return cell_m > kMicrometre_m ? kMicrometre_m * std::floor(cell_m / kMicrometre_m) : cell_m;
}

/// Both numbers of a texture that is finer than the samples of a contact, and the correction;
/// nothing where the cause is a different one, such as a contact that is too wide.
std::string why_too_fine(const PreparedStimulus& stimulus) {
  constexpr double kSamplesPerWave = 8.0;  // as in pd_gradient
  const ParameterValues& own = stimulus.inputs.parameters;
  const double finest_m =
      std::min(finest_wave_m(*stimulus.inputs.tool, number_of(own, "tool_texture_gain")),
               finest_wave_m(*stimulus.inputs.surface, number_of(own, "texture_gain")));
  const double cell_m = number_of(own, "cell_m");
  if (!(kSamplesPerWave * cell_m > finest_m)) return {};
  return ": its shortest wavelength is " + micrometres_text(finest_m) + ", and samples of " +
         micrometres_text(cell_m) + " (cell_m) represent wavelengths of " +
         micrometres_text(kSamplesPerWave * cell_m) +
         " and longer; use a texture without shorter wavelengths, or a cell_m of " +
         micrometres_text(rounded_down_m(finest_m / kSamplesPerWave)) +
         " or less, which takes longer to render. A step at the seam of a repeated tile counts as "
         "the shortest wavelength";
}

struct LimitBeyond {
  std::string limit{};
  std::string sentence{};
};

/// The limits that the model counted in at least half of the contact; the first count is the
/// contact.
std::vector<LimitBeyond> limits_beyond(const StimulusDescription& described,
                                       const PreparedStimulus& stimulus,
                                       const ForceRenderer& renderer) {
  std::vector<LimitBeyond> warnings{};
  const std::span<const NamedCount> counts = renderer.limits();
  if (counts.empty() || counts.front().name != "contact") return warnings;
  const std::uint64_t contact = counts.front().ticks;
  for (const NamedCount& count : counts.subspan(1)) {
    if (contact == 0 || 2 * count.ticks < contact) continue;
    std::string sentence = "the stimulus \"" + described.name + '"';
    if (!described.texture.empty()) {
      sentence += " with the texture \"" + described.texture + '"';
      if (described.height_field) sentence += " (" + *described.height_field + ')';
    }
    if (described.tool) sentence += " under the tool \"" + described.tool->name + '"';
    sentence += " violates the assumption " + std::string(count.name) + " of " + described.model +
                " (ticks of contact: " + std::to_string(count.ticks) + " of " +
                std::to_string(contact) +
                "); where it does, its force differs from the declared force";
    const bool has_bodies = stimulus.inputs.tool && stimulus.inputs.surface;
    const std::string correction =
        count.name == "fine_detail" && has_bodies ? why_too_fine(stimulus) : "";
    sentence += correction.empty()
                    ? " (see \"Counted conditions\" in docs/models/" + described.model + ".md)"
                    : correction;
    warnings.push_back({.limit = std::string(count.name), .sentence = std::move(sentence)});
  }
  return warnings;
}

/// Problems of the files that a protocol names. `is_looked_at` selects the files, by their place.
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

}  // namespace

std::filesystem::path found_protocol(const std::filesystem::path& file,
                                     const std::optional<std::filesystem::path>& study) {
  if (std::filesystem::exists(file) || !study) return file;
  for (const auto& candidate : {*study / file, *study / "protocols" / file,
                                *study / "protocols" / (file.string() + ".json")}) {
    if (std::filesystem::is_regular_file(candidate)) return candidate;
  }
  return file;
}

Protocol load_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                       const std::optional<std::filesystem::path>& study) {
  const std::filesystem::path found = found_protocol(file, study);
  const ProtocolSource source = protocol_source(found);
  return read_protocol(source.text, source.file.string(), declarations_of(models));
}

Protocol load_protocol_to_run(const std::filesystem::path& file, const std::filesystem::path& study,
                              StimulusBuilder& builder, RehearsalMemory* memory) {
  Protocol protocol = load_protocol(file, builder.models(), study);
  const std::string found = found_protocol(file, study).string();
  const CheckedProtocol checked(protocol, found);
  std::vector<Diagnostic> problems = problems_of_files(checked, study, builder);
  if (problems.empty()) problems = problems_of_plugin_stimuli(checked, builder);
  const auto rehearsed = [&] { return rehearse(checked, builder); };
  if (problems.empty()) {
    problems = memory == nullptr ? rehearsed()
                                 : memory->problems_once(content_key(protocol, study), rehearsed);
  }
  if (!problems.empty()) throw ProtocolError(std::move(problems));
  return protocol;
}

namespace {

/// `beyond_s` of contact are checked for warnings.
RehearsedStimuli rehearsed_stimuli(const CheckedProtocol& checked, StimulusBuilder& builder,
                                   double beyond_s, const std::stop_token& stop) {
  const Protocol& protocol = checked.protocol;
  std::set<std::string> made{};
  std::set<std::string> untouched{};
  std::set<std::string> said{};
  RehearsedStimuli found{};
  for (const auto& [trial, planned] : checked.presentations()) {
    const StimulusDescription& stimulus = planned.stimulus;
    if (!stimulus.surface) continue;
    if (stop.stop_requested()) return found;
    const Exploration& exploration = exploration_of(protocol, trial);
    if (!made.insert(name_of_making(stimulus) + ' ' + exploration.name).second) continue;
    try {
      const PreparedStimulus prepared = builder.unmatched(stimulus);
      const HandHabits habits = habits_for(exploration, stimulus.patch);
      const auto renderer = make_renderer(*prepared.model, prepared.inputs);
      // already reported with another tool
      if (untouched.contains(stimulus.surface->name)) continue;
      const FirstTouch touch = first_touch(*renderer, habits, protocol.rate_Hz, beyond_s);
      if (touch == FirstTouch::from_outside) {
        if (beyond_s <= 0.0) continue;
        for (const LimitBeyond& beyond : limits_beyond(stimulus, prepared, *renderer)) {
          // The same contact with another exploration, a few ticks longer or shorter.
          const std::string what = name_of_making(stimulus) + ' ' + beyond.limit;
          if (!said.insert(what).second) continue;
          found.warnings.push_back(checked.at_stimulus(planned.stimulus_template, beyond.sentence));
        }
        continue;
      }
      untouched.insert(stimulus.surface->name);
      found.problems.push_back(checked.at_body(
          stimulus.surface->name,
          never_touched(stimulus, *builder.body(*stimulus.surface, BodyRole::surface).mesh, habits,
                        touch)));
    } catch (const std::exception& error) {
      found.problems.push_back(checked.at_stimulus(
          planned.stimulus_template,
          "the stimulus \"" + stimulus.name + "\" cannot be rendered: " + message_of(error)));
    }
  }
  return found;
}

}  // namespace

std::vector<Diagnostic> rehearse(const CheckedProtocol& checked, StimulusBuilder& builder) {
  return rehearsed_stimuli(checked, builder, 0.0, {}).problems;
}

RehearsedStimuli rehearse_with_warnings(const CheckedProtocol& checked, StimulusBuilder& builder,
                                        const std::stop_token& stop) {
  constexpr double kWatched_s = 0.02;
  return rehearsed_stimuli(checked, builder, kWatched_s, stop);
}

namespace {

/// "no session can run in the language "de": WHAT a problem at line 3: …"
Diagnostic unusable_language(const std::string& file, const ProtocolInLanguage& translation,
                             const std::string& what, const std::vector<Diagnostic>& problems) {
  const Diagnostic& first = problems.front();
  return {
      file, 1, 1, "",
      "no session can run in the language " + in_quotes(translation.language) + ": " + what +
          (problems.size() == 1 ? " a problem"
                                : ' ' + std::to_string(problems.size()) + " problems, the first") +
          " at line " + std::to_string(first.line) + ": " + first.message};
}

/// A warning for every translation of the protocol that cannot be used, and for translated texts that contradict the design.
std::vector<Diagnostic> warnings_about_translations(const std::string& file,
                                                    const ModelRegistry& models) {
  std::vector<Diagnostic> warnings{};
  for (const ProtocolInLanguage& each : languages_of_protocol(file)) {
    if (each.file == file) continue;
    const std::string name = each.file.filename().string();
    try {
      const std::string text = protocol_source(each.file).text;
      const ProtocolReading reading =
          read_protocol_with_problems(text, file, declarations_of(models));
      if (!reading.problems.empty()) {
        warnings.push_back(
            unusable_language(file, each, "with " + name + " the protocol has", reading.problems));
        continue;
      }
      const Plan example = example_plan(*reading.protocol, {1, 0});
      for (Diagnostic& warning : warnings_about_texts(*reading.protocol, file, example)) {
        warning.message = name + ": " + warning.message;
        warnings.push_back(std::move(warning));
      }
    } catch (const ProtocolError& error) {
      warnings.push_back(unusable_language(file, each, name + " has", error.diagnostics()));
    }
  }
  return warnings;
}

/// For a protocol with other problems: the problems of files that are named in valid places.
void add_problems_of_files(const ProtocolReading& reading, const std::filesystem::path& study,
                           const ModelRegistry& models, ProtocolCheck& check) {
  StimulusBuilder builder(models, study);
  const auto is_looked_at = [&reading](const Diagnostic& place) {
    return !may_follow_from(reading.repair, place.pointer, {}) &&
           std::none_of(
               reading.problems.begin(), reading.problems.end(),
               [&place](const Diagnostic& problem) { return problem.pointer == place.pointer; });
  };
  append(check.diagnostics,
         problems_of_named_files(*reading.protocol, check.file, study, builder, is_looked_at));
}

}  // namespace

ProtocolCheck check_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                             const std::optional<std::filesystem::path>& study,
                             const std::optional<std::string>& device) {
  const std::string found = found_protocol(file, study).string();
  ProtocolCheck check{};
  try {
    const ProtocolSource source = protocol_source(found);
    check = check_protocol_text(source.text, source.file.string(), models, study, device);
    append(check.warnings, source.warnings);
    // Problems of the protocol itself would be those of every translation.
    if (found == source.file && check.is_valid()) {
      append(check.warnings, warnings_about_translations(found, models));
    }
  } catch (const ProtocolError& error) {
    check.diagnostics = error.diagnostics();
  } catch (const std::exception& error) {
    check.diagnostics.push_back({found, 0, 0, "", message_of(error)});
  }
  check.file = found;
  return check;
}

ProtocolCheck check_protocol_text(const std::string& text, const std::string& file_name,
                                  const ModelRegistry& models,
                                  const std::optional<std::filesystem::path>& study,
                                  const std::optional<std::string>& device) {
  ProtocolCheck check{};
  check.file = file_name;
  const auto whole_file = [&check](const std::string& message) {
    check.diagnostics.push_back({check.file, 1, 1, "", message});
  };
  ProtocolReading reading{};
  try {
    reading = read_protocol_with_problems(text, file_name, declarations_of(models));
    if (reading.has_form) check.warnings = warnings_about(*reading.protocol, file_name);
  } catch (const std::exception& error) {
    whole_file(message_of(error));
    return check;
  }
  check.diagnostics = reading.problems;
  if (!reading.problems.empty()) {
    if (study && reading.protocol) add_problems_of_files(reading, *study, models, check);
    sort_by_line(check.diagnostics);
    return check;
  }
  check.protocol = std::move(reading.protocol);
  const CheckedProtocol checked(*check.protocol, check.file);
  if (study) {
    StimulusBuilder builder(models, *study);
    check.diagnostics = problems_of_files(checked, *study, builder);
    if (check.diagnostics.empty()) check.diagnostics = problems_of_scaled_heights(checked, builder);
  }
  append(check.diagnostics, problems_of_values(*check.protocol, check.file));
  sort_by_line(check.diagnostics);
  // A real device is not opened: it may be on another machine.
  if (device) {
    if (const std::optional<SimulatedDeviceSettings> settings = simulated_settings(*device)) {
      VirtualHand hand(HandHabits{}, Random(0));
      const SimulatedDevice simulated(hand, *settings);
      for (const Phrase& complaint :
           complaints_about_device(*check.protocol, simulated.capability())) {
        whole_file(complaint.english() +
                   "; choose another device, or relax the requirement in the protocol");
      }
    }
  }
  const Plan example = example_plan(*check.protocol, {1, 0});
  check.cost = cost_of(*check.protocol, example);
  append(check.warnings, warnings_about_plan(*check.protocol, check.file, example));
  append(check.warnings, warnings_about_texts(*check.protocol, check.file, example));
  append(check.warnings, warnings_about_analysis(*check.protocol, check.file));
  append(check.warnings, warnings_about_design(*check.protocol, check.file));
  for (const auto& [name, block] : check.protocol->blocks) {
    if (block.phase != Phase::main) continue;
    if (std::string design = design_of(*check.protocol, block, example); !design.empty()) {
      check.designs.emplace(name, std::move(design));
    }
  }
  return check;
}

std::optional<VersionUse> other_text_of_version(const Study& study, const std::string& text,
                                                SessionsOf counted) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return {};
  const auto said = [&json](const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string{};
  };
  const std::string name = said("name");
  VersionUse use{said("version"), 0};
  if (name.empty() || use.version.empty()) return {};
  std::set<std::int64_t> others{};
  for (const ProtocolRow& row : study.protocols()) {
    if (row.name == name && row.version == use.version && row.source != text &&
        count_protocols({row.source, text}) > 1) {
      others.insert(row.id);
    }
  }
  for (const SessionRow& session : study.sessions()) {
    const bool is_counted =
        counted == SessionsOf::everybody || session.mode != SessionMode::simulate;
    if (is_counted && others.contains(session.protocol_id)) ++use.sessions;
  }
  if (use.sessions == 0) return {};
  return use;
}

std::optional<Diagnostic> warning_about_version(const Protocol& protocol,
                                                const std::string& file_name, const Study& study) {
  const auto use = other_text_of_version(study, protocol.source, SessionsOf::everybody);
  if (!use) return {};
  const std::string sessions =
      use->sessions == 1 ? "1 session" : std::to_string(use->sessions) + " sessions";
  return JsonDocument(protocol.source, file_name)
      .at_key("/version", "the study has " + sessions + " of " + protocol.name + ' ' +
                              use->version +
                              " with another text of the protocol; their responses would be "
                              "analysed together with new ones, and only protocol_sha256 in the "
                              "tables of an export would distinguish them; raise \"version\"");
}

std::vector<Diagnostic> warnings_about_sessions(const CheckedProtocol& checked, const Study& study,
                                                const ModelRegistry& models) {
  std::vector<Diagnostic> warnings = warnings_about_plugins(checked, study, models, std::nullopt);
  if (auto warning = warning_about_version(checked.protocol, checked.file_name, study)) {
    warnings.insert(warnings.begin(), std::move(*warning));
  }
  return warnings;
}

std::vector<Diagnostic> warnings_about_sessions(const CheckedProtocol& checked,
                                                const std::filesystem::path& study,
                                                const ModelRegistry& models) {
  try {
    if (!Study::exists(study)) return {};
    return warnings_about_sessions(checked, Study::open(study, Access::read_only), models);
  } catch (const std::exception& error) {
    return {JsonDocument(checked.protocol.source, checked.file_name)
                .at_key("/version",
                        "whether the study has sessions with another text of this version, or with "
                        "another build of a plug-in, could not be determined: " +
                            message_of(error))};
  }
}

std::vector<Phrase> complaints_about_device(const Protocol& protocol,
                                            const DeviceCapability& device) {
  std::vector<Phrase> complaints{};
  // A device without motors gives no force, regardless of the protocol: the user has chosen it
  // knowingly.
  const bool has_motors = device.actuated_degrees_of_freedom > 0;
  if (has_motors && protocol.force_limit_N > device.peak_force_N) {
    complaints.push_back(phrase("ProtocolFiles",
                                "the protocol's force_limit_N of %1 N exceeds the peak force of "
                                "the device \"%2\", %3 N")
                             .with(text_of_number(protocol.force_limit_N), called(device),
                                   text_of_number(device.peak_force_N)));
  }
  if (protocol.rate_Hz > device.maximum_rate_Hz) {
    complaints.push_back(
        phrase(
            "ProtocolFiles",
            "the protocol's rate_Hz of %1 Hz exceeds the highest rate of the device \"%2\", %3 Hz")
            .with(text_of_number(protocol.rate_Hz), called(device),
                  text_of_number(device.maximum_rate_Hz)));
  }
  return complaints;
}

std::optional<Phrase> complaint_about_label(const std::string& label, bool is_virtual) {
  const bool characters = std::all_of(label.begin(), label.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  });
  if (characters && !label.empty() && label.size() <= 32) {
    if (is_virtual || !label.starts_with("virtual")) return {};
    return phrase("ProtocolFiles",
                  "the participant label \"%1\" is not acceptable for a human participant: labels "
                  "that begin with \"virtual\" are reserved for virtual participants; use another "
                  "label")
        .with(label);
  }
  return phrase("ProtocolFiles",
                "the participant label \"%1\" is not acceptable: it must consist of 1 to 32 "
                "letters and digits (0-9, A-Z, a-z)")
      .with(label);
}

}  // namespace asperity
