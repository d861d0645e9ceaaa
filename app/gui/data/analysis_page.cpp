#include "app/gui/data/analysis_page.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <variant>

#include <QtGui/QStandardItemModel>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QStackedWidget>
#include <QtWidgets/QTableView>
#include <qcustomplot.h>

#include "analysis/number_text.h"
#include "app/analyses/analyze_study.h"
#include "app/analyses/reading_table.h"
#include "app/gui/data/analysis_words.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/task_line.h"
#include "app/gui/look/words.h"
#include "app/gui/study/open_study.h"
#include "app/tasks/export_study.h"
#include "app/tasks/study_overview.h"

namespace asperity {

namespace {

constexpr int kTextWidth = 900;  // longer lines are hard to follow

/// A table whose rows are shares with an interval: where its columns are.
struct ShareColumns {
  std::size_t keys = 0;  ///< the first so many columns say what the row is about
  std::size_t hits = 0;
  std::size_t of = 0;
  std::size_t share = 0;
  std::optional<std::size_t> low{};  ///< of the share's own interval; the high end is beside it
  std::optional<std::size_t> chance{};
};

std::optional<std::size_t> column_of(const Table& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found == table.columns.end()) return {};
  return static_cast<std::size_t>(found - table.columns.begin());
}

std::optional<ShareColumns> share_columns(const Table& table) {
  const auto share = column_of(table, "share");
  const auto of = column_of(table, "of");
  if (!share || !of || *of == 0) return {};
  ShareColumns columns{};
  columns.hits = *of - 1;
  columns.keys = columns.hits;
  columns.of = *of;
  columns.share = *share;
  columns.low = column_of(table, "wilson_low");
  columns.chance = column_of(table, "chance");
  return columns;
}

/// What stands in a column of this name.
QString text_of(const std::string& column, const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) {
    return AnalysisWords::of_cell(column, *text);
  }
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return QString::number(*whole);
  if (const auto* number = std::get_if<double>(&cell)) {
    return QString::fromStdString(number_text(*number));
  }
  return "–";
}

std::optional<double> number_of(const Cell& cell) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  return {};
}

QString percent(const Cell& cell) {
  const auto share = number_of(cell);
  return share ? QString::fromStdString(fixed(100.0 * *share, 0)) + " %" : "–";
}

/// The words of a row's key columns: "all · Total".
QString key_of(const Table& table, std::size_t row, const ShareColumns& columns) {
  QStringList words{};
  for (std::size_t i = 0; i < columns.keys; ++i) {
    words << text_of(table.columns[i], table.rows[row][i]);
  }
  return words.join(" · ");
}

/// A name or a level, also one that is written as a number ("1", then "all"), as opposed to a quantity.
bool holds_words(const Table& table, const std::string& column) {
  const auto at = column_of(table, column);
  return at && !table.rows.empty() && std::holds_alternative<std::string>(table.rows.front()[*at]);
}

QTableView* make_table(const NamedTable& table, QWidget* parent) {
  const Table reading = reading_table(table.table);
  auto* view = new QTableView(parent);
  auto* model = new QStandardItemModel(view);
  QStringList headings{};
  for (const std::string& column : reading.columns) {
    headings << AnalysisWords::of_heading(table, column);
  }
  model->setHorizontalHeaderLabels(headings);
  for (const std::vector<Cell>& row : reading.rows) {
    QList<QStandardItem*> items{};
    for (std::size_t i = 0; i < row.size(); ++i) {
      auto* item = new QStandardItem(text_of(reading.columns[i], row[i]));
      item->setTextAlignment(
          (holds_words(table.table, reading.columns[i]) ? Qt::AlignLeft : Qt::AlignRight) |
          Qt::AlignVCenter);
      items << item;
    }
    model->appendRow(items);
  }
  for (int column = 0; column < model->columnCount(); ++column) {
    const bool words = holds_words(table.table, reading.columns[static_cast<std::size_t>(column)]);
    model->horizontalHeaderItem(column)->setTextAlignment((words ? Qt::AlignLeft : Qt::AlignRight) |
                                                          Qt::AlignVCenter);
  }
  style_table(*view);
  view->setSortingEnabled(false);  // rows belong together: parts, then totals
  view->setModel(model);
  view->resizeColumnsToContents();
  for (int column = 0; column < model->columnCount(); ++column) {
    view->setColumnWidth(column, view->columnWidth(column) + kMargin);
  }
  view->horizontalHeader()->setStretchLastSection(false);
  view->setMaximumWidth(view->horizontalHeader()->length() + 4);
  // The page scrolls, not the table.
  view->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view->setFixedHeight(view->horizontalHeader()->sizeHint().height() +
                       kControlHeight * model->rowCount() +
                       view->horizontalScrollBar()->sizeHint().height() / 2 + 4);
  return view;
}

