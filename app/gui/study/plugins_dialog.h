// Asks which plug-ins the windows load.

#pragma once

#include <filesystem>
#include <vector>

#include <QtWidgets/QDialog>

class QListWidget;

namespace asperity {

/// Lists the files of the plug-ins. Loads nothing itself.
class PluginsDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit PluginsDialog(const std::vector<std::filesystem::path>& files,
                         QWidget* parent = nullptr);

 signals:
  void wanted(const std::vector<std::filesystem::path>& files);

 private:
  void add_files();
  std::vector<std::filesystem::path> listed_files() const;

  QListWidget* list_ = nullptr;
};

}  // namespace asperity
