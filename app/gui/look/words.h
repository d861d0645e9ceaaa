// What is said where there is no Qt, in the language of the windows.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <QtCore/QString>
#include <QtCore/QTextBoundaryFinder>

#include "analysis/words/phrase.h"

class QFontMetricsF;
class QTextDocument;

namespace asperity {

/// What finds the words of the windows' language. Any thread.
Phrase::LookUp language_of_windows();
/// The same, with the decimal point of the user's locale in numbers. Any thread.
Phrase::LookUp words_of_windows();
/// The words in the language of a BCP 47 tag ("de", "de-AT"), whatever that of the windows: what the program
/// tells a participant follows the protocol. English where the program does not have the language. Any thread.
QString words_in_language(const std::string& tag, const Phrase& phrase);

/// Drivers speak to people at a terminal as well: where they name an option or a command, what is said here is the
/// control of the windows that does the same. Any thread.
QString words_of(const Phrase& phrase);
/// Likewise where what an option tells is told right here: by `control`.
QString words_of(const Phrase& phrase, const QString& control);

/// What was chosen or typed where a window offers these: the one that it shows as `text`, otherwise what was typed.
Phrase offered_or_typed(const QString& text, const std::vector<Phrase>& offered);

/// A sentence, followed by the remark if there is one.
QString with_remark(const QString& said, const std::optional<Phrase>& remark);

/// What a study or a protocol says, as it is written there. Any thread.
inline QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

/// Every character of a document as it stands there, lines ended by '\n' (`toPlainText` makes plain spaces of no-break
/// spaces).
QString text_of(const QTextDocument& document);

/// A path as the system writes it.
inline QString path_text(const std::filesystem::path& path) { return text(path.string()); }

/// The same for findings, whose numbers have a point, as in reports, figures and files.
QString words_as_published(const Phrase& phrase);

/// The text for a label that breaks lines, which keeps numbers together: ".001", "p < .05", "± 2", "95 % CI" and "[.00, .64]". For display
/// only: it contains no-break spaces, and word joiners (U+2060) after full stops, because Qt breaks lines between a full stop and the digits
/// after it.
QString with_unbroken_numbers(QString text);
/// `words_as_published` for such a label; for cells of tables and what is copied, use `words_as_published`.
QString sentences_as_published(const Phrase& phrase);

/// The words, lines, or sentences of a text, each with the spaces after it.
std::vector<QString> pieces_of(const QString& text, QTextBoundaryFinder::BoundaryType type);
/// The width below which a label that breaks lines cuts the text.
double width_of_longest_word(const QString& text, const QFontMetricsF& metrics);

/// A number as windows show it: in the user's locale, without separators of thousands and with a minus sign (−). `format` and `precision` as
/// QString::number.
QString shown_number(double value, char format, int precision);

}  // namespace asperity
