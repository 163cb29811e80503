#include "meshing/geometry/volume_header.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <string>

#include "calib/work/error.h"
#include "calib/work/without_plus.h"
#include "meshing/surface/file_ending.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

std::string trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1));
}

std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Fields of a header by name, as they stand there.
class Fields {
 public:
    explicit Fields(const fs::path& path) : path_(path) {}

    void add(const std::string& name, const std::string& value) { values_[name] = value; }
    [[nodiscard]] bool has(const std::string& name) const { return values_.count(name) > 0; }
    [[nodiscard]] std::string text(const std::string& name) const {
        const auto found = values_.find(name);
        if (found == values_.end()) refuse_volume(path_, "its header has no \"" + name + '"');
        return found->second;
    }
    /// All numbers of a field, whatever stands between them.
    [[nodiscard]] std::vector<double> numbers(const std::string& name, std::size_t count) const {
        std::string value = text(name);
        std::replace_if(
            value.begin(), value.end(), [](char c) { return c == '(' || c == ')' || c == ','; },
            ' ');
        std::vector<double> numbers;
        const char* at = value.data();
        const char* const end = at + value.size();
        while (at != end) {
            if (*at == ' ' || *at == '\t') {
                ++at;
                continue;
            }
            double number = 0;
            const char* const first = without_plus({at, static_cast<std::size_t>(end - at)}).data();
            const auto [rest, error] = std::from_chars(first, end, number);
            if (error != std::errc{} || !std::isfinite(number)) break;
            numbers.push_back(number);
            at = rest;
        }
        if (at != end || numbers.size() != count) {
            refuse_volume(path_, '"' + name + "\": expected " + std::to_string(count) +
                                     " numbers, found \"" + text(name) + '"');
        }
        return numbers;
    }
    [[nodiscard]] Eigen::Vector3d vector(const std::string& name) const {
        return Eigen::Vector3d(numbers(name, 3).data());
    }
    void expect_if_there(const std::string& name, const std::string& value) const {
        if (has(name) && lower_case(text(name)) != value) {
            refuse_volume(path_, '"' + name + "\": expected " + value + ", found " + text(name));
        }
    }

 private:
    const fs::path& path_;
    std::map<std::string, std::string> values_;
};

Eigen::Vector3i cells_along_axes(const Fields& fields, const std::string& name,
                                 const fs::path& path) {
    constexpr double kMaxCells = 1 << 30;
    const Eigen::Vector3d size = fields.vector(name);
    if ((size.array() < 1).any() || size != size.array().round().matrix() ||
        size.prod() > kMaxCells) {
        refuse_volume(path, '"' + name + "\": expected three counts of cells, 2^30 in all at most");
    }
    return size.cast<int>();
}

CellType type_named(const std::string& name, const fs::path& path) {
    static const std::map<std::string, CellType> types{
        {"signed char", CellType::kInt8},    {"int8", CellType::kInt8},
        {"int8_t", CellType::kInt8},         {"met_char", CellType::kInt8},
        {"unsigned char", CellType::kUint8}, {"uchar", CellType::kUint8},
        {"uint8", CellType::kUint8},         {"uint8_t", CellType::kUint8},
        {"met_uchar", CellType::kUint8},     {"short", CellType::kInt16},
        {"int16", CellType::kInt16},         {"int16_t", CellType::kInt16},
        {"met_short", CellType::kInt16},     {"unsigned short", CellType::kUint16},
        {"ushort", CellType::kUint16},       {"uint16", CellType::kUint16},
        {"uint16_t", CellType::kUint16},     {"met_ushort", CellType::kUint16},
        {"int", CellType::kInt32},           {"int32", CellType::kInt32},
        {"int32_t", CellType::kInt32},       {"met_int", CellType::kInt32},
        {"unsigned int", CellType::kUint32}, {"uint", CellType::kUint32},
        {"uint32", CellType::kUint32},       {"uint32_t", CellType::kUint32},
        {"met_uint", CellType::kUint32},     {"float", CellType::kFloat},
        {"met_float", CellType::kFloat},     {"double", CellType::kDouble},
        {"met_double", CellType::kDouble}};
    const auto found = types.find(lower_case(name));
    if (found == types.end()) refuse_volume(path, "cells of type " + name);
    return found->second;
}

