#pragma once

#include <exception>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lumi {

/// A JSON file of bounded size and depth. Throws Error (E-JSON-READ) naming the file.
[[nodiscard]] nlohmann::ordered_json read_json_file(const std::filesystem::path& path);
[[nodiscard]] nlohmann::ordered_json parse_json(const std::string& text, const std::string& where);

/// Throws Error (E-JSON-READ): the file parses, but `reason` is wrong with it.
[[noreturn]] void refuse_json(const std::filesystem::path& path, const std::string& reason);
/// The same of what the JSON library threw.
[[noreturn]] void refuse_json(const std::filesystem::path& path, const std::exception& fault);

/// Indented UTF-8, keys in the order they were added; whole or not at all. Throws Error
/// (E-JSON-TEXT) when a text in it is not UTF-8, and E-FILE-WRITE.
void write_json_file(const std::filesystem::path& path, const nlohmann::ordered_json& json);
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

}  // namespace lumi
