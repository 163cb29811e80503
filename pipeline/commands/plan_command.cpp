#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/work/counted.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/number_checks.h"
#include "pipeline/plan/plan_workspace.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

std::string wish_text(const CapturePlan& plan, double wished_error_px) {
    if (!(wished_error_px > 0)) return {};
    const std::string wish = number_text(wished_error_px, 2) + " px everywhere";
    if (plan.photographs_for_wish < 0) {
        return wish + " cannot be had with " + std::to_string(kMostPlanned) + " more photographs\n";
    }
    if (plan.photographs_for_wish == 0)
        return wish + " is reached already; the places above would help most\n";
    return wish + " takes " + counted(plan.photographs_for_wish, "more photograph") + "\n";
}

void run_plan(const std::filesystem::path& folder, const CapturePlanOptions& options,
              const CommandContext& context) {
    const Workspace workspace(find_workspace(folder));
    const WorkspacePlan planned = plan_workspace(workspace, options);
    if (context.json) {
        context.print_result(plan_json(planned));
    } else {
        context.print_result(plan_text(planned) + wish_text(planned.plan, options.wished_error_px));
    }
    context.say((workspace.folder() / "plan" / "plan.svg").string() + "\n");
}

}  // namespace

void add_plan_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "plan", "Where to photograph next, and how many photographs a wish takes",
                    "lumi plan work/fountain --wish 0.5");
    const auto folder = std::make_shared<std::filesystem::path>();
    const auto options = std::make_shared<CapturePlanOptions>();
    command.add_option("WORKSPACE", *folder, "Folder that lumi build or lumi poses wrote")
        ->required();
    command.add_option("--suggestions", options->suggestions, "How many")
        ->check(CLI::Range(0, 100))
        ->capture_default_str();
    command
        .add_option("--wish", options->wished_error_px,
                    "Error in pixels, predicted from the poses alone, that is to be reached "
                    "everywhere between the cameras")
        ->check(positive_number());
    command.callback([folder, options, &context] {
        context.chosen = [folder, options, &context] { run_plan(*folder, *options, context); };
    });
}

}  // namespace lumi
