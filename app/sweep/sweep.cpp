// Computes missing rows on several threads, appends them to the table, and fits a curve to each level.

#include "app/sweep/sweep.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/parameter_json.h"
#include "renderers/offline/drop_point.h"

namespace asperity {

namespace {

constexpr auto kBetweenWrites = std::chrono::seconds(1);

const char* text_of_tip(TipForm form) noexcept {
  switch (form) {
    case TipForm::point:
      return "point";
    case TipForm::sphere:
      return "sphere";
    case TipForm::disc:
      return "disc";
  }
  return "";
}

RoughnessStroke at_level(const SweepOrder& order, double value) {
  RoughnessStroke stroke = order.stroke;
  switch (order.varied) {
    case VariedQuantity::probe_diameter:
      stroke.tip.diameter_m = value;
      break;
    case VariedQuantity::applied_force:
      stroke.force_N = value;
      break;
    case VariedQuantity::exploratory_speed:
      stroke.speed_m_per_s = value;
      break;
    case VariedQuantity::turning:
      stroke.turning->amplitude_rad = value;
      break;
  }
  return stroke;
}

bool has_effect(const SweepOrder& order) {
  return depends_on(*order.stroke.model, order.stroke.parameters, order.varied);
}

double log10_frequency(const SweepRow& row) { return -std::log10(row.spacing_m); }

/// Whether the declaration next to a table is that of this sweep.
bool has_declaration(const std::filesystem::path& table, const SweepOrder& order) {
  const std::filesystem::path beside = declaration_beside(table);
  return std::filesystem::exists(beside) &&
         read_file(beside, kOptionsFile) == declaration_of(order);
}

/// The state of one sweep, and its file.
class SweepWork final {
 public:
  SweepWork(Sweep sweep, const Shard& shard, const SweepFile* file, const std::stop_token& stop,
            const std::function<void(double)>& progress)
      : order_(sweep.order), shard_(shard), file_(file), stop_(stop), progress_(progress) {
    is_declared_ = file_ != nullptr && has_declaration(file_->out, order_);
    rows_.resize(order_.values.size() * order_.spacings_m.size());
    for (std::size_t i = 0; i < order_.values.size(); ++i) {
      for (std::size_t j = 0; j < order_.spacings_m.size(); ++j) {
        const SweepRow* known = sweep.find(order_.values[i], order_.spacings_m[j]);
        if (known != nullptr) at(i, j) = *known;
      }
    }
  }

  Sweep done(int jobs) {
    {
      std::vector<std::jthread> workers{};
      for (int job = 1; job < jobs; ++job) workers.emplace_back([this] { work(); });
      work();
    }
    if (failure_) std::rethrow_exception(failure_);
    if (file_ != nullptr && is_new_) write();
    return so_far();
  }

 private:
  std::optional<SweepRow>& at(std::size_t value, std::size_t spacing) {
    return rows_[value * order_.spacings_m.size() + spacing];
  }

  void work() {
    while (!stop_.stop_requested() && !failed_) {
      const std::size_t spacing = next_++;
      if (spacing >= order_.spacings_m.size()) return;
      if (!shard_.has(spacing)) continue;
      try {
        drag_over(spacing);
      } catch (const std::invalid_argument& error) {
        fail(std::make_exception_ptr(std::invalid_argument("over the spacing " +
                                                           number_text(order_.spacings_m[spacing]) +
                                                           " m: " + error.what())));
      } catch (...) {
        fail(std::current_exception());
      }
    }
  }

  void fail(const std::exception_ptr& failure) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = failure;
    failed_ = true;
  }

  void drag_over(std::size_t spacing) {
    std::vector<std::size_t> missing{};
    for (std::size_t value = 0; value < order_.values.size(); ++value) {
      if (!at(value, spacing)) missing.push_back(value);
    }
    if (missing.empty()) return;
    const double spacing_m = order_.spacings_m[spacing];
    const TextureAtSpacing texture = texture_at_spacing(order_.texture, spacing_m);
    if (!has_effect(order_)) {
      const std::optional<DragResult> result = dragged(order_.stroke, texture, stop_);
      if (!result) return;
      SweepRow row{.spacing_m = spacing_m, .status = kNoEffectByConstruction};
      if (result->status == DragStatus::ok) {
        row.roughness = result->roughness;
        row.turning = result->turning;
      }
      for (const std::size_t value : missing) {
        row.value = order_.values[value];
        keep(value, spacing, row);
      }
      return;
    }
    for (const std::size_t value : missing) {
      const std::optional<DragResult> result =
          dragged(at_level(order_, order_.values[value]), texture, stop_);
      if (!result) return;
      keep(value, spacing,
           {.value = order_.values[value],
            .spacing_m = spacing_m,
            .roughness = result->roughness,
            .turning = result->turning,
            .status = text_of(result->status)});
    }
  }

