// Defines the keys of a factor and of an exploration.

#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

constexpr ValueShape kTags = TextShape{.longest = 2000};

constexpr ValueShape kOwnText =
    TextShape{.may_be_empty = true, .name = {.registry = kLevelNames, .is_declared = true}};
constexpr std::array kOwnForms{kLevelNumber, kOwnText};
constexpr ValueShape kOwnLevel = FormsShape{kOwnForms};

constexpr auto kFactorKeys = keys_of(
    required_key(member_key<&Factor::levels>(
        "levels", "Levels", "The levels: all numbers or all names.",
        ListShape{.entry = &kOwnLevel, .meaning = kLevelMeaning, .shortest = 1, .longest = 256})),
    member_key<&Factor::meaning>("meaning", "Meaning", "Meaning of the factor, for the codebook.",
                                 kDescription),
    member_key<&Factor::unit>("unit", "Unit", "SI unit of numeric levels, such as N or m.",
                              TextShape{.longest = 40}),
    member_key<&Factor::hed>(
        "hed", "HED tags",
        "HED tags of levels, by level (hedtags.org), for the sidecars of exports.",
        MapShape{.entry = &kTags,
                 .has_names = false,
                 .key = {kLevelNames},
                 .longest_name = 200,
                 .longest = 256}));

constexpr NumberShape kContact_s{.above = 0.0, .maximum = 600.0, .unit = "s"};
constexpr NumberShape kLimit{.minimum = 0.0};

constexpr auto kBandKeys = keys_of(
    member_key<&Band::minimum>("minimum", "Lower limit", "The lower limit of the band.", kLimit),
    member_key<&Band::target>("target", "Target", "The intended value.", kLimit),
    member_key<&Band::maximum>("maximum", "Upper limit", "The upper limit of the band.", kLimit));

using OnFailure = Exploration::OnFailure;
constexpr auto kOnFailure =
    words_of<OnFailure>({{"flag", OnFailure::flag, "the trial is flagged"},
                         {"repeat_now", OnFailure::repeat_now, "the trial is repeated at once"},
                         {"requeue_at_end_of_block", OnFailure::requeue_at_end_of_block,
                          "the trial is repeated at the end of the block"}});

using Guidance = Exploration::Guidance;
constexpr auto kGuidances = words_of<Guidance>(
    {{"experimenter", Guidance::experimenter, "only the experimenter sees it"},
     {"bars", Guidance::bars, "the participant sees both quantities with their bands"},
     {"moving_target", Guidance::moving_target,
      "the participant sees a moving mark to follow, and the force with its band"},
     {"tones", Guidance::tones,
      "the participant hears nothing inside the bands, low tones below them and high tones above "
      "them"}});

constexpr double kTurn_rad = 6.283185307179586;

constexpr auto kExplorationKeys = keys_of(
    member_key<&Exploration::direction_rad>(
        "direction_rad", "Direction", "Direction of the stroke, from +x towards +y.",
        NumberShape{.minimum = -kTurn_rad,
                    .maximum = kTurn_rad,
                    .unit = "rad",
                    .display = {.unit = "°", .factor = kTurn_rad / 360.0}}),
    member_key<&Exploration::stroke_length_m>(
        "stroke_length_m", "Length of a stroke", kBandTable,
        "Length of one stroke; the mean length of the strokes on a surface has to be in the band."),
    member_key<&Exploration::speed_m_per_s>(
        "speed_m_per_s", "Speed", kBandTable,
        "Speed of a stroke: its length divided by its time, from turn to turn."),
    member_key<&Exploration::normal_force_N>(
        "normal_force_N", "Normal force", kBandTable,
        "Force normal to the surface, without the ripple of its texture."),
    member_key<&Exploration::strokes>("strokes", "Strokes", kBandTable, "Number of strokes."),
    member_key<&Exploration::minimum_contact_s>(
        "minimum_contact_s", "Minimum contact time",
        "Contact time required before a response is accepted.",
        NumberShape{.minimum = 0.0, .maximum = 600.0, .unit = "s"}),
    member_key<&Exploration::maximum_contact_s>("maximum_contact_s", "Maximum contact time",
                                                "Contact time after which the surface fades out.",
                                                kContact_s),
    member_key<&Exploration::required_fraction_in_band>(
        "required_fraction_in_band", "Fraction in the band",
        "Required fraction inside each band: of the contact time for the force, of the strokes for "
        "the speed.",
        NumberShape{.minimum = 0.0, .maximum = 1.0}),
    member_key<&Exploration::on_failure>("on_failure", "Consequence of deviations",
                                         "Consequence of an exploration outside the bands.",
                                         kOnFailure),
    member_key<&Exploration::maximum_repeats>(
        "maximum_repeats", "Maximum number of repeats", "Largest number of repeats of a trial.",
        NumberShape{.minimum = 0.0, .maximum = 10.0, .is_whole = true}),
    listing_words(member_key<&Exploration::guidance>(
        "guidance", "Guidance", "Feedback about force and speed relative to their bands.",
        kGuidances)));

}  // namespace

constexpr KeyTableOf<Factor> kFactorTable =
    table_of("A variable of trials, presentations or runs of a block.", kFactorKeys, "factor");

constexpr KeyTableOf<Exploration> kExplorationTable =
    table_of("Instructed exploration of a surface, and the consequence of deviations from it.",
             kExplorationKeys, "exploration");

constexpr KeyTableOf<Band> kBandTable = not_empty(
    table_of("A range of a quantity: a limit, a target, or several of them.", kBandKeys, "band"));

}  // namespace asperity
