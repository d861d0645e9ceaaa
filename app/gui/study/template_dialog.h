// Declares the dialog in which a template for a new protocol is chosen.

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <QtWidgets/QDialog>

#include "app/gui/look/background_task.h"
#include "app/tasks/template_overviews.h"

class QLabel;
class QListWidget;
class QPushButton;
class QRadioButton;

namespace asperity {

class ScreenPreview;
class StudyTable;

/// The protocols of the library by title, with what each asks, how long it takes and what its participants see; then the textures that the new protocol has.
class TemplateDialog final : public QDialog {
  Q_OBJECT
 public:
  /// The models outlive it.
  TemplateDialog(const std::filesystem::path& study, const ModelRegistry& models,
                 QWidget* parent = nullptr);

 signals:
  void wanted(const std::string& name, const asperity::TemplateTextures& textures);

 private:
  struct Content {
    std::vector<TemplateOverview> templates{};
    std::vector<OwnTexture> reliefs{};
  };

  QWidget* make_detail(const std::filesystem::path& study);
  void show_content(Content content);
  void show_chosen();
  void show_screens(const TemplateOverview& overview);
  void show_what_follows();
  const TemplateOverview* chosen() const;
  TemplateTextures textures() const;

  Content content_{};
  StudyTable* table_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* facts_ = nullptr;
  QLabel* description_ = nullptr;
  ScreenPreview* screen_ = nullptr;
  std::shared_ptr<const Protocol> protocol_{};  ///< of the screens
  std::shared_ptr<const Plan> plan_{};
  QWidget* surfaces_ = nullptr;
  QLabel* needs_ = nullptr;
  QRadioButton* own_ = nullptr;
  QRadioButton* copied_ = nullptr;
  QListWidget* reliefs_ = nullptr;
  QLabel* what_follows_ = nullptr;
  QPushButton* create_ = nullptr;
  BackgroundTask task_{};
};

}  // namespace asperity
