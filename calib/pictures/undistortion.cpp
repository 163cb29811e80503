#include "calib/pictures/undistortion.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "calib/capture/degrees.h"
#include "calib/capture/lens_distortion.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

/// How far from the middle of a picture, in focal lengths, a straight one reaches: what a fisheye
/// sees from 90 degrees on lies behind the camera. Infinite for other lenses, and where it folds
/// before.
double straight_reach(const Camera& camera) {
    constexpr double kReach_deg = 80.0;
    constexpr int kSteps = 16;
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    if (camera.model != LensModel::kOpenCvFisheye) return kInfinite;
    const double* const terms =
        camera.parameters.data() + first_distortion_parameter(LensModel::kOpenCvFisheye);
    double reach = 0.0;
    for (int step = 1; step <= kSteps; ++step) {
        const double radius = fisheye_radius(step * kReach_deg * kRadiansPerDegree / kSteps, terms);
        if (radius <= reach) return kInfinite;
        reach = radius;
    }
    return reach;
}

/// Where the border of the sensor lands at depth 1, as the half-widths that are filled with picture
/// on every side of the optical axis; infinite where all of a side is beside a straight picture.
struct FilledExtent {
    double left = std::numeric_limits<double>::infinity();
    double right = left;
    double top = left;
    double bottom = left;
};

FilledExtent filled_extent(const Camera& camera) {
    constexpr int kSteps = 64;
    const double reach = straight_reach(camera);
    FilledExtent extent;
    const auto lower = [&](double& side, const Eigen::Vector2d& pixel, int axis, double sign) {
        const Eigen::Vector2d bent =
            (pixel - principal_point_px(camera)).cwiseQuotient(focal_length_px(camera));
        if (bent.norm() > reach) return;
        side = std::min(side, sign * unproject(camera, pixel)[axis]);
    };
    for (int step = 0; step <= kSteps; ++step) {
        const double share = static_cast<double>(step) / kSteps;
        const double x = share * camera.width_px;
        const double y = share * camera.height_px;
        lower(extent.left, {0, y}, 0, -1);
        lower(extent.right, {camera.width_px, y}, 0, 1);
        lower(extent.top, {x, 0}, 1, -1);
        lower(extent.bottom, {x, camera.height_px}, 1, 1);
    }
    return extent;
}

/// The pinhole camera of the same size and principal point whose frame the picture just fills. One
/// zoom for both axes, so that pixels keep their shape; none so small that a pixel in the middle
/// stands for more than two by two of the photograph's.
Camera filled_pinhole(const Camera& camera) {
    const Eigen::Vector2d focal = focal_length_px(camera);
    const Eigen::Vector2d centre = principal_point_px(camera);
    Camera pinhole{camera.width_px,
                   camera.height_px,
                   LensModel::kPinhole,
                   {focal.x(), focal.y(), centre.x(), centre.y()}};
    if (is_pinhole(camera)) return pinhole;

    const FilledExtent extent = filled_extent(camera);
    constexpr double kMinZoom = 0.5;
    const double zoom = std::max({kMinZoom, centre.x() / (focal.x() * extent.left),
                                  (camera.width_px - centre.x()) / (focal.x() * extent.right),
                                  centre.y() / (focal.y() * extent.top),
                                  (camera.height_px - centre.y()) / (focal.y() * extent.bottom)});
    constexpr double kMaxZoom = 10.0;
    const bool is_behind = std::min({extent.left, extent.right, extent.top, extent.bottom}) <= 0;
    if (is_behind || !(zoom <= kMaxZoom)) {
        throw Error(ErrorKind::kDegenerateCapture, "E-LENS-FOLDS",
                    "the lens bends the picture so far that no straight picture is left (" +
                        std::string(name_of(camera.model)) + ")",
                    "use a simpler lens model, or calibrate the lens with a board");
    }
    pinhole.parameters[0] *= zoom;
    pinhole.parameters[1] *= zoom;
    return pinhole;
}

/// For each pixel of the pinhole camera, where the photograph has it (OpenCV's pixels: the centre
/// of the top-left one is at 0).
struct ResamplingMap {
    cv::Mat x;
    cv::Mat y;
};

ResamplingMap resampling_map(const Camera& lens, const Camera& pinhole) {
    ResamplingMap map{cv::Mat(pinhole.height_px, pinhole.width_px, CV_32FC1),
                      cv::Mat(pinhole.height_px, pinhole.width_px, CV_32FC1)};
    for (int y = 0; y < pinhole.height_px; ++y) {
        for (int x = 0; x < pinhole.width_px; ++x) {
            const auto pixel = project(lens, unproject(pinhole, {x + 0.5, y + 0.5}));
            map.x.at<float>(y, x) = static_cast<float>(pixel->x() - 0.5);
            map.y.at<float>(y, x) = static_cast<float>(pixel->y() - 0.5);
        }
    }
    return map;
}

