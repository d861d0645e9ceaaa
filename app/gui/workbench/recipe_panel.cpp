// Groups the controls into cards, and recommends a method from the statements about the photograph.

#include "app/gui/workbench/recipe_panel.h"

#include <algorithm>
#include <array>

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>

#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/workbench/opened_picture.h"
#include "app/gui/workbench/parameter_form.h"
#include "stimuli/photographs/photograph_advice.h"
#include "stimuli/photographs/texture_method.h"

namespace asperity {

namespace {

constexpr int kNotStated = -1;
enum RecipeKind { not_chosen = kNotStated, bright_high, dark_high, paint };
/// In the order of the list.
constexpr std::array kLights{PhotographLight::even, PhotographLight::one_lamp};

std::vector<Parameter> declared(std::initializer_list<const char*> names) {
  std::vector<Parameter> chosen{};
  for (const Parameter& parameter : texture_recipe_parameters()) {
    if (std::find(names.begin(), names.end(), parameter.name) != names.end()) {
      chosen.push_back(parameter);
    }
  }
  return chosen;
}

/// What of the advice has to be seen before the sign is chosen.
QString hint_of(PhotographResemblance resemblance) {
  switch (resemblance) {
    case PhotographResemblance::directed:
      return RecipePanel::tr(
          "The picture varies mostly in one direction: either the surface has a grain, or the "
          "picture was taken in light from one side. See the end of this list.");
    case PhotographResemblance::bright_spots:
      return RecipePanel::tr(
          "The picture has narrow bright parts. If they are low, as light mortar is, the dark "
          "parts stand out.");
    case PhotographResemblance::dark_grooves:
    case PhotographResemblance::nothing_clear:
      break;
  }
  return {};
}

QString name_of_method(const std::string& id) { return text_of(declared({"method"}).front(), id); }

/// The recommended method with its reason.
QString recommendation_words(std::optional<PhotographLight> light, double direction_deg) {
  if (!light) {
    return RecipePanel::tr(
        "Answer the question first: the recommended method depends on the light, and the picture "
        "does not show it.");
  }
  const MethodRecommendation recommended = recommended_method(*light);
  const QString method = name_of_method(recommended.method);
  switch (*light) {
    case PhotographLight::one_lamp:
      return RecipePanel::tr(
                 "Recommended method: %1, with the direction of the lamp as the light azimuth. The "
                 "brightness varies mostly along %2° and %3°. With the methods Wu and Brightness, "
                 "the result is the slope towards the light, not the height: edges across the "
                 "light become ridges and grooves, edges along it vanish.")
          .arg(method, shown_number(direction_deg, 'f', 0),
               shown_number(opposite_deg(direction_deg), 'f', 0));
    case PhotographLight::even:
      break;
  }
  return RecipePanel::tr(
             "Recommended method: %1 with a spectral tilt of %2, because on nine of ten measured "
             "surfaces it was closer to the relief than the unprocessed brightness.")
      .arg(method, shown_number(recommended.spectral_tilt, 'f', 1));
}

}  // namespace

RecipePanel::RecipePanel(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  banner_ = new Banner(this);
  banner_->setObjectName("recipe_banner");
  layout->addWidget(banner_);
  controls_ = new QWidget(this);
  auto* inside = new QVBoxLayout(controls_);
  inside->setContentsMargins(0, 0, kGrid, 0);
  inside->setSpacing(kGrid);
  inside->addWidget(make_light_card());
  inside->addWidget(make_kind_card());
  add_groups(inside);
  inside->addWidget(make_evidence_card());
  inside->addStretch(1);
  say_what_it_shows(not_chosen);
  auto* area = new QScrollArea(this);
  area->setWidget(controls_);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFrameShape(QFrame::NoFrame);
  layout->addWidget(area, 1);
}

QWidget* RecipePanel::make_light_card() {
  QVBoxLayout* inside = nullptr;
  QFrame* card = make_card(controls_, inside);
  inside->addWidget(make_text(tr("<b>Did the light come from one lamp at the side?</b>"), card));
  light_ = new ChoiceBox(card);
  light_->setObjectName("light");
  light_->addItems({tr("No: from all sides"), tr("Yes: from one side")});
  light_->setPlaceholderText(tr("Choose…"));
  light_->setCurrentIndex(kNotStated);
  connect(light_, &QComboBox::currentIndexChanged, this, &RecipePanel::recommend);
  inside->addWidget(light_);
  recommendation_ = make_text({}, card);
  recommendation_->setObjectName("recommendation");
  recommendation_->setFont(text_font(TextSize::small));
  inside->addWidget(recommendation_);
  use_ = make_button(tr("Use the recommended method"), ButtonRole::plain, card);
  use_->setObjectName("use_recommendation");
  inside->addWidget(use_, 0, Qt::AlignLeft);
  connect(use_, &QPushButton::clicked, this, &RecipePanel::use_recommendation);
  connect(this, &RecipePanel::edited, this, &RecipePanel::recommend);
  recommend();
  return card;
}

QWidget* RecipePanel::make_kind_card() {
  QVBoxLayout* inside = nullptr;
  QFrame* card = make_card(controls_, inside);
  inside->addWidget(make_text(tr("<b>What does the photograph show?</b>"), card));
  kind_ = new ChoiceBox(card);
  kind_->setObjectName("kind");
  kind_->addItems({tr("Relief: bright parts stand out"), tr("Relief: dark parts stand out"),
                   tr("Paint, print or stains")});
  kind_->setPlaceholderText(tr("Choose…"));
  kind_->setCurrentIndex(not_chosen);
  connect(kind_, &QComboBox::currentIndexChanged, this, [this](int kind) {
    say_what_it_shows(kind);
    emit edited();
  });
  inside->addWidget(kind_);
  expectation_ = make_text({}, card);
  expectation_->setObjectName("expectation");
  expectation_->setFont(text_font(TextSize::small));
  inside->addWidget(expectation_);
  hint_ = new StateLabel(card);
  hint_->setObjectName("hint");
  hint_->setFont(text_font(TextSize::small));
  hint_->hide();
  inside->addWidget(hint_);
  return card;
}

QWidget* RecipePanel::make_evidence_card() {
  QVBoxLayout* inside = nullptr;
  QFrame* card = make_card(controls_, inside);
  inside->addWidget(make_text(tr("<b>Indications in the picture</b>"), card));
  advice_ = make_text({}, card, true);
  advice_->setObjectName("advice");
  advice_->setFont(text_font(TextSize::small));
  inside->addWidget(advice_);
  return card;
}

void RecipePanel::add_groups(QLayout* layout) {
  struct Group {
    QString title{};
    std::vector<Parameter> parameters{};
  };
  const std::array<Group, 6> groups{
      Group{tr("Method"), declared({"method", "light_azimuth_deg", "light_elevation_deg"})},
      Group{tr("Heights"), declared({"rms_m"})},
      Group{tr("Photograph"), declared({"width_m", "histogram"})},
      Group{tr("Even out the light"),
            declared({"homomorphic_wavelength_m", "gamma_low", "gamma_high"})},
      Group{tr("Remove long wavelengths"), declared({"gaussian_wavelength_m"})},
      Group{tr("Attenuate short wavelengths"), declared({"spectral_tilt"})}};
  for (const Group& group : groups) {
    QVBoxLayout* inside = nullptr;
    QFrame* card = make_card(controls_, inside);
    QLabel* title = make_text(group.title, card);
    title->setFont(text_font(TextSize::body, true));
    inside->addWidget(title);
    auto* form = new ParameterForm(group.parameters, FormStyle::sliders, card);
    connect(form, &ParameterForm::edited, this, &RecipePanel::edited);
    connect(form, &ParameterForm::released, this, &RecipePanel::edited);
    inside->addWidget(form);
    forms_.push_back(form);
    layout->addWidget(card);
  }
}

void RecipePanel::show_opened(const OpenedPicture& opened) {
  banner_->hide();
  advice_->setText(words_of(opened.advice));
  direction_deg_ = opened.direction_deg;
  show_stated({});
  // What is said of the sign stands next to its choice.
  QStringList hints{};
  for (const PhotographResemblance each : opened.resemblances) {
    const QString words = hint_of(each);
    if (words.isEmpty()) continue;
    each == PhotographResemblance::bright_spots ? hints.prepend(words) : hints.append(words);
  }
  const QString hint = hints.join(' ');
  hint_->set_state(State::look, hint);
  hint_->setVisible(!hint.isEmpty());
}

TextureRecipe RecipePanel::recipe() const {
  ParameterValues values{};
  for (const ParameterForm* form : forms_) values.merge(form->values());
  // Where a method uses the light, its direction determines the sign.
  const bool uses_light = texture_method(choice_of(values, "method")).uses_light;
  values["sign"] = kind_->currentIndex() == dark_high && !uses_light ? -1.0 : 1.0;
  return texture_recipe(values);
}

QString RecipePanel::unready() const {
  if (kind_->currentIndex() != not_chosen || texture_method(recipe().method).uses_light) return {};
  return tr("Choose what the photograph shows: the sign of the heights is not determined yet.");
}

RecipePanel::Statements RecipePanel::stated() const {
  return {.light = light(), .kind = kind_->currentIndex()};
}

std::optional<PhotographLight> RecipePanel::light() const {
  const int chosen = light_->currentIndex();
  if (chosen == kNotStated) return std::nullopt;
  return kLights.at(static_cast<std::size_t>(chosen));
}

void RecipePanel::show_stated(const Statements& stated) {
  const QSignalBlocker quiet_light(light_);
  int place = kNotStated;
  for (std::size_t i = 0; i < kLights.size(); ++i) {
    if (stated.light == kLights.at(i)) place = static_cast<int>(i);
  }
  light_->setCurrentIndex(place);
  recommend();
  const QSignalBlocker quiet_kind(kind_);
  kind_->setCurrentIndex(stated.kind);
  say_what_it_shows(stated.kind);
}

void RecipePanel::recommend() {
  recommendation_->setText(recommendation_words(light(), direction_deg_));
  use_->setVisible(light() && !uses_recommendation());
}

bool RecipePanel::uses_recommendation() const {
  const MethodRecommendation recommended = recommended_method(*light());
  const TextureRecipe now = recipe();
  return now.method == recommended.method && now.spectral_tilt == recommended.spectral_tilt;
}

// The direction of the lamp stays: the picture does not show from which of the two sides the light came.
void RecipePanel::use_recommendation() {
  const MethodRecommendation recommended = recommended_method(*light());
  const ParameterValues wanted{{"method", std::string(recommended.method)},
                               {"spectral_tilt", recommended.spectral_tilt}};
  for (ParameterForm* form : forms_) {
    ParameterValues values = form->values();
    for (auto& [name, value] : values) {
      if (const auto of = wanted.find(name); of != wanted.end()) value = of->second;
    }
    form->set_values(values);
  }
  emit edited();
}

void RecipePanel::show_recipe(const TextureRecipe& recipe, const Statements& stated) {
  const ParameterValues all = complete_parameter_values(recipe);
  for (ParameterForm* form : forms_) {
    ParameterValues values{};
    for (const Parameter& parameter : form->parameters()) {
      const auto value = all.find(parameter.name);
      if (value != all.end()) values.insert(*value);
    }
    form->set_values(values);
  }
  show_stated(stated);
}

bool RecipePanel::is_dragging() const {
  return std::any_of(forms_.begin(), forms_.end(),
                     [](const ParameterForm* form) { return form->is_dragging(); });
}

void RecipePanel::show_refusal(const QString& why) {
  why.isEmpty() ? banner_->hide() : banner_->show_news(State::look, why);
}

void RecipePanel::say_what_it_shows(int kind) {
  switch (kind) {
    case dark_high:
      expectation_->setText(
          tr("Dark is high: for light mortar between bricks or light sand between pebbles, in even "
             "light. On five measured surfaces the heights matched the relief only in part, and on "
             "four of them less well than the unprocessed brightness."));
      break;
    case paint:
      expectation_->setText(
          tr("▲ The paint becomes relief: what is felt does not correspond to the surface under "
             "it. Use it only if this is intended."));
      break;
    case not_chosen:
      expectation_->setText(
          tr("▲ The relief is provisional: it shows bright parts as high. The picture does not "
             "determine the sign; look at the surface and choose."));
      break;
    default:
      expectation_->setText(
          tr("Bright is high: for a surface in even light, where grooves and gaps are dark. On "
             "five measured surfaces the heights matched the relief only in part, and on four of "
             "them less well than the unprocessed brightness. A photograph does not show the depth "
             "of the relief: set it below."));
  }
}

}  // namespace asperity

#include "moc_recipe_panel.cpp"
