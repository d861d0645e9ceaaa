// Leaves out what is a command's default.

#include "app/gui/base/command_lines.h"

#include <algorithm>

#include "analysis/numbers/number_text.h"
#include "app/device_bench/device_choice.h"
#include "app/tasks/simulation/simulation_declaration.h"
#include "app/words/shell_word.h"

namespace asperity {

namespace {

class CommandLine final {
 public:
  explicit CommandLine(const std::string& command) : text_("asperity " + command) {}

  CommandLine& word(const std::string& value) {
    text_ += ' ' + shell_word(value);
    return *this;
  }
  CommandLine& flag(const char* name, bool is_set = true) {
    if (is_set) text_ += std::string(" ") + name;
    return *this;
  }
  CommandLine& option(const char* name, const std::string& value) { return flag(name).word(value); }
  CommandLine& plugins(const std::vector<std::filesystem::path>& files) {
    for (const std::filesystem::path& file : files) option("--plugin", file.string());
    return *this;
  }
  CommandLine& level_program(const std::optional<ExternalProgram>& program) {
    if (!program) return *this;
    option("--external", program->file.string());
    // Joined: an argument may begin with "--".
    for (const std::string& argument : program->arguments) {
      word("--external-argument=" + argument);
    }
    return *this;
  }
  CommandLine& raw(const std::string& words) {
    text_ += words;
    return *this;
  }
  std::string text() const { return text_; }

