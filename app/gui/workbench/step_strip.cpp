// Makes a button with caption and thumbnail for each step, scaled to the width of the strip.

#include "app/gui/workbench/step_strip.h"

#include <algorithm>

#include <QtCore/QCoreApplication>
#include <QtGui/QFontMetrics>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QToolButton>

#include "app/gui/look/theme.h"

namespace asperity {

namespace {

constexpr int kThumbnailWidth = 128;
constexpr int kCaption = 28;  // pixels of a thumbnail's words and border
constexpr int kFrame = 8;     // border and padding of a button, on both sides together

struct StepWords {
  Q_DECLARE_TR_FUNCTIONS(StepWords)
};

std::size_t at(Step step) { return static_cast<std::size_t>(step); }

}  // namespace

QString name_of(Step step) {
  switch (step) {
    case Step::photograph:
      return StepWords::tr("Photograph");
    case Step::grey:
      return StepWords::tr("Grey");
    case Step::evened:
      return StepWords::tr("Evened lighting");
    case Step::low_pass:
      return StepWords::tr("Long wavelengths");
    case Step::heights:
      return StepWords::tr("Heights");
    case Step::relief:
      break;
  }
  return StepWords::tr("Relief");
}

QString meaning_of(Step step) {
  switch (step) {
    case Step::photograph:
      return StepWords::tr("The photograph, unchanged.");
    case Step::grey:
      return StepWords::tr("Its brightness only; with “Equalized”, after histogram equalisation.");
    case Step::evened:
      return StepWords::tr(
          "Gradual changes of lighting are attenuated and fine detail is amplified.");
    case Step::low_pass:
      return StepWords::tr(
          "Wavelengths longer than the longest one kept; they are subtracted from the previous "
          "step.");
    case Step::heights:
      return StepWords::tr("The remainder, as heights: dark is low, bright is high.");
    case Step::relief:
      break;
  }
  return StepWords::tr("The heights as an illuminated surface.");
}

StepStrip::StepStrip(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  group_ = new QButtonGroup(this);
  QFont chosen_font = text_font(TextSize::small);
  chosen_font.setBold(true);
  const QFontMetrics metrics(chosen_font);
  int width = kThumbnailWidth;
  for (int i = 0; i < kSteps; ++i) {
    const auto step = static_cast<Step>(i);
    auto* button = new QToolButton(this);
    button->setObjectName(QString("step_%1").arg(i));
    button->setText(name_of(step));
    button->setToolTip(meaning_of(step));
    button->setCheckable(true);
    button->setEnabled(false);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setFont(text_font(TextSize::small));
    // The room decides about the icons, never the icons about the room.
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    button->setMinimumSize(1, 48);
    button->setStyleSheet(
        "QToolButton { border: 1px solid transparent; border-radius: 4px; padding: 2px; "
        "background: transparent; }"
        "QToolButton:hover, QToolButton:focus { border-color: palette(highlight); }"
        "QToolButton:checked { border: 2px solid palette(highlight); background: palette(base); "
        "font-weight: bold; }"
        "QToolButton:disabled { color: palette(mid); }");
    group_->addButton(button, i);
    width = std::max(width, metrics.horizontalAdvance(button->text()) + kFrame);
    layout->addWidget(button);
    buttons_[static_cast<std::size_t>(i)] = button;
  }
  setFixedWidth(width);  // of the longest name, which is bold while its step is chosen
  connect(group_, &QButtonGroup::idToggled, this, [this](int id, bool checked) {
    if (!checked) return;
    chosen_ = static_cast<Step>(id);
    emit stepChosen(chosen_);
  });
}

void StepStrip::set_picture(Step step, const QImage& picture) {
  if (pictures_[at(step)].cacheKey() == picture.cacheKey()) return;  // scaling costs time
  pictures_[at(step)] = picture;
  buttons_[at(step)]->setEnabled(!picture.isNull());
  if (picture.isNull()) {
    buttons_[at(step)]->setIcon({});
    if (chosen_ == step) choose(Step::relief);
  }
  fit(at(step));
}

const QImage& StepStrip::picture(Step step) const { return pictures_[at(step)]; }

void StepStrip::choose(Step step) { buttons_[at(step)]->setChecked(true); }

void StepStrip::resizeEvent(QResizeEvent*) {
  for (std::size_t i = 0; i < buttons_.size(); ++i) fit(i);
}

void StepStrip::fit(std::size_t index) {
  const QImage& picture = pictures_[index];
  if (picture.isNull()) return;
  const QSize room(kThumbnailWidth - kGrid * 2, std::max(24, height() / kSteps - kCaption - kGrid));
  buttons_[index]->setIconSize(room);
  buttons_[index]->setIcon(QPixmap::fromImage(
      picture.scaled(room * devicePixelRatioF(), Qt::KeepAspectRatio, Qt::SmoothTransformation)));
}

}  // namespace asperity

#include "moc_step_strip.cpp"
