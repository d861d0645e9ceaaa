#include "app/gui/workbench/workbench_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QtCore/QBuffer>
#include <QtCore/QEvent>
#include <QtCore/QMimeData>
#include <QtGui/QDragEnterEvent>
#include <QtGui/QDropEvent>
#include <QtGui/QFontMetrics>
#include <QtGui/QImageReader>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QStackedWidget>

#include "analysis/spectrum.h"
#include "app/gui/look/controls.h"
#include "app/gui/study/open_study.h"
#include "app/gui/workbench/force_comparison.h"
#include "app/gui/workbench/parameter_form.h"
#include "app/gui/workbench/relief_view.h"
#include "app/gui/workbench/signal_plots.h"
#include "stimuli/preview.h"

namespace asperity {

namespace {

constexpr int kPanelWidth = 392;
constexpr int kThumbnailSide = 1024;  // of the photograph in colour

enum Kind { bright_high, dark_high, side_light, paint };

QString text_of(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

bool is_height_field(const std::filesystem::path& file) {
  return file.extension() == ".png" && std::filesystem::exists(sidecar_of(file));
}

/// In colour where Qt reads the format; its rows are those of the file, as in decode_photograph.
QImage colour_picture(const std::filesystem::path& file, const GreyImage& grey) {
  QImageReader reader(text_of(file));
  reader.setAutoTransform(false);
  const QSize size = reader.size();
  if (size.isValid() && std::max(size.width(), size.height()) > kThumbnailSide) {
    reader.setScaledSize(size.scaled(kThumbnailSide, kThumbnailSide, Qt::KeepAspectRatio));
  }
  const QImage picture = reader.read();
  return picture.isNull() ? picture_of(grey) : picture;
}

/// Letters, digits, _ and −: a name that every system and every protocol can write.
QString study_name(const std::filesystem::path& file) {
  QString name{};
  for (const char letter : file.stem().string()) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
    const bool capital = letter >= 'A' && letter <= 'Z';
    name += plain ? letter : capital ? static_cast<char>(letter - 'A' + 'a') : '_';
  }
  return name.left(40);
}

bool is_plain(const QString& name) {
  return std::all_of(name.begin(), name.end(), [](QChar letter) {
    return letter.unicode() < 128 && (letter.isLetterOrNumber() || letter == '_' || letter == '-');
  });
}

std::vector<Parameter> declared(std::initializer_list<const char*> names) {
  std::vector<Parameter> chosen{};
  for (const Parameter& parameter : texture_recipe_parameters()) {
    if (std::find(names.begin(), names.end(), parameter.name) != names.end()) {
      chosen.push_back(parameter);
    }
  }
  return chosen;
}

/// What of the advice has to be seen before the sign is chosen.
QString hint_of(PhotographResemblance resemblance) {
  switch (resemblance) {
    case PhotographResemblance::directed:
      return WorkbenchPage::tr(
          "It changes mostly in one direction: a grain, or light from one "
          "side? More at the end of this list.");
    case PhotographResemblance::bright_spots:
      return WorkbenchPage::tr(
          "It has narrow bright parts. If they lie low, as light mortar "
          "does, dark parts stand out.");
    case PhotographResemblance::dark_grooves:
    case PhotographResemblance::nothing_clear:
      break;
  }
  return {};
}

QString in_micrometres(double length_m) { return QString::number(length_m * 1e6, 'f', 0); }

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
  layout->addWidget(make_head());
  banner_ = new Banner(this);
  banner_->setObjectName("banner");
  layout->addWidget(banner_);
  pages_ = new QStackedWidget(this);
  auto* empty = new EmptyState(
      tr("Drop a photograph of a surface here"),
      tr("It becomes a relief that can be felt: its light is evened out, long waves are taken "
         "away, and what is left of its brightness is read as height. PNG, JPEG, TIFF, BMP and "
         "WebP are read. Best is a picture in even light, taken from straight above."),
      pages_);
  empty->setObjectName("drop_area");
  empty->setAttribute(Qt::WA_StyledBackground);
  empty->setStyleSheet("#drop_area { border: 2px dashed palette(mid); border-radius: 8px; }");
  setFocusProxy(
      empty->add_action(tr("Open a photograph…"), ButtonRole::primary, [this] { choose_file(); }));
  pages_->addWidget(empty);
  pages_->addWidget(make_workspace());
  layout->addWidget(pages_, 1);

