// Writes the schema of protocols to the standard output, for editors of files.

#include <iostream>

#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"

int main() {
  constexpr int kIndentation = 2;
  std::cout << asperity::protocol_schema().dump(kIndentation) << '\n';
  return std::cout.flush() ? 0 : 1;
}
