#include "protocols/file/setting_from_json.h"

#include <string>

#include <nlohmann/json.hpp>

#include "protocols/file/json_reading.h"
#include "protocols/keys/device_keys.h"
#include "protocols/keys/reading.h"

namespace asperity {

namespace {

using nlohmann::json;

void read_senses(const json& environment, Protocol& protocol) {
  read_choice(environment, "vision", protocol.vision,
              {{"free", Vision::free},
               {"hand_occluded", Vision::hand_occluded},
               {"blindfold", Vision::blindfold}});
  if (const auto scene = environment.find("scene"); scene != environment.end()) {
    protocol.scene.emplace();
    read_choice(*scene, "visual_texture", *protocol.scene,
                {{"on", VisualTexture::on},
                 {"off", VisualTexture::off},
                 {"neutral", VisualTexture::neutral}});
  }
  if (const auto pictures = environment.find("pictures"); pictures != environment.end()) {
    read_choice(*pictures, "show", protocol.shows_pictures_in_grey,
                {{"as_they_are", false}, {"grey", true}});
  }
  if (const auto noise = environment.find("masking_noise"); noise != environment.end()) {
    using Kind = Protocol::Noise::Kind;
    read_choice(*noise, "kind", protocol.masking_noise.kind,
                {{"none", Kind::none}, {"white", Kind::white}, {"pink", Kind::pink}});
    read(*noise, "level_dBA", protocol.masking_noise.level_dBA);
  }
  for_each_named(environment, "speech", [&](const std::string& cue, const json& path) {
    protocol.speech[cue] = path.get<std::string>();
  });
}

}  // namespace

void read_setting(const nlohmann::json& root, Protocol& protocol) {
  if (const auto found = root.find("environment"); found != root.end()) {
    read_senses(*found, protocol);
  }
  if (const auto found = root.find("device"); found != root.end()) {
    read_keys(device_keys(), *found, "/device", protocol);
  }
  if (const auto found = root.find("instability"); found != root.end()) {
    using OnExcess = InstabilityRule::OnExcess;
    InstabilityRule rule{};
    read(*found, "buzz_max", rule.buzz_max);
    read_choice(*found, "on", rule.on,
                {{"flag", OnExcess::flag}, {"repeat_now", OnExcess::repeat_now}});
    protocol.instability = rule;
  }
  if (const auto found = root.find("surface"); found != root.end()) {
    SurfacePatch& patch = protocol.patch;
    if (const auto centre = found->find("centre_m"); centre != found->end()) {
      patch.centre_m = {centre->at(0), centre->at(1), centre->at(2)};
    }
    if (const auto extent = found->find("extent_m"); extent != found->end()) {
      patch.extent_m = {extent->at(0), extent->at(1)};
    }
    read_choice(
        *found, "tiling", patch.tiling,
        {{"bounded", Tiling::bounded}, {"repeat", Tiling::repeat}, {"mirror", Tiling::mirror}});
    read_choice(*found, "edge", patch.edge, {{"wall", PatchEdge::wall}, {"fade", PatchEdge::fade}});
    read(*found, "edge_width_m", patch.edge_width_m);
    read(*found, "motion_scale", patch.motion_scale);
  }
  if (const auto found = root.find("material"); found != root.end()) {
    read(*found, "stiffness_N_per_m", protocol.material.stiffness_N_per_m);
    read(*found, "friction", protocol.material.friction);
  }
}

}  // namespace asperity
