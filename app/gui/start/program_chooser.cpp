// Takes the file and its arguments, and shows the complaint about a program that cannot be used.

#include "app/gui/start/program_chooser.h"

#include <utility>

#include <QtCore/QProcess>
#include <QtCore/QStringList>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"

namespace asperity {

ProgramChooser::ProgramChooser(QWidget* parent) : QWidget(parent) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* layout = nullptr;
  outer->addWidget(make_card(this, layout));
  layout->addWidget(make_heading(tr("External program"), this));
  layout->addWidget(make_text(
      tr("A program of the laboratory states the levels of this protocol. Choose the program."),
      this, true));
  auto* file_row = new QHBoxLayout();
  file_row->setSpacing(kMargin);
  QLabel* file_label = make_text(tr("Program *"), this);
  file_label->setWordWrap(false);
  file_ = new QLineEdit(this);
  file_->setObjectName("external_program");
  file_label->setBuddy(file_);
  auto* browse = make_button(tr("Browse…"), ButtonRole::plain, this);
  browse->setObjectName("external_program_browse");
  browse->setAccessibleName(tr("Browse for the external program"));
  file_row->addWidget(file_label);
  file_row->addWidget(file_, 1);
  file_row->addWidget(browse);
  layout->addLayout(file_row);
  auto* argument_row = new QHBoxLayout();
  argument_row->setSpacing(kMargin);
  QLabel* argument_label = make_text(tr("Arguments"), this);
  argument_label->setWordWrap(false);
  arguments_ = new QLineEdit(this);
  arguments_->setObjectName("external_program_arguments");
  arguments_->setToolTip(
      tr("Separated by spaces; an argument that contains spaces is in quotation marks."));
  argument_label->setBuddy(arguments_);
  argument_row->addWidget(argument_label);
  argument_row->addWidget(arguments_, 1);
  layout->addLayout(argument_row);
  state_ = new StateLabel(this);
  state_->setObjectName("external_program_state");
  layout->addWidget(state_);
  connect(browse, &QPushButton::clicked, this, &ProgramChooser::choose_file);
  for (QLineEdit* const field : {file_, arguments_}) {
    connect(field, &QLineEdit::textChanged, this, [this] {
      show_complaint();
      emit changed();
    });
  }
  hide();
}

void ProgramChooser::set_protocol(std::shared_ptr<const Protocol> protocol) {
  protocol_ = std::move(protocol);
  is_needed_ = protocol_ != nullptr && !blocks_of_external_program(*protocol_).empty();
  setVisible(is_needed_);
  show_complaint();
}

void ProgramChooser::choose(const std::optional<ExternalProgram>& program) {
  file_->setText(program ? text_of_path(program->file) : QString());
  QStringList arguments{};
  for (const std::string& argument : program ? program->arguments : std::vector<std::string>{}) {
    QString one = QString::fromStdString(argument);
    one.replace('"', R"(""")");
    arguments << (one.contains(' ') || one.isEmpty() ? '"' + one + '"' : one);
  }
  arguments_->setText(arguments.join(' '));
}

std::optional<ExternalProgram> ProgramChooser::typed() const {
  if (file_->text().trimmed().isEmpty()) return std::nullopt;
  ExternalProgram program{.file = path_of_text(file_->text().trimmed())};
  for (const QString& argument : QProcess::splitCommand(arguments_->text())) {
    program.arguments.push_back(argument.toStdString());
  }
  return program;
}

std::optional<ExternalProgram> ProgramChooser::program() const {
  return is_needed_ ? typed() : std::nullopt;
}

QString ProgramChooser::complaint() const {
  if (!is_needed_) return {};
  if (!typed()) return tr("No external program is chosen; choose the one that states the levels.");
  const auto complaint = complaint_about_program(*protocol_, typed());
  return complaint ? words_of(complaint->as_sentence()) : QString();
}

void ProgramChooser::choose_file() {
  auto* dialog = new QFileDialog(this, tr("Choose the external program"));
  dialog->setObjectName("external_program_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& file) { file_->setText(text_of_path(file.toStdString())); });
  dialog->open();
}

void ProgramChooser::show_complaint() {
  const QString wrong = complaint();
  state_->setVisible(!wrong.isEmpty() && typed().has_value());
  state_->set_state(State::stop, wrong);
}

}  // namespace asperity

#include "moc_program_chooser.cpp"
