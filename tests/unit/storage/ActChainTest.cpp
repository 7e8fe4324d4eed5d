// SPDX-License-Identifier: MIT
#include "storage/ActChain.h"

#include <gtest/gtest.h>

#include "core/common/Hash.h"

namespace fodscope {
namespace {

Act sampleAct() {
    Act act{1, "decision", "{}", "Anna", "2026-11-21T10:15:30.250Z", "0.1.0", firstPreviousHash(), ""};
    act.hash = hashOf(act);
    return act;
}

TEST(ActChain, HashIsTheDocumentedText) {
    EXPECT_EQ(hashOf(sampleAct()),
              sha256("fodscope.act/1\n1:1\n8:decision\n2:{}\n4:Anna\n24:2026-11-21T10:15:30.250Z\n5:0.1.0\n64:" +
                     std::string(64, '0') + "\n"));
}

TEST(ActChain, EveryColumnIsCovered) {
    const Act original = sampleAct();
    std::vector<Act> altered(7, original);
    altered[0].sequence = 2;
    altered[1].kind = "photo";
    altered[2].payload = "{ }";
    altered[3].author = "Ben";
    altered[4].timeUtc = "2026-11-21T10:15:30.251Z";
    altered[5].softwareVersion = "0.1.1";
    altered[6].previousHash[0] = '1';
    for (const Act& act : altered) {
        EXPECT_NE(hashOf(act), original.hash);
    }
}

TEST(ActChain, TextMovedBetweenColumnsIsNoticed) {
    Act act = sampleAct();
    act.kind = "decisio";
    act.payload = "n{}";
    EXPECT_NE(hashOf(act), sampleAct().hash);
}

TEST(ActChain, NamesTheActThatIsWrong) {
    const Act act = sampleAct();
    EXPECT_EQ(chainProblem(act, 1, firstPreviousHash()), "");
    EXPECT_EQ(chainProblem(act, 0, firstPreviousHash()), "act 0 is missing from the record");
    EXPECT_NE(chainProblem(act, 1, std::string(64, 'f')).find("does not follow"), std::string::npos);
    Act altered = act;
    altered.author = "Ben";
    EXPECT_EQ(chainProblem(altered, 1, firstPreviousHash()),
              "act 1 (decision by Ben, 2026-11-21T10:15:30.250Z) was altered");
}

}  // namespace
}  // namespace fodscope
