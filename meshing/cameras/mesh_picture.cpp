#include "meshing/cameras/mesh_picture.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "calib/work/formatted.h"
#include "calib/work/median.h"
#include "calib/work/svg_escaped.h"
#include "meshing/cameras/written_names.h"

namespace lumi {
namespace {

constexpr double kPanelWidth = 560;
constexpr double kPanelHeight = 480;
constexpr double kGap = 20;
constexpr double kHeadline = 30;
constexpr double kFootline = 26;
constexpr double kNameSize = 9;  ///< Of the letters.
/// Above this many cameras, only every other, third ... name is written.
constexpr std::size_t kMaxNames = 14;
constexpr std::size_t kMaxPoints = 2500;
constexpr const char* kFaceStroke = "#2f6fb0";
constexpr const char* kShellStroke = "#d68910";
constexpr const char* kCameraStroke = "#c0392b";
constexpr const char* kLeftOutStroke = "#999999";
constexpr const char* kSuggestedStroke = "#1e8449";

/// A parallel projection of the world into a frame of the drawing.
struct Panel {
    Eigen::Vector3d origin_in_world;
    Eigen::Vector3d rightward;
    Eigen::Vector3d downward;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< Of what is shown, in world units.
    double scale = 1;                                  ///< Drawing units per world unit.
    double left = 0;                                   ///< Of the frame.

    [[nodiscard]] Eigen::Vector2d flat(const Eigen::Vector3d& point) const {
        const Eigen::Vector3d offset = point - origin_in_world;
        return {offset.dot(rightward), offset.dot(downward)};
    }
    [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector3d& point) const {
        const Eigen::Vector2d frame_middle(left + kPanelWidth / 2, kHeadline + kPanelHeight / 2);
        return frame_middle + scale * (flat(point) - middle);
    }
};

/// What is drawn, in the world.
struct Drawing {
    const Capture& capture;
    const std::vector<int>& view_indices;
    const CameraMesh& mesh;
    const std::vector<Rigid3>& suggested;
    double camera_size = 1;  ///< Length of a frustum, world units.
    std::vector<const ScenePoint*> points;
};

const View& view_of(const Drawing& drawing, int view_index) {
    return drawing.capture.views[static_cast<std::size_t>(view_index)];
}

std::vector<const ScenePoint*> thinned_points(const Capture& capture) {
    std::vector<const ScenePoint*> points;
    const std::size_t count = std::min(capture.points.size(), kMaxPoints);
    for (std::size_t i = 0; i < count; ++i) {
        points.push_back(&capture.points[i * capture.points.size() / count]);
    }
    return points;
}

Eigen::Vector3d mean_up(const Drawing& drawing) {
    Eigen::Vector3d up = Eigen::Vector3d::Zero();
    for (const int index : drawing.view_indices) {
        up -=
            view_of(drawing, index).cam_from_world.rotation.conjugate() * Eigen::Vector3d::UnitY();
    }
    return up.norm() > 1e-9 ? up.normalized() : Eigen::Vector3d::UnitZ();
}

/// Scales the panel so that the cameras, the centre and all but the outermost points fit.
void fit(Panel& panel, const Drawing& drawing) {
    std::array<std::vector<double>, 2> point_extent;
    for (const ScenePoint* point : drawing.points) {
        const Eigen::Vector2d flat = panel.flat(point->position_in_world);
        point_extent[0].push_back(flat.x());
        point_extent[1].push_back(flat.y());
    }
    Eigen::Vector2d least = panel.flat(drawing.mesh.scene_centre_in_world);
    Eigen::Vector2d most = least;
    for (const Rigid3& pose : drawing.suggested) {
        const Eigen::Vector2d flat = panel.flat(centre_in_world(pose));
        least = least.cwiseMin(flat);
        most = most.cwiseMax(flat);
    }
    for (const int index : drawing.view_indices) {
        const Eigen::Vector2d flat =
            panel.flat(centre_in_world(view_of(drawing, index).cam_from_world));
        least = least.cwiseMin(flat);
        most = most.cwiseMax(flat);
    }
    for (int axis = 0; axis < 2 && !drawing.points.empty(); ++axis) {
        const auto& values = point_extent[static_cast<std::size_t>(axis)];
        least[axis] = std::min(least[axis], quantile_of(values, 0.03));
        most[axis] = std::max(most[axis], quantile_of(values, 0.97));
    }
    const Eigen::Vector2d extent = (most - least).cwiseMax(2 * drawing.camera_size) * 1.15;
    panel.middle = (least + most) / 2;
    panel.scale = std::min(kPanelWidth / extent.x(), kPanelHeight / extent.y());
}

void draw_points(std::string& svg, const Panel& panel, const Drawing& drawing) {
    for (const ScenePoint* point : drawing.points) {
        const Eigen::Vector2d at = panel.at(point->position_in_world);
        svg += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1\" fill=\"#%02x%02x%02x\"/>\n",
                         at.x(), at.y(), unsigned{point->color.r}, unsigned{point->color.g},
                         unsigned{point->color.b});
    }
}

void draw_faces(std::string& svg, const Panel& panel, const CameraMesh& mesh, const char* stroke) {
    const auto vertex = [&mesh](int index) -> const CameraMesh::Vertex& {
        return mesh.vertices[static_cast<std::size_t>(index)];
    };
    for (const CameraMesh::Face& face : mesh.faces) {
        // A strip's vertices stand far above and below its cameras.
        const bool pale = is_strip(mesh) || std::any_of(face.begin(), face.end(), [&](int index) {
                              return vertex(index).is_virtual;
                          });
        svg += formatted(
            "<path fill=\"%s\" fill-opacity=\"%s\" stroke=\"%s\" stroke-opacity=\"%s\" d=\"",
            stroke, pale ? "0.02" : "0.06", stroke, pale ? "0.18" : "0.7");
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector2d at = panel.at(vertex(face[corner]).position_in_world);
            svg += formatted("%s%.1f %.1f", corner == 0 ? "M" : "L", at.x(), at.y());
        }
        svg += "Z\"/>\n";
    }
}