/// Calls `line(text)` for each line until it returns true; returns where the next one begins.
template <class Line>
std::size_t for_each_line(std::string_view text, const fs::path& path, const Line& line) {
    constexpr std::size_t kMaxHeader = 1 << 20;
    std::size_t at = 0;
    while (at < std::min(text.size(), kMaxHeader)) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string found = trimmed(text.substr(at, end - at));
        at = std::min(end + 1, text.size());
        if (line(found)) return at;
    }
    refuse_volume(path, "its header does not end");
}

/// Of a NRRD's "endian".
bool is_big(const std::string& endian, const fs::path& path) {
    const std::string order = lower_case(endian);
    if (order != "big" && order != "little") {
        refuse_volume(path, "\"endian\": expected big or little, found " + endian);
    }
    return order == "big";
}

/// Which axes have their samples on nodes, by a NRRD's "centers": the others have them in cells,
/// as the format's library takes samples that nothing is said of.
std::array<bool, 3> axes_of_nodes(const Fields& fields) {
    std::array<bool, 3> are_nodes{};
    for (const char* name : {"centers", "centerings"}) {
        if (!fields.has(name)) continue;
        const std::string centers = lower_case(fields.text(name));
        std::size_t at = 0;
        for (bool& is_node : are_nodes) {
            at = std::min(centers.find_first_not_of(" \t", at), centers.size());
            is_node = centers.substr(at).starts_with("node");
            at = std::min(centers.find_first_of(" \t", at), centers.size());
        }
    }
    return are_nodes;
}

/// Of a NRRD whose axes are those of the world: "axis mins" and "axis maxs" are the outer borders
/// of cells, but the places of nodes.
void place_along_axes(const Fields& fields, VolumeHeader& header) {
    const std::array<bool, 3> are_nodes = axes_of_nodes(fields);
    const bool has_mins = fields.has("axismins");
    const Eigen::Vector3d mins = has_mins ? fields.vector("axismins") : Eigen::Vector3d::Zero();
    if (fields.has("spacings")) {
        header.steps = fields.vector("spacings").asDiagonal();
    } else if (has_mins && fields.has("axismaxs")) {
        const Eigen::Vector3d extent = fields.vector("axismaxs") - mins;
        for (int axis = 0; axis < 3; ++axis) {
            const int steps =
                header.size[axis] - (are_nodes[static_cast<std::size_t>(axis)] ? 1 : 0);
            header.steps(axis, axis) = extent[axis] / steps;
        }
    }
    if (!has_mins) return;
    header.centre_of_first_cell = mins;
    for (int axis = 0; axis < 3; ++axis) {
        if (!are_nodes[static_cast<std::size_t>(axis)])
            header.centre_of_first_cell[axis] += 0.5 * header.steps(axis, axis);
    }
}

VolumeHeader parse_nrrd(std::string_view text, const fs::path& path) {
    Fields fields(path);
    VolumeHeader header;
    bool is_detached = false;
    const auto take_line = [&](const std::string& line) {
        if (line.empty()) return true;
        const std::size_t colon = line.find(": ");
        if (line.front() != '#' && colon != std::string::npos) {
            std::string name = lower_case(line.substr(0, colon));
            std::erase(name, ' ');
            fields.add(name, trimmed(line.substr(colon + 2)));
            is_detached = is_detached || name == "datafile";
        }
        return false;
    };
    // The header of a file beside its data may end with the file.
    header.header_size =
        for_each_line(std::string(text.substr(0, 1 << 20)) + "\n\n", path, take_line);
    fields.expect_if_there("dimension", "3");
    for (const char* skipped : {"lineskip", "byteskip"}) fields.expect_if_there(skipped, "0");
    header.size = cells_along_axes(fields, "sizes", path);
    header.type = type_named(fields.text("type"), path);
    if (bytes_of(header.type) > 1) header.is_big_endian = is_big(fields.text("endian"), path);
    const std::string encoding = lower_case(fields.text("encoding"));
    header.is_compressed = encoding == "gzip" || encoding == "gz";
    if (!header.is_compressed && encoding != "raw") refuse_volume(path, "encoding " + encoding);
    if (is_detached) header.data_file = fields.text("datafile");
    if (fields.has("spacedirections")) {
        header.steps = Eigen::Matrix3d(fields.numbers("spacedirections", 9).data());
    } else {
        place_along_axes(fields, header);
    }
    if (fields.has("spaceorigin")) header.centre_of_first_cell = fields.vector("spaceorigin");
    return header;
}

