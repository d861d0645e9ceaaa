// Joins the panels, and recomputes the preview in the background for the newest recipe only.

#include "app/gui/workbench/workbench_page.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QtCore/QEvent>
#include <QtCore/QMimeData>
#include <QtGui/QDragEnterEvent>
#include <QtGui/QDropEvent>
#include <QtGui/QFontMetrics>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QMenu>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QStackedWidget>

#include "app/gui/base/open_study.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/task_line.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"
#include "app/gui/workbench/force_comparison.h"
#include "app/gui/workbench/line_profile.h"
#include "app/gui/workbench/relief_view.h"
#include "app/gui/workbench/save_panel.h"
#include "app/gui/workbench/signal_plots.h"
#include "app/tasks/rendering_use.h"
#include "app/words/phrase_of_error.h"
#include "results_schema/files/folder_entries.h"

namespace asperity {

namespace {

constexpr int kPanelWidth = 392;

/// Its content has the size of the area, and scrolls where it needs more. An area that adapts its content by itself would give it
/// the height that it prefers, because the content contains texts that wrap.
class AreaOfWorkspace final : public QScrollArea {
 public:
  AreaOfWorkspace(QWidget* inside, QWidget* parent) : QScrollArea(parent) {
    setObjectName("workspace");
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    viewport()->setAutoFillBackground(false);
    setWidget(inside);
    inside->setAutoFillBackground(false);  // setWidget turns it on
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QScrollArea::resizeEvent(event);
    fit();
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) fit();
    return QScrollArea::eventFilter(watched, event);
  }

 private:
  void fit() {
    const QSize least = widget()->minimumSizeHint();
    QSize room = maximumViewportSize();
    if (least.width() > room.width()) room.rheight() -= horizontalScrollBar()->sizeHint().height();
    if (least.height() > room.height()) room.rwidth() -= verticalScrollBar()->sizeHint().width();
    widget()->resize(room.expandedTo(least));
  }
};

QScrollArea* scrolled(QWidget* inside, QWidget* parent) {
  auto* area = new QScrollArea(parent);
  area->setWidget(inside);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFrameShape(QFrame::NoFrame);
  return area;
}

}  // namespace

