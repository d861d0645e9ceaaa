// Makes one scene of each kind and form of answer, and writes numbered pictures.

#include "tests/gui/participant/scenes.h"

#include <QtCore/QDir>
#include <QtGui/QImage>

#include "tests/support/questions.h"

namespace asperity::scenes {

namespace {

ParticipantScene in_block(ParticipantScene::Kind kind, const std::string& text) {
  ParticipantScene scene{};
  scene.kind = kind;
  scene.text = text;
  scene.block = 3;
  scene.blocks = 6;
  return scene;
}

std::string picture(int number) { return "pictures/" + std::to_string(number) + ".png"; }

std::vector<ParticipantScene::Surface> surfaces(int count) {
  std::vector<ParticipantScene::Surface> all{};
  for (int i = 0; i < count; ++i) {
    all.push_back({.code = std::string(1, static_cast<char>('A' + i)), .felt = true});
  }
  return all;
}

}  // namespace

ParticipantScene to_read() {
  ParticipantScene scene = in_block(
      ParticipantScene::Kind::text,
      "You will see the picture of a material and feel three surfaces, A, B and C. Stroke each one "
      "back and forth, from left to right, as lightly as you would stroke a table. You may go back "
      "to "
      "each as often as you like. Then choose the one that felt most like the material in the "
      "picture. There is no right or wrong; we would like to know what you feel. If you cannot "
      "tell, say so.");
  scene.block = 0;
  return scene;
}

ParticipantScene feel(int count) {
  ParticipantScene scene = in_block(ParticipantScene::Kind::feel, "Feel surface B now.");
  scene.surfaces = surfaces(count);
  for (std::size_t i = 1; i < scene.surfaces.size(); ++i) scene.surfaces[i].felt = false;
  if (count > 1) scene.surfaces[1].now = true;
  if (count == 1) {
    scene.text = "Feel surface A now.";
    scene.surfaces[0].now = true;
  }
  return scene;
}

ParticipantScene recognition(int count) {
  ParticipantScene scene =
      in_block(ParticipantScene::Kind::question, "Which of these materials did you feel?");
  scene.surfaces = surfaces(1);
  for (int i = 1; i <= count; ++i) {
    scene.choices.push_back({.key = std::to_string(i), .picture = picture(i)});
  }
  scene.choices.push_back({.key = "0", .text = "I cannot tell"});
  scene.can_switch = true;
  scene.surfaces[0].can_go = true;
  scene.response_open = true;
  return scene;
}

ParticipantScene matching(int count) {
  ParticipantScene scene =
      in_block(ParticipantScene::Kind::question, "Which picture belongs to which surface?");
  scene.surfaces = surfaces(count);
  for (int i = 1; i <= count; ++i) {
    scene.choices.push_back({.key = std::to_string(i), .picture = picture(i)});
  }
  scene.form = AssignmentForm{};
  scene.assigning = 0;
  scene.response_open = true;
  return scene;
}

ParticipantScene selection(int count) {
  ParticipantScene scene = in_block(ParticipantScene::Kind::question,
                                    "Which surface felt most like the material in the picture?");
  scene.surfaces = surfaces(count);
  for (const ParticipantScene::Surface& surface : scene.surfaces) {
    scene.choices.push_back({.key = surface.code});
  }
  scene.choices.push_back({.key = "0", .text = "I cannot tell"});
  scene.standard_picture = picture(1);
  scene.can_switch = true;
  scene.response_open = true;
  return scene;
}

ParticipantScene scales(int count) {
  static const std::vector<std::vector<std::string>> kEnds = {
      {"smooth", "rough"},      {"soft", "hard"},           {"sticky", "slippery"},
      {"fine", "coarse"},       {"unpleasant", "pleasant"}, {"flat", "bumpy"},
      {"regular", "irregular"}, {"dull", "sharp"},          {"cold", "warm"},
      {"dry", "wet"},           {"elastic", "rigid"},       {"artificial", "natural"}};
  ParticipantScene scene = in_block(ParticipantScene::Kind::question, "How did the surface feel?");
  scene.form = ScaleForm{.minimum = -3.0, .maximum = 3.0, .points = 7};
  scene.surfaces = surfaces(1);
  scene.can_switch = true;
  scene.response_open = true;
  for (int i = 0; i < count; ++i) {
    const std::vector<std::string>& ends = kEnds[static_cast<std::size_t>(i) % kEnds.size()];
    scene.scales.push_back(
        {.prompt = "How " + ends[1] + " did it feel?",
         .form = {.minimum = -3.0, .maximum = 3.0, .points = 7, .labels = ends}});
  }
  scene.scales[0].step = 5;
  scene.scales[0].counts = true;
  if (count > 2) {
    scene.scales[1].step = 1;
    scene.scales[1].counts = true;
    scene.scales[2].step = 3;
    scene.scales[2].current = true;
  }
  return scene;
}

ParticipantScene scale_line() {
  ParticipantScene scene = scales(1);
  scene.text = "How rough did the surface feel?";
  scene.scales = {{.form = {.labels = {"extremely smooth", "extremely rough"}},
                   .step = 413,
                   .counts = true,
                   .current = true}};
  scene.form = scene.scales.front().form;
  scene.can_confirm = true;
  return scene;
}

ParticipantScene drawn_line() {
  ParticipantScene scene =
      in_block(ParticipantScene::Kind::question,
               "How rough did this surface feel? Draw a line that is as long as it felt rough.");
  scene.form = LineForm{};
  scene.surfaces = surfaces(1);
  scene.can_switch = true;
  scene.can_confirm = true;
  scene.line_step = 350;
  scene.response_open = true;
  return scene;
}

ParticipantScene scale_with_labels() {
  ParticipantScene scene = scales(1);
  scene.text = "The surface felt like wood.";
  scene.scales = {{.form = {.minimum = 1.0,
                            .maximum = 5.0,
                            .points = 5,
                            .labels = {"strongly disagree", "disagree",
                                       "neither agree nor disagree", "agree", "strongly agree"}},
                   .step = 3,
                   .counts = true,
                   .current = true}};
  scene.form = scene.scales.front().form;
  scene.can_confirm = true;
  return scene;
}

ParticipantScene magnitude() {
  ParticipantScene scene =
      in_block(ParticipantScene::Kind::question, "How rough did this surface feel?");
  scene.surfaces = surfaces(1);
  scene.form = NumberForm{.is_estimate = true};
  scene.response_open = true;
  return scene;
}

ParticipantScene form_choice() {
  return scene_of_form({.name = "hand_problems",
                        .prompt = "Do you have any problems with your sense of touch, or with the "
                                  "hand or arm that you will use (for example numbness, pain or an "
                                  "injury)?",
                        .form = ChoiceForm{},
                        .options = in_words({"no", "yes", "I would rather not say"})});
}

ParticipantScene form_number() {
  return scene_of_form({.name = "age",
                        .prompt = "How old are you, in years?",
                        .form = NumberForm{.minimum = 18.0, .maximum = 120.0}});
}

ParticipantScene form_choices() {
  return scene_of_form({.name = "places",
                        .prompt = "Where does your hand hurt?",
                        .form = MultipleChoiceForm{},
                        .options = in_words({"fingers", "palm", "wrist", "elsewhere"}),
                        .optional = true});
}

ParticipantScene form_unit() {
  return scene_of_form({.name = "since",
                        .prompt = "For how long has your hand hurt?",
                        .form = NumberForm{.minimum = 0.0, .unit = "min"}});
}

ParticipantScene form_scale(int points) {
  return scene_of_form({.name = "strength",
                        .prompt = "How strong is the pain?",
                        .form = ScaleForm{.minimum = 0.0,
                                          .maximum = 10.0,
                                          .points = points,
                                          .labels = {"no pain", "the worst pain"}},
                        .optional = true});
}

ParticipantScene form_text() {
  return scene_of_form({.name = "remarks",
                        .prompt = "Is there anything else that we should know?",
                        .form = TextForm{},
                        .optional = true});
}

ParticipantScene rest(std::int64_t until_ns) {
  ParticipantScene scene = in_block(
      ParticipantScene::Kind::rest,
      "Please release the handle and rest your hand. You may shake it out if you like. We will "
      "go on when you are ready.");
  scene.rest_until_ns = until_ns;
  return scene;
}

ParticipantScene mask(bool on) {
  return in_block(on ? ParticipantScene::Kind::mask_on : ParticipantScene::Kind::mask_off,
                  on ? "Please put on the eye mask." : "Please take off the eye mask.");
}

ParticipantScene guided(Exploration::Guidance guidance) {
  ParticipantScene scene = feel(3);
  scene.guide.emplace();
  scene.guide->normal_force_N = {.minimum = 0.75, .target = 1.0, .maximum = 1.25};
  scene.guide->speed_m_per_s = {.minimum = 0.045, .target = 0.06, .maximum = 0.075};
  scene.guide->stroke_length_m.target = 0.06;
  scene.guide->guidance = guidance;
  Protocol protocol{};
  protocol.explorations["only"] = *scene.guide;
  scene.guide_scale = guide_scale_of(protocol);
  return scene;
}

std::vector<std::pair<std::string, ParticipantScene>> all() {
  std::vector<std::pair<std::string, ParticipantScene>> scenes{};
  scenes.emplace_back("blank", ParticipantScene{});
  scenes.emplace_back("text", to_read());
  scenes.emplace_back("feel", feel(4));
  ParticipantScene lifting = feel(4);
  lifting.text = "You have finished with surface B. Please lift the handle.";
  scenes.emplace_back("feel-enough", lifting);
  ParticipantScene with_pictures = feel(1);
  with_pictures.choices = recognition(6).choices;
  scenes.emplace_back("feel-pictures", with_pictures);
  ParticipantScene with_standard = feel(3);
  with_standard.standard_picture = picture(1);
  scenes.emplace_back("feel-standard", with_standard);
  ParticipantScene with_workspace = feel(3);
  with_workspace.show_workspace = true;
  scenes.emplace_back("feel-workspace", with_workspace);
  using Guidance = Exploration::Guidance;
  scenes.emplace_back("feel-bars", guided(Guidance::bars));
  scenes.emplace_back("feel-target", guided(Guidance::moving_target));
  ParticipantScene guided_beside = guided(Guidance::bars);
  guided_beside.show_workspace = true;
  guided_beside.standard_picture = picture(1);
  scenes.emplace_back("feel-bars-workspace", guided_beside);
  ParticipantScene recognised = recognition(6);
  recognised.choices[3].chosen = true;
  recognised.can_confirm = true;
  scenes.emplace_back("recognition", recognised);
  ParticipantScene many = recognition(12);
  many.cue = "Please choose first.";
  many.cue_number = 1;
  scenes.emplace_back("recognition-12", many);
  ParticipantScene matched = matching(4);
  matched.choices[2].assigned_to = "A";
  matched.choices[0].assigned_to = "B";
  matched.assigning = 2;
  matched.can_switch = true;
  matched.cue = "Please assign a picture to surface C first.";
  matched.cue_number = 1;
  scenes.emplace_back("matching", matched);
  ParticipantScene selected = selection(3);
  selected.choices[1].chosen = true;
  selected.can_confirm = true;
  scenes.emplace_back("selection", selected);
  ParticipantScene again = selection(3);
  again.cue = "Confirm to feel surface A again.";
  again.cue_number = 1;
  again.can_confirm = true;
  scenes.emplace_back("selection-again", again);
  ParticipantScene from_memory = selection(6);
  from_memory.standard_picture.reset();
  scenes.emplace_back("selection-memory", from_memory);
  ParticipantScene compared = selection(2);
  compared.text = "Which surface is rougher?";
  compared.standard_picture.reset();
  compared.choices.back() = {.key = "3", .text = "Equally rough"};
  compared.choices.back().chosen = true;
  compared.can_confirm = true;
  scenes.emplace_back("pair", compared);
  scenes.emplace_back("magnitude", magnitude());
  scenes.emplace_back("scale-line", scale_line());
  scenes.emplace_back("drawn-line", drawn_line());
  scenes.emplace_back("scale-labels", scale_with_labels());
  scenes.emplace_back("scales", scales(5));
  ParticipantScene doubted = magnitude();
  doubted.text_message = {.what = ParticipantMessage::What::check_estimate, .code = "500"};
  doubted.text = text_of(doubted.text_message);
  doubted.can_switch = true;
  scenes.emplace_back("magnitude-checked", doubted);
  ParticipantScene feedback = in_block(ParticipantScene::Kind::feedback, "That was picture 4.");
  scenes.emplace_back("feedback", feedback);
  scenes.emplace_back("rest", rest(0));
  scenes.emplace_back("form-choice", form_choice());
  scenes.emplace_back("form-number", form_number());
  ParticipantScene signed_number = form_number();
  signed_number.form = NumberForm{.maximum = 120.0};
  scenes.emplace_back("form-number-signed", signed_number);
  scenes.emplace_back("form-choices", form_choices());
  scenes.emplace_back("form-unit", form_unit());
  scenes.emplace_back("form-scale", form_scale(11));
  scenes.emplace_back("form-line", form_scale(0));
  scenes.emplace_back("form-text", form_text());
  scenes.emplace_back("mask-on", mask(true));
  scenes.emplace_back("mask-off", mask(false));
  scenes.emplace_back("paused", in_block(ParticipantScene::Kind::paused, ""));
  ParticipantScene ended = in_block(ParticipantScene::Kind::ended, "");
  ended.block = 0;
  scenes.emplace_back("ended", ended);
  return scenes;
}

std::string sentences(int count) {
  std::string text{};
  for (int i = 1; i <= count; ++i) {
    text += "Sentence " + std::to_string(i) +
            " says in some words what the participant has to know before it begins. ";
  }
  return text;
}

std::vector<std::pair<std::string, ParticipantScene>> demanding() {
  std::vector<std::pair<std::string, ParticipantScene>> scenes{};
  ParticipantScene text = to_read();
  text.text = sentences(18);
  scenes.emplace_back("text-long", text);
  ParticipantScene pause = rest(0);
  pause.text = sentences(14);
  scenes.emplace_back("rest-long", pause);
  scenes.emplace_back("feel-many", feel(9));
  for (const int count : {12, 16}) {
    ParticipantScene recognised = recognition(count);
    recognised.choices[0].chosen = true;
    recognised.can_confirm = true;
    scenes.emplace_back("recognition-" + std::to_string(count), recognised);
  }
  ParticipantScene asked_long = recognition(6);
  asked_long.text = sentences(5) + "Which of these materials did you feel?";
  scenes.emplace_back("recognition-long", asked_long);
  ParticipantScene matched = matching(12);
  matched.choices[11].assigned_to = "A";
  matched.choices[0].assigned_to = "B";
  matched.assigning = 2;
  matched.can_switch = true;
  matched.choices.push_back({.key = "0", .text = "I cannot tell"});
  scenes.emplace_back("matching-12", matched);
  scenes.emplace_back("scales-12", scales(12));
  ParticipantScene selected = selection(9);
  selected.standard_picture.reset();
  scenes.emplace_back("selection-9", selected);
  const ParticipantScene choice = scene_of_form(
      {.name = "experience",
       .prompt = "How often do you work with your hands?",
       .options =
           in_words({"never or hardly ever in all my life", "less than once in a year",
                     "some times in a year, on average", "about once in a month",
                     "about once in a week", "on most days, for a short while",
                     "on most days, for an hour or more", "every day, and it is my profession"})});
  scenes.emplace_back("form-choice-long", choice);
  const ParticipantScene asked = scene_of_form({.name = "agreement",
                                                .prompt = sentences(6) + "Do you agree?",
                                                .options = in_words({"yes", "no"})});
  scenes.emplace_back("form-question-long", asked);
  ParticipantScene number = form_number();
  number.form = NumberForm{.minimum = -1234567.125, .maximum = 1234567.125};
  scenes.emplace_back("form-number-range", number);
  ParticipantScene written = form_text();
  written.text = sentences(7);
  scenes.emplace_back("form-text-long", written);
  return scenes;
}

PictureFolder::PictureFolder() {
  QDir(folder_.path()).mkdir("pictures");
  for (int i = 1; i <= 16; ++i) {
    QSize size(120 + 10 * i, 160);
    if (i == 1) size = {1200, 100};
    if (i == 2) size = {100, 1200};
    QImage image(size, QImage::Format_RGB32);
    image.fill(QColor::fromHsv(22 * i, 120, 160));
    image.save(folder_.filePath(QString("pictures/%1.png").arg(i)));
  }
}

}  // namespace asperity::scenes
