#include "pipeline/config/explained_configuration.h"

#include <string_view>

#include "calib/work/toml_text.h"
#include "calib/work/toml_tree.h"

namespace lumi {
namespace {

/// "key = value", or several lines.
std::string assignment(std::string_view key, const toml::node& node) {
    toml::table alone;
    node.visit([&](const auto& value) { alone.insert_or_assign(key, value); });
    std::string text = readable_text_of(alone);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

std::string explained_values(const toml::table& table, const std::string& prefix) {
    std::string text;
    for (const auto& [key, node] : table) {
        if (node.is_table()) continue;
        const std::string value = assignment(key.str(), node);
        const auto meaning = key_meanings().find(prefix + std::string(key.str()));
        if (meaning == key_meanings().end()) {
            text += value + '\n';
        } else if (value.find('\n') != std::string::npos) {
            text += "# " + meaning->second + '\n' + value + '\n';
        } else {
            text += value + "  # " + meaning->second + '\n';
        }
    }
    return text;
}

}  // namespace

const std::map<std::string, std::string>& key_meanings() {
    static const std::map<std::string, std::string> all{
        {"name", "of the package, NAME.lumi, and of the workspace, work/NAME"},
        {"threads", "0 (all cores) or more"},
        {"workspace", "folder to work in; '': work/NAME below the current folder"},

        {"calibration.boards",
         "folder or video of a calibration board, by which the lens is found; '': none"},
        {"calibration.camera",
         "file of a known lens (.toml; .txt of COLMAP; .yaml of OpenCV, Kalibr, ROS); '': none"},

        {"capture.import",
         "known poses: a COLMAP model, a folder of .camera files, transforms.json, "
         "poses_bounds.npy or *_par.txt; '': estimated"},
        {"capture.keep_overlays",
         "true leaves bars, watermarks and the like in the photographs, false takes them out"},
        {"capture.max_width_px",
         "longer photographs are scaled down to it, whichever side is the longer: 0 (as they are) "
         "or more"},
        {"capture.min_photographs", "with fewer a build ends: 1 or more"},
        {"capture.min_width_px",
         "photographs with a shorter side below it are left out: more than 0"},
        {"capture.photos", "folder of photographs: either `photos` or `video`"},
        {"capture.video", "file of a video: either `photos` or `video`"},
        {"capture.video_fps", "frames taken from each second of a video: more than 0"},

        {"depth.background",
         "whether a plain background is kept out of the scene where there is "
         "one: \"auto\" or \"keep\" (never)"},
        {"depth.import_folder", "depth maps made elsewhere, one a photograph, instead of model"},
        {"depth.import_mesh", "a surface made elsewhere (.ply, .obj), instead of model"},
        {"depth.import_png_unit",
         "what one level of a 16-bit PNG in import_folder stands for: a positive length"},
        {"depth.import_volume", "a volume of solid cells (.nrrd, .mhd), instead of model"},
        {"depth.import_volume_threshold", "cells of import_volume from this value on are solid"},
        {"depth.masks", "folder of masks, one a photograph: black is no part of the scene"},
        {"depth.max_memory_mib",
         "fewer depth maps are made at once where more would be taken: at least 256"},
        {"depth.max_neighbours", "photographs that one is compared with: 1 to 32"},
        {"depth.max_width_px", "of depth maps; finer ones take longer: 16 to 16384"},
        {"depth.model",
         "how depth is found: one of \"auto\", \"plane\", \"slanted_plane\", \"sparse\", "
         "\"sparse_fill\", \"pair_stereo\", \"sweep\", \"refined_sweep\", \"patch_match\"; auto "
         "climbs while photographs gain"},

        {"evaluate.hold_out",
         "names of photographs that are kept back to measure with; or else "
         "hold_out_every"},
        {"evaluate.hold_out_every",
         "every so many photographs one is kept back to measure with: 0 (none) or at least 2"},

        {"mesh.construction",
         "how cameras are joined: \"auto\", \"closed\", \"open\", \"line\" or \"nearest\""},
        {"mesh.repair", "whether the mesh is changed where the scene would reach out of it"},
        {"mesh.shape", "\"star\" or \"convex\": with every camera, or the paper's hull"},
        {"mesh.shells", "whether close-ups get meshes of their own within the first"},

        {"package.keep_transients",
         "true leaves what was there for one photograph alone, false paints it over"},
        {"package.max_mib",
         "views are left out until the package is as small: 0 (no limit) or more"},
        {"package.max_views", "the views of most worth are kept: 0 (no limit) or more"},
        {"package.views",
         "\"all\" or \"auto\": as few as held-out photographs cannot tell from all"},

        {"poses.colmap", "name or path of the program, where front_end or mapper is \"colmap\""},
        {"poses.front_end", "who finds features and matches: \"lumi\" or \"colmap\""},
        {"poses.lens_model",
         "what is estimated of a lens: auto, SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, "
         "OPENCV, OPENCV_FISHEYE or FULL_OPENCV; auto: as much as photographs tell"},
        {"poses.mapper", "who places the photographs: \"lumi\" or \"colmap\""},
        {"poses.masks",
         "folder of masks, one a photograph: black does not hold still while the camera moves"},
        {"poses.max_features", "of a photograph: more than 0"},
        {"poses.max_reprojection_error_px", "what lies further off is dropped: more than 0"},
        {"poses.min_registered_share",
         "with a smaller share of the photographs placed a build ends: "
         "more than 0 and at most 1"},
        {"poses.min_track_length", "points that fewer photographs see are dropped: at least 2"},
        {"poses.refine_lens", "whether a known lens is corrected where photographs ask for it"},
        {"poses.shared_lens", "whether photographs of one camera and zoom share a lens"},
        {"poses.time_limit_s", "for each run of COLMAP: more than 0"},

        {"render.check_guesses",
         "whether a guess is checked against what stands before it: "
         "\"auto\" (as photographs ask for), \"yes\" or \"no\""},
        {"render.depth_block_px",
         "depth is worked out for blocks of so many pixels of the "
         "photographs: 0 (as photographs ask for), or 1 to 2"},
        {"render.depth_views",
         "views whose depth is compared at a pixel: 0 (as photographs ask for), 3 or 4"},
        {"render.draw_thin",
         "whether adaptive draws bars over its triangles: \"auto\" (as "
         "photographs ask for), \"yes\" or \"no\""},
        {"render.even_exposure",
         "whether exposure, white balance and dark corners are evened out between neighbours"},
        {"render.fade_beyond_capture",
         "whether pictures fade from where no photograph was taken, unless asked otherwise"},
        {"render.fill_holes",
         "whether what no depth view sees is drawn from the views next to them: "
         "\"auto\" (as photographs ask for), \"yes\" or \"no\""},
        {"render.noisy_depth_error_px",
         "how closely meshes follow depth that looks like noise: 0 "
         "(as photographs ask for), or 0.1 to 10"},
        {"render.occlusion_tolerance_px",
         "beyond so much disparity a view sees something else and is not blended: 0 (as "
         "photographs "
         "ask for), or 0.1 to 100"},
        {"render.triangle_error_px",
         "how far triangles of adaptive may err: 0 (as photographs ask for), or 0.1 to 10"},
    };
    return all;
}

std::string explained_configuration(const std::string& resolved_toml) {
    const toml::table document = parsed_toml(resolved_toml, "configuration");
    std::string text = explained_values(document, "");
    for (const auto& [key, node] : document) {
        const toml::table* section = node.as_table();
        if (section == nullptr) continue;
        const std::string name(key.str());
        text += "\n[" + name + "]\n" + explained_values(*section, name + '.');
    }
    return text;
}

}  // namespace lumi
