// Reads and writes QSettings: recent studies, theme, language, phrases, plug-ins, devices and geometry.

#include "app/gui/base/settings.h"

#include <algorithm>
#include <iterator>
#include <system_error>

#include <QtCore/QCoreApplication>
#include <QtCore/QCryptographicHash>
#include <QtCore/QDir>
#include <QtCore/QLibraryInfo>
#include <QtCore/QLocale>
#include <QtCore/QSettings>
#include <QtCore/QTranslator>
#include <QtWidgets/QWidget>

#include "app/gui/look/words.h"

namespace asperity {

namespace {

constexpr std::size_t kMostRecent = 10;

void write_recent(const std::vector<RecentStudy>& studies) {
  QSettings settings{};
  settings.beginWriteArray("recent", static_cast<int>(studies.size()));
  for (std::size_t i = 0; i < studies.size(); ++i) {
    settings.setArrayIndex(static_cast<int>(i));
    settings.setValue("folder", path_text(studies[i].folder));
    settings.setValue("name", studies[i].name);
    settings.setValue("used", studies[i].used);
  }
  settings.endArray();
}

/// The texts of one origin, in place of those that were there under its name.
template <typename Load>
void exchange_texts(const QString& name, const Load& load) {
  QCoreApplication* const program = QCoreApplication::instance();
  delete program->findChild<QTranslator*>(name);  // takes its texts with it
  auto* translator = new QTranslator(program);
  translator->setObjectName(name);
  if (load(*translator)) QCoreApplication::installTranslator(translator);
}

}  // namespace

std::vector<RecentStudy> recent_studies() {
  std::vector<RecentStudy> studies{};
  QSettings settings{};
  const int count = settings.beginReadArray("recent");
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    studies.push_back({settings.value("folder").toString().toStdString(),
                       settings.value("name").toString(), settings.value("used").toDateTime()});
  }
  settings.endArray();
  return studies;
}

void remember_study(const std::filesystem::path& folder, const QString& name) {
  std::vector<RecentStudy> studies = recent_studies();
  std::erase_if(studies, [&folder](const RecentStudy& study) { return study.folder == folder; });
  studies.insert(studies.begin(), {folder, name, QDateTime::currentDateTime()});
  if (studies.size() > kMostRecent) studies.resize(kMostRecent);
  write_recent(studies);
}

void forget_study(const std::filesystem::path& folder) {
  std::vector<RecentStudy> studies = recent_studies();
  std::erase_if(studies, [&folder](const RecentStudy& study) { return study.folder == folder; });
  write_recent(studies);
}

std::filesystem::path place_of_studies() {
  const std::vector<RecentStudy> studies = recent_studies();
  std::error_code ignored{};
  for (const RecentStudy& study : studies) {
    const std::filesystem::path place = study.folder.parent_path();
    if (std::filesystem::is_directory(place, ignored)) return place;
  }
  return (QDir::homePath() + "/Asperity").toStdString();
}

ThemeChoice theme_choice() {
  const QString name = QSettings{}.value("theme").toString();
  if (name == "light") return ThemeChoice::light;
  if (name == "dark") return ThemeChoice::dark;
  return ThemeChoice::system;
}

void remember_theme(ThemeChoice choice) {
  const char* name = "system";
  if (choice == ThemeChoice::light) name = "light";
  if (choice == ThemeChoice::dark) name = "dark";
  QSettings{}.setValue("theme", name);
}

QString language_choice() { return QSettings{}.value("language", "system").toString(); }

void remember_language(const QString& code) { QSettings{}.setValue("language", code); }

QStringList available_languages() {
  QStringList codes{"en"};
  for (const QString& file : QDir(":/translations").entryList({"asperity_*.qm"})) {
    const QString code = file.mid(9, file.size() - 12);
    if (code != "en") codes.append(code);
  }
  return codes;
}

