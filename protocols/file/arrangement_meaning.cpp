// Implements the checks of the arrangement of a block's trials.

#include <algorithm>

#include "analysis/numbers/number_text.h"
#include "protocols/file/meaning_checks.h"
#include "protocols/plan/arranged_patches.h"

namespace asperity {

using Block = Protocol::Block;
using Placement = Arrangement::Surfaces;

namespace {

constexpr std::size_t kMostSideBySide = 4;
// From the end of a visit to the end of the contact.
constexpr double kLifting_s = 0.3;

}  // namespace

void Meaning::check_arrangement(const Block& block, const std::string& pointer) {
  check_rove(block, pointer + "/rove");
  const auto& object = document_.root().at("blocks").at(block.name);
  const auto stated = object.find("arrangement");
  if (stated == object.end()) return;
  const Arrangement& arrangement = block.arrangement;
  const std::string place = pointer + "/arrangement";
  for (const std::string& of_trial : {pointer, pointer + "/question"}) {
    const nlohmann::json::json_pointer at(of_trial + "/allow_revisit");
    if (!document_.root().contains(at)) continue;
    report_key(of_trial + "/allow_revisit",
               "the arrangement determines how often a surface can be felt; remove this key, and "
               "state \"visits\" in the arrangement");
  }
  if (arrangement.interval && object.contains("pause_between_surfaces_s")) {
    report_key(pointer + "/pause_between_surfaces_s",
               "interval_s of the arrangement replaces this pause; keep one of the two");
  }
  if (!arrangement.interval && arrangement.surfaces != Placement::sequential &&
      object.contains("pause_between_surfaces_s")) {
    report_key(pointer + "/pause_between_surfaces_s",
               "this pause applies only to surfaces in sequence; remove this key");
  }
  if (arrangement.interval && arrangement.interval->shortest_s > arrangement.interval->longest_s) {
    report(place + "/interval_s/shortest",
           "the lower limit is above the upper limit; exchange the two numbers");
  }
  if (arrangement.maximum_visits && *arrangement.maximum_visits < arrangement.minimum_visits) {
    report(place + "/visits/maximum", "the maximum is below the minimum of " +
                                          std::to_string(arrangement.minimum_visits) +
                                          "; raise it, or lower the minimum");
  }
  check_exposure(block, place);
  if (arrangement.surfaces == Placement::side_by_side) {
    check_side_by_side(block, place);
  } else {
    for (const char* const key : {"gap_m", "axis"}) {
      if (!stated->contains(key)) continue;
      report_key(place + "/" + key,
                 "only patches have this key; remove it, or set \"surfaces\" to \"side_by_side\"");
    }
  }
  if (arrangement.draws_phase) check_drawn_phase(block, place);
}

void Meaning::check_exposure(const Block& block, const std::string& place) {
  const Arrangement& arrangement = block.arrangement;
  if (!arrangement.strokes && !arrangement.contact_s) {
    const nlohmann::json::json_pointer at(place + "/exposure");
    if (!document_.root().contains(at)) return;
    report(place + "/exposure",
           "state what ends a visit: \"strokes\" or \"contact_s\"; or remove this key");
    return;
  }
  if (arrangement.strokes && arrangement.contact_s) {
    report_key(place + "/exposure/contact_s",
               "a visit ends after strokes or after a contact time; keep one of the two");
    return;
  }
  for (const auto& [name, at] : texts_of(block.exploration, "")) {
    const auto exploration = protocol_.explorations.find(name);
    if (exploration == protocol_.explorations.end()) continue;
    if (arrangement.strokes) {
      check_strokes_of_visit(block, exploration->second, place + "/exposure/strokes");
      continue;
    }
    if (*arrangement.contact_s * arrangement.minimum_visits <
        exploration->second.minimum_contact_s) {
      report(place + "/exposure/contact_s",
             "the exploration " + in_quotes(name) + " requires a contact of at least " +
                 digits(exploration->second.minimum_contact_s) +
                 " s; state a longer contact_s, or lower minimum_contact_s");
    } else if (*arrangement.contact_s + kLifting_s > exploration->second.maximum_contact_s) {
      report(place + "/exposure/contact_s",
             "the exploration " + in_quotes(name) + " permits a contact of at most " +
                 digits(exploration->second.maximum_contact_s) + " s, and the hand needs about " +
                 digits(kLifting_s) +
                 " s to lift; state a shorter contact_s, or raise maximum_contact_s");
    }
  }
}

/// The visit ends when the stroke after the last one has begun, which counts as a stroke that is cut off.
void Meaning::check_strokes_of_visit(const Block& block, const Exploration& exploration,
                                     const std::string& place) {
  const int strokes = *block.arrangement.strokes;
  const double of_all_visits = strokes * block.arrangement.minimum_visits;
  if (exploration.strokes.minimum && of_all_visits < *exploration.strokes.minimum) {
    report(place, "the exploration " + in_quotes(exploration.name) + " requires at least " +
                      digits(*exploration.strokes.minimum) +
                      " strokes; state more strokes, or lower its minimum");
  }
  if (exploration.strokes.maximum &&
      of_all_visits + block.arrangement.minimum_visits > *exploration.strokes.maximum) {
    report(place, "the exploration " + in_quotes(exploration.name) +
                      " permits no more strokes than " + digits(*exploration.strokes.maximum) +
                      ", and the stroke that has begun at the end of a visit counts; state "
                      "fewer strokes, or raise its maximum");
  }
}

void Meaning::check_side_by_side(const Block& block, const std::string& place) {
  // A design with one surface in each trial is reported with the kind.
  const std::size_t surfaces = std::max(block.presented.size(), surfaces_in_trial(block));
  if (surfaces < 2 || surfaces > kMostSideBySide) {
    report(place + "/surfaces", "2 to 4 surfaces can lie side by side, but the block presents " +
                                    std::to_string(surfaces) + "; use another arrangement");
    return;
  }
  const Arrangement& arrangement = block.arrangement;
  if (arrangement.interval) {
    report_key(place + "/interval_s",
               "patches are presented together, without an interval; remove this key");
  }
  if (arrangement.maximum_visits) {
    report_key(
        place + "/visits/maximum",
        "the hand moves freely over patches, so that visits have no maximum; remove this key");
  }
  if (arrangement.strokes || arrangement.contact_s) {
    report_key(place + "/exposure",
               "the participant divides the time among patches; remove this key, and state visits "
               "and the contact time of the exploration");
  }
  if (protocol_.scene) {
    report("/environment/scene", "the scene shows one surface, but the block " +
                                     in_quotes(block.name) +
                                     " presents patches side by side; remove this key");
  }
  const double width_m = width_side_by_side_m(protocol_.patch, arrangement, surfaces);
  const double least_m = 2.0 * kBlend_m + protocol_.patch.edge_width_m;
  if (width_m < least_m) {
    report(place + "/gap_m", "the patches would be " + fixed(1000.0 * width_m, 1) +
                                 " mm wide, but need at least " + fixed(1000.0 * least_m, 1) +
                                 " mm; state a smaller gap or a wider surface");
  }
  check_plane_models(block, place + "/surfaces", "lie side by side");
}

void Meaning::check_drawn_phase(const Block& block, const std::string& place) {
  if (protocol_.scene == VisualTexture::on) {
    report(place + "/phase",
           "the scene shows the relief of a surface, which would not agree with a drawn phase; use "
           "\"fixed\", or another scene");
  }
  if (protocol_.patch.tiling == Tiling::bounded) {
    report(place + "/phase",
           "a texture that is not repeated can be felt at one place only; use \"fixed\", or the "
           "tiling \"repeat\"");
  }
  check_plane_models(block, place + "/phase", "have a drawn phase");
}

void Meaning::check_rove(const Block& block, const std::string& place) {
  if (block.rove.is_empty()) return;
  if (!block.rove.raised_m.empty() && block.arrangement.surfaces == Placement::side_by_side) {
    report_key(
        place + "/raised_m",
        "patches side by side lie in one plane; remove this key, or use another arrangement");
  }
  if (!block.rove.raised_m.empty()) check_plane_models(block, place + "/raised_m", "be raised");
}

/// Bodies have a place of their own.
void Meaning::check_plane_models(const Block& block, const std::string& at,
                                 const std::string& what) {
  for (const Protocol::Presented& presented : block.presented) {
    const auto stimulus = protocol_.stimuli.find(presented.stimulus);
    if (stimulus == protocol_.stimuli.end()) continue;
    if (is_point_on_body(stimulus->second)) {
      report(at, "the stimulus " + in_quotes(presented.stimulus) +
                     " lies on a body, which cannot " + what +
                     "; remove its \"surface\", or use another arrangement");
      return;
    }
    for (const auto& [name, where] : texts_of(stimulus->second.model, "")) {
      const auto model = models_.find(name);
      if (model == models_.end() || !model->second->needs_bodies) continue;
      report(at, "the stimulus " + in_quotes(presented.stimulus) + " has the model " +
                     in_quotes(name) + ", whose bodies cannot " + what +
                     "; use a model of a plane, or another arrangement");
      return;
    }
  }
}

}  // namespace asperity
