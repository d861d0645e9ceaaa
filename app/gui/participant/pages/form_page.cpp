// Chooses list, pad or text field by the kind of the question, and composes the answer from the draft.

#include "app/gui/participant/pages/form_page.h"

#include <algorithm>
#include <vector>

#include <QtCore/QStringList>

#include "app/gui/participant/pages/number_pad.h"
#include "app/gui/participant/pages/option_list.h"
#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Scene = ParticipantScene;

NumberSign sign_of(const Question& question) {
  return !question.minimum || *question.minimum < 0.0 ? NumberSign::minus : NumberSign::none;
}

bool is_empty(const Question& question, const ParticipantDraft& draft) {
  switch (question.form) {
    case Question::Form::choice:
      return !draft.option;
    case Question::Form::multiple_choice:
      return draft.options.empty();
    case Question::Form::number:
      return draft.number.isEmpty();
    case Question::Form::text:
      return draft.text.trimmed().isEmpty();
    case Question::Form::scale:  // scale_form_page.h
      break;
  }
  return false;
}

/// What was typed cannot become a number: nothing is confirmed until it is corrected.
bool holds_no_number(const Question& question, const ParticipantDraft& draft) {
  return question.form == Question::Form::number && is_no_number(draft.number, sign_of(question));
}

QString range_text(const PageFrame& frame, const Question& question) {
  const auto number = [](double value) {
    return QString::number(value, 'g', 12).replace('-', "−").toStdString();
  };
  if (question.minimum && question.maximum) {
    return frame.said(phrase("ParticipantLayout", "From %1 to %2")
                          .with(number(*question.minimum), number(*question.maximum)));
  }
  if (question.minimum)
    return frame.said(phrase("ParticipantLayout", "%1 or more").with(number(*question.minimum)));
  if (question.maximum)
    return frame.said(phrase("ParticipantLayout", "%1 or less").with(number(*question.maximum)));
  return {};
}

void lay_out_text(PageFrame& frame) {
  const bool answers = frame.question_over(
      frame.scene_text(), [&frame](double height) { return height >= frame.em(104.0); });
  frame.need_pages(frame.question_pages() + 1);
  if (!answers) return;
  QRectF field = frame.column();
  field.setHeight(std::min(field.height(), frame.em(280.0)));
  frame.add({.kind = ParticipantItem::Kind::field,
             .rect = field,
             .text = frame.inputs().draft.text,
             .size_px = frame.letters(frame.kText)});
}

/// As `form_answer` reads it; empty where nothing is answered.
QString answer_in(const Question& question, const ParticipantDraft& draft) {
  switch (question.form) {
    case Question::Form::choice: {
      const auto options = question.options.size();
      if (!draft.option || static_cast<std::size_t>(*draft.option) > options) return {};
      return QString::fromStdString(question.options[static_cast<std::size_t>(*draft.option - 1)]);
    }
    case Question::Form::multiple_choice: {
      QStringList numbers{};
      for (const int option : draft.options) numbers.append(QString::number(option));
      return numbers.join(' ');
    }
    case Question::Form::number:
      return draft.number;
    case Question::Form::text:
      return draft.text.trimmed();
    case Question::Form::scale:
      break;
  }
  return {};
}

OptionList options_of(const PageFrame& frame, const Question& question) {
  const ParticipantDraft& draft = frame.inputs().draft;
  OptionList list{.question = frame.scene_text(), .chosen = draft.options};
  if (question.form == Question::Form::multiple_choice) {
    list.question += '\n' + frame.said(phrase("ParticipantLayout", "Choose all that apply."));
  } else if (draft.option) {
    list.chosen = {*draft.option};
  }
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    list.options.push_back(frame.text_from(question.text_of_option(i)));
  }
  return list;
}

/// Chooses an option, or no longer chooses it.
void toggle(int option, std::vector<int>& chosen) {
  const auto place = std::lower_bound(chosen.begin(), chosen.end(), option);
  if (place != chosen.end() && *place == option) {
    chosen.erase(place);
  } else {
    chosen.insert(place, option);
  }
}

