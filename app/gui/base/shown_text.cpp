// Formats paths, times, levels, durations, kinds, vision and noise for the pages of a study.

#include "app/gui/base/shown_text.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QDateTime>
#include <QtCore/QDir>
#include <QtCore/QLocale>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/gui/look/words.h"
#include "app/tasks/study_overview.h"
#include "protocols/plan/course.h"

namespace asperity {

QString text_of_path(const std::filesystem::path& path) {
  const QString text = QString::fromStdString(path.string());
  const QString home = QDir::homePath();
  if (text == home || text.startsWith(home + '/')) return '~' + text.mid(home.size());
  return text;
}

std::filesystem::path path_of_text(const QString& text) {
  if (text == "~" || text.startsWith("~/")) return (QDir::homePath() + text.mid(1)).toStdString();
  return text.toStdString();
}

QString text_of_time(const std::string& utc) {
  const QString written = QString::fromStdString(utc);
  QDateTime time = QDateTime::fromString(written, Qt::ISODateWithMs);
  if (!time.isValid()) return written;
  time = time.toLocalTime();
  const QString clock = time.time().toString("HH:mm");
  const qint64 days = time.date().daysTo(QDate::currentDate());
  if (days == 0) return QCoreApplication::translate("asperity::ShownText", "today %1").arg(clock);
  if (days == 1) {
    return QCoreApplication::translate("asperity::ShownText", "yesterday %1").arg(clock);
  }
  return QCoreApplication::translate("asperity::ShownText", "%1, %2")
      .arg(time.date().toString(Qt::ISODate), clock);
}

QString text_of_start(const SessionRow& session) {
  return has_made_up_dates(session)
             ? QCoreApplication::translate("asperity::ShownText", "simulated clock")
             : text_of_time(session.started_utc);
}

QString order_of_start(const SessionRow& session) {
  constexpr int kDigits = 12;
  return has_made_up_dates(session) ? QString("%1").arg(session.id, kDigits, 10, QChar('0'))
                                    : QString::fromStdString(session.started_utc);
}

QString text_of_level(const std::string& factor, double level) {
  const std::string unit = unit_of_parameter(factor);
  const std::string number = unit.empty() ? number_text(level) : stated_quantity(level, unit);
  QString shown = text(number);
  shown.replace('.', QLocale().decimalPoint());
  return QString("%1 %2").arg(text(unit.empty() ? factor : words_of_parameter(factor)), shown);
}

bool is_length_estimated(const Protocol& protocol) {
  const auto& blocks = protocol.blocks;
  return has_estimated_trials(protocol) ||
         std::any_of(blocks.begin(), blocks.end(), [](const auto& named) {
           const Protocol::Block& block = named.second;
           return block.until || (block.procedure && block.procedure->catch_trials);
         });
}

QString text_of_duration(double duration_s) {
  const auto whole_s = static_cast<long>(std::lround(std::max(0.0, duration_s)));
  if (whole_s < 60) {
    return QCoreApplication::translate("asperity::ShownText", "%1 s").arg(whole_s);
  }
  const long minutes = (whole_s + 30) / 60;
  if (minutes < 60) {
    return QCoreApplication::translate("asperity::ShownText", "%1 min").arg(minutes);
  }
  return QCoreApplication::translate("asperity::ShownText", "%1 h %2 min")
      .arg(minutes / 60)
      .arg(minutes % 60, 2, 10, QChar('0'));
}

QString text_of_language(const std::string& tag) {
  const QLocale locale(text(tag));
  if (locale.language() == QLocale::C) return text(tag);
  // "en" alone is American English to Qt, which says so.
  if (locale.language() == QLocale::English) return QStringLiteral("English");
  return locale.nativeLanguageName();
}

QString text_of_kind(const std::string& kind) {
  const StudyAnalysis* const analysis = find_analysis(kind);
  return analysis == nullptr ? text(kind) : words_of(analysis->name);
}

QString text_of_vision(Vision vision) {
  switch (vision) {
    case Vision::free:
      return QCoreApplication::translate("asperity::ShownText", "hand and screen visible");
    case Vision::hand_occluded:
      return QCoreApplication::translate("asperity::ShownText", "hand hidden, screen visible");
    case Vision::blindfold:
      break;
  }
  return QCoreApplication::translate("asperity::ShownText", "blindfold");
}

QString text_of_noise(const Protocol::Noise& noise) {
  const bool is_pink = noise.kind == Protocol::Noise::Kind::pink;
  if (noise.kind == Protocol::Noise::Kind::none) {
    return QCoreApplication::translate("asperity::ShownText", "no masking noise");
  }
  if (!noise.level_dBA) {
    return is_pink ? QCoreApplication::translate("asperity::ShownText", "pink masking noise")
                   : QCoreApplication::translate("asperity::ShownText", "white masking noise");
  }
  const QString text =
      is_pink ? QCoreApplication::translate("asperity::ShownText", "pink masking noise, %1 dB(A)")
              : QCoreApplication::translate("asperity::ShownText", "white masking noise, %1 dB(A)");
  return text.arg(shown_number(*noise.level_dBA, 'f', 0));
}

}  // namespace asperity
