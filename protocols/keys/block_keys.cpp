// Defines the keys of a block.

#include <algorithm>
#include <string>

#include "protocols/keys/revisit_key.h"
#include "protocols/keys/tables.h"
#include "protocols/kind_keys/discrimination_keys.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using Block = Protocol::Block;
using nlohmann::json;

constexpr NumberShape kRepetitions{.minimum = 1.0, .maximum = 10'000.0, .is_whole = true};
constexpr NumberShape kPause{.minimum = 0.0, .maximum = 600.0, .unit = "s"};
constexpr ValueShape kFactorEntry = kFactorName;
constexpr ListShape kFactors{
    .entry = &kFactorEntry, .meaning = kNameMeaning, .shortest = 1, .longest = 256};
constexpr ValueShape kRow = kSomeLevels;
constexpr ValueShape kFormula = TextShape{.name = kFactorName, .is_formula = true};
constexpr ValueShape kExplorationName = NameShape{"explorations"};
constexpr ValueShape kTrialsInARow = kRepetitions;
constexpr ValueShape kDistance = NumberShape{.minimum = 2.0, .maximum = 10'000.0, .is_whole = true};

constexpr auto kPhasesOfStudy =
    words_of<Phase>({{"familiarisation", Phase::familiarisation, "not analysed"},
                     {"practice", Phase::practice, "not analysed"},
                     {"main", Phase::main, "analysed"}});
constexpr auto kOrders =
    words_of<Block::Order>({{"fixed", Block::Order::fixed, "as written"},
                            {"shuffle", Block::Order::shuffle, "all trials in random order"},
                            {"shuffle_within_repetition", Block::Order::shuffle_within_repetition,
                             "each repetition is completed before the next"}});
constexpr auto kPositions = words_of<Block::Positions>(
    {{"as_listed", Block::Positions::as_listed, "as listed"},
     {"shuffle", Block::Positions::shuffle, "in random order"},
     {"balanced", Block::Positions::balanced, "every item in every position equally often"}});
constexpr auto kQuestionOrders = words_of<bool>(
    {{"fixed", false, "as written"}, {"shuffle", true, "in a new random order in every trial"}});
constexpr auto kLayouts =
    words_of<bool>({{"one_after_another", false, "every question has a separate page"},
                    {"one_page", true, "all questions are shown together"}});
using Feedback = Block::Feedback;
constexpr auto kFeedbacks =
    words_of<Feedback>({{"none", Feedback::none, "no feedback"},
                        {"correctness", Feedback::correctness, "whether the response is correct"},
                        {"correct_answer", Feedback::correct_answer, "the correct response"}});

constexpr auto kPlaces =
    words_of<AnchorPlace>({{"start", AnchorPlace::start, "before the trials"},
                           {"middle", AnchorPlace::middle, "after half of the trials"},
                           {"end", AnchorPlace::end, "after the trials"}});
constexpr ValueShape kPlace = WordShape{kPlaces.words};
constexpr ListShape kPlaceList{.entry = &kPlace, .shortest = 1, .longest = 3, .is_distinct = true};

void store_anchor_places(const json& value, Block& block) {
  block.anchor_places.clear();
  store_value(kPlaceList, value, block.anchor_places);
  std::sort(block.anchor_places.begin(), block.anchor_places.end());
}

/// Its settings depend on the dimension and the design of the block: procedure_in (levels_from_json.h) reads it.
void ignore_procedure(const json&, Block&) {}

constexpr ListShape kQuestionList{
    .entry = &kObjectOf<kListedQuestionTable>, .shortest = 1, .longest = 12};
void store_questions(const json& value, Block& block) {
  block.has_question_list = true;
  block.questions.clear();
  store_value(kQuestionList, value, block.questions);
}

/// It replaces "allow_revisit".
void store_arrangement(const json& value, Block& block) {
  block.arrangement = {};
  read_keys(kArrangementTable, value, &block.arrangement);
}

constexpr KeyCondition kWithoutVary = reported_as(
    "the levels of vary are presented equally often; remove this key, or list the levels as a "
    "crossed factor",
    without("vary"));
/// Of an anchor, whose response would count for the criterion.
constexpr KeyCondition kWithoutCriterion = reported_as(
    "a block that ends at a criterion has no anchors, because they do not count for it; remove "
    "this key, or \"until\"",
    without("until"));

auto& own_of_block(void* block) { return static_cast<Block*>(block)->own; }

constexpr auto kDesignKeys = keys_of(
    with_computed_default(
        member_key<&Block::kind>(
            "kind", "Kind",
            "The kind of experiment of this block, if it differs from that of the protocol.",
            WordShape{kKinds}),
        "that of the protocol"),
    member_key<&Block::phase>(
        "phase", "Phase", "Purpose of the trials. Only main trials are analysed.", kPhasesOfStudy),
    member_key<&Block::crossed>("crossed", "Crossed factors",
                                "Factors whose levels are all combined.", kFactors),
    when(member_key<&Block::listed>("listed", "Listed trials",
                                    "List of trials, each with a level of the same factors; an "
                                    "alternative to crossed factors.",
                                    ListShape{.entry = &kRow,
                                              .meaning = "One trial: factor and level.",
                                              .shortest = 1,
                                              .longest = 4096}),
         without("crossed")),
    member_key<&Block::exclude>("exclude", "Excluded combinations",
                                "Combinations of crossed or varied levels that are left out: those "
                                "with all levels of an entry.",
                                ListShape{.entry = &kRow,
                                          .meaning = "One combination: factor and level.",
                                          .shortest = 1,
                                          .longest = 4096}),
    member_key<&Block::derived>("derived", "Derived factors",
                                "Factors whose level in every trial is computed from levels that "
                                "the block crosses, lists or varies: name and formula.",
                                MapShape{.entry = &kFormula,
                                         .meaning = "A formula of numbers, factors, +, -, *, / and "
                                                    "parentheses, such as speed / spacing.",
                                         .key = {.registry = kFactorNames, .is_declared = true},
                                         .shortest = 1}),
    when(list_key<&Block::repetitions_of, kRowRepetitionsTable>(
             "repetitions_of", "Repetitions of some trials",
             "Numbers of repetitions of some trials, in place of that of the block.",
             {.shortest = 1, .longest = 256}),
         kWithoutVary),
    when(member_key<&Block::all_pairs>("all_pairs", "All pairs", kAllPairsTable), kWithPairs),
    member_key<&Block::vary>("vary", "Varied parameter", kDimensionTable),
    when(custom_key<&ignore_procedure>("procedure", "Procedure", "", ObjectShape{&kProcedureTable}),
         of_kinds({"discrimination"}), with("vary")));

constexpr auto kOrderKeys = keys_of(
    member_key<&Block::repetitions>("repetitions", "Repetitions",
                                    "Number of repetitions of the combinations or rows.",
                                    kRepetitions),
    member_key<&Block::drawn>("drawn", "Drawn factors",
                              "Factors drawn at random on every trial, each level equally often "
                              "over the block as far as possible.",
                              kFactors),
    when(member_key<&Block::anchor>(
             "anchor", "Anchor",
             "Anchors, reference trials of every run of the block whose responses are stored and "
             "not analysed: factor and level. The level of the varied parameter is stated in the "
             "measure of its levels.",
             kSomeLevels),
         kWithoutCriterion),
    when(member_key<&Block::anchor_pair>(
             "anchor_pair", "Levels of the anchor", "The levels of the two surfaces of an anchor.",
             ListShape{
                 .entry = &kLevelShape, .meaning = kLevelMeaning, .shortest = 2, .longest = 2}),
         with("all_pairs"), kWithoutCriterion),
    with_standard(custom_key<&store_anchor_places>(
                      "anchor_at", "Places of the anchors",
                      "Places of the anchors in every run of the block: before its trials, after "
                      "half of them (of a procedure: of its largest number of trials, if it is "
                      "reached), and after them.",
                      kPlaceList),
                  [](const ProtocolKey&) { return json::array({"start"}); }),
    listing_words(member_key<&Block::order>("order", "Order", "Order of the trials.", kOrders)),
    member_key<&Block::maximum_in_a_row>(
        "maximum_in_a_row", "Longest run of a level",
        "For a factor: largest number of consecutive trials with the same level.",
        MapShape{.entry = &kTrialsInARow, .meaning = "Trials in a row.", .key = kFactorName}),
    member_key<&Block::minimum_distance>(
        "minimum_distance", "Smallest distance of a level",
        "For a factor: smallest difference of the positions of two trials with the same level; 2 "
        "excludes adjacent trials.",
        MapShape{.entry = &kDistance, .meaning = "Difference of positions.", .key = kFactorName}),
    list_key<&Block::fixed_positions, kFixedPositionTable>(
        "fixed_positions", "Fixed positions", "Positions whose trial has certain levels.",
        {.shortest = 1, .longest = 256}),
    required_key(list_key<&Block::presented, kPresentedTable>(
        "presented", "Surfaces", "The surfaces of one trial.", {.shortest = 1, .longest = 8})),
    member_key<&Block::positions>(
        "positions", "Order of the surfaces",
        "Order of the surfaces within a trial. A balanced order has every item in every position "
        "equally often over the block; in a choice between surfaces with a varied parameter and "
        "without a procedure or a criterion also within each level, if every combination of levels "
        "has a multiple of the number of surfaces as its number of trials.",
        kPositions),
    when(with_computed_default(inner_key("question", "Question", kOnlyQuestionTable),
                               "this, or several questions"),
         without("questions")),
    with_computed_default(
        custom_key<&store_questions>(
            "questions", "Questions",
            "The questions of every trial, at most 12, instead of a single question.",
            kQuestionList),
        "this, or a single question"),
    when(listing_words(member_key<&Block::shuffles_questions>(
             "question_order", "Order of the questions", "Order of the questions of a trial.",
             kQuestionOrders)),
         with("questions")),
    when(listing_words(
             member_key<&Block::on_one_page>("question_layout", "Layout of the questions",
                                             "Whether the questions are shown together, which "
                                             "requires scales with labels at the ends only.",
                                             kLayouts)),
         with("questions")),
    when(member_key<&Block::page_prompt>("page_prompt", "Text of the page",
                                         "The text above the questions of one page.",
                                         kShownParagraph),
         where("question_layout", {"one_page"})),
    when(member_key<&Block::experimenter_prompt>(
             "experimenter_prompt", "Text for the experimenter",
             "Text for the experimenter; {code} is replaced by the code of the "
             "trial's texture.",
             kParagraph),
         with("questions")),
    when(member_key<&Block::pictures_after_feeling>(
             "pictures_after_feeling", "Pictures after feeling",
             "Whether pictures stay hidden until every surface has been felt.", TruthShape{}),
         with("questions")),
    when(revisit_key(), with("questions")),
    required_key(member_key<&Block::exploration>("exploration", "Exploration",
                                                 "The name of the exploration.",
                                                 BoundShape{&kExplorationName})),
    custom_key<&store_arrangement>("arrangement", "Arrangement", "",
                                   ObjectShape{&kArrangementTable}),
    member_key<&Block::equal_roughness>("equal_roughness", "Equal roughness", kEqualRoughnessTable),
    member_key<&Block::rove>("rove", "Roving", kRovingTable),
    member_key<&Block::pause_before_trial_s>("pause_before_trial_s", "Pause before a trial",
                                             "Pause before every trial.", kPause),
    member_key<&Block::pause_between_surfaces_s>("pause_between_surfaces_s",
                                                 "Pause between surfaces",
                                                 "Pause between two surfaces.", kPause),
    member_key<&Block::response_deadline_s>(
        "response_deadline_s", "Response deadline", "Time to respond; absent: no limit.",
        NumberShape{.above = 0.0, .maximum = 3600.0, .unit = "s"}),
    member_key<&Block::feedback>("feedback", "Feedback",
                                 "Feedback to the participant after a response.", kFeedbacks),
    member_key<&Block::until>("until", "Criterion", kCriterionTable));

constexpr auto kBlockKeys = joined(
    kDesignKeys, joined(own_keys<Block, &own_of_block>(kDiscriminationBlockKeys), kOrderKeys));

}  // namespace

constexpr KeyTableOf<Block> kBlockTable =
    table_of("Trials of one kind, run together.", kBlockKeys, "block");

}  // namespace asperity
