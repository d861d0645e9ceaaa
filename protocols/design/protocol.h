// A study's question, written down: what a valid protocol file says, as a value.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/force_features.h"
#include "protocols/design/analysis_declaration.h"
#include "stimuli/meshes/solid_body.h"
#include "stimuli/properties/material.h"
#include "stimuli/properties/parameter.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// `chapter`: one outcome per person per column of the published table, as [Wu 2009] ran them.
/// `improved`: balanced order and position, reshuffled pictures, familiarisation, practice.
enum class ProtocolDesign { chapter, improved };

/// What "realistic" is measured against in a selection.
enum class RealismStandard {
  photograph,       ///< the texture's picture is shown
  physical_sample,  ///< the experimenter places the coded sample that the prompt names
  memory,           ///< the participant's own idea of the material
};

/// What the participant sees.
enum class Vision {
  free,           ///< hand, device and screen
  hand_occluded,  ///< the screen, not the hand
  blindfold,      ///< nothing: an eye mask is on while surfaces are felt
};

/// How object, tool and probe are drawn for a participant who may see them while feeling.
enum class VisualTexture {
  on,       ///< the surface shows its relief
  off,      ///< the surface is plain
  neutral,  ///< the surface shows a pattern that belongs to no texture
};

enum class Phase { familiarisation, practice, main };

/// As it stands in a protocol file and in the store.
const char* text_of(ProtocolDesign design) noexcept;
const char* text_of(Vision vision) noexcept;
const char* text_of(VisualTexture texture) noexcept;
const char* text_of(Phase phase) noexcept;

/// A range and what to aim at; any part may be open.
struct Band {
  std::optional<double> minimum{};
  std::optional<double> target{};
  std::optional<double> maximum{};
};

/// How a surface is to be explored, and what follows when it was not.
struct Exploration {
  enum class OnFailure { flag, repeat_now, requeue_at_end_of_block };
  /// Who is told how force and speed meet their bands while a surface is felt. The experimenter always
  /// is.
  enum class Guidance {
    experimenter,   ///< and nobody else
    bars,           ///< the participant sees each quantity in its band
    moving_target,  ///< the participant follows a mark to and fro, and sees the force in its band
    tones,          ///< the participant hears when a quantity leaves its band, and on which side
  };
  std::string name{};
  double direction_rad = 0.0;  ///< of the stroke, from +x towards +y
  Band stroke_length_m{};
  Band speed_m_per_s{};
  Band normal_force_N{};
  Band strokes{};  ///< a count
  double minimum_contact_s = 1.0;
  double maximum_contact_s = 30.0;
  /// Fraction that has to lie inside each band: of the contact time for the force, of the strokes for
  /// the speed.
  double required_fraction_in_band = 0.0;
  OnFailure on_failure = OnFailure::flag;
  int maximum_repeats = 0;
  Guidance guidance = Guidance::experimenter;
};

/// A texture as participants meet it: felt (a height field), seen (a picture), or both.
struct Texture {
  std::string name{};
  std::string code{};  ///< what blinded people call it, e.g. the label on a physical sample
  std::optional<std::string>
      height_field{};                    ///< study-relative PNG; absent: no rendered counterpart
  std::optional<std::string> picture{};  ///< study-relative
  std::optional<std::string> true_height_field{};  ///< study-relative; of procedural textures
  std::optional<double> spacing_m{};               ///< distance of its elements
  std::optional<ForceFeatures> prior{};            ///< stated expectation where there is no truth
  std::string note{};
};

/// A value, or the factor whose level it is.
template <class Value>
struct Binding {
  std::optional<Value> value{};
  std::string factor{};  ///< used when `value` is absent
};

/// A request that the texture force be made equal, see renderers/offline/force_matching.h.
struct EqualForce {
  std::optional<double> rms_N{};  ///< a stated target, or else
  std::string to_model{};         ///< that of this model with the same texture
  double band_low_Hz = 5.0;
  double band_high_Hz = 500.0;
};

/// What is felt, with places left open for factors.
struct StimulusTemplate {
  std::string name{};
  Binding<std::string> model{};
  Binding<std::string> texture{};  ///< neither value nor factor: no texture is involved
  Binding<std::string> surface{};  ///< a body, of a model that needs them
  Binding<std::string> tool{};     ///< likewise
  std::map<std::string, Binding<ParameterValue>, std::less<>> parameters{};
  std::optional<EqualForce> equal_force{};
};

/// Every name that `Protocol::speech` may have: "surface_1" … "surface_26", "option_1" …
/// "option_26" and the cues without a number.
std::vector<std::string> speech_cues();

