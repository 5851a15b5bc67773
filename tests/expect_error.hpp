#pragma once
// EXPECT_ERROR(statement, Error, text): it throws this kind of error, with a message that has the text. The kind alone
// would let pass any other fault of the same input.

#include <gmock/gmock.h>

#define EXPECT_ERROR(statement, Error, text) \
  EXPECT_THAT([&] { statement; }, testing::ThrowsMessage<Error>(testing::HasSubstr(text)))