/// Shares with their intervals as points on one scale, a row below the other; chance is a line.
QCustomPlot* make_forest(const Table& table, const ShareColumns& columns, QWidget* parent) {
  auto* plot = new QCustomPlot(parent);
  auto labels = QSharedPointer<QCPAxisTickerText>::create();
  QVector<double> shares{};
  QVector<double> places{};
  QVector<double> below{};
  QVector<double> above{};
  const double rows = static_cast<double>(table.rows.size());
  // From the bottom up: a plot keeps its points in the order of their places, and the intervals go
  // by that order.
  for (std::size_t i = table.rows.size(); i-- > 0;) {
    const std::vector<Cell>& row = table.rows[i];
    const auto share = number_of(row[columns.share]);
    const double place = rows - static_cast<double>(i);
    labels->addTick(place, key_of(table, i, columns));
    if (!share) continue;
    const auto low = columns.low ? number_of(row[*columns.low]) : std::nullopt;
    const auto high = columns.low ? number_of(row[*columns.low + 1]) : std::nullopt;
    shares << *share;
    places << place;
    below << *share - low.value_or(*share);
    above << high.value_or(*share) - *share;
  }
  QCPGraph* points = plot->addGraph(plot->yAxis, plot->xAxis);
  points->setData(places, shares);
  points->setLineStyle(QCPGraph::lsNone);
  points->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, series_color(0), 8));
  auto* bars = new QCPErrorBars(plot->yAxis, plot->xAxis);
  bars->setDataPlottable(points);
  bars->setErrorType(QCPErrorBars::etValueError);
  bars->setPen(QPen(series_color(0), 1.5));
  bars->setData(below, above);
  if (columns.chance && !table.rows.empty()) {
    if (const auto chance = number_of(table.rows.back()[*columns.chance])) {
      auto* line = new QCPItemStraightLine(plot);
      line->point1->setCoords(*chance, 0.0);
      line->point2->setCoords(*chance, 1.0);
      line->setPen(QPen(theme().muted, 1.0, Qt::DashLine));
      auto* word = new QCPItemText(plot);
      word->position->setTypeX(QCPItemPosition::ptPlotCoords);
      word->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
      word->position->setCoords(*chance, 0.0);
      word->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
      word->setText(" " + AnalysisPage::tr("chance"));
      word->setColor(theme().muted);
      word->setFont(text_font(TextSize::small));
    }
  }
  plot->xAxis->setRange(-0.02, 1.02);
  plot->xAxis->setLabel(AnalysisPage::tr("share, with its 95 % interval (Wilson)"));
  plot->yAxis->setRange(0.3, rows + 0.9);
  plot->yAxis->setTicker(labels);
  style_plot(*plot);
  plot->yAxis->grid()->setVisible(false);
  plot->setFixedHeight(static_cast<int>(rows) * 26 + 88);
  return plot;
}

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

QString group_text(AnswerGroup group) {
  switch (group) {
    case AnswerGroup::people:
      return AnalysisPage::tr("people");
    case AnswerGroup::pilot:
      return AnalysisPage::tr("pilot sessions");
    case AnswerGroup::virtual_participants:
      return AnalysisPage::tr("virtual participants");
  }
  return {};
}

