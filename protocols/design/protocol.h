// Declares a protocol, the contents of a valid protocol file.

#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/signals/force_features.h"
#include "protocols/answers/question.h"
#include "protocols/design/analysis_declaration.h"
#include "protocols/design/arrangement.h"
#include "protocols/design/dimension.h"
#include "protocols/kind_keys/discrimination.h"
#include "protocols/kind_keys/magnitude.h"
#include "protocols/kind_keys/paired_comparison.h"
#include "protocols/kind_keys/recognition.h"
#include "protocols/kind_keys/selection.h"
#include "protocols/kind_keys/similarity.h"
#include "protocols/procedures/procedure.h"
#include "protocols/shapes/binding.h"
#include "stimuli/meshes/solid_body.h"
#include "stimuli/properties/material.h"
#include "stimuli/properties/parameter.h"
#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// `chapter`: one outcome per participant and column of the published table, as in [Wu 2009]. `improved`: balanced
/// order and position, reshuffled pictures, familiarisation, practice.
enum class ProtocolDesign { chapter, improved };

/// What the participant can see.
enum class Vision {
  free,           ///< hand, device and screen
  hand_occluded,  ///< the screen but not the hand
  blindfold,      ///< nothing: an eye mask is worn while surfaces are felt
};

/// How object, tool and probe are drawn during exploration for a participant who can see them.
enum class VisualTexture {
  on,       ///< the surface shows its relief
  off,      ///< the surface is plain
  neutral,  ///< the surface shows a pattern that is unrelated to the textures
};

enum class Phase { familiarisation, practice, main };

/// Where an anchor stands in a run of its block.
enum class AnchorPlace {
  start,   ///< before the other trials
  middle,  ///< after half of them
  end,     ///< after them
};

/// The text in a protocol file and in the store.
const char* text_of(ProtocolDesign design) noexcept;
const char* text_of(Vision vision) noexcept;
const char* text_of(VisualTexture texture) noexcept;
const char* text_of(Phase phase) noexcept;
const char* text_of(AnchorPlace place) noexcept;

/// A range and a target value; each of them is optional.
struct Band {
  std::optional<double> minimum{};
  std::optional<double> target{};
  std::optional<double> maximum{};
};

/// The instructed exploration of a surface, and the consequence of failing to follow it.
struct Exploration {
  enum class OnFailure { flag, repeat_now, requeue_at_end_of_block };
  /// Who receives feedback on force and speed relative to their bands while a surface is felt. The experimenter always
  /// receives it.
  enum class Guidance {
    experimenter,   ///< only the experimenter
    bars,           ///< the participant sees each quantity in its band
    moving_target,  ///< the participant follows a moving mark and sees the force in its band
    tones,          ///< tones mark when a quantity leaves its band, and on which side
  };
  std::string name{};
  double direction_rad = 0.0;  ///< of the stroke, from +x towards +y
  Band stroke_length_m{};
  Band speed_m_per_s{};
  Band normal_force_N{};
  Band strokes{};  ///< a count
  double minimum_contact_s = 1.0;
  double maximum_contact_s = 30.0;
  /// Required fraction inside each band: of the contact time for the force, of the strokes for the speed.
  double required_fraction_in_band = 0.0;
  OnFailure on_failure = OnFailure::flag;
  int maximum_repeats = 0;
  Guidance guidance = Guidance::experimenter;
};

/// The consequence of a vibration that the force model does not contain (docs/instability.md).
struct InstabilityRule {
  enum class OnExcess { flag, repeat_now };
  double buzz_max = 0.0;  ///< relative to the texture force
  OnExcess on = OnExcess::flag;
};

/// A texture as it is presented to participants: felt (a height field), seen (a picture), or both.
struct Texture {
  std::string name{};
  std::string code{};  ///< for blinded use, e.g. the label on a physical sample
  std::optional<std::string>
      height_field{};                    ///< study-relative PNG; absent: no rendered counterpart
  std::optional<std::string> picture{};  ///< study-relative
  std::optional<std::string> true_height_field{};  ///< study-relative; of procedural textures
  /// Role → study-relative path, of roles that force models declare (AssetDeclaration).
  std::map<std::string, std::string, std::less<>> assets{};
  std::optional<double> spacing_m{};     ///< distance of its elements
  std::optional<ForceFeatures> prior{};  ///< expectation if there is no true height field
  std::string note{};
};

