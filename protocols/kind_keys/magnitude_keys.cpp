// Defines the keys of the analysis of estimates.

#include "protocols/kind_keys/magnitude_keys.h"

#include "analysis/numbers/number_text.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

namespace {

using nlohmann::json;
using Estimation = EstimationDeclaration;

constexpr std::array<KeyWord, 12> kPredictors{
    {{kLevelPredictor, 0, "the level itself"},
     {kValuePredictor, 0, "the values stated for the levels"},
     {"texture_force_N", 0, "the RMS texture force"},
     {"force_N", 0, "the mean normal force"},
     {"force_sd_N", 0, "the SD of the normal force"},
     {"speed_m_per_s", 0, "the mean speed"},
     {"speed_sd_m_per_s", 0, "the SD of the speed"},
     {"waves_5_to_10_mm", 0, "the force at wavelengths of 5 to 10 mm"},
     {"waves_2.5_to_5_mm", 0, "the force at wavelengths of 2.5 to 5 mm"},
     {"waves_1.25_to_2.5_mm", 0, "the force at wavelengths of 1.25 to 2.5 mm"},
     {"waves_0.625_to_1.25_mm", 0, "the force at wavelengths of 0.625 to 1.25 mm"},
     {"waves_0.3125_to_0.625_mm", 0, "the force at wavelengths of 0.3125 to 0.625 mm"}}};

constexpr ValueShape kValueOfLevel = NumberShape{};

constexpr ValueShape kStandardNumber = NumberShape{};
constexpr ValueShape kStandardText = TextShape{.longest = 64, .name = {kLevelNames}};
constexpr std::array kStandardForms{kStandardNumber, kStandardText};

void store_standard(const json& value, EstimationModulus& modulus) {
  modulus.standard =
      value.is_number() ? number_text(value.get<double>()) : value.get<std::string>();
}

constexpr auto kModulusKeys = keys_of(
    required_key(custom_key<&store_standard>(
        "standard", "Standard", "The level of the analysed factor that is the standard.",
        FormsShape{kStandardForms})),
    required_key(member_key<&EstimationModulus::value>(
        "value", "Assigned number", "The number of the standard.", NumberShape{.above = 0.0})));

constexpr std::array<KeyWord, 1> kFree{{{"free", 0, "every participant chooses a scale"}}};
constexpr ValueShape kFreeModulus = WordShape{kFree};
constexpr std::array kModulusForms{kFreeModulus, kObjectOf<kModulusTable>};

/// Without a standard or its number the modulus is free.
void store_modulus(const json& value, Estimation& estimation) {
  if (value.contains("standard") && value.contains("value")) {
    read_keys(kModulusTable, value, &estimation.modulus.emplace());
  }
}

using Normalisation = EstimateNormalisation;
constexpr auto kNormalisations = words_of<Normalisation>(
    {{"geometric_mean", Normalisation::geometric_mean, "the mean of the participant's cells"},
     {"standard", Normalisation::standard,
      "the distance of the estimates of the standard from the modulus"},
     {"none", Normalisation::none, "nothing is removed"}});

constexpr auto kEstimationKeys = keys_of(
    member_key<&Estimation::spacing>(
        "spacing", "Spacings",
        "The factor whose levels are spacings: numbers in metres, or textures with a stated "
        "spacing. Either `spacing` or `factor`.",
        NameShape{.registry = kFactorNames, .governs_levels = true, .levels = "textures"}),
    member_key<&Estimation::items>(
        "factor", "Factor",
        "The factor whose levels are the estimated stimuli, whatever they are, or the parameter "
        "that the blocks vary. Each level is an item of the responses.",
        NameShape{.registry = kFactorNames, .governs_levels = true}),
    member_key<&Estimation::predictor>(
        "predictor", "Predictor",
        "The physical quantity of the power function over a factor: the level itself, the values "
        "stated for the levels, or a property that is measured during the study (the RMS texture "
        "force, the mean and SD of the normal force or of the speed, the force in an octave of "
        "wavelength). Absent: geometric means by level, and no exponent.",
        WordShape{kPredictors}),
    member_key<&Estimation::predictor_values>(
        "values", "Values",
        "With stated values as the predictor: the value of each level, above 0. In the file the "
        "levels are in quotation marks, numbers among them in any notation.",
        MapShape{.entry = &kValueOfLevel,
                 .meaning = "The value of a level.",
                 .has_names = false,
                 .key = {kLevelNames},
                 .shortest = 1,
                 .longest = 256}),
    member_key<&Estimation::predictor_unit>(
        "unit", "Unit",
        "With the level or stated values as the predictor: its unit. Absent: that of the factor.",
        TextShape{.may_be_empty = true, .longest = 64}),
    with_standard(
        custom_key<&store_modulus>(
            "modulus", "Modulus",
            "free: every participant chooses a scale (free modulus). Otherwise a standard, which "
            "precedes the estimated surface in every trial, and the number assigned to it.",
            FormsShape{kModulusForms}),
        [](const ProtocolKey&) { return json("free"); }),
    member_key<&Estimation::stated_normalisation>(
        "normalisation", "Normalisation",
        "What is removed from the logarithms of the estimates of a participant before means and "
        "exponents are computed: the mean of the participant's cells, the distance of the "
        "estimates of the standard from the modulus, or nothing. Absent: the mean with free "
        "modulus, nothing with a standard.",
        kNormalisations),
    member_key<&Estimation::condition>(
        "condition", "Condition",
        "The factor that is constant within a block: the probe, the force, the speed.",
        kFactorName));

}  // namespace

constexpr KeyTableOf<Estimation> kEstimationTable = table_of(
    "Magnitude: the factors of the analysis of estimates, and the modulus.", kEstimationKeys);

constexpr KeyTableOf<EstimationModulus> kModulusTable =
    table_of("The standard and the number assigned to it.", kModulusKeys);

}  // namespace asperity
