// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "core/cloud/ByteWindow.h"
#include "core/cloud/PlyHeader.h"
#include "core/common/Error.h"

namespace fodscope {

/// The numbers of a PLY file's data one after the other, whatever the encoding.
class PlyNumbers {
  public:
    /// @param window where the data begins
    PlyNumbers(ByteWindow& window, PlyEncoding encoding, const std::string& subject)
        : window_(window), encoding_(encoding), subject_(subject) {}

    double next(ScalarType type);

    /// @return the number of entries of a list, which the rest of the file can hold
    std::uint32_t nextListSize(const PlyProperty& list);

    /// @throws Error when the rest of the file is too short for the element's rows
    void requireRows(const PlyElement& element) const;

    void skipRows(const PlyElement& element);

    Error truncated() const;
    bool isText() const { return encoding_ == PlyEncoding::Ascii; }
    std::endian order() const { return encoding_ == PlyEncoding::BigEndian ? std::endian::big : std::endian::little; }
    ByteWindow& window() { return window_; }

  private:
    double nextInText();

    ByteWindow& window_;
    PlyEncoding encoding_;
    const std::string& subject_;
};

/// @return the header; the window is then where the data begins
PlyHeader readPlyHeader(ByteWindow& window, const std::string& subject);

}  // namespace fodscope