  connect(strip_, &StepStrip::stepChosen, this, &WorkbenchPage::choose_step);
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

QWidget* WorkbenchPage::make_head() {
  auto* head = new QWidget(this);
  auto* layout = new QHBoxLayout(head);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  QLabel* title = make_title(tr("Workbench"), head);
  title->setWordWrap(false);
  layout->addWidget(title);
  layout->addSpacing(kMargin);
  mode_ = new QButtonGroup(this);
  const std::array<QString, 2> words{tr("Make a relief"), tr("Compare force models")};
  for (int i = 0; i < 2; ++i) {
    QPushButton* button =
        make_button(words[static_cast<std::size_t>(i)], ButtonRole::selector, head);
    button->setObjectName(i == 0 ? "mode_making" : "mode_comparing");
    // The chosen one is bold and needs its room before it is chosen.
    const QFontMetrics bold(text_font(TextSize::body, true));
    button->setMinimumWidth(bold.horizontalAdvance(button->text()) + 2 * kMargin);
    button->hide();  // until there is something to choose for
    mode_->addButton(button, i);
    layout->addWidget(button);
  }
  connect(mode_, &QButtonGroup::idClicked, this,
          [this](int id) { set_mode(static_cast<Mode>(id)); });
  layout->addStretch(1);
  auto* fields = make_button(tr("Relief of the study"), ButtonRole::plain, head);
  fields->setObjectName("open_height_field");
  auto* menu = new QMenu(fields);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill_study_menu(*menu); });
  fields->setMenu(menu);
  layout->addWidget(fields);
  QPushButton* open = make_button(tr("Open a photograph…"), ButtonRole::plain, head);
  open->setObjectName("open_photograph");
  connect(open, &QPushButton::clicked, this, &WorkbenchPage::choose_file);
  layout->addWidget(open);
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
  profile_ = new SignalPlots(
      {.heading = tr("Profile along the orange line"), .x = tr("Place, mm"), .y = tr("Height, µm")},
      {.heading = tr("Its spectrum"),
       .x = tr("Waves per mm"),
       .y = tr("Power, µm² mm"),
       .x_scale = PlotScale::logarithmic,
       .y_scale = PlotScale::logarithmic},
      plots_);
  profile_->setObjectName("profile");
  forces_ = new SignalPlots({.heading = tr("Force"), .x = tr("Time, s"), .y = tr("Force, N")},
                            {.heading = tr("Its spectrum"),
                             .x = tr("Frequency, Hz"),
                             .y = tr("Power, N²/Hz"),
                             .y_scale = PlotScale::logarithmic},
                            plots_);
  forces_->setObjectName("forces");
  plots_->addWidget(profile_);
  plots_->addWidget(forces_);
  middle->addWidget(plots_, 3);
  layout->addLayout(middle, 1);

  side_ = new QStackedWidget(work);
  side_->setFixedWidth(kPanelWidth);
  side_->addWidget(make_recipe_panel());
  comparison_ = new ForceComparison(study_.models(), side_);
  comparison_->setObjectName("comparison");
  side_->addWidget(scrolled(comparison_, side_));
  layout->addWidget(side_);
  return work;
}

