#include "calib/work/toml_tree.h"

#include "calib/work/error.h"

namespace lumi {
namespace {

[[noreturn]] void refuse_syntax(const std::string& where, const toml::parse_error& error) {
    throw Error(ErrorKind::kUsage, "E-CONFIG-SYNTAX",
                where + ": " + std::string(error.description()), "mend the TOML syntax there");
}

/// depth.model as TOML has it, whatever signs its parts have: "depth"."model".
std::string quoted_key(const std::string& setting) {
    std::string quoted = "\"";
    for (const char c : setting) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c == '.' ? std::string("\".\"") : std::string(1, c);
    }
    return quoted + "\"";
}

/// Moves the nodes of one table into another: copies would not know where they stand.
void move_nodes(toml::table& into, toml::table& from, const std::string& setting,
                const std::string& name) {
    for (auto&& [key, node] : from) {
        toml::node* there = into.get(key);
        if (there == nullptr || !node.is_table()) {
            node.visit(
                [&into, &to = key](auto& value) { into.insert_or_assign(to, std::move(value)); });
        } else if (there->is_table()) {
            move_nodes(*there->as_table(), *node.as_table(), setting, name);
        } else {
            throw Error(ErrorKind::kUsage, "E-CONFIG-VALUE",
                        place_in_toml(*there, name) + ": `" + setting + "`: expected a table",
                        "correct this key, or remove it");
        }
    }
}

}  // namespace

toml::table parsed_toml(std::string_view text, const std::string& name) {
    try {
        return toml::parse(text, std::string_view(name));
    } catch (const toml::parse_error& error) {
        const toml::source_position begin = error.source().begin;
        refuse_syntax(name + ":" + std::to_string(begin.line) + ":" + std::to_string(begin.column),
                      error);
    }
}

std::string place_in_toml(const toml::node& node, const std::string& name) {
    const toml::source_region& source = node.source();
    if (source.path && *source.path != name) return *source.path;
    return name + ":" + std::to_string(source.begin.line);
}

void change_toml(toml::table& document, const ConfigChange& change, const std::string& name) {
    const std::string where = name + " with " + change.setting + " = " + change.literal;
    try {
        toml::table changed = toml::parse(
            std::string_view(quoted_key(change.setting) + " = " + change.literal), where);
        move_nodes(document, changed, change.setting, name);
    } catch (const toml::parse_error& error) {
        refuse_syntax(where, error);
    }
}

}  // namespace lumi