/// A request to equalise the texture force, see renderers/offline/force_matching.h.
struct EqualForce {
  std::optional<double> rms_N{};  ///< a stated target, or else
  std::string to_model{};         ///< the texture force of this model with the same texture
  double band_low_Hz = 5.0;
  double band_high_Hz = 500.0;

  bool operator==(const EqualForce&) const = default;
};

/// A stimulus in which values may be bound to factors.
struct StimulusTemplate {
  std::string name{};
  Binding<std::string> model{};
  Binding<std::string> texture{};  ///< neither value nor factor: no texture is used
  Binding<std::string>
      surface{};  ///< a body: of a model that needs bodies, or of a point model without a tool
  Binding<std::string> tool{};  ///< a body, for models that need bodies
  std::map<std::string, Binding<ParameterValue>, std::less<>> parameters{};
  std::optional<EqualForce> equal_force{};
  /// In place of those of the protocol's material.
  std::optional<double> stiffness_N_per_m{};
  std::optional<double> friction{};
};

/// All valid names in `Protocol::speech`: "surface_1" … "surface_26", "option_1" … "option_26" and the cues without a
/// number.
std::vector<std::string> speech_cues();

using Level = std::variant<double, std::string>;
std::string text_of(const Level& level);

struct Factor {
  std::string name{};
  std::string meaning{};
  std::string unit{};
  std::vector<Level> levels{};
  std::map<std::string, std::string> hed{};  ///< level → its HED tags
};

/// The judgement model of a virtual participant; see virtual_observer.h.
struct ObserverDeclaration {
  enum class Expectation {
    none,          ///< realism and identity are not simulated: responses are flagged guesses
    true_surface,  ///< features of the textures' true height fields, rendered on another stroke
    prior,         ///< features stated in the protocol (Texture::prior)
  };
  Expectation expectation = Expectation::none;
  /// With true_surface: the expectation is computed from the true surface without its longer waves, filtered by the
  /// Gaussian of a height field from a photograph (TextureRecipe). Absent: from the complete surface.
  std::optional<double> gaussian_wavelength_m{};
  bool deaf = false;           ///< ignores the forces; uniform responses over the open options
  double feature_noise = 0.1;  ///< standard deviation added to every feature
  double position_bias = 0.0;  ///< added to the evidence of the first position
  double lapse = 0.02;         ///< probability of a guess
  /// The quantity that is judged.
  enum class MagnitudeOf {
    lateral_force,  ///< as a fraction of the mean normal force
    normal_force,   ///< as a fraction of the mean normal force
    held_tool,      ///< the vibration of a held tool (ForceFeatures::shaking_m_per_s2)
    compliance,     ///< how far the surface yields (ForceFeatures::compliance_m_per_N)
  };
  MagnitudeOf magnitude_of = MagnitudeOf::lateral_force;
  MagnitudeObserver magnitude{};
  DiscriminationObserver discrimination{};
};

/// The text in a protocol file and in the store.
const char* text_of(ObserverDeclaration::MagnitudeOf what) noexcept;

/// Stores the contents of a protocol file. Always valid: only `read_protocol` makes one.
struct Protocol {
  /// The id of an ExperimentKind (protocols/kinds/experiment_kind.h): that of every block without its own.
  std::string kind = "selection";
  ProtocolDesign design = ProtocolDesign::chapter;
  std::string name{};
  std::string version{};
  std::string title{};
  std::string language =
      "en";  ///< of its texts, a BCP 47 tag; also of the program's participant texts
  std::string description{};
  std::vector<std::string> authors{};
  std::string license{};
  std::string consent_version{};
  std::string consent_statement{};
  int planned_participants = 0;
  int sessions = 1;                                   ///< per participant
  std::vector<std::string> participant_questions{};   ///< asked once, before the first session
  std::optional<RealismStandard> realism_standard{};  ///< of a selection
  std::optional<EstimationDeclaration> estimation{};  ///< of a magnitude

