// Implements the checks of head, textures, factors, explorations and questions.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "protocols/file/device_limit.h"
#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/keys/conditions.h"
#include "protocols/keys/form_sentences.h"
#include "stimuli/properties/other_unit.h"

namespace asperity {

namespace {

/// The problem with the form of a HED string; empty if there is none.
Phrase hed_problem(const std::string& tags) {
  int depth = 0;
  bool wants_tag = true;  // at the beginning, after a comma and after an opening parenthesis
  for (const char letter : tags) {
    if (letter == ' ') continue;
    if (std::string_view("[]{}~\"\n\t").find(letter) != std::string_view::npos) {
      return letter < ' ' ? phrase("Protocols", "a HED tag cannot contain line breaks")
                          : phrase("Protocols", "a HED tag cannot contain %1")
                                .with(in_quotes(std::string(1, letter)));
    }
    if (letter == ',' || letter == ')') {
      if (wants_tag) {
        return phrase("Protocols", "a HED tag is missing before %1")
            .with(in_quotes(std::string(1, letter)));
      }
      if (letter == ')' && --depth < 0)
        return phrase("Protocols", "a closing parenthesis has no opening one");
      wants_tag = letter == ',';
    } else {
      wants_tag = letter == '(';
      if (wants_tag) ++depth;
    }
  }
  if (depth > 0) return phrase("Protocols", "an opening parenthesis has no closing one");
  return wants_tag ? phrase("Protocols", "a HED tag is missing at the end") : Phrase();
}

/// Numbers are compared by value, independent of notation.
bool is_name_of(const Level& level, const std::string& name) {
  const double* const number = std::get_if<double>(&level);
  if (number == nullptr) return std::get<std::string>(level) == name;
  double named = 0.0;
  const char* const end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data(), end, named);
  return error == std::errc() && rest == end && named == *number;
}

/// The existence of tags is not checked: HED's vocabulary has thousands of them and its own validator.
void check_hed(CheckedDocument& checked, const Factor& factor) {
  const auto& declared = checked.document.root().at("factors").at(factor.name);
  const auto hed = declared.find("hed");
  if (hed == declared.end()) return;
  std::vector<std::string> names{};
  for (const Level& level : factor.levels) names.push_back(text_of(level));
  for (const auto& [name, tags] : hed->items()) {
    const std::string pointer = pointer_to(pointer_to("/factors", factor.name) + "/hed", name);
    const bool is_level =
        std::any_of(factor.levels.begin(), factor.levels.end(),
                    [&name = name](const Level& level) { return is_name_of(level, name); });
    if (!is_level) {
      checked.report_key(
          pointer, with_guess(phrase("Protocols", "%1 is not a level of the factor %2; use %3")
                                  .with(in_quotes(name), in_quotes(factor.name),
                                        joined_by_or(quoted(names))),
                              name, names));
    }
    const Phrase problem = hed_problem(tags.get<std::string>());
    if (problem.empty()) continue;
    checked.report(pointer,
                   phrase("Protocols",
                          "%1; separate HED tags by commas and group them by parentheses, such as "
                          "%2")
                       .with(problem, in_quotes("Sensory-event, (Rough, Large)")));
  }
}

void check_band(CheckedDocument& checked, const Band& band, const std::string& pointer) {
  const auto ordered = [](const std::optional<double>& a, const std::optional<double>& b) {
    return !a || !b || *a <= *b;
  };
  if (!ordered(band.minimum, band.target) || !ordered(band.target, band.maximum) ||
      !ordered(band.minimum, band.maximum)) {
    checked.report(pointer,
                   phrase("Protocols", "a band must be ascending: minimum ≤ target ≤ maximum"));
  }
}

/// Checks that there is guidance to show and that the participant can perceive it.
void check_guidance(CheckedDocument& checked, const Exploration& exploration,
                    const std::string& pointer) {
  using Guidance = Exploration::Guidance;
  if (exploration.guidance == Guidance::experimenter) return;
  const std::string place = pointer + "/guidance";
  if (checked.protocol.vision == Vision::blindfold && exploration.guidance != Guidance::tones) {
    checked.report(place,
                   phrase("Protocols",
                          "a blindfolded participant sees neither bars nor a target; choose %1 or "
                          "%2, or another %3")
                       .with(word_name("tones"), word_name("experimenter"), key_name("vision")));
  }
  const auto bounded = [](const Band& band) { return band.minimum || band.maximum; };
  if (exploration.guidance != Guidance::moving_target && !bounded(exploration.normal_force_N) &&
      !bounded(exploration.speed_m_per_s)) {
    checked.report(
        place,
        phrase("Protocols", "there is no band to indicate: give %1 or %2 a minimum or a maximum")
            .with(key_name("normal_force_N"), key_name("speed_m_per_s")));
  }
  if (exploration.guidance == Guidance::moving_target) {
    const auto positive = [](const Band& band) { return band.target.value_or(0.0) > 0.0; };
    if (!positive(exploration.speed_m_per_s) || !positive(exploration.stroke_length_m)) {
      checked.report(
          place,
          phrase("Protocols",
                 "a moving target needs a speed and a length: give %1 and %2 a target above 0")
              .with(key_name("speed_m_per_s"), key_name("stroke_length_m")));
    }
  }
}

}  // namespace

