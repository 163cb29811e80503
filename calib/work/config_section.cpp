#include "calib/work/config_section.h"

#include <toml++/toml.h>
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "calib/work/error.h"
#include "calib/work/nearest_word.h"
#include "calib/work/toml_text.h"
#include "calib/work/toml_tree.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

enum class PathSpelling { kAsGiven, kAbsolute };

}  // namespace

struct ConfigSection::Document {
    toml::table root;
    std::string name;
    std::filesystem::path folder;
    std::shared_ptr<Table> top;
};

/// A table of the document and what has been asked of it so far.
struct ConfigSection::Table {
    std::string path;                   ///< Dotted, "" for the document itself.
    const toml::table* toml = nullptr;  ///< nullptr when the file does not have it.
    toml::table answers;
    std::map<std::string, std::string> absolute_paths;  ///< Of those answers that are paths.
    std::set<std::string> asked;
    std::map<std::string, std::shared_ptr<Table>> tables;
    std::map<std::string, std::vector<std::shared_ptr<Table>>> table_arrays;

    /// Every answer given, here and below.
    [[nodiscard]] toml::table resolved(PathSpelling spelling) const {
        toml::table result = answers;
        if (spelling == PathSpelling::kAbsolute) {
            for (const auto& [key, absolute] : absolute_paths)
                result.insert_or_assign(key, absolute);
        }
        for (const auto& [key, child] : tables)
            result.insert_or_assign(key, child->resolved(spelling));
        for (const auto& [key, children] : table_arrays) {
            toml::array array;
            for (const auto& child : children) array.push_back(child->resolved(spelling));
            result.insert_or_assign(key, std::move(array));
        }
        return result;
    }
};

namespace {

std::string joined(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
}

std::string place(const std::string& name, const toml::node* node) {
    return node == nullptr ? name : place_in_toml(*node, name);
}

std::string suggestion_for(const std::string& key, const std::set<std::string>& known) {
    if (known.empty()) return "remove the key";
    if (const auto meant = nearest_word(key, known)) return "did you mean `" + *meant + "`?";
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    return "known here: " + list;
}

}  // namespace

ConfigSection::ConfigSection(std::shared_ptr<Document> document, std::shared_ptr<Table> table)
    : document_(std::move(document)), table_(std::move(table)) {}

ConfigSection ConfigSection::from_text(std::string_view toml, std::string name) {
    return from_text(toml, std::move(name), std::filesystem::current_path());
}

ConfigSection ConfigSection::from_text(std::string_view toml, std::string name,
                                       const std::filesystem::path& folder,
                                       const std::vector<ConfigChange>& changes) {
    auto document = std::make_shared<Document>();
    document->root = parsed_toml(toml, name);
    for (const ConfigChange& change : changes) change_toml(document->root, change, name);
    document->name = std::move(name);
    document->folder = std::filesystem::absolute(folder);
    document->top = std::make_shared<Table>();
    document->top->toml = &document->root;
    return {document, document->top};
}

ConfigSection ConfigSection::from_file(const std::filesystem::path& path) {
    return from_text(read_whole_text(path, std::size_t{1} << 24), path.string(),
                     std::filesystem::absolute(path).parent_path());
}

bool ConfigSection::has(const std::string& key) const {
    return table_->toml != nullptr && table_->toml->contains(key);
}

ConfigSection ConfigSection::section(const std::string& key) const {
    table_->asked.insert(key);
    std::shared_ptr<Table>& child = table_->tables[key];
    if (!child) {
        child = std::make_shared<Table>();
        child->path = joined(table_->path, key);
        if (has(key)) {
            child->toml = table_->toml->get(key)->as_table();
            if (child->toml == nullptr) refuse(key, "a table");
        }
    }
    return {document_, child};
}

void ConfigSection::leave_to_others(const std::string& key) const { table_->asked.insert(key); }

std::vector<ConfigSection> ConfigSection::sections(const std::string& key) const {
    table_->asked.insert(key);
    std::vector<std::shared_ptr<Table>>& children = table_->table_arrays[key];
    if (children.empty() && has(key)) {
        const toml::array* array = table_->toml->get(key)->as_array();
        if (array == nullptr || !array->is_array_of_tables()) refuse(key, "an array of tables");
        for (std::size_t index = 0; index < array->size(); ++index) {
            auto child = std::make_shared<Table>();
            child->path = joined(table_->path, key) + "[" + std::to_string(index) + "]";
            child->toml = array->get(index)->as_table();
            children.push_back(child);
        }
    }
    std::vector<ConfigSection> result;
    for (const auto& child : children) result.push_back({document_, child});
    return result;
}

std::string ConfigSection::place_of(const std::string& key) const {
    return place(document_->name, has(key) ? table_->toml->get(key) : nullptr);
}

