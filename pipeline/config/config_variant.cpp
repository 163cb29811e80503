#include "pipeline/config/config_variant.h"

#include <toml++/toml.h>
#include <functional>
#include <sstream>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/config/plain_capture.h"

namespace lumi {

struct ConfigDocument::Document {
    toml::table root;
};

namespace {

namespace fs = std::filesystem;

toml::table parsed(const std::string& text, const std::string& name) {
    try {
        return toml::parse(text, name);
    } catch (const toml::parse_error& error) {
        std::ostringstream where;
        where << name << ":" << error.source().begin.line << ":" << error.source().begin.column
              << ": " << error.description();
        throw Error(ErrorKind::kUsage, "E-CONFIG-SYNTAX", where.str(),
                    "mend the TOML syntax there");
    }
}

std::string text_of(const toml::table& table) {
    std::ostringstream text;
    text << table << "\n";
    return text.str();
}

std::string literal_of(const toml::node& node) {
    std::ostringstream text;
    node.visit([&](const auto& value) { text << value; });
    return text.str();
}

[[noreturn]] void refuse(const std::string& name, const toml::node& node,
                         const std::string& setting, const std::string& expected) {
    throw Error(ErrorKind::kUsage, "E-CONFIG-VALUE",
                name + ":" + std::to_string(node.source().begin.line) + ": `" + setting +
                    "`: expected " + expected,
                "correct this key, or remove it");
}

/// Calls `found` for every value at or below `table`, with its dotted name.
void visit_values(const toml::table& table, const std::string& path,
                  const std::function<void(const std::string&, const toml::node&)>& found) {
    for (const auto& [key, node] : table) {
        const std::string name = (path.empty() ? "" : path + '.') + std::string(key.str());
        if (const toml::table* below = node.as_table()) {
            visit_values(*below, name, found);
        } else {
            found(name, node);
        }
    }
}

/// A value that stands in the section itself says how, not what: "modes", "repeats".
bool is_option(const std::string& name) { return name.find('.') == std::string::npos; }

void set(toml::table& root, const ConfigChange& change, const std::string& name) {
    toml::table* table = &root;
    std::string rest = change.setting;
    for (std::size_t dot = rest.find('.'); dot != std::string::npos; dot = rest.find('.')) {
        const std::string key = rest.substr(0, dot);
        rest = rest.substr(dot + 1);
        if (!table->contains(key)) table->insert(key, toml::table{});
        toml::table* below = table->get(key)->as_table();
        if (below == nullptr) refuse(name, *table->get(key), change.setting, "a table");
        table = below;
    }
    toml::table value = parsed("value = " + change.literal, name);
    value.get("value")->visit([&](auto& node) { table->insert_or_assign(rest, std::move(node)); });
}

}  // namespace

std::vector<std::string> ConfigList::words() const {
    std::vector<std::string> words;
    for (const std::string& literal : literals) {
        const bool is_quoted = literal.size() >= 2 && (literal[0] == '"' || literal[0] == '\'');
        words.push_back(is_quoted ? literal.substr(1, literal.size() - 2) : literal);
    }
    return words;
}

ConfigDocument ConfigDocument::open(const fs::path& path) {
    ConfigDocument document;
    auto content = std::make_shared<Document>();
    document.name_ = path.string();
    if (const std::optional<PlainCapture> plain = plain_capture(path)) {
        const fs::path absolute = fs::absolute(path).lexically_normal();
        content->root.insert("capture", toml::table{{plain->key, absolute.string()}});
        document.default_build_name_ = plain->name;
        document.folder_ = fs::current_path();
    } else {
        content->root = parsed(read_whole_text(path, std::size_t{1} << 24), path.string());
        document.default_build_name_ = path.stem().string();
        document.folder_ = fs::absolute(path).parent_path();
    }
    document.document_ = std::move(content);
    return document;
}

bool ConfigDocument::has_tables(const std::string& key) const {
    return document_->root[key].is_array_of_tables();
}

ConfigSection ConfigDocument::options_of(const std::string& section) const {
    toml::table options;
    if (const toml::table* table = document_->root[section].as_table()) {
        for (const auto& [key, node] : *table) {
            if (node.is_table()) continue;
            node.visit([&](const auto& value) { options.insert(key, value); });
        }
    }
    return ConfigSection::from_text(text_of(options), name_ + " [" + section + "]", folder_);
}

std::vector<ConfigList> ConfigDocument::lists_of(const std::string& section) const {
    std::vector<ConfigList> lists;
    const toml::table* table = document_->root[section].as_table();
    if (table == nullptr) return lists;
    visit_values(*table, "", [&](const std::string& setting, const toml::node& node) {
        if (is_option(setting)) return;
        const toml::array* array = node.as_array();
        if (array == nullptr || array->empty()) {
            refuse(name_, node, section + '.' + setting, "a list of values to try");
        }
        ConfigList list{setting, {}};
        for (const toml::node& value : *array) list.literals.push_back(literal_of(value));
        lists.push_back(std::move(list));
    });
    return lists;
}

std::vector<ConfigChange> ConfigDocument::changes_of(const std::string& section) const {
    std::vector<ConfigChange> changes;
    const toml::table* table = document_->root.at_path(section).as_table();
    if (table == nullptr) return changes;
    visit_values(*table, "", [&](const std::string& setting, const toml::node& node) {
        changes.push_back({setting, literal_of(node)});
    });
    return changes;
}

std::string ConfigDocument::text_with(const std::vector<ConfigChange>& changes) const {
    toml::table root = document_->root;
    for (const ConfigChange& change : changes) set(root, change, name_);
    return text_of(root);
}

BuildConfig ConfigDocument::build_config_with(const std::vector<ConfigChange>& changes) const {
    return read_build_config(ConfigSection::from_text(text_with(changes), name_, folder_),
                             default_build_name_);
}

}  // namespace lumi
