// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/MessagePipe.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>

namespace fodscope::bridge {
namespace {

/// A workstation that has not read this much gets no more states and maps until it has.
constexpr std::size_t kGreatestBacklog = kGreatestMessage;

void makeNonBlocking(int descriptor) {
    ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK);
}

bool mayBeLeftOut(const Event& event) {
    return std::holds_alternative<State>(event) || std::holds_alternative<Streams>(event) ||
           std::holds_alternative<MapCloud>(event) || std::holds_alternative<Trajectory>(event);
}

}  // namespace

MessagePipe::MessagePipe(int input, int output) : input_(input), output_(output) {
    makeNonBlocking(input_);
    makeNonBlocking(output_);
}

void MessagePipe::send(const Event& event) {
    if (waitingBytes_ > kGreatestBacklog && mayBeLeftOut(event)) return;
    waiting_.push_back(framed(encode(event)));
    waitingBytes_ += waiting_.back().size();
    writeSome();
}

void MessagePipe::wait(int milliseconds) {
    pollfd descriptors[2] = {{input_, POLLIN, 0}, {output_, static_cast<short>(waiting_.empty() ? 0 : POLLOUT), 0}};
    if (::poll(descriptors, 2, milliseconds) <= 0) return;
    if (descriptors[0].revents != 0) readAll();
    if ((descriptors[1].revents & POLLERR) != 0) isClosed_ = true;
    writeSome();
}

std::optional<Request> MessagePipe::next() {
    const auto body = reader_.next();
    if (!body) return std::nullopt;
    return decodeRequest(*body);
}

void MessagePipe::readAll() {
    std::uint8_t buffer[65536];
    for (;;) {
        const ssize_t count = ::read(input_, buffer, sizeof buffer);
        if (count > 0) {
            reader_.append(buffer, static_cast<std::size_t>(count));
        } else {
            const bool isLater = count < 0 && (errno == EAGAIN || errno == EINTR);
            if (!isLater) isClosed_ = true;
            return;
        }
    }
}

void MessagePipe::writeSome() {
    while (!waiting_.empty()) {
        const Bytes& message = waiting_.front();
        const ssize_t count = ::write(output_, message.data() + written_, message.size() - written_);
        if (count < 0) {
            if (errno != EAGAIN && errno != EINTR) isClosed_ = true;
            return;
        }
        written_ += static_cast<std::size_t>(count);
        if (written_ < message.size()) continue;
        waitingBytes_ -= message.size();
        waiting_.pop_front();
        written_ = 0;
    }
}

}  // namespace fodscope::bridge
