// The group of a participant, where the experimenter assigns it.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QtWidgets/QWidget>

class QComboBox;

namespace asperity {

class GroupChooser final : public QWidget {
  Q_OBJECT
 public:
  explicit GroupChooser(QWidget* parent = nullptr);

  /// The groups to choose from; without any there is nothing to choose, and nothing is shown. The
  /// chosen group stays chosen if it is among them.
  void set_groups(const std::vector<std::string>& groups);
  void choose(const std::optional<std::string>& group);
  /// Nothing where there is nothing to choose, or nothing is chosen.
  std::optional<std::string> group() const;
  bool is_missing() const;

 signals:
  void changed();

 private:
  QComboBox* groups_ = nullptr;
};

}  // namespace asperity
