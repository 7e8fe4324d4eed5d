// SPDX-License-Identifier: MIT
#include "core/bridge/CborTree.h"

#include <utility>

#include "core/bridge/BridgeCodec.h"

namespace fodscope::bridge {
namespace {

using nlohmann::json;

constexpr std::size_t kGreatestDepth = 8;

/// Builds the tree from the library's events, and ends the reading where it goes too deep.
class TreeBuilder : public nlohmann::json_sax<json> {
  public:
    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override { return put(value); }
    bool number_float(number_float_t value, const string_t&) override { return put(value); }
    bool string(string_t& value) override { return put(std::move(value)); }
    bool binary(binary_t& value) override { return put(std::move(value)); }
    bool start_object(std::size_t) override { return open(json::object()); }
    bool key(string_t& value) override {
        key_ = std::move(value);
        return true;
    }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t, const std::string&, const json::exception&) override { return false; }

    json take() { return std::move(root_); }

  private:
    json* place(json value) {
        if (open_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        json& parent = *open_.back();
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        return &(parent[key_] = std::move(value));
    }
    bool put(json value) {
        place(std::move(value));
        return true;
    }
    bool open(json value) {
        if (open_.size() == kGreatestDepth) return false;
        open_.push_back(place(std::move(value)));
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    json root_;
    std::vector<json*> open_;
    std::string key_;
};

}  // namespace

json readCbor(const Bytes& body) {
    TreeBuilder builder;
    const bool whole = json::sax_parse(body, &builder, json::input_format_t::cbor);
    if (!whole) throw ProtocolError("it sent a message that cannot be read");
    return builder.take();
}

}  // namespace fodscope::bridge
