// Searches the rows of the order on several threads, and stores them with their declaration.

#include "app/sweep/clean_stiffness_table.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/study_files/parameter_json.h"

namespace asperity {

namespace {

void require_list(const std::vector<double>& numbers, const std::string& name) {
  if (numbers.empty()) throw std::invalid_argument(name + " are missing; give at least one");
  for (const double number : numbers) {
    if (!(number > 0.0 && std::isfinite(number))) {
      throw std::invalid_argument("one of " + name + " is " + number_text(number) +
                                  "; it must be positive and finite");
    }
    if (std::count(numbers.begin(), numbers.end(), number) > 1) {
      throw std::invalid_argument(name + ": " + number_text(number) +
                                  " occurs twice; give it once");
    }
  }
}

void require_order(const CleanStiffnessOrder& order) {
  if (order.models.empty()) {
    throw std::invalid_argument("the force models are missing; give at least one");
  }
  for (const ForceModel* model : order.models) {
    if (!model->declaration.needs_bodies) continue;
    throw std::invalid_argument(
        "the force model " + model->declaration.id +
        " needs two bodies, and the search has a point on a plane; choose a model of a point");
  }
  require_list(order.amplitudes_m, "the amplitudes");
  require_list(order.wavelengths_m, "the wavelengths");
  require_list(order.rates_Hz, "the rates");
}

std::optional<CleanStiffness> found_in(const CleanStiffnessOrder& order,
                                       const CleanStiffnessRow& row, const std::stop_token& stop) {
  const TextureAtSpacing texture = texture_at_spacing(
      {.kind = "sinusoid", .values = {{"amplitude_m", row.amplitude_m}}}, row.wavelength_m);
  const RoughnessStroke stroke{
      .model = row.model, .parameters = order.parameters, .material = {.friction = order.friction}};
  LoopStrokes loop = order.loop;
  loop.rate_Hz = row.rate_Hz;
  return clean_stiffness(*row.model, stroked_inputs(stroke, texture), loop, order.search, stop);
}

}  // namespace

std::optional<std::vector<CleanStiffnessRow>> clean_stiffness_rows(
    const CleanStiffnessOrder& order, int jobs, const std::stop_token& stop,
    const std::function<void(double)>& progress) {
  require_order(order);
  std::vector<CleanStiffnessRow> rows{};
  for (const ForceModel* model : order.models) {
    for (const double amplitude_m : order.amplitudes_m) {
      for (const double wavelength_m : order.wavelengths_m) {
        for (const double rate_Hz : order.rates_Hz) {
          rows.push_back({.model = model,
                          .amplitude_m = amplitude_m,
                          .wavelength_m = wavelength_m,
                          .rate_Hz = rate_Hz});
        }
      }
    }
  }
  std::atomic<std::size_t> next{0};
  std::atomic<bool> is_over{false};
  std::mutex mutex{};  // guards the following three
  std::exception_ptr failure{};
  std::size_t failed = rows.size();  // the first combination with a failure, whatever the jobs
  std::size_t complete = 0;
  const auto fail = [&](std::size_t i, const std::exception_ptr& error) {
    const std::lock_guard lock(mutex);
    is_over = true;
    if (i > failed) return;
    failed = i;
    failure = error;
  };
  const auto work = [&] {
    while (!is_over && !stop.stop_requested()) {
      const std::size_t i = next++;
      if (i >= rows.size()) return;
      try {
        const std::optional<CleanStiffness> found = found_in(order, rows[i], stop);
        if (!found) return;
        rows[i].found = *found;
        const std::lock_guard lock(mutex);
        ++complete;
        if (progress) progress(static_cast<double>(complete) / static_cast<double>(rows.size()));
      } catch (const std::invalid_argument& error) {
        fail(i, std::make_exception_ptr(std::invalid_argument(
                    rows[i].model->declaration.id + " at an amplitude of " +
                    number_text(rows[i].amplitude_m) + " m, a wavelength of " +
                    number_text(rows[i].wavelength_m) + " m and " + number_text(rows[i].rate_Hz) +
                    " Hz: " + error.what())));
      } catch (...) {
        fail(i, std::current_exception());
      }
    }
  };
  {
    std::vector<std::jthread> workers{};
    for (int job = 1; job < jobs; ++job) workers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  if (complete < rows.size()) return {};
  return rows;
}

Table table_of(const std::vector<CleanStiffnessRow>& rows) {
  Table table{.columns = {"model", "amplitude_m", "wavelength_m", "rate_Hz",
                          "clean_stiffness_N_per_m", "unclean_stiffness_N_per_m", "buzz_of_clean",
                          "buzz_of_unclean", "buzz_force_of_clean_N", "buzz_force_of_unclean_N",
                          "status"}};
  const auto cell = [](const std::optional<double>& value) {
    return value ? Cell(*value) : Cell();
  };
  const auto ratio = [](const std::optional<Buzz>& buzz) {
    return buzz ? Cell(buzz->ratio) : Cell();
  };
  const auto force = [](const std::optional<Buzz>& buzz) {
    return buzz ? Cell(buzz->force_N) : Cell();
  };
  for (const CleanStiffnessRow& row : rows) {
    const CleanStiffness& found = row.found;
    table.rows.push_back({row.model->declaration.id, row.amplitude_m, row.wavelength_m, row.rate_Hz,
                          cell(found.clean_N_per_m), cell(found.unclean_N_per_m),
                          ratio(found.buzz_of_clean), ratio(found.buzz_of_unclean),
                          force(found.buzz_of_clean), force(found.buzz_of_unclean),
                          std::string(text_of(found.status))});
  }
  return table;
}

std::string declaration_of(const CleanStiffnessOrder& order) {
  nlohmann::ordered_json json{{"format", "asperity.clean_stiffness/1"}};
  json["models"] = nlohmann::ordered_json::array();
  for (const ForceModel* model : order.models) {
    nlohmann::ordered_json one{{"model", model->declaration.id},
                               {"version", model->declaration.version}};
    if (model->plugin) one["plugin_sha256"] = model->plugin->sha256;
    json["models"].push_back(one);
  }
  json["parameters"] = nlohmann::ordered_json::parse(json_text_of(order.parameters));
  json["friction"] = order.friction;
  json["amplitudes_m"] = order.amplitudes_m;
  json["wavelengths_m"] = order.wavelengths_m;
  json["rates_Hz"] = order.rates_Hz;
  json["device"] = order.device;
  json["hand_speed_m_per_s"] = order.loop.habits.speed_m_per_s;
  json["hand_force_N"] = order.loop.habits.normal_force_N;
  json["strokes"] = order.loop.strokes;
  json["stroke_s"] = order.loop.duration_s;
  json["seed"] = order.loop.seed;
  json["least_stiffness_N_per_m"] = order.search.least_N_per_m;
  json["most_stiffness_N_per_m"] = order.search.most_N_per_m;
  json["tolerance"] = order.search.tolerance;
  json["buzz_limit"] = order.search.buzz_limit;
  json["buzz_force_limit_N"] = order.search.buzz_force_limit_N;
  return json.dump(2) + '\n';
}

}  // namespace asperity
