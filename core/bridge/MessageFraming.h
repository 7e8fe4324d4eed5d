// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

/// @return the body with the mark and its length before it
Bytes framed(const Bytes& body);

/// Puts messages together from whatever pieces the pipe hands over. Memory grows with what came, not with what a
/// length promises.
class FrameReader {
  public:
    void append(const std::uint8_t* data, std::size_t size);
    /// @return the next whole body, or nothing yet
    /// @throws ProtocolError when something else than a message begins, or one that is too long
    std::optional<Bytes> next();

  private:
    Bytes pending_;
    std::size_t begin_ = 0;
};

}  // namespace fodscope::bridge
