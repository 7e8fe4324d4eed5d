// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

/// The other side said something that is not in the protocol. what() tells what, as half a sentence.
class ProtocolError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// @return the body of a message, CBOR
Bytes encode(const Request& request);
Bytes encode(const Event& event);

/// @throws ProtocolError for a body that is no CBOR, is nested too deeply, names no known message, lacks a field or
///         has a value out of its range
Request decodeRequest(const Bytes& body);
Event decodeEvent(const Bytes& body);

}  // namespace fodscope::bridge
