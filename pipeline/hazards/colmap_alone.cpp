#include "pipeline/hazards/colmap_alone.h"

#include <system_error>
#include <vector>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/image_io.h"
#include "calib/work/child_process.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// "f,cx,cy,k" of COLMAP's default lens model, for the size of the first photograph.
std::string camera_parameters(const fs::path& photographs, double focal_length_px) {
    const ImageSize size = read_image_size(fs::directory_iterator(photographs)->path());
    return std::to_string(focal_length_px) + "," + std::to_string(0.5 * size.width_px) + "," +
           std::to_string(0.5 * size.height_px) + ",0";
}

std::vector<std::vector<std::string>> steps_of(const fs::path& photographs,
                                               std::optional<double> focal_length_px,
                                               const fs::path& scratch) {
    const std::string database = (scratch / "database.db").string();
    std::vector<std::string> extract{
        "colmap",       "feature_extractor",  "--database_path",          database,
        "--image_path", photographs.string(), "--SiftExtraction.use_gpu", "0"};
    if (focal_length_px) {
        extract.insert(extract.end(), {"--ImageReader.camera_params",
                                       camera_parameters(photographs, *focal_length_px)});
    }
    return {extract,
            {"colmap", "exhaustive_matcher", "--database_path", database, "--SiftMatching.use_gpu",
             "0"},
            {"colmap", "mapper", "--database_path", database, "--image_path", photographs.string(),
             "--output_path", (scratch / "models").string()}};
}

std::optional<Capture> largest_model(const fs::path& models) {
    std::optional<Capture> best;
    for (int number = 0; fs::is_directory(models / std::to_string(number)); ++number) {
        Capture model = read_colmap_model(models / std::to_string(number));
        const bool is_better =
            !best || model.views.size() > best->views.size() ||
            (model.views.size() == best->views.size() && model.points.size() > best->points.size());
        if (is_better) best = std::move(model);
    }
    return best;
}

}  // namespace

ColmapAlone reconstruct_with_colmap_alone(const fs::path& photographs,
                                          std::optional<double> focal_length_px,
                                          const fs::path& scratch_folder, double time_limit_s,
                                          Progress& progress) {
    std::error_code status;
    fs::remove_all(scratch_folder, status);
    fs::create_directories(scratch_folder / "models");
    ColmapAlone result;
    for (std::vector<std::string>& step : steps_of(photographs, focal_length_px, scratch_folder)) {
        ChildCommand command;
        command.log_path = scratch_folder / (step[1] + ".log");
        command.arguments = std::move(step);
        command.arguments.insert(command.arguments.end(), {"--log_to_stderr", "1"});
        command.time_limit_s = time_limit_s;
        command.missing_advice = "install COLMAP 3.8 (Debian: apt-get install colmap)";
        const ChildResult run = run_child(command, progress);
        result.cpu_s += run.cpu_s;
        result.ending = command.arguments[1] + ": " + description_of(run, command);
        result.ended_by_itself = run.end == ChildEnd::kExited;
        if (!result.ended_by_itself) break;
    }
    try {
        result.model = largest_model(scratch_folder / "models");
    } catch (const Error&) {
        result.ended_by_itself = false;  // What a killed mapper left behind is not whole.
    }
    return result;
}

}  // namespace lumi
