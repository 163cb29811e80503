#include "meshing/geometry/triangle_mesh_writing.h"

#include <bit>
#include <string>

#include "calib/work/whole_file.h"
#include "meshing/surface/places_in_floats.h"

namespace lumi {
namespace {

static_assert(std::endian::native == std::endian::little);

/// To a thousandth of the triangles' sides, on average.
bool floats_hold_places_of(const TriangleMesh& mesh) {
    double distances = 0;
    double lengths = 0;
    for (const auto& face : mesh.faces) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector3d& a = mesh.vertices[face[corner]];
            const Eigen::Vector3d& b = mesh.vertices[face[(corner + 1) % 3]];
            distances += a.norm();
            lengths += (b - a).norm();
        }
    }
    return floats_hold_places(distances, lengths);
}

}  // namespace

void write_triangle_mesh_ply(const std::filesystem::path& path, const TriangleMesh& mesh) {
    const bool has_normals = mesh.normals.size() == mesh.vertices.size();
    const bool has_colors = mesh.colors.size() == mesh.vertices.size();
    std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                         std::to_string(mesh.vertices.size());
    const bool are_floats = floats_hold_places_of(mesh);
    for (const char* axis : {"x", "y", "z"}) {
        header += std::string("\nproperty ") + (are_floats ? "float " : "double ") + axis;
    }
    header += "\n";
    if (has_normals) header += "property float nx\nproperty float ny\nproperty float nz\n";
    if (has_colors) header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    header += "element face " + std::to_string(mesh.faces.size()) +
              "\nproperty list uchar uint vertex_indices\nend_header\n";
    Bytes bytes(header.begin(), header.end());
    const auto append = [&](const void* data, std::size_t size) {
        const auto* begin = static_cast<const std::uint8_t*>(data);
        bytes.insert(bytes.end(), begin, begin + size);
    };
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        if (are_floats) {
            const Eigen::Vector3f place = mesh.vertices[i].cast<float>();
            append(place.data(), 3 * sizeof(float));
        } else {
            append(mesh.vertices[i].data(), 3 * sizeof(double));
        }
        if (has_normals) append(mesh.normals[i].data(), 3 * sizeof(float));
        if (has_colors) append(&mesh.colors[i], sizeof(Rgb8));
    }
    for (const auto& face : mesh.faces) {
        bytes.push_back(3);
        append(face.data(), 3 * sizeof(std::uint32_t));
    }
    write_whole_file(path, bytes);
}

}  // namespace lumi
