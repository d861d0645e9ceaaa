#include "app/gui/look/words.h"

#include <QtCore/QCoreApplication>

namespace asperity {

QString words_of(const Phrase& phrase) {
  return QString::fromStdString(phrase.translated([](const char* context, const char* words) {
    return QCoreApplication::translate(context, words).toStdString();
  }));
}

}  // namespace asperity
