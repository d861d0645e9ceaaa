// Declares the dialog in which the values of a rendering are copied into a protocol.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QtWidgets/QDialog>

#include "app/gui/base/commands_button.h"
#include "app/gui/look/background_task.h"
#include "app/gui/look/newest_work.h"
#include "app/tasks/checked_rendering_use.h"
#include "app/tasks/template_overviews.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace asperity {

class OpenStudy;
class StateLabel;
class StudyTable;

/// Rendering, protocol and surface, with the changes of the protocol before they are made. The protocol that results is
/// checked first: one with a problem is not offered.
class UseRenderingDialog final : public QDialog {
  Q_OBJECT
 public:
  /// The unsaved text of a protocol in the editor; nothing where there is none.
  using UnsavedText = std::function<std::optional<std::string>(const std::filesystem::path&)>;

  /// Offers these renderings, one or several. `study` outlives the dialog.
  UseRenderingDialog(OpenStudy& study, std::vector<std::filesystem::path> renderings,
                     UnsavedText unsaved, QWidget* parent = nullptr);

 signals:
  /// `before` is the text that `after` was made from.
  void wanted(const std::filesystem::path& protocol, const std::string& before,
              const std::string& after, const QString& rendering);

 private:
  struct Result;

  void read_protocols(const std::filesystem::path& chosen);
  void choose_template();
  void fill_surfaces();
  void choose_surface();
  void show_changes();
  void take(const std::shared_ptr<const Result>& result);
  std::filesystem::path protocol() const;
  void set_usable(bool is_usable);
  std::vector<ShownCommand> commands() const;

  OpenStudy& study_;
  std::vector<std::filesystem::path> renderings_{};
  UnsavedText unsaved_{};
  std::vector<std::filesystem::path> protocols_{};
  std::vector<UsableSurface> usable_{};
  std::string before_{};
  std::uint64_t shown_ = 0;                 ///< number of the choice that is shown
  std::shared_ptr<const Result> result_{};  ///< of this choice; null while nothing can be done
  QComboBox* rendering_ = nullptr;
  QComboBox* protocol_ = nullptr;
  QComboBox* surface_ = nullptr;
  QCheckBox* keeps_texture_ = nullptr;
  StudyTable* changes_ = nullptr;
  QLabel* remarks_ = nullptr;
  StateLabel* state_ = nullptr;
  QPushButton* commands_ = nullptr;
  QPushButton* use_ = nullptr;
  BackgroundTask task_{};
  NewestWork work_{};
};

}  // namespace asperity