void check_applicability(CheckedDocument& checked) {
  for (const InapplicableKey& key : inapplicable_keys(checked.document.root())) {
    if (key.is_permitted) continue;
    if (key.condition->of != KeyCondition::Of::kind) {
      checked.report_key(key.pointer, inapplicable_key(*key.condition));
      continue;
    }
    std::vector<Phrase> owners{};
    std::vector<std::string> ids{};
    for (const std::string_view kind : key.condition->values()) {
      owners.push_back(phrase("Protocols", "a %1").with(kind_named(kind).name));
      ids.emplace_back(kind);
    }
    // A question that needs another kind needs another experiment.
    const bool is_of_question = key.pointer.find("/question") != std::string::npos;
    checked.report_key(
        key.pointer,
        (is_of_question ? phrase("Protocols", "only %1 has this key; remove it")
                        : phrase("Protocols", "only %1 has this key; remove it, or set %2 to %3"))
            .with(joined_by_or(owners), key_name("kind"), joined_by_or(quoted(ids))));
  }
}

void check_head(CheckedDocument& checked) {
  for (const ExperimentKind* const kind : checked.kinds) {
    for (const RequiredKey& key : kind->required) {
      if (!checked.document.root().contains(key.name)) checked.report("/kind", key.if_missing);
    }
  }
  const auto& patch = checked.protocol.patch;
  if (2.0 * patch.edge_width_m >= std::min(patch.extent_m.x, patch.extent_m.y)) {
    checked.report("/surface/edge_width_m",
                   phrase("Protocols",
                          "edges of %1 m on both sides cover the whole patch of %2 m by %3 m; "
                          "reduce %4 or enlarge the patch")
                       .with(digits(patch.edge_width_m), digits(patch.extent_m.x),
                             digits(patch.extent_m.y), key_name("edge_width_m")));
  }
}

void check_instability(CheckedDocument& checked) {
  // Vibration is judged from 150 Hz to half the rate.
  constexpr double kLowestRate_Hz = 300.0;
  if (!checked.protocol.instability || checked.protocol.rate_Hz > kLowestRate_Hz) return;
  checked.report("/instability",
                 phrase("Protocols",
                        "vibration above 150 Hz cannot be judged at a servo rate of %1 Hz: set "
                        "%2 above 300, or remove this key")
                     .with(digits(checked.protocol.rate_Hz), place_name("/device/rate_Hz")));
}

void check_device_limits(CheckedDocument& checked) {
  const auto rate_Hz = checked.protocol.device_limits.find("rate_Hz");
  if (rate_Hz == checked.protocol.device_limits.end()) return;
  if (const auto complaint =
          complaint_about_rate_limit(rate_Hz->second, checked.protocol.rate_Hz)) {
    checked.report("/device/limits/rate_Hz", *complaint);
  }
}

