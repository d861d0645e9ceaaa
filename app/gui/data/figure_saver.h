// Saves figures where a person says, and copies them.

#pragma once

#include <filesystem>
#include <string>

#include <QtCore/QObject>

#include "app/findings/outcome/figure.h"
#include "app/gui/look/background_task.h"
#include "results_schema/files/atomic_file.h"

class QWidget;

namespace asperity {

class Banner;

/// Asks for a file in a dialog of `page`; what came of it stands on `banner`. A file that is there
/// is replaced only when the person says so there. Both outlive the saver.
class FigureSaver final : public QObject {
  Q_OBJECT
 public:
  FigureSaver(Banner& banner, QWidget& page);

  /// `name`: proposed, without an ending.
  void ask_where_to_save(const Figure& figure, double width_mm, const std::string& name);
  /// As a picture and as SVG, so that a program takes what it can.
  void copy(const Figure& figure);

 signals:
  void copied();

 private:
  void save(const Figure& figure, double width_mm, const std::filesystem::path& file,
            Overwrite overwrite);

  Banner& banner_;
  QWidget& page_;
  BackgroundTask saving_{};
  BackgroundTask copying_{};
};

}  // namespace asperity
