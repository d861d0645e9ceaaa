// Scenes made by hand, and a folder of pictures for them.

#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <QtCore/QTemporaryDir>

#include "app/session/respondents/participant_scene.h"

namespace asperity::scenes {

ParticipantScene to_read();
ParticipantScene feel(int surfaces);
/// One of three surfaces, with its hand guided: 1 N and 60 mm/s are asked for, within a quarter.
ParticipantScene guided(Exploration::Guidance guidance);
/// Recognition: `count` pictures.
ParticipantScene recognition(int count);
/// Matching: as many pictures as surfaces.
ParticipantScene matching(int count);
/// Selection: letters and "I cannot tell", with the picture of the material.
ParticipantScene selection(int count);
/// One surface, answered by a number.
ParticipantScene magnitude();
/// Bipolar scales on one page: with marks, one of them where a key began; the third is current.
ParticipantScene scales(int count);
/// A visual analogue scale with a mark.
ParticipantScene scale_line();
/// A line in place of a number, as it is drawn.
ParticipantScene drawn_line();
/// A scale with a label for every point.
ParticipantScene scale_with_labels();
ParticipantScene form_choice();
ParticipantScene form_number();
/// Several options may be chosen.
ParticipantScene form_choices();
/// A number with a unit.
ParticipantScene form_unit();
/// A scale of the questionnaire; 0: a line without points.
ParticipantScene form_scale(int points);
ParticipantScene form_text();
ParticipantScene rest(std::int64_t until_ns);
ParticipantScene mask(bool on);
/// Each kind once and in its fullest state, by name.
std::vector<std::pair<std::string, ParticipantScene>> all();

/// Scenes with more in them than fits easily: long texts, many pictures, letters and options.
std::vector<std::pair<std::string, ParticipantScene>> demanding();
/// A text of this many sentences, "Sentence 1 says …".
std::string sentences(int count);

/// A folder with the pictures "pictures/1.png" … "pictures/16.png" of these scenes, each of one colour;
/// the first is twelve times as wide as high, the second twelve times as high as wide.
class PictureFolder final {
 public:
  PictureFolder();
  std::filesystem::path path() const { return folder_.path().toStdString(); }

 private:
  QTemporaryDir folder_{};
};

}  // namespace asperity::scenes
