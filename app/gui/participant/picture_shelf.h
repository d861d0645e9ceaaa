// The pictures of a study, decoded and scaled away from the GUI thread, each once.

#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtGui/QImage>
#include <QtGui/QPixmap>

#include "app/gui/look/background_task.h"

namespace asperity {

/// Pictures as squares: the largest centred square of each, so that all are equal in size whatever
/// the photographs' proportions, and none can be told by its shape.
class PictureShelf final : public QObject {
  Q_OBJECT
 public:
  explicit PictureShelf(std::filesystem::path study, QObject* parent = nullptr);

  /// From now on, and of those that are there.
  void show_in_grey();
  /// The picture `side` pixels wide, or a null one: then it is being prepared, and `arrived` follows.
  /// What cannot be read stays null and is told once by `unreadable`.
  QPixmap picture(const QString& name, int side);
  /// It is there, or will never be.
  bool is_settled(const QString& name, int side) const;
  /// Decodes these before they are asked for.
  void prepare(const std::vector<QString>& names, int side);

 signals:
  void arrived();
  void unreadable(const QString& name);

 private:
  using Wanted = std::pair<QString, int>;
  void fetch();

  std::filesystem::path study_;
  bool in_grey_ = false;
  std::map<QString, QImage> squares_{};  ///< as large as they are ever shown
  std::map<Wanted, QPixmap> scaled_{};
  std::set<Wanted> wanted_{};
  std::set<QString> unreadable_{};
  BackgroundTask task_{};
};

}  // namespace asperity
