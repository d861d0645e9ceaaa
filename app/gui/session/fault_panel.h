// After a stop: what was zeroed and when, and what clears it.

#pragma once

#include <QtWidgets/QFrame>

class QBoxLayout;
class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace asperity {

/// The way on is open only after the person has said that it is safe. In a narrow window it stands
/// under the words.
class FaultPanel final : public QFrame {
  Q_OBJECT
 public:
  explicit FaultPanel(QWidget* parent = nullptr);
  /// `can_clear`: going on is possible at all.
  void show_fault(const QString& what, bool can_clear);
  QString text() const;

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 signals:
  void clear_wanted();
  void end_wanted();

 private:
  void restyle();
  void arrange(bool narrow);

  bool narrow_ = false;
  QGridLayout* grid_ = nullptr;
  QBoxLayout* ways_ = nullptr;
  QLabel* shape_ = nullptr;
  QLabel* text_ = nullptr;
  QCheckBox* safe_ = nullptr;
  QPushButton* clear_ = nullptr;
  QLabel* why_ = nullptr;
};

}  // namespace asperity
