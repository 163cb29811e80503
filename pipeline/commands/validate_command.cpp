#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "pipeline/commands/commands.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

/// A damaged package is a result of this command as well as its exit code.
void run_validate(const std::filesystem::path& package, const CommandContext& context) {
    try {
        const Lumigraph lumigraph = read_package(package);
        if (context.json) {
            context.print_result(Json{{"valid", true}, {"views", lumigraph.views.size()}});
        } else {
            context.print_result("valid: " + counted(lumigraph.views.size(), "view") + "\n");
        }
    } catch (const Error&) {
        if (context.json) context.print_result(Json{{"valid", false}});
        throw;
    }
}

}  // namespace

void add_validate_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "validate", "Checks every file, number and checksum of a package",
                    "lumi validate work/fountain/fountain.lumi");
    const auto package = std::make_shared<std::filesystem::path>();
    command.add_option("PACKAGE", *package, "Folder NAME.lumi")->required();
    command.callback([package, &context] {
        context.chosen = [package, &context] { run_validate(*package, context); };
    });
}

}  // namespace lumi
