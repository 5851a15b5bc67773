#pragma once
// The tests of a program that run: those of some of its sources.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <string_view>

namespace percuss::test {

/// The tests of a source as a filter of GoogleTest; empty if it has none.
inline std::string filter_source(std::string_view source) {
  std::string filter;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      if (std::string_view(test.file()).ends_with("/" + std::string(source)))
        filter += std::string(suite.name()) + "." + test.name() + ":";
    }
  }
  return filter;
}

/// Runs only tests of the sources that the arguments name, such as contact/friction_test.cpp; all tests if there are no
/// arguments. False, with a message, if a source has no tests here, so that none is left out by a wrong name. After
/// testing::InitGoogleTest, which takes its own arguments away.
inline bool choose_sources(int argc, char** argv) {
  std::string filter;
  for (int i = 1; i < argc; ++i) {
    const std::string tests = filter_source(argv[i]);
    if (tests.empty()) {
      std::fprintf(stderr, "%s: error: no test of this program is in it (the arguments are sources)\n", argv[i]);
      return false;
    }
    filter += tests;
  }
  if (!filter.empty()) GTEST_FLAG_SET(filter, filter);
  return true;
}

}  // namespace percuss::test
