#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lumi {

/// One object of a JSON document that may come from anyone, read field by field. Every member
/// throws Error (E-PACKAGE-MANIFEST) that names the field and what was expected. Copies share one
/// document.
class StrictJsonObject {
 public:
    /// The document's outermost object: at most `max_depth` levels of nesting (the parser itself
    /// overflows the stack at 1e5) and no key twice in one object; `where` begins each message.
    [[nodiscard]] static StrictJsonObject parse(std::string_view text, int max_depth,
                                                const std::string& where);

    [[nodiscard]] bool has(const std::string& key) const;
    [[nodiscard]] StrictJsonObject object(const std::string& key) const;
    /// Between 1 and `max_count` objects.
    [[nodiscard]] std::vector<StrictJsonObject> objects(const std::string& key,
                                                        std::size_t max_count) const;
    /// Finite.
    [[nodiscard]] double number(const std::string& key) const;
    [[nodiscard]] double number(const std::string& key, double min, double max) const;
    [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t count) const;
    [[nodiscard]] int integer(const std::string& key, int min, int max) const;
    [[nodiscard]] std::uint64_t byte_count(const std::string& key) const;
    [[nodiscard]] bool boolean(const std::string& key) const;
    [[nodiscard]] std::string text(const std::string& key) const;
    /// The object as JSON text.
    [[nodiscard]] std::string json_text() const;

    /// An Error about the field `key`.
    [[noreturn]] void refuse(const std::string& key, const std::string& expected) const;

 private:
    struct Node;  ///< A place in the parsed document.
    StrictJsonObject(std::shared_ptr<const Node> node, std::string where);
    [[nodiscard]] Node field(const std::string& key) const;

    std::shared_ptr<const Node> node_;
    std::string where_;
};

}  // namespace lumi
