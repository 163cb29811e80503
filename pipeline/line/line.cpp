#include "pipeline/line/line.h"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

#include "calib/ingest/cut_outs.h"
#include "calib/work/content_hash.h"
#include "calib/work/error_of_exception.h"
#include "meshing/geometry/binary_volume.h"
#include "pipeline/evaluate/asked_efforts.h"
#include "pipeline/evaluate/view_curve.h"
#include "pipeline/line/code_version.h"
#include "pipeline/line/colmap_version.h"
#include "pipeline/line/finished_stages.h"
#include "pipeline/line/named_paths.h"
#include "pipeline/line/stages_file.h"
#include "pipeline/line/told_configuration.h"
#include "pipeline/stages/calibrate_stage.h"
#include "pipeline/stages/depth_stage.h"
#include "pipeline/stages/ingest_stage.h"
#include "pipeline/stages/mesh_stage.h"
#include "pipeline/stages/pack_stage.h"
#include "pipeline/stages/photograph_list.h"
#include "pipeline/stages/posed_files.h"
#include "pipeline/stages/poses_stage.h"
#include "pipeline/stages/used_views.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void append(std::vector<ContentEntry>& entries, const std::vector<ContentEntry>& more) {
    entries.insert(entries.end(), more.begin(), more.end());
}

/// One run of the line: each function below describes a stage by what the stages before it left in
/// the workspace, and by what decides its result.
class Line {
 public:
    Line(const BuildConfig& config, const Workspace& workspace, int threads, Progress& progress,
         StageStore* store)
        : config_(config),
          workspace_(workspace),
          threads_(threads),
          progress_(progress),
          store_(store),
          configuration_sha256_(configuration_sha256(config)) {}

    [[nodiscard]] const std::vector<FinishedStage>& finished() const { return finished_; }

    /// So far: what an earlier run wrote down does not outlast the beginning of this one.
    void write_down() const {
        write_stages_file(workspace_.stages_path(), finished_, configuration_sha256_);
    }
    void write_down(const std::string& failed_stage, const Error& failure) const {
        write_stages_file(workspace_.stages_path(), finished_, configuration_sha256_, failed_stage,
                          failure);
    }

    void bring_up_to_date(const std::string& name) {
        finished_.push_back(
            lumi::bring_up_to_date(workspace_, stage_named(name), threads_, progress_, store_));
        write_down();
        if (name == "ingest") read_ingested();
    }

 private:
    [[nodiscard]] Stage stage_named(const std::string& name) {
        if (name == "ingest") return ingest_stage();
        if (name == "calibrate") return calibrate_stage();
        if (name == "poses") return poses_stage();
        if (name == "mesh") return mesh_stage();
        if (name == "depth") return depth_stage();
        assert(name == "pack");
        return pack_stage();
    }

    [[nodiscard]] StageIdentity identity(const std::string& stage,
                                         const std::vector<ContentEntry>& inputs) const {
        return {stage, code_version_of(stage), config_.stage_parameters.at(stage), "",
                sha256_of_content(inputs)};
    }

    [[nodiscard]] Stage ingest_stage() const {
        const std::vector<ContentEntry> inputs =
            content_of_photographs(config_.photographs_or_video, workspace_.stage_folder("ingest"),
                                   config_.ingest.other_folders, threads_);
        return {identity("ingest", inputs),
                [this](const fs::path& folder) {
                    return run_ingest_stage(config_.photographs_or_video, config_.ingest, folder,
                                            threads_, progress_);
                },
                {}};
    }

    [[nodiscard]] Stage calibrate_stage() const {
        return {identity("calibrate", content_of_photographs(config_.boards, {}, {}, threads_)),
                [this](const fs::path& folder) {
                    return run_calibrate_stage(config_.boards, folder, threads_, progress_);
                },
                {}};
    }

    /// Of what is named beside the photographs; the workspace may lie in the same folder.
    [[nodiscard]] std::vector<ContentEntry> content_beside(const fs::path& named) const {
        return content_of(named, threads_, workspace_.folder());
    }

    /// From a file, from photographs of a board, or none.
    [[nodiscard]] std::optional<Camera> known_lens() const {
        if (config_.boards.empty()) return config_.given_lens;
        return read_calibrated_lens(workspace_.stage_folder("calibrate"));
    }

