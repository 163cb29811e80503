#include "calib/ingest/video.h"

#include <cmath>
#include <cstdio>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <utility>

#include "calib/ingest/exif.h"
#include "calib/ingest/sharpness.h"
#include "calib/ingest/video_colors.h"
#include "calib/pictures/srgb_conversion.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

struct Frame {
    cv::Mat bgr;
    double sharpness = -1.0;
    std::size_t number = 0;  ///< In the video, from 1.
};

int exif_orientation_of(double rotation_deg) {
    switch (static_cast<int>(std::lround(rotation_deg))) {
        case 90:
            return 6;
        case 180:
            return 3;
        case 270:
        case -90:
            return 8;
        default:
            return 1;
    }
}

cv::VideoCapture open_video(const std::filesystem::path& video) {
    // FFmpeg by name: other back ends would take a single picture for a video.
    cv::VideoCapture capture(video.string(), cv::CAP_FFMPEG);
    if (!capture.isOpened()) {
        throw Error(ErrorKind::kBadInput, "E-INGEST-NOVIDEO",
                    video.string() + ": not a video that can be read",
                    "give a folder of photographs, or a video that a player can show");
    }
    capture.set(cv::CAP_PROP_ORIENTATION_AUTO, 0);
    return capture;
}

ColorImage rgb_image_of(const cv::Mat& bgr) {
    ColorImage image(bgr.cols, bgr.rows);
    cv::Mat rgb(bgr.rows, bgr.cols, CV_8UC3, image.row(0));
    cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
    return image;
}

/// What its colours mean, unless they are coded for HDR by PQ.
ColorTags color_tags_of(const std::filesystem::path& video) {
    ColorTags tags;
    tags.coded = coded_colors_of_video(video);
    if (tags.coded && tags.coded->transfer == kPqTransfer) {
        throw Error(ErrorKind::kBadInput, "E-INGEST-HDR",
                    video.string() + ": coded for HDR by PQ (SMPTE ST 2084)",
                    "convert it for ordinary screens first: ffmpeg -i IN -vf zscale=t=linear:"
                    "npl=100,format=gbrpf32le,zscale=p=bt709,tonemap=hable,zscale=t=bt709:m=bt709:"
                    "r=tv,format=yuv420p OUT.mp4");
    }
    return tags;
}

std::string frame_name(std::size_t number) {
    char name[32];
    std::snprintf(name, sizeof(name), "frame-%06zu.png", number);
    return name;
}

/// A video that claims more frames than it shows was cut off; counts are estimates, so with room.
void report_early_end(double frames_claimed, std::size_t frames_read,
                      const std::filesystem::path& video, std::vector<Candidate>& candidates) {
    constexpr double kShareThatIsWhole = 0.95;
    if (static_cast<double>(frames_read) >= kShareThatIsWhole * frames_claimed) return;
    Candidate end;
    end.left_out = LeftOut{video.filename().string(), "E-INGEST-TRUNCATED",
                           "the video ends after " + std::to_string(frames_read) + " of " +
                               std::to_string(std::lround(frames_claimed)) + " frames"};
    candidates.push_back(std::move(end));
}

}  // namespace

std::vector<Candidate> ingest_video(const std::filesystem::path& video,
                                    const IngestOptions& options,
                                    const std::filesystem::path& copies_folder,
                                    Progress& progress) {
    const ColorTags color_tags = color_tags_of(video);
    cv::VideoCapture capture = open_video(video);
    const int orientation = exif_orientation_of(capture.get(cv::CAP_PROP_ORIENTATION_META));
    const double frames_claimed = capture.get(cv::CAP_PROP_FRAME_COUNT);
    progress.begin("ingest video",
                   frames_claimed > 0 ? static_cast<std::size_t>(frames_claimed) : 0);

    std::vector<Candidate> candidates;
    Frame sharpest;
    const auto keep_sharpest = [&] {
        if (sharpest.bgr.empty()) return;
        StoredPicture stored;
        stored.raster = rgb_image_of(sharpest.bgr);
        stored.tags = color_tags;
        const SrgbPicture frame = srgb_of(std::move(stored));
        candidates.push_back(make_working_copy(frame.picture, frame_name(sharpest.number), options,
                                               copies_folder, candidates.size() + 1));
        candidates.back().photograph.exif_orientation = orientation;
        candidates.back().photograph.camera_key =
            camera_key_of({}, {frame.picture.width(), frame.picture.height()});
        candidates.back().conversion = frame.conversion;
        sharpest = {};
    };

    double interval = 0;
    cv::Mat bgr;
    std::size_t number = 0;
    while (capture.read(bgr)) {
        progress.throw_if_interrupted();
        progress.advance();
        ++number;
        const double time_s = capture.get(cv::CAP_PROP_POS_MSEC) / 1000.0;
        if (std::floor(time_s * options.video_fps) != interval) {
            keep_sharpest();
            interval = std::floor(time_s * options.video_fps);
        }
        if (const double value = sharpness(bgr); value > sharpest.sharpness) {
            sharpest = {bgr.clone(), value, number};
        }
    }
    keep_sharpest();
    report_early_end(frames_claimed, number, video, candidates);
    return candidates;
}

}  // namespace lumi
