#include "calib/ingest/video.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "calib/ingest/exif.h"
#include "calib/ingest/sharpness.h"
#include "calib/ingest/video_decoder.h"
#include "calib/pictures/image_format.h"
#include "calib/pictures/srgb_conversion.h"
#include "calib/work/error.h"
#include "calib/work/formatted.h"

namespace lumi {
namespace {

struct NumberedFrame {
    ColorImage picture;
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

/// What its colours mean, unless they are coded for HDR by PQ.
ColorTags color_tags_of(const VideoFacts& facts, const std::filesystem::path& video) {
    ColorTags tags;
    tags.coded = facts.coded;
    if (tags.coded && tags.coded->transfer == kPqTransfer) {
        throw Error(ErrorKind::kBadInput, "E-INGEST-HDR",
                    video.string() + ": coded for HDR by PQ (SMPTE ST 2084)",
                    "convert it for ordinary screens first: ffmpeg -i IN -vf zscale=t=linear:"
                    "npl=100,format=gbrpf32le,zscale=p=bt709,tonemap=hable,zscale=t=bt709:m=bt709:"
                    "r=tv,format=yuv420p OUT.mp4");
    }
    return tags;
}

/// Decoders of videos take it for a video of one frame.
void expect_no_photograph(const std::filesystem::path& video) {
    if (!image_format_of(video)) return;
    throw Error(ErrorKind::kBadInput, "E-INGEST-NOVIDEO",
                video.string() + ": is one photograph, expected a video",
                "give the folder that it lies in");
}

std::string frame_name(std::size_t number) {
    char name[32];
    std::snprintf(name, sizeof(name), "frame-%06zu.png", number);
    return name;
}

/// How long the frames of a video are seen.
struct Shown {
    double last_s = 0.0;         ///< When its last frame comes.
    double longest_gap_s = 0.0;  ///< Between two frames: as long the last one may stay.
};

/// A video that claims to be longer than it is was cut off; durations are estimates, so with room.
void report_early_end(double duration_s, const Shown& shown, const std::filesystem::path& video,
                      std::vector<Candidate>& candidates) {
    constexpr double kShareThatIsWhole = 0.95;
    if (shown.last_s + shown.longest_gap_s >= kShareThatIsWhole * duration_s) return;
    Candidate end;
    end.left_out = LeftOut{video.filename().string(), "E-INGEST-TRUNCATED",
                           formatted("the video ends after %.1f", shown.last_s) +
                               formatted(" of %.1f seconds", duration_s)};
    candidates.push_back(std::move(end));
}

}  // namespace

std::vector<Candidate> ingest_video(const std::filesystem::path& video,
                                    const IngestOptions& options,
                                    const std::filesystem::path& copies_folder,
                                    Progress& progress) {
    expect_no_photograph(video);
    VideoDecoder decoder(video);
    const VideoFacts& facts = decoder.facts();
    const ColorTags color_tags = color_tags_of(facts, video);
    progress.begin("ingest video", facts.frames);

    std::vector<Candidate> candidates;
    NumberedFrame sharpest;
    const auto keep_sharpest = [&] {
        if (sharpest.picture.empty()) return;
        StoredPicture stored;
        stored.raster = std::move(sharpest.picture);
        stored.tags = color_tags;
        const SrgbPicture frame = srgb_of(std::move(stored));
        candidates.push_back(make_working_copy(frame.picture, frame_name(sharpest.number), options,
                                               copies_folder, candidates.size() + 1));
        candidates.back().photograph.exif_orientation = exif_orientation_of(facts.rotation_deg);
        candidates.back().photograph.camera_key =
            camera_key_of({}, {frame.picture.width(), frame.picture.height()});
        candidates.back().conversion = frame.conversion;
        sharpest = {};
    };

    double interval = 0;
    Shown shown;
    for (std::size_t number = 1; decoder.next(); ++number) {
        progress.throw_if_interrupted();
        progress.advance();
        const double time_s = decoder.time_s();
        shown.longest_gap_s = std::max(shown.longest_gap_s, time_s - shown.last_s);
        shown.last_s = time_s;
        if (std::floor(time_s * options.video_fps) != interval) {
            keep_sharpest();
            interval = std::floor(time_s * options.video_fps);
        }
        if (const double value = sharpness(decoder.brightness()); value > sharpest.sharpness) {
            sharpest = {decoder.picture(), value, number};
        }
    }
    keep_sharpest();
    report_early_end(facts.duration_s, shown, video, candidates);
    return candidates;
}

}  // namespace lumi
