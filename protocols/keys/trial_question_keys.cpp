// Defines the keys of the questions of a trial.

#include "protocols/keys/answer_keys.h"
#include "protocols/keys/revisit_key.h"
#include "protocols/keys/tables.h"
#include "protocols/kind_keys/discrimination_keys.h"
#include "protocols/kind_keys/paired_comparison_keys.h"
#include "protocols/kind_keys/recognition_keys.h"
#include "protocols/kind_keys/similarity_keys.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using nlohmann::json;
using Template = Protocol::TrialQuestionTemplate;

constexpr ValueShape kPictureName = NameShape{"textures"};

constexpr KeyCondition kChosen{"form", {kAbsent, ChoiceForm::kName}};
constexpr KeyCondition kChosenAmong{"form",
                                    {kAbsent, ChoiceForm::kName, MultipleChoiceForm::kName}};

constexpr auto kWordKeys =
    keys_of(required_key(member_key<&Option::value>(
                "value", "Value",
                "The value that is stored and exported: the same in all languages of a protocol.",
                NameShape{})),
            required_key(member_key<&Option::text>(
                "text", "Text", "The text that is shown for this option.", kShownText)));

constexpr auto kNameAndPromptKeys = keys_of(
    required_key(
        member_key<&Question::name>("name", "Name", "Name of the response in the data.",
                                    NameShape{.registry = kAnswerNames, .is_declared = true})),
    required_key(member_key<&Question::prompt>(
        "prompt", "Question", "The question as the participant reads it.", kShownParagraph)));

constexpr auto kTrialKeys = keys_of(
    when(member_key<&Template::pictures>(
             "pictures", "Pictures",
             "Textures whose pictures are the options; absent: the surfaces felt are the options.",
             ListShape{
                 .entry = &kPictureName, .meaning = kNameMeaning, .shortest = 2, .longest = 256}),
         kWithPictures, kChosen, without("scale")),
    when(member_key<&Template::reshuffle_pictures>(
             "reshuffle_pictures", "Draw positions in every trial",
             "Whether the positions of the pictures are drawn for every trial; otherwise they are "
             "drawn once per session.",
             TruthShape{}),
         with("pictures")),
    when(member_key<&Template::allow_cannot_tell>(
             "allow_cannot_tell", "\"I cannot tell\"",
             "Whether \"I cannot tell\" is one of the options. In a discrimination in which one of "
             "two surfaces is chosen, such a response counts as the mean of a guess.",
             TruthShape{}),
         kWithCannotTell, kChosen, without("scale")));

/// A scale has its own analysis in blocks of every kind.
void store_additional_form(const json& value, Question& question) {
  question.form = form_named(value.get<std::string>());
  question.is_additional = !question.is_answered_by<ScaleForm>();
}

constexpr auto kTrialFormKeys = joined(
    keys_of(custom_key<&store_additional_form>(
                "form", "Form",
                "Form of the response to an additional question, which is stored and exported and "
                "which no analysis uses, except that of a scale. Absent: the question of the kind "
                "of experiment, or one answered on a scale.",
                WordShape{kForms}),
            when(list_key<&Question::options, kWordTable>(
                     "options", "Options",
                     "Options in words, in the order in which they are shown; only for kinds of "
                     "experiment that permit them, and for an additional question.",
                     {.shortest = 2, .longest = 9}),
                 kWithWords, kChosenAmong, without("scale"))),
    joined(joined(kNumberKeys, joined(kScaleKey, kLineKey)), condition_key(kTrialConditionTable)));

/// The keys of a question in the table of an Owner that contains it; `template_in` finds it there.
template <class Owner, Template& (*template_in)(void* owner)>
consteval auto question_keys_of() {
  constexpr auto question = [](void* owner) -> void* {
    return static_cast<Question*>(&template_in(owner));
  };
  constexpr auto as_template = [](void* owner) -> void* { return &template_in(owner); };
  constexpr auto own = [](void* owner) -> auto& { return template_in(owner).own; };
  constexpr auto of_kinds = joined(joined(own_keys<Owner, own>(kRecognitionQuestionKeys),
                                          own_keys<Owner, own>(kDiscriminationQuestionKeys)),
                                   joined(joined(own_keys<Owner, own>(kConfidenceKeys),
                                                 own_keys<Owner, own>(kSimilarityQuestionKeys)),
                                          own_keys<Owner, own>(kPairQuestionKeys)));
  return joined(in_part<Owner>(kNameAndPromptKeys, question),
                joined(joined(in_part<Owner>(kTrialKeys, as_template), of_kinds),
                       in_part<Owner>(kTrialFormKeys, question)));
}

Template& template_itself(void* owner) { return *static_cast<Template*>(owner); }
constexpr auto kListedQuestionKeys = question_keys_of<Template, &template_itself>();

constexpr auto kOfTheTrialKeys = keys_of(
    member_key<&Protocol::Block::experimenter_prompt>(
        "experimenter_prompt", "Text for the experimenter",
        "Text for the experimenter; {code} is replaced by the code of the trial's texture.",
        kParagraph),
    when(member_key<&Protocol::Block::pictures_after_feeling>(
             "pictures_after_feeling", "Pictures after feeling",
             "Whether pictures stay hidden until every surface has been felt.", TruthShape{}),
         with("pictures")),
    revisit_key());

/// The one question of a block that has no list of them.
Template& only_question(void* block) {
  auto& questions = static_cast<Protocol::Block*>(block)->questions;
  return questions.empty() ? questions.emplace_back() : questions.back();
}

constexpr auto kOnlyQuestionKeys =
    joined(question_keys_of<Protocol::Block, &only_question>(), kOfTheTrialKeys);

}  // namespace

constexpr KeyTableOf<Template> kListedQuestionTable =
    table_of("One of several questions of a trial.", kListedQuestionKeys);

constexpr KeyTableOf<Protocol::Block> kOnlyQuestionTable =
    table_of("The question of every trial, if there is only one.", kOnlyQuestionKeys);

constexpr KeyTableOf<Option> kWordTable =
    table_of("One option: the value that is stored, and the text that is shown.", kWordKeys);
}  // namespace asperity
