// Declares the columns of presentations.tsv from the plan and the stored rows, with counts of limits.

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/numbers/unit_of_name.h"
#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"
#include "app/words/text_parts.h"
#include "protocols/design/roughness_match.h"

namespace asperity::export_columns {
namespace {

using Place = ExportPlace;

/// The presentation in the plan; null where there is none.
const nlohmann::json* planned_presentation(const Place& at) {
  const auto planned = at.plan->find("presentations");
  if (planned == at.plan->end()) return nullptr;
  for (const nlohmann::json& presentation : *planned) {
    if (presentation.value("position", 0) == at.presentation->position) return &presentation;
  }
  return nullptr;
}

Cell planned_member(const Place& at, const std::string& name) {
  const nlohmann::json* const planned = planned_presentation(at);
  return planned == nullptr ? Cell{} : member_of(planned, name);
}

/// The place of the texture in the plan, in one of its two directions.
Cell texture_origin_m(const Place& at, std::size_t direction) {
  const nlohmann::json* const planned = planned_presentation(at);
  if (planned == nullptr || !planned->contains("patch")) return {};
  return planned->at("patch").at("texture_origin_m").at(direction).get<double>();
}

std::vector<std::string> names_of_match_statuses() {
  std::vector<std::string> names{};
  for (const MatchStatus status : match_statuses()) names.emplace_back(text_of(status));
  return names;
}

std::map<std::string, LevelMeaning> meanings_of_match_statuses() {
  std::map<std::string, LevelMeaning> meanings{};
  for (const MatchStatus status : match_statuses()) {
    meanings[std::string(text_of(status))].description = meaning_of(status);
  }
  return meanings;
}

/// The relative amplitude of the surface, and how it was determined.
void add_equal_roughness(Columns& columns) {
  columns.push_back(missing(
      "the block neither varies the relative amplitude of this surface nor presents surfaces of "
      "equal "
      "roughness",
      at_least(0,
               column("relative_amplitude", "number", "1",
                      "factor by which the amplitude parameter was multiplied",
                      [](const Place& at) { return planned_member(at, "relative_amplitude"); }))));
  columns.push_back(missing(
      "the block does not present surfaces of equal roughness",
      with_levels(column("roughness_match", "text", "",
                         "how the relative amplitude of equal roughness was determined",
                         [](const Place& at) { return planned_member(at, "roughness_match"); }),
                  names_of_match_statuses())));
  columns.back().level_meanings = meanings_of_match_statuses();
}

/// From the last contact with any surface of the attempt to the onset of this one.
Cell interval_before(const Place& at) {
  if (!at.presentation->onset_ns) return {};
  std::optional<std::int64_t> lifted_ns{};
  for (const PresentationRow& other : at.attempt->presentations) {
    for (const VisitRow& visit : other.visits) {
      if (visit.offset_ns >= *at.presentation->onset_ns) continue;
      lifted_ns = std::max(lifted_ns.value_or(visit.offset_ns), visit.offset_ns);
    }
  }
  if (!lifted_ns) return {};
  return static_cast<double>(*at.presentation->onset_ns - *lifted_ns) / 1e9;
}

// Counts of every plug-in (renderers/plugin/plugin_model.h), all others of models with their own assumptions.
constexpr const char* kLimitsOfPlugins = "plugin_";

bool is_of_plugins(const std::string& limit) { return limit.starts_with(kLimitsOfPlugins); }

std::string meaning_of_limit(const std::string& limit) {
  if (limit == "plugin_error") {
    return "ticks without a force because the plug-in of the force model reported an error or "
           "threw "
           "an exception (docs/write-a-force-model.md)";
  }
  if (limit == "plugin_not_valid") {
    return "ticks without a force because a result of the plug-in of the force model was not "
           "finite, "
           "or its normal force or penetration negative (docs/write-a-force-model.md)";
  }
  return "ticks in which this assumption of the force model was violated "
         "(\"Counted conditions\" of its page in docs/models)";
}

}  // namespace

Columns presentation_columns(const StudyVocabulary& vocabulary) {
  Columns columns = keys_to(Key::attempt);
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  const auto text = [&add](const char* name, const char* description, auto member) {
    add(column(name, "text", "", description,
               [member](const Place& at) { return at.presentation->*member; }));
  };
  add(at_least(1, column("position", "integer", "", "place in the order of the trial's surfaces",
                         [](const Place& at) { return integer(at.presentation->position); })));
  text("role", "role of the surface in the trial", &PresentationRow::role);
  columns.back().levels = {"alternative", "target", "anchor", "standard", "comparison"};
  text("item", "name of the surface in the responses", &PresentationRow::item);
  text("stimulus", "stimulus of the protocol", &PresentationRow::stimulus);
  text("model", "force model", &PresentationRow::model);
  text("model_version", "version of the force model", &PresentationRow::model_version);
  add(missing("no texture is involved",
              column("texture", "text", "", "texture of the protocol", [](const Place& at) -> Cell {
                const std::string& texture = at.presentation->texture;
                return texture.empty() ? Cell{} : Cell{texture};
              })));
  const auto sha256 = [&add](const std::string& role, const std::string& description,
                             const std::string& when_missing) {
    add(missing(when_missing,
                column(role + "_sha256", "text", "", description, [role](const Place& at) {
                  return optional_cell(asset_sha256(at.presentation->assets, role));
                })));
  };
  sha256("height_field",
         "SHA-256 of the height field's sidecar; the sidecar contains the SHA-256 of its picture",
         "no height field is involved");
  sha256("surface", "SHA-256 of the body that was touched (docs/formats/study.md)",
         "the surface is a plane");
  sha256("tool", "SHA-256 of the body that was held (docs/formats/study.md)",
         "the tool of the model is a point");
  for (const auto& [role, models] : vocabulary.assets) {
    if (role == kPluginRole) {
      sha256(role, "SHA-256 of the plug-in of the force model", "the force model is built in");
      columns.back().publication = Publication::dropped_with_new_labels;  // it may be built anew
      continue;
    }
    sha256(role, "SHA-256 of a file that the force model needs; models: " + comma_separated(models),
           "the model does not need this file");
  }
  const auto number = [&add](const char* name, const char* unit, const char* description,
                             double PresentationRow::*member) {
    add(column(name, "number", unit, description,
               [member](const Place& at) { return at.presentation->*member; }));
  };
  number("stiffness_N_per_m", "N/m", "stiffness of the surface without its texture",
         &PresentationRow::stiffness_N_per_m);
  number("friction", "1", "Coulomb friction coefficient of the surface",
         &PresentationRow::friction);
  number("raised_m", "m", "height of the plane of the surface above that of the workspace",
         &PresentationRow::raised_m);
  text("seed", "seed of the renderer, a 64-bit integer", &PresentationRow::seed);
  columns.back().publication = Publication::dropped_with_new_labels;  // follows from the session's
  const auto time = [&add](const char* name, const char* description, const char* when,
                           auto member) {
    add(missing(when, column(name, "number", "s", description, [member](const Place& at) {
                  return seconds_in_session(at, at.presentation->*member);
                })));
  };
  time("onset_s", "time of the first tick with the surface present, since the session began",
       "the surface was not presented", &PresentationRow::onset_ns);
  time("contact_onset_s",
       "time of the first tick with the probe in the surface, since the session began",
       "the surface was not touched", &PresentationRow::contact_ns);
  time("offset_s", "time of the last tick with the surface present, since the session began",
       "the surface was not presented", &PresentationRow::offset_ns);
  add(at_least(0, column("contact_s", "number", "s", "time in contact",
                         [](const Place& at) { return at.presentation->contact_s; })));
  add(at_least(
      0, column("gaps_in_contact", "integer", "1",
                "times between two ticks of more than two periods while this surface was touched",
                [](const Place& at) { return integer(at.presentation->gaps_in_contact); })));
  add(missing("the stimulus has no equal_force",
              at_least(0, column("matched_texture_force_N", "number", "N",
                                 "intended RMS of the texture force on the prescribed path",
                                 [](const Place& at) {
                                   return optional_cell(at.presentation->matched_texture_force_N);
                                 }))));
  add(missing("the surface was not in contact for long enough",
              at_least(0, column("achieved_texture_force_N", "number", "N",
                                 "RMS of the texture force along the participant's own path",
                                 [](const Place& at) {
                                   return optional_cell(at.presentation->achieved_texture_force_N);
                                 }))));
  add_equal_roughness(columns);
  add_instability(columns);
  for (const auto& [kind, models] : vocabulary.limits) {
    add(missing(is_of_plugins(kind) ? "the force model is not a plug-in"
                                    : "the model does not check this assumption",
                at_least(0, column("limit_" + kind + "_ticks", "integer", "1",
                                   meaning_of_limit(kind) + "; models: " + comma_separated(models),
                                   [kind = kind](const Place& at) -> Cell {
                                     for (const ModelLimitRow& limit : at.presentation->limits) {
                                       if (limit.kind == kind) return limit.ticks;
                                     }
                                     return {};
                                   }))));
  }
  for (const auto& [name, parameter] : vocabulary.parameters) {
    const std::string of = comma_separated(parameter.models);
    const bool numeric = parameter.levels.empty();
    std::string meaning{};
    for (const std::string& each : parameter.meanings) meaning += each + "; ";
    ExportColumn made =
        missing("the model does not have this parameter",
                column("parameter_" + name, numeric ? "number" : "text",
                       numeric ? parameter.unit.value_or(unit_in_files(name)) : "",
                       meaning + "parameter of the force model as rendered; models: " + of,
                       [name = name](const Place& at) { return member_of(at.parameters, name); }));
    made.source = parameter.meanings.empty() ? "parameters as rendered" : "force model";
    made.minimum = parameter.minimum;
    made.maximum = parameter.maximum;
    made.levels.assign(parameter.levels.begin(), parameter.levels.end());
    columns.push_back(std::move(made));
  }
  for (const auto& [name, direction] :
       {std::pair{"texture_origin_x_m", std::size_t{0}}, {"texture_origin_y_m", std::size_t{1}}}) {
    add(missing(
        "the surface fills the workspace, and its place on the texture is that of the "
        "protocol",
        column(
            name, "number", "m",
            "point of the texture at the centre of the surface, as planned; if the phase is drawn, "
            "the point drawn for the presentation",
            [direction = direction](const Place& at) { return texture_origin_m(at, direction); })));
  }
  add(missing("no surface was touched before in the attempt",
              at_least(0, column("interval_s", "number", "s",
                                 "inter-stimulus interval: time from the last contact with a "
                                 "surface of the attempt to the onset of this one",
                                 interval_before))));
  return columns;
}

}  // namespace asperity::export_columns
