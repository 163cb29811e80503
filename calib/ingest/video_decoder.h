#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "calib/capture/image.h"
#include "calib/pictures/stored_picture.h"

namespace lumi {

/// What the headers of a video say. Counts and durations are estimates, 0 where there is none.
struct VideoFacts {
    double rotation_deg = 0.0;  ///< Clockwise, for display: 0 to 360.
    double duration_s = 0.0;    ///< Of what is shown: after edit lists.
    std::size_t frames = 0;
    std::optional<CodedColors> coded;  ///< Empty where nothing is said of colours.
};

/// The frames of a video's best stream of pictures, one after the other, in the order of display,
/// by FFmpeg's libraries.
///
/// Brightness and colour differences become RGB by the matrix and the range that the video names.
/// Where it names none, by BT.709 from 720 lines on and by BT.601 below and for JPEGs, as players
/// do. Frames that the decoder calls damaged are passed over.
class VideoDecoder {
 public:
    /// Throws Error (E-INGEST-NOVIDEO).
    explicit VideoDecoder(const std::filesystem::path& video);
    ~VideoDecoder();
    VideoDecoder(const VideoDecoder&) = delete;
    VideoDecoder& operator=(const VideoDecoder&) = delete;

    [[nodiscard]] const VideoFacts& facts() const;
    /// Goes on to the next frame. False at the end, or where nothing further can be read.
    [[nodiscard]] bool next();
    /// Of the present frame, from the first one on.
    [[nodiscard]] double time_s() const;
    /// The present frame, not turned, by the video's own primaries and curve; where its pixels are
    /// not square (DV, HDV) it is stretched until they are.
    [[nodiscard]] ColorImage picture();
    /// Its brightness alone, which is found sooner, in the raster that is stored.
    [[nodiscard]] GrayImage brightness();

 private:
    class Stream;
    std::unique_ptr<Stream> stream_;
};

}  // namespace lumi
