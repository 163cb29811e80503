#include "pipeline/evaluate/ghost_energy.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "meshing/surface/nearest_cameras.h"
#include "render/renderer/offscreen_renderer.h"

namespace lumi {
namespace {

/// Frames have 8 bits: the luma of a camera whose weight is less than a sixteenth is lost in them,
/// and what it adds to the variance is noise.
constexpr std::uint8_t kLeastWeight = 16;

/// Sums over the classes at each pixel of one eye.
struct ClassMoments {
    FloatImage weight;
    FloatImage luma;
    FloatImage squared_luma;
    GrayImage coverage;
};

/// The Lumigraph whose photographs tell of one class alone: red is luma, green says "here".
Lumigraph only_class(const Lumigraph& lumigraph, const std::vector<int>& classes, int wanted) {
    Lumigraph result = lumigraph;
    for (std::size_t i = 0; i < result.views.size(); ++i) {
        const bool is_wanted = classes[i] == wanted;
        for (Rgb8& pixel : result.views[i].photograph.pixels()) {
            const double luma = 0.299 * pixel.r + 0.587 * pixel.g + 0.114 * pixel.b;
            pixel = is_wanted ? Rgb8{static_cast<std::uint8_t>(std::lround(luma)), 255, 0} : Rgb8{};
        }
    }
    return result;
}

void add_class(ClassMoments& moments, const Frame& frame) {
    for (std::size_t i = 0; i < frame.color.pixels().size(); ++i) {
        const Rgb8& pixel = frame.color.pixels()[i];
        if (pixel.g < kLeastWeight) continue;
        const float weight = static_cast<float>(pixel.g) / 255.0F;
        const float weighted_luma = static_cast<float>(pixel.r);
        moments.weight.pixels()[i] += weight;
        moments.luma.pixels()[i] += weighted_luma;
        moments.squared_luma.pixels()[i] += weighted_luma * weighted_luma / weight;
    }
    moments.coverage = frame.coverage;
}

/// Of a mesh without faces.
std::vector<std::set<int>> views_blended_for(const CameraMesh& mesh, int view_count,
                                             const std::vector<Eye>& eyes) {
    std::vector<std::set<int>> blended(static_cast<std::size_t>(view_count));
    for (const Eye& eye : eyes) {
        for (const EyeBlend& blend : blends_of_eye(mesh, centre_in_world(eye.cam_from_world),
                                                   optical_axis_in_world(eye.cam_from_world)))
            for (const int one : blend.weights.view_indices)
                for (const int other : blend.weights.view_indices)
                    if (one != other) blended[static_cast<std::size_t>(one)].insert(other);
    }
    return blended;
}

FloatImage variance(const ClassMoments& moments) {
    FloatImage result(moments.weight.width(), moments.weight.height());
    for (std::size_t i = 0; i < result.pixels().size(); ++i) {
        const float weight = moments.weight.pixels()[i];
        if (weight <= 0.0F || moments.coverage.pixels()[i] == 0) continue;
        const float mean = moments.luma.pixels()[i] / weight;
        result.pixels()[i] =
            std::max(0.0F, moments.squared_luma.pixels()[i] / weight - mean * mean);
    }
    return result;
}

}  // namespace

std::vector<int> camera_classes(const CameraMesh& mesh, int view_count,
                                const std::vector<Eye>& eyes) {
    const std::vector<std::set<int>> neighbours =
        mesh.faces.empty() ? views_blended_for(mesh, view_count, eyes)
                           : neighbouring_views(mesh, static_cast<std::size_t>(view_count));
    std::vector<int> classes(static_cast<std::size_t>(view_count), -1);
    for (std::size_t view = 0; view < classes.size(); ++view) {
        std::set<int> taken;
        for (const int other : neighbours[view]) {
            taken.insert(classes[static_cast<std::size_t>(other)]);
        }
        int free_class = 0;
        while (taken.contains(free_class)) ++free_class;
        classes[view] = free_class;
    }
    return classes;
}

std::vector<FloatImage> ghost_energies(const Lumigraph& lumigraph, const std::vector<Eye>& eyes,
                                       RenderMode mode, Progress& progress) {
    const std::vector<int> classes =
        camera_classes(lumigraph.mesh, static_cast<int>(lumigraph.views.size()), eyes);
    const int class_count = 1 + *std::max_element(classes.begin(), classes.end());
    std::vector<ClassMoments> moments;
    for (const Eye& eye : eyes) {
        const FloatImage zero(eye.camera.width_px, eye.camera.height_px, 0.0F);
        moments.push_back({zero, zero, zero, {}});
    }
    progress.begin("measuring ghost energy", static_cast<std::size_t>(class_count) * eyes.size());
    for (int wanted = 0; wanted < class_count; ++wanted) {
        OffscreenRenderer renderer(only_class(lumigraph, classes, wanted));
        for (std::size_t i = 0; i < eyes.size(); ++i) {
            progress.throw_if_interrupted();
            add_class(moments[i], renderer.draw(eyes[i], {.mode = mode}));
            progress.advance();
        }
    }
    std::vector<FloatImage> energies;
    for (const ClassMoments& sums : moments) energies.push_back(variance(sums));
    return energies;
}

}  // namespace lumi