    [[nodiscard]] Stage poses_stage() const {
        std::vector<ContentEntry> inputs = outputs_of("ingest", "ingest/");
        append(inputs, content_beside(config_.imported_poses));
        append(inputs, content_beside(config_.poses.mask_folder));
        if (!config_.boards.empty()) {
            append(inputs, outputs_of("calibrate", "calibrate/camera.toml"));
        }
        Stage stage{identity("poses", inputs),
                    [this](const fs::path& folder) {
                        return run_poses_stage(
                            workspace_.stage_folder("ingest"),
                            {config_.imported_poses, known_lens(), config_.poses}, folder, threads_,
                            progress_);
                    },
                    {}};
        const bool runs_colmap =
            config_.imported_poses.empty() && (config_.poses.front_end == PoseProgram::kColmap ||
                                               config_.poses.mapper == PoseProgram::kColmap);
        if (runs_colmap) stage.identity.external_tool = colmap_version(config_.poses.colmap);
        return stage;
    }

    [[nodiscard]] Stage mesh_stage() {
        read_used_views();
        std::vector<ContentEntry> inputs = outputs_of("poses", "poses/pinhole/");
        inputs.push_back(held_out_entry());
        return {identity("mesh", inputs),
                [this](const fs::path& folder) {
                    return run_mesh_stage(used_.capture, config_.mesh, folder);
                },
                {}};
    }

    [[nodiscard]] Stage depth_stage() const {
        std::vector<ContentEntry> inputs = pictures_and_poses();
        append(inputs, content_beside(config_.depth.import_folder));
        append(inputs, content_of(config_.depth.import_mesh, threads_));
        for (const fs::path& file : files_of_volume(config_.depth.import_volume)) {
            append(inputs, content_of(file, threads_));
        }
        append(inputs, content_beside(config_.depth.mask_folder));
        // By their lenses what belongs to photographs is brought onto straight pictures.
        if (!depth_mask_folder().empty() || !config_.depth.import_folder.empty())
            append(inputs, outputs_of("poses", "poses/sparse/"));
        inputs.push_back(held_out_entry());
        return {identity("depth", inputs),
                [this](const fs::path& folder) {
                    return run_depth_stage(used_, masked_photographs(), config_.depth, folder,
                                           threads_, progress_);
                },
                {}};
    }

    [[nodiscard]] Stage pack_stage() const {
        std::vector<ContentEntry> inputs = pictures_and_poses();
        for (const char* stage : {"mesh", "depth"}) {
            append(inputs, outputs_of(stage, ""));
        }
        inputs.push_back(held_out_entry());
        inputs.push_back({"facts of all stages", sha256_hex(facts_of(finished_))});
        return {identity("pack", inputs),
                [this](const fs::path& folder) {
                    return run_pack_stage(pack_sources(), workspace_.package_folder(), folder,
                                          threads_, progress_);
                },
                workspace_.package_folder(), is_name_in_package};
    }

    [[nodiscard]] PackSources pack_sources() const {
        return {.name = config_.name,
                .photographs = used_,
                .ingested = ingested_,
                .held_out = held_out_,
                .mesh_folder = workspace_.stage_folder("mesh"),
                .depth_folder = workspace_.stage_folder("depth"),
                .pictures_sha256 = sha256_of_content(pictures_and_poses()),
                .mesh_sha256 = sha256_of_content(outputs_of("mesh", "")),
                .depth_sha256 = sha256_of_content(outputs_of("depth", "")),
                .configuration_sha256 = configuration_sha256_,
                .resolved_config_toml = config_.resolved_toml,
                .evidence_json = facts_of(finished_),
                .options = config_.package,
                .drawing = config_.drawing,
                .mesh_options = config_.mesh,
                .max_memory_mib = config_.depth.max_memory_mib,
                .sufficient_views =
                    [this](const Lumigraph& lumigraph, const Capture& capture) {
                        return sufficient_views(lumigraph, capture, config_.mesh, threads_,
                                                progress_);
                    },
                .depth_mesh_effort =
                    [this](const Lumigraph& lumigraph, const Capture& capture) {
                        return asked_depth_mesh_effort(lumigraph, capture, config_.mesh,
                                                       config_.drawing, progress_);
                    },
                .drawing_efforts =
                    [this](const Lumigraph& lumigraph, const Capture& capture) {
                        return asked_drawing_efforts(lumigraph, capture, config_.mesh,
                                                     config_.drawing, progress_);
                    }};
    }