QString people_text(int count) {
  return count == 1 ? AnalysisPage::tr("1 participant")
                    : AnalysisPage::tr("%n participants", nullptr, count);
}

QString answers_text(int count) {
  return count == 1 ? AnalysisPage::tr("1 answer") : AnalysisPage::tr("%n answers", nullptr, count);
}

QString question_of(const AnalysisOutcome& outcome) {
  if (outcome.kind == "selection") {
    return AnalysisPage::tr("Which rendering was chosen as the most realistic?");
  }
  if (outcome.kind == "matching") {
    return AnalysisPage::tr("Were felt textures matched to their pictures?");
  }
  if (outcome.kind == "recognition") {
    return AnalysisPage::tr("Was the felt texture recognised among the pictures?");
  }
  return QString::fromStdString(outcome.kind);
}

QWidget* make_outcome(const AnalysisOutcome& outcome) {
  auto* page = new QWidget();
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(kMargin, 0, kMargin, kMargin);
  layout->setSpacing(kGrid);
  if (outcome.group != AnswerGroup::people) {
    auto* band = new ModeBand(page);
    band->set_mode(outcome.group == AnswerGroup::pilot ? SessionMode::pilot
                                                       : SessionMode::simulate);
    layout->addWidget(band);
  }
  layout->addWidget(make_title(question_of(outcome), page));
  for (const NamedTable& table : outcome.tables) {
    const QString sentence = sentence_of(table);
    if (sentence.isEmpty()) continue;
    QLabel* answer = make_heading(sentence, page);
    answer->setObjectName("answer");
    layout->addWidget(answer);
    break;
  }
  layout->addWidget(make_text(
      AnalysisPage::tr("%1 %2 · %3 · %4 counted")
          .arg(QString::fromStdString(outcome.protocol), QString::fromStdString(outcome.version),
               people_text(static_cast<int>(outcome.count.participants)),
               answers_text(static_cast<int>(outcome.answers))),
      page, true));
  for (const Phrase& remark : outcome.remarks) {
    auto* line = new StateLabel(page);
    line->set_state(State::look, words_of(remark));
    add_narrow(line, *layout);
  }
  bool has_figure = false;
  for (const NamedTable& table : outcome.tables) {
    layout->addSpacing(kMargin);
    layout->addWidget(make_heading(words_of(table.title), page));
    const auto shares = share_columns(table.table);
    if (shares && shares->low && !has_figure) {
      QVBoxLayout* inside = nullptr;
      QFrame* card = make_card(page, inside);
      card->setMaximumWidth(kTextWidth);
      inside->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
      inside->addWidget(make_forest(table.table, *shares, card));
      layout->addWidget(card);
      has_figure = true;
    }
    layout->addWidget(make_table(table, page));
    if (!table.note.empty()) {
      add_folded(AnalysisPage::tr("How it was computed"), words_of(table.note), *layout, page);
    }
  }
  layout->addStretch(1);
  return page;
}

}  // namespace

QString sentence_of(const NamedTable& table) {
  const auto columns = share_columns(table.table);
  if (!columns || !columns->low || table.table.rows.empty()) return {};
  // Rows over everything come last. Where the shares are of different things, the greatest speaks.
  std::vector<Cell> row{};
  QString what{};
  for (const std::vector<Cell>& candidate : table.table.rows) {
    QStringList words{};
    bool is_part = false;
    for (std::size_t i = 0; i < columns->keys; ++i) {
      const std::string& name = table.table.columns[i];
      const auto* word = std::get_if<std::string>(&candidate[i]);
      if (word != nullptr && (*word == "all" || *word == "Total")) continue;
      if (name == "column" || name == "person") is_part = true;
      words << text_of(name, candidate[i]);
    }
    const auto share = number_of(candidate[columns->share]);
    if (is_part || !share) continue;
    if (row.empty() || *share >= number_of(row[columns->share]).value_or(0.0)) {
      row = candidate;
      what = words.isEmpty() ? AnalysisPage::tr("In all") : words.join(" ");
    }
  }
  if (row.empty()) return {};
  const QString numbers = AnalysisPage::tr("%1 of %2 (%3; 95 % interval %4 to %5)")
                              .arg(text_of({}, row[columns->hits]), text_of({}, row[columns->of]),
                                   percent(row[columns->share]), percent(row[*columns->low]),
                                   percent(row[*columns->low + 1]));
  const QString chance = columns->chance ? percent(row[*columns->chance]) : QString();
  if (chance.isEmpty()) return AnalysisPage::tr("%1: %2.").arg(what, numbers);
  return AnalysisPage::tr("%1: %2, where chance is %3.").arg(what, numbers, chance);
}

