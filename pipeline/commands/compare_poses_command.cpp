#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/poses/pose_comparison.h"
#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "pipeline/commands/commands.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

/// Of a folder; the poses of a workspace lie in a folder of their own.
NamedPoses poses_in(const std::filesystem::path& folder) {
    const std::filesystem::path of_workspace = folder / "poses" / "sparse";
    std::error_code status;
    if (std::filesystem::is_regular_file(folder / "config.toml", status) &&
        std::filesystem::is_directory(of_workspace, status)) {
        throw Error(ErrorKind::kBadInput, "E-COMPARE-WORKSPACE",
                    folder.string() + ": is a workspace, expected a folder of poses",
                    "did you mean " + of_workspace.string() + "?");
    }
    return read_named_poses(folder);
}

Json comparison_json(const PoseComparison& comparison) {
    Json views = Json::array();
    for (const PoseDifference& view : comparison.views) {
        views.push_back({{"name", view.name},
                         {"position", view.position},
                         {"rotation_deg", view.rotation_deg}});
    }
    return Json{
        {"scale", comparison.b_from_a.scale},
        {"position",
         {{"median", comparison.median_position},
          {"mean", comparison.mean_position},
          {"max", comparison.max_position}}},
        {"rotation_deg",
         {{"median", comparison.median_rotation_deg}, {"max", comparison.max_rotation_deg}}},
        {"views", std::move(views)}};
}

std::string comparison_text(const PoseComparison& comparison) {
    std::string text;
    for (const PoseDifference& view : comparison.views) {
        text += view.name + "  position " + number_text(view.position, 6) + "  rotation " +
                number_text(view.rotation_deg, 4) + " deg\n";
    }
    return text + counted(comparison.views.size(), "view") + ", in the units of B: position" +
           " median " + number_text(comparison.median_position, 6) + " mean " +
           number_text(comparison.mean_position, 6) + " max " +
           number_text(comparison.max_position, 6) + "; rotation median " +
           number_text(comparison.median_rotation_deg, 4) + " max " +
           number_text(comparison.max_rotation_deg, 4) + " deg\n";
}

}  // namespace

void add_compare_poses_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "compare-poses",
                    "Position and rotation errors of poses A against B, after the "
                    "similarity that fits A onto B; in the units of B",
                    "lumi compare-poses work/fountain/poses/sparse fountain-P11/cameras");
    const auto a = std::make_shared<std::filesystem::path>();
    const auto b = std::make_shared<std::filesystem::path>();
    command.add_option("A", *a, "Folder with a COLMAP model or with .camera files")->required();
    command.add_option("B", *b, "The same; what A is measured against")->required();
    command.callback([a, b, &context] {
        context.chosen = [a, b, &context] {
            const NamedPoses poses = poses_in(*a);
            const PoseComparison comparison = compare_poses(poses, poses_in(*b));
            if (context.json) {
                context.print_result(comparison_json(comparison));
            } else {
                context.print_result(comparison_text(comparison));
            }
        };
    });
}

}  // namespace lumi
