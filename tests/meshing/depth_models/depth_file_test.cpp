#include "meshing/depth_models/depth_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

FloatImage ramp() {
    FloatImage image(5, 3);
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        image.pixels()[i] = 0.25F * static_cast<float>(i);
    }
    return image;
}

void write_with_header(const std::filesystem::path& path, const std::string& header,
                       std::vector<float> values, bool swap = false) {
    Bytes bytes(header.begin(), header.end());
    for (const float value : values) {
        std::array<std::uint8_t, 4> raw;
        std::memcpy(raw.data(), &value, raw.size());
        if (swap) std::reverse(raw.begin(), raw.end());
        bytes.insert(bytes.end(), raw.begin(), raw.end());
    }
    write_whole_file(path, bytes);
}

std::string code_of_reading(const std::filesystem::path& path) {
    try {
        (void)read_depth_file(path, 1.0);
    } catch (const Error& error) {
        return error.code();
    }
    return "none";
}

TEST(DepthFile, EveryFormatSaysTheSame) {
    const ScratchFolder folder;
    const FloatImage expected = ramp();
    write_float_tiff(folder.path() / "a.tiff", expected);
    const std::vector<float>& values = expected.pixels();
    write_with_header(folder.path() / "b.geometric.bin", "5&3&1&", values);
    std::vector<float> upside_down;
    for (int y = 2; y >= 0; --y) {
        upside_down.insert(upside_down.end(), expected.row(y), expected.row(y) + 5);
    }
    write_with_header(folder.path() / "c.pfm", "Pf\n5 3\n-1.0\n", upside_down);
    write_with_header(folder.path() / "d.pfm", "Pf\n5 3\n1.0\n", upside_down, true);
    Image<std::uint16_t> levels(5, 3);
    for (std::size_t i = 0; i < values.size(); ++i) {
        levels.pixels()[i] = static_cast<std::uint16_t>(250 * i);
    }
    write_png(folder.path() / "e.png", levels);
    OIIO::ImageSpec spec(5, 3, 1, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"Z"};
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output && output->open((folder.path() / "f.exr").string(), spec));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
    ASSERT_TRUE(output->close());
    for (const char* name : {"a.tiff", "b.geometric.bin", "c.pfm", "d.pfm", "e.png", "f.exr"}) {
        const FloatImage read = read_depth_file(folder.path() / name, 0.001);
        ASSERT_EQ(read.width(), 5) << name;
        ASSERT_EQ(read.height(), 3) << name;
        for (std::size_t i = 0; i < values.size(); ++i) {
            ASSERT_FLOAT_EQ(read.pixels()[i], values[i]) << name << " " << i;
        }
    }
}

TEST(DepthFile, RefusesAnExrThatHoldsAPartOfThePhotograph) {
    const ScratchFolder folder;
    const std::filesystem::path path = folder.path() / "part.exr";
    OIIO::ImageSpec spec(5, 3, 1, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"Z"};
    spec.x = 2;
    spec.full_width = 10;
    spec.full_height = 6;
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output && output->open(path.string(), spec));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, ramp().pixels().data()));
    ASSERT_TRUE(output->close());
    EXPECT_EQ(code_of_reading(path), "E-DEPTH-FORMAT");
}

TEST(DepthFile, RefusesHeadersThatPromiseMoreThanThereIs) {
    const ScratchFolder folder;
    write_with_header(folder.path() / "a.bin", "5000000&5000000&1&", {1, 2});
    write_with_header(folder.path() / "b.bin", "2&2&1&", {1, 2});
    write_with_header(folder.path() / "c.bin", "2&1&3&", {1, 2, 3, 4, 5, 6});
    write_with_header(folder.path() / "d.pfm", "PF\n1 1\n-1\n", {1, 2, 3});
    write_with_header(folder.path() / "e.pfm", "Pf\n-1 1\n-1\n", {1});
    write_whole_text(folder.path() / "f.exr", "no picture");
    for (const char* name : {"a.bin", "b.bin", "c.bin", "d.pfm", "e.pfm", "f.exr"}) {
        EXPECT_EQ(code_of_reading(folder.path() / name), "E-DEPTH-FORMAT") << name;
    }
}

}  // namespace
}  // namespace lumi