AnalysisPage::AnalysisPage(OpenStudy& study, QWidget* parent) : QWidget(parent), study_(study) {
  setObjectName("analysis_page");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  layout->setSpacing(kMargin);
  auto* header = new QHBoxLayout();
  header->addWidget(make_title(tr("Analysis"), this), 1);
  export_ = make_button(tr("Export the tables…"), ButtonRole::plain, this);
  export_->setObjectName("export_tables");
  header->addWidget(export_);
  layout->addLayout(header);
  banner_ = new Banner(this);
  layout->addWidget(banner_);
  analysing_ = new TaskLine(analysis_, this);
  analysing_->setObjectName("analysing");
  analysing_->set_words(tr("Counting the answers…"));
  layout->addWidget(analysing_);
  writing_ = new TaskLine(exporting_, this);
  writing_->setObjectName("exporting");
  layout->addWidget(writing_);
  stack_ = new QStackedWidget(this);
  layout->addWidget(stack_, 1);
  stack_->addWidget(
      new EmptyState(tr("No answers yet"),
                     tr("When a session has been run or simulated, its answers are "
                        "counted and tested here. Start one from the page Protocols."),
                     stack_));
  auto* both = new QWidget(stack_);
  auto* columns = new QHBoxLayout(both);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(kMargin);
  list_ = new QListWidget(both);
  list_->setObjectName("outcomes");
  list_->setFixedWidth(280);
  list_->setWordWrap(true);
  area_ = new QScrollArea(both);
  area_->setWidgetResizable(true);
  columns->addWidget(list_);
  columns->addWidget(area_, 1);
  stack_->addWidget(both);
  connect(list_, &QListWidget::currentRowChanged, this, &AnalysisPage::show_outcome);
  connect(export_, &QPushButton::clicked, this, &AnalysisPage::ask_where_to_export);
  connect(analysing_, &TaskLine::cancelWanted, this, [this] {
    analysis_.abandon();
    banner_->show_news(State::look,
                       tr("The answers were not counted; what is shown is from before."),
                       tr("Count again"), [this] { refresh(); });
  });
  connect(writing_, &TaskLine::cancelWanted, &exporting_, &BackgroundTask::cancel);
  connect(&exporting_, &BackgroundTask::started, this, &AnalysisPage::show_whether_exportable);
  connect(&exporting_, &BackgroundTask::finished, this, &AnalysisPage::show_whether_exportable);
  connect(&study_, &OpenStudy::changed, this, [this] {
    outdated_ = true;
    if (isVisible()) refresh();
  });
}

void AnalysisPage::choose(const std::string& protocol) {
  wanted_ = protocol;
  select_wanted();
}

void AnalysisPage::select_wanted() {
  for (std::size_t i = 0; i < outcomes_.size() && !wanted_.empty(); ++i) {
    if (outcomes_[i].protocol == wanted_) list_->setCurrentRow(static_cast<int>(i));
  }
}

void AnalysisPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (outdated_) refresh();
}

void AnalysisPage::refresh() {
  outdated_ = false;
  analysis_.run<Analysis>(
      [folder = study_.folder()](const std::stop_token& stop, const BackgroundTask::Progress&) {
        const Study study = Study::open(folder, Access::read_only);
        Analysis analysis{analyze_study(study, {}, stop), {}};
        for (const SessionRow& session : study.sessions()) {
          if (!is_blind(study, session)) continue;
          analysis.running.insert(study.protocol(session.protocol_id).name);
        }
        return analysis;
      },
      [this](Analysis analysis) { show_analysis(std::move(analysis)); },
      [this](const QString& what) {
        banner_->show_news(State::stop, what, tr("Try again"), [this] { refresh(); });
      });
}

