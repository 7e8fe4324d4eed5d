// SPDX-License-Identifier: MIT
#include "core/common/Files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/common/Error.h"

namespace fodscope {
namespace {

std::string reason(int errorNumber) {
    return std::generic_category().message(errorNumber);
}

Error cannotWrite(const std::filesystem::path& file, int errorNumber) {
    return Error(file.string(), "cannot be written (" + reason(errorNumber) + ")",
                 "check that the folder exists and may be written, and that the disk has room");
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& file) : path_(file) {
    std::error_code code;
    const auto status = std::filesystem::status(file, code);
    if (!std::filesystem::exists(status)) {
        throw Error(file.string(), "no such file", "check the name and the folder");
    }
    if (std::filesystem::is_directory(status)) {
        throw Error(file.string(), "is a folder", "give a file");
    }
    descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) {
        throw Error(file.string(), "cannot be opened (" + reason(errno) + ")", "check that it may be read");
    }
    if (std::filesystem::is_regular_file(status)) size_ = std::filesystem::file_size(file, code);
    if (code) size_ = 0;
}

InputFile::~InputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

InputFile::InputFile(InputFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

InputFile& InputFile::operator=(InputFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    std::swap(size_, other.size_);
    return *this;
}

std::size_t InputFile::read(std::span<std::byte> bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = ::read(descriptor_, bytes.data() + done, bytes.size() - done);
        if (count == 0) break;
        if (count < 0 && errno == EINTR) continue;
        if (count < 0)
            throw Error(path_.string(), "could not be read to its end", "check the disk and copy the file anew");
        done += static_cast<std::size_t>(count);
    }
    return done;
}

std::vector<std::byte> readFile(const std::filesystem::path& file) {
    InputFile input(file);
    std::vector<std::byte> bytes(static_cast<std::size_t>(input.size()));
    bytes.resize(input.read(bytes));
    // What is no regular file does not tell its length.
    std::vector<std::byte> more(1 << 16);
    while (const std::size_t count = input.read(more))
        bytes.insert(bytes.end(), more.begin(), more.begin() + static_cast<std::ptrdiff_t>(count));
    return bytes;
}

std::string readTextFile(const std::filesystem::path& file) {
    const std::vector<std::byte> bytes = readFile(file);
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

void writeFile(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    std::string temporary = file.string() + ".XXXXXX";
    const int descriptor = ::mkstemp(temporary.data());
    if (descriptor < 0) throw cannotWrite(file, errno);
    const auto fail = [&](int errorNumber) {
        ::close(descriptor);
        ::unlink(temporary.c_str());
        throw cannotWrite(file, errorNumber);
    };
    std::size_t written = 0;
    while (written < bytes.size()) {
        const ssize_t count = ::write(descriptor, bytes.data() + written, bytes.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(errno);
        written += static_cast<std::size_t>(count);
    }
    if (::fchmod(descriptor, 0644) != 0 || ::fsync(descriptor) != 0) fail(errno);
    if (::close(descriptor) != 0 || ::rename(temporary.c_str(), file.c_str()) != 0) {
        const int errorNumber = errno;
        ::unlink(temporary.c_str());
        throw cannotWrite(file, errorNumber);
    }
}

void writeFile(const std::filesystem::path& file, std::string_view text) {
    writeFile(file, std::as_bytes(std::span(text.data(), text.size())));
}

void makeFolder(const std::filesystem::path& folder) {
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (code || !std::filesystem::is_directory(folder)) {
        throw Error(folder.string(),
                    "the folder cannot be made (" + (code ? code.message() : "a file is in the way") + ")",
                    "choose another folder");
    }
}

}  // namespace fodscope
