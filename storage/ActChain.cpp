// SPDX-License-Identifier: MIT
#include "storage/ActChain.h"

#include "core/common/Hash.h"

namespace fodscope {

std::string firstPreviousHash() {
    return std::string(64, '0');
}

std::string hashOf(const Act& act) {
    std::string text = "fodscope.act/1\n";
    const std::string sequence = std::to_string(act.sequence);
    for (const std::string* field :
         {&sequence, &act.kind, &act.payload, &act.author, &act.timeUtc, &act.softwareVersion, &act.previousHash}) {
        text += std::to_string(field->size()) + ":" + *field + "\n";
    }
    return sha256(text);
}

std::string chainProblem(const Act& act, std::int64_t expectedSequence, const std::string& previousHash) {
    if (act.sequence != expectedSequence) {
        return "act " + std::to_string(expectedSequence) + " is missing from the record";
    }
    if (hashOf(act) != act.hash) return nameOf(act) + " was altered";
    if (act.previousHash != previousHash) {
        return nameOf(act) + " does not follow the act before it: that one was replaced";
    }
    return {};
}

std::string nameOf(const Act& act) {
    return "act " + std::to_string(act.sequence) + " (" + act.kind + " by " + act.author + ", " + act.timeUtc + ")";
}

}  // namespace fodscope
