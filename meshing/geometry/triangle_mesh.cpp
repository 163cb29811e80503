#include "meshing/geometry/triangle_mesh.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "calib/work/without_plus.h"
#include "meshing/surface/file_ending.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
static_assert(std::endian::native == std::endian::little);

[[noreturn]] void refuse(const fs::path& path, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-GEOMETRY-READ", path.string() + ": " + what,
                "export the mesh as PLY or OBJ with plain triangles");
}

/// Words of a text, line by line.
class Words {
 public:
    explicit Words(std::string_view line) : rest_(line) {}
    [[nodiscard]] std::string_view next() {
        const std::size_t begin = rest_.find_first_not_of(" \t\r");
        if (begin == std::string_view::npos) return rest_ = {};
        const std::size_t end = std::min(rest_.find_first_of(" \t\r", begin), rest_.size());
        const std::string_view word = rest_.substr(begin, end - begin);
        rest_.remove_prefix(end);
        return word;
    }

 private:
    std::string_view rest_;
};

template <class Number>
std::optional<Number> parsed(std::string_view word) {
    word = without_plus(word);
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
}

class Lines {
 public:
    explicit Lines(std::string_view text) : text_(text) {}
    [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
    [[nodiscard]] std::string_view next() {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        const std::string_view line = text_.substr(at_, end - at_);
        at_ = end + 1;
        ++number_;
        return line;
    }
    [[nodiscard]] std::size_t position() const { return std::min(at_, text_.size()); }
    [[nodiscard]] std::string number() const { return std::to_string(number_); }

 private:
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t number_ = 0;
};

void add_fan(const std::vector<std::uint32_t>& polygon, TriangleMesh& mesh) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        mesh.faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
    }
}

TriangleMesh parse_obj(std::string_view text, const fs::path& path) {
    TriangleMesh mesh;
    std::vector<std::uint32_t> polygon;
    for (Lines lines(without_byte_order_mark(text)); !lines.at_end();) {
        const std::string_view line = lines.next();
        Words words(line.substr(0, line.find('#')));  // The rest is a comment.
        const std::string_view kind = words.next();
        if (kind == "v") {
            Eigen::Vector3d vertex;
            for (int axis = 0; axis < 3; ++axis) {
                const auto value = parsed<double>(words.next());
                if (!value) refuse(path, "line " + lines.number() + ": expected three numbers");
                vertex[axis] = *value;
            }
            mesh.vertices.push_back(vertex);
        } else if (kind == "f") {
            polygon.clear();
            for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
                const auto index = parsed<std::int64_t>(word.substr(0, word.find('/')));
                if (!index || *index == 0) {
                    refuse(path, "line " + lines.number() + ": expected indices of vertices");
                }
                // Negative indices count from the last vertex so far.
                const auto count = static_cast<std::int64_t>(mesh.vertices.size());
                const std::int64_t from_zero = *index > 0 ? *index - 1 : count + *index;
                if (from_zero < 0 || from_zero > std::int64_t{UINT32_MAX}) {
                    refuse(path, "line " + lines.number() + ": an index out of range");
                }
                polygon.push_back(static_cast<std::uint32_t>(from_zero));
            }
            add_fan(polygon, mesh);
        }
    }
    return mesh;
}

enum class PlyFormat { kText, kLittleEndian, kBigEndian };

struct PlyProperty {
    std::string name;
    std::string type;
    std::string count_type;  ///< Of a list; empty otherwise.
};
struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};
struct PlyHeader {
    PlyFormat format = PlyFormat::kText;
    std::vector<PlyElement> elements;
    std::size_t size = 0;
};

PlyHeader parse_ply_header(std::string_view text, const fs::path& path) {
    PlyHeader header;
    Lines lines(text);
    (void)lines.next();
    while (!lines.at_end()) {
        Words words(lines.next());
        const std::string_view keyword = words.next();
        if (keyword == "end_header") {
            header.size = lines.position();
            return header;
        }
        if (keyword == "format") {
            const std::string_view format = words.next();
            header.format = format == "binary_little_endian" ? PlyFormat::kLittleEndian
                            : format == "binary_big_endian"  ? PlyFormat::kBigEndian
                                                             : PlyFormat::kText;
            if (header.format == PlyFormat::kText && format != "ascii") break;
        } else if (keyword == "element") {
            const std::string name(words.next());
            const auto count = parsed<std::uint64_t>(words.next());
            // An element takes at least one byte.
            if (!count || *count > text.size()) refuse(path, "element " + name + ": a wrong count");
            header.elements.push_back({name, *count, {}});
        } else if (keyword == "property") {
            if (header.elements.empty()) break;
            PlyProperty property;
            property.type = words.next();
            if (property.type == "list") {
                property.count_type = words.next();
                property.type = words.next();
            }
            property.name = words.next();
            header.elements.back().properties.push_back(std::move(property));
        }
    }
    refuse(path, "line " + lines.number() + " of its header is not that of a PLY file");
}

