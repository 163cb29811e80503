#include "render/lumigraph/strict_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "calib/work/error.h"
#include "calib/work/formatted.h"
#include "calib/work/json_fault.h"
#include "calib/work/printable.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse_manifest(const std::string& where_and_what) {
    throw Error(ErrorKind::kBadInput, "E-PACKAGE-MANIFEST", printable(where_and_what),
                "the package is damaged: copy it again, or build it again with `lumi build`");
}

[[noreturn]] void refuse_manifest(const std::string& where, const std::string& what) {
    refuse_manifest(where + ": " + what);
}

double finite_number(const Json& value, const StrictJsonObject& object, const std::string& key) {
    if (!value.is_number()) object.refuse(key, "a number");
    const double number = value.get<double>();
    if (!std::isfinite(number)) object.refuse(key, "a finite number");
    return number;
}

Json parse_bounded(std::string_view text, int max_depth, const std::string& where) {
    std::vector<std::set<std::string>> keys_of_open_objects;
    const auto check = [&](int depth, Json::parse_event_t event, Json& parsed) {
        if (depth >= max_depth && (event == Json::parse_event_t::object_start ||
                                   event == Json::parse_event_t::array_start)) {
            refuse_manifest(where,
                            "expected at most " + std::to_string(max_depth) + " levels of nesting");
        }
        if (event == Json::parse_event_t::object_start) keys_of_open_objects.emplace_back();
        if (event == Json::parse_event_t::object_end) keys_of_open_objects.pop_back();
        if (event == Json::parse_event_t::key) {
            const auto key = parsed.get<std::string>();
            if (!keys_of_open_objects.back().insert(key).second) {
                refuse_manifest(where, "the key '" + key + "' stands twice in one object");
            }
        }
        return true;
    };
    try {
        return Json::parse(text, check);
    } catch (const Json::exception& exception) {
        refuse_manifest(json_fault(where, exception));
    }
}

}  // namespace

struct StrictJsonObject::Node {
    std::shared_ptr<const Json> document;  ///< Keeps `value` alive.
    const Json* value;
};

StrictJsonObject StrictJsonObject::parse(std::string_view text, int max_depth,
                                         const std::string& where) {
    auto document = std::make_shared<const Json>(parse_bounded(text, max_depth, where));
    const Json* value = document.get();
    return {std::make_shared<const Node>(Node{std::move(document), value}), where};
}

StrictJsonObject::StrictJsonObject(std::shared_ptr<const Node> node, std::string where)
    : node_(std::move(node)), where_(std::move(where)) {
    if (!node_->value->is_object()) refuse_manifest(where_, "expected an object");
}

void StrictJsonObject::refuse(const std::string& key, const std::string& expected) const {
    refuse_manifest(where_ + "." + key, "expected " + expected);
}

StrictJsonObject::Node StrictJsonObject::field(const std::string& key) const {
    const auto found = node_->value->find(key);
    if (found == node_->value->end()) refuse_manifest(where_, "expected a field '" + key + "'");
    return {node_->document, &*found};
}

bool StrictJsonObject::has(const std::string& key) const { return node_->value->contains(key); }

StrictJsonObject StrictJsonObject::object(const std::string& key) const {
    return {std::make_shared<const Node>(field(key)), where_ + "." + key};
}

std::vector<StrictJsonObject> StrictJsonObject::objects(const std::string& key,
                                                        std::size_t max_count) const {
    const Node node = field(key);
    const Json& array = *node.value;
    if (!array.is_array() || array.empty() || array.size() > max_count) {
        refuse(key, "a list of 1 to " + std::to_string(max_count));
    }
    std::vector<StrictJsonObject> result;
    for (std::size_t i = 0; i < array.size(); ++i) {
        result.push_back({std::make_shared<const Node>(Node{node.document, &array[i]}),
                          where_ + "." + key + "[" + std::to_string(i) + "]"});
    }
    return result;
}

double StrictJsonObject::number(const std::string& key) const {
    return finite_number(*field(key).value, *this, key);
}

double StrictJsonObject::number(const std::string& key, double min, double max) const {
    const double value = number(key);
    if (value < min || value > max) refuse(key, formatted("a number from %g to %g", min, max));
    return value;
}

std::vector<double> StrictJsonObject::numbers(const std::string& key, std::size_t count) const {
    const Json& array = *field(key).value;
    if (!array.is_array() || array.size() != count) {
        refuse(key, "a list of " + std::to_string(count) + " numbers");
    }
    std::vector<double> result;
    for (const Json& value : array) result.push_back(finite_number(value, *this, key));
    return result;
}

int StrictJsonObject::integer(const std::string& key, int min, int max) const {
    const Json& value = *field(key).value;
    const bool in_range = value.is_number_unsigned()
                              ? value.get<std::uint64_t>() <= static_cast<std::uint64_t>(max) &&
                                    static_cast<int>(value.get<std::uint64_t>()) >= min
                              : value.is_number_integer() && value.get<std::int64_t>() >= min &&
                                    value.get<std::int64_t>() <= max;
    if (!in_range) {
        refuse(key, "a whole number from " + std::to_string(min) + " to " + std::to_string(max));
    }
    return value.get<int>();
}

std::uint64_t StrictJsonObject::byte_count(const std::string& key) const {
    const Json& value = *field(key).value;
    if (!value.is_number_unsigned()) refuse(key, "a count of bytes");
    return value.get<std::uint64_t>();
}

bool StrictJsonObject::boolean(const std::string& key) const {
    const Json& value = *field(key).value;
    if (!value.is_boolean()) refuse(key, "true or false");
    return value.get<bool>();
}

std::string StrictJsonObject::text(const std::string& key) const {
    const Json& value = *field(key).value;
    if (!value.is_string()) refuse(key, "a text");
    return value.get<std::string>();
}

std::string StrictJsonObject::json_text() const { return node_->value->dump(); }

}  // namespace lumi
