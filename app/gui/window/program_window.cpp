// Creates the application, turns fatal errors of Qt into a sentence, and shows the study window.

#include "app/gui/window/program_window.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <QtGui/QIcon>
#include <QtWidgets/QApplication>
#include <locale.h>

#include "app/gui/base/settings.h"
#include "app/gui/look/theme.h"
#include "app/gui/window/session_desk.h"
#include "app/gui/window/study_window.h"
#include "app/study_files/program.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

constexpr const char* kNoScreen =
    "start asperity in a graphical session, or use a subcommand: asperity --help lists them";

/// For as long as the application is being made: what Qt gives up on becomes a sentence and the
/// exit status 1, where Qt would abort.
void end_in_order(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type != QtFatalMsg) return;
  std::fprintf(stderr, "asperity: no window can be shown (%s); %s\n", qPrintable(text.simplified()),
               kNoScreen);
  std::_Exit(1);
}

}  // namespace

int run_windows(int& argc, char** argv, const std::optional<std::filesystem::path>& study) {
  if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
      qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    throw std::runtime_error(
        "there is no screen to show a window on (neither DISPLAY nor WAYLAND_DISPLAY is set); " +
        std::string(kNoScreen));
  }
  const QtMessageHandler usual = qInstallMessageHandler(end_in_order);
  QApplication application(argc, argv);
  qInstallMessageHandler(usual);
  setlocale(LC_NUMERIC, "C");  // QApplication takes over the person's
  QApplication::setOrganizationName("asperity");
  QApplication::setApplicationName("asperity");
  QApplication::setDesktopFileName("asperity");
  application.setProperty(kClosingProgram, QString::fromStdString(program_file().string()));
  QApplication::setWindowIcon(QIcon(":/look/asperity.svg"));
  apply_theme(application, theme_choice());
  apply_language(language_choice());
  Study::read_beside_writers();
  StudyWindow window{};
  const SessionDesk desk(window, nullptr);
  if (study) window.open_study(*study);
  window.show();
  return QApplication::exec();
}

}  // namespace asperity
