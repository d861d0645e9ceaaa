#include "app/gui/look/words.h"

#include <QtCore/QCoreApplication>

namespace asperity {

Phrase::LookUp language_of_windows() {
  return [](const char* context, const char* words) {
    return QCoreApplication::translate(context, words).toStdString();
  };
}

QString words_of(const Phrase& phrase) {
  return QString::fromStdString(phrase.translated(language_of_windows()));
}

}  // namespace asperity
