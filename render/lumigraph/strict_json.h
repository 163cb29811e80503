#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lumi {

/// Parses JSON that may come from anyone: at most `max_depth` levels of nesting (the parser itself
/// overflows the stack at 1e5) and no key twice in one object. Throws Error (E-PACKAGE-MANIFEST);
/// `where` begins the message.
[[nodiscard]] nlohmann::ordered_json parse_strict_json(std::string_view text, int max_depth,
                                                       const std::string& where);

/// One object of a JSON document, read field by field. Every getter throws Error
/// (E-PACKAGE-MANIFEST) that names the field and what was expected. Refers to the document, which
/// must outlive it.
class StrictJsonObject {
 public:
    StrictJsonObject(const nlohmann::ordered_json& value, std::string where);

    [[nodiscard]] bool has(const std::string& key) const;
    [[nodiscard]] StrictJsonObject object(const std::string& key) const;
    /// Between 1 and `max_count` objects.
    [[nodiscard]] std::vector<StrictJsonObject> objects(const std::string& key,
                                                        std::size_t max_count) const;
    /// Finite.
    [[nodiscard]] double number(const std::string& key) const;
    [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t count) const;
    [[nodiscard]] int integer(const std::string& key, int min, int max) const;
    [[nodiscard]] std::uint64_t byte_count(const std::string& key) const;
    [[nodiscard]] std::string text(const std::string& key) const;
    /// The object as JSON text.
    [[nodiscard]] std::string json_text() const;

    /// An Error about the field `key`.
    [[noreturn]] void refuse(const std::string& key, const std::string& expected) const;

 private:
    [[nodiscard]] const nlohmann::ordered_json& field(const std::string& key) const;

    const nlohmann::ordered_json* value_;
    std::string where_;
};

}  // namespace lumi
