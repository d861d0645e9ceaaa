#include "app/gui/look/words.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QRegularExpression>

namespace asperity {

namespace {

/// What a window says where a command names an option or another command.
struct DriverWords {
  Q_DECLARE_TR_FUNCTIONS(DriverWords)
};

}  // namespace

Phrase::LookUp language_of_windows() {
  return [](const char* context, const char* words) {
    return QCoreApplication::translate(context, words).toStdString();
  };
}

QString words_of(const Phrase& phrase) {
  return words_of(phrase, DriverWords::tr("“Set up…” on the page Devices"));
}

QString words_of(const Phrase& phrase, const QString& control) {
  QString words = QString::fromStdString(phrase.translated(language_of_windows()));
  if (words.contains("--")) {
    for (const char* option : {"--firmware FILE", "--library FILE", "--service HOST:PORT"}) {
      words.replace(option, control);
    }
  }
  if (words.contains("\"asperity device-test")) {
    static const QRegularExpression kCommand("\"asperity device-test[^\"]*\"");
    words.replace(kCommand, DriverWords::tr("“Test this device…” on the page Devices"));
  }
  return words;
}

QString with_remark(const QString& said, const std::optional<Phrase>& remark) {
  return remark ? said + ' ' + words_of(*remark) : said;
}

}  // namespace asperity
