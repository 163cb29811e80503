#include "pipeline/bench/rival_scenes.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "calib/work/median.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/surface/depth_map.h"
#include "pipeline/bench/shown_pixels.h"
#include "pipeline/evaluate/asked_efforts.h"
#include "pipeline/evaluate/moved_eye.h"
#include "pipeline/synth/photographer.h"
#include "pipeline/synth/scene_description.h"
#include "pipeline/synth/synthesize.h"
#include "render/depth_mesh/view_depth_mesh.h"
#include "render/paths/pose_between.h"

namespace lumi {
namespace {

struct SceneSettings {
    const char* name;
    const char* paper;
    std::array<std::size_t, 2> paper_triangles;  ///< 0: the paper does not say.
    PathKind kind;
    int photographs;
    int rows;
    double span_deg;
    double elevation_deg;
    double top_elevation_deg;
    bool object_alone;  ///< Without the room, which would stand in the way of cameras.
};

constexpr SceneSettings kScenes[] = {
    {.name = "coke",
     .paper = "33 real photographs: 30 frames a second",
     .paper_triangles = {0, 0},
     .kind = PathKind::kArc,
     .photographs = 33,
     .rows = 3,
     .span_deg = 60,
     .elevation_deg = 10,
     .top_elevation_deg = 35,
     .object_alone = false},
    {.name = "petruschka",
     .paper = "169 synthetic: 14 frames a second at 780 triangles, 1.7 at 5000",
     .paper_triangles = {780, 5000},
     .kind = PathKind::kArc,
     .photographs = 169,
     .rows = 13,
     .span_deg = 66,
     .elevation_deg = 7,
     .top_elevation_deg = 40,
     .object_alone = false},
    {.name = "statue",
     .paper = "107 synthetic, all around: 60 frames a second at 500 triangles, 4.6 at 3500",
     .paper_triangles = {500, 3500},
     .kind = PathKind::kHemisphere,
     .photographs = 107,
     .rows = 5,
     .span_deg = 360,
     .elevation_deg = -10,
     .top_elevation_deg = 70,
     .object_alone = true},
};

/// What stands on the table.
const std::set<std::string> kObject{"table", "plinth", "cat", "cat's gold", "vase"};

SceneDescription description_of(const SceneSettings& settings, const RivalCaptureOptions& options) {
    SceneDescription description =
        read_scene_description(ConfigSection::from_text(demo_scene_toml(), settings.name));
    description.camera = pinhole_camera(options.size_px, options.size_px, 1.1 * options.size_px);
    description.path.kind = settings.kind;
    description.path.count = settings.photographs + options.held_out;
    description.path.rows = settings.rows;
    description.path.start_at = 0;
    description.path.span_deg = settings.span_deg;
    description.path.elevation_deg = settings.elevation_deg;
    description.path.top_elevation_deg = settings.top_elevation_deg;
    if (settings.object_alone)
        std::erase_if(description.scene.bodies,
                      [](const Body& body) { return !kObject.contains(body.name()); });
    return description;
}

DepthMap depth_map_of(const FloatImage& z) {
    DepthMap map{FloatImage(z.width(), z.height()), GrayImage(z.width(), z.height(), kKnown)};
    std::transform(z.pixels().begin(), z.pixels().end(), map.inverse_depth.pixels().begin(),
                   [](float depth) { return depth > 0 ? 1 / depth : 0.0F; });
    return map;
}

/// Inverse depth that this share of the samples lie below.
double inverse_depth_at(const std::vector<FloatImage>& depths, double share) {
    std::vector<float> samples;
    for (const FloatImage& z : depths)
        for (std::size_t i = 0; i < z.pixels().size(); i += 97)
            if (z.pixels()[i] > 0) samples.push_back(1 / z.pixels()[i]);
    return static_cast<double>(quantile_of(std::move(samples), share));
}

/// Evenly among the places, but not at the ends.
std::set<std::size_t> held_out_places(std::size_t places, int count) {
    std::set<std::size_t> chosen;
    for (int i = 0; i < count; ++i)
        chosen.insert((2 * static_cast<std::size_t>(i) + 1) * places /
                      (2 * static_cast<std::size_t>(count)));
    return chosen;
}

/// The capture without what is held out, its views in the order that the Lumigraph has.
Capture kept_part(const Capture& capture, const std::set<std::size_t>& held_out) {
    Capture kept;
    kept.cameras = capture.cameras;
    std::vector<int> index_of(capture.views.size(), -1);
    for (std::size_t i = 0; i < capture.views.size(); ++i) {
        if (held_out.contains(i)) continue;
        index_of[i] = static_cast<int>(kept.views.size());
        kept.views.push_back(capture.views[i]);
    }
    for (ScenePoint point : capture.points) {
        std::erase_if(point.track, [&](const auto& seen) {
            return index_of[static_cast<std::size_t>(seen.view_index)] < 0;
        });
        for (auto& seen : point.track)
            seen.view_index = index_of[static_cast<std::size_t>(seen.view_index)];
        if (!point.track.empty()) kept.points.push_back(point);
    }
    return kept;
}

/// `shown` is left empty.
TrueFrame true_frame(const SceneDescription& description, const Rigid3& cam_from_world) {
    const ExactPicture exact =
        photograph(description.scene, description.camera, cam_from_world, description.sampling);
    return {{description.camera, cam_from_world}, develop(exact.light, {}, 0), exact.depth, {}};
}

const SceneSettings& settings_named(const std::string& name) {
    return *std::find_if(std::begin(kScenes), std::end(kScenes),
                         [&](const SceneSettings& settings) { return settings.name == name; });
}

}  // namespace

std::vector<std::string> rival_scene_names() {
    std::vector<std::string> names;
    for (const SceneSettings& settings : kScenes) names.emplace_back(settings.name);
    return names;
}

ColorImage true_picture(const std::string& name, const RivalCaptureOptions& options,
                        const Eye& eye) {
    SceneDescription description = description_of(settings_named(name), options);
    description.camera = eye.camera;
    return true_frame(description, eye.cam_from_world).picture;
}

RivalCapture rival_capture(const std::string& name, const RivalCaptureOptions& options,
                           Progress& progress) {
    const SceneSettings& settings = settings_named(name);
    const SceneDescription description = description_of(settings, options);
    const SyntheticCapture taken = synthesize(description, 0, progress);
    const std::set<std::size_t> places =
        held_out_places(taken.capture.views.size(), options.held_out);
    RivalCapture result;
    result.name = settings.name;
    result.paper = settings.paper;
    for (const std::size_t count : settings.paper_triangles)
        if (count > 0) result.paper_triangles.push_back(count);
    Lumigraph& lumigraph = result.lumigraph;
    lumigraph.name = settings.name;
    for (std::size_t i = 0; i < taken.capture.views.size(); ++i) {
        const View& view = taken.capture.views[i];
        if (places.contains(i)) {
            result.held_out.push_back({{description.camera, view.cam_from_world},
                                       taken.photographs[i],
                                       taken.depths[i],
                                       {}});
        } else {
            lumigraph.views.push_back({view.name, description.camera, view.cam_from_world, 1,
                                       taken.photographs[i], depth_map_of(taken.depths[i])});
        }
    }
    const Capture kept = kept_part(taken.capture, places);
    std::vector<int> all;
    for (std::size_t i = 0; i < kept.views.size(); ++i) all.push_back(static_cast<int>(i));
    lumigraph.mesh = build_camera_mesh(kept, all, {}).mesh;
    lumigraph.near_depth = 1 / inverse_depth_at(taken.depths, 0.99);
    lumigraph.far_depth = 1 / inverse_depth_at(taken.depths, 0.01);
    make_depth_meshes(lumigraph, 0, progress);
    choose(asked_drawing_efforts(lumigraph, kept, {}, {}, progress), lumigraph.drawing);
    for (TrueFrame& frame : result.held_out)
        frame.shown = shown_pixels(frame.depth, frame.eye, lumigraph.views);
    for (const TrueFrame& frame : result.held_out)
        for (const double share_of_distance : {0.1, -0.1})
            result.off_cameras.push_back(true_frame(
                description, moved_ahead(lumigraph, frame.eye, share_of_distance).cam_from_world));
    for (int i = 0; i < options.path_frames; ++i)
        result.path.push_back(true_frame(
            description,
            pose_between(result.held_out[0].eye.cam_from_world,
                         result.held_out[1].eye.cam_from_world,
                         static_cast<double>(i) / std::max(1, options.path_frames - 1))));
    return result;
}

}  // namespace lumi
