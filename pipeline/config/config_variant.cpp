#include "pipeline/config/config_variant.h"

#include <functional>
#include <sstream>

#include "calib/work/error.h"
#include "calib/work/toml_tree.h"
#include "calib/work/whole_file.h"
#include "pipeline/config/plain_capture.h"

namespace lumi {

struct ConfigDocument::Document {
    /// Read anew for every variant: a copy of the tree would not know its lines.
    std::string text;
    toml::table root;
};

namespace {

namespace fs = std::filesystem;

std::string literal_of(const toml::node& node) {
    std::ostringstream text;
    node.visit([&](const auto& value) { text << value; });
    return text.str();
}

[[noreturn]] void refuse(const std::string& name, const toml::node& node,
                         const std::string& setting, const std::string& expected) {
    throw Error(ErrorKind::kUsage, "E-CONFIG-VALUE",
                place_in_toml(node, name) + ": `" + setting + "`: expected " + expected,
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

/// A file of another name was perhaps not meant as a configuration.
toml::table configuration_in(const std::string& text, const fs::path& path) {
    try {
        return parsed_toml(text, path.string());
    } catch (const Error& error) {
        if (path.extension() == ".toml") throw;
        throw Error(error.kind(), error.code(), error.what(),
                    "give a configuration in TOML, a folder of photographs, or a video");
    }
}

/// A value that stands in the section itself says how, not what: "modes", "repeats".
bool is_option(const std::string& name) { return name.find('.') == std::string::npos; }

}  // namespace

std::string literal_of_text(const std::string& text) {
    return literal_of(toml::value<std::string>(text));
}

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
    document.name_ = path.string();
    std::string text;
    if (const std::optional<PlainCapture> plain = plain_capture(path)) {
        const fs::path absolute = fs::absolute(path).lexically_normal();
        text = "[capture]\n" + plain->key + " = " + literal_of_text(absolute.string()) + "\n";
        document.default_build_name_ = plain->name;
        document.folder_ = fs::current_path();
    } else {
        expect_utf8(fs::absolute(path).parent_path());
        text = read_whole_text(path, std::size_t{1} << 24);
        document.default_build_name_ = path.stem().string();
        document.folder_ = fs::absolute(path).parent_path();
    }
    toml::table root = configuration_in(text, path);
    document.document_ = std::make_shared<Document>(Document{std::move(text), std::move(root)});
    return document;
}

bool ConfigDocument::has_tables(const std::string& key) const {
    return document_->root[key].is_array_of_tables();
}

ConfigSection ConfigDocument::options_of(const std::string& section) const {
    const ConfigSection whole = ConfigSection::from_text(document_->text, name_, folder_);
    for (const auto& [key, node] : document_->root) {
        if (key.str() != section) whole.leave_to_others(std::string(key.str()));
    }
    ConfigSection options = whole.section(section);
    if (const toml::table* table = document_->root[section].as_table()) {
        for (const auto& [key, node] : *table) {
            if (node.is_table()) options.leave_to_others(std::string(key.str()));
        }
    }
    return options;
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

BuildConfig ConfigDocument::build_config_with(const std::vector<ConfigChange>& changes) const {
    if (has_tables("scene")) {
        throw Error(ErrorKind::kUsage, "E-CONFIG-DATASET",
                    name_ + ": a dataset of scenes ([[scene]]), where one capture is expected",
                    "`lumi build " + name_ +
                        "` builds all its scenes, without --target; elsewhere "
                        "name the configuration of one scene");
    }
    return read_build_config(ConfigSection::from_text(document_->text, name_, folder_, changes),
                             default_build_name_);
}

}  // namespace lumi
