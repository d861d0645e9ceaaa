// Implements the conversion of heights to levels and back, and the JSON sidecar.

#include "stimuli/heights/height_field_file.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "analysis/numbers/repeated_key.h"
#include "analysis/words/phrased_error.h"
#include "stimuli/pictures/photograph.h"
#include "stimuli/pictures/picture_codecs.h"

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFieldFormat = "asperity.height_field/1";
constexpr double kLargestLevel = 65535.0;

Json provenance_json(const HeightFieldProvenance& provenance) {
  Json parameters = Json::object();
  for (const auto& [name, value] : provenance.parameters) {
    std::visit([&parameters, &key = name](const auto& v) { parameters[key] = v; }, value);
  }
  Json json{{"kind", provenance.kind}, {"parameters", parameters}};
  if (provenance.seed) json["seed"] = *provenance.seed;
  if (!provenance.source_name.empty()) {
    json["source_name"] = provenance.source_name;
    json["source_sha256"] = provenance.source_sha256;
  }
  json["program_version"] = provenance.program_version;
  return json;
}

Phrase with_remedy(const Phrase& sentence) {
  return Phrase("%1 %2").with(sentence, phrase("Stimuli", "Make the height field again."));
}

class Sidecar final {
 public:
  Sidecar(std::string_view text, std::string name) : name_(std::move(name)) {
    json_ = Json::parse(text, nullptr, false);
    if (!json_.is_object())
      refuse(phrase("Stimuli", "%1 is not a JSON object in the format %2."), format());
    if (const auto key = repeated_key<Json>(text)) {
      refuse(phrase("Stimuli", "%1 has the key \"%2\" twice in one object."), *key);
    }
    const std::string given = this->text(json_, "format");
    if (given != kFieldFormat) {
      refuse(phrase("Stimuli", "%1 has the format \"%2\"; this program reads %3."), given,
             format());
    }
  }

  /// %1 of the sentence is the name of the file.
  template <class... Values>
  [[noreturn]] void refuse(const Phrase& sentence, const Values&... values) const {
    throw PhrasedRefusal(with_remedy(sentence.with(name_, values...)));
  }

  double length_m(const char* key) const {
    const auto found = json_.find(key);
    // NaN is not valid JSON, and a number too large for a double is infinite.
    if (found == json_.end() || !found->is_number() || std::abs(found->get<double>()) > 1.0) {
      refuse(phrase("Stimuli", "%1 needs a number %2, in metres, of at most 1."), key);
    }
    return found->get<double>();
  }

  std::string sha256() const { return text(json_, "sha256"); }

  HeightFieldProvenance provenance() const {
    const auto found = json_.find("provenance");
    if (found == json_.end() || !found->is_object())
      refuse(phrase("Stimuli", "%1 needs an object provenance."));
    HeightFieldProvenance result{.kind = text(*found, "kind"),
                                 .program_version = text(*found, "program_version")};
    if (found->contains("source_name")) {
      result.source_name = text(*found, "source_name");
      result.source_sha256 = text(*found, "source_sha256");
    }
    if (const auto seed = found->find("seed"); seed != found->end()) {
      if (!seed->is_number_unsigned())
        refuse(phrase("Stimuli", "%1 has a provenance seed that is not a whole number."));
      result.seed = seed->get<std::uint64_t>();
    }
    const auto parameters = found->find("parameters");
    if (parameters == found->end() || !parameters->is_object()) {
      refuse(phrase("Stimuli", "%1 needs an object provenance/parameters."));
    }
    for (const auto& [key, value] : parameters->items()) {
      if (value.is_number()) {
        result.parameters.emplace(key, value.get<double>());
      } else if (value.is_string()) {
        result.parameters.emplace(key, value.get<std::string>());
      } else {
        refuse(phrase("Stimuli",
                      "%1 has a provenance parameter %2 that is neither a number nor a string."),
               key);
      }
    }
    return result;
  }

 private:
  static std::string format() { return std::string("\"") + kFieldFormat + "\""; }

  std::string text(const Json& object, const char* key) const {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_string()) {
      refuse(phrase("Stimuli", "%1 needs a string \"%2\"."), key);
    }
    return found->get<std::string>();
  }

  std::string name_;
  Json json_{};
};

}  // namespace

std::vector<std::byte> encode_height_field_png(const HeightField& field) {
  const HeightField::Grid& grid = field.grid();
  const double range_m = field.maximum_m() - field.minimum_m();
  const double levels_per_m = range_m > 0.0 ? kLargestLevel / range_m : 0.0;
  cv::Mat levels(static_cast<int>(grid.rows), static_cast<int>(grid.columns), CV_16UC1);
  std::transform(
      field.heights_m().begin(), field.heights_m().end(), levels.ptr<std::uint16_t>(0),
      [&](float height_m) {
        const double level = (static_cast<double>(height_m) - field.minimum_m()) * levels_per_m;
        return static_cast<std::uint16_t>(std::lround(std::clamp(level, 0.0, kLargestLevel)));
      });
  return picture_codecs().encode_png(levels, {});
}

std::string encode_height_field_sidecar(const HeightField& field,
                                        const HeightFieldProvenance& provenance,
                                        std::string_view png_sha256) {
  const Json json{{"format", kFieldFormat},
                  {"pitch_m", field.grid().pitch_m},
                  {"height_min_m", field.minimum_m()},
                  {"height_max_m", field.maximum_m()},
                  {"sha256", png_sha256},
                  {"provenance", provenance_json(provenance)}};
  // A file name may contain bytes that are not UTF-8; they are replaced, because the sidecar is always UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

StoredHeightField decode_height_field(std::span<const std::byte> png, std::string_view sidecar,
                                      const std::string& name) {
  const Sidecar json(sidecar, name + ".json");
  const double minimum_m = json.length_m("height_min_m");
  const double range_m = json.length_m("height_max_m") - minimum_m;
  const double pitch_m = json.length_m("pitch_m");
  if (pitch_m <= 0.0) json.refuse(phrase("Stimuli", "%1 has a pitch_m that is not positive."));
  if (!(range_m >= 0.0))
    json.refuse(phrase("Stimuli", "%1 has a height_max_m below its height_min_m."));

  const PictureFacts facts = inspect_picture(png, name);
  if (facts.format != PictureFormat::png || facts.bits_per_channel != 16 || facts.channels != 1) {
    throw PhrasedRefusal(with_remedy(
        phrase("Stimuli", "%1 is not a 16-bit greyscale PNG, as a height field must be.")
            .with(name)));
  }
  const GreyImage grey = decode_photograph(png, name).grey;
  std::vector<float> heights_m(grey.values.size());
  std::transform(grey.values.begin(), grey.values.end(), heights_m.begin(), [&](float brightness) {
    // A float represents level/65535 accurately enough to recover the level.
    const double level = std::round(static_cast<double>(brightness) * kLargestLevel);
    return static_cast<float>(minimum_m + level / kLargestLevel * range_m);
  });
  return {HeightField({.rows = grey.rows, .columns = grey.columns, .pitch_m = pitch_m},
                      std::move(heights_m)),
          json.provenance(), json.sha256()};
}

}  // namespace asperity
