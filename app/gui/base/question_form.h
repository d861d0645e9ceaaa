// A protocol's questions about a person, as a form.

#pragma once

#include <vector>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "app/records/participant_answers.h"
#include "protocols/design/protocol.h"

class QGridLayout;

namespace asperity {

/// One row per question, the prompt at the left and the field at the right; required ones carry a
/// star. The field of a question has the object name "question_NAME".
class QuestionForm final : public QWidget {
  Q_OBJECT
 public:
  explicit QuestionForm(QWidget* parent = nullptr);

  /// The fields are empty afterwards, unless the questions are those that were asked already.
  void set_questions(const std::vector<Question>& questions);
  ParticipantAnswers answers() const;
  /// Those of questions that are not asked are left out.
  void set_answers(const ParticipantAnswers& answers);
  /// A sentence for each answer that is missing or not acceptable, in the order of the questions.
  std::vector<QString> complaints() const;
  void clear_answers();
  /// In the order of the questions.
  std::vector<QWidget*> fields() const;

 signals:
  void answered();

 private:
  void add_row(const Question& question, int row);

  std::vector<Question> questions_{};
  QGridLayout* grid_ = nullptr;
};

/// Lets the wheel scroll the page instead of changing what was chosen in `field`.
void ignore_wheel(QWidget& field);

}  // namespace asperity