  void keep(std::size_t value, std::size_t spacing, const SweepRow& row) {
    const std::lock_guard lock(mutex_);
    at(value, spacing) = row;
    is_new_ = true;
    const auto now = std::chrono::steady_clock::now();
    if (file_ != nullptr && now - written_ > kBetweenWrites) {
      write();
      written_ = now;
    }
    if (progress_) {
      const auto there = std::count_if(rows_.begin(), rows_.end(),
                                       [](const auto& one) { return one.has_value(); });
      progress_(static_cast<double>(there) / static_cast<double>(number_of_rows()));
    }
  }

  /// Of the shard.
  std::size_t number_of_rows() const {
    return order_.values.size() * shard_.number_of(order_.spacings_m.size());
  }

  Sweep so_far() const {
    Sweep sweep{.order = order_};
    for (const std::optional<SweepRow>& row : rows_) {
      if (row) sweep.rows.push_back(*row);
    }
    sweep.is_complete = sweep.rows.size() == number_of_rows();
    return sweep;
  }

  // The table never exists with the declaration of another sweep, to which it would be attributed.
  void write() {
    const std::string table = tsv_of(table_of(so_far()));
    if (is_declared_) {
      write_file(file_->out, table, Overwrite::allow);
    } else {
      write_files_together(
          {{declaration_beside(file_->out), declaration_of(order_)}, {file_->out, table}},
          Overwrite::allow);
      is_declared_ = true;
    }
    is_new_ = false;
  }

  SweepOrder order_;
  Shard shard_{};
  const SweepFile* file_ = nullptr;
  std::stop_token stop_;
  const std::function<void(double)>& progress_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_{};  // guards the following members, except for rows that no other job uses
  std::vector<std::optional<SweepRow>> rows_{};
  bool is_new_ = false;
  bool is_declared_ = false;  ///< its declaration is on disk
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
  std::exception_ptr failure_{};
};

bool is_shown(const MeasureEntry& entry, const SweepOrder& order) {
  return !entry.is_of_turning || order.stroke.turning;
}

/// The rows of a table that `table_of` made.
Sweep sweep_in(const std::string& text, const SweepOrder& order, const std::string& name) {
  Sweep sweep{.order = order};
  const Table table = read_tsv(text, name);
  if (table.columns != table_of(sweep).columns) {
    throw std::runtime_error(name +
                             " does not have the columns of a sweep; use --force to replace it");
  }
  const auto cell = [&table](const std::vector<Cell>& row, const char* column) -> const Cell& {
    const auto found = std::find(table.columns.begin(), table.columns.end(), column);
    return row[static_cast<std::size_t>(found - table.columns.begin())];
  };
  const auto number = [&](const std::vector<Cell>& row, const char* column) {
    const auto* words = std::get_if<std::string>(&cell(row, column));
    return words != nullptr ? number_in(*words) : std::nullopt;
  };
  for (const std::vector<Cell>& row : table.rows) {
    const std::optional<double> value = number(row, "value");
    const std::optional<double> spacing_m = number(row, "spacing_m");
    const auto* status = std::get_if<std::string>(&cell(row, "status"));
    if (!value || !spacing_m || status == nullptr) {
      throw std::runtime_error(
          name + " has a row that was not written by a sweep; use --force to replace it");
    }
    SweepRow read{.value = *value, .spacing_m = *spacing_m, .status = *status};
    for (const MeasureEntry& entry : sweep_measures()) {
      if (!is_shown(entry, order)) continue;
      if (const std::optional<double> measured = number(row, entry.column)) {
        entry.set(read, *measured);
      }
    }
    sweep.rows.push_back(std::move(read));
  }
  return sweep;
}

}  // namespace

const SweepRow* Sweep::find(double value, double spacing_m) const noexcept {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const SweepRow& row) {
    return row.value == value && row.spacing_m == spacing_m;
  });
  return found == rows.end() ? nullptr : &*found;
}

bool spacing_has_effect(const SweepOrder& order) {
  return order.asset_sha256.empty() || order.stroke.model->declaration.needs_height_field;
}

