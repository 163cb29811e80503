#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lumi {

/// One setting of a configuration and what it is to be, as it would stand in the file: 768,
/// "sweep".
struct ConfigChange {
    std::string setting;  ///< Dotted: "depth.model".
    std::string literal;
};

/// One table of a TOML file, read strictly.
///
/// Each stage reads its own section with defaults at hand; what nobody asked for is an error with a
/// suggestion. The section remembers every answer it gave, so that the resolved configuration can
/// be written out with its defaults filled in. Copies share one document.
///
/// All getters throw Error (kUsage, E-CONFIG-VALUE) with file, line and key when the value has
/// another type.
class ConfigSection {
 public:
    /// Throws Error (E-CONFIG-SYNTAX) with line and column, or E-FILE-READ.
    [[nodiscard]] static ConfigSection from_file(const std::filesystem::path& path);
    [[nodiscard]] static ConfigSection from_text(std::string_view toml, std::string name);
    /// Paths in it are relative to `folder`. Errors name what was changed as such, and the lines of
    /// all else.
    [[nodiscard]] static ConfigSection from_text(std::string_view toml, std::string name,
                                                 const std::filesystem::path& folder,
                                                 const std::vector<ConfigChange>& changes = {});

    [[nodiscard]] bool has(const std::string& key) const;
    /// The table below `key`; an empty one when it is absent.
    [[nodiscard]] ConfigSection section(const std::string& key) const;
    /// What stands below `key` is for others to read: none of it is unknown here.
    void leave_to_others(const std::string& key) const;
    /// The tables of the array of tables `[[key]]`; none when it is absent.
    [[nodiscard]] std::vector<ConfigSection> sections(const std::string& key) const;

    [[nodiscard]] double number(const std::string& key, double fallback) const;
    [[nodiscard]] int integer(const std::string& key, int fallback) const;
    [[nodiscard]] bool boolean(const std::string& key, bool fallback) const;
    [[nodiscard]] std::string text(const std::string& key, const std::string& fallback) const;
    [[nodiscard]] std::vector<std::string> texts(const std::string& key,
                                                 std::vector<std::string> fallback) const;
    [[nodiscard]] std::vector<double> numbers(const std::string& key,
                                              std::vector<double> fallback) const;

    /// A path relative to the configuration file, made absolute; empty when absent.
    [[nodiscard]] std::filesystem::path path(const std::string& key) const;

    /// Where a key stands: "my.toml:7"; the document alone where it does not.
    [[nodiscard]] std::string place_of(const std::string& key) const;

    /// An Error (kUsage, E-CONFIG-VALUE) that names file, line and key; for range checks.
    [[noreturn]] void refuse(const std::string& key, const std::string& expected) const;

    /// Throws Error (E-CONFIG-KEY) for the first key of this whole document that no getter asked
    /// for, with the nearest known key as a suggestion.
    void expect_all_keys_known() const;

    /// The document as asked: every key that was read, with the value that was answered, as TOML.
    [[nodiscard]] std::string resolved() const;
    /// The same with every path absolute, so that it says the same in any folder.
    [[nodiscard]] std::string resolved_for_any_folder() const;
    /// This table alone, without the named keys: what identifies the parameters of one stage.
    [[nodiscard]] std::string resolved_table(const std::vector<std::string>& without = {}) const;

 private:
    struct Document;
    struct Table;
    ConfigSection(std::shared_ptr<Document> document, std::shared_ptr<Table> table);
    std::shared_ptr<Document> document_;
    std::shared_ptr<Table> table_;
};

}  // namespace lumi
