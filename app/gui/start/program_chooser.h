// The external program that states the levels of a session, where the protocol takes its levels from one.

#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QtWidgets/QWidget>

#include "app/session/levels/external_program.h"

class QLineEdit;

namespace asperity {

class StateLabel;

/// A card with the program and its arguments. Shown only for a protocol that needs a program; it is chosen here anew
/// every time the program starts, and never read from a file or from the settings.
class ProgramChooser final : public QWidget {
  Q_OBJECT
 public:
  explicit ProgramChooser(QWidget* parent = nullptr);

  /// Null: no protocol.
  void set_protocol(std::shared_ptr<const Protocol> protocol);
  void choose(const std::optional<ExternalProgram>& program);
  /// Nothing where none is needed or chosen.
  std::optional<ExternalProgram> program() const;
  /// Why the session cannot take its levels from it; empty where it can.
  QString complaint() const;

 signals:
  void changed();

 private:
  std::optional<ExternalProgram> typed() const;
  void choose_file();
  void show_complaint();

  std::shared_ptr<const Protocol> protocol_{};
  bool is_needed_ = false;
  QLineEdit* file_ = nullptr;
  QLineEdit* arguments_ = nullptr;
  StateLabel* state_ = nullptr;
};

}  // namespace asperity
