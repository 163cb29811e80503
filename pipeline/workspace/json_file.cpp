#include "pipeline/workspace/json_file.h"

#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/json_fault.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMaxDepth = 64;  // Far beyond what lumi writes, far below what overflows the stack.
constexpr std::size_t kMaxBytes = std::size_t{256} << 20;

[[noreturn]] void refuse(const std::string& what_and_where) {
    throw Error(ErrorKind::kBadInput, "E-JSON-READ", what_and_where,
                "the file is damaged or was edited: make it again");
}

}  // namespace

Json parse_json(const std::string& text, const std::string& where) {
    const auto limit_depth = [&](int depth, Json::parse_event_t, Json&) {
        if (depth > kMaxDepth) refuse(where + ": nested too deeply");
        return true;
    };
    try {
        return Json::parse(text, limit_depth);
    } catch (const Json::exception& error) {
        refuse(json_fault(where, error));
    }
}

void refuse_json(const std::filesystem::path& path, const std::string& reason) {
    refuse(path.string() + ": " + reason);
}

void refuse_json(const std::filesystem::path& path, const std::exception& fault) {
    refuse(json_fault(path.string(), fault));
}

Json read_json_file(const std::filesystem::path& path) {
    return parse_json(read_whole_text(path, kMaxBytes), path.string());
}

std::string json_text(const Json& json) {
    try {
        return json.dump(2) + "\n";
    } catch (const Json::type_error&) {
        throw Error(ErrorKind::kBadInput, "E-JSON-TEXT",
                    "a name among the photographs is not valid UTF-8",
                    "rename the file so that its name is plain text");
    }
}

void write_json_file(const std::filesystem::path& path, const Json& json) {
    write_whole_text(path, json_text(json));
}

}  // namespace lumi
