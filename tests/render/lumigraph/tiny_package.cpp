#include "tests/render/lumigraph/tiny_package.h"

#include <fstream>
#include <random>

#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "render/lumigraph/manifest.h"

namespace lumi {
namespace {

ColorImage random_photograph(int width_px, int height_px, std::mt19937& random) {
    ColorImage image(width_px, height_px);
    for (Rgb8& pixel : image.pixels()) {
        const auto bits = random();
        pixel = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                 static_cast<std::uint8_t>(bits >> 16)};
    }
    return image;
}

DepthMap random_depth(int width_px, int height_px, std::mt19937& random) {
    DepthMap depth{FloatImage(width_px, height_px), GrayImage(width_px, height_px)};
    std::uniform_real_distribution<float> inverse_depth(0.0F, 0.7F);
    for (float& q : depth.inverse_depth.pixels()) q = inverse_depth(random);
    for (std::uint8_t& c : depth.confidence.pixels()) c = static_cast<std::uint8_t>(random());
    return depth;
}

/// A fan of each kind over a photograph of 6 x 5 samples of depth.
std::shared_ptr<const DepthMesh> tiny_depth_mesh(const Camera& camera) {
    const auto width = static_cast<float>(camera.width_px);
    const auto height = static_cast<float>(camera.height_px);
    DepthMesh mesh;
    mesh.columns = 6;
    mesh.rows = 5;
    mesh.wanted_error_px = 0.1;
    mesh.error_px = 0.3;
    mesh.disparity_px = 1000.0 / 3.0;
    mesh.vertices = {{0, 0, 0.125F},     {0, height, 0.5F},         {width, 0, 0.25F},
                     {width, height, 0}, {width / 2, height, 0.4F}, {width / 2, 0, 0.3F}};
    mesh.indices = {0, 1, 2, 2, 1, 3, 0, 1, 4, 5, 4, 3};
    mesh.kind_begin = {0, 6, 9, 12};
    return std::make_shared<const DepthMesh>(mesh);
}

}  // namespace

Lumigraph tiny_lumigraph(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    Lumigraph lumigraph;
    lumigraph.name = "tiny";
    lumigraph.near_depth = 1.0 / 0.7;
    lumigraph.far_depth = 100.0 / 3.0;
    for (int i = 0; i < 3; ++i) {
        LumigraphView view;
        view.name = "set a/ünï " + std::to_string(i) + ".jpg";
        view.camera = pinhole_camera(13 + i, 7, 10.0 / 3.0);
        view.cam_from_world.rotation =
            Eigen::Quaterniond(number(random), number(random), number(random), number(random))
                .normalized();
        view.cam_from_world.translation = {number(random), 1e-300, 1e12 * number(random)};
        view.exif_orientation = 1 + 3 * i;
        view.photograph = random_photograph(13 + i, 7, random);
        if (i < 2) view.depth = random_depth(6, 5, random);
        if (i == 0) view.depth_mesh = tiny_depth_mesh(view.camera);
        lumigraph.mesh.vertices.push_back({{number(random), number(random), number(random)}, i});
        lumigraph.views.push_back(std::move(view));
    }
    lumigraph.mesh.construction = MeshConstruction::kOpen;
    lumigraph.mesh.scene_centre_in_world = {number(random), number(random), number(random)};
    lumigraph.mesh.faces = {{0, 1, 2}};
    return lumigraph;
}

PackageExtras tiny_extras() {
    return {.resolved_config_toml = "name = \"tiny\"\n",
            .evidence_json = R"({"poses": {"views": 3}})",
            .points = {ScenePoint{{1.0, 2.0, 3.0}, {10, 20, 30}, 0.5, {}}}};
}

void put_file(const std::filesystem::path& path, const std::string& bytes) {
    std::filesystem::remove(path);
    std::ofstream(path, std::ios::binary) << bytes;
}

void forge_manifest(const std::filesystem::path& package,
                    const std::function<void(nlohmann::ordered_json&)>& change) {
    auto json = nlohmann::ordered_json::parse(read_whole_text(package / kManifestName));
    change(json);
    put_file(package / kManifestName, with_manifest_checksum(json.dump(1) + "\n").value());
}

void forge_file(const std::filesystem::path& package, const std::string& listing,
                const std::string& bytes) {
    forge_manifest(package, [&](nlohmann::ordered_json& json) {
        auto& entry = json.at(nlohmann::ordered_json::json_pointer(listing));
        put_file(package / entry["path"].get<std::string>(), bytes);
        entry["bytes"] = bytes.size();
        entry["sha256"] = sha256_hex(bytes);
    });
}

std::string code_of_reading(const std::filesystem::path& package, const PackageLimits& limits) {
    try {
        static_cast<void>(read_package(package, limits));
    } catch (const Error& error) {
        return error.code();
    }
    return {};
}

}  // namespace lumi