QWidget* WorkbenchPage::make_recipe_panel() {
  auto* panel = new QWidget(side_);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  recipe_banner_ = new Banner(panel);
  recipe_banner_->setObjectName("recipe_banner");
  layout->addWidget(recipe_banner_);
  finished_ = make_text(tr("This relief is finished: it comes from a file of the study. Open a "
                           "photograph to make another one, or compare how the force models "
                           "render this one."),
                        panel, true);
  finished_->setObjectName("finished");
  layout->addWidget(finished_);

  recipe_panel_ = new QWidget(panel);
  auto* inside = new QVBoxLayout(recipe_panel_);
  inside->setContentsMargins(0, 0, kGrid, 0);
  inside->setSpacing(kGrid);
  QVBoxLayout* shows = nullptr;
  QFrame* card = make_card(recipe_panel_, shows);
  shows->addWidget(make_text(tr("<b>What does the photograph show?</b>"), card));
  kind_ = new QComboBox(card);
  kind_->setObjectName("kind");
  kind_->addItems({tr("Relief: bright parts stand out"), tr("Relief: dark parts stand out"),
                   tr("A surface lit from one side"), tr("Paint, print or stains")});
  connect(kind_, &QComboBox::currentIndexChanged, this, [this](int kind) {
    say_what_it_shows(kind);
    recompute();
  });
  shows->addWidget(kind_);
  expectation_ = make_text({}, card);
  expectation_->setObjectName("expectation");
  expectation_->setFont(text_font(TextSize::small));
  shows->addWidget(expectation_);
  hint_ = new StateLabel(card);
  hint_->setObjectName("hint");
  hint_->setFont(text_font(TextSize::small));
  hint_->hide();
  shows->addWidget(hint_);
  inside->addWidget(card);
  add_recipe_groups(inside, recipe_panel_);
  QVBoxLayout* tells = nullptr;
  QFrame* evidence = make_card(recipe_panel_, tells);
  tells->addWidget(make_text(tr("<b>What the picture tells about itself</b>"), evidence));
  advice_ = make_text({}, evidence, true);
  advice_->setObjectName("advice");
  advice_->setFont(text_font(TextSize::small));
  tells->addWidget(advice_);
  inside->addWidget(evidence);
  inside->addStretch(1);
  say_what_it_shows(bright_high);

  layout->addWidget(scrolled(recipe_panel_, panel), 1);
  layout->addWidget(make_save_panel());
  return panel;
}

void WorkbenchPage::add_recipe_groups(QLayout* layout, QWidget* parent) {
  struct Group {
    QString title{};
    std::vector<Parameter> parameters{};
  };
  const std::array<Group, 4> groups{
      Group{tr("Heights"), declared({"rms_m"})},
      Group{tr("Photograph"), declared({"width_m", "histogram"})},
      Group{tr("Even the light"),
            declared({"homomorphic_wavelength_m", "gamma_low", "gamma_high"})},
      Group{tr("Take long waves away"), declared({"gaussian_wavelength_m"})}};
  for (const Group& group : groups) {
    QVBoxLayout* inside = nullptr;
    QFrame* card = make_card(parent, inside);
    QLabel* title = make_text(group.title, card);
    title->setFont(text_font(TextSize::body, true));
    inside->addWidget(title);
    auto* form = new ParameterForm(group.parameters, FormStyle::sliders, card);
    connect(form, &ParameterForm::edited, this, &WorkbenchPage::recompute);
    connect(form, &ParameterForm::released, this, &WorkbenchPage::recompute);
    inside->addWidget(form);
    forms_.push_back(form);
    layout->addWidget(card);
  }
}

QWidget* WorkbenchPage::make_save_panel() {
  QVBoxLayout* layout = nullptr;
  QFrame* card = make_card(side_, layout);
  facts_ = make_text({}, card, true);
  facts_->setObjectName("facts");
  facts_->setFont(text_font(TextSize::small));
  layout->addWidget(facts_);
  auto* line = new QHBoxLayout();
  line->setSpacing(kGrid);
  name_ = new QLineEdit(card);
  name_->setObjectName("name");
  name_->setPlaceholderText(tr("Name in the study"));
  name_->setAccessibleName(tr("Name in the study"));
  save_ = make_button(tr("Save to study"), ButtonRole::primary, card);
  save_->setObjectName("save");
  line->addWidget(name_, 1);
  line->addWidget(save_);
  layout->addLayout(line);
  name_problem_ = make_text({}, card, true);
  name_problem_->setObjectName("name_problem");
  name_problem_->setFont(text_font(TextSize::small));
  layout->addWidget(name_problem_);
  connect(name_, &QLineEdit::textChanged, this, &WorkbenchPage::check_name);
  connect(name_, &QLineEdit::returnPressed, save_, &QPushButton::click);
  connect(save_, &QPushButton::clicked, this, [this] { save(Overwrite::refuse); });
  return card;
}

void WorkbenchPage::set_mode(Mode mode) {
  const int id = static_cast<int>(mode);
  mode_->button(id)->setChecked(true);
  plots_->setCurrentIndex(id);
  side_->setCurrentIndex(id);
  const bool making = mode == Mode::making;
  relief_->set_mouse(making ? MouseMeans::turning : MouseMeans::stroking);
  relief_->set_line(making ? std::optional(line_y_m_) : std::nullopt);
  relief_->set_trail({});
  if (!making) {
    strip_->choose(Step::relief);
    // Renderers are made for a relief that is looked at, not for every step towards it.
    comparison_->set_field(preview_.field);
    if (!std::exchange(has_sound_, true)) comparison_->set_sound(default_output());
  }
  choose_step(strip_->chosen());
  show_forces();
}

