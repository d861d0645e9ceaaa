// Holds the table of measured quantities, and converts profiles to JSON and back.

#include "app/profiles/device_profile.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "analysis/numbers/repeated_key.h"
#include "app/words/coded_phrases.h"
#include "app/words/device_remarks.h"
#include "app/words/utc_time.h"
#include "device/simulated_models.h"
#include "results_schema/error_text.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/files/folder_entries.h"

namespace asperity {
namespace {

constexpr const char* kProfileFormat = "asperity.device_profile/1";

using Bound = DeviceItem::Bound;
constexpr DeviceQuantity mechanical(const char* name, DeviceTrait trait,
                                    Bound bound = Bound::at_most) {
  return {.name = name, .bound = bound, .trait = trait};
}
constexpr std::array<DeviceQuantity, 16> kDeviceQuantities{
    {{"rate_Hz", Bound::at_least, true},  // of the loop, independent of the device
     {"lateness_p50_s", Bound::at_most, true},
     {"lateness_p99_s", Bound::at_most, true},
     {"lateness_max_s", Bound::at_most, true},
     {"missed_deadlines", Bound::at_most, true},
     {"force_zero_N", Bound::at_most, false, false},
     mechanical("position_noise_m", DeviceTrait::position_noise),
     mechanical("friction_N", DeviceTrait::friction),
     mechanical("damping_N_s_per_m", DeviceTrait::damping, Bound::at_least),
     mechanical("position_resolution_m", DeviceTrait::position_step),
     mechanical("latency_s", DeviceTrait::latency),
     mechanical("moving_mass_kg", DeviceTrait::moving_mass),
     mechanical("resonance_Hz", DeviceTrait::resonance, Bound::at_least),
     mechanical("stiffness_N_per_m", DeviceTrait::stiffness, Bound::at_least),
     mechanical("force_resolution_N", DeviceTrait::force_resolution),
     {"workspace_reached", Bound::at_least}}};

/// Items without a number.
constexpr std::array<std::string_view, 4> kDoneOrNot{
    "limiter", "zero_after_stop", "zero_after_not_finite", "zero_without_heartbeat"};

nlohmann::ordered_json or_null(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

nlohmann::ordered_json corner(const glm::dvec3& p) {
  return nlohmann::ordered_json::array({p.x, p.y, p.z});
}

nlohmann::ordered_json or_null(const std::optional<glm::dvec3>& p) {
  return p ? corner(*p) : nlohmann::ordered_json();
}

nlohmann::ordered_json json_of_item(const DeviceItem& item) {
  nlohmann::ordered_json json{{"name", item.name},
                              {"status", text_of(item.status)},
                              {"result", outcome_of(item)},
                              {"value", or_null(item.value)},
                              {"limit", or_null(item.limit)}};
  if (item.limit) {
    json["bound"] = item.bound == DeviceItem::Bound::at_most ? "at_most" : "at_least";
  }
  if (!item.by_axis.empty()) json["by_axis"] = item.by_axis;
  json["text"] = item.text.english();
  json["remark"] = json_of(item.text);
  return json;
}

std::optional<double> number_or_nothing(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return {};
  return found->get<double>();
}

glm::dvec3 corner_in(const nlohmann::json& corner) {
  return {corner.at(0).get<double>(), corner.at(1).get<double>(), corner.at(2).get<double>()};
}

std::optional<glm::dvec3> corner_or_nothing(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return {};
  return corner_in(*found);
}

DeviceItem::Status status_from(const std::string& text) {
  for (const auto status :
       {DeviceItem::Status::pass, DeviceItem::Status::fail, DeviceItem::Status::not_measured}) {
    if (text == text_of(status)) return status;
  }
  throw std::runtime_error("status is \"" + text + "\"; it must be pass, fail or not_measured");
}

DeviceItem item_from(const nlohmann::json& json) {
  DeviceItem item{};
  item.name = json.at("name").get<std::string>();
  item.status = status_from(json.at("status").get<std::string>());
  item.value = number_or_nothing(json, "value");
  const bool is_done_or_not =
      std::find(kDoneOrNot.begin(), kDoneOrNot.end(), item.name) != kDoneOrNot.end();
  if (!is_done_or_not && device_quantity(item.name) == nullptr) {
    throw std::runtime_error(
        "the item \"" + item.name +
        "\" is unknown to this program (docs/formats/device_profile.md lists the known items)");
  }
  if (item.value && *item.value < 0.0) {
    throw std::runtime_error("the item " + item.name + " is " + std::to_string(*item.value) +
                             "; it must be at least 0");
  }
  item.limit = number_or_nothing(json, "limit");
  if (json.value("bound", "at_most") == "at_least") item.bound = DeviceItem::Bound::at_least;
  item.by_axis = json.value("by_axis", std::vector<double>{});
  item.text = phrase_from(nlohmann::ordered_json(json.at("remark")));
  return item;
}

nlohmann::ordered_json json_of_response(const AxisResponse& response) {
  std::vector<double> frequencies_Hz{};
  std::vector<double> responses_m_per_N{};
  for (const FrequencyResponse& tone : response.tones) {
    frequencies_Hz.push_back(tone.frequency_Hz);
    responses_m_per_N.push_back(tone.response_m_per_N);
  }
  return {{"axis", response.axis},
          {"frequency_Hz", frequencies_Hz},
          {"response_m_per_N", responses_m_per_N}};
}

AxisResponse response_from(const nlohmann::json& json) {
  const auto frequencies_Hz = json.at("frequency_Hz").get<std::vector<double>>();
  const auto responses_m_per_N = json.at("response_m_per_N").get<std::vector<double>>();
  if (frequencies_Hz.size() != responses_m_per_N.size()) {
    throw std::runtime_error("the numbers of frequencies (" +
                             std::to_string(frequencies_Hz.size()) + ") and of values (" +
                             std::to_string(responses_m_per_N.size()) +
                             ") of a response must be equal");
  }
  AxisResponse response{.axis = json.at("axis").get<std::string>()};
  for (std::size_t i = 0; i < frequencies_Hz.size(); ++i) {
    response.tones.push_back({frequencies_Hz[i], responses_m_per_N[i]});
  }
  return response;
}

nlohmann::ordered_json trait_names(const std::vector<DeviceTrait>& traits) {
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const DeviceTrait trait : traits) names.push_back(name_of(trait));
  return names;
}

/// The traits that the profile gives as unknown of the device that a simulated one models.
std::vector<DeviceTrait> not_known_in(const nlohmann::json& stands_for) {
  std::vector<DeviceTrait> traits{};
  for (const nlohmann::json& name : stands_for.at("not_known")) {
    const auto* const found = std::find_if(
        kDeviceTraits.begin(), kDeviceTraits.end(),
        [&name](DeviceTrait trait) { return name_of(trait) == name.get<std::string>(); });
    if (found == kDeviceTraits.end()) {
      throw std::runtime_error("stands_for names " + name.dump() +
                               ", which is not a property of a device");
    }
    traits.push_back(*found);
  }
  return traits;
}

/// The device of a profile; members are empty where the text cannot be read or lacks them.
WhichDevice device_in(const std::string& text) {
  WhichDevice found{};
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  const auto device = json.find("device");
  if (!json.is_object() || device == json.end() || !device->is_object()) return found;
  const auto read = [&device](const char* key, std::string& into) {
    const auto told = device->find(key);
    if (told != device->end() && told->is_string()) into = told->get<std::string>();
  };
  read("name", found.name);
  read("model", found.model);
  read("serial", found.serial);
  return found;
}

/// Replaces characters that are not permitted in a file name.
std::string for_file_name(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) {
        return !((c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'));
      },
      '_');
  return text;
}

}  // namespace

const char* text_of(DeviceItem::Status status) noexcept {
  switch (status) {
    case DeviceItem::Status::pass:
      return "pass";
    case DeviceItem::Status::fail:
      return "fail";
    case DeviceItem::Status::not_measured:
      return "not_measured";
  }
  return "unknown";
}

const char* outcome_of(const DeviceItem& item) noexcept {
  if (item.is_only_told()) return "no limit";
  return item.status == DeviceItem::Status::not_measured ? "not measured" : text_of(item.status);
}

std::span<const DeviceQuantity> device_quantities() noexcept { return kDeviceQuantities; }

const DeviceQuantity* device_quantity(std::string_view name) noexcept {
  const auto found =
      std::find_if(kDeviceQuantities.begin(), kDeviceQuantities.end(),
                   [name](const DeviceQuantity& quantity) { return name == quantity.name; });
  return found == kDeviceQuantities.end() ? nullptr : &*found;
}

std::optional<double> UsualLimits::of(std::string_view item) const noexcept {
  constexpr double kSlowest = 0.95;  // of the requested rate
  if (item == "force_zero_N") return 0.0;
  if (item == "workspace_reached") return 0.8;
  if (is_simulated) return {};  // its timing characterises the computer
  if (item == "rate_Hz") return kSlowest * rate_Hz;
  if (item == "lateness_p99_s") return 1.0 / rate_Hz;
  return {};
}

bool keeps(double value, DeviceItem::Bound bound, double limit) noexcept {
  return bound == DeviceItem::Bound::at_most ? value <= limit : value >= limit;
}

const DeviceItem* DeviceProfile::item(std::string_view wanted) const noexcept {
  const auto found = std::find_if(items.begin(), items.end(),
                                  [&](const DeviceItem& one) { return one.name == wanted; });
  return found == items.end() ? nullptr : &*found;
}

std::optional<double> DeviceProfile::value(std::string_view wanted) const noexcept {
  const DeviceItem* const found = item(wanted);
  return found == nullptr ? std::nullopt : found->value;
}

bool DeviceProfile::has_failed() const noexcept {
  return std::any_of(items.begin(), items.end(),
                     [](const DeviceItem& one) { return one.status == DeviceItem::Status::fail; });
}

bool DeviceProfile::has_open_limit() const noexcept {
  return std::any_of(items.begin(), items.end(),
                     [](const DeviceItem& one) { return one.is_open(); });
}

std::string DeviceProfile::stands_for() const { return std::string(model_stood_for(model)); }

std::vector<DeviceTrait> DeviceProfile::known() const {
  return traits_without(kDeviceTraits, not_known);
}

bool DeviceProfile::is_unknown(std::string_view wanted) const noexcept {
  const DeviceQuantity* const quantity = device_quantity(wanted);
  return quantity != nullptr && quantity->trait &&
         std::find(not_known.begin(), not_known.end(), *quantity->trait) != not_known.end();
}

void leave_out_unknown(DeviceProfile& profile) {
  for (DeviceItem& item : profile.items) {
    if (!profile.is_unknown(item.name)) continue;
    item.status = DeviceItem::Status::not_measured;
    item.value.reset();
    item.by_axis.clear();
    item.text = phrase_of(DeviceRemark::not_known).with(profile.stands_for());
  }
  // The responses depend on the moving mass and its support.
  if (profile.is_unknown("resonance_Hz")) profile.responses.clear();
}

std::string json_text_of(const DeviceProfile& profile) {
  nlohmann::ordered_json items = nlohmann::ordered_json::array();
  for (const DeviceItem& item : profile.items) items.push_back(json_of_item(item));
  nlohmann::ordered_json json{
      {"format", kProfileFormat},
      {"device", {{"name", profile.name}, {"model", profile.model}, {"serial", profile.serial}}},
      {"simulated", profile.is_simulated}};
  if (!profile.stands_for().empty()) {
    json["stands_for"] = {{"model", profile.stands_for()},
                          {"known", trait_names(profile.known())},
                          {"not_known", trait_names(profile.not_known)}};
  }
  json["measured_utc"] = profile.measured_utc;
  json["program_version"] = profile.program_version;
  json["program_commit"] = profile.program_commit;
  json["rate_Hz"] = profile.rate_Hz;
  json["scheduling"] = profile.scheduling;
  json["force_N"] = profile.force_N;
  json["workspace_minimum_m"] = corner(profile.workspace_minimum_m);
  json["workspace_maximum_m"] = corner(profile.workspace_maximum_m);
  json["reached_minimum_m"] = or_null(profile.reached_minimum_m);
  json["reached_maximum_m"] = or_null(profile.reached_maximum_m);
  json["items"] = std::move(items);
  for (const AxisResponse& response : profile.responses) {
    json["responses"].push_back(json_of_response(response));
  }
  return json.dump(2) + '\n';
}

DeviceProfile profile_from_json(const std::string& text, const std::string& origin) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    if (const auto key = repeated_key<nlohmann::json>(text)) {
      throw std::runtime_error("it has the key \"" + *key + "\" twice in one object");
    }
    if (json.at("format") != kProfileFormat) {
      throw std::runtime_error("format is " + json.at("format").dump() + "; this program reads \"" +
                               kProfileFormat + "\"");
    }
    DeviceProfile profile{};
    const nlohmann::json& device = json.at("device");
    profile.name = device.at("name").get<std::string>();
    profile.model = device.at("model").get<std::string>();
    profile.serial = device.at("serial").get<std::string>();
    profile.is_simulated = json.at("simulated").get<bool>();
    profile.measured_utc = json.at("measured_utc").get<std::string>();
    (void)days_since_1970(profile.measured_utc);
    profile.program_version = json.at("program_version").get<std::string>();
    profile.program_commit = json.at("program_commit").get<std::string>();
    profile.rate_Hz = json.at("rate_Hz").get<double>();
    if (!(profile.rate_Hz > 0.0)) {
      throw std::runtime_error("rate_Hz is " + json.at("rate_Hz").dump() + "; it must be above 0");
    }
    profile.scheduling = json.at("scheduling").get<std::string>();
    profile.force_N = json.at("force_N").get<double>();
    profile.workspace_minimum_m = corner_in(json.at("workspace_minimum_m"));
    profile.workspace_maximum_m = corner_in(json.at("workspace_maximum_m"));
    profile.reached_minimum_m = corner_or_nothing(json, "reached_minimum_m");
    profile.reached_maximum_m = corner_or_nothing(json, "reached_maximum_m");
    for (const nlohmann::json& item : json.at("items")) profile.items.push_back(item_from(item));
    for (const nlohmann::json& response : json.value("responses", nlohmann::json::array())) {
      profile.responses.push_back(response_from(response));
    }
    if (!profile.stands_for().empty()) profile.not_known = not_known_in(json.at("stands_for"));
    return profile;
  } catch (const nlohmann::json::exception&) {
    throw std::runtime_error(
        "the device profile " + origin +
        " cannot be read: it is not JSON of the form that this program writes; "
        "measure the device again");
  } catch (const std::exception& error) {
    throw std::runtime_error("the device profile " + origin + " cannot be read: " +
                             message_of(error) + "; measure the device again");
  }
}

