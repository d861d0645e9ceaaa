// Defines the keys of a protocol.

#include "protocols/keys/tables.h"
#include "protocols/kind_keys/magnitude_keys.h"
#include "protocols/kind_keys/selection_keys.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using Counterbalance = Protocol::Counterbalance;
constexpr auto kCounterbalances =
    words_of<Counterbalance>({{"none", Counterbalance::none, "the order of the levels"},
                              {"latin", Counterbalance::latin, "a Latin square"},
                              {"williams", Counterbalance::williams, "a Williams design"}});

// The reader does not need these values.
template <class Owner>
void ignore(const nlohmann::json&, Owner&) {}

constexpr std::array<KeyWord, 1> kFormats{{{"asperity.protocol/1", 0, "this format"}}};
constexpr auto kDesigns = words_of<ProtocolDesign>(
    {{"chapter", ProtocolDesign::chapter,
      "one response per participant and column of the published table"},
     {"improved", ProtocolDesign::improved, "balanced, with practice and repetitions"}});
void store_author(const nlohmann::json& value, std::string& name) {
  name = value.get<std::string>();
}

constexpr auto kAuthorKeys = keys_of(
    required_key(custom_key<&store_author>("name", "Name", "Name for citations.", TextShape{})),
    custom_key<&ignore<std::string>>(
        "orcid", "ORCID iD", "ORCID iD in four groups of four, such as 0000-0002-1825-0097.",
        TextShape{.pattern = R"(^\d{4}-\d{4}-\d{4}-\d{3}[\dX]$)"}),
    custom_key<&ignore<std::string>>("affiliation", "Affiliation", "Institution of the author.",
                                     TextShape{.longest = 400}));

constexpr auto kProtocolKeys = keys_of(
    custom_key<&ignore<Protocol>>("$schema", "Schema", "URI of this schema, for editors.",
                                  TextShape{.longest = 400}),
    required_key(custom_key<&ignore<Protocol>>("format", "Format", "The version of this format.",
                                               WordShape{kFormats})),
    listing_words(required_key(member_key<&Protocol::kind>(
        "kind", "Kind", "The kind of experiment; a block can have another one.",
        WordShape{kKinds}))),
    required_key(listing_words(member_key<&Protocol::design>(
        "design", "Design", "The design of the experiment.", kDesigns))),
    required_key(
        member_key<&Protocol::name>("name", "Name",
                                    "Short name, used in file names and data: lower-case letters, "
                                    "digits and underscores, starting with a letter.",
                                    NameShape{})),
    required_key(member_key<&Protocol::version>(
        "version", "Version", "Version of the protocol as three numbers, such as 1.0.0.",
        TextShape{.longest = 32,
                  .pattern = R"(^(0|[1-9]\d{0,5})\.(0|[1-9]\d{0,5})\.(0|[1-9]\d{0,5})$)"})),
    required_key(member_key<&Protocol::title>("title", "Title", "Title shown to users.",
                                              TextShape{.translated = Translated::if_present})),
    member_key<&Protocol::language>(
        "language", "Language",
        "Language of the protocol's texts, and of the program's own texts to the participant, as a "
        "BCP 47 tag: \"en\", \"de\". The program has English and German; in any other language its "
        "own texts are English.",
        TextShape{.longest = 35, .pattern = "^[a-z]{2,3}(-[A-Za-z0-9]{2,8})*$"}),
    member_key<&Protocol::description>("description", "Description",
                                       "Question and method of the study.", kDescription),
    list_key<&Protocol::authors, kAuthorTable>("authors", "Authors", "Authors of this protocol.",
                                               {.longest = 64}),
    member_key<&Protocol::license>("license", "Licence",
                                   "Licence of this protocol, such as CC-BY-4.0.", TextShape{}),
    inner_key("participants", "Participants", kParticipantsTable),
    required_key(inner_key("consent", "Consent", kConsentTable)),
    when(member_key<&Protocol::realism_standard>(
             "realism_standard", "Standard of realism",
             "Selection, paired comparison: the standard with which realism is compared.",
             kStandards),
         kWithRealism),
    when(member_key<&Protocol::estimation>("estimation", "Estimation", kEstimationTable),
         of_kinds({"magnitude"})),
    inner_key("environment", "Environment", kEnvironmentTable),
    member_key<&Protocol::instability>("instability", "Instability", kInstabilityTable),
    inner_key("device", "Haptic device", kDeviceTable),
    member_key<&Protocol::patch>("surface", "Surface", kSurfaceTable),
    member_key<&Protocol::material>("material", "Material", kMaterialTable),
    map_key<&Protocol::textures, kTextureTable>("textures", "Textures", "The textures by name."),
    map_key<&Protocol::bodies, kBodyTable>(
        "bodies", "Bodies", "Solid bodies by name, for models in which a tool touches a surface."),
    required_key(map_key<&Protocol::stimuli, kStimulusTable>(
        "stimuli", "Stimuli", "The stimuli by name.", {.shortest = 1})),
    map_key<&Protocol::factors, kFactorTable>("factors", "Factors", "The factors by name."),
    required_key(map_key<&Protocol::explorations, kExplorationTable>(
        "explorations", "Explorations", "Ways to explore a surface, by name.", {.shortest = 1})),
    map_key<&Protocol::questions, kQuestionTable>(
        "questions", "Questions",
        "Questions of the questionnaire and about the participant, by name."),
    required_key(map_key<&Protocol::blocks, kBlockTable>(
        "blocks", "Blocks", "Blocks of trials, by name.", {.shortest = 1})),
    required_key(list_key<&Protocol::flow, kStepTable>("flow", "Flow", "The session, step by step.",
                                                       {.shortest = 1, .longest = 1000})),
    member_key<&Protocol::resume>("resume", "Resumption", kResumeTable),
    member_key<&Protocol::counterbalance>(
        "counterbalance", "Counterbalancing",
        "Order, across participants, of the levels of a factor for each of which a block is run.",
        kCounterbalances),
    member_key<&Protocol::groups>("groups", "Groups", kGroupsTable),
    member_key<&Protocol::observer>("observer", "Virtual observer", kObserverTable),
    inner_key("recording", "Recording", kRecordingTable),
    member_key<&Protocol::analysis>("analysis", "Analysis", kAnalysisTable));

}  // namespace

constexpr KeyTableOf<std::string> kAuthorTable =
    table_of("An author of this protocol.", kAuthorKeys, "author");

// Until 0.3.0 a protocol could state instructions that participants did not read.
constexpr std::array<RemovedKey, 1> kRemoved{{RemovedKey{
    "instructions",
    "participants read the screens of the flow: write the instructions there, on a screen "
    "before the first block, and remove this key"}}};

constexpr KeyTableOf<Protocol> kProtocolTable = with_removed_keys(
    table_of("A haptic texture experiment: its stimuli, their order, and its questions.",
             kProtocolKeys),
    kRemoved);

}  // namespace asperity
