#include "pipeline/commands/run_dataset_build.h"

#include <nlohmann/json.hpp>

#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "pipeline/dataset/dataset_files.h"
#include "pipeline/dataset/run_dataset.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

std::string table_of(const std::vector<SceneOutcome>& outcomes) {
    std::string table = padded_right("scene", 24) + padded_left("CPU s", 9) +
                        padded_left("MiB", 9) + padded_left("dB", 8) + padded_left("FLIP", 9) +
                        "\n";
    for (const SceneOutcome& outcome : outcomes) {
        table += padded_right(outcome.name, 24);
        if (outcome.failure) {
            table += "  " + printable(failure_text(*outcome.failure)) + "\n";
            continue;
        }
        table += padded_left(number_text(outcome.cpu_s, 1), 9) +
                 padded_left(number_text(outcome.package_mib, 1), 9);
        if (outcome.mean) {
            table += padded_left(number_text(outcome.mean->psnr_db, 2), 8) +
                     padded_left(number_text(outcome.mean->flip, 4), 9);
        }
        table += "\n";
    }
    return table;
}

/// Names what is missing, if anything is: scenes, or many of a scene's photographs.
void refuse_partial(const std::vector<SceneOutcome>& outcomes) {
    std::string missing;
    int concerned = 0;
    for (const SceneOutcome& outcome : outcomes) {
        const PlacedPhotographs& photographs = outcome.photographs;
        if (!outcome.failure && !photographs.is_partial()) continue;
        missing += (missing.empty() ? "" : ", ") + outcome.name + " (" +
                   (outcome.failure ? outcome.failure->code()
                                    : std::to_string(photographs.placed) + " of " +
                                          counted(photographs.total, "photograph")) +
                   ")";
        ++concerned;
    }
    if (concerned == 0) return;
    throw Error(ErrorKind::kPartialResult, "E-DATASET-PARTIAL",
                std::to_string(concerned) + " of " + counted(outcomes.size(), "scene") +
                    " could not be built, or only in part: " + missing,
                "mend them and run the same command again: the others are kept");
}

}  // namespace

void run_dataset_build(const BuildRequest& request, const CommandContext& context) {
    const Dataset dataset = read_dataset(request.config);
    const fs::path folder =
        request.workspace.empty() ? fs::path("work") / dataset.name : request.workspace;
    const std::vector<SceneOutcome> outcomes =
        run_dataset(dataset, folder, context.threads, *context.progress);
    write_dataset_files(folder, dataset.name, outcomes, *context.progress);
    if (context.json) {
        context.print_result(dataset_json(dataset.name, outcomes));
    } else {
        context.print_result(table_of(outcomes));
    }
    context.say((folder / "dataset.html").string() + "\n");

    refuse_partial(outcomes);
}

}  // namespace lumi