/// What a mesh without faces has in their place: who is near whom.
void draw_neighbours(std::string& svg, const Panel& panel, const CameraMesh& mesh,
                     const char* stroke) {
    if (mesh.construction != MeshConstruction::kNearest) return;
    std::map<int, Eigen::Vector2d> place_of_view;
    for (const CameraMesh::Vertex& camera : mesh.vertices)
        place_of_view[camera.view_index] = panel.at(camera.position_in_world);
    const auto neighbours =
        neighbouring_views(mesh, static_cast<std::size_t>(place_of_view.rbegin()->first) + 1);
    for (const auto& [view, from] : place_of_view) {
        for (const int other : neighbours[static_cast<std::size_t>(view)]) {
            if (other < view) continue;
            const Eigen::Vector2d& to = place_of_view.at(other);
            svg += formatted(
                "<path stroke=\"%s\" stroke-opacity=\"0.5\" d=\"M%.1f %.1fL%.1f %.1f\"/>\n", stroke,
                from.x(), from.y(), to.x(), to.y());
        }
    }
}

void draw_frustum(std::string& svg, const Panel& panel, const Drawing& drawing,
                  const Camera& camera, const Rigid3& cam_from_world, const char* stroke) {
    const Rigid3 world_from_cam = inverse(cam_from_world);
    const Eigen::Vector2d apex = panel.at(world_from_cam.translation);
    const double width = camera.width_px;
    const double height = camera.height_px;
    std::string base;
    std::string sides;
    for (const Eigen::Vector2d& pixel :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(width, 0), Eigen::Vector2d(width, height),
          Eigen::Vector2d(0, height)}) {
        const Eigen::Vector3d in_cam = drawing.camera_size * unproject(camera, pixel);
        const Eigen::Vector2d at = panel.at(world_from_cam * in_cam);
        base += formatted("%s%.1f %.1f", base.empty() ? "M" : "L", at.x(), at.y());
        sides += formatted("M%.1f %.1fL%.1f %.1f", apex.x(), apex.y(), at.x(), at.y());
    }
    svg += "<path fill=\"none\" stroke=\"" + std::string(stroke) + "\" d=\"" + base + "Z" + sides +
           "\"/>\n";
    svg += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.2\" fill=\"%s\"/>\n", apex.x(),
                     apex.y(), stroke);
}

void draw_cameras(std::string& svg, const Panel& panel, const Drawing& drawing) {
    std::set<int> kept;
    for (const CameraMesh::Vertex& vertex : drawing.mesh.vertices) kept.insert(vertex.view_index);
    for (const CameraMesh& shell : drawing.mesh.shells) {
        for (const CameraMesh::Vertex& vertex : shell.vertices) kept.insert(vertex.view_index);
    }
    WrittenNames names(kNameSize);
    const std::size_t name_every = 1 + (drawing.view_indices.size() - 1) / kMaxNames;
    for (std::size_t i = 0; i < drawing.view_indices.size(); ++i) {
        const int index = drawing.view_indices[i];
        const View& view = view_of(drawing, index);
        draw_frustum(svg, panel, drawing, camera_of(drawing.capture, view), view.cam_from_world,
                     kept.contains(index) ? kCameraStroke : kLeftOutStroke);
        if (i % name_every != 0) continue;
        const Eigen::Vector2d at =
            panel.at(centre_in_world(view.cam_from_world)) + Eigen::Vector2d(4, -4);
        if (!names.claim(at, view.name)) continue;
        svg += formatted("<text x=\"%.1f\" y=\"%.1f\">", at.x(), at.y());
        svg += svg_escaped(view.name) + "</text>\n";
    }
}

