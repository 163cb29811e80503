#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <fstream>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "meshing/surface/mesh_io.h"
#include "render/lumigraph/deflate.h"
#include "render/lumigraph/manifest.h"
#include "render/lumigraph/package_folder.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/lumigraph/tiny_package.h"

/// What opening a file of a folder fails with, a value of errno; 0: it does not.
static int failing_openat = 0;

/// In the C library's place.
extern "C" int openat(int folder, const char* path, int flags, ...) {
    if (failing_openat != 0) {
        errno = failing_openat;
        return -1;
    }
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
    va_end(arguments);
    return static_cast<int>(::syscall(SYS_openat, folder, path, flags, mode));
}

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

class PackageReader : public testing::Test {
 protected:
    void SetUp() override { write_package(folder_, tiny_lumigraph(), tiny_extras()); }

    /// Reading must fail with `code` after the change; the package is restored afterwards.
    void expect_refused(const std::string& code, const std::function<void(Json&)>& change,
                        const std::string& what) {
        const std::string manifest = read_whole_text(folder_ / kManifestName);
        forge_manifest(folder_, change);
        EXPECT_EQ(code_of_reading(folder_), code) << what;
        put_file(folder_ / kManifestName, manifest);
    }
    void expect_refused_value(const std::string& code, const std::string& pointer,
                              const Json& value) {
        expect_refused(
            code, [&](Json& json) { json[Json::json_pointer(pointer)] = value; },
            pointer + " = " + value.dump().substr(0, 60));
    }

    ScratchFolder scratch_;
    fs::path folder_ = scratch_ / "tiny.lumi";
};

TEST_F(PackageReader, ReadsAPackageWhoseForgedManifestSaysTheSame) {
    forge_manifest(folder_, [](Json&) {});
    EXPECT_EQ(code_of_reading(folder_), "");
}

TEST_F(PackageReader, RefusesEveryTruncationOfTheManifest) {
    const std::string text = read_whole_text(folder_ / kManifestName);
    ASSERT_GT(text.size(), 1000U);
    for (std::size_t length = 0; length < text.size(); ++length) {
        EXPECT_THROW(static_cast<void>(parse_manifest(text.substr(0, length), {})), Error)
            << "length " << length;
    }
    EXPECT_NO_THROW(static_cast<void>(parse_manifest(text, {})));
}

TEST_F(PackageReader, RefusesEveryMissingField) {
    const Json whole = Json::parse(read_whole_text(folder_ / kManifestName)).flatten();
    int fields = 0;
    for (const auto& [pointer, value] : whole.items()) {
        if (pointer.starts_with("/evidence/")) continue;
        const Json::json_pointer field(pointer);
        if (std::isdigit(static_cast<unsigned char>(field.back()[0])) != 0) continue;
        auto json = Json::parse(read_whole_text(folder_ / kManifestName));
        json.at(field.parent_pointer()).erase(field.back());
        const std::string text = json.dump(1);
        EXPECT_THROW(
            static_cast<void>(parse_manifest(with_manifest_checksum(text).value_or(text), {})),
            Error)
            << pointer;
        ++fields;
    }
    EXPECT_GT(fields, 50);
}

TEST_F(PackageReader, RefusesEveryWrongType) {
    const Json whole = Json::parse(read_whole_text(folder_ / kManifestName)).flatten();
    for (const auto& [pointer, value] : whole.items()) {
        if (pointer.starts_with("/evidence/")) continue;
        for (const Json& wrong : {Json(nullptr), Json(true), Json::array(), Json::object(),
                                  value.is_string() ? Json(7) : Json("7")}) {
            auto json = Json::parse(read_whole_text(folder_ / kManifestName));
            json.at(Json::json_pointer(pointer)) = wrong;
            const std::string text = json.dump(1);
            EXPECT_THROW(
                static_cast<void>(parse_manifest(with_manifest_checksum(text).value_or(text), {})),
                Error)
                << pointer << " = " << wrong;
        }
    }
}

