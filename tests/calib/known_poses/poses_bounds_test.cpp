#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "calib/work/whole_file.h"
#include "tests/calib/known_poses/known_capture.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

/// A .npy file of version 1.
Bytes npy(const std::string& type, const std::string& shape, const std::vector<double>& values) {
    std::string header =
        "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
    header.resize((header.size() + 10 + 63) / 64 * 64 - 10, ' ');
    std::string text = "\x93NUMPY";
    text +=
        {'\1', '\0', static_cast<char>(header.size() & 255), static_cast<char>(header.size() >> 8)};
    text += header;
    Bytes bytes(text.begin(), text.end());
    for (const double value : values) {
        std::uint8_t raw[8];
        const auto single = static_cast<float>(value);
        const std::size_t size = type == "<f8" ? 8 : 4;
        if (size == 8) {
            std::memcpy(raw, &value, 8);
        } else {
            std::memcpy(raw, &single, 4);
        }
        bytes.insert(bytes.end(), raw, raw + size);
    }
    return bytes;
}

std::vector<double> llff_values(const Capture& capture, double focal) {
    std::vector<double> values;
    const double size_and_focal[3] = {kHeight, kWidth, focal};
    for (const View& view : capture.views) {
        const Axes axes = axes_of(view);
        for (int row = 0; row < 3; ++row) {
            values.insert(values.end(), {axes.down[row], axes.right[row], -axes.forward[row],
                                         axes.centre[row], size_and_focal[row]});
        }
        values.insert(values.end(), {1.0, 10.0});
    }
    return values;
}

TEST(PosesBounds, HasDownRightBackAxesAndPairsByOrder) {
    const ScratchFolder scratch;
    const Capture capture = truth(3);
    for (const std::string type : {"<f8", "<f4"}) {
        scratch.put("poses_bounds.npy", npy(type, "(3, 17)", llff_values(capture, 500)));
        const PoseResult result = import_poses(photographs_of(capture, kWidth, kHeight, 320, 240),
                                               {}, scratch / "poses_bounds.npy");
        expect_poses(result.capture, capture, type == "<f8" ? 1e-12 : 1e-6);
        expect_lens(result.capture.cameras.at(0), pinhole_camera(320, 240, 250), 1e-12);
    }
    EXPECT_EQ(refusal(photographs_of(truth(4)), scratch / "poses_bounds.npy").code(),
              "E-IMPORT-COUNT");
}

TEST(PosesBounds, PicturesThatWereLeftOutHadPosesToo) {
    const ScratchFolder scratch;
    const Capture capture = truth(4);
    scratch.put("poses_bounds.npy", npy("<f8", "(4, 17)", llff_values(capture, 500)));
    auto photographs = photographs_of(capture);
    const LeftOut damaged{photographs[1].name, "E-INGEST-TRUNCATED", "damaged"};
    const LeftOut package{"a.lumi", "E-INGEST-OWN", "made by lumi"};
    photographs.erase(photographs.begin() + 1);
    const auto import = [&](const std::vector<LeftOut>& left_out) {
        return import_poses(photographs, left_out, scratch / "poses_bounds.npy");
    };
    Capture without_damaged = capture;
    without_damaged.views.erase(without_damaged.views.begin() + 1);
    expect_poses(import({damaged, package}).capture, without_damaged, 1e-12);
    // A photograph of later on beside a damaged one: as many as there are poses, of other pictures.
    photographs.push_back(photographs.back());
    photographs.back().name = "view 004.jpg";
    EXPECT_THROW(static_cast<void>(import({damaged})), Error);
}

TEST(PosesBounds, RefusesArraysThatAreNotWhatTheyClaim) {
    const ScratchFolder scratch;
    const Capture capture = truth(3);
    const auto photographs = photographs_of(capture);
    const auto values = llff_values(capture, 500);
    const auto code = [&](const Bytes& bytes) {
        scratch.put("poses_bounds.npy", bytes);
        return refusal(photographs, scratch / "poses_bounds.npy").code();
    };
    EXPECT_EQ(code(npy("<f8", "(3, 17)", values)), "none");
    EXPECT_EQ(code(npy(">f8", "(3, 17)", values)), "E-IMPORT-NPY");
    EXPECT_EQ(code(npy("<f8", "(51,)", values)), "E-IMPORT-NPY");
    EXPECT_EQ(code(npy("<f8", "(4, 17)", values)), "E-IMPORT-NPY");
    EXPECT_EQ(code(npy("<f8", "(4611686018427387904, 8)", values)), "E-IMPORT-NPY");
    EXPECT_EQ(code(npy("<f8", "(17, 3)", values)), "E-IMPORT-POSES");
    EXPECT_EQ(code(npy("<f8", "(3, 17)", llff_values(capture, -5))), "E-IMPORT-POSES");
    auto not_finite = values;
    not_finite[3] = std::nan("");
    EXPECT_EQ(code(npy("<f8", "(3, 17)", not_finite)), "E-IMPORT-POSES");
    const Bytes whole = npy("<f8", "(3, 17)", values);
    for (std::size_t length = 6; length < whole.size(); ++length) {
        EXPECT_EQ(code(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(length))),
                  "E-IMPORT-NPY")
            << "length " << length;
    }
}

}  // namespace
}  // namespace lumi