void draw_suggestions(std::string& svg, const Panel& panel, const Drawing& drawing) {
    const Camera& camera = camera_of(drawing.capture, view_of(drawing, drawing.view_indices[0]));
    for (std::size_t i = 0; i < drawing.suggested.size(); ++i) {
        draw_frustum(svg, panel, drawing, camera, drawing.suggested[i], kSuggestedStroke);
        const Eigen::Vector2d at = panel.at(centre_in_world(drawing.suggested[i]));
        svg += formatted("<text x=\"%.1f\" y=\"%.1f\" font-size=\"14\" fill=\"%s\">%zu</text>\n",
                         at.x() + 5, at.y() - 5, kSuggestedStroke, i + 1);
    }
}

std::string panel_svg(const Panel& panel, const Drawing& drawing, const char* title,
                      const char* id) {
    std::string svg;
    svg += formatted("<text x=\"%.0f\" y=\"20\" font-size=\"14\" fill=\"#222222\">%s</text>\n",
                     panel.left, title);
    svg += formatted(
        "<clipPath id=\"%s\"><rect x=\"%.0f\" y=\"%.0f\" width=\"%.0f\" height=\"%.0f\"/>"
        "</clipPath>\n<g clip-path=\"url(#%s)\">\n",
        id, panel.left, kHeadline, kPanelWidth, kPanelHeight, id);
    draw_points(svg, panel, drawing);
    draw_faces(svg, panel, drawing.mesh, kFaceStroke);
    draw_neighbours(svg, panel, drawing.mesh, kFaceStroke);
    for (const CameraMesh& shell : drawing.mesh.shells) {
        draw_faces(svg, panel, shell, kShellStroke);
    }
    draw_cameras(svg, panel, drawing);
    draw_suggestions(svg, panel, drawing);
    const Eigen::Vector2d centre = panel.at(drawing.mesh.scene_centre_in_world);
    svg += formatted(
        "<path stroke=\"#111111\" stroke-width=\"1.5\" d=\"M%.1f %.1fh12m-6 -6v12\"/>\n</g>\n",
        centre.x() - 6, centre.y());
    svg += formatted(
        "<rect x=\"%.0f\" y=\"%.0f\" width=\"%.0f\" height=\"%.0f\" fill=\"none\" "
        "stroke=\"#bbbbbb\"/>\n",
        panel.left, kHeadline, kPanelWidth, kPanelHeight);
    return svg;
}

/// The median distance of the drawn cameras from the scene's centre, world units.
double usual_camera_distance(const Drawing& drawing) {
    std::vector<double> distances;
    for (const int index : drawing.view_indices) {
        distances.push_back((centre_in_world(view_of(drawing, index).cam_from_world) -
                             drawing.mesh.scene_centre_in_world)
                                .norm());
    }
    return quantile_of(std::move(distances), 0.5);
}

}  // namespace

std::string camera_mesh_svg(const Capture& capture, const std::vector<int>& view_indices,
                            const CameraMesh& mesh, const std::vector<Rigid3>& suggested) {
    Drawing drawing{capture, view_indices, mesh, suggested, 1.0, thinned_points(capture)};
    drawing.camera_size = std::max(0.06 * usual_camera_distance(drawing), 1e-300);
    const Eigen::Vector3d up = mean_up(drawing);
    Eigen::Vector3d inward = Eigen::Vector3d::Zero();
    for (const int index : view_indices) {
        inward += optical_axis_in_world(view_of(drawing, index).cam_from_world);
    }
    inward -= inward.dot(up) * up;
    const Eigen::Vector3d forward =
        inward.norm() > 1e-6 ? Eigen::Vector3d(inward.normalized()) : up.unitOrthogonal();
    const Eigen::Vector3d rightward = forward.cross(up);

    Panel above{mesh.scene_centre_in_world, rightward, -forward};
    Panel beside{mesh.scene_centre_in_world, forward, -up};
    beside.left = kPanelWidth + kGap;
    fit(above, drawing);
    fit(beside, drawing);
    std::string svg;
    svg += formatted(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-10 0 %.0f %.0f\" "
        "font-family=\"sans-serif\" font-size=\"%.0f\" fill=\"#444444\" stroke-width=\"0.8\">\n",
        2 * kPanelWidth + kGap + 20, kHeadline + kPanelHeight + kFootline, kNameSize);
    svg += panel_svg(above, drawing, "Camera mesh from above", "above");
    svg += panel_svg(beside, drawing, "from the side (photographs look to the right)", "beside");
    svg += formatted("<text x=\"0\" y=\"%.0f\" font-size=\"11\">", kHeadline + kPanelHeight + 17);
    svg +=
        "blue: faces, pale where they go on beyond the cameras; red: cameras; grey: cameras "
        "that are no vertex; +: scene centre" +
        std::string(mesh.shells.empty() ? "" : "; orange: shells over close-ups") +
        std::string(suggested.empty() ? "" : "; green: where to photograph next") +
        "</text>\n</svg>\n";
    return svg;
}

}  // namespace lumi