/// Reads one number after the other from the body of a PLY file.
class PlyBody {
 public:
    PlyBody(std::string_view body, PlyFormat format, const fs::path& path)
        : body_(body), format_(format), path_(path) {}

    [[nodiscard]] double next(const std::string& type) {
        if (format_ == PlyFormat::kText) return next_word();
        if (type == "float" || type == "float32") return static_cast<double>(raw<float>());
        if (type == "double" || type == "float64") return raw<double>();
        if (type == "uchar" || type == "uint8") return raw<std::uint8_t>();
        if (type == "char" || type == "int8") return raw<std::int8_t>();
        if (type == "ushort" || type == "uint16") return raw<std::uint16_t>();
        if (type == "short" || type == "int16") return raw<std::int16_t>();
        if (type == "uint" || type == "uint32") return raw<std::uint32_t>();
        if (type == "int" || type == "int32") return raw<std::int32_t>();
        refuse(path_, "a property of unknown type " + type);
    }

 private:
    double next_word() {
        at_ = std::min(body_.find_first_not_of(" \t\r\n", at_), body_.size());
        const std::size_t end = std::min(body_.find_first_of(" \t\r\n", at_), body_.size());
        const auto value = parsed<double>(body_.substr(at_, end - at_));
        if (!value) refuse(path_, "expected a number at byte " + std::to_string(at_));
        at_ = end;
        return *value;
    }
    template <class Number>
    Number raw() {
        if (body_.size() - at_ < sizeof(Number)) refuse(path_, "the file ends early");
        std::array<char, sizeof(Number)> bytes;
        std::memcpy(bytes.data(), body_.data() + at_, bytes.size());
        at_ += bytes.size();
        if (format_ == PlyFormat::kBigEndian) std::reverse(bytes.begin(), bytes.end());
        return std::bit_cast<Number>(bytes);
    }

    std::string_view body_;
    std::size_t at_ = 0;
    PlyFormat format_;
    const fs::path& path_;
};

void read_element(const PlyElement& element, PlyBody& body, const fs::path& path,
                  TriangleMesh& mesh) {
    constexpr double kMaxCorners = 1 << 16;
    std::vector<std::uint32_t> polygon;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        Eigen::Vector3d vertex = Eigen::Vector3d::Zero();
        for (const PlyProperty& property : element.properties) {
            if (property.count_type.empty()) {
                const double value = body.next(property.type);
                if (property.name == "x") vertex.x() = value;
                if (property.name == "y") vertex.y() = value;
                if (property.name == "z") vertex.z() = value;
                continue;
            }
            const double count = body.next(property.count_type);
            if (!(count >= 0 && count <= kMaxCorners)) refuse(path, "a list of a wrong length");
            polygon.clear();
            for (int k = 0; k < static_cast<int>(count); ++k) {
                const double index = body.next(property.type);
                const bool is_index = index >= 0 && index <= UINT32_MAX;
                polygon.push_back(is_index ? static_cast<std::uint32_t>(index) : UINT32_MAX);
            }
            const bool is_faces =
                property.name == "vertex_indices" || property.name == "vertex_index";
            if (element.name == "face" && is_faces) add_fan(polygon, mesh);
        }
        if (element.name == "vertex") mesh.vertices.push_back(vertex);
    }
}

TriangleMesh parse_ply(std::string_view text, const fs::path& path) {
    const PlyHeader header = parse_ply_header(text, path);
    PlyBody body(text.substr(header.size), header.format, path);
    TriangleMesh mesh;
    for (const PlyElement& element : header.elements) {
        // An element without properties takes no bytes, however many there are.
        if (!element.properties.empty()) read_element(element, body, path, mesh);
    }
    return mesh;
}

void check(const TriangleMesh& mesh, const fs::path& path) {
    // Products of a few such places are finite as well.
    constexpr double kFarthest = std::numeric_limits<float>::max();
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
        if (!(vertex.array().abs() <= kFarthest).all()) {
            refuse(path, "a vertex that is not finite, or farther away than 3e38");
        }
    }
    for (const auto& face : mesh.faces) {
        for (const std::uint32_t index : face) {
            if (index >= mesh.vertices.size()) {
                refuse(path, "a face that names vertex " + std::to_string(index) + " of " +
                                 std::to_string(mesh.vertices.size()));
            }
        }
    }
    if (!mesh.faces.empty()) return;
    throw Error(ErrorKind::kBadInput, "E-GEOMETRY-EMPTY", path.string() + ": no triangle in it",
                "export a surface, not points alone");
}

}  // namespace

TriangleMesh read_triangle_mesh(const fs::path& path) {
    const Bytes bytes = read_whole_file(path);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const bool is_ply = text.starts_with("ply\n") || text.starts_with("ply\r");
    const bool is_obj = lower_case_ending(path) == ".obj";
    if (!is_ply && !is_obj) refuse(path, "neither a PLY nor an OBJ file");
    TriangleMesh mesh = is_ply ? parse_ply(text, path) : parse_obj(text, path);
    check(mesh, path);
    return mesh;
}

}  // namespace lumi
