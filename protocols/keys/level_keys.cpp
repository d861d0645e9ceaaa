// Defines the keys of "vary" and "procedure" of a block.

#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using nlohmann::json;
using Declaration = ProcedureDeclaration;

constexpr KeyCondition kOfUpDown{"method", {"transformed_up_down", "weighted_up_down"}};
constexpr KeyCondition kAroundUpDown =
    where_around("method", {"transformed_up_down", "weighted_up_down"});
constexpr KeyCondition kOfTracks{
    "method", {"transformed_up_down", "weighted_up_down", "psi", "quest_plus", "external"}};

constexpr ValueShape kGridLevel = NumberShape{};
constexpr NumberShape kNumber{};

constexpr auto kScales =
    words_of<LevelScale>({{"linear", LevelScale::linear, "equal differences"},
                          {"log10", LevelScale::log10, "equal differences of the logarithm"},
                          {"db", LevelScale::decibel, "decibels of an amplitude"},
                          {"ratio", LevelScale::ratio, "equal ratios"}});

constexpr auto kGridKeys = keys_of(
    required_key(member_key<&LevelGrid::lowest>("lowest", "Lowest level",
                                                "Of a grid: the lowest level.", kNumber)),
    required_key(member_key<&LevelGrid::highest>(
        "highest", "Highest level", "Of a grid: the upper limit of the levels.", kNumber)),
    required_key(member_key<&LevelGrid::step>(
        "step", "Step",
        "Of a grid: the step, in the unit of its scale; with the scale ratio, a ratio above 1.",
        kNumber)),
    member_key<&LevelGrid::scale>("scale", "Scale",
                                  "Of a grid: the scale on which its steps are equal: linear, "
                                  "log10, db (decibels of an amplitude) or ratio.",
                                  kScales));

constexpr ListShape kListOfLevels{
    .entry = &kGridLevel, .meaning = "A level.", .shortest = 1, .longest = 256};
constexpr ValueShape kLevelList = kListOfLevels;
constexpr std::array kMeasureForms{kLevelList, kObjectOf<kGridTable>};
constexpr FormsShape kLevelsOfMeasure{kMeasureForms};

void store_parameter(const json& value, Dimension& dimension) {
  dimension.factor = dimension.parameter = value.get<std::string>();
}
template <LevelMeasure measure>
void store_levels(const json& value, Dimension& dimension) {
  dimension.measure = measure;
  if (value.is_object()) {
    read_keys(kGridTable, value, &dimension.grid.emplace());
  } else {
    store_value(kListOfLevels, value, dimension.list);
  }
}

constexpr auto kDimensionKeys = keys_of(
    required_key(custom_key<&store_parameter>(
        "parameter", "Parameter",
        "The parameter of the force model, or \"relative_amplitude\": a factor by which the "
        "amplitude of the texture is multiplied, whatever the force model and whatever determines "
        "the amplitude otherwise; a standard has the value 1.",
        TextShape{.longest = 64, .pattern = "^[a-z][A-Za-z0-9_]*$"})),
    member_key<&Dimension::factor>(
        "factor", "Factor", "Name of the factor in the data; the name of the parameter by default.",
        NameShape{.registry = kFactorNames, .is_declared = true}),
    required_key(member_key<&Dimension::role>("of", "Varied surface",
                                              "Role of the surface whose parameter is varied.",
                                              NameShape{kRoleNames})),
    member_key<&Dimension::standard_role>(
        "relative_to", "Reference surface",
        "Role of the surface to which levels refer; its stimulus states the parameter, unless this "
        "is the relative amplitude.",
        NameShape{kRoleNames}),
    custom_key<&store_levels<LevelMeasure::value>>(
        "levels", "Values",
        "Values of the parameter, in its unit: a list, or a grid of equal steps.",
        kLevelsOfMeasure),
    custom_key<&store_levels<LevelMeasure::difference>>(
        "levels_difference", "Differences",
        "Differences from the standard, in the unit of the parameter: a list or a grid.",
        kLevelsOfMeasure),
    custom_key<&store_levels<LevelMeasure::percent>>(
        "levels_percent", "Differences in per cent",
        "Differences from the standard in per cent of the standard: a list or a grid.",
        kLevelsOfMeasure),
    custom_key<&store_levels<LevelMeasure::ratio>>(
        "levels_ratio", "Ratios", "Ratios to the standard: a list or a grid.", kLevelsOfMeasure),
    custom_key<&store_levels<LevelMeasure::decibels>>(
        "levels_decibels", "Decibels",
        "Levels re the standard in decibels, 20·log10 of the ratio: a list or a grid.",
        kLevelsOfMeasure));

