#include "meshing/surface/mesh_io.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <sstream>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "meshing/surface/ply_places.h"

namespace lumi {
namespace {

constexpr const char* kVertexLayout =
    "property double x\nproperty double y\nproperty double z\nproperty int view\n";
/// Written since vertices say whether they are virtual; files without it are read as well.
constexpr const char* kVirtualLayout = "property uchar virtual\n";
/// Written where it matters: of cameras without a surface.
constexpr const char* kSightLayout =
    "property double sight_x\nproperty double sight_y\nproperty double sight_z\n";
constexpr std::size_t kPlaceBytes = 3 * sizeof(double) + sizeof(std::int32_t);
constexpr std::size_t kFaceBytes = 1 + 3 * sizeof(std::int32_t);

template <class Value>
Value take(const Bytes& bytes, std::size_t& offset) {
    Value value;
    std::memcpy(&value, &bytes[offset], sizeof(Value));
    offset += sizeof(Value);
    return value;
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-PLY-READ", path.string() + ": " + what,
                "this is not a camera mesh that lumi wrote; make it again with `lumi mesh`");
}

Bytes header_bytes(const std::string& header) { return {header.begin(), header.end()}; }

bool names_lines_of_sight(const CameraMesh& mesh) {
    return mesh.construction == MeshConstruction::kNearest;
}

/// Shells stand in the same lists, behind the mesh that they belong to, each announced by a line
/// "comment shell CONSTRUCTION CENTRE VERTICES FACES".
std::string camera_mesh_header(const CameraMesh& mesh) {
    std::size_t vertices = mesh.vertices.size();
    std::size_t faces = mesh.faces.size();
    std::ostringstream header;
    header.precision(17);
    const auto put_centre = [&header](const Eigen::Vector3d& centre) {
        header << centre.x() << " " << centre.y() << " " << centre.z();
    };
    header
        << "ply\nformat binary_little_endian 1.0\ncomment lumi camera mesh\ncomment construction "
        << name_of(mesh.construction) << "\ncomment scene_centre ";
    put_centre(mesh.scene_centre_in_world);
    for (const CameraMesh& shell : mesh.shells) {
        vertices += shell.vertices.size();
        faces += shell.faces.size();
        header << "\ncomment shell " << name_of(shell.construction) << " ";
        put_centre(shell.scene_centre_in_world);
        header << " " << shell.vertices.size() << " " << shell.faces.size();
    }
    header << "\nelement vertex " << vertices << "\n"
           << kVertexLayout << kVirtualLayout << (names_lines_of_sight(mesh) ? kSightLayout : "")
           << "element face " << faces << "\nproperty list uchar int vertex_indices\nend_header\n";
    return header.str();
}

void put_vector(Bytes& bytes, const Eigen::Vector3d& vector) {
    for (int axis = 0; axis < 3; ++axis) append_to_ply(vector[axis], bytes);
}

Eigen::Vector3d take_vector(const Bytes& bytes, std::size_t& offset) {
    Eigen::Vector3d vector;
    for (int axis = 0; axis < 3; ++axis) vector[axis] = take<double>(bytes, offset);
    return vector;
}

void put_vertices(Bytes& bytes, const CameraMesh& mesh, bool with_lines_of_sight) {
    for (const CameraMesh::Vertex& vertex : mesh.vertices) {
        put_vector(bytes, vertex.position_in_world);
        append_to_ply(static_cast<std::int32_t>(vertex.view_index), bytes);
        append_to_ply(static_cast<std::uint8_t>(vertex.is_virtual ? 1 : 0), bytes);
        if (with_lines_of_sight) put_vector(bytes, vertex.line_of_sight_in_world);
    }
}

void put_faces(Bytes& bytes, const CameraMesh& mesh, std::size_t first_vertex) {
    for (const CameraMesh::Face& face : mesh.faces) {
        append_to_ply(std::uint8_t{3}, bytes);
        for (const int index : face) {
            append_to_ply(
                static_cast<std::int32_t>(index) + static_cast<std::int32_t>(first_vertex), bytes);
        }
    }
}

/// The header's lines up to and including end_header; `offset` is set behind them.
std::vector<std::string> header_lines(const Bytes& bytes, std::size_t& offset,
                                      const std::filesystem::path& path) {
    constexpr std::size_t kMaxLines = 100'000;
    std::vector<std::string> lines;
    while (lines.size() < kMaxLines) {
        const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(offset);
        const auto end = std::find(begin, bytes.end(), std::uint8_t{'\n'});
        if (end == bytes.end()) break;
        lines.emplace_back(begin, end);
        offset = static_cast<std::size_t>(end - bytes.begin()) + 1;
        if (lines.back() == "end_header") return lines;
    }
    refuse(path, "expected a PLY header");
}

/// How many entries of the lists belong to one surface.
struct Part {
    std::size_t vertices = 0;
    std::size_t faces = 0;
};

struct ParsedHeader {
    bool names_virtual_vertices = false;
    bool names_lines_of_sight = false;
    std::size_t vertices = 0;  ///< Of all parts.
    std::size_t faces = 0;
    std::vector<Part> shells;  ///< In the order of the mesh's.
};

/// Reads "CONSTRUCTION CENTRE VERTICES FACES"; the file's counts must hold what they say.
bool read_shell(std::istringstream& words, CameraMesh& mesh, ParsedHeader& header) {
    std::string name;
    Eigen::Vector3d centre;
    Part part;
    if (!(words >> name >> centre.x() >> centre.y() >> centre.z() >> part.vertices >> part.faces)) {
        return false;
    }
    const auto construction = mesh_construction_named(name);
    if (!construction) return false;
    CameraMesh& shell = mesh.shells.emplace_back();
    shell.construction = *construction;
    shell.scene_centre_in_world = centre;
    header.shells.push_back(part);
    return true;
}

/// What is left for the mesh itself; empty when the shells are said to have more than there is.
std::optional<Part> base_part(const ParsedHeader& header) {
    Part base{header.vertices, header.faces};
    for (const Part& shell : header.shells) {
        if (shell.vertices > base.vertices || shell.faces > base.faces) return std::nullopt;
        base.vertices -= shell.vertices;
        base.faces -= shell.faces;
    }
    return base;
}

ParsedHeader parse_header(const std::vector<std::string>& lines, CameraMesh& mesh,
                          const std::filesystem::path& path) {
    ParsedHeader header;
    std::string layout;
    for (const std::string& line : lines) {
        std::istringstream words(line);
        std::string first;
        std::string second;
        words >> first >> second;
        bool read = true;
        if (first == "comment" && second == "construction") {
            std::string name;
            words >> name;
            // Walks forward had a name of their own, and no lines of sight.
            if (name == "forward") name = name_of(MeshConstruction::kNearest);
            const auto construction = mesh_construction_named(name);
            if (!construction) refuse(path, "unknown construction '" + name + "'");
            mesh.construction = *construction;
        } else if (first == "comment" && second == "scene_centre") {
            Eigen::Vector3d& centre = mesh.scene_centre_in_world;
            read = static_cast<bool>(words >> centre.x() >> centre.y() >> centre.z());
        } else if (first == "comment" && second == "shell") {
            read = read_shell(words, mesh, header);
        } else if (first == "element" && second == "vertex") {
            read = static_cast<bool>(words >> header.vertices);
        } else if (first == "element" && second == "face") {
            read = static_cast<bool>(words >> header.faces);
        } else if (first != "comment") {
            layout += line + "\n";
        }
        if (!read) refuse(path, "cannot read '" + line + "'");
    }
    const std::string begin = std::string("ply\nformat binary_little_endian 1.0\n") + kVertexLayout;
    const std::string end = "property list uchar int vertex_indices\nend_header\n";
    header.names_lines_of_sight = layout == begin + kVirtualLayout + kSightLayout + end;
    header.names_virtual_vertices =
        header.names_lines_of_sight || layout == begin + kVirtualLayout + end;
    if (!header.names_virtual_vertices && layout != begin + end) {
        refuse(path, "expected vertices x y z view virtual and triangular faces");
    }
    return header;
}

void take_vertices(const Bytes& bytes, std::size_t& offset, std::size_t count,
                   const ParsedHeader& header, CameraMesh& mesh,
                   const std::filesystem::path& path) {
    for (std::size_t i = 0; i < count; ++i) {
        CameraMesh::Vertex vertex;
        vertex.position_in_world = take_vector(bytes, offset);
        vertex.view_index = take<std::int32_t>(bytes, offset);
        if (header.names_virtual_vertices) {
            const auto is_virtual = take<std::uint8_t>(bytes, offset);
            if (is_virtual > 1) refuse(path, "a vertex is neither virtual nor not");
            vertex.is_virtual = is_virtual == 1;
        }
        if (header.names_lines_of_sight) vertex.line_of_sight_in_world = take_vector(bytes, offset);
        if (!vertex.position_in_world.allFinite() || !vertex.line_of_sight_in_world.allFinite())
            refuse(path, "a vertex is not finite");
        if (vertex.view_index < 0) refuse(path, "a vertex names a negative view");
        mesh.vertices.push_back(vertex);
    }
}

/// Indices count from the first vertex of all; those of a part begin at `first_vertex`.
void take_faces(const Bytes& bytes, std::size_t& offset, std::size_t count,
                std::size_t first_vertex, CameraMesh& mesh, const std::filesystem::path& path) {
    const auto first = static_cast<std::int64_t>(first_vertex);
    const auto vertices = static_cast<std::int64_t>(mesh.vertices.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (take<std::uint8_t>(bytes, offset) != 3) refuse(path, "a face is not a triangle");
        CameraMesh::Face face{};
        for (int& index : face) {
            const std::int64_t own = std::int64_t{take<std::int32_t>(bytes, offset)} - first;
            if (own < 0 || own >= vertices) {
                refuse(path, "a face names a vertex that does not exist");
            }
            index = static_cast<int>(own);
        }
        mesh.faces.push_back(face);
    }
}

}  // namespace