    void read_ingested() {
        ingested_ = read_photograph_list(workspace_.stage_folder("ingest")).photographs;
        held_out_ = held_out_names(names_of(ingested_), config_.hold_out);
    }
    void read_used_views() {
        used_ = without_views(read_posed_photographs(workspace_.stage_folder("poses") / "pinhole"),
                              held_out_);
    }

    /// As drawn; else what alpha channels leave of the photographs, if a background may be found.
    [[nodiscard]] fs::path depth_mask_folder() const {
        if (!config_.depth.mask_folder.empty() || config_.depth.background != "auto")
            return config_.depth.mask_folder;
        return cut_out_folder(workspace_.stage_folder("ingest"));
    }

    [[nodiscard]] MaskedPhotographs masked_photographs() const {
        MaskedPhotographs masked{
            depth_mask_folder(), workspace_.stage_folder("poses"), {}, held_out_};
        for (const Photograph& photograph : ingested_) masked.all_names.push_back(photograph.name);
        return masked;
    }

    /// Photographs may come and go, and with them those that every so many are held out.
    [[nodiscard]] ContentEntry held_out_entry() const {
        return {"held out", sha256_hex(Json(held_out_).dump())};
    }

    /// What a finished stage wrote, where the name begins with `prefix`.
    [[nodiscard]] std::vector<ContentEntry> outputs_of(const std::string& stage,
                                                       const std::string& prefix) const {
        return lumi::outputs_of(finished_, stage, prefix);
    }

    /// Pictures that needed no undistortion are the working copies themselves.
    [[nodiscard]] std::vector<ContentEntry> pictures_and_poses() const {
        std::vector<ContentEntry> inputs = outputs_of("ingest", "ingest/");
        append(inputs, outputs_of("poses", "poses/pinhole/"));
        return inputs;
    }

    const BuildConfig& config_;
    const Workspace& workspace_;
    int threads_;
    Progress& progress_;
    StageStore* store_;
    std::string configuration_sha256_;
    std::vector<FinishedStage> finished_;
    std::vector<Photograph> ingested_;
    std::vector<std::string> held_out_;
    PosedPhotographs used_;
};

/// What ended a stage, with what the line knows of the way on.
std::optional<Error> failure_of_stage(const std::exception& exception) {
    std::optional<Error> failure = error_of_exception(exception);
    if (!failure || failure->kind() != ErrorKind::kInterrupted) return failure;
    return Error(failure->kind(), failure->code(), failure->what(),
                 "run the same command again: finished stages are kept");
}

/// Boards are one more stage, where there are any.
std::vector<std::string> stages_for(const BuildConfig& config) {
    if (config.boards.empty()) return stages_of_line();
    return {kAllStages.begin(), kAllStages.end()};
}

/// Does work of a stage; what ends it is written down.
template <class Work>
void in_stage(const std::string& stage, const Line& line, const Work& work) {
    try {
        work();
    } catch (const std::exception& exception) {
        const std::optional<Error> failure = failure_of_stage(exception);
        if (!failure) throw;
        line.write_down(stage, *failure);
        throw *failure;
    }
}

}  // namespace

const std::vector<std::string>& stages_of_line() {
    static const std::vector<std::string> stages = [] {
        std::vector<std::string> names(kAllStages.begin(), kAllStages.end());
        std::erase(names, "calibrate");
        return names;
    }();
    return stages;
}

std::vector<FinishedStage> run_line(const BuildConfig& config, const Workspace& workspace,
                                    const std::string& last_stage, int threads, Progress& progress,
                                    StageStore* store) {
    const std::vector<std::string> stages = stages_for(config);
    write_configuration(workspace, config);
    Line line(config, workspace, threads, progress, store);
    line.write_down();
    in_stage(stages.front(), line, [&] { expect_named_paths(config, last_stage); });
    for (const std::string& stage : stages) {
        in_stage(stage, line, [&] { line.bring_up_to_date(stage); });
        if (stage == last_stage) break;
    }
    return line.finished();
}

WorkspaceLayout workspace_of(const BuildConfig& config) {
    const fs::path folder =
        config.workspace.empty() ? fs::path("work") / config.name : config.workspace;
    return {folder, config.name};
}

}  // namespace lumi