std::optional<Phrase> complaint_about_path(const std::string& text) {
  const auto refuse = [&](const Phrase& why) {
    return phrase("Protocols", "%1; name a file inside the study, such as %2")
        .with(why.with(in_quotes(text)), in_quotes("stimuli/metal.png"));
  };
  if (text.starts_with('/') || text.starts_with('~') || (text.size() > 1 && text[1] == ':')) {
    return refuse(phrase("Protocols", "%1 is not a path relative to the study"));
  }
  for (const char c : text) {
    if (c == '\\' || static_cast<unsigned char>(c) < 0x20) {
      return refuse(phrase("Protocols", "%1 contains a backslash or a control character"));
    }
  }
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t end = std::min(text.find('/', from), text.size());
    const std::string_view part = std::string_view(text).substr(from, end - from);
    if (part == "..") return refuse(phrase("Protocols", "%1 points outside the study"));
    if (part.empty() || part == ".") return refuse(phrase("Protocols", "%1 has an empty part"));
    from = end + 1;
  }
  return {};
}

void check_path(CheckedDocument& checked, const std::optional<std::string>& path,
                const std::string& pointer) {
  if (!path) return;
  if (const auto complaint = complaint_about_path(*path)) checked.report(pointer, *complaint);
}

void check_textures(CheckedDocument& checked) {
  std::map<std::string, std::string> codes{};
  std::map<std::string, std::string> roles{};  // those that force models declare → a model
  for (const auto& [id, model] : checked.models) {
    for (const AssetDeclaration& asset : model->assets) roles.emplace(asset.role, id);
  }
  for (const auto& [name, texture] : checked.protocol.textures) {
    const std::string pointer = pointer_to("/textures", name);
    check_path(checked, texture.height_field, pointer + "/height_field");
    check_path(checked, texture.picture, pointer + "/picture");
    check_path(checked, texture.true_height_field, pointer + "/true_height_field");
    for (const auto& [role, path] : texture.assets) {
      const std::string place = pointer_to(pointer + "/assets", role);
      check_path(checked, path, place);
      if (!roles.contains(role))
        checked.report_key(place, unknown_name("role of an asset", role, roles));
    }
    if (!texture.height_field && !texture.picture && texture.assets.empty()) {
      checked.report(pointer,
                     phrase("Protocols",
                            "this texture can be neither felt nor seen: give it a %1, a %2 or both")
                         .with(key_name("height_field"), key_name("picture")));
    }
    if (texture.code.empty()) continue;
    const auto [other, is_new] = codes.emplace(texture.code, name);
    if (!is_new) {
      checked.report(
          pointer + "/code",
          phrase("Protocols", "the code %1 is also that of %2; give each texture its own code")
              .with(in_quotes(texture.code), in_quotes(other->second)));
    }
  }
}

void check_factors(CheckedDocument& checked) {
  const auto declared = checked.document.root().find("factors");
  for (const auto& [name, factor] : checked.protocol.factors) {
    // The factor of a varied parameter is declared by its block.
    if (declared == checked.document.root().end() || !declared->contains(name)) continue;
    const std::string pointer = pointer_to("/factors", name) + "/levels";
    for (std::size_t i = 0; i < factor.levels.size(); ++i) {
      const Level& level = factor.levels[i];
      if (level.index() != factor.levels.front().index()) {
        checked.report(
            pointer_to(pointer, i),
            phrase("Protocols",
                   "the levels of a factor must be all numbers or all names; write this level in "
                   "the form of the first one"));
      } else if (std::find(factor.levels.begin(),
                           factor.levels.begin() + static_cast<std::ptrdiff_t>(i),
                           level) != factor.levels.begin() + static_cast<std::ptrdiff_t>(i)) {
        checked.report(pointer_to(pointer, i),
                       phrase("Protocols", "%1 is listed twice; list it once")
                           .with(in_quotes(text_of(level))));
      } else if (std::holds_alternative<std::string>(level) && text_of(level).empty()) {
        checked.report(pointer_to(pointer, i),
                       phrase("Protocols", "a level cannot be empty; give it a name"));
      }
    }
    check_hed(checked, factor);
  }
}