/// The map of each camera from its first view to its last. Photographs of many cameras need no more
/// memory at a time than there are threads; those of one camera share its map.
class ResamplingMaps {
 public:
    ResamplingMaps(const Capture& lenses, const Capture& pinholes)
        : lenses_(lenses), pinholes_(pinholes), entries_(lenses.cameras.size()) {
        for (const View& view : lenses.views) ++entry_of(view).views_left;
    }

    std::shared_ptr<const ResamplingMap> for_view(const View& view) {
        Entry& entry = entry_of(view);
        const std::scoped_lock lock(entry.mutex);
        if (!entry.map) {
            entry.map = std::make_shared<ResamplingMap>(
                resampling_map(camera_of(lenses_, view), camera_of(pinholes_, view)));
        }
        return entry.map;
    }

    void release(const View& view) {
        Entry& entry = entry_of(view);
        const std::scoped_lock lock(entry.mutex);
        if (--entry.views_left == 0) entry.map.reset();
    }

 private:
    struct Entry {
        std::mutex mutex;
        std::shared_ptr<const ResamplingMap> map;
        int views_left = 0;
    };
    Entry& entry_of(const View& view) {
        return entries_[static_cast<std::size_t>(view.camera_index)];
    }

    const Capture& lenses_;
    const Capture& pinholes_;
    std::vector<Entry> entries_;
};

ColorImage resampled(const ColorImage& photograph, const ResamplingMap& map) {
    const cv::Mat source(photograph.height(), photograph.width(), CV_8UC3,
                         const_cast<Rgb8*>(photograph.row(0)));
    ColorImage picture(map.x.cols, map.x.rows);
    cv::Mat target(picture.height(), picture.width(), CV_8UC3, picture.row(0));
    cv::remap(source, target, map.x, map.y, cv::INTER_CUBIC, cv::BORDER_REPLICATE);
    return picture;
}

ColorImage read_picture_of(const Camera& camera, const std::filesystem::path& path) {
    ColorImage picture = read_color_image(path);
    if (picture.width() != camera.width_px || picture.height() != camera.height_px) {
        throw Error(ErrorKind::kBadInput, "E-PICTURE-SIZE",
                    path.string() + ": expected " + std::to_string(camera.width_px) + "x" +
                        std::to_string(camera.height_px) + " pixels as its camera has, found " +
                        std::to_string(picture.width()) + "x" + std::to_string(picture.height()),
                    "take in the photographs again");
    }
    return picture;
}

void move_tracks(const Capture& from, Capture& to) {
    for (ScenePoint& point : to.points) {
        for (Observation& observation : point.track) {
            const View& view = from.views[static_cast<std::size_t>(observation.view_index)];
            const auto ray = unproject(camera_of(from, view), observation.pixel);
            const auto pixel = project(camera_of(to, view), ray);
            if (pixel) observation.pixel = *pixel;
        }
    }
}

std::filesystem::path numbered_png(const std::filesystem::path& folder, std::size_t index) {
    char name[32];
    std::snprintf(name, sizeof(name), "%06zu.png", index + 1);
    return folder / name;
}

}  // namespace

PosedPhotographs undistort(const Capture& capture,
                           const std::vector<std::filesystem::path>& picture_paths,
                           const std::filesystem::path& folder, int threads, Progress& progress) {
    PosedPhotographs result{capture, picture_paths};
    for (Camera& camera : result.capture.cameras) camera = filled_pinhole(camera);
    move_tracks(capture, result.capture);

    ResamplingMaps maps(capture, result.capture);
    progress.begin("straightening photographs", capture.views.size());
    parallel_for(static_cast<int>(capture.views.size()), threads, [&](int index) {
        progress.throw_if_interrupted();
        const auto i = static_cast<std::size_t>(index);
        const Camera& lens = camera_of(capture, capture.views[i]);
        if (!is_pinhole(lens)) {
            const ColorImage picture = read_picture_of(lens, picture_paths[i]);
            result.picture_paths[i] = numbered_png(folder, i);
            write_png(result.picture_paths[i],
                      resampled(picture, *maps.for_view(capture.views[i])));
            maps.release(capture.views[i]);
        }
        progress.advance();
    });
    return result;
}

}  // namespace lumi
