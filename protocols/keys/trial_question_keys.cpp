// Defines the keys of the questions of a trial.

#include "protocols/keys/answer_keys.h"
#include "protocols/keys/common_shapes.h"
#include "protocols/keys/keys_of.h"
#include "protocols/keys/tables.h"

namespace asperity {

namespace {

using nlohmann::json;
using Template = Protocol::TrialQuestionTemplate;

constexpr ValueShape kPictureName = NameShape{"textures"};

constexpr auto kWordKeys =
    keys_of(required_key(member_key<&Option::value>(
                "value", "Value",
                "The value that is stored and exported: the same in all languages of a protocol.",
                NameShape{})),
            required_key(member_key<&Option::text>(
                "text", "Text", "The text that is shown for this option.", kShownText)));

constexpr auto kTieKeys = keys_of(required_key(member_key<&Template::tie>(
    "text", "Text", "The text that is shown for this option.", kShownText)));

constexpr auto kJudgements = words_of<DiscriminationJudgement>(
    {{"performance", DiscriminationJudgement::performance,
      "the comparison is the correct response"},
     {"comparison", DiscriminationJudgement::comparison,
      "no response is correct, and the point of subjective equality is estimated"}});
constexpr auto kAsked =
    words_of<Template::AsksFor>({{"more", Template::AsksFor::more, "the higher value"},
                                 {"less", Template::AsksFor::less, "the lower value"}});
constexpr auto kRated = words_of<RatedQuantity>(
    {{"dissimilarity", RatedQuantity::dissimilarity, "the dissimilarity of the two surfaces"},
     {"similarity", RatedQuantity::similarity, "the similarity of the two surfaces"}});

constexpr auto kNameAndPromptKeys = keys_of(
    required_key(
        member_key<&Question::name>("name", "Name", "Name of the response in the data.",
                                    NameShape{.registry = kAnswerNames, .is_declared = true})),
    required_key(member_key<&Question::prompt>(
        "prompt", "Question", "The question as the participant reads it.", kShownParagraph)));

constexpr auto kTrialKeys = keys_of(
    member_key<&Template::pictures>(
        "pictures", "Pictures",
        "Textures whose pictures are the options; absent: the surfaces felt are the options.",
        ListShape{.entry = &kPictureName, .meaning = kNameMeaning, .shortest = 2, .longest = 256}),
    member_key<&Template::reshuffle_pictures>(
        "reshuffle_pictures", "Draw positions in every trial",
        "Whether the positions of the pictures are drawn for every trial; otherwise they are "
        "drawn once per session.",
        TruthShape{}),
    member_key<&Template::allow_cannot_tell>(
        "allow_cannot_tell", "\"I cannot tell\"",
        "Whether \"I cannot tell\" is one of the options. In a discrimination in which one of two "
        "surfaces is chosen, such a response counts as the mean of a guess.",
        TruthShape{}),
    member_key<&Template::correct_factor>(
        "correct_factor", "Factor of the correct picture",
        "Recognition: the factor whose level is the correct picture.",
        NameShape{.registry = kFactorNames, .levels = "textures"}),
    member_key<&Template::judgement>(
        "judgement", "Judgement",
        "Discrimination: performance: the comparison is the correct response; comparison: no "
        "response is correct, and the point of subjective equality is estimated.",
        kJudgements),
    with_standard(
        member_key<&Template::asks_for>(
            "asks_for", "Asks for",
            "Discrimination with the judgement comparison: whether the question asks for the "
            "surface with the higher (more) or the lower (less) value of the varied parameter.",
            kAsked),
        [](const ProtocolKey&) { return json("more"); }),
    member_key<&Template::confidence_of>(
        "confidence_of", "Confidence of",
        "Of a scale in a block of a discrimination: the earlier question whose response it rates "
        "the confidence of.",
        NameShape{kAnswerNames}),
    with_standard(
        member_key<&Template::rates>("rates", "Rates",
                                     "Similarity: whether the scale increases with the "
                                     "dissimilarity or with the similarity of the two surfaces.",
                                     kRated),
        [](const ProtocolKey&) { return json("dissimilarity"); }),
    inner_key("tie", "Tie", kTieTable));

/// A scale has its own analysis in blocks of every kind.
void store_additional_form(const json& value, Question& question) {
  question.form = form_named(value.get<std::string>());
  question.is_additional = !question.is_answered_by<ScaleForm>();
}

constexpr auto kTrialFormKeys = joined(
    keys_of(custom_key<&store_additional_form>(
                "form", "Form",
                "Form of the response to an additional question, which is stored and exported "
                "and which no analysis uses, except that of a scale. Absent: the question of the "
                "kind of experiment, or one answered on a scale.",
                WordShape{kForms}),
            list_key<&Question::options, kWordTable>(
                "options", "Options",
                "Options in words, in the order in which they are shown; only for kinds of "
                "experiment that permit them, and for an additional question.",
                {.shortest = 2, .longest = 9})),
    joined(joined(kNumberKeys, joined(kScaleKey, kLineKey)), condition_key(kTrialConditionTable)));

/// The keys of a question in the table of an object that contains it.
template <class Owner>
consteval auto question_keys_of(void* (*question)(void* owner), void* (*as_template)(void* owner)) {
  return joined(
      in_part<Owner>(kNameAndPromptKeys, question),
      joined(in_part<Owner>(kTrialKeys, as_template), in_part<Owner>(kTrialFormKeys, question)));
}

constexpr auto kListedQuestionKeys = question_keys_of<Template>(
    [](void* owner) -> void* { return static_cast<Question*>(static_cast<Template*>(owner)); },
    nullptr);

void store_revisits(const json& value, Protocol::Block& block) {
  if (!value.get<bool>()) block.arrangement.maximum_visits = 1;
}

constexpr auto kOfTheTrialKeys = keys_of(
    member_key<&Protocol::Block::experimenter_prompt>(
        "experimenter_prompt", "Text for the experimenter",
        "Text for the experimenter; {code} is replaced by the code of the trial's texture.",
        kParagraph),
    member_key<&Protocol::Block::pictures_after_feeling>(
        "pictures_after_feeling", "Pictures after feeling",
        "Whether pictures stay hidden until every surface has been felt.", TruthShape{}),
    with_standard(custom_key<&store_revisits>(
                      "allow_revisit", "Surfaces can be felt again",
                      "Whether the participant may switch between the surfaces before responding.",
                      TruthShape{}),
                  [](const ProtocolKey&) { return json(true); }));

/// The one question of a block that has no list of them.
Template& only_question(void* block) {
  auto& questions = static_cast<Protocol::Block*>(block)->questions;
  return questions.empty() ? questions.emplace_back() : questions.back();
}

constexpr auto kOnlyQuestionKeys =
    joined(question_keys_of<Protocol::Block>(
               [](void* owner) -> void* { return static_cast<Question*>(&only_question(owner)); },
               [](void* owner) -> void* { return &only_question(owner); }),
           kOfTheTrialKeys);

}  // namespace

constexpr KeyTableOf<Template> kListedQuestionTable =
    table_of("One of several questions of a trial.", kListedQuestionKeys);

constexpr KeyTableOf<Protocol::Block> kOnlyQuestionTable = table_of(
    "The question of every trial; \"questions\" lists several questions.", kOnlyQuestionKeys);

constexpr KeyTableOf<Option> kWordTable =
    table_of("One option, as an object {\"value\": \"yes\", \"text\": \"Yes\"}.", kWordKeys);

constexpr KeyTableOf<Template> kTieTable = table_of(
    "Paired comparison: an option after those for the surfaces, stored as \"tie\"; absent: one of "
    "the surfaces has to be chosen.",
    kTieKeys);

}  // namespace asperity
