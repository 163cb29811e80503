#include "meshing/geometry/binary_volume.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <optional>
#include <random>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "meshing/depth/depth_stage.h"
#include "meshing/geometry/volume_depth.h"
#include "tests/calib/scratch_folder.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

/// Cells of `cell` world units whose centres `is_inside` holds, the grid's corner at `corner`.
template <class Inside>
BinaryVolume volume_of(int size, double cell, const Eigen::Vector3d& corner, const Inside& inside) {
    BinaryVolume volume;
    volume.size = {size, size, size};
    volume.world_from_grid.linear() *= cell;
    volume.world_from_grid.translation() = corner;
    for (int z = 0; z < size; ++z) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                volume.solid.push_back(inside(
                    Eigen::Vector3d(corner + cell * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5))));
            }
        }
    }
    return volume;
}

DepthView view_from(const Eigen::Vector3d& centre) {
    DepthView view;
    view.name = "a.jpg";
    view.camera = small_camera();
    view.cam_from_world = looking_ahead_from(centre);
    return view;
}

Eigen::Vector3d ray_of(const DepthView& view, int x, int y) {
    Eigen::Vector3d ray = unproject(view.camera, {x + 0.5, y + 0.5});
    return ray / ray.z();
}

/// Where a ray enters a box, as a share of its direction; empty where it misses it.
std::optional<double> entry(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                            const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    double enters = 0;
    double leaves = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (low[axis] - origin[axis]) / direction[axis];
        const double b = (high[axis] - origin[axis]) / direction[axis];
        enters = std::max(enters, std::min(a, b));
        leaves = std::min(leaves, std::max(a, b));
    }
    return enters < leaves ? std::optional(enters) : std::nullopt;
}

TEST(VolumeDepth, OfABoxIsThatOfItsFaces) {
    const Eigen::Vector3d low(-0.3, -0.2, 1.9);
    const Eigen::Vector3d high(0.4, 0.3, 2.5);
    const BinaryVolume volume = volume_of(20, 0.1, {-1, -1, 1}, [&](const Eigen::Vector3d& p) {
        return (p.array() > low.array()).all() && (p.array() < high.array()).all();
    });
    const DepthView view = view_from({0.013, 0.027, -0.4});
    const DepthMap map = VolumeCaster(volume).depth(view);
    int seen = 0;
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 240; ++x) {
            const auto z = entry({0.013, 0.027, -0.4}, ray_of(view, x, y), low, high);
            ASSERT_EQ(map.confidence(x, y) != 0, z.has_value()) << x << ' ' << y;
            if (!z) continue;
            ASSERT_NEAR(map.inverse_depth(x, y), 1 / *z, 1e-6) << x << ' ' << y;
            ++seen;
        }
    }
    EXPECT_GT(seen, 500);
}

TEST(VolumeDepth, OfABallIsWithinACellOfTheBall) {
    const Eigen::Vector3d centre(0.1, 0, 2);
    const double cell = 0.02;
    const BinaryVolume volume = volume_of(64, cell, {-0.54, -0.64, 1.36},
                                          [&](const auto& p) { return (p - centre).norm() < 0.5; });
    const DepthView view = view_from({0, 0, 0});
    const DepthMap map = VolumeCaster(volume).depth(view);
    int seen = 0;
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 240; ++x) {
            const Eigen::Vector3d ray = ray_of(view, x, y);
            const double distance = ray.cross(centre).norm() / ray.norm();
            // Half a cell's diagonal beside the ball nothing is solid; as deep within it all is.
            if (distance > 0.5 + cell) {
                ASSERT_EQ(map.confidence(x, y), 0);
            }
            if (distance > 0.4) continue;  // Where the ball is seen at a slant less than 0.6.
            const double along = ray.dot(centre) / ray.squaredNorm();
            const double z = along - std::sqrt(0.25 - distance * distance) / ray.norm();
            ASSERT_NE(map.confidence(x, y), 0);
            ASSERT_NEAR(1 / map.inverse_depth(x, y), z, 0.866 * cell / 0.6) << x << ' ' << y;
            ++seen;
        }
    }
    EXPECT_GT(seen, 2000);
}

