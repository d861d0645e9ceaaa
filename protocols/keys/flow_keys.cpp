// Defines the keys of a step of the flow, and of breaks.

#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using Run = Protocol::Run;
using Step = Protocol::Step;

constexpr ValueShape kGroupName = TextShape{.may_be_empty = true, .name = {kGroupNames}};
constexpr ValueShape kAskedName = NameShape{"questions"};
constexpr NumberShape kTrials{.minimum = 1.0, .maximum = 10'000.0, .is_whole = true};

using What = Protocol::Check::What;
constexpr auto kChecks = words_of<What>(
    {{"device", What::device, "the check of the device"},
     {"force_zero", What::force_zero, "the device responds and zero force is sent"}});

void store_contact_minutes(const nlohmann::json& value, Run& run) {
  run.break_every_contact_s = 60.0 * value.get<double>();
}

constexpr auto kStepKeys = keys_of(
    alternative_of<Step>(member_key<&Protocol::Screen::text>(
        "screen", "Text", "A text that the participant reads.", kShownParagraph)),
    when(alternative_of<Step>(member_key<&Protocol::Screen::condition>(
             "if", "Condition", kConditionTable, "The condition under which the text is shown.")),
         with("screen")),
    when(alternative_of<Step>(member_key<&Protocol::Screen::groups>(
             "groups", "Groups",
             "The groups of participants to whom the text is shown. Absent: all "
             "participants.",
             ListShape{.entry = &kGroupName,
                       .meaning = "A group: a level of the factor of the groups.",
                       .shortest = 1,
                       .longest = Protocol::Groups::kMost,
                       .is_distinct = true})),
         with("screen")),
    alternative_of<Step>(
        member_key<&Protocol::Check::what>("check", "Check",
                                           "The surface is removed, and the check is passed if the "
                                           "device responds and zero force is sent.",
                                           kChecks)),
    alternative_of<Step>(inner_key("break", "Break", kBreakTable)),
    alternative_of<Step>(
        member_key<&Run::block>("run", "Block", "The block to run.", NameShape{"blocks"})),
    when(
        alternative_of<Step>(member_key<&Run::for_each>(
            "for_each", "Factor of the runs",
            "A factor; the block runs once per level, in the counterbalanced order.", kFactorName)),
        with("run")),
    when(alternative_of<Step>(member_key<&Run::break_every_trials>(
             "break_every_trials", "Trials between breaks",
             "The number of trials after which there is a break.", kTrials)),
         with("run")),
    when(alternative_of<Step>(custom_key<&store_contact_minutes>(
             "break_every_contact_minutes", "Contact between breaks",
             "The time in contact with surfaces, in minutes, after which there is a "
             "break, measured since the last break.",
             NumberShape{.above = 0.0, .maximum = 1000.0, .unit = "minutes"})),
         with("run")),
    when(alternative_of<Step>(member_key<&Run::pause>("pause", "Break", kBreakTable)), with("run")),
    alternative_of<Step>(member_key<&Protocol::Ask::questions>(
        "ask", "Questions", "The questions of this step.",
        ListShape{.entry = &kAskedName, .meaning = kNameMeaning, .shortest = 1, .longest = 256})));

constexpr std::array<std::string_view, 5> kStepKinds{"screen", "check", "break", "run", "ask"};

using DriftCheck = Protocol::Break::DriftCheck;

constexpr auto kBreakKeys = keys_of(
    required_key(member_key<&Protocol::Break::minimum_s>(
        "minimum_s", "Shortest duration", "Shortest duration of the break.",
        NumberShape{.minimum = 0.0, .maximum = 3600.0, .unit = "s"})),
    member_key<&Protocol::Break::text>("text", "Text", "Text for the participant during the break.",
                                       kShownParagraph),
    member_key<&Protocol::Break::zero_force>(
        "zero_force", "Check of zero force",
        "Whether the break begins with a check that the device responds and zero force is sent.",
        TruthShape{}),
    member_key<&Protocol::Break::drift_check>("drift_check", "Check of the drift",
                                              kDriftCheckTable));

constexpr auto kDriftCheckKeys = keys_of(
    required_key(
        member_key<&DriftCheck::text>("text", "Request",
                                      "Request to the experimenter to have the handle released, so "
                                      "that it rests; confirmed before the recording.",
                                      kShownParagraph)),
    member_key<&DriftCheck::tip_text>("tip_text", "Request at reference point",
                                      "Request to hold the tip at a fixed reference point; with it "
                                      "a second recording is made there.",
                                      kShownParagraph),
    member_key<&DriftCheck::duration_s>("duration_s", "Duration", "Duration of each recording.",
                                        NumberShape{.minimum = 0.5, .maximum = 60.0, .unit = "s"}));

}  // namespace

constexpr KeyTableOf<Step> kStepTable = decided_by(
    table_of("One step of the session: a text, a check, a break, a run of a block, or questions.",
             kStepKeys, "step"),
    kStepKinds);

constexpr KeyTableOf<Protocol::Break> kBreakTable =
    table_of("A break in which the participant rests.", kBreakKeys, "pause");

constexpr KeyTableOf<DriftCheck> kDriftCheckTable = table_of(
    "Before the participant rests, the reading of the device is recorded while no hand moves it "
    "and no force is sent.",
    kDriftCheckKeys);

}  // namespace asperity
