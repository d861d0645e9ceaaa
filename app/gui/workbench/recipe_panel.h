// The recipe beside the relief: what the photograph shows, and a control for every parameter.

#pragma once

#include <optional>
#include <vector>

#include <QtWidgets/QWidget>

#include "stimuli/photographs/photograph_advice.h"
#include "stimuli/photographs/texture_from_photograph.h"

class QComboBox;
class QLabel;
class QLayout;
class QPushButton;

namespace asperity {

class Banner;
class ParameterForm;
class StateLabel;
struct OpenedPicture;

class RecipePanel final : public QWidget {
  Q_OBJECT
 public:
  explicit RecipePanel(QWidget* parent = nullptr);

  /// What the user states about a photograph.
  struct Statements {
    std::optional<PhotographLight> light{};
    int kind = -1;  ///< what it shows, as its place in the list; −1 until it is chosen
  };

  /// Shows the statistics of a photograph. Its light and what it shows are open until they are stated; the method is
  /// recommended for the light. The other parameters stay.
  void show_opened(const OpenedPicture& opened);

  TextureRecipe recipe() const;
  /// Why the relief is provisional: the sign of the heights is not chosen. Empty if it is, or if the method determines it.
  QString unready() const;
  Statements stated() const;
  /// As it was left elsewhere. Does not signal.
  void show_recipe(const TextureRecipe& recipe, const Statements& stated);
  /// A slider is held.
  bool is_dragging() const;
  /// Why the recipe cannot be; empty: it can.
  void show_refusal(const QString& why);

 signals:
  void edited();

 private:
  QWidget* make_light_card();
  QWidget* make_kind_card();
  QWidget* make_evidence_card();
  void add_groups(QLayout* layout);
  void show_stated(const Statements& stated);
  std::optional<PhotographLight> light() const;
  void recommend();
  bool uses_recommendation() const;
  void use_recommendation();
  void say_what_it_shows(int kind);

  Banner* banner_ = nullptr;
  QWidget* controls_ = nullptr;
  QComboBox* light_ = nullptr;
  double direction_deg_ = 0.0;
  QComboBox* kind_ = nullptr;
  QLabel* expectation_ = nullptr;
  StateLabel* hint_ = nullptr;
  QLabel* recommendation_ = nullptr;
  QPushButton* use_ = nullptr;
  QLabel* advice_ = nullptr;
  std::vector<ParameterForm*> forms_{};
};

}  // namespace asperity
