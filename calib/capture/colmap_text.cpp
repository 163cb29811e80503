#include "calib/capture/colmap_text.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <sstream>

#include "calib/capture/colmap_model.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

/// One line of a text file, cut at blanks, that knows where it stands.
class TextLine {
 public:
    TextLine(std::string_view text, std::string where) : rest_(text), where_(std::move(where)) {}

    template <class Value>
    Value next() {
        const std::string_view word = next_word();
        Value value{};
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || error != std::errc{} || end != word.data() + word.size()) {
            refuse("expected a number, found '" + std::string(word) + "'");
        }
        if constexpr (std::is_floating_point_v<Value>) {
            if (!std::isfinite(value)) refuse("a number is not finite");
        }
        return value;
    }

    std::string_view next_word() {
        skip_blanks();
        const std::size_t length = std::min(rest_.find_first_of(" \t"), rest_.size());
        const std::string_view word = rest_.substr(0, length);
        rest_.remove_prefix(length);
        return word;
    }

    /// All that is left: names may hold blanks.
    std::string_view rest() {
        skip_blanks();
        return rest_;
    }
    bool at_end() {
        skip_blanks();
        return rest_.empty();
    }

    [[nodiscard]] const std::string& where() const { return where_; }
    [[noreturn]] void refuse(const std::string& what) const { refuse_colmap_model(where_, what); }

 private:
    void skip_blanks() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
    }

    std::string_view rest_;
    std::string where_;
};

/// The lines of a file without comments; empty lines are kept, they mean "no keypoints".
class TextFile {
 public:
    explicit TextFile(const std::filesystem::path& path)
        : path_(path.string()), text_(read_whole_text(path)) {}

    /// Whether there is a further line that is not a comment.
    bool advance() {
        while (offset_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', offset_), text_.size());
            line_ = std::string_view(text_).substr(offset_, end - offset_);
            offset_ = end + 1;
            ++line_number_;
            if (line_.ends_with('\r')) line_.remove_suffix(1);
            if (!line_.starts_with('#')) return true;
        }
        return false;
    }
    [[nodiscard]] bool blank() const {
        return line_.find_first_not_of(" \t") == std::string_view::npos;
    }
    [[nodiscard]] TextLine line() const {
        return {line_, path_ + ":" + std::to_string(line_number_)};
    }

 private:
    std::string path_;
    std::string text_;
    std::size_t offset_ = 0;
    std::size_t line_number_ = 0;
    std::string_view line_;
};

std::vector<Eigen::Vector2d> read_keypoints(TextLine line) {
    std::vector<Eigen::Vector2d> keypoints;
    while (!line.at_end()) {
        const auto x = line.next<double>();
        const auto y = line.next<double>();
        line.next<std::int64_t>();  // The point's id: points3D tells it as well.
        keypoints.emplace_back(x, y);
    }
    return keypoints;
}

void read_images(TextFile file, ColmapRecords& records) {
    while (file.advance()) {
        if (file.blank()) continue;
        TextLine line = file.line();
        const auto id = line.next<std::uint32_t>();
        ColmapImageRecord image;
        Rigid3& pose = image.view.cam_from_world;
        for (double* value :
             {&pose.rotation.w(), &pose.rotation.x(), &pose.rotation.y(), &pose.rotation.z(),
              &pose.translation.x(), &pose.translation.y(), &pose.translation.z()}) {
            *value = line.next<double>();
        }
        pose.rotation = checked_unit(pose.rotation);
        image.camera_id = line.next<std::uint32_t>();
        image.view.name = line.rest();
        if (file.advance()) image.keypoints_px = read_keypoints(file.line());
        if (!records.images.emplace(id, image).second) line.refuse("an image id stands twice");
    }
}

void read_points(TextFile file, ColmapRecords& records) {
    while (file.advance()) {
        if (file.blank()) continue;
        TextLine line = file.line();
        const auto id = line.next<std::uint64_t>();
        ColmapPointRecord record;
        for (int axis = 0; axis < 3; ++axis) {
            record.point.position_in_world[axis] = line.next<double>();
        }
        record.point.color.r = line.next<std::uint8_t>();
        record.point.color.g = line.next<std::uint8_t>();
        record.point.color.b = line.next<std::uint8_t>();
        record.point.error_px = line.next<double>();
        while (!line.at_end()) {
            const auto image_id = line.next<std::uint32_t>();
            const auto keypoint = line.next<std::uint32_t>();
            record.track.emplace_back(image_id, keypoint);
        }
        if (!records.points.emplace(id, record).second) line.refuse("a point id stands twice");
    }
}

/// Shortest text that reads back to the same double.
std::string exact(double value) {
    char buffer[32];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof(buffer), value);
    return {buffer, end};
}

