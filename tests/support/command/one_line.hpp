// Expects that a call of the command is refused with one given line.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "command/command.hpp"

namespace assur::test {

inline void expect_one_line(const CommandResult& result, const std::string& expected) {
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1) << result.messages;
  EXPECT_EQ(result.messages.rfind("error: ", 0), 0U) << result.messages;
  EXPECT_NE(result.messages.find(expected), std::string::npos)
      << "expected: " << expected << "\nfound:    " << result.messages;
}

}  // namespace assur::test
