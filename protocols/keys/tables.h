// Declares the tables of the objects of a protocol. Each is defined in the source of its subject.

#pragma once

#include <map>
#include <string>

#include "protocols/design/protocol.h"
#include "protocols/keys/procedure_declaration.h"
#include "protocols/shapes/key.h"

namespace asperity {

/// The keys of a protocol, of which every other table is part.
extern const KeyTableOf<Protocol> kProtocolTable;

extern const KeyTableOf<std::string> kAuthorTable;
extern const KeyTableOf<Protocol> kParticipantsTable;
extern const KeyTableOf<Protocol> kConsentTable;
extern const KeyTableOf<Protocol::Groups> kGroupsTable;
extern const KeyTableOf<Protocol::Resume> kResumeTable;
extern const KeyTableOf<ObserverDeclaration> kObserverTable;

extern const KeyTableOf<Texture> kTextureTable;
extern const KeyTableOf<ForceFeatures> kFeaturesTable;
extern const KeyTableOf<BodyDescription> kBodyTable;
extern const KeyTableOf<StimulusTemplate> kStimulusTable;
extern const KeyTableOf<EqualForce> kEqualForceTable;
extern const KeyTableOf<StimulusTemplate> kStimulusMaterialTable;
extern const KeyTableOf<Factor> kFactorTable;
extern const KeyTableOf<Exploration> kExplorationTable;
extern const KeyTableOf<Band> kBandTable;

extern const KeyTableOf<AnalysisDeclaration> kAnalysisTable;

extern const KeyTableOf<Question> kQuestionTable;
extern const KeyTableOf<Option> kOptionTable;
extern const KeyTableOf<ScaleForm> kScaleTable;
extern const KeyTableOf<AnswerCondition> kConditionTable;
extern const KeyTableOf<AnswerCondition> kTrialConditionTable;
extern const KeyTableOf<Protocol::Step> kStepTable;
extern const KeyTableOf<Protocol::Break> kBreakTable;
extern const KeyTableOf<Protocol::Break::DriftCheck> kDriftCheckTable;

extern const KeyTableOf<Protocol::Block> kBlockTable;
extern const KeyTableOf<Protocol::Block::AllPairs> kAllPairsTable;
extern const KeyTableOf<Protocol::Block::EqualRoughness> kEqualRoughnessTable;
extern const KeyTableOf<Protocol::Block::RowRepetitions> kRowRepetitionsTable;
extern const KeyTableOf<Protocol::Block::FixedPosition> kFixedPositionTable;
extern const KeyTableOf<Protocol::Presented> kPresentedTable;
extern const KeyTableOf<Protocol::Criterion> kCriterionTable;
extern const KeyTableOf<Roving> kRovingTable;
extern const KeyTableOf<Arrangement> kArrangementTable;
extern const KeyTableOf<Arrangement> kVisitsTable;
extern const KeyTableOf<Arrangement> kExposureTable;
extern const KeyTableOf<Arrangement::Interval> kIntervalTable;

extern const KeyTableOf<Protocol::TrialQuestionTemplate> kListedQuestionTable;
extern const KeyTableOf<Protocol::Block> kOnlyQuestionTable;
extern const KeyTableOf<Option> kWordTable;
extern const KeyTableOf<LineForm> kLineTable;

extern const KeyTableOf<Dimension> kDimensionTable;
extern const KeyTableOf<LevelGrid> kGridTable;
extern const KeyTableOf<ProcedureDeclaration> kProcedureTable;
extern const KeyTableOf<ProcedureDeclaration::Prior> kPriorTable;
extern const KeyTableOf<ValueRange> kRangeTable;
extern const KeyTableOf<ValueRange> kLapseRangeTable;
extern const KeyTableOf<ProcedureDeclaration::Stop> kStopTable;
extern const KeyTableOf<IntervalRule> kIntervalRuleTable;
extern const KeyTableOf<ProcedureDeclaration::Track> kTrackTable;
extern const KeyTableOf<ProcedureDeclaration::CatchTrials> kCatchTrialsTable;

extern const KeyTableOf<Protocol> kEnvironmentTable;
extern const KeyTableOf<Protocol> kSceneTable;
extern const KeyTableOf<Protocol> kPicturesTable;
extern const KeyTableOf<Protocol::Noise> kNoiseTable;

extern const KeyTableOf<InstabilityRule> kInstabilityTable;
extern const KeyTableOf<SurfacePatch> kSurfaceTable;
extern const KeyTableOf<Material> kMaterialTable;
extern const KeyTableOf<Protocol> kRecordingTable;

extern const KeyTableOf<Protocol> kDeviceTable;
/// Items of a device.
extern const KeyTableOf<std::map<std::string, double>> kDeviceLimitsTable;

}  // namespace asperity
