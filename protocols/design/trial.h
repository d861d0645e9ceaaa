// Declares one trial of a session: its surfaces and its questions.

#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocols/answers/question.h"
#include "protocols/design/protocol.h"
#include "protocols/design/roughness_match.h"
#include "stimuli/stimulus_description.h"

namespace asperity {

/// One surface of a trial.
struct PlannedPresentation {
  int position = 0;    ///< 1-based, in the order of presentation
  std::string role{};  ///< "alternative", "target", "anchor"
  std::string item{};  ///< the model (selection) or texture that it is an instance of
  std::string code{};  ///< label for blinded use: "A" for the first position, then "B", …
  std::string stimulus_template{};  ///< the template of the stimulus, by its name in the protocol
  StimulusDescription stimulus{};
  /// Where the surface is presented: the patch of the stimulus, or the part of it that the arrangement gives it.
  SurfacePatch patch{};
  /// Whether the material of the stimulus differs from that of the protocol by its own statement or by roving.
  bool has_own_material = false;
  std::optional<EqualForce> equal_force{};
  /// With `Protocol::Block::equal_roughness`: how its relative amplitude was determined.
  std::optional<MatchStatus> roughness_match{};
};

/// The place of a trial in its track.
struct TrackStep {
  int track = 0;  ///< 1-based within the run of its block
  int step = 0;   ///< 1-based within the track

  bool operator==(const TrackStep&) const = default;
};

/// Of a catch trial at a random place among the trials of a procedure.
struct CatchTrial {
  CatchType type = CatchType::easy;
  bool is_above_standard = true;  ///< of the type easy

  bool operator==(const CatchTrial&) const = default;
};

struct Trial {
  int ordinal = 0;  ///< 1-based within the session
  std::string block{};
  std::string kind{};     ///< that of its block
  int block_ordinal = 0;  ///< 1-based within the session; every run of a block counts
  Phase phase = Phase::main;
  /// 0 of an anchor and of a catch trial; the step of a trial with a track.
  int repetition = 1;
  std::optional<TrackStep> track{};  ///< where a procedure chose its level
  std::optional<CatchTrial> catch_trial{};
  std::optional<AnchorPlace> anchor{};  ///< of an anchor: its place in the run of its block
  std::map<std::string, Level, std::less<>> factors{};
  std::vector<PlannedPresentation> presentations{};
  std::string experimenter_prompt{};  ///< e.g. which coded sample to place; empty: nothing to do
  /// Study-relative picture of the texture that realism is measured against, where it is shown.
  std::optional<std::string> standard_picture{};
  Arrangement arrangement{};
  Material flat{};  ///< of the flat surface between surfaces side by side: that of the protocol
  bool pictures_after_feeling = false;  ///< options stay hidden until every surface was felt
  /// At least one, in the order in which they are asked.
  std::vector<Question> questions{};
  bool on_one_page = false;   ///< all questions are shown together; otherwise one after another
  std::string page_prompt{};  ///< shown above the questions of one page; may be empty

  /// Of a track, or among those of tracks: what surfaces it presents depends on responses.
  bool is_of_procedure() const noexcept { return track || catch_trial; }
};

/// The questions that are shown together, page after page.
std::vector<std::span<const Question>> pages_of(const Trial& trial);

/// Null where the trial does not ask a question of that name.
const Question* find_question(const Trial& trial, const std::string& name) noexcept;

}  // namespace asperity
