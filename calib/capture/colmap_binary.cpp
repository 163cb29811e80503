#include "calib/capture/colmap_binary.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "calib/capture/colmap_model.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

static_assert(std::endian::native == std::endian::little,
              "COLMAP's binary files are little-endian");

/// Walks through a file's bytes and refuses to walk past their end.
class BinaryReader {
 public:
    explicit BinaryReader(const std::filesystem::path& path)
        : path_(path.string()), bytes_(read_whole_file(path)) {}

    template <class Value>
    Value next() {
        need(sizeof(Value));
        Value value;
        std::memcpy(&value, &bytes_[offset_], sizeof(Value));
        offset_ += sizeof(Value);
        return value;
    }

    std::string next_name() {
        const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(offset_);
        const auto end = std::find(begin, bytes_.end(), std::uint8_t{0});
        if (end == bytes_.end()) refuse("a name does not end");
        offset_ = static_cast<std::size_t>(end - bytes_.begin()) + 1;
        return {begin, end};
    }

    /// A count of records that are at least `min_record_bytes` long each.
    std::uint64_t next_count(std::size_t min_record_bytes) {
        const auto count = next<std::uint64_t>();
        if (count > (bytes_.size() - offset_) / min_record_bytes) {
            refuse("claims " + std::to_string(count) + " records, more than it has room for");
        }
        return count;
    }

    void expect_end() {
        if (offset_ != bytes_.size()) refuse("has bytes after its last record");
    }

    [[nodiscard]] std::string where() const {
        return path_ + " at byte " + std::to_string(offset_);
    }
    [[noreturn]] void refuse(const std::string& what) const { refuse_colmap_model(where(), what); }

 private:
    void need(std::size_t size) const {
        if (bytes_.size() - offset_ < size) refuse("ends early");
    }

    std::string path_;
    Bytes bytes_;
    std::size_t offset_ = 0;
};

class BinaryWriter {
 public:
    template <class Value>
    void put(Value value) {
        const auto* begin = reinterpret_cast<const std::uint8_t*>(&value);
        bytes_.insert(bytes_.end(), begin, begin + sizeof(Value));
    }
    void put_name(const std::string& name) {
        bytes_.insert(bytes_.end(), name.begin(), name.end());
        bytes_.push_back(0);
    }
    void write(const std::filesystem::path& path) const { write_whole_file(path, bytes_); }

 private:
    Bytes bytes_;
};

void read_cameras(BinaryReader& reader, ColmapRecords& records) {
    constexpr std::size_t kMinRecordBytes = 4 + 4 + 8 + 8 + 3 * 8;
    for (std::uint64_t left = reader.next_count(kMinRecordBytes); left > 0; --left) {
        const auto id = reader.next<std::uint32_t>();
        const auto model_id = reader.next<std::int32_t>();
        const auto width = reader.next<std::uint64_t>();
        const auto height = reader.next<std::uint64_t>();
        if (const std::string_view foreign = name_of_foreign_lens_model(model_id);
            !foreign.empty()) {
            refuse_foreign_lens_model(reader.where(), id, foreign);
        }
        if (!is_lens_model(model_id)) reader.refuse("camera has a lens model that is not COLMAP's");
        const auto model = static_cast<LensModel>(model_id);
        constexpr std::uint64_t kMaxSide = 1 << 20;
        if (width > kMaxSide || height > kMaxSide) reader.refuse("camera has an absurd size");
        Camera camera{static_cast<int>(width), static_cast<int>(height), model, {}};
        for (std::size_t i = 0; i < parameter_count(model); ++i) {
            camera.parameters.push_back(reader.next<double>());
        }
        if (!records.cameras.emplace(id, camera).second) reader.refuse("a camera id stands twice");
    }
    reader.expect_end();
}

void read_images(BinaryReader& reader, ColmapRecords& records) {
    constexpr std::size_t kMinRecordBytes = 4 + 7 * 8 + 4 + 1 + 8;
    for (std::uint64_t left = reader.next_count(kMinRecordBytes); left > 0; --left) {
        const auto id = reader.next<std::uint32_t>();
        ColmapImageRecord image;
        Rigid3& pose = image.view.cam_from_world;
        for (double* value :
             {&pose.rotation.w(), &pose.rotation.x(), &pose.rotation.y(), &pose.rotation.z(),
              &pose.translation.x(), &pose.translation.y(), &pose.translation.z()}) {
            *value = reader.next<double>();
        }
        pose.rotation = checked_unit(pose.rotation);
        image.camera_id = reader.next<std::uint32_t>();
        image.view.name = reader.next_name();
        constexpr std::size_t kKeypointBytes = 3 * 8;
        for (std::uint64_t keys = reader.next_count(kKeypointBytes); keys > 0; --keys) {
            const auto x = reader.next<double>();
            const auto y = reader.next<double>();
            reader.next<std::uint64_t>();  // The point's id: points3D tells it as well.
            image.keypoints_px.emplace_back(x, y);
        }
        if (!records.images.emplace(id, image).second) reader.refuse("an image id stands twice");
    }
    reader.expect_end();
}