void check_explorations(CheckedDocument& checked) {
  for (const auto& [name, exploration] : checked.protocol.explorations) {
    const std::string pointer = pointer_to("/explorations", name);
    check_band(checked, exploration.speed_m_per_s, pointer + "/speed_m_per_s");
    check_band(checked, exploration.strokes, pointer + "/strokes");
    check_guidance(checked, exploration, pointer);
    const auto is_weak_enough = [&](double force_N) {
      return force_N <= checked.protocol.force_limit_N;
    };
    const auto too_strong = [&](const std::optional<double>& force_N, const char* key) {
      if (!force_N || is_weak_enough(*force_N)) return false;
      checked.report(pointer + "/normal_force_N/" + key,
                     phrase("Protocols",
                            "the band reaches %1 N, but the force limit is %2 N "
                            "(%3); lower the force or raise the limit%4")
                         .with(digits(*force_N), digits(checked.protocol.force_limit_N),
                               place_name("/device/force_limit_N"),
                               meant_in_other_unit(*force_N, "N", is_weak_enough)));
      return true;
    };
    const Band& force = exploration.normal_force_N;
    const std::array strong{too_strong(force.minimum, "minimum"),
                            too_strong(force.target, "target"),
                            too_strong(force.maximum, "maximum")};
    // A value in another unit is out of order as well, which would be a second error.
    if (strong == std::array{false, false, false})
      check_band(checked, force, pointer + "/normal_force_N");
    const auto& patch = checked.protocol.patch;
    const double along_x = std::abs(std::cos(exploration.direction_rad));
    const double along_y = std::abs(std::sin(exploration.direction_rad));
    const auto is_short_enough = [&](double length_m) {
      constexpr double kRounding_m = 1e-9;
      return length_m * along_x <= patch.extent_m.x + kRounding_m &&
             length_m * along_y <= patch.extent_m.y + kRounding_m;
    };
    const auto too_long = [&](const std::optional<double>& length_m, const char* key) {
      if (!length_m || is_short_enough(*length_m)) return false;
      checked.report(
          pointer + "/stroke_length_m/" + key,
          phrase("Protocols",
                 "a stroke of %1 m does not fit into the patch of %2 m by %3 m; shorten "
                 "the stroke or enlarge the patch%4")
              .with(digits(*length_m), digits(patch.extent_m.x), digits(patch.extent_m.y),
                    meant_in_other_unit(*length_m, "m", is_short_enough)));
      return true;
    };
    const Band& length = exploration.stroke_length_m;
    const std::array is_long{too_long(length.minimum, "minimum"),
                             too_long(length.target, "target")};
    if (is_long == std::array{false, false})
      check_band(checked, length, pointer + "/stroke_length_m");
    if (exploration.minimum_contact_s > exploration.maximum_contact_s) {
      checked.report(
          pointer + "/minimum_contact_s",
          phrase("Protocols",
                 "at least %1 s of contact are requested, but the surface is removed "
                 "after %2 s; lower %3 or raise %4")
              .with(digits(exploration.minimum_contact_s), digits(exploration.maximum_contact_s),
                    key_name("minimum_contact_s"), key_name("maximum_contact_s")));
    }
    const auto bounded = [](const Band& band) { return band.minimum || band.maximum; };
    if (exploration.required_fraction_in_band > 0.0 && !bounded(exploration.normal_force_N) &&
        !bounded(exploration.speed_m_per_s)) {
      checked.report(pointer + "/required_fraction_in_band",
                     phrase("Protocols",
                            "there is no band to which the fraction could refer: give %1 or %2 a "
                            "minimum or a maximum")
                         .with(key_name("normal_force_N"), key_name("speed_m_per_s")));
    }
    const bool repeats = exploration.on_failure != Exploration::OnFailure::flag;
    if (repeats && exploration.maximum_repeats < 1) {
      checked.report(
          pointer + "/on_failure",
          phrase("Protocols", "trials are to be repeated, but at most 0 times: set %1 to 1 or more")
              .with(key_name("maximum_repeats")));
    }
    if (!repeats && exploration.maximum_repeats > 0) {
      checked.report(pointer + "/maximum_repeats",
                     phrase("Protocols", "nothing is repeated while %1 is %2; choose %3 or %4")
                         .with(key_name("on_failure"), word_name("flag"), word_name("repeat_now"),
                               word_name("requeue_at_end_of_block")));
    }
  }
}

}  // namespace asperity