WorkbenchPage::WorkbenchPage(OpenStudy& study, QWidget* parent) : QWidget(parent), study_(study) {
  setObjectName("workbench");
  setAcceptDrops(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  layout->setSpacing(kGrid);
  layout->addLayout(make_head());
  banner_ = new Banner(this);
  banner_->setObjectName("banner");
  layout->addWidget(banner_);
  reading_ = new TaskLine(opening_, this);
  reading_->setObjectName("reading");
  layout->addWidget(reading_);
  pages_ = new QStackedWidget(this);
  pages_->addWidget(make_empty());
  pages_->addWidget(make_workspace());
  layout->addWidget(pages_, 1);

  connect(strip_, &StepStrip::stepChosen, this, &WorkbenchPage::choose_step);
  connect(reading_, &TaskLine::cancelWanted, this, [this] {
    opening_.abandon();
    banner_->show_news(State::look,
                       tr("Reading the file was cancelled; to read it, open it again."));
  });
  connect(recipe_, &RecipePanel::edited, this, &WorkbenchPage::recompute);
  connect(recipe_, &RecipePanel::edited, save_, &SavePanel::check);
  connect(save_, &SavePanel::saved, this, [this](const QString& name) {
    keep_unsaved(false);
    saved_as_ = "stimuli/" + name.toStdString() + ".png";
    renderings_->show_relief(name.toStdString());
  });
  connect(renderings_, &RenderingPanel::use_wanted, this, &WorkbenchPage::use_wanted);
  connect(comparison_, &ForceComparison::models_changed, renderings_, &RenderingPanel::check);
  connect(relief_, &ReliefView::pointed, this, [this](double, double y_m) {
    if (mode_->checkedId() == static_cast<int>(Mode::making)) show_line(y_m);
  });
  connect(relief_, &ReliefView::strokeBegan, comparison_, &ForceComparison::begin_stroke);
  connect(relief_, &ReliefView::strokeMoved, comparison_, &ForceComparison::aim_stroke);
  connect(relief_, &ReliefView::strokeEnded, comparison_, &ForceComparison::end_stroke);
  connect(comparison_, &ForceComparison::across_wanted, this,
          [this] { comparison_->stroke_across(0.0); });
  connect(comparison_, &ForceComparison::advanced, this, &WorkbenchPage::show_forces);
  set_mode(Mode::making);
}

WorkbenchPage::~WorkbenchPage() = default;

QWidget* WorkbenchPage::make_empty() {
  auto* empty = new EmptyState(
      tr("Drop a photograph of a surface here"),
      tr("It becomes a relief that can be felt: uneven light is corrected, long wavelengths are "
         "removed, "
         "and the remaining brightness is read as height. PNG, JPEG, TIFF, BMP and WebP are read. "
         "A picture in even light, taken from directly above, gives the best result."),
      pages_);
  empty->setObjectName("drop_area");
  empty->setAttribute(Qt::WA_StyledBackground);
  empty->setStyleSheet("#drop_area { border: 2px dashed palette(mid); border-radius: 8px; }");
  setFocusProxy(
      empty->add_action(tr("Open a photograph…"), ButtonRole::primary, [this] { choose_file(); }));
  return empty;
}

QLayout* WorkbenchPage::make_head() {
  auto* head = new WrappingRow(nullptr, kGrid);
  auto* modes = new QHBoxLayout();
  auto* sources = new QHBoxLayout();
  for (QHBoxLayout* const group : {modes, sources}) {
    group->setSpacing(kGrid);
    head->add_layout(group);
  }
  QLabel* title = make_title(tr("Workbench"), this);
  title->setWordWrap(false);
  modes->addWidget(title);
  modes->addSpacing(kMargin);
  mode_ = new QButtonGroup(this);
  const std::array<QString, 2> words{tr("Make a relief"), tr("Compare force models")};
  for (int i = 0; i < 2; ++i) {
    QPushButton* button =
        make_button(words[static_cast<std::size_t>(i)], ButtonRole::selector, this);
    button->setObjectName(i == 0 ? "mode_making" : "mode_comparing");
    // The chosen one is bold and needs its room before it is chosen.
    const QFontMetrics bold(text_font(TextSize::body, true));
    button->setMinimumWidth(bold.horizontalAdvance(button->text()) + 2 * kMargin);
    button->hide();  // until there is something to choose for
    mode_->addButton(button, i);
    modes->addWidget(button);
  }
  modes->addStretch(1);  // moves the sources to the other end of the row
  connect(mode_, &QButtonGroup::idClicked, this,
          [this](int id) { set_mode(static_cast<Mode>(id)); });
  auto* fields = make_button(tr("Relief of the study"), ButtonRole::plain, this);
  fields->setObjectName("open_height_field");
  auto* menu = new QMenu(fields);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill_study_menu(*menu); });
  fields->setMenu(menu);
  sources->addWidget(fields);
  QPushButton* open = make_button(tr("Open a photograph…"), ButtonRole::plain, this);
  open->setObjectName("open_photograph");
  connect(open, &QPushButton::clicked, this, &WorkbenchPage::choose_file);
  sources->addWidget(open);
  return head;
}

