// Holds a table of titles and units by the name of the item, and groups items by subject.

#include "app/gui/devices/profile_words.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QtCore/QCoreApplication>
#include <QtCore/QDateTime>
#include <QtCore/QLocale>

#include "app/gui/look/words.h"

namespace asperity {

namespace {

/// For lupdate: what is not said by a widget.
class ProfileWords {
  Q_DECLARE_TR_FUNCTIONS(ProfileWords)
};

enum class Subject { timing, safety, mechanics };

struct ItemWords {
  const char* name = nullptr;
  Subject subject = Subject::mechanics;
  const char* title = nullptr;
  double scale = 1.0;
  const char* unit = "";
};

constexpr std::array<ItemWords, 20> kItemWords{
    {{"rate_Hz", Subject::timing, QT_TRANSLATE_NOOP("ProfileWords", "Servo rate"), 1.0, "Hz"},
     {"lateness_p50_s", Subject::timing, QT_TRANSLATE_NOOP("ProfileWords", "Lateness, median"), 1e6,
      "µs"},
     {"lateness_p99_s", Subject::timing,
      QT_TRANSLATE_NOOP("ProfileWords", "Lateness, 99th percentile"), 1e6, "µs"},
     {"lateness_max_s", Subject::timing, QT_TRANSLATE_NOOP("ProfileWords", "Lateness, maximum"),
      1e6, "µs"},
     {"missed_deadlines", Subject::timing, QT_TRANSLATE_NOOP("ProfileWords", "Missed deadlines")},
     {"force_zero_N", Subject::safety, QT_TRANSLATE_NOOP("ProfileWords", "Force without a surface"),
      1.0, "N"},
     {"position_noise_m", Subject::mechanics,
      QT_TRANSLATE_NOOP("ProfileWords", "Position noise at rest"), 1e6, "µm"},
     {"limiter", Subject::safety,
      QT_TRANSLATE_NOOP("ProfileWords", "Compliance with the force limit")},
     {"zero_after_stop", Subject::safety,
      QT_TRANSLATE_NOOP("ProfileWords", "Zero force after a stop")},
     {"zero_after_not_finite", Subject::safety,
      QT_TRANSLATE_NOOP("ProfileWords", "Zero force instead of a force that is not finite")},
     {"zero_without_heartbeat", Subject::safety,
      QT_TRANSLATE_NOOP("ProfileWords", "Zero force when the program stops responding")},
     {"friction_N", Subject::mechanics, QT_TRANSLATE_NOOP("ProfileWords", "Friction"), 1.0, "N"},
     {"damping_N_s_per_m", Subject::mechanics, QT_TRANSLATE_NOOP("ProfileWords", "Damping"), 1.0,
      "N s/m"},
     {"position_resolution_m", Subject::mechanics,
      QT_TRANSLATE_NOOP("ProfileWords", "Position step"), 1e6, "µm"},
     {"latency_s", Subject::mechanics, QT_TRANSLATE_NOOP("ProfileWords", "Latency"), 1e3, "ms"},
     {"moving_mass_kg", Subject::mechanics, QT_TRANSLATE_NOOP("ProfileWords", "Moving mass"), 1e3,
      "g"},
     {"resonance_Hz", Subject::mechanics, QT_TRANSLATE_NOOP("ProfileWords", "Lowest resonance"),
      1.0, "Hz"},
     {"stiffness_N_per_m", Subject::mechanics,
      QT_TRANSLATE_NOOP("ProfileWords", "Stiffest stable spring"), 1.0, "N/m"},
     {"force_resolution_N", Subject::mechanics,
      QT_TRANSLATE_NOOP("ProfileWords", "Smallest force that moves the handle"), 1.0, "N"},
     {"workspace_reached", Subject::mechanics,
      QT_TRANSLATE_NOOP("ProfileWords", "Fraction of the workspace reached"), 100.0, "%"}}};

const ItemWords* words_for(const std::string& name) {
  const auto found = std::find_if(kItemWords.begin(), kItemWords.end(),
                                  [&name](const ItemWords& words) { return name == words.name; });
  return found == kItemWords.end() ? nullptr : &*found;
}

/// Four digits are more than any of these is good for, and none is written with an exponent.
QString in_digits(double value) {
  const double size = std::abs(value);
  if (size == 0.0 || !std::isfinite(value)) return QString::number(value);
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
  QString text = shown_number(value, 'f', std::clamp(3 - before, 0, 6));
  const QString point = QLocale().decimalPoint();
  if (text.contains(point)) {
    while (text.endsWith('0')) text.chop(1);
    if (text.endsWith(point)) text.chop(1);
  }
  return text;
}

}  // namespace

QString title_of_item(const std::string& name) {
  const ItemWords* const words = words_for(name);
  return words == nullptr ? QString::fromStdString(name)
                          : QCoreApplication::translate("ProfileWords", words->title);
}

QString value_in_words(const std::string& name, double value) {
  const ItemWords* const words = words_for(name);
  if (words == nullptr) return in_digits(value);
  const QString unit = QString::fromUtf8(words->unit);
  return in_digits(words->scale * value) + (unit.isEmpty() ? "" : " " + unit);
}

QString limit_in_words(const DeviceItem& item) {
  if (!item.limit) return {};
  return (item.bound == DeviceItem::Bound::at_most ? "≤ " : "≥ ") +
         value_in_words(item.name, *item.limit);
}

ItemResult result_of(const DeviceItem& item) {
  switch (item.status) {
    case DeviceItem::Status::pass:
      if (item.is_only_told()) return {State::unknown, ProfileWords::tr("no limit")};
      return {State::fine, ProfileWords::tr("pass")};
    case DeviceItem::Status::fail:
      return {State::stop, ProfileWords::tr("fail")};
    case DeviceItem::Status::not_measured:
      break;
  }
  return {State::look, ProfileWords::tr("not measured")};
}

std::vector<ItemGroup> groups_of(const DeviceProfile& profile) {
  std::vector<ItemGroup> groups{
      {ProfileWords::tr("Safety")}, {ProfileWords::tr("Timing")}, {ProfileWords::tr("Mechanics")}};
  for (const DeviceItem& item : profile.items) {
    const ItemWords* const words = words_for(item.name);
    const Subject subject = words == nullptr ? Subject::mechanics : words->subject;
    const std::size_t place = subject == Subject::safety ? 0 : subject == Subject::timing ? 1 : 2;
    groups[place].items.push_back(&item);
  }
  return groups;
}

ItemResult verdict_of(const DeviceProfile& profile) {
  const auto count = [&profile](State state) {
    return std::count_if(
        profile.items.begin(), profile.items.end(),
        [state](const DeviceItem& item) { return result_of(item).state == state; });
  };
  QStringList parts{};
  if (const auto failed = count(State::stop); failed > 0) {
    parts << ProfileWords::tr("%1 failed").arg(failed);
  }
  parts << ProfileWords::tr("%1 passed").arg(count(State::fine));
  if (const auto missing = count(State::look); missing > 0) {
    parts << ProfileWords::tr("%1 not measured").arg(missing);
  }
  const State state = profile.has_failed()       ? State::stop
                      : profile.has_open_limit() ? State::look
                                                 : State::fine;
  return {state, parts.join(", ")};
}

ItemResult short_verdict_of(const DeviceProfile& profile) {
  const auto failed =
      std::count_if(profile.items.begin(), profile.items.end(),
                    [](const DeviceItem& item) { return item.status == DeviceItem::Status::fail; });
  if (failed > 0) return {State::stop, ProfileWords::tr("%1 failed").arg(failed)};
  return {State::fine, ProfileWords::tr("pass")};
}

QString text_of_age(double days) {
  if (days < 1.0) return ProfileWords::tr("less than a day");
  if (days < 1.5) return ProfileWords::tr("a day");
  return ProfileWords::tr("%1 days").arg(std::lround(days));
}

QString date_in_words(const std::string& utc) {
  const QDateTime date = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODateWithMs);
  if (!date.isValid()) return QString::fromStdString(utc);
  return date.toLocalTime().toString("yyyy-MM-dd HH:mm");
}

}  // namespace asperity