 private:
  std::string text_{};
};

std::string text_of(const std::set<ExportFormat>& formats) {
  std::string text{};
  for (const ExportFormat format : formats) {
    text += (text.empty() ? "" : ",") + std::string(name_of(format));
  }
  return text.empty() ? "none" : text;
}

std::string value_text(const ParameterValue& value) {
  const double* const number = std::get_if<double>(&value);
  return number != nullptr ? number_text(*number) : std::get<std::string>(value);
}

}  // namespace

std::string check_line(const std::filesystem::path& protocol, const std::filesystem::path& study,
                       const std::vector<std::filesystem::path>& plugins) {
  return CommandLine("check")
      .word(protocol.string())
      .option("--study", study.string())
      .plugins(plugins)
      .text();
}

std::string simulate_line(const SimulationInputs& inputs,
                          const std::vector<std::filesystem::path>& plugins) {
  CommandLine line("simulate");
  for (const std::filesystem::path& protocol : inputs.protocols) line.word(protocol.string());
  line.option("--study", inputs.study.string())
      .option("--participants", std::to_string(inputs.participants))
      .option("--seed", std::to_string(inputs.seed));
  if (inputs.device != SimulationInputs{}.device) line.option("--device", inputs.device);
  if (inputs.recordings != SimulationInputs{}.recordings) {
    line.option("--recordings", text_of(inputs.recordings));
  }
  return line.level_program(inputs.level_program)
      .flag("--resume", inputs.resume)
      .plugins(plugins)
      .text();
}

std::string run_line(const RunInputs& inputs, const std::vector<std::filesystem::path>& plugins) {
  CommandLine line("run");
  line.word(inputs.protocol.string())
      .option("--study", inputs.study.string())
      .option("--participant", inputs.participant);
  if (inputs.device != RunInputs{}.device) {
    line.option("--device", inputs.device).raw(as_command_options(inputs.driver_options));
  }
  if (inputs.resume) {
    line.flag("--resume");
    if (!inputs.late_reason.empty()) line.option("--late-reason", inputs.late_reason);
  } else {
    line.option("--seed", std::to_string(inputs.seed));
    if (inputs.group) line.option("--group", *inputs.group);
  }
  if (inputs.is_virtual) {
    line.flag("--virtual").flag("--realtime", inputs.pacing == RunPacing::real_time);
  } else if (inputs.mode == SessionMode::pilot) {
    line.option("--mode", "pilot");
  }
  return line.level_program(inputs.level_program).plugins(plugins).text();
}

std::string analyze_line(const std::filesystem::path& study,
                         const std::optional<std::string>& protocol) {
  CommandLine line("analyze");
  line.word(study.string());
  if (protocol) line.option("--protocol", *protocol);
  return line.text();
}

std::string synth_line(const std::string& kind, const ParameterValues& given,
                       const SurfaceCanvas& canvas, const std::filesystem::path& out) {
  CommandLine line("synth");
  line.word(kind).option("--out", out.string());
  for (const auto& [name, value] : given) line.option("--param", name + '=' + value_text(value));
  const SurfaceCanvas usual{};
  if (canvas.width_m != usual.width_m) line.option("--width-m", number_text(canvas.width_m));
  if (canvas.pixels != usual.pixels) line.option("--pixels", std::to_string(canvas.pixels));
  if (canvas.seed != usual.seed) line.option("--seed", std::to_string(canvas.seed));
  return line.text();
}

std::string texture_line(const std::filesystem::path& photograph, const TextureRecipe& recipe,
                         const std::filesystem::path& out) {
  CommandLine line("texture");
  line.word(photograph.string()).option("--out", out.string());
  const ParameterValues usual = parameter_values(TextureRecipe{});
  for (const auto& [name, value] : parameter_values(recipe)) {
    const auto found = usual.find(name);
    if (name != "width_m" && found != usual.end() && found->second == value) continue;
    std::string option = "--" + name;
    std::replace(option.begin(), option.end(), '_', '-');
    line.option(option.c_str(), value_text(value));
  }
  return line.text();
}

std::string rename_stimulus_line(const std::filesystem::path& stimulus, const std::string& name) {
  return CommandLine("stimulus").word(stimulus.string()).option("--rename", name).text();
}

std::string delete_stimulus_line(const std::filesystem::path& stimulus) {
  return CommandLine("stimulus").word(stimulus.string()).flag("--delete").text();
}

std::string copy_stimuli_line(const std::vector<std::filesystem::path>& stimuli,
                              const std::filesystem::path& study) {
  CommandLine line("stimulus");
  for (const std::filesystem::path& stimulus : stimuli) line.word(stimulus.string());
  return line.option("--copy-to", study.string()).text();
}

std::string use_rendering_line(const std::filesystem::path& rendering,
                               const std::filesystem::path& protocol, const RenderingPlace& place,
                               const std::vector<std::filesystem::path>& plugins) {
  CommandLine line("stimulus");
  line.word(rendering.string()).option("--use-in", protocol.string());
  if (place.replaced) line.option("--replace", *place.replaced);
  return line.flag("--keep-texture", place.keeps_texture)
      .option("--out", protocol.string())
      .flag("--force")
      .plugins(plugins)
      .text();
}

std::string power_line(const PowerLine& power, const std::vector<std::filesystem::path>& plugins) {
  CommandLine line("power");
  line.word(power.protocol.string())
      .option("--participants", std::to_string(power.participants))
      .option("--seed", std::to_string(power.seed))
      .option("--runs", std::to_string(power.runs));
  for (const auto& [name, value] : power.effects) {
    line.option("--effect", name + '=' + number_text(value));
  }
  for (const auto& [name, value] : power.assumed) {
    line.option("--assume", name + '=' + number_text(value));
  }
  return line.plugins(plugins).text();
}

std::string report_line(const std::filesystem::path& study, const std::filesystem::path& out) {
  return CommandLine("report").word(study.string()).option("--out", out.string()).text();
}

std::string export_line(const std::filesystem::path& study, const std::filesystem::path& out,
                        const ExportOptions& options) {
  CommandLine line("export");
  line.word(study.string())
      .option("--out", out.string())
      .flag("--public", is_public(options.audience))
      .flag("--relabel", options.audience == ExportAudience::relabelled)
      .flag("--age-bands", options.has_age_bands);
  if (options.formats != usual_export_formats()) line.option("--formats", text_of(options.formats));
  return line.text();
}

}  // namespace asperity
