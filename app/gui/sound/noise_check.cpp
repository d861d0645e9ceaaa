// Plays the noise at the gain of the slider, and shows the required level and reservations about it.

#include "app/gui/sound/noise_check.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include <QtCore/QEvent>
#include <QtCore/QSignalBlocker>
#include <QtCore/QTimer>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSlider>

#include "app/gui/look/controls.h"
#include "app/gui/look/decimal_field.h"
#include "app/gui/look/words.h"
#include "app/gui/sound/qt_sound.h"
#include "app/tasks/checks/noise_check.h"

namespace asperity {

namespace {

// The slider counts half decibels relative to full scale.
constexpr int kLowest = -120;  // −60 dB
constexpr int kHighest = -25;  // −12.5 dB, just below MaskingSound::kHighestGain
constexpr int kNoiseLook_ms = 250;
constexpr double kLoudest_dBA = 85.0;      // over a working day; no protocol may ask for more
constexpr double kNotMeasured_dBA = 29.5;  // the spin box's lowest value stands for "not measured"

double gain_of(int slider) { return std::pow(10.0, 0.5 * slider / 20.0); }
int slider_of(double gain) {
  return std::clamp(static_cast<int>(std::lround(40.0 * std::log10(gain))), kLowest, kHighest);
}

/// Passes the wheel to the page that a field stands on: who scrolls over a level does not turn it.
class WheelPasser final : public QObject {
 public:
  explicit WheelPasser(QObject* field) : QObject(field) { field->installEventFilter(this); }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Wheel) return false;
    event->ignore();
    return true;
  }
};

}  // namespace

NoiseCheck::NoiseCheck(const MaskingNoise& declared, QWidget* parent)
    : NoiseCheck(declared, default_output(), parent) {}

NoiseCheck::NoiseCheck(const MaskingNoise& declared, SoundOutput output, QWidget* parent)
    : QWidget(parent), value_(declared), output_(std::move(output)) {
  const bool has_noise = value_.kind != MaskingNoise::Kind::none;

  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid);

  QString what = tr("This protocol uses no masking noise. Cues are played nevertheless.");
  const bool white = value_.kind == MaskingNoise::Kind::white;
  if (has_noise && value_.declared_dBA) {
    const QString level = shown_number(*value_.declared_dBA, 'f', 0);
    what = white ? tr("The protocol requires white noise of %1 dB(A) at the ear.").arg(level)
                 : tr("The protocol requires pink noise of %1 dB(A) at the ear.").arg(level);
  } else if (has_noise) {
    what = white ? tr("The protocol requires white noise and states no level.")
                 : tr("The protocol requires pink noise and states no level.");
  }
  rows->addWidget(make_text(what, this));
  state_ = new StateLabel(this);
  state_->setObjectName("noise_state");
  rows->addWidget(state_);

  auto* buttons = new QHBoxLayout();
  buttons->setSpacing(kGrid);
  noise_ = make_button(tr("Play noise"), ButtonRole::selector, this);
  noise_->setObjectName("play_noise");
  noise_->setVisible(has_noise);
  QPushButton* cue = make_button(tr("Play a cue"), ButtonRole::plain, this);
  cue->setObjectName("play_cue");
  buttons->addWidget(noise_);
  buttons->addWidget(cue);
  buttons->addStretch(1);
  rows->addLayout(buttons);

  rows->addSpacing(kGrid);
  auto* grid = new QGridLayout();
  grid->setHorizontalSpacing(kMargin);
  grid->setVerticalSpacing(kGrid);
  grid->setColumnStretch(1, 1);
  const auto add_row = [this, grid](int row, const QString& name, QWidget* field, QWidget* after) {
    auto* label = new QLabel(name, this);
    label->setBuddy(field);
    grid->addWidget(label, row, 0);
    grid->addWidget(field, row, 1, 1, after == nullptr ? 2 : 1);
    if (after != nullptr) grid->addWidget(after, row, 2);
  };

  gain_ = new QSlider(Qt::Horizontal, this);
  new WheelPasser(gain_);
  gain_->setObjectName("noise_gain");
  gain_->setRange(kLowest, kHighest);
  gain_->setPageStep(6);
  gain_->setMinimumHeight(kControlHeight);
  gain_->setValue(slider_of(value_.gain));
  gain_text_ = new QLabel(this);
  gain_text_->setFont(number_font(TextSize::body));
  gain_text_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  gain_text_->setMinimumWidth(gain_text_->fontMetrics().horizontalAdvance("−60.0 dB"));
  gain_text_->setToolTip(tr("Relative to the highest level that the sound card can play"));
  add_row(0, tr("&Gain"), gain_, gain_text_);

  measured_ = new DecimalField(this);
  new WheelPasser(measured_);
  measured_->setObjectName("measured_level");
  measured_->setRange(kNotMeasured_dBA, 100.0);
  measured_->setDecimals(1);
  measured_->setSingleStep(0.5);
  measured_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  measured_->setSuffix(tr(" dB(A)"));
  measured_->setSpecialValueText(tr("not measured"));
  measured_->setValue(value_.measured_dBA.value_or(kNotMeasured_dBA));
  add_row(1, tr("&Level at the ear"), measured_, nullptr);

  verified_by_ = new QLineEdit(QString::fromStdString(value_.verified_by), this);
  verified_by_->setObjectName("verified_by");
  verified_by_->setPlaceholderText(tr("Experimenter who read the sound level meter"));
  add_row(2, tr("&Verified by"), verified_by_, nullptr);
  rows->addLayout(grid);
  if (!has_noise) {
    for (int row = 1; row <= 2; ++row) {
      for (int column = 0; column <= 1; ++column) {
        grid->itemAtPosition(row, column)->widget()->hide();
      }
    }
  }

  connect(noise_, &QPushButton::toggled, this, &NoiseCheck::play_noise);
  connect(cue, &QPushButton::clicked, this, [this] { sound().play(Cue::question, 0); });
  connect(gain_, &QSlider::valueChanged, this, &NoiseCheck::set_gain);
  connect(measured_, &QDoubleSpinBox::valueChanged, this, [this](double level_dBA) {
    value_.measured_dBA.reset();
    if (level_dBA > kNotMeasured_dBA) value_.measured_dBA = level_dBA;
    show_state();
    emit changed();
  });
  connect(verified_by_, &QLineEdit::textChanged, this, [this](const QString& name) {
    value_.verified_by = name.trimmed().toStdString();
    show_state();
    emit changed();
  });
  watch_ = new QTimer(this);
  watch_->setInterval(kNoiseLook_ms);
  connect(watch_, &QTimer::timeout, this, &NoiseCheck::look_at_card);
  noise_->setEnabled(!output_.is_null);  // the line above says why
  cue->setEnabled(!output_.is_null);
  show_state();
}