QWidget* WorkbenchPage::make_workspace() {
  auto* work = new QWidget(pages_);
  auto* layout = new QHBoxLayout(work);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kMargin);
  strip_ = new StepStrip(work);
  strip_->setObjectName("steps");
  layout->addWidget(strip_);

  auto* middle = new QVBoxLayout();
  middle->setSpacing(kGrid);
  finished_ = make_text({}, work);
  finished_->setObjectName("finished");
  finished_->hide();
  middle->addWidget(finished_);
  centre_ = new QStackedWidget(work);
  relief_ = new ReliefView(centre_);
  step_picture_ = new QLabel(centre_);
  step_picture_->setObjectName("step_picture");
  step_picture_->setAlignment(Qt::AlignCenter);
  step_picture_->setMinimumSize(1, 1);
  step_picture_->installEventFilter(this);
  centre_->addWidget(relief_);
  centre_->addWidget(step_picture_);
  middle->addWidget(centre_, 5);
  caption_ = make_text({}, work, true);
  caption_->setObjectName("caption");
  caption_->setFont(text_font(TextSize::small));
  middle->addWidget(caption_);
  plots_ = new QStackedWidget(work);
  profile_ = new SignalPlots({.heading = tr("Profile along the orange line"),
                              .x = tr("Position, mm"),
                              .y = tr("Height, µm")},
                             {.heading = tr("Spectrum of the profile"),
                              .x = tr("Spatial frequency, 1/mm"),
                              .y = tr("Power spectral density, µm² mm"),
                              .x_scale = PlotScale::logarithmic,
                              .y_scale = PlotScale::logarithmic},
                             plots_);
  profile_->setObjectName("profile");
  auto* felt = new QWidget(plots_);
  forces_ = new SignalPlots({.heading = tr("Force"), .x = tr("Time, s"), .y = tr("Force, N")},
                            {.heading = tr("Spectrum of the profile"),
                             .x = tr("Frequency, Hz"),
                             .y = tr("Power, N²/Hz"),
                             .y_scale = PlotScale::logarithmic},
                            felt);
  forces_->setObjectName("forces");
  roughness_ = new SignalPlot({.heading = tr("Predicted roughness"),
                               .x = tr("Time, s"),
                               .y = tr("RMS acceleration, m/s²"),
                               .names_are_large = true},
                              felt);
  roughness_->setObjectName("roughness");
  auto* row = new QHBoxLayout(felt);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kMargin);
  row->addWidget(forces_, 5);
  row->addWidget(roughness_, 2);
  plots_->addWidget(profile_);
  plots_->addWidget(felt);
  middle->addWidget(plots_, 3);
  layout->addLayout(middle, 1);

  side_ = new QStackedWidget(work);
  side_->setFixedWidth(kPanelWidth);
  auto* making = new QWidget(side_);
  auto* column = new QVBoxLayout(making);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid);
  recipe_ = new RecipePanel(making);
  save_ = new SavePanel(
      study_, *banner_, [this] { return recipe(); }, [this] { return recipe_->unready(); }, making);
  column->addWidget(recipe_, 1);
  column->addWidget(save_);
  side_->addWidget(making);
  comparison_ = new ForceComparison(study_.models(), side_);
  comparison_->setObjectName("comparison");
  auto* comparing = new QWidget(side_);
  auto* models = new QVBoxLayout(comparing);
  models->setContentsMargins(0, 0, 0, 0);
  models->setSpacing(kGrid);
  renderings_ = new RenderingPanel(
      study_, *banner_, [this] { return compared(); }, comparing);
  models->addWidget(scrolled(comparison_, comparing), 1);
  models->addWidget(renderings_);
  side_->addWidget(comparing);
  layout->addWidget(side_);
  return new AreaOfWorkspace(work, pages_);
}

void WorkbenchPage::set_mode(Mode mode) {
  const int id = static_cast<int>(mode);
  mode_->button(id)->setChecked(true);
  plots_->setCurrentIndex(id);
  side_->setCurrentIndex(id);
  choose_panels();
  const bool making = mode == Mode::making;
  relief_->set_mouse(making ? MouseMeans::turning : MouseMeans::stroking);
  relief_->set_line(making ? std::optional(line_y_m_) : std::nullopt);
  relief_->set_trail({});
  if (making) {
    relief_->set_dent({});
    dent_of_.clear();
  } else {
    strip_->choose(Step::relief);
    // Renderers are made for a relief that is looked at, not for every step towards it.
    comparison_->set_field(preview_.field);
    if (!std::exchange(has_sound_, true)) comparison_->set_sound(default_output());
  }
  choose_step(strip_->chosen());
  show_forces();
}

