#include "meshing/fusion/fused_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "meshing/fusion/front_surface.h"

namespace lumi {
namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

void require(bool holds, const std::string& what) {
    if (holds) return;
    throw Error(ErrorKind::kUsage, "E-FUSE-OPTION", what, "correct the option");
}

[[noreturn]] void refuse_few(std::size_t points) {
    throw Error(ErrorKind::kDegenerateCapture, "E-FUSE-FEW",
                "the views agree on " + counted(points, "point") +
                    ", through which no surface goes: too few for a mesh of the scene",
                "find depth with model = \"sweep\" or one above it from overlapping photographs");
}

/// Which piece of the surface each point belongs to, by one of its points.
class Pieces {
 public:
    Pieces(std::size_t points, const Faces& faces) : parent_(points) {
        std::iota(parent_.begin(), parent_.end(), 0U);
        for (const auto& face : faces) {
            join(face[0], face[1]);
            join(face[1], face[2]);
        }
    }
    [[nodiscard]] std::uint32_t of(std::uint32_t point) {
        while (parent_[point] != point) {
            parent_[point] = parent_[parent_[point]];
            point = parent_[point];
        }
        return point;
    }

 private:
    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t root_a = of(a);
        const std::uint32_t root_b = of(b);
        parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    }
    std::vector<std::uint32_t> parent_;
};

/// Scraps that float before or behind the scene: pieces of less than a thousandth of the surface.
void remove_scraps(std::size_t points, Faces& faces) {
    constexpr std::size_t kMinFaces = 20;
    Pieces pieces(points, faces);
    std::vector<std::size_t> size(points);
    for (const auto& face : faces) ++size[pieces.of(face[0])];
    const std::size_t least = std::max(kMinFaces, faces.size() / 1000);
    std::erase_if(faces, [&](const auto& face) { return size[pieces.of(face[0])] < least; });
}

/// The points that faces use, and the faces over them.
TriangleMesh mesh_of(const std::vector<SurfacePoint>& points, const Faces& faces) {
    constexpr std::uint32_t kUnused = UINT32_MAX;
    std::vector<std::uint32_t> index(points.size(), kUnused);
    TriangleMesh mesh;
    for (const auto& face : faces) {
        std::array<std::uint32_t, 3> kept{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const SurfacePoint& point = points[face[corner]];
            std::uint32_t& at = index[face[corner]];
            if (at == kUnused) {
                at = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(point.position);
                mesh.normals.push_back(point.normal);
                mesh.colors.push_back(point.color);
            }
            kept[corner] = at;
        }
        mesh.faces.push_back(kept);
    }
    return mesh;
}

}  // namespace

void validate(const SurfacePointOptions& options) {
    require(std::isfinite(options.spacing_px) && options.spacing_px >= 1,
            "spacing: expected 1 pixel or more, found " + std::to_string(options.spacing_px));
    require(options.max_points >= 1000,
            "max points: expected at least 1000, found " + std::to_string(options.max_points));
    require(options.min_agreeing_views >= 1, "agreeing views: expected at least 1, found " +
                                                 std::to_string(options.min_agreeing_views));
}

FusedMesh fused_mesh(const std::vector<PicturedView>& views, const SurfacePointOptions& options,
                     int threads, Progress& progress) {
    validate(options);
    constexpr std::size_t kFewestPoints = 100;
    const SurfacePoints found = surface_points(views, options, threads, progress);
    if (found.points.size() < kFewestPoints) refuse_few(found.points.size());
    progress.begin("surface through " + std::to_string(found.points.size()) + " points", 0);
    Faces faces = front_surface(found.points);
    progress.throw_if_interrupted();
    remove_scraps(found.points.size(), faces);
    if (faces.empty()) refuse_few(found.points.size());
    return {mesh_of(found.points, faces), found.confident_pixels, found.agreeing_pixels,
            found.spacing_px};
}

}  // namespace lumi
