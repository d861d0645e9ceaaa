// The force models that a stroke over the relief is felt through: which, and with what parameters.

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QtCore/QElapsedTimer>
#include <QtCore/QString>
#include <QtCore/QStringList>
#include <QtCore/QTimer>
#include <QtCore/QVector>
#include <QtWidgets/QWidget>
#include <glm/vec2.hpp>

#include "app/gui/look/newest_work.h"
#include "app/gui/sound/force_speaker.h"
#include "app/gui/workbench/force_stroke.h"
#include "app/gui/workbench/signal_plots.h"
#include "app/gui/workbench/surface_card.h"
#include "app/study_files/rendering_files.h"
#include "renderers/elastic/surface_dent.h"
#include "renderers/force/force_model.h"
#include "renderers/offline/felt_roughness.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace asperity {

class ParameterForm;
class StateLabel;

/// Renderers are made in the background whenever the relief, the surface or a parameter changes, and
/// a stroke under way begins again with them. Where a model takes parameters from a sample, those of
/// this relief become the form's defaults.
class ForceComparison final : public QWidget {
  Q_OBJECT
 public:
  /// `models` outlives the widget.
  explicit ForceComparison(const ModelRegistry& models, QWidget* parent = nullptr);

  void set_field(std::shared_ptr<const HeightField> field);
  const ForceStroke& stroke() const noexcept { return stroke_; }
  bool is_settled() const noexcept { return !work_.is_busy(); }
  /// The models of the present choices are being made.
  bool is_preparing() const noexcept { return work_.is_busy(); }

  /// What a person has chosen, for a widget that takes the place of this one.
  struct Choices {
    std::map<std::string, bool> chosen{};            ///< by model
    std::map<std::string, ParameterValues> given{};  ///< by model, what differs from its default
    SurfaceCard::Choices surface{};
    int component = 0;  ///< of the force, as in its list
    int heard = 0;
  };
  Choices choices() const;
  void choose(const Choices& choices);

  /// The chosen models with their values, as the stroke has them: without a texture.
  struct Saveable {
    std::vector<Rendering> renderings{};
    QStringList
        left_out{};  ///< names of models that need more than a rendering has: bodies, or files
    bool is_on_body = false;  ///< the relief lies on a body: no rendering has one
  };
  Saveable saveable() const;

  /// While models are prepared, the stroke begins once they are ready, at the place of the hand then.
  void begin_stroke(double x_m, double y_m);
  void aim_stroke(double x_m, double y_m);
  void end_stroke();
  /// From left to right at 60 mm/s, as in the comparison of texture forces.
  void stroke_across(double y_m);

  /// Where the chosen force is heard. It is open while a force is to be heard and this is seen, and
  /// no longer. A null output is said so beside the choice, and one that does not play as soon as
  /// that is known.
  void set_sound(SoundOutput output);

  /// The last two seconds of the stroke, and their spectra.
  std::vector<PlotSeries> forces() const;
  std::vector<PlotSeries> spectra() const;
  /// The dent that the hand makes in the first of the stroked models with a soft surface.
  struct Dent {
    QString model{};  ///< its name
    SurfaceDent surface{};
  };
  std::optional<Dent> dent() const;
  /// How the forces of the stroke would shake a held tool (FeltRoughness): a curve of the RMS
  /// acceleration for every model, over the same two seconds, with the newest number as its name.
  std::vector<PlotSeries> roughness() const;
  /// The same numbers and the other measures, a line for every model; empty before there are any.
  QString roughness_in_words() const;

 signals:
  void advanced();  ///< there is more of the stroke, or there are other models
  void across_wanted();
  void models_changed();  ///< they are prepared, or being prepared

 protected:
  void showEvent(QShowEvent* event) override;
  /// Ends the stroke, and what is heard of it.
  void hideEvent(QHideEvent* event) override;

 private:
  struct ModelCard {
    const ForceModel* model = nullptr;
    QCheckBox* chosen = nullptr;
    QWidget* body = nullptr;
    ParameterForm* form = nullptr;
    StateLabel* complaint = nullptr;
    QColor color{};
  };
  struct Built;
  /// Of the stroke through one model.
  struct Shaking {
    FeltRoughness felt{FeltRoughness::Judging{}};
    std::optional<HeldToolRoughness> newest{};
    QVector<double> time_s{};
    QVector<double> rms_m_per_s2{};
  };
  void add_card(const ForceModel& model, QWidget* parent);
  void make_renderers();
  void take(Built built);
  void start_stroke();
  void clear_stroke();
  void frame();
  void judge();
  const ModelCard& card_of(std::size_t model) const;
  std::vector<double> component_of(std::size_t model, std::size_t first) const;
  void play();
  void open_or_close_sound();
  void look_at_card();

  std::vector<ModelCard> cards_{};
  SurfaceCard* surface_ = nullptr;
  QComboBox* component_ = nullptr;
  QComboBox* heard_ = nullptr;
  QLabel* no_sound_ = nullptr;
  std::shared_ptr<FieldPlate> field_{};
  ForceStroke stroke_{};
  std::vector<Shaking> shakings_{};  // by model of the stroke
  std::size_t judged_ = 0;           // samples of this stroke
  QElapsedTimer clock_{};
  QTimer frames_{};
  std::uint64_t frame_ = 0;
  std::optional<double> across_y_m_{};
  glm::dvec2 hand_at_m_{};
  bool is_stroke_waiting_ = false;  // for the models
  SoundOutput output_{};
  std::unique_ptr<ForceSpeaker> speaker_{};  // none while nothing is to be heard
  QTimer looks_{};                           // at the card, while there is a speaker
  QElapsedTimer silent_{};                   // since it was last seen to play, or was opened
  std::size_t played_ = 0;                   // samples of this stroke
  NewestWork work_{};
};

}  // namespace asperity
