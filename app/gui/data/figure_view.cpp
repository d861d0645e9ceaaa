// Draws a figure on a canvas in the colours of the theme.

#include "app/gui/data/figure_view.h"

#include <cmath>
#include <utility>

#include <QtGui/QFontInfo>
#include <QtGui/QPainter>
#include <QtWidgets/QMenu>

#include "app/figures/draw_figure.h"
#include "app/figures/figure_files.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

FigureLook look_of_theme() {
  const Theme& look = theme();
  FigureLook figure_look{};
  figure_look.colors = {.ground = look.panel,
                        .text = look.text,
                        .muted = look.muted,
                        .line = look.line,
                        .strong = look.dark ? QColor("#9CD0FF") : print_colors().strong};
  const QFont font = text_font(TextSize::small);
  figure_look.family = font.family();
  figure_look.letters = QFontInfo(font).pixelSize();
  figure_look.look_up = language_of_windows();
  return figure_look;
}

/// Nothing but the drawing.
class FigureCanvas final : public QWidget {
 public:
  FigureCanvas(const Figure& figure, QWidget* parent) : QWidget(parent), figure_(figure) {
    setObjectName("canvas");
    setAccessibleName(words_as_published(figure.title));
    setAccessibleDescription(words_as_published(figure.note));
    // Not fixed: the height would end at that of the usual width.
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
  }

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override {
    return static_cast<int>(std::ceil(figure_height(figure_, width, look_of_theme())));
  }
  QSize sizeHint() const override {
    constexpr int kUsualWidth = 640;
    return {kUsualWidth, heightForWidth(kUsualWidth)};
  }
  QSize minimumSizeHint() const override { return {320, 80}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    draw_figure(figure_, painter, rect(), look_of_theme());
  }

 private:
  const Figure& figure_;
};

}  // namespace

FigureView::FigureView(Figure figure, QWidget* parent)
    : QFrame(parent), figure_(std::move(figure)) {
  setProperty("role", "card");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kMargin, kMargin, kGrid);
  layout->setSpacing(kGrid);
  if (!figure_.is_drawn()) {
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    QLabel* sentence = make_text(sentences_as_published(figure_.instead), this, true);
    sentence->setObjectName("figure_instead");
    layout->addWidget(sentence);
    return;
  }
  layout->addWidget(new FigureCanvas(figure_, this));
  QLabel* note = make_text(sentences_as_published(figure_.note), this, true);
  note->setFont(text_font(TextSize::small));
  layout->addWidget(note);
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  QPushButton* save = make_button(tr("Save figure"), ButtonRole::plain, this);
  save->setObjectName("save_figure");
  auto* widths = new QMenu(save);
  widths->addAction(tr("Save at the width of a journal column, 85 mm…"), this,
                    [this] { emit saveWanted(kColumnWidth_mm); });
  widths->addAction(tr("Save at the width of a page, 170 mm…"), this,
                    [this] { emit saveWanted(kPageWidth_mm); });
  save->setMenu(widths);
  QPushButton* copy = make_button(tr("Copy figure"), ButtonRole::plain, this);
  copy->setObjectName("copy_figure");
  connect(copy, &QPushButton::clicked, this, &FigureView::copyWanted);
  row->addWidget(save);
  row->addWidget(copy);
  row->addStretch(1);
  layout->addLayout(row);
}

}  // namespace asperity

#include "moc_figure_view.cpp"