void WorkbenchPage::fill_study_menu(QMenu& menu) {
  menu.clear();
  const std::filesystem::path folder = study_.folder() / "stimuli";
  std::vector<std::filesystem::path> files{};
  std::error_code missing{};
  for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
    if (is_height_field(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files) {
    connect(menu.addAction(text_of(file.stem())), &QAction::triggered, this,
            [this, file] { open_file(file); });
  }
  if (files.empty()) menu.addAction(tr("This study has no relief yet"))->setEnabled(false);
}

void WorkbenchPage::choose_file() {
  auto* dialog = new QFileDialog(this, tr("Open a photograph of a surface"), {},
                                 tr("Photographs (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.webp)"));
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
  open_file(event->mimeData()->urls().first().toLocalFile().toStdString());
}

void WorkbenchPage::open_file(const std::filesystem::path& file) {
  banner_->show_news(State::unknown, tr("Reading %1 …").arg(text_of(file.filename())));
  opening_.run<std::shared_ptr<const Opened>>(
      [file, recipe = recipe()](const std::stop_token&, const BackgroundTask::Progress&) {
        auto opened = std::make_shared<Opened>();
        opened->file = file;
        opened->recipe = recipe;
        if (is_height_field(file)) {
          opened->preview = preview_of(load_height_field(file).field);
          return std::shared_ptr<const Opened>(opened);
        }
        opened->loaded = load_photograph(file);
        const GreyImage& grey = opened->loaded.photograph.grey;
        const std::string name = file.filename().string();
        opened->reduced = scaled_to_fit(grey, kPreviewSide);
        opened->coarse = scaled_to_fit(grey, kDraggedSide);
        opened->preview = preview_of(opened->reduced, recipe, name);
        const PhotographEvidence evidence = examine_photograph(opened->reduced, recipe, name);
        opened->advice = advice(evidence);
        opened->resemblance = resemblance(evidence);
        opened->original = colour_picture(file, opened->reduced);
        return std::shared_ptr<const Opened>(opened);
      },
      [this](std::shared_ptr<const Opened> opened) { take(std::move(opened)); },
      [this](const QString& what) {
        banner_->show_news(State::stop, tr("The file could not be opened: %1").arg(what));
      });
}

void WorkbenchPage::take(std::shared_ptr<const Opened> opened) {
  banner_->hide();
  recipe_banner_->hide();
  opened_ = std::move(opened);
  pages_->setCurrentIndex(1);
  for (QAbstractButton* button : mode_->buttons()) button->show();
  setFocusProxy(relief_);
  relief_->setFocus(Qt::OtherFocusReason);
  const bool has_recipe = !opened_->reduced.values.empty();
  finished_->setVisible(!has_recipe);
  recipe_panel_->setVisible(has_recipe);
  strip_->set_picture(Step::photograph, opened_->original);
  line_y_m_ = 0.0;
  if (has_recipe) {
    advice_->setText(QString::fromStdString(opened_->advice));
    const QSignalBlocker quiet(kind_);
    kind_->setCurrentIndex(bright_high);
    say_what_it_shows(bright_high);
    const QString hint = hint_of(opened_->resemblance);
    hint_->set_state(State::look, hint);
    hint_->setVisible(!hint.isEmpty());
  }
  name_->setText(study_name(opened_->file));
  keep_unsaved(has_recipe);
  show_preview(opened_->preview);
  strip_->choose(Step::relief);
  choose_step(Step::relief);
  check_name();
  // The recipe may have been changed while the file was read.
  if (parameter_values(recipe()) != parameter_values(opened_->recipe)) recompute();
}

TextureRecipe WorkbenchPage::recipe() const {
  ParameterValues values{};
  for (const ParameterForm* form : forms_) values.merge(form->values());
  values["sign"] = kind_->currentIndex() == dark_high ? -1.0 : 1.0;
  return texture_recipe(values);
}

void WorkbenchPage::recompute() {
  if (opened_ == nullptr || opened_->reduced.values.empty()) return;
  keep_unsaved(true);
  const bool dragging = std::any_of(forms_.begin(), forms_.end(),
                                    [](const ParameterForm* form) { return form->is_dragging(); });
  work_.ask(
      [this, opened = opened_, recipe = recipe(), dragging]() -> NewestWork::Delivery {
        auto preview = std::make_shared<TexturePreview>(preview_of(
            dragging ? opened->coarse : opened->reduced, recipe, opened->file.filename().string()));
        return [this, opened, preview] {
          if (opened != opened_) return;  // another file has been opened meanwhile
          recipe_banner_->hide();
          show_preview(std::move(*preview));
        };
      },
      [this](const QString& what) { recipe_banner_->show_news(State::look, what); });
}

void WorkbenchPage::show_preview(TexturePreview preview) {
  preview_ = std::move(preview);
  const int first = kSteps - 1 - static_cast<int>(preview_.steps.size());
  for (int i = 1; i < kSteps - 1; ++i) {
    strip_->set_picture(static_cast<Step>(i),
                        i < first ? QImage() : preview_.steps[static_cast<std::size_t>(i - first)]);
  }
  // The strip's own small relief, always seen from the same side.
  strip_->set_picture(Step::relief, draw_relief(*preview_.coarse, ReliefLook{}, {160, 120}));
  relief_->show_relief(preview_.fine, preview_.coarse);
  if (mode_->checkedId() == static_cast<int>(Mode::comparing)) {
    comparison_->set_field(preview_.field);
  }
  const HeightField& field = *preview_.field;
  facts_->setText(tr("%1 × %2 mm, %3 µm from the lowest to the highest point, RMS %4 µm")
                      .arg(field.width_m() * 1e3, 0, 'f', 0)
                      .arg(field.length_m() * 1e3, 0, 'f', 0)
                      .arg(in_micrometres(field.maximum_m() - field.minimum_m()),
                           in_micrometres(field.rms_m())));
  show_line(line_y_m_);
  choose_step(strip_->chosen());
}

void WorkbenchPage::say_what_it_shows(int kind) {
  switch (kind) {
    case dark_high:
      expectation_->setText(
          tr("Dark is high: for light mortar between bricks or light sand "
             "between pebbles. The shape comes back well in even light."));
      break;
    case side_light:
      expectation_->setText(
          tr("▲ What comes back is the slope towards the light, not the height: edges across the "
             "light become ridges and grooves, edges along it vanish. It looks like a relief and "
             "feels like one, of another surface. Take the picture again in even light if you "
             "can."));
      break;
    case paint:
      expectation_->setText(
          tr("▲ The paint becomes relief: what is felt has nothing to do with "
             "the surface under it. Use it only if that is what you want."));
      break;
    default:
      expectation_->setText(
          tr("Bright is high: for a surface in even light, where grooves and "
             "gaps are dark. The shape comes back well; how deep it is you "
             "have to say."));
  }
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
  const QString height = times > 1.0 ? tr("Heights are drawn %1 times too high.").arg(times)
                                     : tr("Heights are drawn to scale.");
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
  const HeightField& field = *preview_.field;
  const HeightField::Grid& grid = field.grid();
  relief_->set_line(mode_->checkedId() == static_cast<int>(Mode::making) ? std::optional(y_m)
                                                                         : std::nullopt);
  const double row_at = 0.5 * static_cast<double>(grid.rows - 1) - y_m / grid.pitch_m;
  const auto row = static_cast<std::size_t>(
      std::clamp(std::round(row_at), 0.0, static_cast<double>(grid.rows - 1)));
  const float* heights_m = field.heights_m().data() + row * grid.columns;
  PlotSeries profile{.color = series_color(5)};
  std::vector<double> heights_um{};
  for (std::size_t j = 0; j < grid.columns; ++j) {
    heights_um.push_back(1e6 * static_cast<double>(heights_m[j]));
    profile.x.push_back(1e3 * grid.pitch_m * static_cast<double>(j));
    profile.y.push_back(heights_um.back());
  }
  profile_->show_signal({profile});
  // Half the line in a window: three of them, and waves down to half its length.
  const PowerSpectrum spectrum = welch_spectrum(
      heights_um,
      {.rate_Hz = 1e-3 / grid.pitch_m, .length = std::max<std::size_t>(2, grid.columns / 2)});
  PlotSeries lines{.color = series_color(5)};
  for (std::size_t k = 1; k < spectrum.density.size(); ++k) {
    lines.x.push_back(static_cast<double>(k) * spectrum.spacing_Hz);
    lines.y.push_back(spectrum.density[k]);
  }
  profile_->show_spectrum({lines});
}

void WorkbenchPage::show_forces() {
  if (mode_->checkedId() != static_cast<int>(Mode::comparing)) return;
  forces_->show_signal(comparison_->forces(), tr("Drag over the relief to feel it"));
  forces_->show_spectrum(comparison_->spectra(), tr("After a quarter of a second"));
  constexpr std::size_t kTrail = 400;  // samples: what the eye follows
  const std::vector<ProbeState>& path = comparison_->stroke().path();
  std::vector<glm::dvec2> trail_m{};
  for (std::size_t i = path.size() - std::min(path.size(), kTrail); i < path.size(); i += 4) {
    trail_m.emplace_back(path[i].position_m.x, path[i].position_m.y);
  }
  relief_->set_trail(std::move(trail_m));
}

/// For the window, which makes its pages anew in another theme or language.
void WorkbenchPage::keep_unsaved(bool unsaved) {
  setProperty("keep", unsaved
                          ? tr("The relief in the workbench is not saved and would be lost: save "
                               "it, then change theme or language.")
                          : QString());
}

void WorkbenchPage::check_name() {
  QString problem{};
  const QString name = name_->text();
  if (opened_ == nullptr || opened_->reduced.values.empty()) {
    problem = tr("A relief that comes from a file is saved already.");
  } else if (name.isEmpty()) {
    problem = tr("The relief needs a name.");
  } else if (!is_plain(name)) {
    problem = tr("Letters without accents, digits, _ and - only.");
  } else if (name.endsWith("_photo")) {
    problem = tr("Names that end in _photo are those of photographs.");
  } else if (saving_.is_running()) {
    problem = tr("Saving …");
  }
  save_->setEnabled(problem.isEmpty());
  name_problem_->setText(
      problem.isEmpty() ? tr("Goes to stimuli/ with its sidecar and its photograph.") : problem);
}

void WorkbenchPage::save(Overwrite overwrite) {
  if (!save_->isEnabled()) return;
  const std::string name = name_->text().toStdString();
  const std::filesystem::path folder = study_.folder() / "stimuli";
  const std::filesystem::path png = folder / (name + ".png");
  const std::filesystem::path photo = folder / (name + "_photo.png");
  const auto there = [](const std::filesystem::path& file) {
    return std::filesystem::exists(file);
  };
  if (overwrite == Overwrite::refuse && (there(png) || there(sidecar_of(png)) || there(photo))) {
    banner_->show_news(State::look,
                       tr("The study has a stimulus “%1” already. Protocols that use it would "
                          "present the new one; sessions that were run keep the mark of the old.")
                           .arg(name_->text()),
                       tr("Replace “%1”").arg(name_->text()), [this] { save(Overwrite::allow); });
    return;
  }
  saving_.run<int>(
      [opened = opened_, recipe = recipe(), folder, png, photo, overwrite](
          const std::stop_token&, const BackgroundTask::Progress&) {
        std::filesystem::create_directories(folder);
        refuse_existing({png, sidecar_of(png), photo}, overwrite);
        const GreyImage& grey = opened->loaded.photograph.grey;
        const std::string source = opened->file.filename().string();
        const PhotographTexture texture = texture_from_photograph(grey, recipe, source);
        save_height_field(
            png, texture.field,
            {"photograph", parameter_values(recipe), {}, source, opened->loaded.sha256, ""},
            overwrite);
        save_picture(photo, grey, overwrite);
        return 0;
      },
      [this, shown = name_->text()](int) {
        keep_unsaved(false);
        banner_->show_news(
            State::fine,
            tr("Saved as stimuli/%1.png, with its sidecar and stimuli/%1_photo.png.").arg(shown));
        check_name();
        study_.announce_change();
      },
      [this](const QString& what) {
        banner_->show_news(State::stop, tr("The relief was not saved: %1").arg(what));
        check_name();
      });
  check_name();
}

bool WorkbenchPage::is_settled() const {
  return !opening_.is_running() && !saving_.is_running() && !work_.is_busy() &&
         relief_->is_settled() && comparison_->is_settled();
}

}  // namespace asperity
