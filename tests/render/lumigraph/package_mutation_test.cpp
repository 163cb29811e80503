#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "calib/work/whole_file.h"
#include "render/lumigraph/manifest.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

struct PackageBytes {
    fs::path path;
    Bytes bytes;
};

std::vector<PackageBytes> files_of(const fs::path& package) {
    std::vector<PackageBytes> files;
    for (const auto& entry : fs::recursive_directory_iterator(package)) {
        if (entry.is_regular_file()) {
            files.push_back({entry.path(), read_whole_file(entry.path())});
        }
    }
    std::sort(files.begin(), files.end(),
              [](const PackageBytes& a, const PackageBytes& b) { return a.path < b.path; });
    return files;
}

void overwrite_byte(const fs::path& path, std::size_t offset, std::uint8_t byte) {
    std::fstream stream(path, std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(static_cast<std::streamoff>(offset));
    stream.put(static_cast<char>(byte));
}

TEST(PackageMutation, EverySingleByteChangeIsNoticed) {
    const ScratchFolder scratch;
    const fs::path package = scratch / "tiny.lumi";
    write_package(package, tiny_lumigraph(), tiny_extras());
    const std::vector<PackageBytes> files = files_of(package);
    ASSERT_EQ(files.size(), 12U);

    std::mt19937 random(7);
    std::vector<int> mutations_of_file(files.size(), 0);
    for (int mutation = 0; mutation < 2000; ++mutation) {
        const std::size_t file = random() % files.size();
        const std::size_t offset = random() % files[file].bytes.size();
        const std::uint8_t byte = files[file].bytes[offset];
        const auto changed = static_cast<std::uint8_t>(byte ^ (1 + random() % 255));
        overwrite_byte(files[file].path, offset, changed);
        EXPECT_TRUE(code_of_reading(package).starts_with("E-PACKAGE-"))
            << files[file].path.filename() << " offset " << offset << " byte " << +changed;
        overwrite_byte(files[file].path, offset, byte);
        ++mutations_of_file[file];
    }
    EXPECT_GT(*std::min_element(mutations_of_file.begin(), mutations_of_file.end()), 100);
    EXPECT_EQ(code_of_reading(package), "");
}

/// A forger's mutations pass the checksums: what they reach must still be refused or be sound.
TEST(PackageMutation, ForgedPicturesAndMeshesNeverCrashTheReader) {
    const ScratchFolder scratch;
    const fs::path package = scratch / "tiny.lumi";
    write_package(package, tiny_lumigraph(), tiny_extras());
    const std::map<std::string, std::string> path_of{
        {"/views/0/photograph", "views/000001.png"},
        {"/views/1/depth/inverse_depth", "depth/000002.png"},
        {"/views/1/depth/confidence", "depth/000002_confidence.png"},
        {"/views/0/depth/mesh/file", "depth/000001.mesh"},
        {"/camera_mesh", "camera_mesh.ply"}};
    std::mt19937 random(8);
    for (const auto& [listing, path] : path_of) {
        const std::string original = read_whole_text(package / path);
        int refused = 0;
        for (int mutation = 0; mutation < 200; ++mutation) {
            std::string bytes = original;
            bytes[random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
            forge_file(package, listing, bytes);
            const std::string code = code_of_reading(package);
            EXPECT_TRUE(code.empty() || code.starts_with("E-PACKAGE-")) << code;
            refused += code.empty() ? 0 : 1;
        }
        EXPECT_GT(refused, 20) << path;
        forge_file(package, listing, original);
        EXPECT_EQ(code_of_reading(package), "");
    }
}

/// All numbers of a manifest, as JSON pointers.
std::vector<std::string> numbers_of(const fs::path& package) {
    const auto flat = nlohmann::json::parse(read_whole_text(package / kManifestName)).flatten();
    std::vector<std::string> pointers;
    for (const auto& [pointer, value] : flat.items())
        if (value.is_number()) pointers.push_back(pointer);
    return pointers;
}

TEST(PackageMutation, ExtremeNumbersAreRefusedOrRead) {
    const ScratchFolder scratch;
    const fs::path package = scratch / "tiny.lumi";
    Lumigraph lumigraph = tiny_lumigraph();
    for (LumigraphView& view : lumigraph.views) view.exposure_gain = {2, 0.5, 1};
    write_package(package, lumigraph, tiny_extras());
    const std::string original = read_whole_text(package / kManifestName);
    int refused = 0;
    int read = 0;
    for (const std::string& pointer : numbers_of(package)) {
        for (const double number : {0.0, 1e-300, 1e-30, 1e-3, 1e3, 1e30, 1e300, -1e300}) {
            forge_manifest(package, [&](nlohmann::ordered_json& json) {
                json[nlohmann::ordered_json::json_pointer(pointer)] = number;
            });
            const std::string code = code_of_reading(package);
            EXPECT_TRUE(code.empty() || code.starts_with("E-PACKAGE-"))
                << pointer << " = " << number << ": " << code;
            ++(code.empty() ? read : refused);
            put_file(package / kManifestName, original);
        }
    }
    EXPECT_GT(refused, 100);
    EXPECT_GT(read, 20);
}

TEST(PackageMutation, OnlyCamerasThatAreNoneAreRefusedForTheirNumbers) {
    const ScratchFolder scratch;
    const fs::path package = scratch / "tiny.lumi";
    Lumigraph lumigraph = tiny_lumigraph();
    for (LumigraphView& view : lumigraph.views) view.exposure_gain = {2, 2, 2};
    write_package(package, lumigraph, tiny_extras());
    const auto code_with = [&](const std::vector<double>& parameters) {
        forge_manifest(package, [&](nlohmann::ordered_json& json) {
            json["views"][0]["camera"]["parameters"] = parameters;
        });
        return code_of_reading(package);
    };
    // A fisheye of 175 degrees, and a hundred pixels cut from the picture of a telescope.
    EXPECT_EQ(code_with({0.28, 0.28, 6.5, 3.5}), "");
    EXPECT_EQ(code_with({2e5, 2e5, -700, 900}), "");
    for (const double focal_px : {1e-3, 1e-300, 1e9, 1e300})
        EXPECT_EQ(code_with({focal_px, focal_px, 6.5, 3.5}), "E-PACKAGE-CONTENT") << focal_px;
    for (const double centre_px : {1e7, -1e7, 1e30, -1e300})
        EXPECT_EQ(code_with({10, 10, 6.5, centre_px}), "E-PACKAGE-CONTENT") << centre_px;
}

}  // namespace
}  // namespace lumi
