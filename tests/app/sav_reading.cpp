// Collects variables, labels and cells from the callbacks of ReadStat.

#include "tests/app/sav_reading.h"

#include <algorithm>
#include <cstddef>

#include <gtest/gtest.h>

#include "results_schema/tables/table.h"

namespace asperity {

Sav sav(const std::filesystem::path& path) {
  Sav read{};
  readstat_parser_t* const parser = readstat_parser_init();
  readstat_set_variable_handler(
      parser, [](int, readstat_variable_t* variable, const char* labels, void* context) -> int {
        const auto text = [](const char* words) {
          return std::string(words == nullptr ? "" : words);
        };
        static_cast<Sav*>(context)->variables.push_back(
            {text(readstat_variable_get_name(variable)),
             text(readstat_variable_get_label(variable)), text(labels),
             readstat_variable_get_measure(variable),
             readstat_variable_get_missing_ranges_count(variable)});
        return READSTAT_HANDLER_OK;
      });
  readstat_set_value_label_handler(
      parser, [](const char* set, readstat_value_t value, const char* label, void* context) -> int {
        static_cast<Sav*>(context)->value_labels[set][readstat_double_value(value)] = label;
        return READSTAT_HANDLER_OK;
      });
  readstat_set_value_handler(
      parser,
      [](int row, readstat_variable_t* variable, readstat_value_t value, void* context) -> int {
        Sav& into = *static_cast<Sav*>(context);
        into.rows.resize(std::max(into.rows.size(), static_cast<std::size_t>(row) + 1));
        std::string text = ".";
        if (readstat_value_type_class(value) == READSTAT_TYPE_CLASS_STRING) {
          const char* const words = readstat_string_value(value);
          text = words == nullptr ? "" : words;
        } else if (!readstat_value_is_system_missing(value)) {
          text = text_of_number(readstat_double_value(value));
        }
        into.rows.back()[readstat_variable_get_name(variable)] = text;
        return READSTAT_HANDLER_OK;
      });
  EXPECT_EQ(readstat_parse_sav(parser, path.c_str(), &read), READSTAT_OK);
  readstat_parser_free(parser);
  return read;
}

}  // namespace asperity
