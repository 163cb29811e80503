#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/work/whole_file.h"
#include "pipeline/commands/commands.h"
#include "pipeline/gallery/gallery.h"

namespace lumi {

void add_gallery_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "gallery", "Pictures, charts and figures of a workspace for a README",
                    "lumi gallery work/demo --out README.images");
    const auto workspace = std::make_shared<std::filesystem::path>();
    const auto out = std::make_shared<std::filesystem::path>();
    command.add_option("WORKSPACE", *workspace, "Folder that lumi evaluate has seen")->required();
    command.add_option("--out", *out, "Where pictures, charts and gallery.md go")->required();
    command.callback([workspace, out, &context] {
        context.chosen = [workspace, out, &context] {
            require_writable_folder(*out);
            write_gallery(find_workspace(*workspace), *out, *context.progress);
            const std::string page = (*out / "gallery.md").string();
            if (context.json) {
                context.print_result(nlohmann::ordered_json{{"page", page}});
            } else {
                context.print_result(page + "\n");
            }
        };
    });
}

}  // namespace lumi