  Vision vision = Vision::free;
  std::optional<VisualTexture> scene{};  ///< shown during exploration; absent: nothing is shown
  bool shows_pictures_in_grey = false;
  /// Masking noise over headphones, so that the device is not heard.
  struct Noise {
    enum class Kind { none, white, pink };
    Kind kind = Kind::none;
    std::optional<double> level_dBA{};  ///< at the ear; required for every noise
  };
  Noise masking_noise{};
  /// Recorded speech that replaces tones: the cue ("surface_1", "question"; see `speech_cues`) → a study-relative WAV
  /// file.
  std::map<std::string, std::string, std::less<>> speech{};

  double rate_Hz = 1000.0;
  double force_limit_N = 5.0;
  int maximum_missed_deadlines = 50;  ///< in contact, per attempt; more make the attempt invalid
  int maximum_gaps_in_contact = 50;   ///< of more than two periods between ticks, per attempt
  int maximum_lost_records = 0;
  std::optional<InstabilityRule> instability{};
  /// Maximum age of the device's profile for a session with a participant; absent: no profile is needed.
  std::optional<double> profile_maximum_age_days{};
  bool refuses_rehearsal_warnings = false;  ///< of unrenderable stimuli and unmet device limits
  /// Contacts of two textured bodies are evaluated on a compute device instead of the processor.
  bool computes_on_gpu = false;
  bool input_only = false;  ///< participants' study data may come from a device without motors
  /// The device's item ("lateness_p99_s") → its limit; the item determines the permitted side.
  std::map<std::string, double> device_limits{};

  SurfacePatch patch{};
  Material material{};
  std::map<std::string, Texture, std::less<>> textures{};
  /// Without paths of height fields: the textures have those.
  std::map<std::string, BodyDescription, std::less<>> bodies{};
  std::map<std::string, StimulusTemplate, std::less<>> stimuli{};
  std::map<std::string, Factor, std::less<>> factors{};
  std::map<std::string, Exploration, std::less<>> explorations{};
  std::map<std::string, Question, std::less<>> questions{};

