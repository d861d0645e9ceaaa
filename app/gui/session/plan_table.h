// The plan of a session as a table: what was, what is under way, what comes.

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QtCore/QAbstractTableModel>
#include <QtCore/QStringList>
#include <QtWidgets/QWidget>

#include "app/gui/session/session_text.h"
#include "app/session/session_monitor.h"

class QLabel;
class QPushButton;
class QTableView;

namespace asperity {

/// One row per trial, and one before each block. Columns: trial, condition, outcome.
class PlanModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  explicit PlanModel(QObject* parent);

  void set_facts(std::shared_ptr<const SessionFacts> facts);
  /// Codes stand for the conditions; otherwise their names.
  void set_blind(bool blind);
  /// False where they are those that it has.
  bool set_attempts(std::shared_ptr<const std::vector<AttemptSummary>> attempts);
  /// `trial` is under way or comes (0: none does), and this is what happens in it.
  void set_now(int trial, const QString& phase);
  /// Whether the row's outcome states its reason: why it is flagged or was not explored as instructed.
  bool explains(int row) const;

  /// Of one surface of a trial (position from 1): its code or its name; empty where there is none.
  QString condition(int trial, int surface) const;
  int row_of(int trial) const;
  bool is_heading(int row) const;
  /// Who saw the name of a stimulus is told about right and wrong as well. While blind that is
  /// shown only where the participant is told too, and so the mirror shows it.
  bool tells_right(const AttemptSummary& attempt) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    const Trial* trial = nullptr;  ///< null: the heading of a block
    QString block{};
    QString code{};
    QString name{};
    QStringList surface_codes{};
    QStringList surface_names{};
    int attempts = 0;
    QString outcome{};  ///< of the last attempt
    QString history{};  ///< of all, the last one first
    QString reason{};   ///< why the last attempt does not count or is flagged
    bool is_of_hand =
        false;  ///< the reason is one that the experimenter can explain to the participant
    State state = State::unknown;
  };
  void write_outcomes();
  static bool explains(const Row& row) { return row.is_of_hand && !row.reason.isEmpty(); }
  QString text_of(const Row& row, int column) const;

  std::shared_ptr<const SessionFacts> facts_{};
  std::shared_ptr<const Protocol> codes_of_{};
  std::optional<BlindCodes> codes_{};  ///< of the session of `codes_of_`
  std::shared_ptr<const std::vector<AttemptSummary>> attempts_{};
  std::vector<Row> rows_{};
  std::vector<int> row_of_trial_{};
  NameVeil veil_{};
  bool blind_ = true;
  int now_ = 0;
  QString phase_{};
};

/// The table; keeps the trial under way in sight until the person scrolls, and again once asked to.
class PlanTable final : public QWidget {
  Q_OBJECT
 public:
  explicit PlanTable(QWidget* parent = nullptr);
  PlanModel& model() noexcept { return *model_; }
  void set_facts(std::shared_ptr<const SessionFacts> facts);
  void set_attempts(std::shared_ptr<const std::vector<AttemptSummary>> attempts);
  void set_now(int trial, const QString& phase);
  void set_blind(bool blind);
  bool is_following() const noexcept { return following_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  void let_go();
  void fit_columns();
  void fit_row(int row);  ///< to the lines that its texts need

  PlanModel* model_ = nullptr;
  QTableView* view_ = nullptr;
  QPushButton* follow_button_ = nullptr;
  int now_ = 0;
  bool following_ = true;
};

}  // namespace asperity