using Level = std::variant<double, std::string>;
std::string text_of(const Level& level);

struct Factor {
  std::string name{};
  std::string meaning{};
  std::string unit{};
  std::vector<Level> levels{};
};

/// A question of the questionnaire or about the participant; trials have TrialQuestion (plan.h).
struct Question {
  enum class Form { choice, number, text };
  std::string name{};
  std::string prompt{};
  Form form = Form::choice;
  std::vector<std::string> options{};  ///< what is stored
  /// What is shown for each option, where that is another text (of another language); else empty.
  std::vector<std::string> option_texts{};
  std::optional<double> minimum{};
  std::optional<double> maximum{};
  bool optional = false;

  const std::string& text_of_option(std::size_t i) const {
    return option_texts.empty() ? options.at(i) : option_texts.at(i);
  }
};

/// How a virtual participant judges; see virtual_observer.h.
struct ObserverDeclaration {
  enum class Expectation {
    none,  ///< no judgement of realism or identity is simulated: answers are guesses, marked so
    true_surface,  ///< features of the textures' true height fields, rendered on another stroke
    prior,         ///< features stated in the protocol (Texture::prior)
  };
  Expectation expectation = Expectation::none;
  /// With true_surface: what is expected is the true surface without its longer waves, by the same
  /// Gaussian that a height field from a photograph has lost them to (TextureRecipe). Nothing: the
  /// whole surface.
  std::optional<double> gaussian_wavelength_m{};
  bool deaf = false;           ///< ignores what was felt, answers uniformly over the open options
  double feature_noise = 0.1;  ///< standard deviation added to every feature
  double position_bias = 0.0;  ///< added to the evidence of the first position
  double lapse = 0.02;         ///< probability of a guess
  /// Of a magnitude: what a number is made from, and the power of it that numbers grow with.
  enum class MagnitudeOf {
    lateral_force,  ///< as a share of the mean normal force
    normal_force,   ///< likewise
    held_tool,      ///< how the force shakes a held tool (ForceFeatures::shaking_m_per_s2)
  };
  MagnitudeOf magnitude_of = MagnitudeOf::lateral_force;
  double exponent = 1.0;
};

/// As it stands in a protocol file and in the store.
const char* text_of(ObserverDeclaration::MagnitudeOf what) noexcept;

/// Everything a protocol file says. Always valid: only `read_protocol` makes one.
struct Protocol {
  std::string kind =
      "selection";  ///< the id of an ExperimentKind (protocols/kinds/experiment_kind.h)
  ProtocolDesign design = ProtocolDesign::chapter;
  std::string name{};
  std::string version{};
  std::string title{};
  std::string language =
      "en";  ///< of its texts, a BCP 47 tag; the program's own to participants follow
  std::string description{};
  std::vector<std::string> authors{};
  std::string license{};
  std::string instructions{};
  std::string consent_version{};
  std::string consent_statement{};
  int planned_participants = 0;
  int sessions = 1;                                   ///< per participant
  std::vector<Question> participant_questions{};      ///< asked once, before the first session
  std::optional<RealismStandard> realism_standard{};  ///< of a selection
  std::optional<EstimationDeclaration> estimation{};  ///< of a magnitude

  Vision vision = Vision::free;
  std::optional<VisualTexture> scene{};  ///< shown while feeling; absent: nothing is
  bool shows_pictures_in_grey = false;
  /// Over headphones, so that the device is not heard.
  struct Noise {
    enum class Kind { none, white, pink };
    Kind kind = Kind::none;
    std::optional<double> level_dBA{};  ///< at the ear; stated for every noise but none
  };
  Noise masking_noise{};
  /// Recorded speech in the place of tones: the cue ("surface_1", "question"; see `speech_cues`) →
  /// a study-relative WAV file.
  std::map<std::string, std::string, std::less<>> speech{};

  double rate_Hz = 1000.0;
  double force_limit_N = 5.0;
  int maximum_missed_deadlines = 50;  ///< in contact, per attempt; more make the attempt invalid
  int maximum_lost_records = 0;
  /// A session with a person needs a profile of its device that is not older; absent: none is needed.
  std::optional<double> profile_maximum_age_days{};
  bool refuses_rehearsal_warnings = false;  ///< of what the device cannot render or does not keep
  bool input_only = false;  ///< study data of people may come from a device without motors
  /// The device's item ("lateness_p99_s") → what it is held to; which side is right is the item's.
  std::map<std::string, double> device_limits{};

