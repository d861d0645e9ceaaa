// What the program remembers of its user from one start to the next.

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QtCore/QDateTime>
#include <QtCore/QString>
#include <QtCore/QStringList>

#include "app/gui/look/theme.h"
#include "device/drivers.h"

class QWidget;

namespace asperity {

/// A study that was open once.
struct RecentStudy {
  std::filesystem::path folder{};
  QString name{};
  QDateTime used{};
};

/// At most ten, the latest first. A study that is gone stays in the list until it is forgotten.
std::vector<RecentStudy> recent_studies();
void remember_study(const std::filesystem::path& folder, const QString& name);
void forget_study(const std::filesystem::path& folder);

/// The folder that studies are made in: where the last one was made or opened, at first one of the
/// program's own in the home folder.
std::filesystem::path place_of_studies();

ThemeChoice theme_choice();
void remember_theme(ThemeChoice choice);

/// "system", or the code of a language: "en", "de".
QString language_choice();
void remember_language(const QString& code);
/// The codes of those that the program has texts in: every :/translations/asperity_CODE.qm. English
/// is the first; its file holds plurals alone, the program is written in English.
QStringList available_languages();
/// Its texts from now on in that language, or in English where there are none; windows that are open
/// have to be filled anew. Qt's own texts, of its dialogs and menus, follow where they are installed.
void apply_language(const QString& choice);

/// Notes of the experimenter's own that a click writes, the latest last.
QStringList note_phrases();
void remember_note_phrases(const QStringList& phrases);

/// The plug-ins with force models that the windows load with every study.
std::vector<std::filesystem::path> plugin_files();
void remember_plugin_files(const std::vector<std::filesystem::path>& files);

/// The device that sessions of a study ran on last, as RunInputs::device; empty where none has.
std::string remembered_device(const std::filesystem::path& study);
void remember_device(const std::filesystem::path& study, const std::string& device);

/// What a driver has to be told where it does not find it by itself: a file, or HOST:PORT of a service.
enum class DriverNeed { firmware, library, service };
/// Nothing for a driver that finds everything by itself.
std::optional<DriverNeed> need_of(const std::string& driver);
/// Where that is, as somebody has named it in a window; empty where nobody has. Commands are told by their options:
/// they neither read nor write it.
std::string driver_place(const std::string& driver);
void remember_driver_place(const std::string& driver, const std::string& place);  ///< empty: forget
/// All that were named, by driver.
std::map<std::string, std::string> driver_places();
/// What the windows tell the driver of `device`, which is named as DriverRegistry::open takes it. Any thread.
DriverOptions driver_options(const std::string& device);
/// The property of the application with DriverOptions::closing_program.
inline constexpr const char* kClosingProgram = "closing_program";

/// Where a window was, by its name; false when it has never been anywhere.
bool restore_geometry(QWidget& window, const QString& name);
void remember_geometry(const QWidget& window, const QString& name);

}  // namespace asperity
