// Memory from check to check.

#include "src/contact/check/check_space.hpp"

#include <gtest/gtest.h>

#include "kernels/core/host_copy.hpp"

namespace percuss::test {
namespace {

TEST(RememberedFace, IsFoundWhateverWasKnownBefore) {
  const Array<const std::int64_t> numbers = to_view("test::numbers", std::vector<std::int64_t>{3, 5, 8, 13});
  for (const int known : {-1, 0, 1, 2, 3, 4, 1000}) {
    EXPECT_EQ(find_remembered_face(numbers, 8, known), 2);
    EXPECT_EQ(find_remembered_face(numbers, 13, known), 3);
    EXPECT_EQ(find_remembered_face(numbers, 7, known), -1);   // not here
    EXPECT_EQ(find_remembered_face(numbers, -1, known), -1);  // none is remembered
  }
}

}  // namespace
}  // namespace percuss::test
