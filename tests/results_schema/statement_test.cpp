// Uses statements again that were prepared earlier, as the store does for every row.

#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include "results_schema/sqlite.h"

namespace asperity {
namespace {

constexpr const char* kInsertion = "INSERT INTO numbers VALUES (?, ?)";
constexpr const char* kFirsts = "SELECT first FROM numbers ORDER BY first";

class Statements : public testing::Test {
 protected:
  Statements() { database_.execute("CREATE TABLE numbers (first INTEGER, second INTEGER)"); }

  void insert(std::int64_t first, std::int64_t second) {
    Statement(database_, kInsertion).bind(first, second).run();
  }

  Database database_{"folder", "", Database::Mode::in_memory};
};

TEST_F(Statements, KeepNoParameterOfTheirLastUse) {
  insert(1, 2);
  Statement(database_, kInsertion).bind(std::int64_t{3}).run();
  Statement row(database_, "SELECT second FROM numbers WHERE first = 3");
  ASSERT_TRUE(row.step());
  std::optional<std::int64_t> second{7};
  row.read(second);
  EXPECT_FALSE(second.has_value());
}

TEST_F(Statements, BeginWithTheFirstRowAlthoughTheirLastUseReadOne) {
  insert(1, 0);
  insert(2, 0);
  for (int use = 0; use < 2; ++use) {
    Statement rows(database_, kFirsts);
    ASSERT_TRUE(rows.step());
    EXPECT_EQ(rows.integer_at(0), 1);
  }
}

TEST_F(Statements, OfOneTextReadTheirOwnRows) {
  insert(1, 0);
  insert(2, 0);
  { const Statement earlier(database_, kFirsts); }
  Statement outer(database_, kFirsts);
  ASSERT_TRUE(outer.step());
  Statement inner(database_, kFirsts);
  ASSERT_TRUE(inner.step());
  ASSERT_TRUE(inner.step());
  EXPECT_EQ(inner.integer_at(0), 2);
  EXPECT_EQ(outer.integer_at(0), 1);
}

// A statement with a row keeps its table from being dropped.
TEST_F(Statements, HoldNothingOnceTheyAreNotUsed) {
  insert(1, 0);
  {
    Statement half(database_, kFirsts);
    ASSERT_TRUE(half.step());
  }
  database_.execute("DROP TABLE numbers");
  database_.execute("CREATE TABLE numbers (first INTEGER, second INTEGER)");
  insert(5, 0);
  Statement rows(database_, kFirsts);
  ASSERT_TRUE(rows.step());
  EXPECT_EQ(rows.integer_at(0), 5);
}

}  // namespace
}  // namespace asperity
