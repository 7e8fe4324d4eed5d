// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

#include "core/bridge/BridgeCodec.h"
#include "core/bridge/MessageFraming.h"

namespace fodscope::bridge {

/// The bridge's end of the two pipes. Writing never blocks: a workstation that does not read must not keep the bridge
/// from hearing its STOP.
class MessagePipe {
  public:
    /// Both descriptors become non-blocking.
    MessagePipe(int input, int output);

    void send(const Event& event);
    /// Waits for something to read or to go on writing, then does both.
    void wait(int milliseconds);
    /// @throws ProtocolError
    std::optional<Request> next();
    /// The workstation is gone.
    bool isClosed() const { return isClosed_; }

  private:
    void readAll();
    void writeSome();

    int input_;
    int output_;
    FrameReader reader_;
    std::deque<Bytes> waiting_;
    std::size_t waitingBytes_ = 0;
    /// How much of the first message is written.
    std::size_t written_ = 0;
    bool isClosed_ = false;
};

}  // namespace fodscope::bridge