// A relief that comes from a file has neither steps nor a recipe: it has the room to itself.
void WorkbenchPage::choose_panels() {
  const bool finished = opened_ != nullptr && !opened_->is_photograph();
  const bool making = mode_->checkedId() == static_cast<int>(Mode::making);
  strip_->setVisible(!finished);
  side_->setVisible(!finished || !making);
  finished_->setVisible(finished && making);
}

void WorkbenchPage::fill_study_menu(QMenu& menu) {
  menu.clear();
  const std::filesystem::path folder = study_.folder() / "stimuli";
  std::vector<std::filesystem::path> files{};
  for (const auto& entry : entries_in(folder)) {
    if (is_height_field(entry.path())) files.push_back(entry.path());
  }
  for (const std::filesystem::path& file : files) {
    connect(menu.addAction(path_text(file.stem())), &QAction::triggered, this,
            [this, file] { open_file(file); });
  }
  if (files.empty()) menu.addAction(tr("This study has no relief yet"))->setEnabled(false);
}

void WorkbenchPage::choose_file() {
  auto* dialog = new QFileDialog(this, tr("Open a photograph of a surface"), {},
                                 tr("Photographs and measured surfaces (*.png *.jpg *.jpeg *.tif "
                                    "*.tiff *.bmp *.webp *.x3p *.sur *.gwy)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& file) { open_file(file.toStdString()); });
  dialog->open();
}

void WorkbenchPage::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.first().isLocalFile()) event->acceptProposedAction();
}

void WorkbenchPage::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  const QList<QUrl> urls = event->mimeData()->urls();
  const std::filesystem::path first = urls.first().toLocalFile().toStdString();
  QStringList remarks{};
  if (urls.size() > 1) {
    remarks << tr("%1 files were dropped; only the first is shown: %2.")
                   .arg(urls.size())
                   .arg(path_text(first.filename()));
  }
  read(first, remarks);
}

void WorkbenchPage::open_file(const std::filesystem::path& file) {
  is_rendering(file) ? open_rendering(file) : read(file, {});
}

void WorkbenchPage::open_rendering(const std::filesystem::path& file) {
  struct Loaded {
    Rendering rendering{};
    RenderingRemarks remarks{};
    std::shared_ptr<const OpenedPicture> opened{};
  };
  banner_->hide();
  reading_->set_words(tr("Reading %1 …").arg(path_text(file.filename())));
  opening_.run<std::shared_ptr<const Loaded>>(
      [file, recipe = recipe(), &models = study_.models(), folder = study_.folder()](
          const std::stop_token& stop, const BackgroundTask::Progress& progress) {
        auto loaded = std::make_shared<Loaded>();
        loaded->rendering = load_rendering(file);
        loaded->remarks = remarks_about(loaded->rendering, models, folder);
        if (loaded->remarks.problems.empty()) {
          loaded->opened =
              open_picture(folder / loaded->rendering.texture.height_field, recipe, stop, progress);
        }
        return loaded;
      },
      [this](const std::shared_ptr<const Loaded>& loaded) {
        QStringList sentences{};
        for (const auto* const some : {&loaded->remarks.problems, &loaded->remarks.warnings}) {
          for (const Phrase& sentence : *some) sentences << words_of(sentence);
        }
        if (loaded->opened == nullptr) {
          if (!sentences.isEmpty()) banner_->show_news(State::stop, sentences.join(' '));
          return;
        }
        take(loaded->opened, sentences);
        take_rendering(loaded->rendering);
      },
      [this](const QString& what) {
        banner_->show_news(State::stop, tr("The file could not be opened: %1").arg(what));
      });
}

