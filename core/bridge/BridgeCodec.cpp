// SPDX-License-Identifier: MIT
#include "core/bridge/BridgeCodec.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "core/bridge/CborTree.h"
#include "core/bridge/MessageFields.h"

namespace fodscope::bridge {
namespace {

using nlohmann::json;

constexpr const char* kName = "is";

template <class Value>
constexpr bool isMessage = kMessageName<Value> != nullptr;

// --- writing ---------------------------------------------------------------------------------------------------------

class Writer {
  public:
    template <class Value>
    void operator()(const char* name, Value& value) {
        tree_[name] = written(value);
    }
    template <class Value>
    void operator()(const char* name, std::optional<Value>& value) {
        if (value) tree_[name] = written(*value);
    }
    json take() { return std::move(tree_); }

  private:
    static json written(Bytes& value) { return json::binary(std::move(value)); }
    static json written(PlanarPose& pose) { return {pose.x_m, pose.y_m, pose.yaw_rad}; }
    template <class Value>
    static json written(std::vector<Value>& values) {
        json list = json::array();
        for (Value& value : values)
            list.push_back(written(value));
        return list;
    }
    template <class Value>
    static json written(Value& value) {
        if constexpr (isMessage<Value>) {
            Writer fields;
            visitFields(fields, value);
            return fields.take();
        } else if constexpr (std::is_enum_v<Value>) {
            return static_cast<int>(value);
        } else {
            return value;
        }
    }

    json tree_ = json::object();
};

template <class Variant>
Bytes encodeAny(Variant message) {
    const json tree = std::visit(
        [](auto& each) {
            Writer writer;
            visitFields(writer, each);
            json fields = writer.take();
            fields[kName] = kMessageName<std::decay_t<decltype(each)>>;
            return fields;
        },
        message);
    return json::to_cbor(tree);
}

// --- reading ---------------------------------------------------------------------------------------------------------

template <class Enum>
constexpr int kGreatest = -1;
template <>
constexpr int kGreatest<Link> = static_cast<int>(Link::Lost);
template <>
constexpr int kGreatest<GoalProblem> = static_cast<int>(GoalProblem::StopRequested);
template <>
constexpr int kGreatest<PhotoProblem> = static_cast<int>(PhotoProblem::TimedOut);

void require(bool holds, const std::string& name, const char* what) {
    if (!holds) throw ProtocolError("its field '" + name + "' " + what);
}

void read(json& tree, const std::string& name, bool& value) {
    require(tree.is_boolean(), name, "is no truth value");
    value = tree.get<bool>();
}

void read(json& tree, const std::string& name, double& value) {
    require(tree.is_number(), name, "is no number");
    value = tree.get<double>();
    require(std::isfinite(value), name, "is not finite");
}

void read(json& tree, const std::string& name, std::string& value) {
    require(tree.is_string(), name, "is no text");
    value = std::move(tree.get_ref<std::string&>());
}

void read(json& tree, const std::string& name, Bytes& value) {
    require(tree.is_binary(), name, "is no byte string");
    value = std::move(static_cast<Bytes&>(tree.get_binary()));
}

template <class Integer>
requires std::is_integral_v<Integer>
void read(json& tree, const std::string& name, Integer& value) {
    require(tree.is_number_integer(), name, "is no whole number");
    const bool fits = tree.is_number_unsigned() ? std::in_range<Integer>(tree.get<std::uint64_t>())
                                                : std::in_range<Integer>(tree.get<std::int64_t>());
    require(fits, name, "is out of range");
    value = tree.get<Integer>();
}

template <class Enum>
requires std::is_enum_v<Enum>
void read(json& tree, const std::string& name, Enum& value) {
    int number = -1;
    read(tree, name, number);
    require(number >= 0 && number <= kGreatest<Enum>, name, "is out of range");
    value = static_cast<Enum>(number);
}

template <std::size_t Size>
void read(json& tree, const std::string& name, std::array<double, Size>& values) {
    require(tree.is_array() && tree.size() == Size, name, "has a wrong number of values");
    for (std::size_t i = 0; i < Size; ++i)
        read(tree[i], name, values[i]);
}

void read(json& tree, const std::string& name, PlanarPose& pose) {
    std::array<double, 3> values{};
    read(tree, name, values);
    pose = {values[0], values[1], values[2]};
}

void read(json& tree, const std::string& name, std::map<std::string, std::string>& values) {
    require(tree.is_object(), name, "is no table");
    for (auto& entry : tree.items())
        read(entry.value(), name, values[entry.key()]);
}

class Reader {
  public:
    explicit Reader(json& tree) : tree_(tree) {}

    template <class Value>
    void operator()(const char* name, Value& value) {
        const auto found = tree_.find(name);
        require(found != tree_.end(), name, "is missing");
        readOne(*found, name, value);
    }
    template <class Value>
    void operator()(const char* name, std::optional<Value>& value) {
        const auto found = tree_.find(name);
        if (found != tree_.end()) readOne(*found, name, value.emplace());
    }

  private:
    template <class Value>
    static void readOne(json& tree, const std::string& name, Value& value) {
        if constexpr (isMessage<Value>) {
            require(tree.is_object(), name, "is no table");
            Reader reader(tree);
            visitFields(reader, value);
        } else {
            read(tree, name, value);
        }
    }
    template <class Value>
    requires(!std::is_same_v<Value, std::uint8_t>) static void readOne(json& tree, const std::string& name,
                                                                       std::vector<Value>& values) {
        require(tree.is_array(), name, "is no list");
        values.resize(tree.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            readOne(tree[i], name, values[i]);
    }

    json& tree_;
};

template <class Message, class Variant>
bool readAs(json& tree, const std::string& name, Variant& message) {
    if (name != kMessageName<Message>) return false;
    Reader reader(tree);
    visitFields(reader, message.template emplace<Message>());
    return true;
}

template <class... Messages>
std::variant<Messages...> decodeAny(const Bytes& body, std::variant<Messages...> message) {
    json tree = readCbor(body);
    if (!tree.is_object() || !tree.contains(kName) || !tree[kName].is_string())
        throw ProtocolError("it sent a message without a name");
    const std::string name = tree[kName].template get<std::string>();
    if (!(readAs<Messages>(tree, name, message) || ...)) throw ProtocolError("it sent a message of an unknown kind");
    return message;
}

}  // namespace

Bytes encode(const Request& request) {
    return encodeAny(request);
}

Bytes encode(const Event& event) {
    return encodeAny(event);
}

Request decodeRequest(const Bytes& body) {
    return decodeAny(body, Request{});
}

Event decodeEvent(const Bytes& body) {
    return decodeAny(body, Event{});
}

}  // namespace fodscope::bridge
