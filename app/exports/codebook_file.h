// The file codebook.tsv, which describes every column of every file of an export.

#pragma once

#include <string>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/export_folder.h"

namespace asperity {

/// Collects the descriptions of columns, and writes them with those of codebook.tsv and MANIFEST.tsv.
class CodebookFile final {
 public:
  void add(const std::string& file, const std::vector<ExportColumn>& columns);
  void write(ExportFolder& folder);

 private:
  std::vector<std::vector<Cell>> rows_{};
};

}  // namespace asperity