NoiseCheck::~NoiseCheck() = default;

QtSound& NoiseCheck::sound() {
  if (!sound_) {
    sound_ =
        std::make_unique<QtSound>(value_, std::map<std::string, std::filesystem::path>{}, output_);
    silent_.start();
    watch_->start();
  }
  return *sound_;
}

/// A card that opens within the time that any card takes is not spoken of.
void NoiseCheck::look_at_card() {
  if (!sound_) {
    watch_->stop();
    return;
  }
  if (sound_->is_running()) silent_.restart();
  const bool is_silent = static_cast<double>(silent_.elapsed()) > SoundStream::kOpens_s * 1e3;
  if (is_silent == is_silent_) return;
  is_silent_ = is_silent;
  show_state();
  emit changed();
}

void NoiseCheck::play_noise(bool on) {
  noise_->setText(on ? tr("Stop noise") : tr("Play noise"));
  if (on || sound_) sound().set_masking(on);
}

void NoiseCheck::set_gain(int slider) {
  value_.gain = gain_of(slider);
  if (sound_) sound_->set_gain(value_.gain);
  value_.measured_dBA.reset();
  const QSignalBlocker quiet(measured_);
  measured_->setValue(kNotMeasured_dBA);
  show_state();
  emit changed();
}

QString NoiseCheck::reservation() const {
  if (output_.is_null)
    return tr("There is no sound output. Connect headphones to play noise and cues.");
  if (is_silent_) {
    return tr("%1 produces no sound. Connect it again, or choose another sound output in the "
              "settings of the computer.")
        .arg(output_.name);
  }
  if (value_.kind == MaskingNoise::Kind::none) return {};
  if (!value_.measured_dBA)
    return tr("The level of the noise at the ear was not measured; measure it, and enter it.");
  if (*value_.measured_dBA > kLoudest_dBA) {
    return tr("The noise was measured at %1 dB(A): levels above %2 dB(A) can damage hearing. Lower "
              "the gain, and measure again.")
        .arg(shown_number(*value_.measured_dBA, 'f', 1))
        .arg(shown_number(kLoudest_dBA, 'f', 0));
  }
  if (value_.declared_dBA &&
      std::abs(*value_.measured_dBA - *value_.declared_dBA) > kNoiseTolerance_dBA) {
    return tr("The noise was measured at %1 dB(A); the protocol requires %2 dB(A). Change the "
              "gain, and measure again.")
        .arg(shown_number(*value_.measured_dBA, 'f', 1))
        .arg(shown_number(*value_.declared_dBA, 'f', 1));
  }
  if (value_.verified_by.empty())
    return tr("The experimenter who measured the noise has not been entered; enter the name.");
  return {};
}

void NoiseCheck::show_state() {
  gain_text_->setText(tr("%1 dB").arg(shown_number(20.0 * std::log10(value_.gain), 'f', 1)));
  const QString problem = reservation();
  if (problem.isEmpty()) {
    state_->set_state(State::fine, tr("Sound output: %1.").arg(output_.name));
  } else {
    state_->set_state(State::look, problem);
  }
}

void NoiseCheck::hideEvent(QHideEvent* event) {
  noise_->setChecked(false);
  sound_.reset();
  watch_->stop();
  is_silent_ = false;
  QWidget::hideEvent(event);
}

}  // namespace asperity

#include "moc_noise_check.cpp"