void WorkbenchPage::take_rendering(const Rendering& rendering) {
  ForceComparison::Choices choices = comparison_->choices();
  for (auto& [model, is_chosen] : choices.chosen) is_chosen = model == rendering.model;
  choices.given[rendering.model] = rendering.parameters;
  choices.surface.given["stiffness_N_per_m"] = rendering.material.stiffness_N_per_m;
  choices.surface.given["friction"] = rendering.material.friction;
  choices.surface.given["body"] = std::string("plane");
  try {
    comparison_->choose(choices);
  } catch (const std::exception& error) {
    banner_->show_news(State::stop,
                       tr("The file could not be opened: %1").arg(words_of(phrase_of(error))));
  }
  set_mode(Mode::comparing);
}

void WorkbenchPage::read(const std::filesystem::path& file, const QStringList& remarks) {
  banner_->hide();
  reading_->set_words(tr("Reading %1 …").arg(path_text(file.filename())));
  opening_.run<std::shared_ptr<const OpenedPicture>>(
      [file, recipe = recipe()](const std::stop_token& stop,
                                const BackgroundTask::Progress& progress) {
        return open_picture(file, recipe, stop, progress);
      },
      [this, remarks](std::shared_ptr<const OpenedPicture> opened) {
        take(std::move(opened), remarks);
      },
      [this, remarks](const QString& what) {
        QStringList sentences = remarks;
        sentences << tr("The file could not be opened: %1").arg(what);
        banner_->show_news(State::stop, sentences.join(' '));
      });
}

void WorkbenchPage::take(std::shared_ptr<const OpenedPicture> opened, const QStringList& remarks) {
  opened_ = std::move(opened);
  saved_as_.clear();
  const QStringList all = remarks + opened_->remarks;
  all.isEmpty() ? banner_->hide() : banner_->show_news(State::look, all.join(' '));
  pages_->setCurrentIndex(1);
  for (QAbstractButton* button : mode_->buttons()) button->show();
  setFocusProxy(relief_);
  relief_->setFocus(Qt::OtherFocusReason);
  strip_->set_picture(Step::photograph, opened_->original);
  line_y_m_ = 0.0;
  if (opened_->is_photograph()) {
    recipe_->show_opened(*opened_);
  } else {
    const QString measured = tr(
        "<b>%1</b>: %2. This relief was measured; its least-squares plane was subtracted. Compare "
        "how the force models render it. To use it in the study, convert the file with “asperity "
        "texture”.");
    const QString of_study =
        tr("<b>%1</b>: %2. This relief comes from a file of the study and is finished. Compare how "
           "the force models render it, or open a photograph to make another relief.");
    finished_->setText((opened_->is_measured ? measured : of_study)
                           .arg(path_text(opened_->file.stem()).toHtmlEscaped(),
                                facts_of(*opened_->preview.field)));
  }
  choose_panels();
  save_->show_opened(opened_);
  renderings_->show_relief(opened_->file.stem().string());
  keep_unsaved(opened_->is_photograph());
  show_preview(opened_->preview);
  strip_->choose(Step::relief);
  choose_step(Step::relief);
  // The recipe may have been changed while the file was read.
  if (parameter_values(recipe()) != parameter_values(opened_->recipe)) recompute();
}

WorkbenchPage::Work WorkbenchPage::work() const {
  return {.opened = opened_,
          .recipe = recipe(),
          .stated = recipe_->stated(),
          .saved_as = saved_as_,
          .compares = mode_->checkedId() == static_cast<int>(Mode::comparing),
          .comparison = comparison_->choices()};
}

void WorkbenchPage::resume(const Work& work) {
  comparison_->choose(work.comparison);
  if (work.opened == nullptr) return;
  take(work.opened, {});
  banner_->hide();  // it was read when the file was opened
  if (work.opened->is_photograph()) {
    recipe_->show_recipe(work.recipe, work.stated);
    save_->check();
    recompute();
    keep_unsaved(false);
    saved_as_ = work.saved_as;
    renderings_->check();
  }
  if (work.compares) set_mode(Mode::comparing);
}

