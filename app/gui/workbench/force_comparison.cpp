// Builds the renderers of the chosen models, advances the stroke, and shows forces and Welch spectra.

#include "app/gui/workbench/force_comparison.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include <QtCore/QStringList>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QGridLayout>
#include <glm/geometric.hpp>

#include "analysis/signals/spectrum.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/workbench/parameter_form.h"
#include "app/gui/workbench/surface_card.h"
#include "app/words/phrase_of_error.h"

namespace asperity {

namespace {

constexpr int kComparisonFrame_ms = 16;
constexpr int kComparisonLook_ms = 250;
constexpr std::size_t kShownSamples = 2000;
constexpr double kShown_s = 2.0;  // the same
constexpr std::size_t kWelchSamples = 256;
constexpr double kAcross_m_per_s = 0.060;
constexpr double kComparedRate_Hz = 1000.0;
constexpr std::int64_t kComparedPeriod_ns = 1'000'000;
constexpr std::size_t kBetweenJudgings = 50;  // samples: twenty numbers a second
constexpr double kLoud_N = 0.2;               // a strong texture force is at half of full scale
constexpr double kStill_m_per_s = 1e-4;       // below, a direction of motion means nothing

QString model_name(const ForceModel& model) {
  QString name = QString::fromStdString(model.declaration.id).replace('_', ' ');
  name[0] = name[0].toUpper();
  return name;
}

/// Two digits: more would only flicker.
QString in_m_per_s2(double acceleration_m_per_s2) {
  const int decimals = acceleration_m_per_s2 < 0.995 ? 2 : acceleration_m_per_s2 < 9.95 ? 1 : 0;
  return shown_number(acceleration_m_per_s2, 'f', decimals);
}

}  // namespace

struct ForceComparison::Built {
  struct Model {
    std::string id{};
    ParameterValues suggestion{};
    StrokedModel stroked{};
    QString complaint{};
  };
  std::vector<Model> models{};
  MouseHand hand{0.0};
};

ForceComparison::ForceComparison(const ModelRegistry& models, QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, kGrid, 0);
  layout->setSpacing(kMargin);
  layout->addWidget(make_text(tr("Choose models, then drag the mouse over the relief: the force "
                                 "of each model along the same path of the hand is shown."),
                              this, true));
  auto* across = make_button(tr("Stroke once across"), ButtonRole::plain, this);
  across->setObjectName("stroke_across");
  across->setToolTip(tr("From left to right at 60 mm/s, always the same"));
  connect(across, &QPushButton::clicked, this, &ForceComparison::across_wanted);
  layout->addWidget(across);
  component_ = new ChoiceBox(this);
  component_->setObjectName("force_component");
  component_->addItems({tr("Normal force"), tr("Force against the motion")});
  connect(component_, &QComboBox::currentIndexChanged, this, &ForceComparison::advanced);
  heard_ = new ChoiceBox(this);
  heard_->setObjectName("heard");
  heard_->addItem(tr("Nothing"));
  for (const ForceModel& model : models.models()) heard_->addItem(model_name(model));
  heard_->setEnabled(false);
  connect(heard_, &QComboBox::currentIndexChanged, this, [this](int index) {
    // What is to be heard has to be rendered.
    if (index > 0) cards_[static_cast<std::size_t>(index - 1)].chosen->setChecked(true);
    open_or_close_sound();
  });
  auto* choices = new QGridLayout();
  choices->setSpacing(kGrid);
  choices->setColumnStretch(1, 1);
  int line = 0;
  for (const auto& [words, list] :
       {std::pair{tr("Show"), component_}, std::pair{tr("Hear"), heard_}}) {
    QLabel* caption = make_text(words, this);
    caption->setFont(text_font(TextSize::small));
    caption->setBuddy(list);
    choices->addWidget(caption, line, 0);
    choices->addWidget(list, line++, 1);
  }
  no_sound_ = make_text({}, this, true);
  no_sound_->setObjectName("no_sound");
  no_sound_->setFont(text_font(TextSize::small));
  no_sound_->hide();
  choices->addWidget(no_sound_, line, 1);
  layout->addLayout(choices);
  for (const ForceModel& model : models.models()) add_card(model, this);

  surface_ = new SurfaceCard(this);
  connect(surface_, &SurfaceCard::edited, this, &ForceComparison::make_renderers);
  layout->addWidget(surface_);
  layout->addStretch(1);
  frames_.setInterval(kComparisonFrame_ms);
  connect(&frames_, &QTimer::timeout, this, &ForceComparison::frame);
  looks_.setInterval(kComparisonLook_ms);
  connect(&looks_, &QTimer::timeout, this, &ForceComparison::look_at_card);
}

