// Declares the dialog in which a template for a new protocol is chosen.

#pragma once

#include <filesystem>
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

class StudyTable;

/// The protocols of the library by title, with what each asks and how long it takes; then the textures that the new protocol has.
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

  QWidget* make_detail();
  void show_content(Content content);
  void show_chosen();
  void show_what_follows();
  const TemplateOverview* chosen() const;
  TemplateTextures textures() const;

  Content content_{};
  StudyTable* table_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* facts_ = nullptr;
  QLabel* description_ = nullptr;
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
