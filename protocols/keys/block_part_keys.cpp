// Defines the keys of the objects in a block: its surfaces, their arrangement, its pairs, repetitions and criterion.

#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using Block = Protocol::Block;
using Criterion = Protocol::Criterion;
using nlohmann::json;

constexpr NumberShape kCount{.minimum = 1.0, .maximum = 10'000.0, .is_whole = true};
constexpr NumberShape kSeconds{.minimum = 0.0, .maximum = 600.0, .unit = "s"};
constexpr MapShape kLevels{.entry = &kLevelShape, .meaning = kLevelMeaning, .key = kFactorName};

constexpr auto kOnFailures = words_of<Criterion::OnFailure>(
    {{"continue_flagged", Criterion::OnFailure::continue_flagged, "the session continues, flagged"},
     {"end_session", Criterion::OnFailure::end_session, "the session ends"}});

constexpr auto kCriterionKeys = keys_of(
    required_key(member_key<&Criterion::correct>("correct", "Correct responses",
                                                 "Number of correct responses required.", kCount)),
    required_key(member_key<&Criterion::of_last>(
        "of_last", "Responses considered", "Number of most recent responses that are considered.",
        kCount)),
    required_key(member_key<&Criterion::maximum_trials>(
        "maximum_trials", "Maximum number of trials",
        "Number of trials after which the block ends even if the criterion is not met.", kCount)),
    member_key<&Criterion::on_failure>("on_failure", "Consequence of failure",
                                       "Consequence if the criterion is not met.", kOnFailures));

constexpr ValueShape kStiffnessLevel = kStiffness;
constexpr ValueShape kFrictionLevel = kFriction;
constexpr ValueShape kHeightLevel =
    NumberShape{.minimum = -0.02, .maximum = 0.02, .unit = "m", .display = kMillimetres};

constexpr auto kRovingKeys = keys_of(
    member_key<&Roving::stiffness_N_per_m>(
        "stiffness_N_per_m", "Stiffness", "Levels of the stiffness.",
        ListShape{.entry = &kStiffnessLevel, .meaning = "A level.", .shortest = 1, .longest = 256}),
    member_key<&Roving::friction>(
        "friction", "Friction", "Levels of the Coulomb friction coefficient.",
        ListShape{.entry = &kFrictionLevel, .meaning = "A level.", .shortest = 1, .longest = 256}),
    member_key<&Roving::raised_m>(
        "raised_m", "Height",
        "Levels of the height of the surface's plane above that of the workspace.",
        ListShape{.entry = &kHeightLevel, .meaning = "A level.", .shortest = 1, .longest = 256}));

using DrawnInterval = Arrangement::Interval;
constexpr NumberShape kLimitOfInterval{
    .minimum = 0.0, .maximum = 600.0, .display = {.unit = "s", .power = 0}};
constexpr auto kIntervalKeys =
    keys_of(required_key(member_key<&DrawnInterval::shortest_s>(
                "shortest", "Shortest interval", "The lower limit.", kLimitOfInterval)),
            required_key(member_key<&DrawnInterval::longest_s>(
                "longest", "Longest interval", "The upper limit.", kLimitOfInterval)));

constexpr ValueShape kFixedInterval = kSeconds;
constexpr std::array kIntervalForms{kFixedInterval, kObjectOf<kIntervalTable>};

void store_interval(const json& value, Arrangement& arrangement) {
  DrawnInterval& interval = arrangement.interval.emplace();
  if (value.is_object()) {
    read_keys(kIntervalTable, value, &interval);
  } else {
    interval.shortest_s = interval.longest_s = value.get<double>();
  }
}

constexpr auto kVisitsKeys = keys_of(
    member_key<&Arrangement::minimum_visits>(
        "minimum", "Minimum",
        "Visits to each surface before a response is possible. In a sequence the surfaces are "
        "presented this number of times: A B, A B A B and so on.",
        NumberShape{.minimum = 1.0, .maximum = 20.0, .is_whole = true}),
    member_key<&Arrangement::maximum_visits>(
        "maximum", "Maximum",
        "Maximum number of visits to each surface, including those on request; absent: no limit.",
        NumberShape{.minimum = 1.0, .maximum = 1000.0, .is_whole = true}));

constexpr auto kExposureKeys =
    keys_of(member_key<&Arrangement::strokes>(
                "strokes", "Strokes", "Strokes in each visit.",
                NumberShape{.minimum = 1.0, .maximum = 100.0, .is_whole = true}),
            when(member_key<&Arrangement::contact_s>(
                     "contact_s", "Contact time", "Contact time of each visit.",
                     NumberShape{.above = 0.0, .maximum = 600.0, .unit = "s"}),
                 without("strokes")));

using Surfaces = Arrangement::Surfaces;
constexpr auto kSurfaces = words_of<Surfaces>(
    {{"sequential", Surfaces::sequential, "one after the other, in the order of the trial"},
     {"side_by_side", Surfaces::side_by_side,
      "2 to 4 surfaces at once, as patches of the workspace"},
     {"on_request", Surfaces::on_request,
      "one at a time, in any order that the participant chooses"}});
constexpr auto kPatchAxes = words_of<Arrangement::Axis>(
    {{"x", Arrangement::Axis::x, "along x"}, {"y", Arrangement::Axis::y, "along y"}});
constexpr auto kPhases = words_of<bool>(
    {{"fixed", false, "a texture always has the same place on its surface"},
     {"drawn", true,
      "the point of the texture at the centre of the surface is drawn for every presentation"}});

constexpr KeyCondition kNotSideBySide{"surfaces", {kAbsent, "sequential", "on_request"}};

constexpr auto kArrangementKeys = keys_of(
    listing_words(member_key<&Arrangement::surfaces>(
        "surfaces", "Presentation", "How the surfaces of a trial are presented.", kSurfaces)),
    inner_key("visits", "Visits", kVisitsTable),
    when(custom_key<&store_interval>(
             "interval_s", "Inter-stimulus interval",
             "The inter-stimulus interval, from the last contact with a surface to the permission "
             "to touch the next: a time, or the limits between which it is drawn for every "
             "interval. It replaces the pause between surfaces.",
             FormsShape{kIntervalForms}),
         reported_as("patches are presented together, without an interval; remove this key",
                     kNotSideBySide)),
    when(inner_key("exposure", "Exposure", kExposureTable),
         reported_as(
             "the participant divides the time among patches; remove this key, and state visits "
             "and the contact time of the exploration",
             kNotSideBySide)),
    when(member_key<&Arrangement::gap_m>(
             "gap_m", "Gap",
             "Side by side: the width of the flat surface between two patches, with the stiffness "
             "and the friction of the material.",
             NumberShape{.minimum = 0.005, .maximum = 0.1, .unit = "m", .display = kMillimetres}),
         where("surfaces", {"side_by_side"})),
    when(member_key<&Arrangement::axis>("axis", "Axis",
                                        "Side by side: the axis of the workspace along which the "
                                        "patches lie, in the order of the trial.",
                                        kPatchAxes),
         where("surfaces", {"side_by_side"})),
    listing_words(member_key<&Arrangement::draws_phase>(
        "phase", "Phase of the texture", "Place of a texture on its surface.", kPhases)));

constexpr auto kAllPairsKeys = keys_of(
    required_key(member_key<&Block::AllPairs::factor>(
        "factor", "Factor", "The factor whose levels are paired.",
        NameShape{.registry = kFactorNames, .governs_levels = true})),
    member_key<&Block::AllPairs::in_both_orders>(
        "in_both_orders", "Both orders",
        "Whether every pair is presented twice, with either level first. Otherwise it is presented "
        "once, and its order is that of the surfaces within a trial.",
        TruthShape{}),
    when(member_key<&Block::AllPairs::with_identical>(
             "with_identical", "Identical pairs",
             "Similarity: whether each level is also paired with itself, once.", TruthShape{}),
         of_kinds({"similarity"})),
    when(member_key<&Block::AllPairs::parts>(
             "parts", "Parts of the pairs",
             "Similarity: the number of parts into which the pairs of different levels are "
             "divided; each participant is given one part, in which all levels occur equally often "
             "as far as possible. 1: every participant is given all pairs.",
             NumberShape{.minimum = 1.0, .maximum = 256.0, .is_whole = true}),
         of_kinds({"similarity"})));

constexpr auto kEqualRoughnessKeys =
    keys_of(required_key(member_key<&Block::EqualRoughness::matched_in>(
        "matched_in", "Matching block",
        "The block that matches the surfaces: a discrimination with the judgement comparison whose "
        "procedure varies the relative amplitude.",
        NameShape{"blocks"})));

constexpr auto kRowRepetitionsKeys =
    keys_of(required_key(member_key<&Block::RowRepetitions::levels>(
                "levels", "Levels", "Factor and level.", kSomeLevels)),
            required_key(member_key<&Block::RowRepetitions::repetitions>(
                "repetitions", "Repetitions", "Repetitions of these trials.", kCount)));

constexpr auto kFixedPositionKeys =
    keys_of(required_key(member_key<&Block::FixedPosition::position>(
                "position", "Position", "Position in every run of the block, from 1.", kCount)),
            required_key(member_key<&Block::FixedPosition::levels>(
                "levels", "Levels", "Factor and level.", kSomeLevels)));

constexpr std::array<KeyWord, 4> kRoles{{{"alternative", 0, "one that can be chosen"},
                                         {"target", 0, "the judged surface"},
                                         {"standard", 0, "the standard"},
                                         {"comparison", 0, "the comparison"}}};

constexpr auto kPresentedKeys =
    keys_of(member_key<&Protocol::Presented::role>(
                "role", "Role",
                "Role of the surface, determined by the kind: alternative in a selection and a "
                "paired comparison, standard or comparison in a discrimination, target otherwise.",
                WordShape{kRoles}),
            required_key(member_key<&Protocol::Presented::stimulus>(
                "stimulus", "Stimulus", "The name of the stimulus.", NameShape{"stimuli"})),
            member_key<&Protocol::Presented::with>("with", "Fixed factors",
                                                   "Factors fixed for this surface.", kLevels),
            member_key<&Protocol::Presented::item>(
                "item", "Item",
                "Name of the surface in the responses, if the model (selection) or the texture "
                "does not distinguish the surfaces.",
                NameShape{.registry = kItemNames, .is_declared = true}));

}  // namespace

