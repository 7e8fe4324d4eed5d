// SPDX-License-Identifier: MIT
#include "core/bridge/MessageFraming.h"

#include <algorithm>

#include "core/bridge/BridgeCodec.h"

namespace fodscope::bridge {
namespace {

constexpr std::array<std::uint8_t, 4> kMark{'F', 'S', 'B', '1'};
constexpr std::size_t kHeaderSize = 8;

std::size_t littleEndian(const std::uint8_t* bytes) {
    return std::size_t{bytes[0]} | std::size_t{bytes[1]} << 8 | std::size_t{bytes[2]} << 16 |
           std::size_t{bytes[3]} << 24;
}

}  // namespace

Bytes framed(const Bytes& body) {
    if (body.size() > kGreatestMessage) throw ProtocolError("a message is too long to be sent");
    Bytes message(kMark.begin(), kMark.end());
    message.reserve(kHeaderSize + body.size());
    for (int shift = 0; shift < 32; shift += 8)
        message.push_back(static_cast<std::uint8_t>(body.size() >> shift));
    message.insert(message.end(), body.begin(), body.end());
    return message;
}

void FrameReader::append(const std::uint8_t* data, std::size_t size) {
    pending_.insert(pending_.end(), data, data + size);
}

std::optional<Bytes> FrameReader::next() {
    const std::size_t available = pending_.size() - begin_;
    const std::uint8_t* head = pending_.data() + begin_;
    if (!std::equal(head, head + std::min(available, kMark.size()), kMark.begin()))
        throw ProtocolError("it sent something that is no message");
    if (available < kHeaderSize) return std::nullopt;
    const std::size_t size = littleEndian(head + kMark.size());
    if (size > kGreatestMessage) throw ProtocolError("it announced a message of " + std::to_string(size) + " bytes");
    if (available < kHeaderSize + size) return std::nullopt;
    Bytes body(head + kHeaderSize, head + kHeaderSize + size);
    begin_ += kHeaderSize + size;
    // What was read is dropped once it is most of the buffer, so that many small messages are not moved many times.
    if (begin_ * 2 >= pending_.size()) {
        pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(begin_));
        begin_ = 0;
    }
    return body;
}

}  // namespace fodscope::bridge
