// The precision and the power to expect of a protocol, from studies that are simulated in the background.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QtCore/QPointer>
#include <QtCore/QTimer>
#include <QtWidgets/QWidget>

#include "app/gui/base/commands_button.h"
#include "app/gui/base/open_study.h"
#include "app/gui/look/background_task.h"
#include "app/power/assumption.h"
#include "app/power/curve/precision.h"
#include "protocols/design/protocol.h"

class QLabel;
class QScrollArea;
class QSpinBox;

namespace asperity {

class AssumptionFields;
class StateLabel;
class StudyTable;

/// The numbers of `asperity power` for one number of participants, with the seed 1 and up to 1000 studies. The figures are those of the
/// studies so far: the first ones follow after a second, and further studies refine them.
///
/// Studies are simulated only while the view is shown, the text is unchanged, every assumption has a value and the device is not in use.
/// What is stated here is kept for each protocol file while the study is open; it is not a part of the protocol.
class PrecisionView final : public QWidget {
  Q_OBJECT
 public:
  static constexpr std::int64_t kStudies = 1000;
  static constexpr std::uint64_t kSeed = 1;

  explicit PrecisionView(OpenStudy& study, QWidget* parent = nullptr);
  ~PrecisionView() override;

  /// A protocol without problems, as the text of the file is now. The same text as before continues its studies; those of
  /// another text begin after a moment without another one.
  void show_protocol(const std::filesystem::path& file, std::shared_ptr<const Protocol> protocol);
  /// The text has changed: no study is simulated until `show_protocol`.
  void hold_for_new_text();
  std::int64_t studies() const noexcept { return studies_ ? studies_->studies() : 0; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  /// What the user stated of one protocol file.
  struct Inputs {
    int participants = 0;  ///< 0: the usual number
    std::map<std::string, double> stated{};
  };
  struct Design;

  void read_design();
  void show_design(const Design& design);
  void take_inputs();
  void restart();
  /// Simulates until all studies are there, or states why not.
  void proceed();
  /// What keeps studies from being simulated, with its remedy; empty if nothing does.
  QString blocker() const;
  void show_state();
  void show_results();
  std::vector<ShownCommand> commands() const;
  std::vector<Assumption> assumptions() const;
  Inputs& inputs() { return inputs_[file_.string()]; }

  OpenStudy& study_;
  QPointer<OpenStudy> left_to_{};
  std::filesystem::path file_{};
  std::shared_ptr<const Protocol> protocol_{};
  std::vector<Assumption> usual_{};  ///< of the protocol
  QString refusal_{};                ///< why its studies cannot be simulated
  bool is_read_ = false;             ///< `usual_` and `refusal_` are those of the protocol
  bool has_new_text_ = false;
  std::map<std::string, Inputs> inputs_{};  ///< by file
  std::shared_ptr<const PrecisionStudies> studies_{};
  std::vector<PrecisionOf> results_{};  ///< of the studies
  QString failure_{};
  QSpinBox* participants_ = nullptr;
  QLabel* round_ = nullptr;
  StateLabel* state_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  AssumptionFields* fields_ = nullptr;
  StudyTable* table_ = nullptr;
  QTimer pause_{};
  BackgroundTask reading_{};
  BackgroundTask simulation_{};
};

}  // namespace asperity