std::vector<SweepCurve> curves_of(const Sweep& sweep, SweepMeasure measure) {
  std::vector<SweepCurve> curves{};
  for (const double value : sweep.order.values) {
    SweepCurve& curve = curves.emplace_back(SweepCurve{.value = value});
    std::vector<double> x{};
    std::vector<double> y{};
    for (const SweepRow& row : sweep.rows) {
      const std::optional<double> log10 = log10_of(row, measure);
      const bool counts = row.status == "ok" || row.status == kNoEffectByConstruction;
      if (row.value != value || !counts || !log10) continue;
      curve.fitted.push_back(row);
      x.push_back(log10_frequency(row));
      y.push_back(*log10);
    }
    if (x.size() < 3 || !spacing_has_effect(sweep.order)) continue;
    curve.fit = curve_fit({.x = x, .log10 = y});
    const auto greatest =
        static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
    if (greatest > 0 && greatest + 1 < y.size()) {
      curve.greatest_at_m = curve.fitted[greatest].spacing_m;
    }
  }
  return curves;
}

std::optional<double> drop_point_at(const SweepOrder& order, double value) {
  const RoughnessStroke& stroke = order.stroke;
  if (stroke.model == nullptr || !stroke.model->declaration.needs_bodies || stroke.tool) {
    return std::nullopt;
  }
  RigidTip tip = stroke.tip;
  if (order.varied == VariedQuantity::probe_diameter) tip.diameter_m = value;
  return drop_point_m(order.texture, tip);
}

std::vector<double> usual_values(VariedQuantity varied) {
  switch (varied) {
    case VariedQuantity::probe_diameter:
      return {0.001, 0.002, 0.003};
    case VariedQuantity::applied_force:
      return {0.25, 0.5, 1.0};
    case VariedQuantity::exploratory_speed:
      return {0.05, 0.1, 0.2};
    case VariedQuantity::turning:
      return {0.1, 0.2, 0.4};
  }
  return {};
}

std::vector<double> logarithmic_spacings(double from_m, double to_m, int count) {
  if (!(from_m > 0.0 && to_m > from_m && std::isfinite(to_m)) || count < 2) {
    throw std::invalid_argument(
        "the first spacing is " + number_text(from_m) + " m, the last one is " + number_text(to_m) +
        " m, and their number is " + std::to_string(count) +
        "; the first must be above 0, the last above the first, and the number at least 2");
  }
  std::vector<double> spacings_m{};
  for (int i = 0; i < count; ++i) {
    const double part = static_cast<double>(i) / (count - 1);
    spacings_m.push_back(from_m * std::pow(to_m / from_m, part));
  }
  spacings_m.back() = to_m;
  return spacings_m;
}

Table table_of(const Sweep& sweep) {
  Table table{.columns = {"model", "varied", "value", "spacing_m", "drag"}};
  for (const MeasureEntry& entry : sweep_measures()) {
    if (is_shown(entry, sweep.order)) table.columns.push_back(entry.column);
  }
  table.columns.push_back("status");
  for (const SweepRow& row : sweep.rows) {
    std::vector<Cell>& cells = table.rows.emplace_back(
        std::vector<Cell>{sweep.order.stroke.model->declaration.id, text_of(sweep.order.varied),
                          row.value, row.spacing_m, text_of(sweep.order.stroke.mode)});
    for (const MeasureEntry& entry : sweep_measures()) {
      if (!is_shown(entry, sweep.order)) continue;
      Cell& cell = cells.emplace_back();
      if (const std::optional<double> value = entry.value(row)) cell = *value;
    }
    cells.push_back(row.status);
  }
  return table;
}

std::string declaration_of(const SweepOrder& order) {
  const RoughnessStroke& stroke = order.stroke;
  nlohmann::ordered_json json{
      {"format", "asperity.sweep/1"},
      {"model", stroke.model->declaration.id},
      {"model_version", stroke.model->declaration.version},
      {"parameters", nlohmann::ordered_json::parse(json_text_of(stroke.parameters))},
      {"varied", text_of(order.varied)},
      {"values", order.values},
      {"spacings_m", order.spacings_m}};
  nlohmann::ordered_json texture{};
  if (order.texture.relief) {
    texture["relief_sha256"] = order.relief_sha256;
  } else {
    texture["kind"] = order.texture.kind;
    texture["values"] = nlohmann::ordered_json::parse(json_text_of(order.texture.values));
    texture["seed"] = order.texture.seed;
  }
  json["texture"] = texture;
  if (stroke.tool) {
    json["tool_sha256"] = order.tool_sha256;
  } else if (stroke.model->declaration.needs_bodies) {
    json["tip"] = text_of_tip(stroke.tip.form);
  }
  if (!order.asset_sha256.empty()) json["assets_sha256"] = order.asset_sha256;
  if (stroke.model->plugin) json["plugin_sha256"] = stroke.model->plugin->sha256;
  if (stroke.body) {
    json["body"] = order.body;
    json["body_sha256"] = order.body_sha256;
  }
  json["drag"] = text_of(stroke.mode);
  json["hand"] = {{"mass_kg", stroke.hand.mass_kg},
                  {"damping_N_s_per_m", stroke.hand.damping_N_s_per_m},
                  {"stiffness_N_per_m", stroke.hand.stiffness_N_per_m}};
  json["stiffness_N_per_m"] = stroke.material.stiffness_N_per_m;
  json["friction"] = stroke.material.friction;
  // The varied level is in `values`.
  if (order.varied != VariedQuantity::probe_diameter && !stroke.tool &&
      stroke.model->declaration.needs_bodies && stroke.tip.form != TipForm::point) {
    json["probe_diameter_m"] = stroke.tip.diameter_m;
  }
  if (order.varied != VariedQuantity::applied_force) json["applied_force_N"] = stroke.force_N;
  if (order.varied != VariedQuantity::exploratory_speed) {
    json["exploratory_speed_m_per_s"] = stroke.speed_m_per_s;
  }
  if (stroke.turning) {
    json["turning_radius_m"] = stroke.turning->radius_m;
    if (order.varied != VariedQuantity::turning) {
      json["turning_rad"] = stroke.turning->amplitude_rad;
    }
  }
  json["seed"] = stroke.seed;
  return json.dump(2) + '\n';
}

