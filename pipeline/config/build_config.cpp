#include "pipeline/config/build_config.h"

#include <algorithm>

#include "calib/lens_files/lens_files.h"
#include "calib/work/printable.h"
#include "pipeline/config/config_variant.h"
#include "pipeline/config/lens_file.h"
#include "pipeline/config/plain_capture.h"
#include "pipeline/text/number_text.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Exactly one of `photos` and `video`.
fs::path read_source(const ConfigSection& capture) {
    const fs::path photos = capture.path("photos");
    const fs::path video = capture.path("video");
    if (photos.empty() && video.empty()) {
        capture.refuse("photos", "a folder of photographs (or `video`: a video file)");
    }
    if (!photos.empty() && !video.empty()) capture.refuse("video", "either `photos` or `video`");
    return photos.empty() ? video : photos;
}

HoldOutOptions read_hold_out_options(const ConfigSection& evaluate) {
    HoldOutOptions options;
    options.every = evaluate.integer("hold_out_every", options.every);
    options.names = evaluate.texts("hold_out", options.names);
    options.place = evaluate.place_of("hold_out");
    if (options.every < 0 || options.every == 1) {
        evaluate.refuse("hold_out_every", "0 (none) or at least 2");
    }
    if (options.every != 0 && !options.names.empty()) {
        evaluate.refuse("hold_out", "either `hold_out` or `hold_out_every`");
    }
    return options;
}

PackageOptions read_package_options(const ConfigSection& package) {
    PackageOptions options;
    const std::string views = package.text("views", "all");
    if (views != "all" && views != "auto") package.refuse("views", R"("all" or "auto")");
    options.fewest_views = views == "auto";
    options.max_views = package.integer("max_views", options.max_views);
    if (options.max_views < 0) package.refuse("max_views", "0 (no limit) or more");
    options.max_mib = package.number("max_mib", options.max_mib);
    if (!(options.max_mib >= 0)) package.refuse("max_mib", "0 (no limit) or more");
    options.keep_transients = package.boolean("keep_transients", options.keep_transients);
    return options;
}

/// Empty for "auto".
std::optional<bool> read_yes_no_or_auto(const ConfigSection& section, const std::string& key) {
    const std::string answer = section.text(key, "auto");
    if (answer == "auto") return std::nullopt;
    if (answer != "yes" && answer != "no")
        section.refuse(key, R"("auto" (as photographs ask for), "yes" or "no")");
    return answer == "yes";
}

/// A number within bounds, or 0 for "as photographs ask for".
double read_number_or_auto(const ConfigSection& section, const std::string& key, double fallback,
                           double least, double most) {
    const double value = section.number(key, fallback);
    if (value != 0 && !(value >= least && value <= most))
        section.refuse(key, "0 (as photographs ask for), or " + shortest_number_text(least) +
                                " to " + shortest_number_text(most));
    return value;
}

int read_depth_views(const ConfigSection& render, int fallback) {
    static_assert(kMaxDepthViews == kLeastDepthViews + 1);
    const int views = render.integer("depth_views", fallback);
    if (views != 0 && (views < kLeastDepthViews || views > kMaxDepthViews))
        render.refuse("depth_views", "0 (as photographs ask for), " +
                                         std::to_string(kLeastDepthViews) + " or " +
                                         std::to_string(kMaxDepthViews));
    return views;
}

DrawingOptions read_drawing_options(const ConfigSection& render) {
    DrawingOptions options;
    options.even_exposure = render.boolean("even_exposure", options.even_exposure);
    options.fade_beyond_capture =
        render.boolean("fade_beyond_capture", options.fade_beyond_capture);
    options.occlusion_tolerance_px =
        read_number_or_auto(render, "occlusion_tolerance_px", options.occlusion_tolerance_px,
                            kLeastOcclusionTolerance_px, kMostOcclusionTolerance_px);
    options.noisy_depth_error_px =
        read_number_or_auto(render, "noisy_depth_error_px", options.noisy_depth_error_px,
                            kLeastNoisyDepthError_px, kMostNoisyDepthError_px);
    options.depth_views = read_depth_views(render, options.depth_views);
    options.depth_block_px = read_number_or_auto(render, "depth_block_px", options.depth_block_px,
                                                 kLeastDepthBlock_px, kMaxDepthBlock_px);
    options.fill_holes = read_yes_no_or_auto(render, "fill_holes");
    options.check_guesses = read_yes_no_or_auto(render, "check_guesses");
    options.triangle_error_px =
        read_number_or_auto(render, "triangle_error_px", options.triangle_error_px,
                            kLeastTriangleError_px, kMostTriangleError_px);
    options.draw_thin = read_yes_no_or_auto(render, "draw_thin");
    return options;
}

/// What is named for something else, and may lie among the photographs. Poses may lie in one folder
/// with them.
std::vector<fs::path> folders_of_other_things(const BuildConfig& config) {
    std::vector<fs::path> folders;
    for (const fs::path& path : {config.boards, config.poses.mask_folder,
                                 config.depth.import_folder, config.depth.mask_folder}) {
        if (!path.empty()) folders.push_back(path);
    }
    return folders;
}