void ConfigSection::refuse(const std::string& key, const std::string& expected) const {
    throw Error(ErrorKind::kUsage, "E-CONFIG-VALUE",
                place_of(key) + ": `" + joined(table_->path, key) + "`: expected " + expected,
                has(key) ? "correct this key, or remove it to use the default" : "add this key");
}

double ConfigSection::number(const std::string& key, double fallback) const {
    table_->asked.insert(key);
    std::optional<double> value = fallback;
    if (has(key)) value = table_->toml->get(key)->value<double>();
    if (!value || !std::isfinite(*value)) refuse(key, "a finite number");
    table_->answers.insert_or_assign(key, *value);
    return *value;
}

int ConfigSection::integer(const std::string& key, int fallback) const {
    table_->asked.insert(key);
    std::optional<int> value = fallback;
    if (has(key)) {
        const toml::node* node = table_->toml->get(key);
        value = node->is_integer() ? node->value<int>() : std::nullopt;
    }
    if (!value) refuse(key, "a whole number");
    table_->answers.insert_or_assign(key, *value);
    return *value;
}

bool ConfigSection::boolean(const std::string& key, bool fallback) const {
    table_->asked.insert(key);
    std::optional<bool> value = fallback;
    if (has(key)) {
        const toml::node* node = table_->toml->get(key);
        value = node->is_boolean() ? node->value<bool>() : std::nullopt;
    }
    if (!value) refuse(key, "true or false");
    table_->answers.insert_or_assign(key, *value);
    return *value;
}

std::string ConfigSection::text(const std::string& key, const std::string& fallback) const {
    table_->asked.insert(key);
    std::optional<std::string> value = fallback;
    if (has(key)) value = table_->toml->get(key)->value_exact<std::string>();
    if (!value) refuse(key, "a text in quotes");
    table_->answers.insert_or_assign(key, *value);
    return *value;
}

std::vector<std::string> ConfigSection::texts(const std::string& key,
                                              std::vector<std::string> fallback) const {
    table_->asked.insert(key);
    std::vector<std::string> values = std::move(fallback);
    if (has(key)) {
        values.clear();
        const toml::array* array = table_->toml->get(key)->as_array();
        if (array == nullptr) refuse(key, "a list of texts");
        for (const toml::node& node : *array) {
            const auto value = node.value_exact<std::string>();
            if (!value) refuse(key, "a list of texts");
            values.push_back(*value);
        }
    }
    toml::array answer;
    for (const std::string& value : values) answer.push_back(value);
    table_->answers.insert_or_assign(key, std::move(answer));
    return values;
}

std::vector<double> ConfigSection::numbers(const std::string& key,
                                           std::vector<double> fallback) const {
    table_->asked.insert(key);
    std::vector<double> values = std::move(fallback);
    if (has(key)) {
        values.clear();
        const toml::array* array = table_->toml->get(key)->as_array();
        if (array == nullptr) refuse(key, "a list of numbers");
        for (const toml::node& node : *array) {
            const auto value = node.value<double>();
            if (!value || !std::isfinite(*value)) refuse(key, "a list of finite numbers");
            values.push_back(*value);
        }
    }
    toml::array answer;
    for (const double value : values) answer.push_back(value);
    table_->answers.insert_or_assign(key, std::move(answer));
    return values;
}

std::filesystem::path ConfigSection::path(const std::string& key) const {
    const std::string value = text(key, "");
    if (value.empty()) return {};
    std::filesystem::path path = (document_->folder / value).lexically_normal();
    table_->absolute_paths[key] = path.string();
    return path;
}

void ConfigSection::expect_all_keys_known() const {
    const auto check = [this](const auto& self, const Table& table) -> void {
        if (table.toml != nullptr) {
            for (const auto& [key, node] : *table.toml) {
                const std::string name(key.str());
                if (table.asked.contains(name)) continue;
                throw Error(ErrorKind::kUsage, "E-CONFIG-KEY",
                            place(document_->name, &node) + ": unknown key `" +
                                joined(table.path, name) + "`",
                            suggestion_for(name, table.asked));
            }
        }
        for (const auto& [key, child] : table.tables) self(self, *child);
        for (const auto& [key, children] : table.table_arrays) {
            for (const auto& child : children) self(self, *child);
        }
    };
    check(check, *document_->top);
}

std::string ConfigSection::resolved() const {
    return readable_text_of(document_->top->resolved(PathSpelling::kAsGiven));
}

std::string ConfigSection::resolved_for_any_folder() const {
    return readable_text_of(document_->top->resolved(PathSpelling::kAbsolute));
}

std::string ConfigSection::resolved_table(const std::vector<std::string>& without) const {
    toml::table table = table_->resolved(PathSpelling::kAsGiven);
    for (const std::string& key : without) table.erase(key);
    return text_of(table);
}

}  // namespace lumi
