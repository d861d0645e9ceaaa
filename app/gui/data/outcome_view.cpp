// Builds a column of widgets from an outcome, with long texts no wider than is legible and details folded.

#include "app/gui/data/outcome_view.h"

#include <algorithm>
#include <set>

#include <QtCore/QCoreApplication>

#include "app/findings/outcome/figures_of.h"
#include "app/gui/data/figure_view.h"
#include "app/gui/data/result_table_view.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

// The texts belong to the page of the analyses.
struct OutcomeText {
  Q_DECLARE_TR_FUNCTIONS(asperity::AnalysisPage)
};

constexpr int kTextWidth = 900;  // longer lines are hard to follow

/// Left-bound and no wider than is good to read. In a row of its own, because a column asks how high
/// a text is at its whole width, whatever the text's maximum.
void add_narrow(QWidget* text, QVBoxLayout& column) {
  text->setMaximumWidth(kTextWidth);
  auto* row = new QHBoxLayout();
  row->addWidget(text, 1000);
  row->addStretch(1);
  column.addLayout(row);
}

/// A line to press that shows or hides what is under it.
void add_folded(const QString& words, const QString& text, QVBoxLayout& layout, QWidget* parent) {
  QPushButton* fold = make_button("▸ " + words, ButtonRole::link, parent);
  fold->setCheckable(true);
  QLabel* note = make_text(text, parent, true);
  note->hide();
  QObject::connect(fold, &QPushButton::toggled, note, [fold, note, words](bool open) {
    fold->setText((open ? "▾ " : "▸ ") + words);
    note->setVisible(open);
  });
  layout.addWidget(fold, 0, Qt::AlignLeft);
  add_narrow(note, layout);
}

QString people_text(int count) {
  return count == 1 ? OutcomeText::tr("1 participant")
                    : OutcomeText::tr("%n participants", nullptr, count);
}

/// What belongs to an outcome, one under the other.
class OutcomeColumn final {
 public:
  OutcomeColumn(const AnalysisOutcome& outcome, const FigureWishes& wishes, QWidget* page)
      : outcome_(outcome), wishes_(wishes), figures_(figures_of(outcome)), page_(page) {
    layout_ = new QVBoxLayout(page);
    layout_->setContentsMargins(kMargin, 0, kMargin, kMargin);
    layout_->setSpacing(kGrid);
  }

  void fill() {
    if (outcome_.group != AnswerGroup::people) {
      auto* band = new ModeBand(page_);
      band->set_mode(outcome_.group == AnswerGroup::pilot ? SessionMode::pilot
                                                          : SessionMode::simulate);
      layout_->addWidget(band);
    }
    if (outcome_.questions.empty()) {
      say(QString::fromStdString(outcome_.protocol), {});
      about();
      if (!figures_.empty()) add_table(figures_.front().table);
    }
    for (const AnsweredQuestion& question : outcome_.questions) {
      const bool is_first = &question == &outcome_.questions.front();
      if (!is_first) layout_->addSpacing(kGroupGap);
      say(sentences_as_published(question.question), sentences_as_published(question.answer));
      if (is_first) about();
      add_table(question.table);
      if (question.method.empty()) continue;
      add_folded(OutcomeText::tr("Method"), sentences_as_published(question.method), *layout_,
                 page_);
    }
    for (const ResultTable& table : outcome_.tables) add_table(table.name);
    for (const Figure& figure : figures_) {
      if (figure.table.empty()) add_figure(figure);
    }
    layout_->addStretch(1);
  }

 private:
  void say(const QString& question, const QString& answer) {
    const bool is_first = layout_->count() <= 1;
    QLabel* title = is_first ? make_title(question, page_) : make_heading(question, page_);
    title->setWordWrap(true);
    add_narrow(title, *layout_);
    if (answer.isEmpty()) return;
    QLabel* sentence = is_first ? make_heading(answer, page_) : make_text(answer, page_);
    sentence->setWordWrap(true);
    sentence->setObjectName(is_first ? "answer" : "further_answer");
    add_narrow(sentence, *layout_);
  }

  /// Who answered, and what is to be known before a number is believed.
  void about() {
    QStringList facts{OutcomeText::tr("%1 %2 · %3 · %4 counted")
                          .arg(text(outcome_.protocol), text(outcome_.version),
                               people_text(static_cast<int>(outcome_.count.participants)),
                               answers_text(static_cast<int>(outcome_.answers)))};
    if (outcome_.questions.size() > 1) {
      facts << OutcomeText::tr("the first of %1 questions").arg(outcome_.questions.size());
    }
    layout_->addWidget(make_text(facts.join(" · "), page_, true));
    for (const Phrase& remark : outcome_.remarks) {
      auto* line = new StateLabel(page_);
      line->set_state(State::look, sentences_as_published(remark));
      add_narrow(line, *layout_);
    }
  }

  /// Once, with its figures above it.
  void add_table(const std::string& name) {
    if (!shown_.insert(name).second) return;
    for (const ResultTable& table : outcome_.tables) {
      if (table.name != name) continue;
      layout_->addSpacing(kMargin);
      layout_->addWidget(make_heading(sentences_as_published(table.title), page_));
      for (const Figure& figure : figures_) {
        if (figure.table == name) add_figure(figure);
      }
      layout_->addWidget(new ResultTableView(table, page_));
      if (table.note.empty()) continue;
      add_folded(OutcomeText::tr("Notes on this table"), sentences_as_published(table.note),
                 *layout_, page_);
    }
  }

  void add_figure(const Figure& figure) {
    if (figure.table.empty()) {
      layout_->addSpacing(kMargin);
      layout_->addWidget(make_heading(sentences_as_published(figure.title), page_));
    }
    auto* view = new FigureView(figure, page_);
    view->setObjectName(QString::fromStdString("figure_" + figure.name));
    QObject::connect(
        view, &FigureView::saveWanted, view,
        [wishes = wishes_, view](double width_mm) { wishes.save(view->figure(), width_mm); });
    QObject::connect(view, &FigureView::copyWanted, view,
                     [wishes = wishes_, view] { wishes.copy(view->figure()); });
    add_narrow(view, *layout_);
  }

  const AnalysisOutcome& outcome_;
  const FigureWishes& wishes_;
  std::vector<Figure> figures_{};
  std::set<std::string> shown_{};
  QWidget* page_ = nullptr;
  QVBoxLayout* layout_ = nullptr;
};

}  // namespace

QString answers_text(int count) {
  return count == 1 ? OutcomeText::tr("1 response")
                    : OutcomeText::tr("%n responses", nullptr, count);
}

QWidget* make_outcome(const AnalysisOutcome& outcome, const FigureWishes& wishes) {
  auto* page = new QWidget();
  OutcomeColumn(outcome, wishes, page).fill();
  return page;
}

}  // namespace asperity