class FormPage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override {
    const Scene& scene = frame.scene();
    if (!scene.question) {
      frame.prompt(frame.scene_text(), frame.letters(frame.kPrompt));
      return;
    }
    const Question& question = *scene.question;
    switch (question.form) {
      case Question::Form::choice:
      case Question::Form::multiple_choice:
        lay_out_options(frame, options_of(frame, question));
        break;
      case Question::Form::number: {
        const NumberTexts texts{
            .range = range_text(frame, question),
            .unit = frame.text_from(question.unit),
            .no_number = frame.said(
                phrase("ParticipantLayout", "This is not a number. Please correct it."))};
        lay_out_number(frame, texts, sign_of(question));
        break;
      }
      case Question::Form::text:
        lay_out_text(frame);
        break;
      case Question::Form::scale:
        break;
    }
  }

  void add_controls(PageFrame& frame) const override {
    if (!frame.scene().question) return;
    const Question& question = *frame.scene().question;
    const ParticipantDraft& draft = frame.inputs().draft;
    // An empty text can be confirmed.
    const bool is_missing = question.form != Question::Form::text && is_empty(question, draft);
    if (question.optional && is_missing) {
      frame.add_control(frame.said(phrase("ParticipantLayout", "Skip")), frame.return_key(),
                        {.what = Action::What::confirm}, true);
      return;
    }
    frame.add_control(frame.said(phrase("ParticipantLayout", "Confirm")), frame.return_key(),
                      {.what = Action::What::confirm},
                      !is_missing && !holds_no_number(question, draft));
  }

  std::optional<Action> action_of_key(const Scene& scene, int key,
                                      const QString& typed) const override {
    if (is_return(key)) return Action{.what = Action::What::confirm};
    if (!scene.question) return {};
    switch (scene.question->form) {
      case Question::Form::choice:
      case Question::Form::multiple_choice:
        return key_of_option_list(typed, static_cast<int>(scene.question->options.size()));
      case Question::Form::number:
        // A minus is written where there can be none: it is seen, and said to be wrong.
        return key_of_number(key, typed, NumberSign::minus);
      case Question::Form::text:
      case Question::Form::scale:
        break;
    }
    return {};
  }

  Typing typing(const Scene& scene) const override {
    if (!scene.question) return Typing::none;
    switch (scene.question->form) {
      case Question::Form::choice:
      case Question::Form::multiple_choice:
      case Question::Form::scale:
        return Typing::none;
      case Question::Form::number:
        return Typing::number;
      case Question::Form::text:
        return Typing::text;
    }
    return Typing::none;
  }

  bool is_private() const override { return true; }

  bool would_leave_out(const Scene& scene, const ParticipantDraft& draft) const override {
    return scene.question && scene.question->optional && is_empty(*scene.question, draft);
  }

  ActionEffect act(const Scene& scene, const Action& action,
                   ParticipantDraft& draft) const override {
    if (!scene.question) return {};
    const Question& question = *scene.question;
    switch (action.what) {
      case Action::What::choose:
        if (question.form == Question::Form::multiple_choice) {
          toggle(action.number, draft.options);
          return {};  // the page of the picture with this option stays in view
        }
        if (question.optional && draft.option == action.number) {
          draft.option.reset();
        } else {
          draft.option = action.number;
        }
        return {.shows_answer = true};
      case Action::What::write:
      case Action::What::erase:
        write_number(action, sign_of(question), draft.number);
        return {.shows_answer = true};
      case Action::What::confirm:
        if (holds_no_number(question, draft)) return {};
        return {.told = ParticipantInput{.kind = ParticipantInput::Kind::text,
                                         .text = answer_in(question, draft).toStdString()}};
      case Action::What::surface:
      case Action::What::next:
      case Action::What::mark:
      case Action::What::step:
      case Action::What::select:
      case Action::What::turn_to:
        break;
    }
    return {};
  }
};

}  // namespace

const ParticipantPage& form_page() {
  static const FormPage kScenePage{};
  return kScenePage;
}

}  // namespace asperity