VolumeHeader parse_meta_image(std::string_view text, const fs::path& path) {
    Fields fields(path);
    VolumeHeader header;
    header.header_size = for_each_line(text, path, [&](const std::string& line) {
        const std::size_t equals = line.find('=');
        if (equals == std::string::npos) return false;
        const std::string name = lower_case(trimmed(line.substr(0, equals)));
        fields.add(name, trimmed(line.substr(equals + 1)));
        return name == "elementdatafile";  // The last one by definition.
    });
    fields.expect_if_there("ndims", "3");
    fields.expect_if_there("elementnumberofchannels", "1");
    fields.expect_if_there("headersize", "0");
    fields.expect_if_there("binarydata", "true");
    header.size = cells_along_axes(fields, "dimsize", path);
    header.type = type_named(fields.text("elementtype"), path);
    for (const char* order : {"binarydatabyteordermsb", "elementbyteordermsb"}) {
        if (fields.has(order)) header.is_big_endian = lower_case(fields.text(order)) == "true";
    }
    header.is_compressed =
        fields.has("compresseddata") && lower_case(fields.text("compresseddata")) == "true";
    const std::string data = fields.text("elementdatafile");
    if (lower_case(data) != "local") header.data_file = data;
    for (const char* matrix : {"orientation", "rotation", "transformmatrix"}) {
        if (fields.has(matrix)) header.steps = Eigen::Matrix3d(fields.numbers(matrix, 9).data());
    }
    // Cells touch where nothing is said of what lies between their centres.
    const char* const spacing = fields.has("elementspacing") ? "elementspacing" : "elementsize";
    if (fields.has(spacing)) header.steps = header.steps * fields.vector(spacing).asDiagonal();
    for (const char* origin : {"origin", "position", "offset"}) {
        if (fields.has(origin)) header.centre_of_first_cell = fields.vector(origin);
    }
    return header;
}

}  // namespace

std::size_t bytes_of(CellType type) {
    switch (type) {
        case CellType::kInt8:
        case CellType::kUint8:
            return 1;
        case CellType::kInt16:
        case CellType::kUint16:
            return 2;
        case CellType::kInt32:
        case CellType::kUint32:
        case CellType::kFloat:
            return 4;
        case CellType::kDouble:
            break;
    }
    return 8;
}

void refuse_volume(const fs::path& path, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-VOLUME-READ", path.string() + ": " + what,
                "export the volume as NRRD (raw or gzip) or MetaImage, one number a cell");
}

VolumeHeader parse_volume_header(std::string_view text, const fs::path& path) {
    const bool is_nrrd = text.starts_with("NRRD");
    const std::string ending = lower_case_ending(path);
    if (!is_nrrd && ending != ".mhd" && ending != ".mha") {
        refuse_volume(path, "neither a NRRD file nor a MetaImage");
    }
    VolumeHeader header = is_nrrd ? parse_nrrd(text, path) : parse_meta_image(text, path);
    const double cell = std::abs(header.steps.determinant());
    if (!(cell > 0) || !std::isfinite(cell)) {
        refuse_volume(path, "steps between cells that span no space");
    }
    return header;
}

}  // namespace lumi