constexpr std::array<std::string_view, 5> kMeasures{"levels", "levels_difference", "levels_percent",
                                                    "levels_ratio", "levels_decibels"};

constexpr NumberShape kTrialCount{.minimum = 1.0, .maximum = 10'000.0, .is_whole = true};
constexpr NumberShape kMoves{.minimum = 1.0, .maximum = 10.0, .is_whole = true};
constexpr ListShape kSteps{
    .entry = &kGridLevel, .meaning = "A step.", .shortest = 1, .longest = 100};

consteval auto range_keys(const NumberShape& lowest) {
  return keys_of(required_key(member_key<&ValueRange::lowest>("lowest", "Lowest value",
                                                              "Lowest value.", lowest)),
                 required_key(member_key<&ValueRange::highest>("highest", "Highest value",
                                                               "Highest value.", NumberShape{})),
                 required_key(member_key<&ValueRange::count>(
                     "count", "Number of values", "Number of values.",
                     NumberShape{.minimum = 1.0, .maximum = 1000.0, .is_whole = true})));
}
constexpr auto kRangeKeys = range_keys({.above = 0.0});
constexpr auto kLapseRangeKeys = range_keys({.minimum = 0.0});

constexpr auto kPriorKeys = keys_of(
    member_key<&Declaration::Prior::threshold>(
        "threshold", "Thresholds", kRangeTable,
        "Thresholds in steps of equal ratio, as differences of level from the standard; absent: 41 "
        "from the smallest to the greatest difference of the levels."),
    member_key<&Declaration::Prior::slope>(
        "slope", "Slopes", kRangeTable, "Slopes β in steps of equal ratio; absent: 8 from 1 to 8."),
    member_key<&Declaration::Prior::lapse>(
        "lapse", "Lapse rates", kLapseRangeTable,
        "Lapse rates in equal steps; absent: 4 from 0 to 0.06."));

constexpr auto kIntervalRuleKeys =
    keys_of(required_key(member_key<&IntervalRule::ratio>(
                "ratio", "Ratio",
                "The upper end of the 95 % credible interval of the threshold is at most this many "
                "times the lower end.",
                NumberShape{.above = 1.0})),
            required_key(member_key<&IntervalRule::minimum_trials>(
                "minimum_trials", "Minimum number of trials",
                "Minimum number of trials of the track.", kTrialCount)),
            required_key(member_key<&IntervalRule::minimum_of_each>(
                "minimum_of_each", "Minimum of each response",
                "Minimum number of correct responses, and of incorrect responses.",
                NumberShape{.minimum = 0.0, .maximum = 10'000.0, .is_whole = true})));

constexpr auto kStopKeys = keys_of(
    required_key(member_key<&Declaration::Stop::trials>(
        "trials", "Maximum number of trials of a track", "Maximum number of trials of a track.",
        kTrialCount)),
    when(member_key<&Declaration::Stop::reversals>("reversals", "Reversals",
                                                   "Up-down: number of reversals.", kTrialCount),
         kAroundUpDown),
    when(member_key<&Declaration::Stop::clipped_moves>(
             "clipped_moves", "Clipped moves",
             "Up-down: number of moves in succession that the lowest or highest level shortened or "
             "prevented; absent: the track stays at this level until a move leads away from it.",
             kTrialCount),
         kAroundUpDown),
    when(member_key<&Declaration::Stop::interval>("interval", "Precision", kIntervalRuleTable),
         where_around("method", {"psi", "quest_plus"})));

constexpr auto kTrackKeys = keys_of(when(
    member_key<&Declaration::Track::start>(
        "start", "Starting level", "The level of its first trial, if it differs.", NumberShape{}),
    kAroundUpDown));

constexpr auto kCatchTypes = words_of<CatchType>(
    {{"easy", CatchType::easy,
      "the comparison at an easy level, an error in which is a lapse of attention"},
     {"no_signal", CatchType::no_signal,
      "the standard twice with the judgement performance, every choice in which is a false alarm"},
     {"identical_pair", CatchType::identical_pair,
      "the standard twice with the judgement comparison"}});

constexpr auto kCatchTrialsKeys = keys_of(
    listing_words(member_key<&Declaration::CatchTrials::type>(
        "type", "Type", "Surfaces of the catch trials.", kCatchTypes)),
    when(member_key<&Declaration::CatchTrials::level>(
             "level", "Level",
             "Of the type easy, which requires it: level of the catch trials, in the measure of "
             "the levels of the varied parameter; at least as easy as the easiest of them.",
             NumberShape{}),
         where("type", {kAbsent, "easy"})),
    required_key(member_key<&Declaration::CatchTrials::every>(
        "every", "Trials per catch trial",
        "Number of consecutive trials of the block that contain one catch trial.",
        NumberShape{.minimum = 2.0, .maximum = 10'000.0, .is_whole = true})));

constexpr std::array<KeyWord, 6> kMethods{
    {{"constant_stimuli", 0, "every level equally often, in random order"},
     {"transformed_up_down", 0,
      "a staircase: down after a number of correct responses in succession, up after a number of "
      "incorrect ones"},
     {"weighted_up_down", 0,
      "a staircase: down after a correct response, up by a larger step after an incorrect one"},
     {"psi", 0, "the level from which the most is expected about the threshold"},
     {"quest_plus", 0,
      "the level from which the most is expected about threshold, slope and lapse rate"},
     {"external", 0, "the level that a program of the laboratory states"}}};

constexpr auto kNuisances =
    words_of<NuisanceParameter>({{"slope", NuisanceParameter::slope, "the slope"},
                                 {"lapse", NuisanceParameter::lapse, "the lapse rate"}});
constexpr ValueShape kNuisance = WordShape{kNuisances.words};
constexpr ListShape kNuisanceList{
    .entry = &kNuisance, .meaning = "A nuisance parameter.", .longest = 2, .is_distinct = true};

void store_marginalised(const json& value, Declaration& procedure) {
  procedure.marginalised.clear();
  store_value(kNuisanceList, value, procedure.marginalised);
}

constexpr KeyTable kAnyObject{.meaning = "Any object.", .is_open = true};

void store_settings(const json& value, Declaration& procedure) {
  procedure.settings_json = value.dump();
}

constexpr auto kTimeouts =
    words_of<bool>({{"same_level", false, "the level is presented again in another trial"},
                    {"incorrect", true, "an incorrect response"}});

constexpr auto kProcedureKeys = keys_of(
    required_key(listing_words(member_key<&Declaration::method>(
        "method", "Method",
        "The method that chooses the levels. A program of the laboratory is given by run "
        "--external or in the window, and never by a file.",
        WordShape{kMethods}))),
    when(member_key<&Declaration::repetitions>(
             "repetitions", "Repetitions",
             "Constant stimuli: number of presentations of every level.", kTrialCount),
         where("method", {"constant_stimuli"})),
    when(member_key<&Declaration::down>(
             "down", "Correct responses before a move down",
             "Transformed up-down: number of correct responses in succession before a move down.",
             kMoves),
         where("method", {"transformed_up_down"})),
    when(member_key<&Declaration::up>(
             "up", "Incorrect responses before a move up",
             "Transformed up-down: number of incorrect responses in succession before a move up.",
             kMoves),
         where("method", {"transformed_up_down"})),
    when(with_standard(member_key<&Declaration::target>(
                           "target", "Target proportion",
                           "Weighted up-down: proportion correct at the target level. Psi and "
                           "QUEST+: proportion correct at the threshold; 2/3 by default where one "
                           "of three surfaces is chosen.",
                           NumberShape{.above = 0.0, .below = 1.0}),
                       [](const ProtocolKey&) { return json(WeightedUpDown{}.target); }),
         where("method", {"weighted_up_down", "psi", "quest_plus"})),
    when(with_standard(member_key<&Declaration::start>(
                           "start", "Starting level",
                           "Up-down: the level of the first trial of a track.", NumberShape{}),
                       [](const ProtocolKey&) { return json(nullptr); }),
         kOfUpDown),
    when(member_key<&Declaration::steps>(
             "steps", "Steps",
             "Up-down: the step, in the unit of the scale of the grid. If several are listed, each "
             "reversal selects the next one.",
             kSteps),
         kOfUpDown),
    when(member_key<&Declaration::steps_up>(
             "steps_up", "Steps up",
             "Transformed up-down: the steps of moves up, if they are not those of all moves.",
             kSteps),
         where("method", {"transformed_up_down"})),
    when(member_key<&Declaration::steps_down>(
             "steps_down", "Steps down",
             "Up-down: the steps of moves down, if they are not those of all moves.", kSteps),
         kOfUpDown),
    when(member_key<&Declaration::prior>("prior", "Prior", kPriorTable),
         where("method", {"psi", "quest_plus"})),
    when(with_standard(
             custom_key<&store_marginalised>(
                 "marginalise", "Nuisance parameters",
                 "Psi: the nuisance parameters, on which no trials are spent.", kNuisanceList),
             [](const ProtocolKey&) {
               return json::array({"slope", "lapse"});
             }),
         where("method", {"psi"})),
    when(custom_key<&store_settings>(
             "settings", "Settings",
             "External: settings that the program receives unchanged; they are not interpreted.",
             ObjectShape{&kAnyObject}),
         where("method", {"external"})),
    when(member_key<&Declaration::answer_within_s>(
             "answer_within_s", "Time to answer",
             "External: the time in seconds within which the program must answer.",
             NumberShape{.minimum = 1.0, .maximum = 600.0, .unit = "s"}),
         where("method", {"external"})),
    when(member_key<&Declaration::stop>("stop", "Stopping rule", kStopTable), kOfTracks),
    when(list_key<&Declaration::tracks, kTrackTable>(
             "tracks", "Tracks",
             "Interleaved tracks of each combination of the levels of the other factors; one track "
             "by default.",
             {.shortest = 1, .longest = 16}),
         kOfTracks),
    listing_words(member_key<&Declaration::timeouts_are_incorrect>(
        "timed_out", "Missed response deadline", "What a missed response deadline means.",
        kTimeouts)),
    member_key<&Declaration::catch_trials>("catch_trials", "Catch trials", kCatchTrialsTable));

}  // namespace

constexpr KeyTableOf<LevelGrid> kGridTable = table_of("A grid of levels.", kGridKeys);

constexpr KeyTableOf<Dimension> kDimensionTable = decided_by(
    table_of("The parameter that the trials vary: a factor whose levels are values of one "
             "parameter of one of the surfaces, in combination with the other factors of the "
             "block. The levels are stated in exactly one of the measures.",
             kDimensionKeys),
    kMeasures);

constexpr KeyTableOf<ValueRange> kRangeTable = table_of("A range of values.", kRangeKeys);
constexpr KeyTableOf<ValueRange> kLapseRangeTable =
    table_of("A range of lapse rates.", kLapseRangeKeys);

constexpr KeyTableOf<Declaration::Prior> kPriorTable = table_of(
    "Psi and QUEST+: the values of the parameters of a Weibull function of the difference from the "
    "standard, all equally probable before the first response.",
    kPriorKeys);

constexpr KeyTableOf<IntervalRule> kIntervalRuleTable =
    table_of("Psi and QUEST+: a precise threshold.", kIntervalRuleKeys);

constexpr KeyTableOf<Declaration::Stop> kStopTable = table_of(
    "Up-down, psi, QUEST+ and external: a track ends when the first of these rules applies.",
    kStopKeys);

constexpr KeyTableOf<Declaration::Track> kTrackTable = table_of("One track.", kTrackKeys);

constexpr KeyTableOf<Declaration::CatchTrials> kCatchTrialsTable = table_of(
    "Trials with a known response at random places among the others; no threshold is estimated "
    "from them.",
    kCatchTrialsKeys);

constexpr KeyTableOf<Declaration> kProcedureTable =
    table_of("The procedure that chooses the levels of the varied parameter from the responses.",
             kProcedureKeys);

}  // namespace asperity