std::string cameras_text(const Capture& capture) {
    std::string text = "# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n";
    for (std::size_t i = 0; i < capture.cameras.size(); ++i) {
        const Camera& camera = capture.cameras[i];
        text += std::to_string(i + 1) + " " + std::string(name_of(camera.model)) + " " +
                std::to_string(camera.width_px) + " " + std::to_string(camera.height_px);
        for (const double parameter : camera.parameters) text += " " + exact(parameter);
        text += "\n";
    }
    return text;
}

std::string images_text(const Capture& capture, const ColmapKeypoints& keypoints) {
    std::string text =
        "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n"
        "# POINTS2D[] as (X, Y, POINT3D_ID)\n";
    for (std::size_t i = 0; i < capture.views.size(); ++i) {
        const View& view = capture.views[i];
        const Rigid3& pose = view.cam_from_world;
        text += std::to_string(i + 1);
        for (const double value :
             {pose.rotation.w(), pose.rotation.x(), pose.rotation.y(), pose.rotation.z(),
              pose.translation.x(), pose.translation.y(), pose.translation.z()}) {
            text += " " + exact(value);
        }
        text += " " + std::to_string(view.camera_index + 1) + " " + view.name + "\n";
        const char* separator = "";
        for (const auto& [pixel, point] : keypoints.by_view[i]) {
            text += separator + exact(pixel.x()) + " " + exact(pixel.y()) + " " +
                    std::to_string(point + 1);
            separator = " ";
        }
        text += "\n";
    }
    return text;
}

std::string points_text(const Capture& capture, const ColmapKeypoints& keypoints) {
    std::string text =
        "# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n";
    for (std::size_t i = 0; i < capture.points.size(); ++i) {
        const ScenePoint& point = capture.points[i];
        text += std::to_string(i + 1);
        for (int axis = 0; axis < 3; ++axis) text += " " + exact(point.position_in_world[axis]);
        for (const int channel : {point.color.r, point.color.g, point.color.b}) {
            text += " " + std::to_string(channel);
        }
        text += " " + exact(point.error_px);
        for (std::size_t k = 0; k < point.track.size(); ++k) {
            text += " " + std::to_string(point.track[k].view_index + 1) + " " +
                    std::to_string(keypoints.index_in_view[i][k]);
        }
        text += "\n";
    }
    return text;
}

void refuse_names_that_text_cannot_carry(const Capture& capture) {
    for (const View& view : capture.views) {
        const auto is_blank = [](char letter) { return letter == ' ' || letter == '\t'; };
        const bool carried = !view.name.empty() &&
                             view.name.find_first_of("\n\r") == std::string::npos &&
                             !is_blank(view.name.front()) && !is_blank(view.name.back());
        if (carried) continue;
        throw Error(ErrorKind::kBadInput, "E-COLMAP-NAME",
                    view.name + ": a text model cannot carry this name",
                    "rename the photograph, or write the binary form");
    }
}

}  // namespace

std::map<std::uint32_t, Camera> read_colmap_cameras(const std::filesystem::path& cameras_txt) {
    std::map<std::uint32_t, Camera> cameras;
    TextFile file(cameras_txt);
    while (file.advance()) {
        if (file.blank()) continue;
        TextLine line = file.line();
        const auto id = line.next<std::uint32_t>();
        const std::string_view name = line.next_word();
        const auto model = lens_model_named(name);
        if (is_foreign_lens_model(name)) refuse_foreign_lens_model(line.where(), id, name);
        if (!model) line.refuse("lens model '" + std::string(name) + "' is not known to lumi");
        Camera camera;
        camera.model = *model;
        camera.width_px = line.next<int>();
        camera.height_px = line.next<int>();
        while (!line.at_end()) camera.parameters.push_back(line.next<double>());
        if (!cameras.emplace(id, camera).second) line.refuse("a camera id stands twice");
    }
    return cameras;
}

ColmapRecords read_colmap_text(const std::filesystem::path& folder) {
    ColmapRecords records;
    records.cameras = read_colmap_cameras(folder / "cameras.txt");
    read_images(TextFile(folder / "images.txt"), records);
    if (std::filesystem::exists(folder / "points3D.txt")) {
        read_points(TextFile(folder / "points3D.txt"), records);
    }
    return records;
}

void write_colmap_model_text(const Capture& capture, const std::filesystem::path& folder) {
    refuse_names_that_text_cannot_carry(capture);
    const ColmapKeypoints keypoints = keypoints_of(capture);
    write_whole_text(folder / "cameras.txt", cameras_text(capture));
    write_whole_text(folder / "images.txt", images_text(capture, keypoints));
    write_whole_text(folder / "points3D.txt", points_text(capture, keypoints));
}

}  // namespace lumi
