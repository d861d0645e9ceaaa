// Defines the keys of "participants", "consent", "groups" and "resume".

#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using Groups = Protocol::Groups;
using Resume = Protocol::Resume;

constexpr ValueShape kQuestionName = NameShape{"questions"};
constexpr ValueShape kBlockSize = NumberShape{.minimum = 2.0, .maximum = 1000.0, .is_whole = true};
constexpr ValueShape kResumeText = TextShape{.longest = 20'000, .translated = Translated::always};

constexpr auto kParticipantsKeys =
    keys_of(member_key<&Protocol::planned_participants>(
                "planned", "Planned participants", "Planned number of participants.",
                NumberShape{.minimum = 1.0, .maximum = 100'000.0, .is_whole = true}),
            member_key<&Protocol::sessions>(
                "sessions", "Sessions", "Sessions per participant.",
                NumberShape{.minimum = 1.0, .maximum = 100.0, .is_whole = true}),
            member_key<&Protocol::participant_questions>(
                "questions", "Questions", "Questions asked once, before the first session.",
                ListShape{.entry = &kQuestionName, .meaning = kNameMeaning, .longest = 256}));

constexpr auto kConsentKeys = keys_of(
    required_key(member_key<&Protocol::consent_version>(
        "version", "Version", "Version of the consent text.", TextShape{.longest = 100})),
    required_key(member_key<&Protocol::consent_statement>(
        "statement", "Statement", "The text that the participant agrees to.", kShownParagraph)));

constexpr auto kAssignments = words_of<Groups::Assignment>(
    {{"balanced", Groups::Assignment::balanced, "to the group with the fewest participants"},
     {"permuted_blocks", Groups::Assignment::permuted_blocks,
      "by a random sequence in blocks, each of which contains every group equally often"},
     {"by_experimenter", Groups::Assignment::by_experimenter,
      "stated when the first session begins"}});

constexpr auto kGroupsKeys = keys_of(
    required_key(
        member_key<&Groups::factor>("factor", "Factor",
                                    "The factor whose levels are the groups. Every trial has the "
                                    "level of the participant's group, so no block sets it.",
                                    NameShape{.registry = kFactorNames, .levels = kGroupNames})),
    listing_words(member_key<&Groups::assigned>(
        "assigned", "Assignment", "The assignment of participants to groups.", kAssignments)),
    when(member_key<&Groups::block_sizes>(
             "block_sizes", "Sizes of blocks",
             "Of permuted blocks: the sizes from which that of each block is drawn, multiples of "
             "the number of groups. Absent: two and three times this number.",
             ListShape{.entry = &kBlockSize,
                       .meaning = "Participants in a block.",
                       .shortest = 1,
                       .longest = 16}),
         where("assigned", {"permuted_blocks"})),
    when(member_key<&Groups::seed>(
             "seed", "Seed", "Of permuted blocks: the seed of the sequence.",
             NumberShape{.minimum = 0.0, .maximum = 9'007'199'254'740'991.0, .is_whole = true}),
         where("assigned", {"permuted_blocks"})));

constexpr auto kResumeKeys = keys_of(
    member_key<&Resume::screens>(
        "screens", "Texts",
        "The texts that the participant reads. Default: the last text before the interruption.",
        ListShape{.entry = &kResumeText, .longest = 20}),
    member_key<&Resume::maximum_age_hours>(
        "maximum_age_hours", "Maximum age without a reason",
        "Time since the interruption after which a session is resumed only with a reason, which is "
        "stored.",
        NumberShape{.above = 0.0, .maximum = 100'000.0, .unit = "hours"}),
    member_key<&Resume::practice_trials>(
        "practice_trials", "Repeated practice trials",
        "Number of practice trials that the participant repeats before the session continues: the "
        "first trials of the latest practice block. They are stored as refreshers and never count.",
        NumberShape{.minimum = 1.0, .maximum = 100.0, .is_whole = true}));

}  // namespace

constexpr KeyTableOf<Protocol> kParticipantsTable =
    table_of("The participants.", kParticipantsKeys);

constexpr KeyTableOf<Protocol> kConsentTable = table_of("Informed consent.", kConsentKeys);

constexpr KeyTableOf<Groups> kGroupsTable = table_of(
    "A between-participants factor: each participant belongs to one group, in all sessions of the "
    "protocol.",
    kGroupsKeys);

constexpr KeyTableOf<Resume> kResumeTable = table_of(
    "Resumption of an interrupted session: the checks of the device are repeated, and the "
    "participant reads a text and then starts from a screen of the program.",
    kResumeKeys);

}  // namespace asperity
