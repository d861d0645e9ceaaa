// The statement that a participant agrees to.

#pragma once

#include <string>
#include <vector>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;

namespace asperity {

class ConsentCard final : public QWidget {
  Q_OBJECT
 public:
  explicit ConsentCard(QWidget* parent = nullptr);

  /// Nobody has agreed to it yet, unless the statement is the one that is shown already.
  void set_statement(const QString& statement, const QString& version);
  /// Somebody else is to agree.
  void forget();
  void fill_in(bool has_consented, const std::string& seen_by);
  bool is_given() const;
  std::string seen_by() const;
  /// What is missing, a sentence each.
  std::vector<QString> complaints() const;

 signals:
  void changed();

 private:
  void show_time();

  QLabel* statement_ = nullptr;
  QCheckBox* given_ = nullptr;
  QLineEdit* seen_by_ = nullptr;
  QLabel* when_ = nullptr;
};

}  // namespace asperity
