// Looks phrases up in the translations of Qt, with the decimal point of the locale.

#include "app/gui/look/words.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <string_view>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>
#include <QtCore/QRegularExpression>
#include <QtCore/QTranslator>
#include <QtGui/QFontMetrics>
#include <QtGui/QTextDocument>

#include "stimuli/properties/other_unit.h"

namespace asperity {

namespace {

/// What a window says where a command names an option or another command.
struct DriverWords {
  Q_DECLARE_TR_FUNCTIONS(DriverWords)
};

/// "-10.0" → "−10,0"; what is not a number stays.
std::string with_point_of_locale(const QLocale& locale, const char* words) {
  static const QRegularExpression kNumber("^[-−]?[0-9]+(\\.[0-9]+)?$");
  QString text = QString::fromUtf8(words);
  if (kNumber.match(text).hasMatch()) {
    text.replace('.', locale.decimalPoint());
    if (text.startsWith('-')) text.replace(0, 1, "−");
  }
  return text.toStdString();
}

}  // namespace

QString text_of(const QTextDocument& document) {
  QString text = document.toRawText();
  text.replace(QChar::ParagraphSeparator, '\n');
  return text;
}

std::vector<QString> pieces_of(const QString& text, QTextBoundaryFinder::BoundaryType type) {
  std::vector<QString> pieces{};
  QTextBoundaryFinder finder(type, text);
  qsizetype from = 0;
  for (qsizetype to = finder.toNextBoundary(); to >= 0; to = finder.toNextBoundary()) {
    pieces.push_back(text.mid(from, to - from));
    from = to;
  }
  if (from < text.size()) pieces.push_back(text.mid(from));
  return pieces;
}

double width_of_longest_word(const QString& text, const QFontMetricsF& metrics) {
  double longest = 0.0;
  for (const QString& word : pieces_of(text, QTextBoundaryFinder::Line)) {
    longest = std::max(longest, metrics.horizontalAdvance(word.trimmed()));
  }
  return longest;
}

Phrase::LookUp language_of_windows() {
  return [](const char* context, const char* words) {
    if (context == nullptr) return std::string(words);
    return QCoreApplication::translate(context, words).toStdString();
  };
}

Phrase::LookUp words_of_windows() {
  return [look = language_of_windows()](const char* context, const char* words) {
    const bool is_number = context == nullptr || std::string_view(context) == kNumbersOfFile;
    return is_number ? with_point_of_locale(QLocale(), words) : look(context, words);
  };
}

QString words_in_language(const std::string& tag, const Phrase& phrase) {
  // Loaded once each: a picture of the participant is laid out many times a second, and the thread of a session that
  // fails needs them too.
  static std::mutex mutex{};
  const std::lock_guard lock(mutex);
  static std::map<std::string, QTranslator> texts_of{};
  const QLocale locale(QString::fromStdString(tag));
  const auto [texts, is_new] = texts_of.try_emplace(tag);
  if (is_new && !texts->second.load(locale, "asperity", "_", ":/translations")) {
    (void)texts->second.load("asperity_en", ":/translations");
  }
  return QString::fromStdString(
      phrase.translated([&](const char* context, const char* words) -> std::string {
        if (context == nullptr) return with_point_of_locale(locale, words);
        const QString found = texts->second.translate(context, words);
        return found.isEmpty() ? words : found.toStdString();
      }));
}

QString words_of(const Phrase& phrase) {
  return words_of(phrase, DriverWords::tr("“Set up…” on the Devices page"));
}

QString words_as_published(const Phrase& phrase) {
  return QString::fromStdString(phrase.translated(language_of_windows()));
}

QString with_unbroken_numbers(QString text) {
  static const QString kNoBreakSpace(QChar::Nbsp);
  constexpr qsizetype kLongestInterval = 40;  // a longer one may be wider than its label
  static const QRegularExpression kInterval("\\[[-−]?[.0-9][^\\[\\]]*\\]");
  for (auto found = kInterval.globalMatch(text); found.hasNext();) {
    const QRegularExpressionMatch interval = found.next();
    if (interval.capturedLength() > kLongestInterval) continue;
    // As many characters as before: the places of the other matches stay.
    text.replace(interval.capturedStart(), interval.capturedLength(),
                 interval.captured().replace(' ', kNoBreakSpace));
  }
  static const QRegularExpression kRelation(" ([=<>≤≥≈±]) (?=[-−]?[.0-9])");
  text.replace(kRelation, kNoBreakSpace + "\\1" + kNoBreakSpace);
  static const QRegularExpression kPercent("(?<=[0-9]) %");
  text.replace(kPercent, kNoBreakSpace + '%');
  text.replace("% CI", '%' + kNoBreakSpace + "CI");
  static const QRegularExpression kLeadingPoint("(?<=^|[\\s\\x{00a0}\\[(−-])\\.(?=[0-9])");
  text.replace(kLeadingPoint, QString('.') + QChar(0x2060));
  return text;
}

QString sentences_as_published(const Phrase& phrase) {
  return with_unbroken_numbers(words_as_published(phrase));
}

QString shown_number(double value, char format, int precision) {
  QString text = QLocale().toString(value, format, precision);
  if (text.startsWith('-')) text.replace(0, 1, "−");
  return text;
}

QString words_of(const Phrase& phrase, const QString& control) {
  QString words = QString::fromStdString(phrase.translated(words_of_windows()));
  if (words.contains("--")) {
    for (const char* option : {"--firmware FILE", "--library FILE", "--service HOST:PORT"}) {
      words.replace(option, control);
    }
  }
  if (words.contains("\"asperity device-test")) {
    static const QRegularExpression kCommand("\"asperity device-test[^\"]*\"");
    words.replace(kCommand, DriverWords::tr("“Test this device…” on the Devices page"));
  }
  return words;
}

Phrase offered_or_typed(const QString& text, const std::vector<Phrase>& offered) {
  const auto chosen = std::find_if(offered.begin(), offered.end(),
                                   [&text](const Phrase& one) { return words_of(one) == text; });
  return chosen == offered.end() ? Phrase(text.toStdString()) : *chosen;
}

QString with_remark(const QString& said, const std::optional<Phrase>& remark) {
  return remark ? said + ' ' + words_of(*remark) : said;
}

}  // namespace asperity