void read_points(BinaryReader& reader, ColmapRecords& records) {
    constexpr std::size_t kMinRecordBytes = 8 + 3 * 8 + 3 + 8 + 8;
    for (std::uint64_t left = reader.next_count(kMinRecordBytes); left > 0; --left) {
        const auto id = reader.next<std::uint64_t>();
        ColmapPointRecord record;
        for (int axis = 0; axis < 3; ++axis) {
            record.point.position_in_world[axis] = reader.next<double>();
        }
        record.point.color.r = reader.next<std::uint8_t>();
        record.point.color.g = reader.next<std::uint8_t>();
        record.point.color.b = reader.next<std::uint8_t>();
        record.point.error_px = reader.next<double>();
        constexpr std::size_t kTrackElementBytes = 8;
        for (std::uint64_t elements = reader.next_count(kTrackElementBytes); elements > 0;
             --elements) {
            const auto image_id = reader.next<std::uint32_t>();
            const auto keypoint = reader.next<std::uint32_t>();
            record.track.emplace_back(image_id, keypoint);
        }
        if (!records.points.emplace(id, record).second) reader.refuse("a point id stands twice");
    }
    reader.expect_end();
}

void write_cameras(const Capture& capture, const std::filesystem::path& path) {
    BinaryWriter writer;
    writer.put(static_cast<std::uint64_t>(capture.cameras.size()));
    for (std::size_t i = 0; i < capture.cameras.size(); ++i) {
        const Camera& camera = capture.cameras[i];
        writer.put(static_cast<std::uint32_t>(i + 1));
        writer.put(static_cast<std::int32_t>(camera.model));
        writer.put(static_cast<std::uint64_t>(camera.width_px));
        writer.put(static_cast<std::uint64_t>(camera.height_px));
        for (const double parameter : camera.parameters) writer.put(parameter);
    }
    writer.write(path);
}

void write_images(const Capture& capture, const ColmapKeypoints& keypoints,
                  const std::filesystem::path& path) {
    BinaryWriter writer;
    writer.put(static_cast<std::uint64_t>(capture.views.size()));
    for (std::size_t i = 0; i < capture.views.size(); ++i) {
        const View& view = capture.views[i];
        const Rigid3& pose = view.cam_from_world;
        writer.put(static_cast<std::uint32_t>(i + 1));
        for (const double value :
             {pose.rotation.w(), pose.rotation.x(), pose.rotation.y(), pose.rotation.z(),
              pose.translation.x(), pose.translation.y(), pose.translation.z()}) {
            writer.put(value);
        }
        writer.put(static_cast<std::uint32_t>(view.camera_index + 1));
        writer.put_name(view.name);
        writer.put(static_cast<std::uint64_t>(keypoints.by_view[i].size()));
        for (const auto& [pixel, point] : keypoints.by_view[i]) {
            writer.put(pixel.x());
            writer.put(pixel.y());
            writer.put(static_cast<std::uint64_t>(point + 1));
        }
    }
    writer.write(path);
}

void write_points(const Capture& capture, const ColmapKeypoints& keypoints,
                  const std::filesystem::path& path) {
    BinaryWriter writer;
    writer.put(static_cast<std::uint64_t>(capture.points.size()));
    for (std::size_t i = 0; i < capture.points.size(); ++i) {
        const ScenePoint& point = capture.points[i];
        writer.put(static_cast<std::uint64_t>(i + 1));
        for (int axis = 0; axis < 3; ++axis) writer.put(point.position_in_world[axis]);
        for (const std::uint8_t channel : {point.color.r, point.color.g, point.color.b}) {
            writer.put(channel);
        }
        writer.put(point.error_px);
        writer.put(static_cast<std::uint64_t>(point.track.size()));
        for (std::size_t k = 0; k < point.track.size(); ++k) {
            writer.put(static_cast<std::uint32_t>(point.track[k].view_index + 1));
            writer.put(static_cast<std::uint32_t>(keypoints.index_in_view[i][k]));
        }
    }
    writer.write(path);
}

}  // namespace

ColmapRecords read_colmap_binary(const std::filesystem::path& folder) {
    ColmapRecords records;
    BinaryReader cameras(folder / "cameras.bin");
    read_cameras(cameras, records);
    BinaryReader images(folder / "images.bin");
    read_images(images, records);
    if (std::filesystem::exists(folder / "points3D.bin")) {
        BinaryReader points(folder / "points3D.bin");
        read_points(points, records);
    }
    return records;
}

void write_colmap_model_binary(const Capture& capture, const std::filesystem::path& folder) {
    const ColmapKeypoints keypoints = keypoints_of(capture);
    write_cameras(capture, folder / "cameras.bin");
    write_images(capture, keypoints, folder / "images.bin");
    write_points(capture, keypoints, folder / "points3D.bin");
}

}  // namespace lumi
