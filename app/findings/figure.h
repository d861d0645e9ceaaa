// What a figure shows, as plain values: no colours, no letters, no pixels, nothing of Qt.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/words/phrase.h"

namespace asperity {

enum class AxisScale { linear, log10 };

/// One direction of a plot. With `places` its numbers are 0, 1, 2, … and are written as these names.
struct FigureAxis {
  Phrase name{};
  std::string unit{};  ///< as SI writes it; empty for a pure number
  AxisScale scale = AxisScale::linear;
  double low = 0.0;  ///< what is shown, from here
  double high = 1.0;
  std::vector<Phrase> places{};
};

struct FigureSpan {
  double low = 0.0;
  double high = 0.0;
};

/// An interval that goes on beyond the axis ends there with an arrow instead of a cap.
struct FigurePoint {
  double x = 0.0;
  double y = 0.0;
  std::optional<FigureSpan> x_interval{};
  std::optional<FigureSpan> y_interval{};
  Phrase label{};     ///< beside the point; empty: none
  double size = 1.0;  ///< its width, against that of other points
};

struct FigurePlace {
  double x = 0.0;
  double y = 0.0;
};

/// Marks of one thing. `style` is its colour, the shape of its points and the strokes of its lines at
/// once, so that nothing rests on colour alone. The key has an entry for every name, where there is more
/// than one; series without a name belong to the one of their style.
struct FigureSeries {
  Phrase name{};
  int style = 0;
  bool hollow = false;  ///< its points are outlines
  bool single = false;  ///< of single participants: small and pale, behind all others
  std::vector<FigurePoint> points{};
  std::vector<std::vector<FigurePlace>> lines{};  ///< each from place to place
};

/// A dashed line across the plot, as chance is.
struct FigureReference {
  enum class At { x, y };
  At at = At::x;
  double value = 0.0;
  Phrase label{};
};

/// Rectangles on places of both axes, row 0 at the top. Shade 0 is the ground, 1 the strongest.
struct FigureCell {
  std::size_t column = 0;
  std::size_t row = 0;
  std::optional<double> shade{};  ///< nothing: there is nothing to shade
  std::string text{};
  bool framed = false;
};

/// How high a figure is for its width.
enum class FigureShape {
  rows,    ///< as its rows, the places of the vertical axis, need
  wide,    ///< 3 : 5
  square,  ///< both directions have one scale
};

/// A figure is drawn from this alone (draw_figure.h) and written as SVG, PNG and PDF
/// (figure_files.h). Where there is nothing to draw, `instead` is the sentence that says why.
struct Figure {
  std::string name{};      ///< fixed, for files: "shares_forest"
  std::string table{};     ///< the table of the outcome that has its numbers; empty: none
  std::string question{};  ///< the question of the outcome that it answers; empty: none
  Phrase title{};          ///< for whoever places it; not drawn
  Phrase note{};           ///< what the marks are and how to read them; not drawn
  Phrase instead{};
  FigureShape shape = FigureShape::wide;
  FigureAxis x{};
  FigureAxis y{};  ///< with `places`, from the top down
  std::vector<FigureSeries> series{};
  std::vector<FigureReference> references{};
  std::vector<FigureCell> cells{};
  Phrase shade_name{};  ///< what the shade of cells is a share of

  bool is_drawn() const noexcept { return instead.empty(); }
};

}  // namespace asperity
