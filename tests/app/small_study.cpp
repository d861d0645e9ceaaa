// Writes one texture, and composes protocols from a block and an exploration.

#include "tests/app/small_study.h"

#include "app/study_files/height_field_files.h"
#include "protocols/file/protocol_reader.h"
#include "results_schema/study.h"
#include "stimuli/heights/synthetic_surface.h"

namespace asperity {

void make_small_study(const std::filesystem::path& folder) {
  Study::create(folder, "small");
  const HeightField field =
      make_surface("noise", {}, SurfaceCanvas{.width_m = 0.02, .pixels = 128, .seed = 5});
  save_height_field(folder / "stimuli" / "grain.png", field, {.kind = "noise"}, Overwrite::refuse);
  save_picture(folder / "stimuli" / "grain_photo.png", {2, 2, {0.0F, 1.0F, 1.0F, 0.0F}},
               Overwrite::refuse);
}

std::string small_protocol(const std::string& block, const std::string& exploration) {
  return R"({
  "format": "asperity.protocol/1",
  "kind": "selection",
  "design": "improved",
  "name": "small",
  "version": "1.0.0",
  "title": "A few short trials",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "realism_standard": "photograph",
  "textures": {"grain": {"height_field": "stimuli/grain.png", "picture": "stimuli/grain_photo.png"}},
  "factors": {"model": {"levels": ["height_map", "stochastic"]}, "go": {"levels": [1, 2, 3]}},
  "stimuli": {"rendered": {"model": {"factor": "model"}, "texture": "grain"}},
  "explorations": {"short": {"minimum_contact_s": 0.5, "maximum_contact_s": 2)" +
         exploration + R"(}},
  "questions": {"remarks": {"prompt": "Anything else?", "form": "text", "optional": true},
                "comfort": {"prompt": "How is your hand?", "form": "choice", "options": ["well", "tired"]}},
  "blocks": {
    "main": {
      "crossed": ["go"],
      "presented": [
        {"stimulus": "rendered", "with": {"model": "height_map"}},
        {"stimulus": "rendered", "with": {"model": "stochastic"}}
      ],
      "question": {"name": "best", "prompt": "Which felt more like the picture?"},
      "exploration": "short")" +
         block + R"(
    }
  },
  "flow": [{"screen": "Welcome."}, {"run": "main"}, {"ask": ["comfort", "remarks"]}, {"screen": "Thank you."}]
})";
}

Protocol read_small_protocol(const ModelRegistry& models, const std::string& text) {
  return read_protocol(text, "small.json", declarations_of(models));
}

}  // namespace asperity
