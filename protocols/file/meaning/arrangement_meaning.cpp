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
    checked.report(place, "the exploration " + in_quotes(exploration.name) + " requires at least " +
                              digits(*exploration.strokes.minimum) +
                              " strokes; state more strokes, or lower its minimum");
  }
  if (exploration.strokes.maximum &&
      of_all_visits + block.arrangement.minimum_visits > *exploration.strokes.maximum) {
    checked.report(place, "the exploration " + in_quotes(exploration.name) +
                              " permits no more strokes than " +
                              digits(*exploration.strokes.maximum) +
                              ", and the stroke that has begun at the end of a visit counts; state "
                              "fewer strokes, or raise its maximum");
  }
}

void check_exposure(CheckedDocument& checked, const Block& block, const std::string& place) {
  const Arrangement& arrangement = block.arrangement;
  if (!arrangement.strokes && !arrangement.contact_s) {
    const nlohmann::json::json_pointer at(place + "/exposure");
    if (!checked.document.root().contains(at)) return;
    checked.report(place + "/exposure",
                   "state what ends a visit: \"strokes\" or \"contact_s\"; or remove this key");
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
                     "the exploration " + in_quotes(name) + " requires a contact of at least " +
                         digits(exploration->second.minimum_contact_s) +
                         " s; state a longer contact_s, or lower minimum_contact_s");
    } else if (*arrangement.contact_s + kLifting_s > exploration->second.maximum_contact_s) {
      checked.report(place + "/exposure/contact_s",
                     "the exploration " + in_quotes(name) + " permits a contact of at most " +
                         digits(exploration->second.maximum_contact_s) +
                         " s, and the hand needs about " + digits(kLifting_s) +
                         " s to lift; state a shorter contact_s, or raise maximum_contact_s");
    }
  }
}

/// Bodies have a place of their own.
void check_plane_models(CheckedDocument& checked, const Block& block, const std::string& at,
                        const std::string& what) {
  for (const Protocol::Presented& presented : block.presented) {
    const auto stimulus = checked.protocol.stimuli.find(presented.stimulus);
    if (stimulus == checked.protocol.stimuli.end()) continue;
    if (is_point_on_body(stimulus->second)) {
      checked.report(at, "the stimulus " + in_quotes(presented.stimulus) +
                             " lies on a body, which cannot " + what +
                             "; remove its \"surface\", or use another arrangement");
      return;
    }
    for (const auto& [name, where] : texts_of(checked, stimulus->second.model, "")) {
      const auto model = checked.models.find(name);
      if (model == checked.models.end() || !model->second->needs_bodies) continue;
      checked.report(at, "the stimulus " + in_quotes(presented.stimulus) + " has the model " +
                             in_quotes(name) + ", whose bodies cannot " + what +
                             "; use a model of a plane, or another arrangement");
      return;
    }
  }
}

void check_side_by_side(CheckedDocument& checked, const Block& block, const std::string& place) {
  // A design with one surface in each trial is reported with the kind.
  const std::size_t surfaces = std::max(block.presented.size(), surfaces_in_trial(block));
  if (surfaces < 2 || surfaces > kMostSideBySide) {
    checked.report(place + "/surfaces",
                   "2 to 4 surfaces can lie side by side, but the block presents " +
                       std::to_string(surfaces) + "; use another arrangement");
    return;
  }
  const Arrangement& arrangement = block.arrangement;
  if (arrangement.maximum_visits) {
    checked.report_key(
        place + "/visits/maximum",
        "the hand moves freely over patches, so that visits have no maximum; remove this key");
  }
  if (checked.protocol.scene) {
    checked.report("/environment/scene", "the scene shows one surface, but the block " +
                                             in_quotes(block.name) +
                                             " presents patches side by side; remove this key");
  }
  const double width_m = width_side_by_side_m(checked.protocol.patch, arrangement, surfaces);
  const double least_m = 2.0 * kBlend_m + checked.protocol.patch.edge_width_m;
  if (width_m < least_m) {
    checked.report(place + "/gap_m", "the patches would be " + fixed(1000.0 * width_m, 1) +
                                         " mm wide, but need at least " +
                                         fixed(1000.0 * least_m, 1) +
                                         " mm; state a smaller gap or a wider surface");
  }
  check_plane_models(checked, block, place + "/surfaces", "lie side by side");
}

void check_drawn_phase(CheckedDocument& checked, const Block& block, const std::string& place) {
  if (checked.protocol.scene == VisualTexture::on) {
    checked.report(
        place + "/phase",
        "the scene shows the relief of a surface, which would not agree with a drawn phase; use "
        "\"fixed\", or another scene");
  }
  if (checked.protocol.patch.tiling == Tiling::bounded) {
    checked.report(
        place + "/phase",
        "a texture that is not repeated can be felt at one place only; use \"fixed\", or the "
        "tiling \"repeat\"");
  }
  check_plane_models(checked, block, place + "/phase", "have a drawn phase");
}

void check_rove(CheckedDocument& checked, const Block& block, const std::string& place) {
  if (block.rove.is_empty()) return;
  if (!block.rove.raised_m.empty() && block.arrangement.surfaces == Placement::side_by_side) {
    checked.report_key(
        place + "/raised_m",
        "patches side by side lie in one plane; remove this key, or use another arrangement");
  }
  if (!block.rove.raised_m.empty())
    check_plane_models(checked, block, place + "/raised_m", "be raised");
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
        "the arrangement determines how often a surface can be felt; remove this key, and "
        "state \"visits\" in the arrangement");
  }
  if (arrangement.interval && object.contains("pause_between_surfaces_s")) {
    checked.report_key(pointer + "/pause_between_surfaces_s",
                       "interval_s of the arrangement replaces this pause; keep one of the two");
  }
  if (!arrangement.interval && arrangement.surfaces != Placement::sequential &&
      object.contains("pause_between_surfaces_s")) {
    checked.report_key(pointer + "/pause_between_surfaces_s",
                       "this pause applies only to surfaces in sequence; remove this key");
  }
  if (arrangement.interval && arrangement.interval->shortest_s > arrangement.interval->longest_s) {
    checked.report(place + "/interval_s/shortest",
                   "the lower limit is above the upper limit; exchange the two numbers");
  }
  if (arrangement.maximum_visits && *arrangement.maximum_visits < arrangement.minimum_visits) {
    checked.report(place + "/visits/maximum", "the maximum is below the minimum of " +
                                                  std::to_string(arrangement.minimum_visits) +
                                                  "; raise it, or lower the minimum");
  }
  check_exposure(checked, block, place);
  if (arrangement.surfaces == Placement::side_by_side) check_side_by_side(checked, block, place);
  if (arrangement.draws_phase) check_drawn_phase(checked, block, place);
}

}  // namespace asperity
