#include "render/lumigraph/coded_depth_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "calib/work/error.h"

namespace lumi {
namespace {

constexpr int kUnitsPerSample = 4;
constexpr double kStepsPerPixel = 64.0;
constexpr double kMostSteps = 65535.0;

/// Column and row in quarters of a sample, and step of inverse depth.
using CodedVertex = std::array<std::int32_t, 3>;

[[noreturn]] void refuse_mesh(const std::string& where, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-PACKAGE-MESH", where + ": " + what,
                "the package is damaged: copy it again, or build it again with `lumi build`");
}

/// Turns vertices into whole numbers and back.
class VertexScale {
 public:
    VertexScale(const CodedDepthMeshHeader& header, const Camera& camera)
        : unit_x_px_(static_cast<double>(camera.width_px) / (kUnitsPerSample * header.columns)),
          unit_y_px_(static_cast<double>(camera.height_px) / (kUnitsPerSample * header.rows)),
          least_(header.min_inverse_depth),
          range_(header.max_inverse_depth - header.min_inverse_depth),
          steps_(std::clamp(std::ceil(kStepsPerPixel * header.disparity_px * range_), 1.0,
                            kMostSteps)) {}

    [[nodiscard]] int steps() const { return static_cast<int>(steps_); }

    [[nodiscard]] CodedVertex coded(const Eigen::Vector3f& vertex) const {
        const Eigen::Vector3d v = vertex.cast<double>();
        const double step = range_ > 0 ? (v.z() - least_) / range_ * steps_ : 0.0;
        return {static_cast<std::int32_t>(std::lround(v.x() / unit_x_px_)),
                static_cast<std::int32_t>(std::lround(v.y() / unit_y_px_)),
                static_cast<std::int32_t>(std::lround(step))};
    }
    [[nodiscard]] Eigen::Vector3f decoded(const CodedVertex& vertex) const {
        return {static_cast<float>(vertex[0] * unit_x_px_),
                static_cast<float>(vertex[1] * unit_y_px_),
                static_cast<float>(std::lerp(least_, least_ + range_, vertex[2] / steps_))};
    }

 private:
    double unit_x_px_;
    double unit_y_px_;
    double least_;
    double range_;
    double steps_;
};

void append_number(std::uint32_t value, std::vector<std::uint8_t>& bytes) {
    for (; value >= 0x80U; value >>= 7U) bytes.push_back(static_cast<std::uint8_t>(value | 0x80U));
    bytes.push_back(static_cast<std::uint8_t>(value));
}

std::uint32_t zigzag(std::int32_t value) {
    const auto doubled = static_cast<std::uint32_t>(value) << 1U;
    return value < 0 ? ~doubled : doubled;
}

std::int32_t from_zigzag(std::uint32_t value) {
    const auto half = static_cast<std::int32_t>(value >> 1U);
    return (value & 1U) != 0 ? -half - 1 : half;
}

/// Numbers one after the other.
class NumberReader {
 public:
    NumberReader(const std::vector<std::uint8_t>& bytes, const std::string& where)
        : bytes_(bytes), where_(where) {}

    std::uint32_t next() {
        std::uint32_t value = 0;
        for (unsigned shift = 0; shift < 32; shift += 7) {
            if (at_ >= bytes_.size()) refuse_mesh(where_, "ends within a triangle");
            const std::uint32_t byte = bytes_[at_++];
            if (shift == 28 && byte > 0x0fU) break;
            value |= (byte & 0x7fU) << shift;
            if (byte < 0x80U) return value;
        }
        refuse_mesh(where_, "holds a number of more than 32 bits");
    }
    [[nodiscard]] bool is_at_end() const { return at_ == bytes_.size(); }