std::filesystem::path declaration_beside(const std::filesystem::path& table) {
  return table.string() + ".json";
}

void require_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  if (folder.empty() || std::filesystem::is_directory(folder)) return;
  throw std::invalid_argument("there is no folder " + folder.string() + " for " +
                              file.filename().string() + "; create it first, or choose another");
}

void require_sweep(const SweepOrder& order) {
  const auto require = [](const std::vector<double>& numbers, const char* name) {
    if (numbers.empty())
      throw std::invalid_argument(std::string(name) + " are missing; give at least one");
    for (const double number : numbers) {
      if (!(number > 0.0 && std::isfinite(number))) {
        throw std::invalid_argument("one of " + std::string(name) + " is " + number_text(number) +
                                    "; it must be positive and finite");
      }
      if (std::count(numbers.begin(), numbers.end(), number) > 1) {
        throw std::invalid_argument(std::string(name) + ": " + number_text(number) +
                                    " occurs twice; give it once");
      }
    }
  };
  require(order.values, "the values");
  require(order.spacings_m, "the spacings");
  if (order.varied == VariedQuantity::turning && !order.stroke.turning) {
    throw std::invalid_argument("the tool does not turn; give the radius of its arc");
  }
  const bool has_size = order.stroke.tip.form != TipForm::point && !order.stroke.tool;
  if (order.varied == VariedQuantity::probe_diameter &&
      order.stroke.model->declaration.needs_bodies && !has_size) {
    throw std::invalid_argument(
        "only the diameter of a sphere or a disc can be varied: choose one of these tools, or vary "
        "another quantity");
  }
  // Checked before hours of work: errors of the first and the last texture and of their renderers.
  for (const double spacing_m : {order.spacings_m.front(), order.spacings_m.back()}) {
    const TextureAtSpacing texture = texture_at_spacing(order.texture, spacing_m);
    if (!order.stroke.tool) stroked_renderer(at_level(order, order.values.front()), texture);
  }
}

Sweep sweep_into_file(const SweepOrder& order, const SweepFile& file, const std::stop_token& stop,
                      const std::function<void(double)>& progress) {
  require_sweep(order);
  require_folder_of(file.out);
  Sweep known{.order = order};
  const std::filesystem::path beside = declaration_beside(file.out);
  if (std::filesystem::exists(file.out) || std::filesystem::exists(beside)) {
    const bool is_same = has_declaration(file.out, order);
    if (is_same && std::filesystem::exists(file.out)) {
      known = sweep_in(read_file(file.out, kTableFile), order, file.out.string());
    } else if (!is_same && file.overwrite == Overwrite::refuse) {
      throw std::runtime_error(
          file.out.string() +
          " exists and belongs to another sweep: the declaration of this sweep differs from " +
          beside.string() + "; use --force to replace it, or another --out to keep it");
    }
  }
  return SweepWork(std::move(known), {}, &file, stop, progress).done(file.jobs);
}

Sweep sweep_of(const SweepOrder& order, int jobs) {
  require_sweep(order);
  const std::function<void(double)> nobody{};
  return SweepWork({.order = order}, {}, nullptr, {}, nobody).done(jobs);
}

Sweep sweep_of_shard(const SweepOrder& order, const Shard& shard, int jobs,
                     const std::stop_token& stop, const std::function<void(double)>& progress) {
  require_items(shard, order.spacings_m.size(), "spacings");
  require_sweep(order);
  return SweepWork({.order = order}, shard, nullptr, stop, progress).done(jobs);
}

}  // namespace asperity