TextureRecipe WorkbenchPage::recipe() const { return recipe_->recipe(); }

void WorkbenchPage::recompute() {
  if (opened_ == nullptr || !opened_->is_photograph()) return;
  keep_unsaved(true);
  saved_as_.clear();
  renderings_->check();
  work_.ask(
      [this, opened = opened_, recipe = recipe(),
       dragging = recipe_->is_dragging()]() -> NewestWork::Delivery {
        auto preview = std::make_shared<TexturePreview>(
            (dragging ? opened->dragged : opened->resting)->under(recipe));
        return [this, opened, preview] {
          if (opened != opened_) return;  // another file has been opened meanwhile
          recipe_->show_refusal({});
          show_preview(std::move(*preview));
        };
      },
      [this](const QString& what) { recipe_->show_refusal(what); });
}

void WorkbenchPage::show_preview(TexturePreview preview) {
  preview_ = std::move(preview);
  const int first = kSteps - 1 - static_cast<int>(preview_.steps.size());
  for (int i = 1; i < kSteps - 1; ++i) {
    strip_->set_picture(static_cast<Step>(i),
                        i < first ? QImage() : preview_.steps[static_cast<std::size_t>(i - first)]);
  }
  strip_->set_picture(Step::relief, preview_.relief);
  relief_->show_relief(preview_.fine, preview_.coarse);
  if (mode_->checkedId() == static_cast<int>(Mode::comparing)) {
    comparison_->set_field(preview_.field);
  }
  save_->show_facts(*preview_.field);
  show_line(line_y_m_);
  choose_step(strip_->chosen());
}

void WorkbenchPage::choose_step(Step step) {
  const bool relief = step == Step::relief;
  centre_->setCurrentWidget(relief ? static_cast<QWidget*>(relief_) : step_picture_);
  if (preview_.field == nullptr) return;
  if (!relief) {
    const QImage& picture = strip_->picture(step);
    if (picture.isNull() || step_picture_->width() < 2) return;
    step_picture_->setPixmap(
        QPixmap::fromImage(picture.scaled(step_picture_->size() * devicePixelRatioF(),
                                          Qt::KeepAspectRatio, Qt::SmoothTransformation)));
    caption_->setText(meaning_of(step));
    return;
  }
  const bool making = mode_->checkedId() == static_cast<int>(Mode::making);
  const double times = preview_.fine->exaggeration;
  const QString height = times > 1.0 ? tr("Heights are exaggerated by a factor of %1.").arg(times)
                                     : tr("Heights are drawn to scale.");
  if (!dent_of_.isEmpty()) {
    caption_->setText(tr("%1 The dent is that of “%2”, with the same factor. Drag to stroke, right "
                         "button: light, arrow keys: turn.")
                          .arg(height, dent_of_));
    return;
  }
  caption_->setText(
      making ? tr("%1 Drag to turn, right button: light, wheel: zoom.").arg(height)
             : tr("%1 Drag to stroke, right button: light, arrow keys: turn.").arg(height));
}

bool WorkbenchPage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == step_picture_ && event->type() == QEvent::Resize &&
      strip_->chosen() != Step::relief) {
    choose_step(strip_->chosen());
  }
  return QWidget::eventFilter(watched, event);
}

void WorkbenchPage::show_line(double y_m) {
  if (preview_.field == nullptr) return;
  line_y_m_ = y_m;
  relief_->set_line(mode_->checkedId() == static_cast<int>(Mode::making) ? std::optional(y_m)
                                                                         : std::nullopt);
  const LineProfile line = profile_along(*preview_.field, y_m);
  profile_->show_signal({line.heights});
  profile_->show_spectrum({line.spectrum});
}