void ForceComparison::add_card(const ForceModel& model, QWidget* parent) {
  ModelCard card{.model = &model, .color = series_color(static_cast<int>(cards_.size()))};
  QVBoxLayout* inside = nullptr;
  QFrame* frame = make_card(parent, inside);
  auto* head = new QHBoxLayout();
  auto* swatch = new QLabel(frame);
  swatch->setFixedSize(16, 4);
  swatch->setStyleSheet("background: " + card.color.name());
  card.chosen = new QCheckBox(model_name(model), frame);
  card.chosen->setObjectName("model_" + QString::fromStdString(model.declaration.id));
  card.chosen->setFont(text_font(TextSize::body, true));
  head->addWidget(card.chosen, 1);
  head->addWidget(swatch);
  inside->addLayout(head);
  QLabel* summary = make_text(words_of(model.declaration.summary), frame, true);
  summary->setFont(text_font(TextSize::small));
  summary->setToolTip(QString::fromStdString(model.declaration.source));
  inside->addWidget(summary);
  card.body = new QWidget(frame);
  auto* body = new QVBoxLayout(card.body);
  body->setContentsMargins(0, 0, 0, 0);
  card.form = new ParameterForm(model.declaration.parameters, FormStyle::fields, card.body);
  card.form->setObjectName("form_" + QString::fromStdString(model.declaration.id));
  connect(card.form, &ParameterForm::edited, this, &ForceComparison::make_renderers);
  card.complaint = new StateLabel(card.body);
  card.complaint->hide();
  body->addWidget(card.form);
  body->addWidget(card.complaint);
  inside->addWidget(card.body);
  card.chosen->setChecked(cards_.size() < 2);
  card.body->setVisible(card.chosen->isChecked());
  connect(card.chosen, &QCheckBox::toggled, card.body, &QWidget::setVisible);
  connect(card.chosen, &QCheckBox::toggled, this, &ForceComparison::make_renderers);
  layout()->addWidget(frame);
  cards_.push_back(card);
}

ForceComparison::Choices ForceComparison::choices() const {
  Choices choices{.surface = surface_->choices(),
                  .component = component_->currentIndex(),
                  .heard = heard_->currentIndex()};
  for (const ModelCard& card : cards_) {
    choices.chosen[card.model->declaration.id] = card.chosen->isChecked();
    choices.given[card.model->declaration.id] = card.form->given();
  }
  return choices;
}

void ForceComparison::choose(const Choices& choices) {
  surface_->choose(choices.surface);
  for (const ModelCard& card : cards_) {
    const auto chosen = choices.chosen.find(card.model->declaration.id);
    if (chosen == choices.chosen.end()) continue;
    card.form->set_values(choices.given.at(chosen->first));
    card.chosen->setChecked(chosen->second);
  }
  component_->setCurrentIndex(choices.component);
  heard_->setCurrentIndex(choices.heard);
  make_renderers();
}

ForceComparison::Saveable ForceComparison::saveable() const {
  Saveable saveable{.is_on_body = surface_->body()->choice().shape != "plane"};
  for (std::size_t m = 0; m < stroke_.models().size(); ++m) {
    const ModelDeclaration& model = card_of(m).model->declaration;
    if (model.needs_bodies || !model.assets.empty()) {
      saveable.left_out << model_name(*card_of(m).model);
      continue;
    }
    saveable.renderings.push_back(
        {.model = model.id,
         .version = model.version,
         .parameters = complete_values(model, stroke_.models()[m].inputs.parameters),
         .material = surface_->material()});
  }
  return saveable;
}

void ForceComparison::set_field(std::shared_ptr<const HeightField> field) {
  if (field_ != nullptr && field == field_->field()) return;  // a stroke over it goes on
  field_ = field != nullptr ? std::make_shared<FieldPlate>(std::move(field)) : nullptr;
  make_renderers();
}

