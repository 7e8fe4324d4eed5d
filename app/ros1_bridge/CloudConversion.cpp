// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/CloudConversion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>

#include "core/common/Error.h"

namespace fodscope::bridge {
namespace {

constexpr std::uint64_t kGreatestPointCount = 40'000'000;

[[noreturn]] void refuse(const std::string& problem) {
    throw Error("map cloud", problem, "check what publishes it");
}

std::size_t sizeOf(std::uint8_t type) {
    constexpr std::size_t kSizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return type < std::size(kSizes) ? kSizes[type] : 0;
}

/// One field of every point, as a number.
class FieldReader {
  public:
    FieldReader(const CloudField& field, const CloudMessage& message)
        : offset_(field.offset),
          type_(field.type),
          isSwapped_(message.isBigEndian != (std::endian::native == std::endian::big)) {
        const std::size_t size = sizeOf(field.type);
        if (size == 0) refuse("its field '" + field.name + "' has the unknown type " + std::to_string(field.type));
        if (std::uint64_t{field.offset} + size > message.pointStep)
            refuse("its field '" + field.name + "' lies outside its points");
    }

    template <class Value>
    Value bits(const std::uint8_t* point) const {
        std::uint8_t bytes[sizeof(Value)];
        std::memcpy(bytes, point + offset_, sizeof(Value));
        if (isSwapped_) std::reverse(std::begin(bytes), std::end(bytes));
        Value value;
        std::memcpy(&value, bytes, sizeof(Value));
        return value;
    }

    double number(const std::uint8_t* point) const {
        switch (type_) {
            case 1:
                return bits<std::int8_t>(point);
            case 2:
                return bits<std::uint8_t>(point);
            case 3:
                return bits<std::int16_t>(point);
            case 4:
                return bits<std::uint16_t>(point);
            case 5:
                return bits<std::int32_t>(point);
            case 6:
                return bits<std::uint32_t>(point);
            case 7:
                return bits<float>(point);
            default:
                return bits<double>(point);
        }
    }

  private:
    std::size_t offset_;
    std::uint8_t type_;
    bool isSwapped_;
};

const CloudField* fieldNamed(const CloudMessage& message, const std::string& name) {
    const auto found = std::find_if(message.fields.begin(), message.fields.end(),
                                    [&](const CloudField& field) { return field.name == name; });
    return found == message.fields.end() ? nullptr : &*found;
}

FieldReader coordinate(const CloudMessage& message, const std::string& name) {
    const CloudField* field = fieldNamed(message, name);
    if (field == nullptr) refuse("it has no field '" + name + "'");
    return {*field, message};
}

/// Colours are packed into the bits of a number of 32 bits, whatever its type says.
const CloudField* colourField(const CloudMessage& message) {
    const CloudField* field = fieldNamed(message, "rgb");
    if (field == nullptr) field = fieldNamed(message, "rgba");
    return field != nullptr && sizeOf(field->type) == 4 ? field : nullptr;
}

void requireSizes(const CloudMessage& message) {
    const std::uint64_t count = std::uint64_t{message.width} * message.height;
    if (count == 0) refuse("it has no points");
    if (count > kGreatestPointCount) refuse("it claims to have " + std::to_string(count) + " points");
    const std::uint64_t used = std::uint64_t{message.width} * message.pointStep;
    if (message.pointStep == 0 || message.rowStep < used)
        refuse("its rows are shorter than the points that they are to hold");
    const std::uint64_t needed = std::uint64_t{message.rowStep} * (message.height - 1) + used;
    if (message.data.size < needed) refuse("it is cut off");
}

void appendFloat(Bytes& bytes, double value) {
    auto word = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    for (int i = 0; i < 4; ++i, word >>= 8)
        bytes.push_back(static_cast<std::uint8_t>(word));
}

}  // namespace

MapCloud mapCloudOf(const CloudMessage& message, const std::optional<Rows>& T_map_from_cloud) {
    requireSizes(message);
    const FieldReader x = coordinate(message, "x");
    const FieldReader y = coordinate(message, "y");
    const FieldReader z = coordinate(message, "z");
    std::optional<FieldReader> colour;
    if (const CloudField* field = colourField(message)) colour.emplace(*field, message);

    MapCloud cloud;
    cloud.stamp_ns = message.stamp_ns;
    const std::size_t count = std::size_t{message.width} * message.height;
    cloud.points.reserve(count * 12);
    if (colour) cloud.colours.reserve(count * 3);
    for (std::uint32_t row = 0; row < message.height; ++row) {
        const std::uint8_t* point = message.data.data + std::size_t{row} * message.rowStep;
        for (std::uint32_t column = 0; column < message.width; ++column, point += message.pointStep) {
            std::array<double, 3> p{x.number(point), y.number(point), z.number(point)};
            if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
                ++cloud.dropped;
                continue;
            }
            if (T_map_from_cloud) {
                const Rows& t = *T_map_from_cloud;
                p = {t[0] * p[0] + t[1] * p[1] + t[2] * p[2] + t[3], t[4] * p[0] + t[5] * p[1] + t[6] * p[2] + t[7],
                     t[8] * p[0] + t[9] * p[1] + t[10] * p[2] + t[11]};
            }
            for (const double value : p)
                appendFloat(cloud.points, value);
            if (!colour) continue;
            const auto bits = colour->bits<std::uint32_t>(point);
            for (const int shift : {16, 8, 0})
                cloud.colours.push_back(static_cast<std::uint8_t>(bits >> shift));
        }
    }
    if (cloud.points.empty()) refuse("none of its points is finite");
    return cloud;
}

}  // namespace fodscope::bridge