void apply_language(const QString& choice) {
  QLocale locale = choice == "system" ? QLocale::system() : QLocale(choice);
  // "1000" reads alike everywhere; with separators it is one thing or another.
  locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  QLocale::setDefault(locale);
  exchange_texts("asperity-texts", [&locale](QTranslator& texts) {
    return texts.load(locale, "asperity", "_", ":/translations") ||
           texts.load("asperity_en", ":/translations");
  });
  exchange_texts("qt-texts", [&locale](QTranslator& texts) {
    return texts.load(locale, "qtbase", "_", QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  });
}

QStringList note_phrases() { return QSettings{}.value("note_phrases").toStringList(); }

void remember_note_phrases(const QStringList& phrases) {
  QSettings{}.setValue("note_phrases", phrases);
}

namespace {

constexpr const char* kPlugins = "plugins";

}  // namespace

std::vector<std::filesystem::path> plugin_files() {
  std::vector<std::filesystem::path> files{};
  for (const QString& file : QSettings{}.value(kPlugins).toStringList()) {
    files.emplace_back(file.toStdString());
  }
  return files;
}

void remember_plugin_files(const std::vector<std::filesystem::path>& files) {
  QStringList names{};
  for (const std::filesystem::path& file : files) {
    names.append(QString::fromStdString(file.string()));
  }
  QSettings{}.setValue(kPlugins, names);
}

namespace {

/// Names of keys have no slashes of their own.
QString device_key(const std::filesystem::path& study) {
  const std::string folder = std::filesystem::weakly_canonical(study).string();
  const QByteArray hash =
      QCryptographicHash::hash(QByteArray::fromStdString(folder), QCryptographicHash::Sha256);
  return "devices/of_study/" + QString::fromLatin1(hash.toHex().left(32));
}

struct Need {
  const char* driver = nullptr;
  DriverNeed need{};
  const char* key = nullptr;
};
/// A library each: that of one maker is none of the other's.
constexpr Need kNeeds[] = {
    {"falcon", DriverNeed::firmware, "devices/firmware"},
    {"force_dimension", DriverNeed::library, "devices/library/force_dimension"},
    {"openhaptics", DriverNeed::library, "devices/library/openhaptics"},
    {"inverse3", DriverNeed::service, "devices/service"}};

const Need* entry_of(const std::string& driver) {
  const auto* const found = std::find_if(std::begin(kNeeds), std::end(kNeeds),
                                         [&](const Need& need) { return need.driver == driver; });
  return found == std::end(kNeeds) ? nullptr : found;
}

}  // namespace

std::string remembered_device(const std::filesystem::path& study) {
  return QSettings().value(device_key(study)).toString().toStdString();
}

void remember_device(const std::filesystem::path& study, const std::string& device) {
  QSettings().setValue(device_key(study), QString::fromStdString(device));
}

std::optional<DriverNeed> need_of(const std::string& driver) {
  const Need* const need = entry_of(driver);
  return need == nullptr ? std::nullopt : std::optional(need->need);
}

std::string driver_place(const std::string& driver) {
  const Need* const need = entry_of(driver);
  return need == nullptr ? std::string{} : QSettings().value(need->key).toString().toStdString();
}

void remember_driver_place(const std::string& driver, const std::string& place) {
  const Need* const need = entry_of(driver);
  if (need == nullptr) return;
  if (place.empty()) {
    QSettings().remove(need->key);
  } else {
    QSettings().setValue(need->key, QString::fromStdString(place));
  }
}

std::map<std::string, std::string> driver_places() {
  std::map<std::string, std::string> places{};
  for (const Need& need : kNeeds) {
    if (const std::string place = driver_place(need.driver); !place.empty()) {
      places[need.driver] = place;
    }
  }
  return places;
}

DriverOptions driver_options(const std::string& device) {
  const std::string driver = device.substr(0, device.find(':'));
  DriverOptions options{};
  options.closing_program =
      QCoreApplication::instance()->property(kClosingProgram).toString().toStdString();
  const std::optional<DriverNeed> need = need_of(driver);
  if (!need) return options;
  switch (*need) {
    case DriverNeed::firmware:
      options.firmware = driver_place(driver);
      break;
    case DriverNeed::library:
      options.library = driver_place(driver);
      break;
    case DriverNeed::service:
      options.service = driver_place(driver);
      break;
  }
  return options;
}

bool restore_geometry(QWidget& window, const QString& name) {
  return window.restoreGeometry(QSettings{}.value("geometry/" + name).toByteArray());
}

void remember_geometry(const QWidget& window, const QString& name) {
  QSettings{}.setValue("geometry/" + name, window.saveGeometry());
}

}  // namespace asperity
