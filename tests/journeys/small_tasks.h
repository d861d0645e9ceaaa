// Protocols of a few short trials, one for each task, for a study with the textures of SmallStudy.

#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace asperity::test {

/// Ratings on five scales, then a recognition, then a selection with a rating of confidence; 10 trials.
nlohmann::ordered_json three_tasks();
/// Both orders of two models with two textures, with a tie, twice; 8 trials.
nlohmann::ordered_json pairs_of_models();
/// The dissimilarity of five models on one texture, with identical pairs, side by side; 15 trials, or 11 or 9 in two parts.
nlohmann::ordered_json rated_pairs_of_models(int parts);
/// Two interleaved staircases of four trials.
nlohmann::ordered_json staircases();
/// Two levels of a same–different task, each as four pairs.
nlohmann::ordered_json same_different();
/// Three levels of a choice among three surfaces: of oddity trials with both types of every level.
nlohmann::ordered_json choice_of_three(const std::string& design);
/// The interleaved staircases with oddity trials.
nlohmann::ordered_json tracks_of_oddity();
/// A psi track of six trials on the levels of amplitude_jnd_psi, with slope and lapse rate marginalised, and a catch trial after every
/// third; 8 trials.
nlohmann::ordered_json psi_track();
/// Numbers for two textures with a standard of a given number, three times; 6 trials.
nlohmann::ordered_json magnitude_estimates();

}  // namespace asperity::test