void WorkbenchPage::show_forces() {
  if (mode_->checkedId() != static_cast<int>(Mode::comparing)) return;
  forces_->show_signal(comparison_->forces(), comparison_->is_preparing()
                                                  ? tr("Preparing the models…")
                                                  : tr("Drag over the relief to feel it"));
  forces_->show_spectrum(comparison_->spectra(), tr("Shown after a quarter of a second"));
  roughness_->show_series(comparison_->roughness(), tr("Shown after half a second"));
  const QString meaning =
      tr("Predicted acceleration of a hand-held tool of 50 g under the force of the last second of "
         "this stroke, computed as in asperity sweep.");
  const QString numbers = comparison_->roughness_in_words();
  roughness_->setToolTip(numbers.isEmpty() ? meaning : meaning + '\n' + numbers);
  roughness_->setAccessibleDescription(roughness_->toolTip());
  constexpr std::size_t kTrail = 400;  // samples: what the eye follows
  const std::vector<ProbeState>& path = comparison_->stroke().path();
  std::vector<glm::dvec2> trail_m{};
  for (std::size_t i = path.size() - std::min(path.size(), kTrail); i < path.size(); i += 4) {
    trail_m.emplace_back(path[i].position_m.x, path[i].position_m.y);
  }
  relief_->set_trail(std::move(trail_m));
  show_dent();
}

void WorkbenchPage::show_dent() {
  const std::optional<ForceComparison::Dent> dent = comparison_->dent();
  const QString of_model = dent ? dent->model : QString();
  relief_->set_dent(dent ? std::optional(dent->surface) : std::nullopt);
  if (std::exchange(dent_of_, of_model) != of_model) choose_step(strip_->chosen());
}

/// For the window, which makes its pages anew in another theme or language.
void WorkbenchPage::keep_unsaved(bool unsaved) {
  setProperty("keep", unsaved
                          ? tr("The relief in the workbench is not saved and would be lost: save "
                               "it, then change the theme or the language.")
                          : QString());
}

std::string WorkbenchPage::relief_of_study() const {
  if (opened_ == nullptr) return {};
  if (opened_->is_photograph()) return saved_as_;
  std::error_code unknown{};
  const bool is_there = std::filesystem::equivalent(opened_->file.parent_path(),
                                                    study_.folder() / "stimuli", unknown);
  return is_there && !opened_->is_measured ? "stimuli/" + opened_->file.filename().string()
                                           : std::string();
}

RenderingPanel::Compared WorkbenchPage::compared() const {
  ForceComparison::Saveable saveable = comparison_->saveable();
  RenderingPanel::Compared compared{.renderings = std::move(saveable.renderings)};
  const std::string relief = relief_of_study();
  for (Rendering& rendering : compared.renderings) {
    rendering.texture = {relief, opened_ == nullptr ? std::string() : opened_->sha256};
  }
  if (relief.empty() && opened_ != nullptr && opened_->is_photograph()) {
    compared.problem = tr("Save the relief to the study first, under “Make a relief”.");
  } else if (relief.empty() && opened_ != nullptr && opened_->is_measured) {
    compared.problem =
        tr("This relief was measured. Convert its file with “asperity texture”, then open the "
           "result.");
  } else if (relief.empty()) {
    compared.problem =
        tr("This relief is not in the study. Copy the file with its sidecar into the folder "
           "stimuli of the study, then open it from there.");
  } else if (comparison_->is_preparing()) {
    compared.problem = tr("Preparing the models…");
  } else if (saveable.is_on_body) {
    compared.problem =
        tr("A rendering lies on the plane. Choose the plane as the body under Surface and hand.");
  }
  if (!saveable.left_out.isEmpty()) {
    compared.left_out = tr("A rendering contains neither bodies nor recordings; left out: %1.")
                            .arg(saveable.left_out.join(", "));
  }
  return compared;
}

bool WorkbenchPage::is_settled() const {
  return !opening_.is_running() && !save_->is_saving() && !renderings_->is_saving() &&
         !work_.is_busy() && relief_->is_settled() && comparison_->is_settled();
}

}  // namespace asperity

#include "moc_workbench_page.cpp"