std::filesystem::path profile_path(const std::filesystem::path& study,
                                   const DeviceProfile& profile) {
  std::string when = profile.measured_utc.substr(0, 19) + 'Z';
  std::erase_if(when, [](char c) { return c == '-' || c == ':'; });
  // Simulated models of one driver are distinguished by the device that they model.
  const std::string stands_for = profile.stands_for();
  const std::string model = stands_for.empty() ? "" : '-' + for_file_name(stands_for);
  const std::string serial = profile.serial.empty() ? "" : '-' + for_file_name(profile.serial);
  return study / "profiles" / (for_file_name(profile.name) + model + serial + '-' + when + ".json");
}

KeptProfiles profiles_in(const std::filesystem::path& study, const WhichDevice& device) {
  KeptProfiles kept{};
  const auto differs = [](const std::string& wanted, const std::string& found) {
    return !wanted.empty() && !found.empty() && wanted != found;
  };
  for (const auto& entry : entries_in(study / "profiles")) {
    if (entry.path().extension() != ".json") continue;
    try {
      const std::string text = read_file(entry.path(), kProfileFile);
      // First: problems of a profile of another device, by a later version, are not reported here.
      const WhichDevice found = device_in(text);
      if (differs(device.name, found.name) || differs(device.model, found.model) ||
          differs(device.serial, found.serial)) {
        continue;
      }
      kept.profiles.push_back(profile_from_json(text, entry.path().string()));
    } catch (const std::exception& error) {
      kept.complaints.push_back(message_of(error));
    }
  }
  std::sort(kept.complaints.begin(), kept.complaints.end());
  // Dates in this format sort as text.
  std::sort(kept.profiles.begin(), kept.profiles.end(),
            [](const DeviceProfile& a, const DeviceProfile& b) {
              return a.measured_utc > b.measured_utc;
            });
  return kept;
}

std::optional<DeviceProfile> latest_profile(const std::filesystem::path& study,
                                            const WhichDevice& device) {
  KeptProfiles kept = profiles_in(study, device);
  if (!kept.complaints.empty()) throw std::runtime_error(kept.complaints.front());
  if (kept.profiles.empty()) return {};
  return std::move(kept.profiles.front());
}

double age_days(const DeviceProfile& profile, const std::string& now_utc) {
  return days_since_1970(now_utc) - days_since_1970(profile.measured_utc);
}

}  // namespace asperity