void ForceComparison::make_renderers() {
  if (field_ == nullptr) return;
  struct Order {
    const ForceModel* model = nullptr;
    ParameterValues given{};
  };
  std::vector<Order> orders{};
  for (const ModelCard& card : cards_) {
    if (card.chosen->isChecked()) orders.push_back({card.model, card.form->given()});
  }
  const QString only_on_a_plane =
      tr("This model touches the relief as a plate. Choose the plane as the body under Surface and "
         "hand.");
  work_.ask(
      [this, orders, only_on_a_plane, material = surface_->material(), plate = field_,
       body = surface_->body(), depth_m = surface_->depth_m(),
       ball_m = surface_->ball_diameter_m()]() -> NewestWork::Delivery {
        const std::shared_ptr<const HeightField>& field = plate->field();
        auto built = std::make_shared<Built>();
        std::shared_ptr<const BodySurface> surface{};
        QString complaint_about_body{};
        try {
          surface = body->surface();
        } catch (const std::exception& error) {
          complaint_about_body = words_of(phrase_of(error));
        }
        built->hand = MouseHand(depth_m, surface);
        for (const Order& order : orders) {
          Built::Model model{.id = order.model->declaration.id, .complaint = complaint_about_body};
          if (model.complaint.isEmpty() && surface != nullptr &&
              order.model->declaration.needs_bodies) {
            model.complaint = only_on_a_plane;
          }
          if (!model.complaint.isEmpty()) {
            built->models.push_back(std::move(model));
            continue;
          }
          try {
            if (order.model->suggested_by) {
              model.suggestion = order.model->suggested_by(*field, material);
            }
            ParameterValues values = model.suggestion;
            for (const auto& [name, value] : order.given) values[name] = value;
            model.stroked = {.id = model.id, .inputs = stroke_inputs(field, material, values)};
            if (order.model->declaration.needs_bodies) {
              add_bodies(model.stroked.inputs, *plate, ball_m);
            } else {
              model.stroked.inputs.body = surface;
            }
            add_files_of_relief(model.stroked.inputs, *order.model,
                                *model.stroked.inputs.height_field);
            model.stroked.renderer = make_renderer(*order.model, model.stroked.inputs);
          } catch (const std::exception& error) {
            model.complaint = words_of(phrase_of(error));
          }
          built->models.push_back(std::move(model));
        }
        return [this, built] { take(std::move(*built)); };
      },
      [this](const QString&) { emit advanced(); });
  // A press often ends the editing of a value: its stroke, or one under way, is that of the new models.
  is_stroke_waiting_ = is_stroke_waiting_ || stroke_.is_going_on();
  clear_stroke();
  emit models_changed();
  emit advanced();
}

void ForceComparison::take(Built built) {
  std::vector<StrokedModel> models{};
  for (Built::Model& model : built.models) {
    const auto card = std::find_if(cards_.begin(), cards_.end(), [&model](const ModelCard& one) {
      return one.model->declaration.id == model.id;
    });
    card->complaint->setVisible(!model.complaint.isEmpty());
    card->complaint->set_state(State::stop, model.complaint);
    if (!model.complaint.isEmpty()) continue;
    card->form->set_defaults(model.suggestion);
    models.push_back(std::move(model.stroked));
  }
  stroke_.set_models(std::move(models), std::move(built.hand));
  // Of an earlier choice while a newer one is being prepared: no stroke yet.
  if (is_stroke_waiting_ && !is_preparing()) start_stroke();
  emit models_changed();
  emit advanced();
}

void ForceComparison::clear_stroke() {
  frames_.stop();
  stroke_.set_models({}, MouseHand(0.0));
  judged_ = 0;
  judge();
}

void ForceComparison::start_stroke() {
  is_stroke_waiting_ = false;
  if (across_y_m_) hand_at_m_ = {-0.45 * field_->field()->width_m(), *across_y_m_};
  played_ = 0;
  stroke_.begin(hand_at_m_);
  judged_ = 0;
  clock_.start();
  frames_.start();
}

void ForceComparison::begin_stroke(double x_m, double y_m) {
  across_y_m_.reset();
  hand_at_m_ = {x_m, y_m};
  is_stroke_waiting_ = is_preparing();
  if (!is_stroke_waiting_) start_stroke();
}

void ForceComparison::aim_stroke(double x_m, double y_m) {
  hand_at_m_ = {x_m, y_m};
  stroke_.aim(hand_at_m_);
}

void ForceComparison::end_stroke() {
  is_stroke_waiting_ = false;
  frames_.stop();
  frame();
  stroke_.end();
  across_y_m_.reset();
}

void ForceComparison::stroke_across(double y_m) {
  if (field_ == nullptr) return;
  across_y_m_ = y_m;
  is_stroke_waiting_ = is_preparing();
  if (!is_stroke_waiting_) start_stroke();
}

