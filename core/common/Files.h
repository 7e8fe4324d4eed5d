// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fodscope {

/// A file that is read from its begin to its end, in pieces of any size.
class InputFile {
  public:
    /// @throws Error when it is missing, a folder, or may not be read
    explicit InputFile(const std::filesystem::path& file);
    ~InputFile();
    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&& other) noexcept;

    const std::filesystem::path& path() const { return path_; }

    /// @return its length; 0 also when only reading tells it (a pipe)
    std::uint64_t size() const { return size_; }

    /// Fills `bytes` unless the file ends before.
    /// @return how many bytes were read
    /// @throws Error when the disk does not give them
    std::size_t read(std::span<std::byte> bytes);

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

/// Reads a whole file.
/// @throws Error when it is missing, a folder, or cannot be read to its end
std::vector<std::byte> readFile(const std::filesystem::path& file);
std::string readTextFile(const std::filesystem::path& file);

/// Writes a whole file so that a reader sees either the old content or the new one: the bytes go to a temporary file
/// beside it, are flushed to the disk, and take its name by rename.
/// @throws Error when the folder is missing, may not be written or the disk is full; the old file is then untouched
void writeFile(const std::filesystem::path& file, std::span<const std::byte> bytes);
void writeFile(const std::filesystem::path& file, std::string_view text);

/// Makes a folder and its parents.
/// @throws Error when that is not possible
void makeFolder(const std::filesystem::path& folder);

}  // namespace fodscope
