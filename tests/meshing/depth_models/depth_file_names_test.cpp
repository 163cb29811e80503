#include <gtest/gtest.h>

#include <cstring>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "meshing/depth_models/depth_file.h"
#include "meshing/depth_models/imported_depth.h"
#include "tests/calib/scratch_folder.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

const std::vector<float> kRowsFromBelow{3, 4, 5, 0, 1, 2};  // 3 x 2.

/// A PFM file of 3 x 2 pixels whose rows count from 0, at the top left.
void write_pfm(const std::filesystem::path& path, const std::string& header,
               const std::vector<float>& rows = kRowsFromBelow) {
    Bytes bytes(header.begin(), header.end());
    bytes.resize(header.size() + rows.size() * sizeof(float));
    std::memcpy(bytes.data() + header.size(), rows.data(), rows.size() * sizeof(float));
    write_whole_file(path, bytes);
}

TEST(DepthFile, APfmMayPutAnyWhiteSpaceBetweenTheFieldsOfItsHeader) {
    const ScratchFolder folder;
    const auto path = folder.path() / "a.pfm";
    for (const char* header :
         {"Pf\n3 2\n-1.0\n", "Pf\r\n3 2\r\n-1.0\r\n", "Pf\n3\n2\n-1\n", "Pf\r3 2\r-1.0\r",
          "Pf \n 3  2 \n -1.000000\n", "Pf\n+3 +2\n-1.0\n", "Pf\n3 2\r\n-1.0\n"}) {
        write_pfm(path, header);
        const FloatImage image = read_depth_file(path, 1);
        ASSERT_EQ(image.width(), 3) << header;
        for (int i = 0; i < 6; ++i) EXPECT_EQ(image(i % 3, i / 3), static_cast<float>(i)) << header;
    }
}

/// The byte of a line feed may be the first of the picture after a lone carriage return.
TEST(DepthFile, APfmWhoseFirstByteIsALineFeedLosesNone) {
    const ScratchFolder folder;
    const auto path = folder.path() / "a.pfm";
    std::vector<float> rows = kRowsFromBelow;
    const std::uint32_t begins_with_line_feed = 0x3f80000aU;
    std::memcpy(rows.data(), &begins_with_line_feed, sizeof(float));
    for (const char* header : {"Pf\n3 2\n-1\n", "Pf\r3 2\r-1\r", "Pf\r\n3 2\r\n-1\r\n"}) {
        write_pfm(path, header, rows);
        const FloatImage image = read_depth_file(path, 1);
        EXPECT_EQ(std::memcmp(image.row(1), &begins_with_line_feed, sizeof(float)), 0) << header;
    }
}

TEST(DepthFile, APfmOfAWrongLengthIsRefusedWhateverEndsItsLines) {
    const ScratchFolder folder;
    const auto path = folder.path() / "a.pfm";
    std::vector<float> rows = kRowsFromBelow;
    rows.push_back(6);
    for (const char* header :
         {"Pf\n3 2\n-1\n", "Pf\r\n3 2\r\n-1\r\n", "Pf\n-3 2\n-1\n", "Pf\r\n3 -2\r\n-1\r\n"}) {
        write_pfm(path, header, rows);
        try {
            (void)read_depth_file(path, 1);
            ADD_FAILURE() << "accepted " << header;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-DEPTH-FORMAT") << header;
        }
    }
}

TEST(ImportedDepth, IsFoundWhateverTheCaseOfItsEnding) {
    const ScratchFolder folder;
    DepthView view;
    view.camera = pinhole_camera(3, 2, 10);
    for (const char* name : {"a.JPG", "b.jpg", "c.JPG", "d.jpg"}) {
        view.name = name;
        const auto stem = std::filesystem::path(name).stem().string();
        const auto file = stem == "a"   ? "a.PFM"
                          : stem == "b" ? "b.jpg.PFM"
                          : stem == "c" ? "c.PFM"
                                        : "d.pfm";
        write_pfm(folder.path() / file, "Pf\n3 2\n-1\n");
        const DepthMap map =
            imported_depth(view, imported_depth_file({view.name}, 0, folder.path()), 1);
        EXPECT_EQ(map.inverse_depth(2, 1), 1.0F / 5) << name;
    }
}

}  // namespace
}  // namespace lumi
