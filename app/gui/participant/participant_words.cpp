#include "app/gui/participant/participant_words.h"

#include <QtCore/QCoreApplication>

namespace asperity {

namespace {

class Words final {
  Q_DECLARE_TR_FUNCTIONS(ParticipantWords)
 public:
  static QString of(const Saying& saying);
};

QString number_of(const std::optional<double>& value) {
  return value ? QString::number(*value, 'g', 12) : QString();
}

QString Words::of(const Saying& saying) {
  const QString code = QString::fromStdString(saying.code);
  switch (saying.what) {
    case Saying::What::nothing:
      return {};
    case Saying::What::feel_surface:
      return tr("Feel surface %1 now.").arg(code);
    case Saying::What::lift:
      return tr("That is enough of surface %1. Please lift.").arg(code);
    case Saying::What::put_mask_on:
      return tr("Please put on the eye mask.");
    case Saying::What::take_mask_off:
      return tr("Please take off the eye mask.");
    case Saying::What::cannot_tell:
      return tr("I cannot tell");
    case Saying::What::feel_first:
      return tr("Please feel surface %1 first.").arg(code);
    case Saying::What::feel_longer:
      return tr("Please feel surface %1 a little longer.").arg(code);
    case Saying::What::not_asked_yet:
      return tr("Please wait for the question.");
    case Saying::What::wait:
      return tr("Please wait %n more second(s).", "", saying.number);
    case Saying::What::choose_first:
      return tr("Please choose first.");
    case Saying::What::assign_first:
      return tr("Please give surface %1 a picture first.").arg(code);
    case Saying::What::feel_again:
      return tr("Confirm to feel surface %1 again.").arg(code);
    case Saying::What::no_going_back:
      return tr("The surfaces cannot be felt again.");
    case Saying::What::was_right:
      return tr("That was right.");
    case Saying::What::was_wrong:
      if (code.isEmpty()) return tr("That was not right.");
      return tr("That was not right. The right answer: %1").arg(code);
    case Saying::What::answer_needed:
      return tr("This question needs an answer.");
    case Saying::What::number_needed:
      if (saying.minimum && saying.maximum) {
        return tr("A number from %1 to %2 is needed.")
            .arg(number_of(saying.minimum), number_of(saying.maximum));
      }
      if (saying.minimum) {
        return tr("A number is needed, %1 or more.").arg(number_of(saying.minimum));
      }
      if (saying.maximum) {
        return tr("A number is needed, %1 or less.").arg(number_of(saying.maximum));
      }
      return tr("A number is needed.");
    case Saying::What::option_needed:
      return tr("Please choose one of the answers.");
  }
  return {};
}

}  // namespace

QString words_of(const Saying& saying, const std::string& text) {
  if (saying.what == Saying::What::nothing) return QString::fromStdString(text);
  // Without a translation the plural of a number is not made: English says it by itself.
  if (saying.what == Saying::What::wait) {
    const QString translated = Words::of(saying);
    return translated.contains("(s)") ? QString::fromStdString(text_of(saying)) : translated;
  }
  return Words::of(saying);
}

}  // namespace asperity
