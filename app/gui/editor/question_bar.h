// A question in place that has to be answered, with a button for every answer.

#pragma once

#include <functional>
#include <vector>

#include <QtCore/QString>
#include <QtWidgets/QFrame>

class QHBoxLayout;
class QLabel;

namespace asperity {

/// Hidden until something is asked; hides with the answer. A newer question takes the place of one
/// that is not answered, which is as if nobody had asked it.
class QuestionBar final : public QFrame {
  Q_OBJECT
 public:
  struct Answer {
    QString name{};  ///< object name of the button
    QString verb{};
    std::function<void()> act{};
  };

  explicit QuestionBar(QWidget* parent = nullptr);
  void ask(const QString& question, const std::vector<Answer>& answers);
  QString question() const;

 private:
  QLabel* question_ = nullptr;
  QHBoxLayout* buttons_ = nullptr;
};

}  // namespace asperity
