// Declares material, depth and ball as parameters of a form, and asks for the mesh of a body.

#include "app/gui/workbench/surface_card.h"

#include <utility>
#include <vector>

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"
#include "app/gui/workbench/parameter_form.h"

namespace asperity {

namespace {

std::vector<Parameter> surface_parameters() {
  const Material usual{};
  std::vector<Parameter> parameters = {
      number_parameter("stiffness_N_per_m", "N/m", 1.0, 5000.0, usual.stiffness_N_per_m,
                       "Stiffness of the surface, the same for every model"),
      number_parameter("friction", "1", 0.0, 2.0, usual.friction,
                       "Coulomb friction coefficient of the surface, the same for every model"),
      number_parameter("pressing_depth_m", "m", 0.0001, 0.009, 0.001,
                       "Depth of the probe below the mean height during the stroke, along z"),
      number_parameter(
          "ball_diameter_m", "m", 0.001, 0.02, 0.005,
          "Diameter of the sphere that a model with two bodies uses as the probe; the other "
          "models use a point")};
  for (Parameter& parameter : body_parameters()) parameters.push_back(std::move(parameter));
  return parameters;
}

}  // namespace

SurfaceCard::SurfaceCard(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* inside = nullptr;
  layout->addWidget(make_card(this, inside));
  inside->addWidget(make_text(tr("<b>Surface and hand</b>, the same for all"), this));
  form_ = new ParameterForm(surface_parameters(), FormStyle::fields, this);
  form_->setObjectName("surface");
  connect(form_, &ParameterForm::edited, this, [this] {
    choose_body();
    emit edited();
  });
  inside->addWidget(form_);
  mesh_button_ = make_button({}, ButtonRole::plain, this);
  mesh_button_->setObjectName("choose_mesh");
  connect(mesh_button_, &QPushButton::clicked, this, &SurfaceCard::ask_for_mesh);
  inside->addWidget(mesh_button_);
  choose_body();
}

SurfaceCard::Choices SurfaceCard::choices() const {
  return {.given = form_->given(), .mesh = mesh_};
}

void SurfaceCard::choose(const Choices& choices) {
  form_->set_values(choices.given);
  mesh_ = choices.mesh;
  choose_body();
}

Material SurfaceCard::material() const {
  const ParameterValues values = form_->values();
  return {.stiffness_N_per_m = number_of(values, "stiffness_N_per_m"),
          .friction = number_of(values, "friction")};
}

double SurfaceCard::depth_m() const { return number_of(form_->values(), "pressing_depth_m"); }

double SurfaceCard::ball_diameter_m() const {
  return number_of(form_->values(), "ball_diameter_m");
}

void SurfaceCard::ask_for_mesh() {
  auto* chooser =
      new QFileDialog(this, tr("Choose a textured mesh"), {}, tr("Textured meshes (*.mesh)"));
  chooser->setObjectName("mesh_dialog");
  chooser->setAttribute(Qt::WA_DeleteOnClose);
  chooser->setFileMode(QFileDialog::ExistingFile);
  connect(chooser, &QFileDialog::fileSelected, this, [this](const QString& file) {
    mesh_ = file.toStdString();
    choose_body();
    emit edited();
  });
  chooser->open();
}

void SurfaceCard::choose_body() {
  const ParameterValues values = form_->values();
  BodyChoice choice{.shape = choice_of(values, "body"),
                    .diameter_m = number_of(values, "body_diameter_m"),
                    .mesh = mesh_};
  mesh_button_->setVisible(choice.shape == "mesh");
  mesh_button_->setText(mesh_.empty() ? tr("Choose mesh…")
                                      : QString::fromStdString(mesh_.filename().string()));
  if (body_ == nullptr || choice != body_->choice()) {
    body_ = std::make_shared<StrokedBody>(std::move(choice));
  }
}

}  // namespace asperity

#include "moc_surface_card.cpp"