constexpr KeyTableOf<Criterion> kCriterionTable = table_of(
    "Practice to a criterion: the block ends when at least `correct` of the last `of_last` "
    "responses are correct.",
    kCriterionKeys);

constexpr KeyTableOf<Roving> kRovingTable = table_of(
    "Irrelevant quantities that vary at random between presentations: each presentation has one of "
    "the levels.",
    kRovingKeys);

constexpr KeyTableOf<Arrangement> kArrangementTable =
    table_of("How the surfaces of a trial are presented.", kArrangementKeys);

constexpr KeyTableOf<Arrangement> kVisitsTable = table_of("Visits to each surface.", kVisitsKeys);

constexpr KeyTableOf<DrawnInterval> kIntervalTable =
    table_of("The limits between which an interval is drawn.", kIntervalKeys);

constexpr KeyTableOf<Arrangement> kExposureTable = table_of(
    "The end of every visit, the same for all surfaces: a number of strokes or a contact time. "
    "Absent: the participant ends it, within the limits of the exploration.",
    kExposureKeys);

constexpr KeyTableOf<Block::AllPairs> kAllPairsTable = table_of(
    "Every pair of levels of a factor is a trial, in combination with crossed or listed factors: "
    "one stimulus is presented with both levels, and the level is the name of its surface in the "
    "responses.",
    kAllPairsKeys);

constexpr KeyTableOf<Block::EqualRoughness> kEqualRoughnessTable = table_of(
    "The surfaces are presented at the amplitudes at which the participant judged them as rough as "
    "the reference of another block, which is run before.",
    kEqualRoughnessKeys);

constexpr KeyTableOf<Block::RowRepetitions> kRowRepetitionsTable = table_of(
    "The trials with all of these levels, and their number of repetitions.", kRowRepetitionsKeys);

constexpr KeyTableOf<Block::FixedPosition> kFixedPositionTable =
    table_of("A position and the levels of its trial.", kFixedPositionKeys);

constexpr KeyTableOf<Protocol::Presented> kPresentedTable =
    table_of("One surface.", kPresentedKeys);

}  // namespace asperity
