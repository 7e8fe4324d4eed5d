// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

/// Reads CBOR into a tree. The library reads nested values by recursion, so depth is limited while it reads.
/// @throws ProtocolError for anything that is not one whole CBOR value, or is nested more than 8 deep
nlohmann::json readCbor(const Bytes& body);

}  // namespace fodscope::bridge
