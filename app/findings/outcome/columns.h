// The columns that tables of several methods have. A column of one method is declared next to it.

#pragma once

#include "analysis/words/phrase.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/result_table.h"

namespace asperity::columns {

// Who and what a row is about.
inline const ResultColumn kParticipant{.id = "participant",
                                       .heading = phrase("AnalysisWords", "participant")};
/// A participant, in the tables of estimates.
inline const ResultColumn kPerson{.id = "person",
                                  .heading = phrase("AnalysisWords", "participant")};
/// Women, men, and everyone.
inline const ResultColumn kSex{
    .id = "person", .heading = phrase("AnalysisWords", "participant"), .words = words_of_sex};
/// The level of the factor `column`, or all of them.
inline const ResultColumn kRepetition{
    .id = "column", .heading = phrase("AnalysisWords", "repetition"), .words = words_of_repetition};
inline const ResultColumn kTexture{.id = "texture", .heading = phrase("AnalysisWords", "texture")};
inline const ResultColumn kPair{
    .id = "pair", .heading = phrase("AnalysisWords", "pair"), .stored_as = {"first", "second"}};
inline const ResultColumn kCondition{.id = "condition",
                                     .heading = phrase("AnalysisWords", "condition"),
                                     .words = words_of_condition_or_all};
inline const ResultColumn kItem{
    .id = "item", .heading = phrase("AnalysisWords", "item"), .words = words_of_item};
inline const ResultColumn kScale{.id = "scale", .heading = phrase("AnalysisWords", "scale")};
inline const ResultColumn kQuestion{.id = "question",
                                    .heading = phrase("AnalysisWords", "question")};
inline const ResultColumn kTask{.id = "task", .heading = phrase("AnalysisWords", "task")};
inline const ResultColumn kMeasure{
    .id = "measure", .heading = phrase("AnalysisWords", "measure"), .words = words_of_measure};
inline const ResultColumn kFactor{
    .id = "factor", .heading = phrase("AnalysisWords", "factor"), .words = words_of_factor};
inline const ResultColumn kFactorLevel{
    .id = "level", .heading = phrase("AnalysisWords", "level"), .words = words_of_level};
inline const ResultColumn kReference{
    .id = "reference", .heading = phrase("AnalysisWords", "reference"), .words = words_of_item};
inline const ResultColumn kStimulus{.id = "stimulus",
                                    .heading = phrase("AnalysisWords", "stimulus")};
/// The stimulus of a response, among the tables of responses to each.
inline const ResultColumn kFelt{.id = "felt", .heading = phrase("AnalysisWords", "stimulus")};
inline const ResultColumn kSpacing{.id = "spacing_m",
                                   .heading = phrase("AnalysisWords", "spacing"),
                                   .unit = "m",
                                   .digits = Digits::length};
inline const ResultColumn kPosition{.id = "position",
                                    .heading = phrase("AnalysisWords", "position")};
inline const ResultColumn kSession{.id = "session", .heading = phrase("AnalysisWords", "session")};
inline const ResultColumn kBlock{.id = "block", .heading = phrase("AnalysisWords", "block")};
inline const ResultColumn kBlockOrdinal{.id = "block_ordinal",
                                        .heading = phrase("AnalysisWords", "number of the block")};
inline const ResultColumn kFirst{.id = "first", .heading = phrase("AnalysisWords", "first")};
inline const ResultColumn kSecond{.id = "second", .heading = phrase("AnalysisWords", "second")};
inline const ResultColumn kOther{.id = "other", .heading = phrase("AnalysisWords", "other")};

// Counts.
inline const ResultColumn kPersons{.id = "persons",
                                   .heading = phrase("AnalysisWords", "participants")};
inline const ResultColumn kResponses{.id = "responses",
                                     .heading = phrase("AnalysisWords", "responses")};
/// Responses that the tables of judgements count.
inline const ResultColumn kAnswers{.id = "answers",
                                   .heading = phrase("AnalysisWords", "responses")};
/// In a row for all of them.
inline const ResultColumn kAllAnswers{
    .id = "answers", .heading = phrase("AnalysisWords", "responses"), .words = words_of_repetition};
inline const ResultColumn kTrials{.id = "trials", .heading = phrase("AnalysisWords", "trials")};
inline const ResultColumn kItems{.id = "items", .heading = phrase("AnalysisWords", "items")};
inline const ResultColumn kMeasurements{.id = "measurements",
                                        .heading = phrase("AnalysisWords", "measurements")};
inline const ResultColumn kLeftOut{.id = "left_out",
                                   .heading = phrase("AnalysisWords", "left out")};
/// Of a counted part: its whole.
inline const ResultColumn kOf{.id = "of", .heading = phrase("AnalysisWords", "total")};
inline const ResultColumn kCorrect{.id = "correct", .heading = phrase("AnalysisWords", "correct")};
inline const ResultColumn kCorrectCount{.id = "right",
                                        .heading = phrase("AnalysisWords", "correct")};
inline const ResultColumn kChosen{.id = "chosen", .heading = phrase("AnalysisWords", "chosen")};
inline const ResultColumn kHits{.id = "hits", .heading = phrase("AnalysisWords", "hits")};

// Estimates.
inline const ResultColumn kValue{
    .id = "value", .heading = phrase("AnalysisWords", "value"), .digits = Digits::of_row};
inline const ResultColumn kUnit{
    .id = "unit", .heading = phrase("AnalysisWords", "unit"), .words = words_of_unit};
inline const ResultColumn kMean{.id = "mean", .heading = phrase("AnalysisWords", "mean")};
inline const ResultColumn kSd{.id = "sd", .heading = phrase("AnalysisWords", "SD")};
inline const ResultColumn kMinimum{.id = "minimum", .heading = phrase("AnalysisWords", "minimum")};
inline const ResultColumn kMedian{.id = "median", .heading = phrase("AnalysisWords", "median")};
inline const ResultColumn kMaximum{.id = "maximum", .heading = phrase("AnalysisWords", "maximum")};
inline const ResultColumn kMeanRank{.id = "mean_rank",
                                    .heading = phrase("AnalysisWords", "mean rank")};
inline const ResultColumn kShare{
    .id = "share", .heading = phrase("AnalysisWords", "proportion"), .digits = Digits::bounded};
inline const ResultColumn kChance{
    .id = "chance", .heading = phrase("AnalysisWords", "chance level"), .digits = Digits::chance};
inline const ResultColumn kDifference{.id = "difference",
                                      .heading = phrase("AnalysisWords", "difference")};
inline const ResultColumn kRatio{.id = "ratio", .heading = phrase("AnalysisWords", "ratio")};
inline const ResultColumn kTime{
    .id = "time_s", .heading = phrase("AnalysisWords", "response time"), .unit = "s"};
inline const ResultColumn kRSquared{
    .id = "r_squared", .heading = phrase("AnalysisWords", "R²"), .digits = Digits::bounded};
inline const ResultColumn kStatus{
    .id = "status", .heading = phrase("AnalysisWords", "reason"), .words = words_of_status};

// Tests.
inline const ResultColumn kP{
    .id = "p", .heading = phrase("AnalysisWords", "p"), .digits = Digits::p};
inline const ResultColumn kDf{
    .id = "df", .heading = phrase("AnalysisWords", "df"), .digits = Digits::statistic};
inline const ResultColumn kDf1{
    .id = "df1", .heading = phrase("AnalysisWords", "df₁"), .digits = Digits::statistic};
inline const ResultColumn kDf2{
    .id = "df2", .heading = phrase("AnalysisWords", "df₂"), .digits = Digits::statistic};

// Configurations and dendrograms.
inline const ResultColumn kX{.id = "x", .heading = phrase("AnalysisWords", "x")};
inline const ResultColumn kY{.id = "y", .heading = phrase("AnalysisWords", "y")};
inline const ResultColumn kDissimilarity{.id = "dissimilarity",
                                         .heading = phrase("AnalysisWords", "dissimilarity")};
inline const ResultColumn kJoin{.id = "join", .heading = phrase("AnalysisWords", "join")};
inline const ResultColumn kHeight{.id = "height", .heading = phrase("AnalysisWords", "height")};

}  // namespace asperity::columns
