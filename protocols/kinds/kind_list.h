// Declares and lists the kinds of experiment; a new kind adds its declaration and its line.

#pragma once

#include <array>

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// Which of several renderings of one texture is the most realistic: a choice among the surfaces felt. No
/// response is correct or incorrect.
const ExperimentKind& selection_kind();

/// Several felt textures are assigned to as many pictures. Correct is the picture of the texture felt.
const ExperimentKind& matching_kind();

/// One felt texture is recognised among pictures: a choice, correct by a factor of the design.
const ExperimentKind& recognition_kind();

/// A number states how rough one felt surface is (magnitude estimation). No response is correct or incorrect.
const ExperimentKind& magnitude_kind();

/// One surface is felt and rated on one or more scales [Osgood 1957]. Scales can also
/// accompany the question of another kind.
const ExperimentKind& rating_kind();

/// Two surfaces are felt, and the one that has more of an attribute, or is closer to a standard, is chosen
/// [Bradley 1952]. A tie can be an option.
const ExperimentKind& paired_comparison_kind();

/// A standard and a comparison that differs from it in one parameter. The design states what a trial presents and how a
/// response is given (DiscriminationDesign): one of two or three surfaces is chosen, or the response is "yes" or "no" to one
/// surface, or "same" or "different" to two. The judgement states what the choice means: `performance`, where one response is correct,
/// or `comparison`, where no answer is correct and the proportion of choices of the comparison is a function of its
/// level.
const ExperimentKind& discrimination_kind();

/// Two surfaces are felt, and their dissimilarity (or similarity) is rated on a scale; the analysis is a configuration of the
/// surfaces in which distances correspond to dissimilarities [Kruskal 1978].
const ExperimentKind& similarity_kind();

/// All of them, in the order in which documents list them.
inline constexpr std::array kKindFunctions{
    &selection_kind, &matching_kind,          &recognition_kind,    &magnitude_kind,
    &rating_kind,    &paired_comparison_kind, &discrimination_kind, &similarity_kind};

}  // namespace asperity