/// Whether something beside the photographs was made for their raster: poses, a lens, masks, depth.
bool is_bound_to_raster(const BuildConfig& config) {
    return !config.imported_poses.empty() || config.given_lens || !config.boards.empty() ||
           !config.poses.mask_folder.empty() || !config.depth.mask_folder.empty() ||
           !config.depth.import_folder.empty();
}

/// A section as it decides a stage's result: what lies at a path counts by its content, which is
/// among the stage's inputs, and the path only by being named.
std::string parameters_of(const ConfigSection& section, const std::vector<std::string>& paths) {
    std::string parameters = section.resolved_table(paths);
    for (const std::string& path : paths) {
        if (!section.path(path).empty()) parameters += path + " is named\n";
    }
    return parameters;
}

/// Of poses from elsewhere, which are only checked.
std::string parameters_of_import(const ConfigSection& document) {
    return document.section("poses").path("masks").empty() ? "import" : "import\nmasks is named\n";
}

/// What is known when every section has been read.
void fill_in_stage_parameters(BuildConfig& config, const ConfigSection& document) {
    const auto parameters = [&](const char* section) {
        return document.section(section).resolved_table();
    };
    const ConfigSection capture = document.section("capture");
    config.stage_parameters = {
        // Where the boards lie is not what they show, either.
        {"calibrate", document.section("calibration").resolved_table({"boards", "camera"})},
        {"ingest", capture.resolved_table({"photos", "video", "import"}) +
                       (config.ingest.crop_bars ? "" : "crop_bars = false\n")},
        {"poses", config.imported_poses.empty()
                      ? parameters_of(document.section("poses"), {"masks"}) +
                            lens_parameters_text(config.given_lens)
                      : parameters_of_import(document)},
        {"mesh", parameters("mesh")},
        {"depth", parameters_of(document.section("depth"),
                                {"import_folder", "import_mesh", "import_volume", "masks"})},
        // All else comes to packing as what other stages made; the configuration that a package
        // records may spell a path, or count threads, as when it was made.
        {"pack", "name = " + config.name + "\n[mesh]\n" + parameters("mesh") + "[package]\n" +
                     parameters("package") + "[render]\n" + parameters("render")},
    };
}

}  // namespace

bool is_plain_name(const std::string& name) {
    const auto is_plain = [](char c) {
        return c != '/' && c != '\\' && static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
    };
    return !name.empty() && name.size() <= kMaxBuildName && name.front() != '.' && is_utf8(name) &&
           std::all_of(name.begin(), name.end(), is_plain);
}

BuildConfig read_build_config(const ConfigSection& document, const std::string& default_name) {
    BuildConfig config;
    config.name = document.text("name", default_name);
    if (!is_plain_name(config.name)) document.refuse("name", "a name that can name a folder");
    config.workspace = document.path("workspace");
    config.threads = document.integer("threads", config.threads);
    if (config.threads < 0) document.refuse("threads", "0 (all cores) or more");

    const ConfigSection capture = document.section("capture");
    for (const char* source : {"photos", "video"}) static_cast<void>(capture.path(source));
    config.imported_poses = capture.path("import");
    config.ingest = read_ingest_options(capture);
    const ConfigSection calibration = document.section("calibration");
    const fs::path lens_path = calibration.path("camera");
    config.boards = calibration.path("boards");
    if (!lens_path.empty() && !config.boards.empty()) {
        calibration.refuse("boards", "either `boards` or `camera`");
    }
    for (const char* lens : {"camera", "boards"}) {
        if (config.imported_poses.empty() || calibration.path(lens).empty()) continue;
        calibration.refuse(lens, "no lens beside `capture.import`, which brings its own");
    }
    if (!lens_path.empty()) config.given_lens = read_lens_file(lens_path);
    config.poses = read_pose_options(document.section("poses"));
    config.mesh = read_camera_mesh_options(document.section("mesh"));
    config.depth = read_depth_options(document.section("depth"));
    config.package = read_package_options(document.section("package"));
    config.drawing = read_drawing_options(document.section("render"));
    config.hold_out = read_hold_out_options(document.section("evaluate"));
    config.ingest.crop_bars = !is_bound_to_raster(config);
    config.ingest.other_folders = folders_of_other_things(config);
    // What to do with a capture beside building it; see `lumi chart` and `lumi stress`.
    for (const char* other : {"sweep", "growth", "stress"}) document.leave_to_others(other);
    document.expect_all_keys_known();  // Before what is misspelt is found to be missing.
    config.photographs_or_video = read_source(capture);

    config.resolved_toml = document.resolved();
    config.movable_toml = document.resolved_for_any_folder();
    fill_in_stage_parameters(config, document);
    return config;
}

BuildConfig load_build_config(const fs::path& path) {
    return ConfigDocument::open(path).build_config_with({});
}

}  // namespace lumi