  SurfacePatch patch{};
  Material material{};
  std::map<std::string, Texture, std::less<>> textures{};
  /// Without paths of height fields: those are the textures'.
  std::map<std::string, BodyDescription, std::less<>> bodies{};
  std::map<std::string, StimulusTemplate, std::less<>> stimuli{};
  std::map<std::string, Factor, std::less<>> factors{};
  std::map<std::string, Exploration, std::less<>> explorations{};
  std::map<std::string, Question, std::less<>> questions{};

  /// Blocks and flow, as the planner reads them.
  struct Presented {
    std::string role{};                                ///< "alternative", "target"
    std::string stimulus{};                            ///< a StimulusTemplate
    std::map<std::string, Level, std::less<>> with{};  ///< factors fixed for this presentation
    /// What it counts as in the answers; empty: the model (selection) or texture it shows.
    std::string item{};
  };
  struct TrialQuestionTemplate {
    std::string name{};
    std::string prompt{};
    std::string experimenter_prompt{};  ///< "{code}" stands for the code of the trial's texture
    /// What the options are: the alternatives felt, or pictures of these textures.
    std::vector<std::string> pictures{};  ///< empty: the alternatives felt
    bool reshuffle_pictures = false;      ///< every trial anew; otherwise once per session
    bool pictures_after_feeling = false;  ///< hidden until every surface was felt (an eye mask)
    bool allow_cannot_tell = false;
    bool allow_revisit = true;     ///< free switching between the surfaces before the answer
    std::string correct_factor{};  ///< recognition: the factor that names the right picture
  };
  /// Practice: the block ends once `correct` of the last `of_last` answers were right, or after
  /// `maximum_trials`, which is how many trials are planned.
  struct Criterion {
    int correct = 0;
    int of_last = 0;
    int maximum_trials = 0;
    enum class OnFailure { continue_flagged, end_session } on_failure = OnFailure::continue_flagged;
  };
  struct Block {
    enum class Order { fixed, shuffle, shuffle_within_repetition };
    enum class Positions { as_listed, shuffle, balanced };
    std::string name{};
    Phase phase = Phase::main;
    std::vector<std::string> crossed{};                               ///< factors, or
    std::vector<std::map<std::string, Level, std::less<>>> listed{};  ///< rows
    int repetitions = 1;
    /// Factors drawn anew on every trial (balanced over the block as far as it goes).
    std::vector<std::string> drawn{};
    /// Of a magnitude: the levels of the trial that comes first in every run of the block, what others
    /// are judged by; empty: none does.
    std::map<std::string, Level, std::less<>> anchor{};
    Order order = Order::shuffle;
    std::map<std::string, int, std::less<>> maximum_in_a_row{};
    std::vector<Presented> presented{};
    Positions positions = Positions::as_listed;
    TrialQuestionTemplate question{};
    Binding<std::string> exploration{};
    double pause_before_trial_s = 0.5;
    double pause_between_surfaces_s = 0.5;
    std::optional<double> response_deadline_s{};
    enum class Feedback { none, correctness, correct_answer } feedback = Feedback::none;
    std::optional<Criterion> until{};
  };
  struct Screen {
    std::string text{};
  };
  struct Check {
    enum class What { device, force_zero } what = What::device;
  };
  struct Break {
    double minimum_s = 0.0;
    std::string text{};
    bool zero_force = true;
  };
  struct Run {
    std::string block{};
    std::string for_each{};  ///< a factor iterated outside the block, in a counterbalanced order
    int break_every_trials = 0;    ///< 0: none within the block
    std::optional<Break> pause{};  ///< after so many trials and between the levels of `for_each`
  };
  struct Ask {
    std::vector<std::string> questions{};
  };
  using Step = std::variant<Screen, Check, Break, Run, Ask>;
  enum class Counterbalance { none, latin, williams };
  Counterbalance counterbalance = Counterbalance::none;
  std::map<std::string, Block, std::less<>> blocks{};
  std::vector<Step> flow{};
  /// How an interrupted session is resumed.
  struct Resume {
    /// What the participant reads; absent: the last text before the interruption.
    std::optional<std::vector<std::string>> screens{};
    /// Since it last ran; an older session is resumed only with a reason.
    std::optional<double> maximum_age_hours{};
  };
  Resume resume{};
  ObserverDeclaration observer{};
  bool record = true;  ///< every tick of every attempt
  AnalysisDeclaration analysis{};

  std::string source{};  ///< the file, byte for byte
};

}  // namespace asperity