  /// Blocks and flow, the input of the planner.
  struct Presented {
    std::string role{};                                ///< "alternative", "target"
    std::string stimulus{};                            ///< a StimulusTemplate
    std::map<std::string, Level, std::less<>> with{};  ///< factors fixed for this presentation
    /// The item that it counts as in the responses; empty: the model (selection) or texture shown.
    std::string item{};
  };
  /// A question of the trials of a block. Its form is that of the kind of its block, unless the file states another; its
  /// options are those in words.
  struct TrialQuestionTemplate : Question {
    /// The options are words, pictures of these textures, or otherwise the felt alternatives.
    std::vector<std::string> pictures{};
    bool reshuffle_pictures = false;  ///< for every trial; otherwise once per session
    bool allow_cannot_tell = false;
    /// What only the question of one kind of experiment states.
    std::variant<std::monostate, DiscriminationQuestion, ConfidenceRating, RecognitionQuestion,
                 PairQuestion, SimilarityQuestion>
        own{};
    /// Null where the question states nothing of this kind.
    template <class Own>
    const Own* own_as() const noexcept {
      return std::get_if<Own>(&own);
    }
    /// Of a discrimination.
    std::optional<DiscriminationJudgement> judgement() const noexcept {
      const auto* const asked = own_as<DiscriminationQuestion>();
      return asked == nullptr ? std::nullopt : asked->judgement;
    }
    /// The factor whose level is the correct option; empty where the kind determines the correct response.
    std::string correct_factor() const {
      const auto* const asked = own_as<RecognitionQuestion>();
      return asked == nullptr ? std::string() : asked->correct_factor;
    }
    /// Of a scale in a block of a discrimination: the question whose response it rates the confidence of; empty: none.
    std::string confidence_of() const {
      const auto* const rating = own_as<ConfidenceRating>();
      return rating == nullptr ? std::string() : rating->of;
    }
    bool asks_for_less() const noexcept {
      const auto* const asked = own_as<DiscriminationQuestion>();
      return asked != nullptr && asked->asks_for == DiscriminationQuestion::AsksFor::less;
    }
  };
  /// Practice: the block ends when `correct` of the last `of_last` responses were correct, or after `maximum_trials`,
  /// the number of planned trials.
  struct Criterion {
    int correct = 0;
    int of_last = 0;
    int maximum_trials = 0;
    enum class OnFailure { continue_flagged, end_session } on_failure = OnFailure::continue_flagged;
  };
  struct Block {
    enum class Order { fixed, shuffle, shuffle_within_repetition };
    enum class Positions { as_listed, shuffle, balanced };
    /// Every pair of levels of a factor is a trial: one stimulus is presented with both, and each level names its
    /// surface.
    struct AllPairs {
      std::string factor{};
      bool in_both_orders = false;  ///< each pair twice, with either level first
      bool with_identical = false;  ///< each level also with itself, once
      /// Each participant is given one of so many parts of the pairs of different levels, in which levels occur equally
      /// often as far as possible. The counterbalancing row determines the part.
      int parts = 1;
    };
    /// What chooses the levels of `vary` from the answers.
    struct LevelProcedure {
      /// Of the tracks that every combination of the other factors has; levels are as `vary` states them.
      std::vector<ProcedureSettings> tracks{};
      /// A missed deadline counts as an incorrect response; otherwise the level is presented again in another trial.
      bool timeouts_are_incorrect = false;
      /// Trials with a known response at random places among the others: one in every `every` trials of the block. They
      /// belong to no track and no threshold is estimated from them.
      struct CatchTrials {
        CatchType type = CatchType::easy;
        /// Of the type easy, as `vary` states levels; it need not be one of them. Of the others that of the standard.
        double level = 0.0;
        int every = 0;  ///< at least 2
      };
      std::optional<CatchTrials> catch_trials{};
    };
    /// The surfaces are presented at the amplitudes at which they were as rough as the reference of another block, for
    /// this participant (RoughnessMatch).
    struct EqualRoughness {
      std::string matched_in{};  ///< the block, whose procedure varies the relative amplitude
    };
    std::string name{};
    std::string kind{};  ///< the id of an ExperimentKind: its own, or that of the protocol
    Phase phase = Phase::main;
    /// What only blocks of one kind of experiment state.
    std::variant<std::monostate, DiscriminationBlock> own{};
    /// Of a discrimination; that of a block that states none.
    const DiscriminationDesign* design() const noexcept {
      const auto* const stated = std::get_if<DiscriminationBlock>(&own);
      return stated == nullptr ? &two_alternatives() : stated->design;
    }
    std::vector<std::string> crossed{};                               ///< factors, or
    std::vector<std::map<std::string, Level, std::less<>>> listed{};  ///< rows
    std::optional<Dimension>
        vary{};  ///< in combination with every row, unless there is a procedure
    std::optional<LevelProcedure> procedure{};
    /// In combination with every row; `presented` has the stimulus twice.
    std::optional<AllPairs> all_pairs{};
    /// Combinations of crossed and varied levels that are left out: those with all levels of an entry.
    std::vector<std::map<std::string, Level, std::less<>>> exclude{};
    /// Factors whose level in every row is computed from its other levels, by a formula (Arithmetic).
    std::map<std::string, std::string, std::less<>> derived{};
    int repetitions = 1;
    /// The rows with all of these levels have another number of repetitions.
    struct RowRepetitions {
      std::map<std::string, Level, std::less<>> levels{};
      int repetitions = 1;
    };
    std::vector<RowRepetitions> repetitions_of{};
    /// Factors drawn for every trial (balanced over the block as far as possible).
    std::vector<std::string> drawn{};
    /// The levels of the anchors, the reference trials of every run of the block: of every factor that its trials set, of
    /// `vary` as stated there. No analysis contains their responses. Empty without anchors.
    std::map<std::string, Level, std::less<>> anchor{};
    std::vector<Level> anchor_pair{};  ///< with `all_pairs`: the two levels of an anchor
    std::vector<AnchorPlace> anchor_places{AnchorPlace::start};  ///< in order, each once
    bool has_anchors() const noexcept { return !anchor.empty() || !anchor_pair.empty(); }
    bool has_anchor_at(AnchorPlace place) const noexcept {
      return has_anchors() &&
             std::find(anchor_places.begin(), anchor_places.end(), place) != anchor_places.end();
    }
    Order order = Order::shuffle;
    std::map<std::string, int, std::less<>> maximum_in_a_row{};
    /// Of two trials with the same level of the factor: the smallest difference of their positions.
    std::map<std::string, int, std::less<>> minimum_distance{};
    /// The trial at a position of the block, from 1, has all of these levels.
    struct FixedPosition {
      int position = 1;
      std::map<std::string, Level, std::less<>> levels{};
    };
    std::vector<FixedPosition> fixed_positions{};
    std::vector<Presented> presented{};
    Positions positions = Positions::as_listed;
    std::vector<TrialQuestionTemplate> questions{};  ///< of every trial; at least one
    bool has_question_list = false;     ///< the file has the key "questions" instead of "question"
    bool shuffles_questions = false;    ///< for every trial
    bool on_one_page = false;           ///< all questions are shown together
    std::string page_prompt{};          ///< shown above them
    std::string experimenter_prompt{};  ///< "{code}" stands for the code of the trial's texture
    bool pictures_after_feeling = false;  ///< hidden until all surfaces were felt (an eye mask)
    Arrangement arrangement{};
    Roving rove{};
    std::optional<EqualRoughness> equal_roughness{};
    Binding<std::string> exploration{};
    double pause_before_trial_s = 0.5;
    double pause_between_surfaces_s = 0.5;
    std::optional<double> response_deadline_s{};
    enum class Feedback { none, correctness, correct_answer } feedback = Feedback::none;
    std::optional<Criterion> until{};
  };
  struct Screen {
    std::string text{};
    std::optional<AnswerCondition> condition{};  ///< shown only if it is met; absent: always shown
    std::vector<std::string> groups{};  ///< only these participants read it (groups_of); empty: all
  };
  struct Check {
    enum class What { device, force_zero } what = What::device;
  };
  struct Break {
    double minimum_s = 0.0;
    std::string text{};
    bool zero_force = true;
    /// Before the participant rests: the reading of the device is recorded while nothing moves it and no force is sent.
    struct DriftCheck {
      std::string text{};  ///< asks the experimenter to have the handle released
      std::string
          tip_text{};  ///< asks for the tip to be held at a reference point; empty: no such check
      double duration_s = 2.0;  ///< of each recording
    };
    std::optional<DriftCheck> drift_check{};
  };
  struct Run {
    std::string block{};
    std::string for_each{};  ///< a factor iterated outside the block, in a counterbalanced order
    int break_every_trials = 0;  ///< 0: none within the block
    /// Between two trials, once surfaces were in contact for so long since the last break of the session or since the
    /// session was begun or resumed; 0: none. The plan does not contain these breaks.
    double break_every_contact_s = 0.0;
    /// After that many trials, after that much contact, and between the levels of `for_each`.
    std::optional<Break> pause{};
  };
  struct Ask {
    std::vector<std::string> questions{};
  };
  using Step = std::variant<Screen, Check, Break, Run, Ask>;
  enum class Counterbalance { none, latin, williams };
  Counterbalance counterbalance = Counterbalance::none;
  /// A between-participants factor: every trial of a participant has the level of the participant's group.
  struct Groups {
    static constexpr std::size_t kMost = 32;
    enum class Assignment {
      balanced,         ///< by the program: the group with the fewest participants
      permuted_blocks,  ///< by the program: blocks of random size in random order
      by_experimenter,  ///< stated when the participant's first session begins
    };
    std::string factor{};
    Assignment assigned = Assignment::balanced;
    /// Of permuted blocks: the possible sizes, multiples of the number of groups, and the seed of the sequence.
    std::vector<int> block_sizes{};
    std::optional<std::uint64_t> seed{};
  };
  std::optional<Groups> groups{};
  std::map<std::string, Block, std::less<>> blocks{};
  std::vector<Step> flow{};
  /// How an interrupted session is resumed.
  struct Resume {
    /// The text for the participant; absent: the last text before the interruption.
    std::optional<std::vector<std::string>> screens{};
    /// Since the session last ran; an older one is resumed only with a stated reason.
    std::optional<double> maximum_age_hours{};
    /// The first so many trials of the latest practice are made again (AttemptPurpose::refresher).
    int practice_trials = 0;
  };
  Resume resume{};
  ObserverDeclaration observer{};
  bool record = true;  ///< every tick of every attempt
  AnalysisDeclaration analysis{};

  std::string source{};  ///< the file, byte for byte
};

/// Those that are asked once, before the first session.
std::vector<Question> questions_about_participant(const Protocol& protocol);

/// The text in a protocol file.
const char* text_of(Protocol::Groups::Assignment assigned) noexcept;
const char* text_of(Protocol::Noise::Kind kind) noexcept;

}  // namespace asperity
