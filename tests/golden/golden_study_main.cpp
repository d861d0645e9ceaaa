// Makes the study of a library protocol whose answers are a formula: see golden.py.

#include <cstdio>
#include <exception>

#include "tests/golden/formula_study.h"

int main(int count, char** arguments) try {
  if (count != 3) {
    std::fputs("Usage: asperity_golden_study PROTOCOL STUDY\n", stderr);
    return 2;
  }
  asperity::test::make_formula_study(arguments[1], arguments[2]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "asperity_golden_study: %s\n", error.what());
  return 1;
}
