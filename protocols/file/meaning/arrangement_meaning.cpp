// Implements the checks of the arrangement of a block's trials.

#include <algorithm>

#include "analysis/numbers/number_text.h"
#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/plan/arranged_patches.h"

namespace asperity {

using Block = Protocol::Block;
using Placement = Arrangement::Surfaces;

namespace {

constexpr std::size_t kMostSideBySide = 4;
// From the end of a visit to the end of the contact.
constexpr double kLifting_s = 0.3;

/// The visit ends when the stroke after the last one has begun, which counts as a stroke that is cut off.
void check_strokes_of_visit(CheckedDocument& checked, const Block& block,
                            const Exploration& exploration, const std::string& place) {
  const int strokes = *block.arrangement.strokes;
  const double of_all_visits = strokes * block.arrangement.minimum_visits;
  if (exploration.strokes.minimum && of_all_visits < *exploration.strokes.minimum) {
    checked.report(place,
                   phrase("Protocols",
                          "the exploration %1 requires at least %2 strokes; state more "
                          "strokes, or lower its minimum")
                       .with(in_quotes(exploration.name), digits(*exploration.strokes.minimum)));
  }
  if (exploration.strokes.maximum &&
      of_all_visits + block.arrangement.minimum_visits > *exploration.strokes.maximum) {
    checked.report(place,
                   phrase("Protocols",
                          "the exploration %1 permits no more strokes than %2, and the "
                          "stroke that has begun at the end of a visit counts; state fewer "
                          "strokes, or raise its maximum")
                       .with(in_quotes(exploration.name), digits(*exploration.strokes.maximum)));
  }
}

void check_exposure(CheckedDocument& checked, const Block& block, const std::string& place) {
  const Arrangement& arrangement = block.arrangement;
  if (!arrangement.strokes && !arrangement.contact_s) {
    const nlohmann::json::json_pointer at(place + "/exposure");
    if (!checked.document.root().contains(at)) return;
    checked.report(place + "/exposure",
                   phrase("Protocols", "state what ends a visit: %1 or %2; or remove this key")
                       .with(key_name("strokes"), key_name("contact_s")));
    return;
  }
  for (const auto& [name, at] : texts_of(checked, block.exploration, "")) {
    const auto exploration = checked.protocol.explorations.find(name);
    if (exploration == checked.protocol.explorations.end()) continue;
    if (arrangement.strokes) {
      check_strokes_of_visit(checked, block, exploration->second, place + "/exposure/strokes");
      continue;
    }
    if (*arrangement.contact_s * arrangement.minimum_visits <
        exploration->second.minimum_contact_s) {
      checked.report(place + "/exposure/contact_s",
                     phrase("Protocols",
                            "the exploration %1 requires a contact of at least %2 s; state a "
                            "longer %3, or lower %4")
                         .with(in_quotes(name), digits(exploration->second.minimum_contact_s),
                               key_name("contact_s"), key_name("minimum_contact_s")));
    } else if (*arrangement.contact_s + kLifting_s > exploration->second.maximum_contact_s) {
      checked.report(
          place + "/exposure/contact_s",
          phrase("Protocols",
                 "the exploration %1 permits a contact of at most %2 s, and the hand "
                 "needs about %3 s to lift; state a shorter %4, or raise %5")
              .with(in_quotes(name), digits(exploration->second.maximum_contact_s),
                    digits(kLifting_s), key_name("contact_s"), key_name("maximum_contact_s")));
    }
  }
}

/// Bodies have a place of their own.
void check_plane_models(CheckedDocument& checked, const Block& block, const std::string& at,
                        const Phrase& what) {
  for (const Protocol::Presented& presented : block.presented) {
    const auto stimulus = checked.protocol.stimuli.find(presented.stimulus);
    if (stimulus == checked.protocol.stimuli.end()) continue;
    if (is_point_on_body(stimulus->second)) {
      checked.report(at, phrase("Protocols",
                                "the stimulus %1 lies on a body, which cannot %2; remove its %3, "
                                "or use another arrangement")
                             .with(in_quotes(presented.stimulus), what, key_name("surface")));
      return;
    }
    for (const auto& [name, where] : texts_of(checked, stimulus->second.model, "")) {
      const auto model = checked.models.find(name);
      if (model == checked.models.end() || !model->second->needs_bodies) continue;
      checked.report(at, phrase("Protocols",
                                "the stimulus %1 has the model %2, whose bodies cannot %3; use a "
                                "model of a plane, or another arrangement")
                             .with(in_quotes(presented.stimulus), in_quotes(name), what));
      return;
    }
  }
}

void check_side_by_side(CheckedDocument& checked, const Block& block, const std::string& place) {
  // A design with one surface in each trial is reported with the kind.
  const std::size_t surfaces = std::max(block.presented.size(), surfaces_in_trial(block));
  if (surfaces < 2 || surfaces > kMostSideBySide) {
    checked.report(place + "/surfaces",
                   phrase("Protocols",
                          "2 to 4 surfaces can lie side by side, but the block presents %1; use "
                          "another arrangement")
                       .with(std::to_string(surfaces)));
    return;
  }
  const Arrangement& arrangement = block.arrangement;
  if (arrangement.maximum_visits) {
    checked.report_key(
        place + "/visits/maximum",
        phrase("Protocols",
               "the hand moves freely over patches, so that visits have no maximum; remove this "
               "key"));
  }
  if (checked.protocol.scene) {
    checked.report("/environment/scene",
                   phrase("Protocols",
                          "the scene shows one surface, but the block %1 presents patches side by "
                          "side; remove this key")
                       .with(in_quotes(block.name)));
  }
  const double width_m = width_side_by_side_m(checked.protocol.patch, arrangement, surfaces);
  const double least_m = 2.0 * kBlend_m + checked.protocol.patch.edge_width_m;
  if (width_m < least_m) {
    checked.report(place + "/gap_m",
                   phrase("Protocols",
                          "the patches would be %1 mm wide, but need at least %2 mm; state a "
                          "smaller gap or a wider surface")
                       .with(fixed(1000.0 * width_m, 1), fixed(1000.0 * least_m, 1)));
  }
  check_plane_models(checked, block, place + "/surfaces", phrase("Protocols", "lie side by side"));
}

void check_drawn_phase(CheckedDocument& checked, const Block& block, const std::string& place) {
  if (checked.protocol.scene == VisualTexture::on) {
    checked.report(
        place + "/phase",
        phrase("Protocols",
               "the scene shows the relief of a surface, which would not agree with a drawn phase; "
               "use %1, or another scene")
            .with(word_name("fixed")));
  }
  if (checked.protocol.patch.tiling == Tiling::bounded) {
    checked.report(
        place + "/phase",
        phrase("Protocols",
               "a texture that is not repeated can be felt at one place only; use %1, or the "
               "tiling %2")
            .with(word_name("fixed"), word_name("repeat")));
  }
  check_plane_models(checked, block, place + "/phase", phrase("Protocols", "have a drawn phase"));
}

void check_rove(CheckedDocument& checked, const Block& block, const std::string& place) {
  if (block.rove.is_empty()) return;
  if (!block.rove.raised_m.empty() && block.arrangement.surfaces == Placement::side_by_side) {
    checked.report_key(
        place + "/raised_m",
        phrase("Protocols",
               "patches side by side lie in one plane; remove this key, or use another "
               "arrangement"));
  }
  if (!block.rove.raised_m.empty())
    check_plane_models(checked, block, place + "/raised_m", phrase("Protocols", "be raised"));
}

}  // namespace

void check_arrangement(CheckedDocument& checked, const Block& block, const std::string& pointer) {
  check_rove(checked, block, pointer + "/rove");
  const auto& object = checked.document.root().at("blocks").at(block.name);
  const auto stated = object.find("arrangement");
  if (stated == object.end()) return;
  const Arrangement& arrangement = block.arrangement;
  const std::string place = pointer + "/arrangement";
  for (const std::string& of_trial : {pointer, pointer + "/question"}) {
    const nlohmann::json::json_pointer at(of_trial + "/allow_revisit");
    if (!checked.document.root().contains(at)) continue;
    checked.report_key(
        of_trial + "/allow_revisit",
        phrase("Protocols",
               "the arrangement determines how often a surface can be felt; remove this key, and "
               "state %1 in the arrangement")
            .with(key_name("visits")));
  }
  if (arrangement.interval && object.contains("pause_between_surfaces_s")) {
    checked.report_key(
        pointer + "/pause_between_surfaces_s",
        phrase("Protocols", "%1 of the arrangement replaces this pause; keep one of the two")
            .with(key_name("interval_s")));
  }
  if (!arrangement.interval && arrangement.surfaces != Placement::sequential &&
      object.contains("pause_between_surfaces_s")) {
    checked.report_key(
        pointer + "/pause_between_surfaces_s",
        phrase("Protocols", "this pause applies only to surfaces in sequence; remove this key"));
  }
  if (arrangement.interval && arrangement.interval->shortest_s > arrangement.interval->longest_s) {
    checked.report(
        place + "/interval_s/shortest",
        phrase("Protocols", "the lower limit is above the upper limit; exchange the two numbers"));
  }
  if (arrangement.maximum_visits && *arrangement.maximum_visits < arrangement.minimum_visits) {
    checked.report(place + "/visits/maximum",
                   phrase("Protocols",
                          "the maximum is below the minimum of %1; raise it, or lower the minimum")
                       .with(std::to_string(arrangement.minimum_visits)));
  }
  check_exposure(checked, block, place);
  if (arrangement.surfaces == Placement::side_by_side) check_side_by_side(checked, block, place);
  if (arrangement.draws_phase) check_drawn_phase(checked, block, place);
}

}  // namespace asperity