 private:
    const std::vector<std::uint8_t>& bytes_;
    const std::string& where_;
    std::size_t at_ = 0;
};

CodedDepthMeshHeader header_of(const DepthMesh& mesh) {
    CodedDepthMeshHeader header{mesh.columns, mesh.rows, mesh.wanted_error_px, mesh.error_px,
                                mesh.disparity_px};
    if (!mesh.indices.empty()) {
        float least = mesh.vertices[mesh.indices.front()].z();
        float most = least;
        for (const std::uint32_t index : mesh.indices) {
            least = std::min(least, mesh.vertices[index].z());
            most = std::max(most, mesh.vertices[index].z());
        }
        header.min_inverse_depth = static_cast<double>(least);
        header.max_inverse_depth = static_cast<double>(most);
    }
    for (std::size_t kind = 0; kind < header.triangles.size(); ++kind)
        header.triangles[kind] =
            static_cast<int>((mesh.kind_begin[kind + 1] - mesh.kind_begin[kind]) / 3);
    return header;
}

/// Reads the vertices that corners name for the first time.
class VertexReader {
 public:
    VertexReader(const CodedDepthMeshHeader& header, const Camera& camera, const std::string& where)
        : scale_(header, camera),
          end_{kUnitsPerSample * header.columns, kUnitsPerSample * header.rows, scale_.steps()},
          count_(static_cast<std::size_t>(header.vertices)),
          where_(where) {}

    void read(NumberReader& numbers, std::vector<Eigen::Vector3f>& vertices) {
        if (vertices.size() == count_) refuse_mesh(where_, "holds more vertices than it states");
        for (std::size_t axis = 0; axis < last_.size(); ++axis) {
            const std::int64_t value = std::int64_t{last_[axis]} + from_zigzag(numbers.next());
            if (value < 0 || value > end_[axis])
                refuse_mesh(where_, "holds a vertex beyond the photograph or the range of depth");
            last_[axis] = static_cast<std::int32_t>(value);
        }
        vertices.push_back(scale_.decoded(last_));
    }

 private:
    VertexScale scale_;
    CodedVertex last_{};
    CodedVertex end_;
    std::size_t count_;
    const std::string& where_;
};

}  // namespace

CodedDepthMesh encode(const DepthMesh& mesh, const Camera& camera) {
    constexpr std::uint32_t kUnnamed = 0xffffffffU;
    CodedDepthMesh coded{header_of(mesh), {}};
    const VertexScale scale(coded.header, camera);
    std::vector<std::uint32_t> name_of(mesh.vertices.size(), kUnnamed);
    std::uint32_t named = 0;
    CodedVertex last{};
    for (const std::uint32_t index : mesh.indices) {
        if (name_of[index] != kUnnamed) {
            append_number(named - name_of[index], coded.bytes);
            continue;
        }
        name_of[index] = named++;
        append_number(0, coded.bytes);
        const CodedVertex vertex = scale.coded(mesh.vertices[index]);
        for (std::size_t axis = 0; axis < vertex.size(); ++axis)
            append_number(zigzag(vertex[axis] - last[axis]), coded.bytes);
        last = vertex;
    }
    coded.header.vertices = static_cast<int>(named);
    return coded;
}

DepthMesh decode(const CodedDepthMesh& coded, const Camera& camera, const std::string& where) {
    const CodedDepthMeshHeader& header = coded.header;
    DepthMesh mesh;
    mesh.columns = header.columns;
    mesh.rows = header.rows;
    mesh.wanted_error_px = header.wanted_error_px;
    mesh.error_px = header.error_px;
    mesh.disparity_px = header.disparity_px;
    for (std::size_t kind = 0; kind < header.triangles.size(); ++kind)
        mesh.kind_begin[kind + 1] =
            mesh.kind_begin[kind] + 3 * static_cast<std::size_t>(header.triangles[kind]);
    const std::size_t corners = mesh.kind_begin.back();
    // What is announced must fit into the bytes before memory is taken for it: a byte a corner, and
    // three more a vertex.
    if (corners + 3 * static_cast<std::size_t>(header.vertices) > coded.bytes.size())
        refuse_mesh(where, "is too short for the triangles that it states");
    mesh.vertices.reserve(static_cast<std::size_t>(header.vertices));
    mesh.indices.reserve(corners);
    NumberReader numbers(coded.bytes, where);
    VertexReader vertices(header, camera, where);
    while (mesh.indices.size() < corners) {
        const std::uint32_t ago = numbers.next();
        if (ago > mesh.vertices.size()) refuse_mesh(where, "names a vertex before it is there");
        if (ago == 0) vertices.read(numbers, mesh.vertices);
        mesh.indices.push_back(
            static_cast<std::uint32_t>(mesh.vertices.size() - (ago == 0 ? 1 : ago)));
    }
    if (!numbers.is_at_end() || mesh.vertices.size() != static_cast<std::size_t>(header.vertices))
        refuse_mesh(where, "does not end with the triangles that it states");
    return mesh;
}

}  // namespace lumi