void ForceComparison::frame() {
  const std::int64_t now_ns = clock_.nsecsElapsed();
  if (across_y_m_ && stroke_.is_going_on()) {
    // Aimed anew for every sample: the same stroke whenever the frames come.
    const double length_m = 0.9 * field_->field()->width_m();
    double gone_m = 0.0;
    while (gone_m <= length_m) {
      const auto next_ns = static_cast<std::int64_t>(stroke_.path().size()) * kComparedPeriod_ns;
      if (next_ns > now_ns) break;
      gone_m = kAcross_m_per_s * 1e-9 * static_cast<double>(next_ns);
      stroke_.aim({std::min(gone_m, length_m) - 0.5 * length_m, *across_y_m_});
      stroke_.advance(next_ns);
    }
    if (gone_m > length_m) {
      across_y_m_.reset();
      stroke_.end();
      frames_.stop();
    }
  } else {
    stroke_.advance(now_ns);
  }
  play();
  judge();
  // The sound wants every frame, the plots every other.
  if (++frame_ % 2 == 0 || !frames_.isActive()) emit advanced();
}

void ForceComparison::set_sound(SoundOutput output) {
  looks_.stop();
  speaker_.reset();
  output_ = std::move(output);
  heard_->setEnabled(!output_.is_null);
  no_sound_->setVisible(output_.is_null);
  no_sound_->setText(tr("There is no sound output. Connect headphones to hear a force."));
  open_or_close_sound();
}

void ForceComparison::open_or_close_sound() {
  const bool wanted = isVisible() && !output_.is_null && heard_->currentIndex() > 0;
  if (wanted == (speaker_ != nullptr)) return;
  looks_.stop();
  speaker_.reset();
  no_sound_->setVisible(output_.is_null);
  if (!wanted) return;
  speaker_ = std::make_unique<ForceSpeaker>(output_);
  speaker_->set_full_scale_N(kLoud_N);
  silent_.start();
  looks_.start();
}

/// A card that opens within the time that any card takes is not spoken of.
void ForceComparison::look_at_card() {
  if (speaker_->is_running()) silent_.restart();
  const bool is_silent = static_cast<double>(silent_.elapsed()) > SoundStream::kOpens_s * 1e3;
  no_sound_->setVisible(is_silent || speaker_->is_refused());
  no_sound_->setText(speaker_->is_refused()
                         ? tr("%1 could not be opened; close other programs that may be using it.")
                               .arg(output_.name)
                         : tr("%1 produces no sound. Connect it again, or choose another sound "
                              "output in the settings of the computer.")
                               .arg(output_.name));
}

void ForceComparison::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  open_or_close_sound();
}

void ForceComparison::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  frames_.stop();
  stroke_.end();
  is_stroke_waiting_ = false;
  across_y_m_.reset();
  open_or_close_sound();
}

void ForceComparison::play() {
  if (speaker_ == nullptr) return;
  const std::string& id =
      cards_[static_cast<std::size_t>(heard_->currentIndex() - 1)].model->declaration.id;
  for (std::size_t m = 0; m < stroke_.models().size(); ++m) {
    if (stroke_.models()[m].id == id)
      speaker_->play_force(component_of(m, played_), kComparedRate_Hz);
  }
  played_ = stroke_.path().size();
}

/// What has been felt since the last time; of a new stroke, from nothing.
void ForceComparison::judge() {
  if (judged_ == 0) shakings_.assign(stroke_.models().size(), {});
  for (; judged_ < stroke_.path().size(); ++judged_) {
    for (std::size_t m = 0; m < shakings_.size(); ++m) {
      Shaking& shaking = shakings_[m];
      shaking.felt.add(stroke_.forces_N()[m][judged_]);
      if (judged_ % kBetweenJudgings != 0) continue;
      shaking.newest = shaking.felt.roughness();
      if (!shaking.newest) continue;
      shaking.time_s << 1e-9 * static_cast<double>(stroke_.path()[judged_].time_ns);
      shaking.rms_m_per_s2 << shaking.newest->rms_accel_m_per_s2;
    }
  }
}

const ForceComparison::ModelCard& ForceComparison::card_of(std::size_t model) const {
  return *std::find_if(cards_.begin(), cards_.end(), [&](const ModelCard& card) {
    return card.model->declaration.id == stroke_.models()[model].id;
  });
}

