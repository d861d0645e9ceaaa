// The card of the surface and the hand, which are the same for all compared force models.

#pragma once

#include <filesystem>
#include <memory>

#include <QtWidgets/QWidget>

#include "app/gui/workbench/stroked_body.h"
#include "renderers/force/force_model.h"
#include "stimuli/properties/parameter.h"

class QPushButton;

namespace asperity {

class ParameterForm;

class SurfaceCard final : public QWidget {
  Q_OBJECT
 public:
  explicit SurfaceCard(QWidget* parent = nullptr);

  /// What differs from the defaults, for a card that takes the place of this one.
  struct Choices {
    ParameterValues given{};
    std::filesystem::path mesh{};
  };
  Choices choices() const;
  /// Without `edited`.
  void choose(const Choices& choices);

  Material material() const;
  double depth_m() const;
  double ball_diameter_m() const;
  /// The same as before if the choice is the same: a body takes up to a second to make.
  const std::shared_ptr<StrokedBody>& body() const noexcept { return body_; }

 signals:
  void edited();

 private:
  void ask_for_mesh();
  void choose_body();

  ParameterForm* form_ = nullptr;
  QPushButton* mesh_button_ = nullptr;
  std::filesystem::path mesh_{};
  std::shared_ptr<StrokedBody> body_{};
};

}  // namespace asperity