TEST_F(PackageReader, RefusesNumbersOutOfRange) {
    const std::string bad = "E-PACKAGE-MANIFEST";
    expect_refused_value(bad, "/near_depth", -1.0);
    expect_refused_value(bad, "/far_depth", 1e-3);
    expect_refused_value(bad, "/views/0/exif_orientation", 0);
    expect_refused_value(bad, "/views/0/exif_orientation", 9);
    expect_refused_value(bad, "/views/0/exif_orientation", 1.5);
    expect_refused_value(bad, "/views/0/camera/width_px", 0);
    expect_refused_value(bad, "/views/0/camera/width_px", -13);
    expect_refused_value(bad, "/views/0/camera/width_px", std::uint64_t{1} << 32 | 13U);
    expect_refused_value(bad, "/views/0/camera/width_px", ~std::uint64_t{0});
    expect_refused_value(bad, "/views/0/camera/model", "OPENCV");
    expect_refused_value(bad, "/views/0/camera/parameters/0", 0.0);
    expect_refused_value(bad, "/views/0/camera/parameters/1", -3.0);
    expect_refused_value(bad, "/views/0/camera/parameters", Json{1, 2, 3});
    expect_refused_value(bad, "/views/0/camera/parameters", Json{1, 2, 3, 4, 5});
    expect_refused_value(bad, "/views/0/cam_from_world/rotation_wxyz", Json{1, 0, 0, 0.01});
    expect_refused_value(bad, "/views/0/cam_from_world/rotation_wxyz", Json{0, 0, 0, 0});
    expect_refused_value(bad, "/views/0/depth/min_inverse_depth", -0.5);
    expect_refused_value(bad, "/views/0/depth/max_inverse_depth", -0.5);
    expect_refused_value(bad, "/views/0/depth/max_inverse_depth", 1e39);
    expect_refused_value(bad, "/views/0/photograph/bytes", -1);
    expect_refused_value(bad, "/views/0/photograph/bytes", 1.0);
    expect_refused_value(bad, "/views/0/photograph/sha256", "");
    expect_refused_value(bad, "/views/0/name", "");
    expect_refused_value(bad, "/views/1/name", "set a/ünï 0.jpg");
    expect_refused_value(bad, "/views", Json::array());
    expect_refused_value(bad, "/blending_space", "linear");
    for (const Json& gain : {Json{1, 1}, Json{1, 1, 17}, Json{1, 0, 1}, Json{1, -1, 1}, Json("1"),
                             Json{1, "1", 1}, Json(nullptr)}) {
        expect_refused_value(bad, "/views/0/exposure_gain", gain);
    }
    expect_refused_value(bad, "/fade_beyond_capture", 1);
    for (const Json& views : {Json(2), Json(5), Json(3.5), Json("3")})
        expect_refused_value(bad, "/depth_views", views);
    for (const Json& block : {Json(0), Json(3), Json(0.5), Json("2"), Json(nullptr)})
        expect_refused_value(bad, "/depth_block_px", block);
    for (const Json& error : {Json(0), Json(-1), Json(11), Json("1"), Json(nullptr)})
        for (const char* const key : {"/triangle_error_px", "/noisy_depth_error_px"})
            expect_refused_value(bad, key, error);
    for (const Json& tolerance : {Json(0), Json(-1), Json(101), Json("1"), Json(nullptr)})
        expect_refused_value(bad, "/occlusion_tolerance_px", tolerance);
    expect_refused_value("E-PACKAGE-VERSION", "/schema_version", 2);
}

TEST_F(PackageReader, RefusesNumbersThatAreNotFinite) {
    const std::string text = read_whole_text(folder_ / kManifestName);
    const std::size_t value = text.find("\"near_depth\": ") + 14;
    const std::size_t length = text.find(',', value) - value;
    for (const char* number :
         {"nan", "NaN", "inf", "-Infinity", "1e400", "-1e400", "0x10", "1,5"}) {
        std::string forged = text;
        forged.replace(value, length, number);
        put_file(folder_ / kManifestName, with_manifest_checksum(forged).value());
        EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-MANIFEST") << number;
    }
}

