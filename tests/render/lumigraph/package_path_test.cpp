#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "calib/work/whole_file.h"
#include "render/lumigraph/package_folder.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

using namespace std::string_literals;

std::vector<std::string> escaping_paths() {
    return {
        "",
        ".png",
        "/",
        "/etc/passwd",
        "/views/000001.png",
        "//views/000001.png",
        "views//000001.png",
        "views/000001.png/",
        "./views/000001.png",
        "views/./000001.png",
        "../views/000001.png",
        "../tiny.lumi/views/000001.png",
        "views/../views/000001.png",
        "views/../../outside.png",
        "views/..png",
        "..",
        "...",
        "views/.hidden.png",
        ".ssh/id.png",
        "views\\000001.png",
        "..\\outside.png",
        "C:\\outside.png",
        "c:/outside.png",
        "c:outside.png",
        "\\\\server\\share\\x.png",
        "//server/share/x.png",
        "file:///etc/x.png",
        "data:image/png;base64,AAAA.png",
        "http://example.org/x.png",
        "~/x.png",
        "~root/x.png",
        "$HOME/x.png",
        "${HOME}/x.png",
        "%HOME%/x.png",
        "%2e%2e/x.png",
        "..%2fx.png",
        "views/000001.png\0.txt"s,
        "views/\0x.png"s,
        "views/000001.png "s,
        " views/000001.png",
        "views/0000 1.png",
        "views/000001\n.png",
        "views/\x1b[31m.png",
        "views/\xe2\x80\xa4\xe2\x80\xa4/x.png",  // U+2024, one dot leader, twice.
        "views/\xef\xbc\x8e\xef\xbc\x8e/x.png",  // U+FF0E, full-width full stop, twice.
        "views\xef\xbc\x8fx.png",                // U+FF0F, full-width solidus.
        "views/\xc0\xae\xc0\xae/x.png",          // Overlong dots.
        "views/\xc3\xa9.png",
        "VIEWS/000001.png",
        "con.png",
        "views/nul.png",
        "aux/x.png",
        "com1.png",
        "lpt9/x.png",
        "views/000001.png::$DATA",
        "views/000001.exe",
        "views/000001.png.sh",
        "views/000001.svg",
        "views/000001",
        "lumigraph.json",
        "`id`.png",
        "$(id).png",
        "a;b.png",
        "a|b.png",
        "*.png",
        "?.png",
        std::string(300, 'a') + ".png",
    };
}

TEST(PackagePath, AcceptsWhatTheWriterWrites) {
    for (const char* path : {"views/000001.png", "depth/000001.png", "camera_mesh.ply",
                             "depth/000001_confidence.png", "points.ply", "config.toml"}) {
        EXPECT_TRUE(is_safe_package_path(path)) << path;
    }
}

TEST(PackagePath, RefusesEveryEscape) {
    EXPECT_GE(escaping_paths().size(), 60U);
    for (const std::string& path : escaping_paths()) {
        EXPECT_FALSE(is_safe_package_path(path)) << path;
    }
}

TEST(PackagePath, RefusesEveryEscapeInAManifest) {
    const ScratchFolder scratch;
    write_package(scratch / "tiny.lumi", tiny_lumigraph(), tiny_extras());
    const std::string manifest = read_whole_text(scratch / "tiny.lumi/lumigraph.json");
    for (const std::string& path : escaping_paths()) {
        put_file(scratch / "tiny.lumi/lumigraph.json", manifest);
        try {
            forge_manifest(scratch / "tiny.lumi", [&](nlohmann::ordered_json& json) {
                json["views"][0]["photograph"]["path"] = path;
            });
        } catch (const nlohmann::json::exception&) {
            continue;  // JSON cannot carry it: not UTF-8.
        }
        EXPECT_EQ(code_of_reading(scratch / "tiny.lumi"), "E-PACKAGE-PATH") << path;
    }
}

TEST(PackagePath, RefusesAPathOfAnotherKindOfFile) {
    const ScratchFolder scratch;
    write_package(scratch / "tiny.lumi", tiny_lumigraph(), tiny_extras());
    forge_manifest(scratch / "tiny.lumi", [](nlohmann::ordered_json& json) {
        json["views"][0]["photograph"] = json["points"];
    });
    EXPECT_EQ(code_of_reading(scratch / "tiny.lumi"), "E-PACKAGE-PATH");
}

}  // namespace
}  // namespace lumi
