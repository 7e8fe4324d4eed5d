// SPDX-License-Identifier: MIT
#include "core/bridge/BridgeSupervisor.h"

#include <poll.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "core/bridge/BridgeCodec.h"
#include "core/bridge/ChildProcess.h"
#include "core/bridge/MessageFraming.h"
#include "core/common/Error.h"

namespace fodscope::bridge {
namespace {

constexpr int kLookEvery_ms = 200;
/// A bridge that ran this long was no failed start.
constexpr std::chrono::seconds kRanWell(10);

}  // namespace

/// With one bridge process, from its start to its end.
class BridgeSupervisor::Conversation {
  public:
    explicit Conversation(BridgeSupervisor& supervisor)
        : supervisor_(supervisor), process_(supervisor.settings_.program) {
        queue(supervisor.settings_.configuration);
        const std::lock_guard lock(supervisor_.mutex_);
        supervisor_.processId_ = process_.id();
        supervisor_.outgoing_.clear();
    }
    ~Conversation() {
        const std::lock_guard lock(supervisor_.mutex_);
        supervisor_.processId_ = 0;
    }

    std::string run() {
        try {
            while (!supervisor_.isOver()) {
                wait();
                takeOutgoing();
                write();
                if (!read()) return process_.ending();
                if (isSilent()) return "it hangs";
            }
            return "";
        } catch (const ProtocolError& problem) {
            process_.kill();
            return problem.what();
        }
    }

  private:
    void queue(const Request& request) {
        const Bytes message = framed(encode(request));
        pending_.insert(pending_.end(), message.begin(), message.end());
    }
    void wait() {
        pollfd descriptors[3] = {{process_.output(), POLLIN, 0},
                                 {supervisor_.wake_, POLLIN, 0},
                                 {process_.input(), static_cast<short>(pending_.empty() ? 0 : POLLOUT), 0}};
        ::poll(descriptors, pending_.empty() ? 2 : 3, kLookEvery_ms);
        std::uint64_t count = 0;
        if (descriptors[1].revents != 0) static_cast<void>(!::read(supervisor_.wake_, &count, sizeof count));
    }
    void takeOutgoing() {
        const std::lock_guard lock(supervisor_.mutex_);
        for (const Request& request : std::exchange(supervisor_.outgoing_, {}))
            queue(request);
    }
    void write() {
        if (pending_.empty()) return;
        const ssize_t count = ::write(process_.input(), pending_.data(), pending_.size());
        if (count > 0) pending_.erase(pending_.begin(), pending_.begin() + count);
    }
    /// @return false when the bridge has closed its output
    bool read() {
        std::uint8_t buffer[1 << 16];
        for (;;) {
            const ssize_t count = ::read(process_.output(), buffer, sizeof buffer);
            if (count == 0) return false;
            if (count < 0) return errno == EAGAIN || errno == EINTR;
            reader_.append(buffer, static_cast<std::size_t>(count));
            heard_ = Clock::now();
            while (const auto body = reader_.next())
                take(decodeEvent(*body));
        }
    }
    void take(Event event) {
        if (const auto* hello = std::get_if<Hello>(&event); hello && hello->version != kProtocolVersion) {
            const std::lock_guard lock(supervisor_.mutex_);
            supervisor_.isHopeless_ = true;
            throw ProtocolError("it is of another version than this program; install both anew");
        }
        supervisor_.tell({std::move(event), "", Clock::now()});
    }
    bool isSilent() {
        const bool isSilent =
            Clock::now() - heard_ > std::chrono::duration<double>(supervisor_.settings_.silentAfter_s);
        if (isSilent) process_.kill();
        return isSilent;
    }

    BridgeSupervisor& supervisor_;
    ChildProcess process_;
    FrameReader reader_;
    Bytes pending_;
    Clock::time_point heard_ = Clock::now();
};

BridgeSupervisor::BridgeSupervisor(SupervisorSettings settings)
    : settings_(std::move(settings)), wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    thread_ = std::thread([this] { run(); });
}

BridgeSupervisor::~BridgeSupervisor() {
    {
        const std::lock_guard lock(mutex_);
        isOver_ = true;
        over_.notify_all();
    }
    ::eventfd_write(wake_, 1);
    thread_.join();
    ::close(wake_);
}

void BridgeSupervisor::send(Request request) {
    const std::lock_guard lock(mutex_);
    if (processId_ == 0) return;
    outgoing_.push_back(std::move(request));
    ::eventfd_write(wake_, 1);
}

std::vector<BridgeSupervisor::Arrival> BridgeSupervisor::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(arrivals_, {});
}

pid_t BridgeSupervisor::processId() const {
    const std::lock_guard lock(mutex_);
    return processId_;
}

void BridgeSupervisor::tell(Arrival arrival) {
    const std::lock_guard lock(mutex_);
    arrivals_.push_back(std::move(arrival));
}

bool BridgeSupervisor::isOver() const {
    const std::lock_guard lock(mutex_);
    return isOver_;
}

void BridgeSupervisor::pause(double time_s) {
    std::unique_lock lock(mutex_);
    over_.wait_for(lock, std::chrono::duration<double>(time_s), [this] { return isOver_; });
}

void BridgeSupervisor::run() {
    // A bridge that dies while it is written to is an error to be read, not the end of this program.
    sigset_t brokenPipe;
    sigemptyset(&brokenPipe);
    sigaddset(&brokenPipe, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &brokenPipe, nullptr);
    double pause_s = settings_.firstPause_s;
    while (!isOver()) {
        const auto began = Clock::now();
        const std::string trouble = superviseOne();
        if (isOver()) return;
        tell({std::nullopt, trouble, Clock::now()});
        if (std::lock_guard lock(mutex_); isHopeless_) return;
        if (Clock::now() - began > kRanWell) pause_s = settings_.firstPause_s;
        pause(pause_s);
        pause_s = std::min(2 * pause_s, settings_.greatestPause_s);
    }
}

std::string BridgeSupervisor::superviseOne() {
    try {
        Conversation conversation(*this);
        return conversation.run();
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace fodscope::bridge
