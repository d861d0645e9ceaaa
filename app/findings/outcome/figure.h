// Describes a figure as plain values: no colours, fonts, pixels or Qt.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/words/phrase.h"

namespace asperity {

/// Lengths are stored in metres and drawn in millimetres.
inline constexpr double kMillimetresPerMetre = 1e3;
/// How far a logarithmic axis extends beyond the outermost marks, as a factor.
inline constexpr double kBeyondMarks = 1.12;

enum class AxisScale { linear, log10 };

/// One axis of a plot. With `places` its numbers are 0, 1, 2, … and are labelled with these names;
/// those of `far_places` label the same places at their other ends, to the right of rows.
struct FigureAxis {
  Phrase name{};
  std::string unit{};  ///< as SI writes it; empty for a pure number
  AxisScale scale = AxisScale::linear;
  double low = 0.0;  ///< the range shown, from here
  double high = 1.0;
  std::vector<Phrase> places{};
  std::vector<Phrase> far_places{};  ///< as many as places, or none
};

struct FigureSpan {
  double low = 0.0;
  double high = 0.0;
};

/// An interval that extends beyond the axis ends there with an arrow instead of a cap.
struct FigurePoint {
  double x = 0.0;
  double y = 0.0;
  std::optional<FigureSpan> x_interval{};
  std::optional<FigureSpan> y_interval{};
  Phrase label{};     ///< next to the point; empty: none
  double size = 1.0;  ///< its width, relative to other points
};

struct FigurePlace {
  double x = 0.0;
  double y = 0.0;
};

/// From the origin of both axes.
struct FigureArrow {
  FigurePlace to{};
  Phrase label{};  ///< beyond its head
};

/// A series of marks. `style` determines its colour, the shape of its points and its line style
/// together, so that no information depends on colour alone. The legend has an entry for every
/// name, where there is more than one; a series without a name belongs to the named one of its
/// style.
struct FigureSeries {
  Phrase name{};
  int style = 0;
  bool hollow = false;  ///< its points are outlines
  bool single = false;  ///< for single participants: small and pale, behind all others
  std::vector<FigurePoint> points{};
  std::vector<std::vector<FigurePlace>> lines{};  ///< each connects several places
  std::vector<FigureArrow> arrows{};
};

/// A dashed line across the plot, for example at chance level.
struct FigureReference {
  enum class At {
    x,
    y,
    equal,  ///< where both axes have the same number
  };
  At at = At::x;
  double value = 0.0;  ///< of the axis; not used for `equal`
  Phrase label{};
};

/// A rectangle at a place of both axes, row 0 at the top. Shade 0 is the background, 1 the
/// strongest.
struct FigureCell {
  std::size_t column = 0;
  std::size_t row = 0;
  std::optional<double> shade{};  ///< absent: not shaded
  std::string text{};
  bool framed = false;
};

/// Rows with several marks, one above the other, are higher by this distance than their marks, in
/// units of the distance between two marks.
inline constexpr double kRoomBetweenRows = 1.2;

/// The height of a figure in relation to its width.
enum class FigureShape {
  rows,    ///< as its rows, the places of the vertical axis, require
  wide,    ///< 3 : 5
  square,  ///< both axes have the same units; a square if their ranges are equal
};

/// The complete input of drawing (draw_figure.h) and of SVG, PNG and PDF files (figure_files.h).
/// Where there is nothing to draw, `instead` states why.
struct Figure {
  std::string name{};      ///< fixed, for files: "shares_forest"
  std::string table{};     ///< the table of the outcome that contains its numbers; empty: none
  std::string question{};  ///< that it answers, if the outcome asks it; empty: none
  Phrase title{};          ///< for the caption; not drawn
  Phrase note{};           ///< explains the marks and how to read them; not drawn
  Phrase instead{};
  FigureShape shape = FigureShape::wide;
  FigureAxis x{};
  FigureAxis y{};                 ///< with `places`, from the top down
  std::size_t marks_per_row = 1;  ///< one above the other, of a place of the vertical axis
  std::vector<FigureSeries> series{};
  std::vector<FigureReference> references{};
  std::vector<FigureCell> cells{};
  Phrase shade_name{};  ///< the quantity that the shade of cells represents

  bool is_drawn() const noexcept { return instead.empty(); }
};

/// The figure as the answer to a question (AnsweredQuestion::name).
inline Figure answering(std::string question, Figure figure) {
  figure.question = std::move(question);
  return figure;
}

}  // namespace asperity