Bytes camera_mesh_ply(const CameraMesh& mesh) {
    Bytes bytes = header_bytes(camera_mesh_header(mesh));
    const bool with_lines_of_sight = names_lines_of_sight(mesh);
    put_vertices(bytes, mesh, with_lines_of_sight);
    for (const CameraMesh& shell : mesh.shells) put_vertices(bytes, shell, with_lines_of_sight);
    put_faces(bytes, mesh, 0);
    std::size_t first_vertex = mesh.vertices.size();
    for (const CameraMesh& shell : mesh.shells) {
        put_faces(bytes, shell, first_vertex);
        first_vertex += shell.vertices.size();
    }
    return bytes;
}

void write_camera_mesh_ply(const std::filesystem::path& path, const CameraMesh& mesh) {
    write_whole_file(path, camera_mesh_ply(mesh));
}

CameraMesh read_camera_mesh_ply(const std::filesystem::path& path) {
    return parse_camera_mesh_ply(read_whole_file(path), path);
}

CameraMesh parse_camera_mesh_ply(const Bytes& bytes, const std::filesystem::path& path) {
    CameraMesh mesh;
    std::size_t offset = 0;
    const ParsedHeader header = parse_header(header_lines(bytes, offset, path), mesh, path);
    const std::size_t body = bytes.size() - offset;
    const std::size_t vertex_bytes = kPlaceBytes + (header.names_virtual_vertices ? 1 : 0) +
                                     (header.names_lines_of_sight ? 3 * sizeof(double) : 0);
    const bool fits = header.vertices <= body / vertex_bytes && header.faces <= body / kFaceBytes &&
                      header.vertices * vertex_bytes + header.faces * kFaceBytes == body;
    if (!fits) refuse(path, "the file's size does not match its counts");
    const std::optional<Part> base = base_part(header);
    if (!base) refuse(path, "its shells have more vertices or faces than there are");
    const auto vertices_of = [&](std::size_t count, CameraMesh& part) {
        take_vertices(bytes, offset, count, header, part, path);
    };
    vertices_of(base->vertices, mesh);
    for (std::size_t i = 0; i < mesh.shells.size(); ++i) {
        vertices_of(header.shells[i].vertices, mesh.shells[i]);
    }
    take_faces(bytes, offset, base->faces, 0, mesh, path);
    std::size_t first_vertex = base->vertices;
    for (std::size_t i = 0; i < mesh.shells.size(); ++i) {
        take_faces(bytes, offset, header.shells[i].faces, first_vertex, mesh.shells[i], path);
        first_vertex += header.shells[i].vertices;
    }
    return mesh;
}

}  // namespace lumi