void AnalysisPage::show_analysis(Analysis analysis) {
  const int shown = std::max(0, list_->currentRow());
  outcomes_ = std::move(analysis.outcomes);
  running_ = std::move(analysis.running);
  list_->clear();
  for (const AnalysisOutcome& outcome : outcomes_) {
    list_->addItem(tr("%1 %2\n%3 · %4")
                       .arg(QString::fromStdString(outcome.protocol),
                            QString::fromStdString(outcome.version), group_text(outcome.group),
                            answers_text(static_cast<int>(outcome.answers))));
  }
  stack_->setCurrentIndex(outcomes_.empty() ? 0 : 1);
  show_whether_exportable();
  list_->setCurrentRow(std::min(shown, list_->count() - 1));
  select_wanted();
  wanted_.clear();
  emit refreshed();
}

void AnalysisPage::show_whether_exportable() {
  export_->setEnabled(!outcomes_.empty() && !exporting_.is_running());
  export_->setToolTip(outcomes_.empty()         ? tr("There are no sessions to export yet.")
                      : exporting_.is_running() ? tr("The tables are being written.")
                                                : QString());
}

void AnalysisPage::show_outcome(int index) {
  if (index < 0) return;
  const AnalysisOutcome& outcome = outcomes_.at(static_cast<std::size_t>(index));
  if (outcome.group == AnswerGroup::people && running_.contains(outcome.protocol)) {
    area_->setWidget(new EmptyState(
        tr("Blind while a session runs"),
        tr("A session of %1 is running. Its counts by name are shown when it is over.")
            .arg(QString::fromStdString(outcome.protocol))));
    return;
  }
  area_->setWidget(make_outcome(outcome));
}

void AnalysisPage::ask_where_to_export() {
  auto* dialog = new QFileDialog(this, tr("A new folder for the tables"));
  dialog->setObjectName("export_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  dialog->selectFile("tables");
  auto* for_public = new QCheckBox(tr("For the public: without dates and free text"), dialog);
  for_public->setObjectName("export_public");
  auto* recordings = new QCheckBox(tr("With the recordings, tick by tick; they are large"), dialog);
  recordings->setObjectName("export_recordings");
  if (auto* grid = qobject_cast<QGridLayout*>(dialog->layout())) {
    for (QCheckBox* const option : {for_public, recordings}) {
      grid->addWidget(option, grid->rowCount(), 0, 1, grid->columnCount());
    }
  }
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, for_public, recordings](const QString& folder) {
            ExportOptions options{};
            if (for_public->isChecked()) options.audience = ExportAudience::published;
            if (recordings->isChecked()) options.formats.insert(ExportFormat::physio);
            export_to(folder, options);
          });
  dialog->open();
}

void AnalysisPage::export_to(const QString& folder, const ExportOptions& options) {
  writing_->set_words(tr("Writing the tables to %1 …").arg(folder));
  exporting_.run<std::size_t>(
      [study = study_.folder(), to = std::filesystem::path(folder.toStdString()), options](
          const std::stop_token& stop, const BackgroundTask::Progress& progress) {
        return export_study(Study::open(study, Access::read_only), built_in_models(), to, options,
                            stop, progress)
            .size();
      },
      [this, folder](std::size_t files) {
        if (files == 0) {
          banner_->show_news(State::look,
                             tr("The tables were not written: you cancelled it. Nothing of them is "
                                "left in %1.")
                                 .arg(folder));
          return;
        }
        banner_->show_news(State::fine,
                           tr("%n files are in %1; codebook.tsv says what every column means.",
                              nullptr, static_cast<int>(files))
                               .arg(folder));
      },
      [this](const QString& what) { banner_->show_news(State::stop, what); });
}

}  // namespace asperity
