// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/common/Error.h"

namespace fodscope {

/// Checks that the call fails with a sentence that holds the words.
template <class Call>
void expectError(const Call& call, const std::string& words) {
    try {
        call();
        ADD_FAILURE() << "no error; expected one with \"" << words << '"';
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(words));
        EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n")));
    }
}

}  // namespace fodscope
