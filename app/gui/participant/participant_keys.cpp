#include "app/gui/participant/participant_keys.h"

#include <cstddef>

#include <QtCore/QRegularExpression>
#include <QtCore/Qt>

namespace asperity {

namespace {

using Action = ParticipantAction;
using Scene = ParticipantScene;

QString upper(const std::string& text) { return QString::fromStdString(text).toUpper(); }

std::optional<Action> typed_into_number(int key, const QString& typed, const QString& signs) {
  if (key == Qt::Key_Backspace) return Action{.what = Action::What::erase};
  if (typed == ",") return Action{.what = Action::What::write, .text = "."};
  if (typed.size() == 1 && signs.contains(typed)) {
    return Action{.what = Action::What::write, .text = typed};
  }
  return {};
}

std::optional<Action> action_on_scale(int key) {
  switch (key) {
    case Qt::Key_Left:
      return Action{.what = Action::What::step, .number = -1};
    case Qt::Key_Right:
      return Action{.what = Action::What::step, .number = 1};
    case Qt::Key_Up:
    case Qt::Key_Backtab:
      return Action{.what = Action::What::select, .number = -1};
    case Qt::Key_Down:
    case Qt::Key_Tab:
      return Action{.what = Action::What::select, .number = 1};
    default:
      return {};
  }
}

}  // namespace

bool takes_typed_number(const ParticipantScene& scene) {
  if (scene.kind == Scene::Kind::question) return scene.is_answered_by<NumberForm>();
  return scene.kind == Scene::Kind::form && scene.question &&
         scene.question->form == Question::Form::number;
}

bool may_be_negative(const ParticipantScene& scene) {
  return scene.kind == Scene::Kind::form && scene.question &&
         (!scene.question->minimum || *scene.question->minimum < 0.0);
}

std::optional<ParticipantAction> sign_amiss(const ParticipantScene& scene, const QString& text) {
  if (!takes_typed_number(scene) || text.size() != 1) return {};
  if (!text.front().isPrint() || text.front().isSpace()) return {};
  return Action{.what = Action::What::write, .text = text};
}

bool is_no_number(const ParticipantScene& scene, const QString& typed) {
  constexpr qsizetype kMostSigns = 15;  // all digits of it are kept
  static const QRegularExpression kBegun(
      QStringLiteral("^-?[0-9]*[.]?[0-9]*$|^-?([0-9]+[.]?[0-9]*|[.][0-9]+)[eE][+-]?[0-9]*$"));
  if (typed.startsWith('-') && !may_be_negative(scene)) return true;
  return typed.size() > kMostSigns || !kBegun.match(typed).hasMatch();
}

QString key_of_form_option(int number) {
  if (number <= 9) return QString::number(number);
  return QString(QChar(static_cast<char16_t>(u'A' + number - 10)));
}

std::optional<ParticipantAction> action_of_key(const ParticipantScene& scene, int key,
                                               const QString& text) {
  const QString typed = text.toUpper();
  const bool is_return = key == Qt::Key_Return || key == Qt::Key_Enter;
  switch (scene.kind) {
    case Scene::Kind::text:
    case Scene::Kind::mask_on:
    case Scene::Kind::mask_off:
    case Scene::Kind::rest:
      if (is_return) return Action{.what = Action::What::confirm};
      return {};
    case Scene::Kind::blank:
      if (scene.surfaces.empty()) return {};
      [[fallthrough]];
    case Scene::Kind::feel:
    case Scene::Kind::question: {
      if (is_return && scene.kind == Scene::Kind::question) {
        return Action{.what = Action::What::confirm};
      }
      if (key == Qt::Key_Space) return Action{.what = Action::What::next};
      if (scene.is_answered_by<ScaleForm>() && scene.kind == Scene::Kind::question) {
        if (auto action = action_on_scale(key)) return action;
        const bool is_list =
            scene.scales.size() == 1 && scene.scales.front().form.labels_every_point();
        for (int point = 1; is_list && point <= scene.scales.front().form.points; ++point) {
          if (typed == key_of_form_option(point)) {
            return Action{.what = Action::What::choose, .number = point};
          }
        }
      }
      if (scene.is_answered_by<NumberForm>()) {
        if (auto action = typed_into_number(key, typed, "0123456789.")) return action;
      }
      if (typed.isEmpty()) return {};
      for (std::size_t i = 0; i < scene.choices.size(); ++i) {
        if (upper(scene.choices[i].key) == typed) {
          return Action{.what = Action::What::choose, .number = static_cast<int>(i) + 1};
        }
      }
      for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        const bool can_be_meant = scene.is_answered_by<AssignmentForm>() ||
                                  scene.surfaces[i].can_go || scene.kind != Scene::Kind::question;
        if (can_be_meant && upper(scene.surfaces[i].code) == typed) {
          return Action{.what = Action::What::surface, .number = static_cast<int>(i) + 1};
        }
      }
      // Answers before there is anything to choose from are refused by name, not ignored.
      bool is_number = false;
      const int number = typed.toInt(&is_number);
      if (!is_number || number < 1) return {};
      const bool has_letters = static_cast<std::size_t>(number) <= scene.choices.size() &&
                               scene.choices[static_cast<std::size_t>(number - 1)].text.empty();
      if (has_letters || scene.choices.empty()) {
        return Action{.what = Action::What::choose, .number = number};
      }
      return {};
    }
    case Scene::Kind::form: {
      if (is_return) return Action{.what = Action::What::confirm};
      if (!scene.question) return {};
      if (scene.question->form == Question::Form::choice) {
        for (std::size_t i = 0; i < scene.question->options.size(); ++i) {
          const int number = static_cast<int>(i) + 1;
          if (typed == key_of_form_option(number)) {
            return Action{.what = Action::What::choose, .number = number};
          }
        }
        return {};
      }
      if (scene.question->form != Question::Form::number) return {};
      return typed_into_number(key, typed, "0123456789.-");
    }
    case Scene::Kind::feedback:
    case Scene::Kind::paused:
    case Scene::Kind::ended:
      return {};
  }
  return {};
}

}  // namespace asperity