std::vector<PlotSeries> ForceComparison::roughness() const {
  std::vector<PlotSeries> all{};
  for (std::size_t m = 0; m < shakings_.size(); ++m) {
    const Shaking& shaking = shakings_[m];
    if (!shaking.newest) continue;
    PlotSeries series{.name = in_m_per_s2(shaking.newest->rms_accel_m_per_s2),
                      .color = card_of(m).color};
    for (qsizetype i = 0; i < shaking.time_s.size(); ++i) {
      if (shaking.time_s[i] < shaking.time_s.back() - kShown_s) continue;
      series.x << shaking.time_s[i];
      series.y << shaking.rms_m_per_s2[i];
    }
    all.push_back(std::move(series));
  }
  return all;
}

QString ForceComparison::roughness_in_words() const {
  QStringList lines{};
  for (std::size_t m = 0; m < shakings_.size(); ++m) {
    const std::optional<HeldToolRoughness>& newest = shakings_[m].newest;
    if (!newest) continue;
    const QString name = model_name(*card_of(m).model);
    const QString rms = in_m_per_s2(newest->rms_accel_m_per_s2);
    const QString greatest = in_m_per_s2(newest->max_accel_m_per_s2);
    lines << (newest->pacinian_dB
                  ? tr("%1: RMS %2 m/s², maximum %3 m/s², %4 dB above the vibrotactile threshold")
                        .arg(name, rms, greatest, shown_number(*newest->pacinian_dB, 'f', 0))
                  : tr("%1: RMS %2 m/s², maximum %3 m/s²").arg(name, rms, greatest));
  }
  return lines.join('\n');
}

std::vector<double> ForceComparison::component_of(std::size_t model, std::size_t first) const {
  const std::vector<glm::dvec3>& forces_N = stroke_.forces_N()[model];
  std::vector<double> component_N{};
  for (std::size_t i = first; i < forces_N.size(); ++i) {
    if (component_->currentIndex() == 0) {
      component_N.push_back(forces_N[i].z);
      continue;
    }
    const glm::dvec3& velocity_m_per_s = stroke_.path()[i].velocity_m_per_s;
    const double speed_m_per_s = glm::length(velocity_m_per_s);
    component_N.push_back(speed_m_per_s < kStill_m_per_s
                              ? 0.0
                              : -glm::dot(forces_N[i], velocity_m_per_s) / speed_m_per_s);
  }
  return component_N;
}

std::vector<PlotSeries> ForceComparison::forces() const {
  std::vector<PlotSeries> all{};
  for (std::size_t m = 0; m < stroke_.models().size(); ++m) {
    const std::size_t samples = stroke_.path().size();
    const std::size_t first = samples - std::min(samples, kShownSamples);
    const std::vector<double> component_N = component_of(m, first);
    if (component_N.empty()) continue;
    PlotSeries series{};
    for (std::size_t i = 0; i < component_N.size(); ++i) {
      series.x.push_back(1e-9 * static_cast<double>(stroke_.path()[first + i].time_ns));
      series.y.push_back(component_N[i]);
    }
    series.name = model_name(*card_of(m).model);
    series.color = card_of(m).color;
    all.push_back(std::move(series));
  }
  return all;
}

std::optional<ForceComparison::Dent> ForceComparison::dent() const {
  for (std::size_t m = 0; m < stroke_.models().size(); ++m) {
    const auto* const soft = dynamic_cast<const DentsSurface*>(stroke_.models()[m].renderer.get());
    if (soft == nullptr || stroke_.path().empty()) continue;
    const std::optional<SurfaceDent> dent = soft->dent();
    if (!dent) return {};
    return Dent{.model = model_name(*card_of(m).model), .surface = *dent};
  }
  return {};
}

std::vector<PlotSeries> ForceComparison::spectra() const {
  std::vector<PlotSeries> all = forces();
  for (PlotSeries& series : all) {
    const std::vector<double> signal(series.y.begin(), series.y.end());
    series.x.clear();
    series.y.clear();
    series.name.clear();  // the colours are named beside the forces
    if (signal.size() < kWelchSamples) continue;
    const PowerSpectrum spectrum =
        welch_spectrum(signal, {.rate_Hz = kComparedRate_Hz, .length = kWelchSamples});
    for (std::size_t k = 1; k < spectrum.density.size(); ++k) {
      series.x.push_back(static_cast<double>(k) * spectrum.spacing_Hz);
      series.y.push_back(spectrum.density[k]);
    }
  }
  return all;
}

}  // namespace asperity

#include "moc_force_comparison.cpp"
