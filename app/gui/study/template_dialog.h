// Declares the dialog in which a template for a new protocol is chosen.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QtWidgets/QDialog>

#include "app/gui/look/background_task.h"
#include "app/gui/look/newest_work.h"
#include "app/study_files/height_field_files.h"
#include "app/tasks/template_overviews.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QPushButton;
class QRadioButton;

namespace asperity {

class ChoiceBox;
class ScreenPreview;
class StateLabel;
class StudyTable;

/// The protocols of the library by title, with what each asks, how long it takes and what its participants see; then the
/// textures that the new protocol has. It is checked with them before it is created.
class TemplateDialog final : public QDialog {
  Q_OBJECT
 public:
  /// The models outlive it.
  TemplateDialog(const std::filesystem::path& study, const ModelRegistry& models,
                 QWidget* parent = nullptr);

 signals:
  void wanted(const asperity::TemplateChoice& choice);

 private:
  struct Content {
    std::vector<TemplateOverview> templates{};
    std::vector<OwnTexture> reliefs{};
  };

  /// The check of the protocol with one of the possible textures.
  struct Checked {
    TemplateChoice choice{};
    ProtocolCheck check{};
    QString remark{};       ///< the first problem, or else the first warning, in words of the form
    std::string refusal{};  ///< why no protocol can be made with them; empty: one can
  };

  QWidget* make_detail(const std::filesystem::path& study);
  QWidget* make_ticks();
  QWidget* make_texts();
  void show_content(Content content);
  void show_chosen();
  void offer_languages(const TemplateOverview& overview);
  void show_texts();
  static QString text_of_cost(const PlanCost& cost);
  void show_facts(bool has_choice);
  void show_screens(const Protocol& protocol);
  void choose_textures();
  void check_chosen();
  void check(const std::vector<TemplateTextures>& possible);
  void take(const Checked& checked);
  void show_what_follows();
  const TemplateOverview* chosen() const;
  /// In the language of the new protocol.
  const Protocol& chosen_in_language() const;
  TemplateChoice choice_of(const TemplateTextures& textures) const;
  TemplateTextures textures() const;
  const OwnTexture& relief_of(const QListWidgetItem& item) const;
  std::vector<OwnTexture> ticked() const;

  std::filesystem::path study_{};
  const ModelRegistry& models_;
  Content content_{};
  StudyTable* table_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* facts_ = nullptr;
  QWidget* texts_ = nullptr;
  QLineEdit* own_title_ = nullptr;               ///< that of the new protocol
  std::map<std::string, QString> own_titles_{};  ///< those that were written, by template
  ChoiceBox* language_ = nullptr;
  QLabel* description_ = nullptr;
  ScreenPreview* screen_ = nullptr;
  std::shared_ptr<const Protocol> protocol_{};  ///< of the screens
  std::shared_ptr<const Plan> plan_{};
  QWidget* surfaces_ = nullptr;
  QLabel* needs_ = nullptr;
  QRadioButton* own_ = nullptr;
  QRadioButton* copied_ = nullptr;
  QWidget* ticks_ = nullptr;
  QListWidget* reliefs_ = nullptr;
  StateLabel* state_ = nullptr;  ///< of the protocol with the chosen textures
  bool is_checking_ = false;
  bool is_refused_ = false;
  std::uint64_t shown_ = 0;                            ///< the check whose result is waited for
  std::shared_ptr<KeptHeightFields> height_fields_{};  ///< of the worker
  QLabel* what_follows_ = nullptr;
  QPushButton* create_ = nullptr;
  BackgroundTask task_{};
  NewestWork work_{};
};

}  // namespace asperity