TEST_F(PackageReader, RefusesDeepNesting) {
    const std::string text = read_whole_text(folder_ / kManifestName);
    const std::string evidence = "\"evidence\": {";
    for (const std::size_t depth : {31U, 100U, 100'000U, 1'000'000U}) {
        std::string forged = text;
        forged.insert(forged.find(evidence) + evidence.size(),
                      "\"deep\": " + std::string(depth, '[') + std::string(depth, ']') + ",");
        put_file(folder_ / kManifestName, with_manifest_checksum(forged).value());
        EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-MANIFEST") << depth;
    }
}

TEST_F(PackageReader, AcceptsNestingAtTheLimit) {
    // The document and the evidence are two levels themselves.
    forge_manifest(folder_, [](Json& json) {
        json["evidence"]["deep"] = Json::parse(std::string(30, '[') + std::string(30, ']'));
    });
    EXPECT_EQ(code_of_reading(folder_), "");
}

TEST_F(PackageReader, RefusesAKeyThatStandsTwice) {
    std::string text = read_whole_text(folder_ / kManifestName);
    text.insert(text.find("\"near_depth\""), "\"near_depth\": 1,");
    put_file(folder_ / kManifestName, with_manifest_checksum(text).value());
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-MANIFEST");
}

TEST_F(PackageReader, KeepsToItsLimits) {
    EXPECT_EQ(code_of_reading(folder_, {.max_manifest_bytes = 100}), "E-PACKAGE-SIZE");
    EXPECT_EQ(code_of_reading(folder_, {.max_views = 2}), "E-PACKAGE-MANIFEST");
    EXPECT_EQ(code_of_reading(folder_, {.max_decoded_bytes = 1000}), "E-PACKAGE-BUDGET");
}

TEST_F(PackageReader, RefusesHugeClaimsBeforeItReads) {
    expect_refused_value("E-PACKAGE-BUDGET", "/points/bytes", ~std::uint64_t{0});
    expect_refused_value("E-PACKAGE-BUDGET", "/views/0/photograph/bytes", std::uint64_t{1} << 60);
    expect_refused(
        "E-PACKAGE-BUDGET",
        [](Json& json) {
            json["views"][0]["camera"]["width_px"] = 65536;
            json["views"][0]["camera"]["height_px"] = 65536;
        },
        "a picture of 2^32 pixels");
    expect_refused(
        "E-PACKAGE-BUDGET",
        [](Json& json) {
            json["views"][0]["depth"]["width_px"] = 65536;
            json["views"][0]["depth"]["height_px"] = 65536;
        },
        "a depth map of 2^32 pixels");
}

TEST_F(PackageReader, RefusesAWrongLengthOrChecksum) {
    expect_refused_value("E-PACKAGE-SIZE", "/camera_mesh/bytes", 10);
    expect_refused_value("E-PACKAGE-SIZE", "/camera_mesh/bytes", 100'000);
    expect_refused_value("E-PACKAGE-CHECKSUM", "/config/sha256", std::string(64, '0'));
    std::ofstream(folder_ / "points.ply", std::ios::app) << "x";
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-SIZE");
}

TEST_F(PackageReader, RefusesPicturesOfAnotherSizeThanStated) {
    expect_refused_value("E-PACKAGE-SIZE", "/views/0/camera/width_px", 14);
    expect_refused_value("E-PACKAGE-SIZE", "/views/1/depth/height_px", 4);
}

TEST_F(PackageReader, RefusesPicturesOfAnotherKind) {
    const std::string gray16 = read_whole_text(folder_ / "depth/000001.png");
    const std::string gray8 = read_whole_text(folder_ / "depth/000001_confidence.png");
    write_jpeg(scratch_ / "photograph.jpg", ColorImage(13, 7), 90);
    forge_file(folder_, "/views/0/depth/confidence", gray16);
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-CONTENT");
    forge_file(folder_, "/views/0/depth/confidence", gray8);
    EXPECT_EQ(code_of_reading(folder_), "");
    forge_file(folder_, "/views/0/depth/inverse_depth", gray8);
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-CONTENT");
    forge_file(folder_, "/views/0/photograph", read_whole_text(scratch_ / "photograph.jpg"));
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-FORMAT");
}

TEST_F(PackageReader, RefusesADepthMeshThatIsNotWhatItStates) {
    const std::string mesh = "/views/0/depth/mesh";
    expect_refused_value("E-PACKAGE-MANIFEST", mesh + "/columns", 7);
    expect_refused_value("E-PACKAGE-MANIFEST", mesh + "/rows", 0);
    expect_refused_value("E-PACKAGE-MANIFEST", mesh + "/error_px", 0.0);
    expect_refused_value("E-PACKAGE-MANIFEST", mesh + "/disparity_px", -1.0);
    expect_refused_value("E-PACKAGE-MANIFEST", mesh + "/max_inverse_depth", 1e39);
    expect_refused_value("E-PACKAGE-MANIFEST", mesh + "/vertices", -1);
    expect_refused_value("E-PACKAGE-PATH", mesh + "/file/path", "depth/000001.png");
    for (const char* count :
         {"/vertices", "/seen_triangles", "/filled_triangles", "/stretched_triangles"}) {
        expect_refused_value("E-PACKAGE-MESH", mesh + count, 0);
        expect_refused_value("E-PACKAGE-MESH", mesh + count, 100);
    }
    expect_refused_value("E-PACKAGE-BUDGET", mesh + "/code_bytes", std::uint64_t{1} << 60);
    expect_refused_value("E-PACKAGE-MESH", mesh + "/code_bytes", std::uint64_t{1} << 20);
    // The code's first byte says that a vertex is new; 1 would name one before there is any.
    Bytes code =
        encode(*tiny_lumigraph().views[0].depth_mesh, tiny_lumigraph().views[0].camera).bytes;
    code[0] = 1;
    const Bytes forged = deflated(code);
    forge_file(folder_, mesh + "/file", {forged.begin(), forged.end()});
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-MESH");
}

TEST_F(PackageReader, ReadsAPackageWithoutItsDepthMeshes) {
    forge_manifest(folder_, [](Json& json) { json["views"][0]["depth"].erase("mesh"); });
    EXPECT_EQ(read_package(folder_).views[0].depth_mesh, nullptr);
}

TEST_F(PackageReader, RefusesAMeshThatNamesWhatDoesNotExist) {
    const auto forge_mesh = [&](const std::function<void(CameraMesh&)>& change) {
        CameraMesh mesh = tiny_lumigraph().mesh;
        change(mesh);
        const Bytes bytes = camera_mesh_ply(mesh);
        forge_file(folder_, "/camera_mesh", {bytes.begin(), bytes.end()});
    };
    forge_mesh([](CameraMesh&) {});
    EXPECT_EQ(code_of_reading(folder_), "");
    forge_mesh([](CameraMesh& mesh) { mesh.vertices[0].view_index = 3; });
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-CONTENT");
    forge_mesh([](CameraMesh& mesh) { mesh.vertices[0].view_index = -1; });
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-CONTENT");
    forge_mesh([](CameraMesh& mesh) { mesh.faces[0][2] = 3; });
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-CONTENT");
    forge_mesh([](CameraMesh& mesh) { mesh.vertices[1].position_in_world.y() = HUGE_VAL; });
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-CONTENT");
}

TEST_F(PackageReader, RefusesLinksPipesAndFolders) {
    const fs::path photograph = folder_ / "views/000001.png";
    const fs::path outside = scratch_ / "outside.png";
    fs::rename(photograph, outside);
    fs::create_symlink(outside, photograph);
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-PATH") << "a link to the right bytes";
    fs::remove(photograph);
    ASSERT_EQ(::mkfifo(photograph.c_str(), 0600), 0);
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-PATH") << "a pipe";
    fs::remove(photograph);
    fs::create_directory(photograph);
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-PATH") << "a folder";
    fs::remove(photograph);
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-MISSING");
    fs::rename(outside, photograph);
    EXPECT_EQ(code_of_reading(folder_), "");

    fs::rename(folder_ / "views", scratch_ / "views");
    fs::create_directory_symlink(scratch_ / "views", folder_ / "views");
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-PATH") << "a link to the right folder";
}

TEST_F(PackageReader, DoesNotCallAPackageDamagedWhereTheSystemRefuses) {
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
    rlimit none = before;
    none.rlim_cur = 0;
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
    std::string code;
    std::string advice;
    try {
        static_cast<void>(read_package(folder_));
    } catch (const Error& error) {
        code = error.code();
        advice = error.advice();
    }
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
    EXPECT_EQ(code, "E-PACKAGE-ACCESS");
    EXPECT_EQ(advice.find("damaged"), std::string::npos) << advice;
    EXPECT_EQ(code_of_reading(folder_), "");
}

TEST_F(PackageReader, DoesNotCallAPackageDamagedWhereDiskNetworkOrMemoryFail) {
    for (const auto& [error_number, code] :
         {std::pair(ESTALE, "E-PACKAGE-ACCESS"), std::pair(ETIMEDOUT, "E-PACKAGE-ACCESS"),
          std::pair(ENOTCONN, "E-PACKAGE-ACCESS"), std::pair(EREMOTEIO, "E-PACKAGE-ACCESS"),
          std::pair(ENOMEM, "E-PACKAGE-ACCESS"), std::pair(EIO, "E-PACKAGE-ACCESS"),
          std::pair(EACCES, "E-PACKAGE-ACCESS"), std::pair(ENOENT, "E-PACKAGE-MISSING"),
          std::pair(ENAMETOOLONG, "E-PACKAGE-MISSING")}) {
        std::string found = "was read";
        std::string advice;
        failing_openat = error_number;
        try {
            static_cast<void>(PackageFolder(folder_).read_unchecked(kManifestName, 1U << 20U));
        } catch (const Error& error) {
            found = error.code();
            advice = error.advice();
        }
        failing_openat = 0;
        EXPECT_EQ(found, code) << error_number;
        EXPECT_EQ(advice.find("damaged") != std::string::npos, found == "E-PACKAGE-MISSING")
            << advice;
    }
    EXPECT_EQ(code_of_reading(folder_), "");
}

TEST_F(PackageReader, RefusesASocket) {
    const fs::path photograph = folder_ / "views/000001.png";
    fs::remove(photograph);
    ASSERT_EQ(::mknod(photograph.c_str(), S_IFSOCK | 0600, 0), 0);
    EXPECT_EQ(code_of_reading(folder_), "E-PACKAGE-PATH");
}

TEST_F(PackageReader, NamesTheFolderThatIsNoPackage) {
    EXPECT_EQ(code_of_reading(scratch_ / "nothing.lumi"), "E-PACKAGE-MISSING");
    EXPECT_EQ(code_of_reading(scratch_.path()), "E-PACKAGE-MISSING");
    EXPECT_EQ(code_of_reading(folder_ / "points.ply"), "E-PACKAGE-MISSING");
}

TEST_F(PackageReader, CallsAFolderThatIsNoPackageNotADamagedOne) {
    const auto advice_for = [](const fs::path& folder) {
        try {
            static_cast<void>(read_package(folder));
        } catch (const Error& error) {
            return error.advice();
        }
        return std::string();
    };
    fs::create_directory(scratch_ / "photographs");
    EXPECT_TRUE(advice_for(scratch_ / "photographs").ends_with("ends in .lumi"));
    fs::create_directory(scratch_ / "lost.lumi");
    EXPECT_TRUE(advice_for(scratch_ / "lost.lumi").starts_with("the package is damaged"));
}

TEST_F(PackageReader, ErrorsNameTheFileAndHoldNoControlCharacters) {
    forge_manifest(folder_, [](Json& json) {
        json["views"][1]["name"] = json["views"][0]["name"] = "\x1b]0;title\x07.jpg";
    });
    try {
        static_cast<void>(read_package(folder_));
        FAIL() << "two views of one name were accepted";
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("lumigraph.json"), std::string::npos) << message;
        EXPECT_EQ(message.find('\x1b'), std::string::npos) << message;
        EXPECT_EQ(message.find('\x07'), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace lumi
