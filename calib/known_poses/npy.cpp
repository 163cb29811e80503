#include "calib/known_poses/npy.h"

#include <bit>
#include <charconv>
#include <cstring>
#include <string_view>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

static_assert(std::endian::native == std::endian::little, "values are copied as they stand");

[[noreturn]] void refuse_npy(const std::filesystem::path& path, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-IMPORT-NPY", path.string() + ": " + what,
                "save it with numpy.save as a two-dimensional array of float64");
}

struct Header {
    std::string_view dictionary;
    std::size_t data_offset = 0;
};

Header read_header(const Bytes& bytes, const std::filesystem::path& path) {
    constexpr std::string_view kMagic = "\x93NUMPY";
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!text.starts_with(kMagic) || bytes.size() < 12) refuse_npy(path, "not a NumPy array");
    // Version 1 has two bytes of length, the later ones four.
    const std::size_t length_bytes = bytes[6] == 1 ? 2 : 4;
    std::size_t length = 0;
    for (std::size_t i = length_bytes; i > 0; --i) length = length << 8 | bytes[8 + i - 1];
    const std::size_t begin = 8 + length_bytes;
    if (length > bytes.size() - begin) refuse_npy(path, "ends within its header");
    return {text.substr(begin, length), begin + length};
}

/// What stands after `'key':` in the header's dictionary.
std::string_view value_after(std::string_view dictionary, std::string_view key,
                             const std::filesystem::path& path) {
    const std::size_t found = dictionary.find("'" + std::string(key) + "'");
    const std::size_t colon = dictionary.find(':', found);
    if (found == std::string_view::npos || colon == std::string_view::npos) {
        refuse_npy(path, "its header has no '" + std::string(key) + "'");
    }
    const std::string_view rest = dictionary.substr(colon + 1);
    return rest.substr(std::min(rest.find_first_not_of(' '), rest.size()));
}

std::vector<std::size_t> shape_of(std::string_view text, const std::filesystem::path& path) {
    std::vector<std::size_t> shape;
    text = text.substr(0, text.find(')'));
    while (true) {
        text.remove_prefix(std::min(text.find_first_of("0123456789"), text.size()));
        if (text.empty()) return shape;
        std::size_t size = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
        if (error != std::errc{}) refuse_npy(path, "its shape is absurd");
        shape.push_back(size);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
}

template <class Value>
std::vector<double> values_of(const Bytes& bytes, std::size_t offset, std::size_t count) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        Value value;
        std::memcpy(&value, &bytes[offset + i * sizeof(Value)], sizeof(Value));
        values[i] = static_cast<double>(value);
    }
    return values;
}

}  // namespace

NpyMatrix read_npy_matrix(const std::filesystem::path& path) {
    const Bytes bytes = read_whole_file(path, std::size_t{256} << 20);
    const auto [dictionary, offset] = read_header(bytes, path);
    const std::string_view type = value_after(dictionary, "descr", path);
    const bool is_double = type.starts_with("'<f8'");
    if (!is_double && !type.starts_with("'<f4'")) refuse_npy(path, "expected float64 or float32");
    if (!value_after(dictionary, "fortran_order", path).starts_with("False")) {
        refuse_npy(path, "expected C order");
    }
    const std::vector<std::size_t> shape = shape_of(value_after(dictionary, "shape", path), path);
    if (shape.size() != 2) refuse_npy(path, "expected two dimensions");
    std::size_t count = 0;
    std::size_t data_bytes = 0;
    const std::size_t value_bytes = is_double ? 8 : 4;
    if (__builtin_mul_overflow(shape[0], shape[1], &count) ||
        __builtin_mul_overflow(count, value_bytes, &data_bytes) ||
        data_bytes != bytes.size() - offset) {
        refuse_npy(path, "its size is not that of its shape");
    }
    return {shape[0], shape[1],
            is_double ? values_of<double>(bytes, offset, count)
                      : values_of<float>(bytes, offset, count)};
}

}  // namespace lumi
