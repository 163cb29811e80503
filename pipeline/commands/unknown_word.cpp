#include "pipeline/commands/unknown_word.h"

#include <set>
#include <string>

#include "calib/work/nearest_word.h"

namespace lumi {
namespace {

std::set<std::string> command_names(const CLI::App& app) {
    std::set<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.insert(command->get_name());
    return names;
}

/// Long names without their dashes, also of groups of options.
std::set<std::string> option_names(const CLI::App& command) {
    std::set<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        names.insert(option->get_lnames().begin(), option->get_lnames().end());
    }
    for (const CLI::App* group : command.get_subcommands({})) {
        if (group->get_name().empty()) names.merge(option_names(*group));
    }
    return names;
}

Error error_of(const std::string& kind, const std::string& word, const std::string& dashes,
               const std::set<std::string>& known, const std::string& help) {
    const auto meant = nearest_word(word, known);
    return {ErrorKind::kUsage, "E-USAGE", "unknown " + kind + " `" + dashes + word + "`",
            (meant ? "did you mean `" + dashes + *meant + "`? " : "") + "see `" + help + "`"};
}

}  // namespace

std::optional<Error> error_of_unknown_word(const CLI::App& app) {
    constexpr const char* kDashes = "--";
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    for (const std::string& word : app.remaining(true)) {
        const bool is_option = word.starts_with(kDashes);
        if (!is_option && chosen.empty()) {
            return error_of("command", word, "", command_names(app), "lumi --help");
        }
        if (!is_option) continue;
        std::set<std::string> known = option_names(app);
        std::string help = "lumi ";
        for (const CLI::App* command : chosen) {
            known.merge(option_names(*command));
            help += command->get_name() + " ";
        }
        return error_of("option", word.substr(2, word.find('=') - 2), kDashes, known,
                        help + "--help");
    }
    return std::nullopt;
}

}  // namespace lumi