TEST(VolumeDepth, EqualsThatOfEveryCellAlone) {
    std::mt19937 random(7);
    BinaryVolume volume;
    volume.size = {6, 5, 7};
    for (int i = 0; i < 6 * 5 * 7; ++i) volume.solid.push_back(random() % 12 == 0);
    // Askew, of unequal steps, and seen from behind and from within the grid.
    volume.world_from_grid = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()) *
                             Eigen::Scaling(0.2, 0.3, 0.15) * Eigen::Translation3d(-3, -2.5, -3.5);
    volume.solid[0] = false;
    for (const Eigen::Vector3d& centre :
         {Eigen::Vector3d(0.05, 0.02, -2), Eigen::Vector3d(-0.4, 0.3, -1.1)}) {
        DepthView view = view_from(centre);
        view.camera = {60, 45, LensModel::kPinhole, {50, 50, 30, 22.5}};
        const DepthMap map = VolumeCaster(volume).depth(view);
        const Eigen::Affine3d grid_from_world = volume.world_from_grid.inverse();
        for (int y = 0; y < 45; ++y) {
            for (int x = 0; x < 60; ++x) {
                const Eigen::Vector3d direction = grid_from_world.linear() * ray_of(view, x, y);
                std::optional<double> nearest;
                for (int i = 0; i < 6 * 5 * 7; ++i) {
                    if (!volume.solid[static_cast<std::size_t>(i)]) continue;
                    const Eigen::Vector3d low(i % 6, i / 6 % 5, i / 30);
                    const auto at = entry(grid_from_world * centre, direction, low,
                                          low + Eigen::Vector3d::Ones());
                    if (at && (!nearest || *at < *nearest)) nearest = at;
                }
                ASSERT_EQ(map.confidence(x, y) != 0, nearest.has_value()) << x << ' ' << y;
                if (nearest) {
                    ASSERT_NEAR(map.inverse_depth(x, y), 1 / *nearest, 1e-5);
                }
            }
        }
    }
}

TEST(VolumeDepth, RefusesACameraWithinTheSolid) {
    const BinaryVolume volume =
        volume_of(4, 1.0, {-2, -2, -2}, [](const auto& p) { return p.z() < 1; });
    try {
        (void)VolumeCaster(volume).depth(view_from({0.2, 0.2, -1}));
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-VOLUME-INSIDE");
    }
}

template <class Number>
Bytes bytes_of_cells(const std::vector<double>& cells, bool swap = false) {
    Bytes bytes;
    for (const double cell : cells) {
        const auto number = static_cast<Number>(cell);
        std::array<std::uint8_t, sizeof(Number)> raw;
        std::memcpy(raw.data(), &number, raw.size());
        if (swap) std::reverse(raw.begin(), raw.end());
        bytes.insert(bytes.end(), raw.begin(), raw.end());
    }
    return bytes;
}

