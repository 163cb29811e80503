#include "render/lumigraph/lumigraph.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "calib/capture/light_left.h"
#include "calib/work/error.h"
#include "calib/work/formatted.h"
#include "calib/work/printable.h"

namespace lumi {
namespace {

[[noreturn]] void refuse_lumigraph(const std::string& where, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-LUMIGRAPH-INVALID", where + ": " + what,
                "build the package again with `lumi build`");
}

void validate_depth(const DepthMap& depth, const std::string& where) {
    const FloatImage& inverse_depth = depth.inverse_depth;
    if (inverse_depth.width() != depth.confidence.width() ||
        inverse_depth.height() != depth.confidence.height()) {
        refuse_lumigraph(where, "expected inverse depth and confidence of one size");
    }
    const bool in_range = std::all_of(inverse_depth.pixels().begin(), inverse_depth.pixels().end(),
                                      [](float q) { return std::isfinite(q) && q >= 0.0F; });
    if (!in_range) refuse_lumigraph(where, "expected finite inverse depths >= 0");
}

void validate_depth_mesh(const DepthMesh& mesh, const std::string& where) {
    const bool sorted_by_kind = mesh.kind_begin.front() == 0 &&
                                mesh.kind_begin.back() == mesh.indices.size() &&
                                std::is_sorted(mesh.kind_begin.begin(), mesh.kind_begin.end()) &&
                                std::all_of(mesh.kind_begin.begin(), mesh.kind_begin.end(),
                                            [](std::size_t begin) { return begin % 3 == 0; });
    const bool names_vertices =
        std::all_of(mesh.indices.begin(), mesh.indices.end(),
                    [&](std::uint32_t index) { return index < mesh.vertices.size(); });
    const bool is_finite = std::all_of(
        mesh.vertices.begin(), mesh.vertices.end(),
        [](const Eigen::Vector3f& vertex) { return vertex.allFinite() && vertex.z() >= 0; });
    if (!sorted_by_kind || !names_vertices || !is_finite)
        refuse_lumigraph(where, "expected a depth mesh of triangles between finite vertices");
}

/// Of the picture's longer side. A picture 179.8 degrees across has the least focal length; a
/// hundred pixels that a telescope took have a tenth of the most, and where they were cut from the
/// border of a large picture, the principal point lies a hundredth of the farthest away. Beyond all
/// that are no cameras, and numbers whose squares are none.
constexpr double kLeastFocalLength_sides = 1e-3;
constexpr double kMostFocalLength_sides = 1e6;
constexpr double kFarthestPrincipalPoint_sides = 1e4;

void validate_camera(const Camera& camera, const std::string& where) {
    validate(camera, where);
    if (camera.model != LensModel::kPinhole) refuse_lumigraph(where, "expected a PINHOLE camera");
    const double side_px = std::max(camera.width_px, camera.height_px);
    const Eigen::Vector2d focal_sides = focal_length_px(camera) / side_px;
    if (!(focal_sides.minCoeff() >= kLeastFocalLength_sides &&
          focal_sides.maxCoeff() <= kMostFocalLength_sides))
        refuse_lumigraph(where,
                         "expected focal lengths from 1/1000 to 1000000 times the longer side");
    if (principal_point_px(camera).cwiseAbs().maxCoeff() > kFarthestPrincipalPoint_sides * side_px)
        refuse_lumigraph(where, "expected the principal point within 10000 times the longer side");
}

void validate_view(const LumigraphView& view, const std::string& where) {
    validate_camera(view.camera, where);
    if (view.photograph.width() != view.camera.width_px ||
        view.photograph.height() != view.camera.height_px) {
        refuse_lumigraph(where, "expected a photograph of its camera's size");
    }
    if (!is_rigid(view.cam_from_world)) {
        refuse_lumigraph(where, "expected a finite rotation and translation");
    }
    if (view.exif_orientation < 1 || view.exif_orientation > 8) {
        refuse_lumigraph(where, "expected an EXIF orientation from 1 to 8");
    }
    for (const double gain : view.exposure_gain) {
        if (!(gain >= 1 / kLargestExposureGain && gain <= kLargestExposureGain)) {
            refuse_lumigraph(where, "expected exposure gains from 1/16 to 16");
        }
    }
    validate_depth(view.depth, where);
    if (view.depth_mesh) validate_depth_mesh(*view.depth_mesh, where);
}

/// A photograph is brightened in its corners by no more than by its exposure.
void validate_falloff(const Lumigraph& lumigraph, const std::string& where) {
    const bool is_falloff = lumigraph.light_falloff <= 0 &&
                            lumigraph.light_left_in_corners() >= 1 / kLargestExposureGain;
    if (!is_falloff)
        refuse_lumigraph(where, "expected a light falloff of 0 or less that leaves 1/16");
}

void validate_drawing(const DrawingChoices& drawing, const std::string& where) {
    for_each_drawing_choice([&](const auto& choice) {
        const auto value = drawing.*choice.member;
        if (!(value >= choice.least && value <= choice.most))
            refuse_lumigraph(where, std::string("expected ") + choice.name + " from " +
                                        formatted("%g", static_cast<double>(choice.least)) +
                                        " to " + formatted("%g", static_cast<double>(choice.most)));
    });
}

}  // namespace

bool Lumigraph::has_depth() const {
    return std::any_of(views.begin(), views.end(),
                       [](const LumigraphView& view) { return view.has_depth(); });
}

double Lumigraph::light_left_in_corners() const {
    double least = 1;
    for (const LumigraphView& view : views)
        least = std::min(least, light_left_in_corner(light_falloff, view.camera));
    return least;
}

void validate(const Lumigraph& lumigraph, const std::string& where) {
    if (lumigraph.views.empty()) refuse_lumigraph(where, "expected at least one view");
    if (!(lumigraph.noisy_depth_error_px >= kLeastNoisyDepthError_px &&
          lumigraph.noisy_depth_error_px <= kMostNoisyDepthError_px))
        refuse_lumigraph(where, "expected noisy depth to be followed to 0.1 to 10 pixels");
    validate_drawing(lumigraph.drawing, where);
    std::set<std::string> names;
    for (const LumigraphView& view : lumigraph.views) {
        validate_view(view, where + ": " + printable(view.name));
        if (view.name.empty()) refuse_lumigraph(where, "a view has no name");
        if (!names.insert(view.name).second) {
            refuse_lumigraph(where, "two views are named " + printable(view.name));
        }
    }
    validate_falloff(lumigraph, where);
    validate(lumigraph.mesh, static_cast<int>(lumigraph.views.size()), where);
    const bool in_range = lumigraph.near_depth >= 0 &&
                          lumigraph.near_depth <= lumigraph.far_depth &&
                          std::isfinite(lumigraph.far_depth);
    if (!in_range) refuse_lumigraph(where, "expected 0 <= near_depth <= far_depth");
}

Lumigraph without_its_views(const Lumigraph& lumigraph) {
    Lumigraph rest;
    rest.name = lumigraph.name;
    rest.near_depth = lumigraph.near_depth;
    rest.far_depth = lumigraph.far_depth;
    rest.noisy_depth_error_px = lumigraph.noisy_depth_error_px;
    rest.drawing = lumigraph.drawing;
    rest.light_falloff = lumigraph.light_falloff;
    rest.evened_falloff = lumigraph.evened_falloff;
    return rest;
}

}  // namespace lumi
