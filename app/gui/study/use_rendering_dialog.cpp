// Computes the text of the protocol in the background whenever a choice changes, and shows what differs.

#include "app/gui/study/use_rendering_dialog.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QGridLayout>
#include <nlohmann/json.hpp>

#include "app/gui/base/command_lines.h"
#include "app/gui/base/form_words.h"
#include "app/gui/base/open_study.h"
#include "app/gui/base/settings.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/dialog_buttons.h"
#include "app/gui/look/words.h"
#include "app/gui/study/template_dialog.h"
#include "app/study_files/protocol_languages.h"
#include "app/tasks/protocol_templates.h"
#include "app/words/phrase_of_error.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

namespace {

constexpr QSize kUseSize{880, 600};

}  // namespace

struct UseRenderingDialog::Result {
  std::filesystem::path protocol{};
  RenderingUseInputs choice{};
  RenderingUse use{};
};

UseRenderingDialog::UseRenderingDialog(OpenStudy& study,
                                       std::vector<std::filesystem::path> renderings,
                                       UnsavedText unsaved, QWidget* parent)
    : QDialog(parent),
      study_(study),
      renderings_(std::move(renderings)),
      unsaved_(std::move(unsaved)) {
  setObjectName("use_rendering_dialog");
  setWindowTitle(tr("Use a rendering in an experiment"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(parent == nullptr ? kUseSize : kUseSize.boundedTo(parent->window()->size()));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  layout->addWidget(make_heading(tr("Use a rendering in an experiment"), this));
  layout->addWidget(make_text(
      tr("The values are copied: the protocol does not depend on the rendering."), this, true));
  auto* choices = new QGridLayout();
  choices->setSpacing(kGrid);
  choices->setColumnStretch(1, 1);
  int row = 0;
  const auto add = [&](const QString& caption, const char* name) {
    auto* box = new ChoiceBox(this);
    box->setObjectName(name);
    QLabel* label = make_text(caption, this);
    label->setBuddy(box);
    choices->addWidget(label, row, 0);
    choices->addWidget(box, row++, 1);
    return box;
  };
  rendering_ = add(tr("Rendering"), "use_rendering");
  for (const std::filesystem::path& file : renderings_) {
    rendering_->addItem(text(rendering_name(file)));
  }
  protocol_ = add(tr("Experiment"), "use_protocol");
  QPushButton* from_template = make_button(tr("New from a template…"), ButtonRole::plain, this);
  from_template->setObjectName("use_template");
  choices->addWidget(from_template, row - 1, 2);
  surface_ = add(tr("Surface"), "use_surface");
  keeps_texture_ = new QCheckBox(this);
  keeps_texture_->setObjectName("use_keeps_texture");
  choices->addWidget(keeps_texture_, row++, 1);
  layout->addLayout(choices);
  remarks_ = make_text({}, this);
  remarks_->setObjectName("use_remarks");
  remarks_->hide();
  layout->addWidget(remarks_);
  changes_ = new StudyTable({{tr("Changes"), 0, StudyTable::Align::text},
                             {tr("Before"), 184, StudyTable::Align::text},
                             {tr("After"), 184, StudyTable::Align::text}},
                            this);
  changes_->setObjectName("use_changes");
  changes_->setAccessibleName(tr("Changes"));
  changes_->wrap_texts();
  changes_->setSortingEnabled(false);
  layout->addWidget(changes_, 1);
  state_ = new StateLabel(this);
  state_->setObjectName("use_state");
  state_->setWordWrap(true);
  layout->addWidget(state_);
  use_ = make_button(tr("Change in the editor"), ButtonRole::primary, this);
  use_->setObjectName("use_change");
  use_->setToolTip(
      tr("The editor shows the changed protocol. It is stored when you save it there."));
  use_->setDefault(true);
  commands_ = make_commands_button([this] { return commands(); }, this);
  set_usable(false);
  add_dialog_buttons(*this, *layout, use_, {commands_});
  connect(rendering_, &QComboBox::currentIndexChanged, this, &UseRenderingDialog::show_changes);
  connect(protocol_, &QComboBox::currentIndexChanged, this, &UseRenderingDialog::fill_surfaces);
  connect(surface_, &QComboBox::currentIndexChanged, this, &UseRenderingDialog::choose_surface);
  connect(keeps_texture_, &QCheckBox::toggled, this, &UseRenderingDialog::show_changes);
  connect(from_template, &QPushButton::clicked, this, &UseRenderingDialog::choose_template);
  connect(use_, &QPushButton::clicked, this, [this] {
    const std::shared_ptr<const Result> result = result_;
    emit wanted(result->protocol, result->choice.protocol, result->use.after,
                text(rendering_name(result->choice.rendering)));
    accept();
  });
  read_protocols({});
}

std::filesystem::path UseRenderingDialog::protocol() const {
  const int index = protocol_->currentIndex();
  return index < 0 ? std::filesystem::path() : protocols_[static_cast<std::size_t>(index)];
}

void UseRenderingDialog::read_protocols(const std::filesystem::path& chosen) {
  {
    const QSignalBlocker quiet(protocol_);
    protocol_->clear();
    protocols_ = protocol_files(study_.folder());
    for (const std::filesystem::path& file : protocols_) protocol_->addItem(path_text(file.stem()));
    const auto found = std::find(protocols_.begin(), protocols_.end(), chosen);
    if (found != protocols_.end()) {
      protocol_->setCurrentIndex(static_cast<int>(found - protocols_.begin()));
    }
  }
  fill_surfaces();
}

void UseRenderingDialog::choose_template() {
  auto* dialog = new TemplateDialog(study_.folder(), study_.models(), this);
  connect(dialog, &TemplateDialog::wanted, this, [this](const TemplateChoice& choice) {
    task_.run<std::filesystem::path>(
        [choice, folder = study_.folder()](const std::stop_token&,
                                           const BackgroundTask::Progress&) {
          return protocol_from_template(folder, choice);
        },
        [this](const std::filesystem::path& file) {
          study_.announce_change();
          read_protocols(file);
        },
        [this](const QString& what) {
          state_->set_state(State::stop, tr("The protocol could not be created: %1").arg(what));
        });
  });
  dialog->open();
}

void UseRenderingDialog::fill_surfaces() {
  {
    const QSignalBlocker quiet(surface_);
    surface_->clear();
    usable_.clear();
    before_.clear();
    const std::filesystem::path file = protocol();
    if (!file.empty()) {
      try {
        before_ = unsaved_(file).value_or(std::string());
        if (before_.empty()) before_ = read_file(file, kProtocolFile);
      } catch (const std::exception& error) {
        state_->set_state(State::stop, words_of(phrase_of(error)));
      }
      usable_ = usable_surfaces(before_);
      for (const UsableSurface& usable : usable_) {
        surface_->addItem(tr("Replace “%1”").arg(text(usable.name)));
      }
      surface_->addItem(tr("Add a surface"));
    }
  }
  choose_surface();
}

void UseRenderingDialog::choose_surface() {
  const auto index = static_cast<std::size_t>(std::max(surface_->currentIndex(), 0));
  const bool has_texture = index < usable_.size() && usable_[index].has_texture;
  const QSignalBlocker quiet(keeps_texture_);
  keeps_texture_->setVisible(has_texture);
  keeps_texture_->setChecked(false);
  if (has_texture) {
    const std::optional<std::string>& factor = usable_[index].texture_factor;
    keeps_texture_->setText(factor ? tr("Keep its textures, the levels of “%1”").arg(text(*factor))
                                   : tr("Keep its texture"));
    keeps_texture_->setChecked(factor.has_value());  // what the experiment compares
  }
  show_changes();
}

void UseRenderingDialog::set_usable(bool is_usable) {
  for (QPushButton* const button : {commands_, use_}) button->setEnabled(is_usable);
}

std::vector<ShownCommand> UseRenderingDialog::commands() const {
  const RenderingUseInputs& choice = result_->choice;
  return {{.action = tr("Change the protocol's file"),
           .line = use_rendering_line(choice.rendering, result_->protocol, choice.place,
                                      plugin_files()),
           .remark = tr("The file is stored at once, without unsaved changes of the editor.")}};
}

void UseRenderingDialog::show_changes() {
  const auto index = static_cast<std::size_t>(std::max(surface_->currentIndex(), 0));
  const bool replaces = index < usable_.size();
  const std::uint64_t number = ++shown_;
  result_.reset();
  set_usable(false);
  remarks_->hide();
  changes_->fill({});
  if (before_.empty()) {
    state_->set_state(State::look,
                      protocols_.empty()
                          ? tr("The study has no protocol yet. Create one from a template.")
                          : tr("This protocol cannot be read. Choose another one."));
    return;
  }
  if (!study_.can_be_written()) {
    state_->set_state(State::stop,
                      tr("This study is read-only; copy it to a folder that you may write to."));
    return;
  }
  state_->set_state(State::unknown, tr("Checking…"));
  RenderingUseInputs choice{
      .study = study_.folder(),
      .rendering = renderings_[static_cast<std::size_t>(rendering_->currentIndex())],
      .protocol = before_};
  if (replaces) choice.place.replaced = usable_[index].name;
  choice.place.keeps_texture = replaces && keeps_texture_->isChecked();
  work_.ask(
      [this, number, file = protocol(), choice,
       &models = study_.models()]() -> NewestWork::Delivery {
        const auto result =
            std::make_shared<const Result>(Result{file, choice, use_of_rendering(choice, models)});
        return [this, number, result] {
          if (number == shown_) take(result);  // otherwise another choice is being computed
        };
      },
      [this, number](const QString& what) {
        if (number == shown_) state_->set_state(State::stop, what);
      });
}

void UseRenderingDialog::take(const std::shared_ptr<const Result>& result) {
  const RenderingUse& use = result->use;
  const auto before = nlohmann::json::parse(result->choice.protocol, nullptr, false);
  const auto after = nlohmann::json::parse(use.after, nullptr, false);
  QStringList remarks{};
  for (const auto* const sentences : {&use.remarks.problems, &use.remarks.warnings}) {
    for (const Phrase& sentence : *sentences) remarks << "▲ " + words_of(sentence);
  }
  for (const Diagnostic& warning : use.warnings) {
    remarks << "▲ " + remark_in_form(after, warning);
  }
  remarks_->setText(remarks.join('\n'));
  remarks_->setVisible(!remarks.isEmpty());
  std::vector<StudyTable::Row> rows{};
  const QString none = tr("none");
  for (const ChangedValue& change : use.changes) {
    rows.push_back(
        {text(change.pointer),
         {text_cell(place_in_form(change.after.empty() ? before : after, change.pointer)),
          text_cell(change.before.empty() ? none : text(change.before)),
          text_cell(change.after.empty() ? none : text(change.after))}});
  }
  changes_->fill(rows);
  if (!use.problems_before.empty()) {
    state_->set_state(State::stop, tr("The protocol has problems. Fix them in the editor first: %1")
                                       .arg(remark_in_form(before, use.problems_before.front())));
  } else if (!use.remarks.problems.empty()) {
    state_->set_state(State::stop, tr("This rendering cannot be used here."));
  } else if (!use.problems.empty()) {
    state_->set_state(
        State::stop,
        tr("The protocol would not be valid: %1").arg(remark_in_form(after, use.problems.front())));
  } else if (use.changes.empty()) {
    state_->set_state(State::look, tr("The surface already has these values."));
  } else {
    QString sentence = use.warnings.empty() ? tr("The changed protocol is valid.")
                                            : tr("The changed protocol is valid, with warnings.");
    if (!result->choice.place.replaced) {
      sentence += ' ' + tr("No block presents the new surface yet: choose it under Task in the "
                           "editor.");
    }
    state_->set_state(use.warnings.empty() ? State::fine : State::look, sentence);
    result_ = result;
    set_usable(true);
  }
}

}  // namespace asperity

#include "moc_use_rendering_dialog.cpp"