Bytes compressed(const Bytes& bytes, int window_bits) {
    z_stream stream{};
    EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY), Z_OK);
    Bytes packed(bytes.size() + 1000);
    stream.next_in = const_cast<Bytef*>(bytes.data());
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = packed.data();
    stream.avail_out = static_cast<uInt>(packed.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

void write_volume(const std::filesystem::path& path, const std::string& header, const Bytes& data) {
    Bytes bytes(header.begin(), header.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    write_whole_file(path, bytes);
}

const std::vector<double> kCells{0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  // 3 x 2 x 2.

TEST(BinaryVolume, EveryKindOfFileSaysTheSame) {
    const ScratchFolder folder;
    const auto file = [&](const char* name) { return folder.path() / name; };
    const std::string nrrd =
        "NRRD0005\n# made by hand\ndimension: 3\nsizes: 3 2 2\nspace: left-posterior-superior\n"
        "space directions: (0,2,0) (-2,0,0) (0,0,4)\nspace origin: (10,20,30)\nmaker:=nobody\n";
    write_volume(file("a.nrrd"), nrrd + "type: unsigned char\nencoding: raw\n\n",
                 bytes_of_cells<std::uint8_t>(kCells));
    write_volume(file("b.nrrd"), nrrd + "type: short\nendian: big\nencoding: gzip\n\n",
                 compressed(bytes_of_cells<std::int16_t>(kCells, true), 15 + 16));
    write_volume(file("c.nhdr"),
                 nrrd + "type: float\nendian: little\nencoding: raw\ndata file: c.raw\n", {});
    write_whole_file(file("c.raw"), bytes_of_cells<float>(kCells));
    const std::string meta =
        "ObjectType = Image\nNDims = 3\nTransformMatrix = 0 1 0 -1 0 0 0 0 1\n"
        "Offset = 10 20 30\nElementSpacing = 2 2 4\nDimSize = 3 2 2\n";
    write_volume(file("d.mha"), meta + "ElementType = MET_USHORT\nElementDataFile = LOCAL\n",
                 bytes_of_cells<std::uint16_t>(kCells));
    write_volume(
        file("e.mhd"),
        meta + "CompressedData = True\nElementType = MET_DOUBLE\nElementDataFile = e.zraw\n", {});
    write_whole_file(file("e.zraw"), compressed(bytes_of_cells<double>(kCells), 15));
    for (const char* name : {"a.nrrd", "b.nrrd", "c.nhdr", "d.mha", "e.mhd"}) {
        const BinaryVolume volume = read_binary_volume(file(name), 0.5);
        ASSERT_EQ(volume.size, Eigen::Vector3i(3, 2, 2)) << name;
        ASSERT_EQ(volume.solid, std::vector<bool>(kCells.begin(), kCells.end())) << name;
        EXPECT_TRUE(volume.is_solid({2, 1, 0})) << name;
        // The centre of the first cell, and of the one two steps along its first axis.
        EXPECT_TRUE((volume.world_from_grid * Eigen::Vector3d(0.5, 0.5, 0.5))
                        .isApprox(Eigen::Vector3d(10, 20, 30)))
            << name;
        EXPECT_TRUE((volume.world_from_grid * Eigen::Vector3d(2.5, 1.5, 0.5))
                        .isApprox(Eigen::Vector3d(8, 24, 30)))
            << name;
    }
    EXPECT_EQ(files_of_volume(file("c.nhdr")).back(), file("c.raw"));
    EXPECT_EQ(files_of_volume(file("a.nrrd")).size(), 1U);
}

/// As the format's own library has it (teem, nrrdOriginCalculate): samples stand in cells unless
/// the file says that they stand on nodes, and "axis mins" is where the first cell begins, or the
/// first node.
TEST(BinaryVolume, AxisMinsAreBordersOfCellsOrPlacesOfNodes) {
    const ScratchFolder folder;
    const auto path = folder.path() / "v.nrrd";
    const std::string head = "NRRD0004\ndimension: 3\ntype: uchar\nsizes: 3 2 2\nencoding: raw\n";
    const auto read = [&](const std::string& fields) {
        write_volume(path, head + fields + "\n", bytes_of_cells<std::uint8_t>(kCells));
        return read_binary_volume(path, 0.5).world_from_grid;
    };
    const Eigen::Vector3d first(0.5, 0.5, 0.5);
    const Eigen::Vector3d last(2.5, 1.5, 1.5);
    const Eigen::Vector3d mins(10, 20, 30);
    const std::string at = "axis mins: 10 20 30\n";
    for (const char* cells : {"", "centers: cell cell cell\n", "centerings: cell cell cell\n"}) {
        const auto world = read(at + "spacings: 2 4 6\n" + cells);
        EXPECT_TRUE((world * first).isApprox(mins + Eigen::Vector3d(1, 2, 3))) << cells;
        EXPECT_TRUE((world * Eigen::Vector3d::Zero()).isApprox(mins)) << cells;
        const auto by_maxs = read(at + "axis maxs: 16 28 42\n" + cells);
        EXPECT_TRUE(by_maxs.matrix().isApprox(world.matrix())) << cells;
        const auto of_one_unit = read(at + cells);
        EXPECT_TRUE((of_one_unit * first).isApprox(mins + first)) << cells;
    }
    const std::string nodes = "centers: node node node\n";
    const auto world = read(at + "spacings: 2 4 6\n" + nodes);
    EXPECT_TRUE((world * first).isApprox(mins));
    EXPECT_TRUE((world * last).isApprox(mins + Eigen::Vector3d(4, 4, 6)));
    EXPECT_TRUE(read(at + "axis maxs: 14 24 36\n" + nodes).matrix().isApprox(world.matrix()));
    const auto mixed = read(at + "spacings: 2 4 6\ncenters: node cell node\n");
    EXPECT_TRUE((mixed * first).isApprox(mins + Eigen::Vector3d(0, 2, 0)));
    // The origin of an oriented grid is the centre of its first cell in any case.
    const auto oriented = read(
        "space: left-posterior-superior\nspace directions: (2,0,0) (0,4,0) (0,0,6)\n"
        "space origin: (10,20,30)\ncenters: cell cell cell\n");
    EXPECT_TRUE((oriented * first).isApprox(mins));
}

TEST(BinaryVolume, AMetaImageWithoutElementSpacingHasItsElementSize) {
    const ScratchFolder folder;
    const auto path = folder.path() / "V.MHA";
    const std::string head = "ObjectType = Image\nNDims = 3\nDimSize = 3 2 2\n";
    const std::string tail = "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
    const auto step_of = [&](const std::string& fields) {
        write_volume(path, head + fields + tail, bytes_of_cells<std::uint8_t>(kCells));
        return Eigen::Vector3d(read_binary_volume(path, 0.5).world_from_grid.linear().diagonal());
    };
    EXPECT_EQ(step_of(""), Eigen::Vector3d(1, 1, 1));
    EXPECT_EQ(step_of("ElementSize = 2 3 4\n"), Eigen::Vector3d(2, 3, 4));
    EXPECT_EQ(step_of("ElementSpacing = 5 6 7\nElementSize = 2 3 4\n"), Eigen::Vector3d(5, 6, 7));
    EXPECT_EQ(step_of("Orientation = 1 0 0 0 1 0 0 0 -1\nElementSize = 2 3 4\n"),
              Eigen::Vector3d(2, 3, -4));
}

TEST(BinaryVolume, AMetaImageMayWriteLocalAsItLikesAndNumbersWithTheirSign) {
    const ScratchFolder folder;
    const auto path = folder.path() / "v.mha";
    for (const char* local : {"LOCAL", "Local", "local"}) {
        write_volume(path,
                     std::string("ObjectType = Image\nNDims = 3\nDimSize = 3 2 2\n"
                                 "Offset = +10 -20 +30\nElementType = MET_UCHAR\n"
                                 "ElementDataFile = ") +
                         local + "\n",
                     bytes_of_cells<std::uint8_t>(kCells));
        const BinaryVolume volume = read_binary_volume(path, 0.5);
        EXPECT_EQ(volume.solid, std::vector<bool>(kCells.begin(), kCells.end())) << local;
        EXPECT_TRUE((volume.world_from_grid * Eigen::Vector3d(0.5, 0.5, 0.5))
                        .isApprox(Eigen::Vector3d(10, -20, 30)));
    }
}

TEST(BinaryVolume, ANrrdMayWriteItsByteOrderInCapitals) {
    const ScratchFolder folder;
    const auto path = folder.path() / "v.nrrd";
    const std::string head = "NRRD0004\ndimension: 3\ntype: short\nsizes: 3 2 2\nencoding: raw\n";
    std::vector<double> cells = kCells;
    for (double& cell : cells) cell *= 2;  // 512 with its bytes swapped.
    for (const char* order : {"big", "BIG", "Big", "little", "Little"}) {
        const bool is_big = order[0] == 'b' || order[0] == 'B';
        write_volume(path, head + "endian: " + order + "\n\n",
                     bytes_of_cells<std::int16_t>(cells, is_big));
        const BinaryVolume volume = read_binary_volume(path, 1.5);
        EXPECT_EQ(volume.solid, std::vector<bool>(kCells.begin(), kCells.end())) << order;
        EXPECT_THROW((void)read_binary_volume(path, 3), Error) << order << ": none is so solid";
    }
}

TEST(BinaryVolume, RefusesWhatDoesNotFitItsHeader) {
    const ScratchFolder folder;
    const auto path = folder.path() / "v.nrrd";
    const Bytes cells = bytes_of_cells<std::uint8_t>(kCells);
    const auto code_of = [&](const std::string& header, const Bytes& data, double threshold = 0.5) {
        write_volume(path, header, data);
        try {
            (void)read_binary_volume(path, threshold);
        } catch (const Error& error) {
            return error.code();
        }
        return std::string("none");
    };
    const std::string head = "NRRD0004\ndimension: 3\ntype: uchar\nsizes: 3 2 2\n";
    const std::string raw = head + "encoding: raw\n\n";
    EXPECT_EQ(code_of(raw, cells), "none");
    EXPECT_EQ(code_of(raw, Bytes(11)), "E-VOLUME-READ") << "ends early";
    EXPECT_EQ(code_of(raw, Bytes(13)), "E-VOLUME-READ") << "goes on";
    EXPECT_EQ(code_of(raw, cells, 1.5), "E-VOLUME-EMPTY");
    EXPECT_EQ(code_of(raw, cells, 0.0), "E-VOLUME-FULL");
    EXPECT_EQ(
        code_of("NRRD0004\ndimension: 4\ntype: uchar\nsizes: 3 2 2 1\nencoding: raw\n\n", cells),
        "E-VOLUME-READ");
    EXPECT_EQ(code_of("NRRD0004\ntype: uchar\nsizes: 3 2000000000 2\nencoding: raw\n\n", cells),
              "E-VOLUME-READ");
    EXPECT_EQ(code_of("NRRD0004\ntype: block\nsizes: 3 2 2\nencoding: raw\n\n", cells),
              "E-VOLUME-READ");
    EXPECT_EQ(code_of("NRRD0004\ntype: short\nsizes: 3 2 1\nencoding: raw\n\n", cells),
              "E-VOLUME-READ")
        << "which byte comes first?";
    EXPECT_EQ(code_of("NRRD0004\ndimension: 3\ntype: short\nsizes: 3 2 1\nendian: middle\n"
                      "encoding: raw\n\n",
                      cells),
              "E-VOLUME-READ");
    EXPECT_EQ(code_of(head + "spacings: 1 0 1\nencoding: raw\n\n", cells), "E-VOLUME-READ");
    EXPECT_EQ(code_of(head + "spacings: 1 nan 1\nencoding: raw\n\n", cells), "E-VOLUME-READ");
    const std::string packed = head + "encoding: gzip\n\n";
    Bytes gzip = compressed(cells, 15 + 16);
    EXPECT_EQ(code_of(packed, gzip), "none");
    EXPECT_EQ(code_of(packed, compressed(Bytes(100000), 15 + 16)), "E-VOLUME-READ") << "too much";
    gzip.resize(gzip.size() / 2);
    EXPECT_EQ(code_of(packed, gzip), "E-VOLUME-READ") << "damaged";
    EXPECT_EQ(code_of("no header", cells), "E-VOLUME-READ");
}

TEST(DepthStage, TakesAVolumeAndRefusesOneThatNoViewSees) {
    const ScratchFolder folder;
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 2}, {0, 0, 1}, [](const auto&) { return true; }, noise_texture(0.03, 5)}},
        {{0, 0, 0}, {0.1, 0, 0}}, {});
    const PosedPhotographs photographs = written(known, folder.path());
    SilentProgress progress;
    DepthOptions options;
    options.import_volume = folder.path() / "wall.nrrd";
    // Two layers of one cell each, 8 wide: nothing before the wall at z = 2, and the wall.
    const std::string header =
        "NRRD0004\ntype: uchar\nsizes: 1 1 2\nencoding: raw\nspacings: 8 8 1\naxis mins: -4 -4 ";
    write_volume(options.import_volume, header + "1\n\n", {0, 1});
    const DepthResult result = estimate_depth(photographs, {0, 1}, options, 1, progress);
    EXPECT_EQ(result.evidence[0].model, "volume");
    for (const float value : result.depth_maps[0].inverse_depth.pixels()) {
        ASSERT_FLOAT_EQ(value, 0.5F);
    }
    write_volume(options.import_volume, header + "-9\n\n", {0, 1});
    try {
        (void)estimate_depth(photographs, {0, 1}, options, 1, progress);
        FAIL() << "accepted what lies behind all cameras";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-GEOMETRY-UNSEEN");
    }
}

}  // namespace
}  // namespace lumi
