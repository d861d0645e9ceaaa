// The steps from photograph to relief as a strip of small pictures, one of which is shown large.

#pragma once

#include <array>

#include <QtGui/QImage>
#include <QtWidgets/QWidget>

class QButtonGroup;
class QToolButton;

namespace asperity {

enum class Step { photograph, grey, evened, low_pass, heights, relief };
inline constexpr int kSteps = 6;

QString name_of(Step step);
/// What happened in this step, in a sentence.
QString meaning_of(Step step);

/// A click, or an arrow key, chooses. A step without picture cannot be chosen.
class StepStrip final : public QWidget {
  Q_OBJECT
 public:
  explicit StepStrip(QWidget* parent = nullptr);

  void set_picture(Step step, const QImage& picture);  ///< null: there is none
  const QImage& picture(Step step) const;
  Step chosen() const noexcept { return chosen_; }
  void choose(Step step);

 signals:
  void stepChosen(asperity::Step step);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit(std::size_t index);

  std::array<QToolButton*, kSteps> buttons_{};
  std::array<QImage, kSteps> pictures_{};
  QButtonGroup* group_ = nullptr;
  Step chosen_ = Step::relief;
};

}  // namespace asperity
