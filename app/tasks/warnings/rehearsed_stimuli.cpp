// Strokes each surface with a simulated hand until it touches it, and counts the assumptions that it violates.

#include "app/tasks/warnings/rehearsed_stimuli.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/random.h"
#include "app/session/attempt_measures.h"
#include "app/session/trial_attempt.h"
#include "app/study_files/parameter_json.h"
#include "app/words/phrase_of_error.h"
#include "device/simulated_device.h"
#include "protocols/design/wording.h"
#include "protocols/plan/course.h"
#include "renderers/pd_gradient/geometry/finest_wave.h"
#include "renderers/servo/contact.h"

namespace asperity {

namespace {

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

Phrase in_mm(double from_m, double to_m) {
  return phrase("Protocols", "%1 to %2 mm").with(fixed(1e3 * from_m, 1), fixed(1e3 * to_m, 1));
}

/// The positions of the strokes and of the surface, and the correction.
Phrase never_touched(const StimulusDescription& stimulus, const TexturedMesh& surface,
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
  std::string surface_name = in_quotes(stimulus.surface->name);
  if (stimulus.surface->mesh) surface_name += " (" + *stimulus.surface->mesh + ')';
  const Phrase of_tool =
      touch == FirstTouch::never
          ? phrase("Protocols", "no part of the surface %1 lies under the path of the tool %2")
          : phrase("Protocols", "the tool %2 begins inside the surface %1 and never leaves it");
  const Phrase of_hand =
      touch == FirstTouch::never
          ? phrase("Protocols", "no part of the surface %1 lies under the path of the hand")
          : phrase("Protocols", "the hand begins inside the surface %1 and never leaves it");
  const Phrase problem = stimulus.tool ? of_tool.with(surface_name, in_quotes(stimulus.tool->name))
                                       : of_hand.with(surface_name);
  Phrase to_bake{};
  const double off_m = 0.01 * (high_m.z - low_m.z);
  if (stimulus.surface->mesh && std::abs(high_m.z) > off_m) {
    to_bake = std::abs(low_m.z) <= off_m
                  ? phrase("Protocols",
                           "; its lowest point lies in that plane, as after `asperity bake --for "
                           "tool`: bake it again with `--for surface`")
                  : phrase("Protocols",
                           "; the highest point of a surface must lie in that plane: bake it "
                           "again with `--for surface`");
  }
  const auto ends_before = [&](const glm::dvec2& place_m) {
    return place_m.x < low_m.x || place_m.x > high_m.x || place_m.y < low_m.y ||
           place_m.y > high_m.y;
  };
  Phrase to_shorten{};
  if (ends_before(end_m) || ends_before(-end_m)) {
    to_shorten = phrase("Protocols",
                        "; the strokes extend beyond the surface: make the surface longer, or "
                        "reduce %1 of the exploration")
                     .with(key_name("stroke_length_m"));
  }
  return phrase("Protocols",
                "%1: strokes begin in the plane z = 0, %2 mm from the middle, and the surface lies "
                "at x %3, y %4, z %5%6%7")
      .with(problem, fixed(0.5e3 * habits.stroke_length_m, 1), in_mm(low_m.x, high_m.x),
            in_mm(low_m.y, high_m.y), in_mm(low_m.z, high_m.z), to_bake, to_shorten);
}

std::string micrometres_text(double length_m) {
  constexpr double kMicrometres_per_m = 1e6;
  return fixed(kMicrometres_per_m * length_m, 0);
}

/// To whole micrometres: a cell of this width contains the waves from which it was computed.
double rounded_down_m(double cell_m) {
  constexpr double kMicrometre_m = 1e-6;
  return cell_m > kMicrometre_m ? kMicrometre_m * std::floor(cell_m / kMicrometre_m) : cell_m;
}

/// Both numbers of a texture that is finer than the samples of a contact, and the correction;
/// nothing where the cause is a different one, such as a contact that is too wide.
Phrase why_too_fine(const PreparedStimulus& stimulus) {
  constexpr double kSamplesPerWave = 8.0;  // as in pd_gradient
  const ParameterValues& own = stimulus.inputs.parameters;
  const double finest_m =
      std::min(finest_wave_m(*stimulus.inputs.tool, number_of(own, "tool_texture_gain")),
               finest_wave_m(*stimulus.inputs.surface, number_of(own, "texture_gain")));
  const double cell_m = number_of(own, "cell_m");
  if (!(kSamplesPerWave * cell_m > finest_m)) return {};
  return phrase("Protocols",
                ": its shortest wavelength is %1 µm, and samples of %2 µm (cell_m) represent "
                "wavelengths of %3 µm and longer; use a texture without shorter wavelengths, or a "
                "cell_m of %4 µm or less, which takes longer to render. A step at the seam of a "
                "repeated tile counts as the shortest wavelength")
      .with(micrometres_text(finest_m), micrometres_text(cell_m),
            micrometres_text(kSamplesPerWave * cell_m),
            micrometres_text(rounded_down_m(finest_m / kSamplesPerWave)));
}

struct LimitBeyond {
  std::string limit{};
  Phrase sentence{};
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
    Phrase with_texture{};
    if (!described.texture.empty()) {
      std::string texture = in_quotes(described.texture);
      if (described.height_field) texture += " (" + *described.height_field + ')';
      with_texture = phrase("Protocols", " with the texture %1").with(texture);
    }
    Phrase under_tool{};
    if (described.tool) {
      under_tool = phrase("Protocols", " under the tool %1").with(in_quotes(described.tool->name));
    }
    const std::string limit(count.name);
    const bool has_bodies = stimulus.inputs.tool && stimulus.inputs.surface;
    Phrase correction = limit == "fine_detail" && has_bodies ? why_too_fine(stimulus) : Phrase();
    if (correction.empty()) {
      correction = phrase("Protocols", " (see \"Counted conditions\" in docs/models/%1.md)")
                       .with(described.model);
    }
    const Phrase sentence =
        phrase("Protocols",
               "the stimulus %1%2%3 violates the assumption %4 of %5 (ticks of contact: %6 of "
               "%7); where it does, its force differs from the declared force%8");
    warnings.push_back(
        {.limit = limit,
         .sentence = sentence.with(in_quotes(described.name), with_texture, under_tool, limit,
                                   described.model, std::to_string(count.ticks),
                                   std::to_string(contact), correction)});
  }
  return warnings;
}

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
      found.problems.push_back(checked.cannot_be_rendered(planned, phrase_of(error)));
    }
  }
  return found;
}

}  // namespace

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

std::vector<Diagnostic> rehearse(const CheckedProtocol& checked, StimulusBuilder& builder) {
  return rehearsed_stimuli(checked, builder, 0.0, {}).problems;
}

RehearsedStimuli rehearse_with_warnings(const CheckedProtocol& checked, StimulusBuilder& builder,
                                        const std::stop_token& stop) {
  constexpr double kWatched_s = 0.02;
  return rehearsed_stimuli(checked, builder, kWatched_s, stop);
}

}  // namespace asperity
